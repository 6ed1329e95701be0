//! Sweeps of the force of a bank, by both methods: distance, depth, angle, speed, and past the end of the wall.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::passing::{PassingShip, Sections, force_of_wall};
use fenderline_sim::{BodyVelocity, Setup, VesselForces};

use crate::sweeps::stage::Stage;
use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Banks";
const SHIP: &str = r#"
[vessel.bulker]
length_bp = "200 m"
beam = "30 m"
draught = "10 m"
block_coefficient = 0.8

[body.ship]
vessel = "bulker"
outline = [[-100, -10], [-80, -15], [60, -15], [100, 0], [60, 15], [-80, 15], [-100, 10]]
"#;
const METHODS: [(&str, &str); 2] = [("Norrbin", "norrbin"), ("image", "image")];
const SUCTION: &str = "the wall draws the ship towards itself";

/// Position, heading and speed of the ship in a sweep, and the depth, beside a wall of 600 m that lies along north.
#[derive(Clone, Copy)]
struct Place {
    along_m: f64,
    off_m: f64,
    heading_deg: f64,
    speed_mps: f64,
    depth_m: f64,
    /// Side of the wall: 1 for a wall to starboard, −1 for its mirror image.
    side: f64,
}

const ABREAST: Place = Place {
    along_m: 0.0,
    off_m: 45.0,
    heading_deg: 0.0,
    speed_mps: 8.0 * KNOT_MPS,
    depth_m: 15.0,
    side: 1.0,
};

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![
        pull_of_image(),
        pulls(
            "bank_gap",
            "Side force by distance",
            distance(),
            |off_m| Place { off_m, ..ABREAST },
            true,
        ),
        turns("bank_gap_yaw", "Yaw moment by distance, 5° towards the wall", distance(), |off_m| {
            Place { off_m, heading_deg: 5.0, ..ABREAST }
        }),
        pulls(
            "bank_depth",
            "Side force of a bank by depth, from aground to deep",
            Axis::new("depth over draught", "", 0.8, 6.0),
            |ratio| Place { depth_m: 10.0 * ratio, ..ABREAST },
            true,
        ),
        pulls(
            "bank_angle",
            "Side force of a bank by the ship's angle to the wall",
            Axis::new("heading off the wall's line", "°", -90.0, 90.0),
            |heading_deg| Place { heading_deg, off_m: 130.0, ..ABREAST },
            false,
        ),
        pulls(
            "bank_end",
            "Side force of a bank past the end of the wall",
            Axis::new("midship along the wall", "m", 0.0, 500.0),
            |along_m| Place { along_m, ..ABREAST },
            true,
        ),
        by_speed(),
    ]
}

fn distance() -> Axis {
    Axis::new("axis of the ship to the wall", "m", 5.0, 400.0)
}

fn stage(method: &str) -> Stage {
    let bank = format!("{{ from = [-300, 0], to = [300, 0], method = \"{method}\" }}");
    Stage::of(&format!("[environment]\ndepth = \"15 m\"\nbank = [{bank}]\n{SHIP}"))
}

/// The force of the wall on the ship at a place. The wall lies along north through the origin; the ship is to port of
/// the wall.
fn at(stage: &Stage, place: &Place) -> VesselForces {
    stage.forces(|setup: &mut Setup| {
        let body = &mut setup.bodies[0];
        body.position_m = vec2(place.along_m, -place.side * place.off_m);
        body.heading_rad = place.side * place.heading_deg.to_radians();
        body.velocity = BodyVelocity { surge_mps: place.speed_mps, ..BodyVelocity::default() };
        setup.world.environment.depth_m = Some(place.depth_m);
    })
}

fn curves(place: fn(f64) -> Place, part: fn(&VesselForces) -> f64) -> impl Iterator<Item = Curve> {
    METHODS.into_iter().map(move |(name, method)| {
        let (stage, mirror) = (stage(method), stage(method));
        Curve::of(name, move |x| part(&at(&stage, &place(x))))
            .mirrored(move |x| -part(&at(&mirror, &Place { side: -1.0, ..place(x) })))
    })
}

fn pulls(
    key: &'static str,
    title: &str,
    axis: Axis,
    place: fn(f64) -> Place,
    is_suction: bool,
) -> Sweep {
    let law = |curve: Curve| if is_suction { curve.never_negative(SUCTION) } else { curve };
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis,
        value: ["side force to the wall", "kN"],
        curves: curves(place, |forces| 1e-3 * forces.banks.sway_n).map(law).collect(),
        lines: Vec::new(),
        note: "A ship of 200 × 30 × 10 m goes at 8 kn in 15 m of water along a wall of 600 m, \
               abreast of the middle of the wall, with her axis 45 m off the wall; the sweep varies \
               one of these values. In the sweep by the angle, the ship is 130 m off the wall. The \
               force of the image fades out where slender-body theory says nothing: nearer to the \
               wall than a quarter of the beam, and more than 15° askew.",
    }
}

fn turns(key: &'static str, title: &str, axis: Axis, place: fn(f64) -> Place) -> Sweep {
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis,
        value: ["yaw moment", "MN·m"],
        curves: curves(place, |forces| 1e-6 * forces.banks.yaw_nm).collect(),
        lines: Vec::new(),
        note: "As above. A negative moment turns the bow away from the wall, which an image of \
               potential flow does not do to a ship along it.",
    }
}

fn by_speed() -> Sweep {
    let place = |knots: f64| Place { speed_mps: knots * KNOT_MPS, ..ABREAST };
    let curves = curves(place, |forces| 1e-3 * forces.banks.sway_n)
        .map(|curve| curve.never_negative(SUCTION).growing_at_most(2.0));
    Sweep {
        key: "bank_speed",
        subject: SUBJECT,
        title: "Side force of a bank by speed, from astern to ahead".to_owned(),
        axis: Axis::new("speed", "kn", -8.0, 14.0),
        value: ["side force to the wall", "kN"],
        curves: curves.collect(),
        lines: Vec::new(),
        note: "As above.",
    }
}

/// The ship's sections: parabolic with 300 m², as the references have them.
fn pull_of_image() -> Sweep {
    let sections = Sections::parabola(200.0, 300.0).expect("a good ship");
    let pull = move |wall_m: f64, side: f64, depth_m: Option<f64>| {
        let own = PassingShip {
            sections: &sections,
            pose: Pose::new(Vec2::ZERO, 0.0),
            velocity_mps: vec2(1.0, 0.0),
        };
        let wall = [vec2(-500.0, side * wall_m), vec2(500.0, side * wall_m)];
        let [_, pull, _] = force_of_wall(&own, wall, 1.0, depth_m, 1.0);
        side * pull * 200.0 * 200.0 / (300.0 * 300.0)
    };
    let depths = [("deep water", None), ("h/T 2", Some(20.0)), ("h/T 1.3", Some(13.0))];
    let curves = depths.map(|(name, depth_m)| {
        let (near, mirror) = (pull.clone(), pull.clone());
        Curve::of(name, move |wall_m| near(wall_m, 1.0, depth_m))
            .mirrored(move |wall_m| mirror(wall_m, -1.0, depth_m))
            .never_negative(SUCTION)
            .falling("a wall that is farther off draws the ship less", 0.1)
    });
    Sweep {
        key: "bank_image",
        subject: SUBJECT,
        title: "The pull of a wall by the image, 200 × 30 × 10 m".to_owned(),
        axis: Axis::new("axis of the ship to the wall", "m", 18.0, 100.0),
        value: ["side force / (ρu²S²/L²)", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "In the unit of the values, S is the area of the midship section.",
    }
}
