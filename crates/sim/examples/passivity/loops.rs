//! Measures the work of a closed, frictionless loop. The corner of a hull moves round the corner of a quay: into the
//! quay on one side and out on the other.
//!
//! The force of stiffness k times overlap area S along the normal of the overlap's chord is not the gradient of an
//! energy (docs/contact_model.md, section 2), so a loop gains or loses energy. The force along the normal of a fender's
//! face is the gradient of an energy, so a loop does no work.

use std::f64::consts::{PI, TAU};

use fenderline_contact::{
    Body, BodyId, BodyState, Fender, FenderLaw, Material, MaterialId, Memory, Mobility, Model,
    Outline, Pair, ReactionFactors, Rotation, Vec2, Workspace, step, vec2,
};

use crate::support::{outline, rectangle, spring};

/// The stiffness k of Moreno et al. (2023) (N/m²).
const STIFFNESS_NPM2: f64 = 500e3;
/// Radius of the circle on which the ship's corner moves (m). `WITHIN_M` is the distance of the circle's centre from
/// both sides of the quay, inside the quay (m).
const RADIUS_M: f64 = 2.0;
const WITHIN_M: f64 = 0.5;
const SHIP_CORNER_M: Vec2 = vec2(149.0, 23.0);
/// Steps round the circle. The error of the computed work decreases with the square of the number of steps.
const STEPS: u32 = 20_000;

/// Measures the work of the loop with the force along the chord's normal, and with the force along the normal of a
/// fender's face. Returns false if the loop at the fender's face did work.
pub(crate) fn report() -> bool {
    println!(
        "frictionless closed loops of {RADIUS_M} m round a corner, k = {:.0} kN/m²:",
        STIFFNESS_NPM2 * 1e-3
    );
    let mut closed = true;
    for heading_deg in [10.0, 20.0, 30.0, 40.0] {
        let heading_rad = f64::to_radians(heading_deg);
        let (chord_j, most_j) = round(&corner(), heading_rad, STEPS);
        let (face_j, face_most_j) = round(&face(), heading_rad, STEPS);
        let (coarse_j, _) = round(&face(), heading_rad, STEPS / 4);
        println!(
            "  hull at {heading_deg:2}°: chord {:+8.2} kJ of {:.0} kJ put in; face {:+.1e} kJ of {:.0} kJ \
             ({:+.1e} in a quarter of the steps)",
            chord_j * 1e-3,
            most_j * 1e-3,
            face_j * 1e-3,
            face_most_j * 1e-3,
            coarse_j * 1e-3
        );
        closed &= face_j.abs() <= 1e-6 * face_most_j;
    }
    println!(
        "  {}",
        if closed {
            "the closed loop along a fender face does no work"
        } else {
            "THE CLOSED LOOP ALONG A FENDER FACE DID WORK"
        }
    );
    closed
}

/// Work on the ship in one loop, and the greatest energy taken from her on the way round (J).
fn round(model: &Model, heading_rad: f64, steps: u32) -> (f64, f64) {
    let turned = Rotation::from_angle(heading_rad);
    let middle_m = vec2(WITHIN_M, WITHIN_M) - turned.apply(SHIP_CORNER_M);
    let at = |index: f64| {
        let angle = TAU * index / f64::from(steps);
        middle_m + vec2(libm::cos(angle), libm::sin(angle)) * RADIUS_M
    };
    let (mut work_j, mut least_j) = (0.0, 0.0_f64);
    for index in 0..steps {
        let index = f64::from(index);
        let force_n = force_on_ship_n(model, at(index + 0.5), heading_rad);
        work_j += force_n.dot(at(index + 1.0) - at(index));
        least_j = least_j.min(work_j);
    }
    (work_j, -least_j)
}

/// The spring force on the ship, before the contact engine limits the force by momentum.
fn force_on_ship_n(model: &Model, position_m: Vec2, heading_rad: f64) -> Vec2 {
    let (mut memory, mut work) = (Memory::new(model), Workspace::new(model));
    let ship = BodyState { position_m, heading_rad, ..BodyState::default() };
    step(model, &mut memory, &mut work, &[BodyState::default(), ship], 0.1).expect("good states");
    // The quay was added first: the force on the ship is +N n.
    work.contacts()
        .iter()
        .fold(Vec2::ZERO, |sum, c| sum + c.normal * (c.parts.spring_n + c.parts.stop_n))
}

/// The model of a quay with its corner at the origin.
fn corner() -> Model {
    let square = [vec2(0.0, 0.0), vec2(60.0, 0.0), vec2(60.0, 60.0), vec2(0.0, 60.0)];
    model(outline(&square), None, spring(STIFFNESS_NPM2, 1.0))
}

/// The model of a fender whose face ends at the quay's corner, with the quay 4 m behind the face.
fn face() -> Model {
    let quay = [vec2(4.0, 0.0), vec2(60.0, 0.0), vec2(60.0, 60.0), vec2(4.0, 60.0)];
    let fender = Fender {
        name: "face".into(),
        key: 0,
        body: BodyId(0),
        position_m: vec2(4.0, 10.0),
        facing_rad: PI,
        width_m: 20.0,
        projection_m: 4.0,
        law: FenderLaw::Area,
        unloading: None,
        material: MaterialId(0),
        rated_deflection_m: 4.0,
        stop: None,
        factors: ReactionFactors::default(),
        panel: None,
    };
    model(outline(&quay), Some(fender), spring(STIFFNESS_NPM2, 1.0))
}

fn model(quay: Outline, fender: Option<Fender>, material: Material) -> Model {
    let mut builder = Model::builder();
    let mut add = |name: &str, key, outline, mobility| {
        builder.body(Body { name: name.into(), key, outline, mobility })
    };
    let bodies = [
        add("quay", 0, quay, Mobility::Fixed),
        add(
            "ship",
            1,
            rectangle(2.0 * SHIP_CORNER_M.x, 2.0 * SHIP_CORNER_M.y),
            Mobility::Free { mass_kg: 9e7, yaw_inertia_kgm2: 5e11 },
        ),
    ];
    let material = builder.material(material);
    if let Some(fender) = fender {
        builder.fender(fender);
    }
    builder.pair(Pair { bodies, material });
    builder.build().expect("a good model")
}
