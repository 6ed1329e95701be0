//! A panel on several cones: statics by hand, and the force compared with the gradient of the stored energy.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use fenderline_contact::*;
use proptest::prelude::*;

const STIFFNESS_NPM: f64 = 1e6;

fn outline(points: &[(f64, f64)]) -> Outline {
    let vertices: Vec<Vec2> = points.iter().map(|&(x, y)| vec2(x, y)).collect();
    Outline::new(&vertices).expect("a good outline").0
}

/// A barge with her side to the quay.
fn barge() -> Outline {
    outline(&[(-10.0, -30.0), (10.0, -30.0), (10.0, 30.0), (-10.0, 30.0)])
}

/// A hull whose corner is at her origin and points to the quay.
fn corner() -> Outline {
    outline(&[(0.0, 0.0), (8.0, 8.0), (16.0, 0.0), (8.0, -8.0)])
}

fn buckling() -> FenderLaw {
    FenderLaw::Curve(vec![[0.0, 0.0], [0.25, 6e5], [0.5, 5e5], [0.8, 6e5], [1.0, 9e5]])
}

fn linear() -> FenderLaw {
    FenderLaw::linear(STIFFNESS_NPM)
}

/// A fender 4 m wide on a quay faces north, with the middle of its face at the origin. To a person who looks at the
/// fender, west is on the right.
struct Case {
    law: FenderLaw,
    cones_m: Option<Vec<f64>>,
    hull: Outline,
    unloading: Option<Unloading>,
    stop: Option<Stop>,
    chains: Vec<TensionChain>,
}

impl Case {
    fn new(law: FenderLaw, cones_m: &[f64], hull: Outline) -> Case {
        Case {
            law,
            cones_m: Some(cones_m.to_vec()),
            hull,
            unloading: None,
            stop: None,
            chains: vec![],
        }
    }

    fn build(self) -> Result<Model, ModelError> {
        let mut builder = Model::builder();
        let quay = builder.body(Body {
            name: "quay".into(),
            key: 0,
            outline: outline(&[(-20.0, -50.0), (-1.2, -50.0), (-1.2, 50.0), (-20.0, 50.0)]),
            mobility: Mobility::Fixed,
        });
        let hull = builder.body(Body {
            name: "hull".into(),
            key: 1,
            outline: self.hull,
            mobility: Mobility::Free { mass_kg: 5e6, yaw_inertia_kgm2: 1e9 },
        });
        let material = builder.material(Material {
            stiffness_npm2: 0.0,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 0.0,
            friction_static: 0.0,
            friction_dynamic: 0.0,
            restitution: 1.0,
        });
        builder.fender(Fender {
            name: "fender".into(),
            key: 0,
            body: quay,
            position_m: vec2(-1.2, 0.0),
            facing_rad: 0.0,
            width_m: 4.0,
            projection_m: 1.2,
            law: self.law,
            unloading: self.unloading,
            material,
            rated_deflection_m: 0.8,
            stop: self.stop,
            factors: ReactionFactors::default(),
            panel: self.cones_m.map(|cones_m| Panel { cones_m, tension_chains: self.chains }),
        });
        builder.pair(Pair { bodies: [quay, hull], material });
        builder.build()
    }

    fn model(self) -> Model {
        self.build().expect("a good model")
    }
}

/// The state of the panel under a hull at rest at this position and heading.
struct Pressed {
    contact: Contact,
    panel: Option<PanelMotion>,
    /// Force on the hull, and moment about her origin.
    force: [f64; 3],
}

fn pressed(model: &Model, [x, y, heading_rad]: [f64; 3]) -> Option<Pressed> {
    let (mut memory, mut work) = (Memory::new(model), Workspace::new(model));
    let hull = BodyState { position_m: vec2(x, y), heading_rad, ..BodyState::default() };
    let states = [BodyState::default(), hull];
    step(model, &mut memory, &mut work, &states, 0.1).expect("a good step");
    let contact = *work.contacts().iter().find(|c| c.fender.is_some())?;
    let force = contact.normal * (contact.parts.spring_n + contact.parts.stop_n);
    let panel = work.panels().first().copied();
    Some(Pressed { contact, panel, force: [force.x, force.y, contact.arm_2_m.cross(force)] })
}

fn close(name: &str, is: f64, wanted: f64) {
    assert!((is - wanted).abs() <= 1e-9 * wanted.abs().max(1e-3), "{name}: {is}, by hand {wanted}");
}

/// A corner presses 0.6 m to the right of the middle. The cones stand at ±1.2 m and bear 1/4 and 3/4 of the force.
#[test]
fn a_corner_off_the_middle_tilts_the_panel_by_statics() {
    let model = Case::new(linear(), &[-1.2, 1.2], corner()).model();
    let Pressed { contact, panel, force } =
        pressed(&model, [-0.25, -0.6, 0.0]).expect("it touches");
    let panel = panel.expect("a panel");
    // Depth 0.25 = 0.25 δ₁ + 0.75 δ₂ with δ₁ = N/4k and δ₂ = 3N/4k.
    let force_n = 0.25 * STIFFNESS_NPM / 0.625;
    let (left_m, right_m) = (0.25 * force_n / STIFFNESS_NPM, 0.75 * force_n / STIFFNESS_NPM);
    let tilt = (right_m - left_m) / 2.4;
    close("left cone", panel.peak_deflections_m[0], left_m);
    close("right cone", panel.peak_deflections_m[1], right_m);
    close("tilt", panel.tilt_rad, tilt);
    close("middle", panel.deflection_m, 0.5 * (left_m + right_m));
    close("moment", panel.moment_nm, 0.6 * force_n);
    close("most compressed", contact.depth_m, right_m);
    close(
        "stored",
        contact.energy.stored_j,
        0.5 * STIFFNESS_NPM * (left_m.powi(2) + right_m.powi(2)),
    );
    // The force is perpendicular to the panel. It pushes north, and towards the end that is pushed in more, which is
    // the west end.
    close("push", force[0], force_n);
    close("push along", force[1], -tilt * force_n);
}

/// If the corner is beyond the outer cone, the other cone is stretched.
#[test]
fn a_corner_beyond_the_cones_stretches_the_other_one() {
    let model = Case::new(linear(), &[-1.2, 1.2], corner()).model();
    let Pressed { panel, force, .. } = pressed(&model, [-0.25, -1.6, 0.0]).expect("it touches");
    let panel = panel.expect("a panel");
    let (left, right) = (-0.4 / 2.4, 2.8 / 2.4);
    // The depth is N/k · (left² + right²).
    let force_n = 0.25 * STIFFNESS_NPM / (left * left + right * right);
    close("force", force[0], force_n);
    close("left cone", panel.least_deflections_m[0], left * force_n / STIFFNESS_NPM);
    close("right cone", panel.peak_deflections_m[1], right * force_n / STIFFNESS_NPM);
    close("moment", panel.moment_nm, 1.6 * force_n);
}

/// The right cone is beyond its peak at 0.4 m, with 540 kN. The corner is at 0.6 m.
#[test]
fn a_cone_that_buckles_takes_its_share_by_its_curve() {
    let model = Case::new(buckling(), &[-1.2, 1.2], corner()).model();
    // δ₂ = 0.4 m: R₂ = 540 kN. Moment about the corner: R₁·1.8 = R₂·0.6, R₁ = 180 kN, δ₁ = 0.075 m.
    let depth_m = 0.25 * 0.075 + 0.75 * 0.4;
    let Pressed { contact, panel, force } =
        pressed(&model, [-depth_m, -0.6, 0.0]).expect("it touches");
    let panel = panel.expect("a panel");
    close("left cone", panel.peak_deflections_m[0], 0.075);
    close("right cone", panel.peak_deflections_m[1], 0.4);
    close("tilt", panel.tilt_rad, 0.325 / 2.4);
    close("moment", panel.moment_nm, 360e3 * 1.2);
    close("force", force[0], 720e3);
    let stored_j = 0.5 * 180e3 * 0.075 + (0.5 * 600e3 * 0.25 + 0.5 * (600e3 + 540e3) * 0.15);
    close("stored", contact.energy.stored_j, stored_j);
}

/// A side that covers the panel turns it parallel to itself.
#[test]
fn a_side_turns_the_panel_parallel() {
    let model = Case::new(linear(), &[-1.5, 0.5, 1.2], barge()).model();
    let angle_rad: f64 = 0.02;
    let Pressed { panel, force, .. } = pressed(&model, [9.7, 0.0, angle_rad]).expect("it touches");
    let panel = panel.expect("a panel");
    // A heading of 0.02 turns her to starboard: the side of the barge at the quay comes nearer in the east, at the left
    // end.
    let middle_m = 10.0 / angle_rad.cos() - 9.7;
    close("tilt", panel.tilt_rad, -angle_rad.tan());
    close("middle", panel.deflection_m, middle_m);
    let reaction_n = |at_m: f64| STIFFNESS_NPM * (middle_m - angle_rad.tan() * at_m);
    let [a, b, c] = [-1.5, 0.5, 1.2].map(reaction_n);
    close("force", force[0], a + b + c);
    close("moment", panel.moment_nm, -1.5 * a + 0.5 * b + 1.2 * c);
}

/// Under a parallel side, two cones are one fender of twice the reaction.
#[test]
fn a_parallel_side_finds_the_cones_as_one_fender() {
    let FenderLaw::Curve(points) = buckling() else { unreachable!("a curve") };
    let twice = FenderLaw::Curve(points.iter().map(|&[m, n]| [m, 2.0 * n]).collect());
    let stop = |stiffness_npm: f64| Some(Stop { from_m: 0.7, stiffness_npm });
    let two = Case { stop: stop(1e7), ..Case::new(buckling(), &[-1.2, 1.2], barge()) }.model();
    let one = Case { cones_m: None, stop: stop(2e7), ..Case::new(twice, &[], barge()) }.model();
    for depth_m in [0.01, 0.2, 0.3, 0.5, 0.65, 0.8, 1.05] {
        let pose = [10.0 - depth_m, 3.0, 0.0];
        let [of_two, of_one] = [&two, &one].map(|model| pressed(model, pose).expect("it touches"));
        close("depth", of_two.contact.depth_m, of_one.contact.depth_m);
        close("stop", of_two.contact.parts.stop_n, of_one.contact.parts.stop_n);
        close("energy", of_two.contact.energy.stored_j, of_one.contact.energy.stored_j);
        for axis in 0..3 {
            let off = of_two.force[axis] - of_one.force[axis];
            assert!(off.abs() < 1e-9 * 3e6, "{depth_m} m, axis {axis}: {off}");
        }
    }
}

const CHAIN: TensionChain =
    TensionChain { at_m: -1.8, slack_m: 0.02, stiffness_npm: 2e6, break_load_n: 1e5 };

/// A corner at the right end turns the left end outwards. There a chain holds the panel once its slack is taken up.
#[test]
fn a_tension_chain_holds_the_free_edge() {
    let case = Case::new(linear(), &[-1.2, 1.2], corner());
    let model = Case { chains: vec![CHAIN], ..case }.model();
    let Pressed { contact, panel, force } = pressed(&model, [-0.3, -1.9, 0.0]).expect("it touches");
    let panel = panel.expect("a panel");
    // By hand, d is the deflection of the middle and θ the turn. Then d + 1.9 θ = 0.3, and the moment about the corner
    // is zero: k(d − 1.2θ)·3.1 + k(d + 1.2θ)·0.7 + c(d − 1.8θ + 0.02)·3.7 = 0.
    let (k, c) = (STIFFNESS_NPM, 2e6);
    let per_tilt = k * ((-1.9 - 1.2) * 3.1 + (-1.9 + 1.2) * 0.7) + c * (-1.9 - 1.8) * 3.7;
    let constant = k * 0.3 * 3.8 + c * (0.3 + 0.02) * 3.7;
    let tilt = -constant / per_tilt;
    let middle_m = 0.3 - 1.9 * tilt;
    let tension_n = -c * (middle_m - 1.8 * tilt + 0.02);
    assert!(tension_n > 0.0 && tension_n < 1e5, "{tension_n}");
    close("tilt", panel.tilt_rad, tilt);
    close("tension", panel.peak_tensions_n[0], tension_n);
    close("force", force[0], 2.0 * k * middle_m - tension_n);
    let stored_j = 0.5 * k * ((middle_m - 1.2 * tilt).powi(2) + (middle_m + 1.2 * tilt).powi(2))
        + 0.5 * tension_n * tension_n / c;
    close("stored", contact.energy.stored_j, stored_j);
    assert_eq!(panel.parted, [false; 4]);
}

/// The chain parts at its break load and stays parted, also in a snapshot. The energy that it stored is booked as lost.
#[test]
fn a_tension_chain_parts_once() {
    for unloading in [None, Some(Unloading::ReturnedEnergy(0.6))] {
        let case = Case::new(linear(), &[-1.2, 1.2], corner());
        let weak = TensionChain { break_load_n: 2e4, ..CHAIN };
        let model = Case { chains: vec![weak], unloading, ..case }.model();
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        let mut states = vec![
            BodyState::default(),
            BodyState {
                position_m: vec2(0.05, -1.9),
                velocity_mps: vec2(-0.25, 0.0),
                ..BodyState::default()
            },
        ];
        let (mut booked_j, mut parted, mut peak_n, mut tension_after_n) =
            (0.0, 0, 0.0_f64, 0.0_f64);
        let (mut lost_j, mut off_j) = (0.0, 0.0);
        for _ in 0..200 {
            let loads = [Wrench::default(); 2];
            advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.01)
                .expect("a good step");
            let on_fender = work.contacts().iter().find(|c| c.fender.is_some());
            for panel in work.panels() {
                if parted > 0 {
                    tension_after_n = tension_after_n.max(panel.peak_tensions_n[0]);
                }
                peak_n = peak_n.max(panel.peak_tensions_n[0]);
                parted += u32::from(panel.parted[0]);
            }
            if let Some(contact) = on_fender {
                // At the start of the step, the energy that the bodies gave is either stored or lost. The work of a
                // step is counted from half a step before its start to half a step after it.
                let energy = contact.energy;
                let work_j = contact.work.limiter_j - contact.work.normal_j;
                off_j = booked_j + 0.5 * work_j
                    - lost_j
                    - energy.hysteresis_at_start_j
                    - energy.stored_j;
                booked_j += work_j;
                lost_j += energy.hysteresis_j;
            }
            // A memory that was copied as bytes continues like the original.
            let bytes = memory.snapshot();
            let mut copy = Memory::new(&model);
            copy.restore(&model, &bytes).expect("a good snapshot");
            assert_eq!(copy, memory);
        }
        assert_eq!(parted, 1);
        assert_eq!(peak_n, 2e4);
        assert_eq!(tension_after_n, 0.0);
        // The remainder is the error of steps of 10 ms. The chain stored T²/2k = 100 J.
        assert!(lost_j > 99.0, "{lost_j}");
        assert!(off_j.abs() < 1e-3 * booked_j, "{off_j} of {booked_j}, {lost_j}");
    }
}

#[test]
fn bad_panels_are_refused() {
    let error = |case: Case| case.build().expect_err("a bad panel").to_string();
    let at = |cones_m: &[f64]| error(Case::new(linear(), cones_m, barge()));
    assert!(at(&[0.0]).contains("number of cones"));
    assert!(at(&[-1.0, 2.1]).contains("place of a cone"));
    assert!(at(&[-1.0, f64::NAN]).contains("place of a cone"));
    assert!(at(&[0.5, 0.5]).contains("spread of the cones"));
    assert!(error(Case::new(FenderLaw::Area, &[-1.0, 1.0], barge())).contains("law"));
    let curve = FenderLaw::Curve(vec![[0.0, 0.0], [0.1, 0.0], [0.5, 1e6]]);
    assert!(error(Case::new(curve, &[-1.0, 1.0], barge())).contains("first line"));
    let unloading = Some(Unloading::Curve(vec![[0.0, 0.0], [0.5, 1e5]]));
    let case = Case { unloading, ..Case::new(linear(), &[-1.0, 1.0], barge()) };
    assert!(error(case).contains("unloading curve"));
    for (chain, what) in [
        (TensionChain { at_m: 2.1, ..CHAIN }, "place of a chain"),
        (TensionChain { slack_m: -0.1, ..CHAIN }, "slack of a chain"),
        (TensionChain { stiffness_npm: 0.0, ..CHAIN }, "stiffness of a chain"),
        (TensionChain { break_load_n: f64::NAN, ..CHAIN }, "break load of a chain"),
    ] {
        let case = Case::new(linear(), &[-1.0, 1.0], barge());
        assert!(error(Case { chains: vec![chain], ..case }).contains(what));
    }
}

/// Speeds before and after an impact off the middle, at an angle, with and without hysteresis, at any step.
#[test]
fn an_impact_returns_its_share_of_the_energy() {
    for (share, within) in [(1.0, 6e-3), (0.55, 6e-3)] {
        for law in [linear(), buckling()] {
            for step_s in [0.01, 0.1, 0.5, 2.0] {
                let unloading = Some(Unloading::ReturnedEnergy(share));
                let case = Case::new(law.clone(), &[-1.2, 0.3, 1.2], barge());
                let model = Case { unloading, ..case }.model();
                let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
                let hull = BodyState {
                    position_m: vec2(10.3, 6.0),
                    heading_rad: 0.03,
                    velocity_mps: vec2(-0.3, 0.0),
                    ..BodyState::default()
                };
                let energy_j = |s: &BodyState| {
                    0.5 * 5e6 * s.velocity_mps.length_squared() + 0.5e9 * s.yaw_rate_radps.powi(2)
                };
                let mut states = vec![BodyState::default(), hull];
                let before_j = energy_j(&states[1]);
                let (mut touched, mut peak_j, mut peak_tilt, mut time_s) =
                    (false, 0.0_f64, 0.0, 0.0);
                loop {
                    let loads = [Wrench::default(); 2];
                    advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, step_s)
                        .expect("a good step");
                    time_s += step_s;
                    let on_fender = || work.contacts().iter().filter(|c| c.fender.is_some());
                    for contact in on_fender() {
                        touched = true;
                        peak_j = peak_j.max(contact.energy.peak_absorbed_j);
                    }
                    for panel in work.panels() {
                        peak_tilt = panel.peak_tilt_rad.abs().max(peak_tilt);
                    }
                    if touched && on_fender().count() == 0 {
                        break;
                    }
                    assert!(time_s < 100.0, "it stays");
                }
                // At the largest deflection she keeps some energy in her turn.
                let lost_j = before_j - energy_j(&states[1]);
                let off = lost_j / peak_j - (1.0 - share);
                assert!(peak_tilt > 0.01, "{peak_tilt}");
                assert!(off.abs() < within, "{share}, {law:?}, {step_s} s: {off}");
            }
        }
    }
}

/// Poses with the side, the end or a corner on the panel.
fn poses() -> impl Strategy<Value = [f64; 3]> {
    let along =
        (9.2..10.1_f64, -31.0..31.0_f64, -0.2..0.2_f64).prop_map(|(x, y, tilt)| [x, y, tilt]);
    let end_on = (29.2..30.1_f64, -11.0..11.0_f64, -0.3..0.3_f64)
        .prop_map(|(x, y, tilt)| [x, y, core::f64::consts::FRAC_PI_2 + tilt]);
    prop_oneof![along, end_on]
}

/// The hull's corners in the frame of the face: x points inwards, which is south; y points to the right, which is west.
fn in_face(corners: &[Vec2], pose: [f64; 3]) -> Vec<Vec2> {
    let rotation = Rotation::from_angle(pose[2]);
    let earth = corners.iter().map(|&v| rotation.apply(v) + vec2(pose[0], pose[1]));
    earth.map(|v| vec2(-v.x, -v.y)).collect()
}

/// The deepest point of a hull at a place along the panel.
fn depth_at(in_face: &[Vec2], y: f64) -> f64 {
    let edges = in_face.iter().zip(in_face.iter().cycle().skip(1));
    edges.fold(f64::NEG_INFINITY, |most, (from, to)| {
        let share = (y - from.y) / (to.y - from.y);
        let at = from.x + share * (to.x - from.x);
        if (0.0..=1.0).contains(&share) { most.max(at) } else { most }
    })
}

/// The engine follows hulls to twice the projection of 1.2 m.
const FOLLOWED_M: f64 = 2.3;

/// The deepest point of a hull before the panel, which is 4 m wide.
fn deepest_m(in_face: &[Vec2]) -> f64 {
    let inside = in_face.iter().filter(|v| v.y.abs() <= 2.0).map(|v| v.x);
    let at_ends = [-2.0, 2.0].map(|y| depth_at(in_face, y));
    inside.chain(at_ends).fold(0.0, f64::max)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    /// Central differences over 10 µm, as for other fenders. If the panel changes from one point of the hull to another
    /// within the difference, the quotient lies between the forces at both ends.
    #[test]
    fn the_force_is_the_gradient_of_the_stored_energy(
        pose in poses(),
        is_buckling in any::<bool>(),
        cones_m in prop::collection::vec(-1.9..1.9_f64, 2..5),
    ) {
        let law = if is_buckling { buckling() } else { linear() };
        let spread = cones_m.iter().fold(0.0_f64, |most, at| most.max((at - cones_m[0]).abs()));
        prop_assume!(spread > 0.3);
        let model = Case::new(law, &cones_m, barge()).model();
        let Some(now) = pressed(&model, pose) else { return Ok(()) };
        prop_assume!(now.contact.energy.stored_j > 100.0 && now.contact.area_m2 > 1e-4);
        prop_assume!(deepest_m(&in_face(barge().vertices(), pose)) < FOLLOWED_M);
        let size_n = vec2(now.force[0], now.force[1]).length();
        for axis in 0..3 {
            let by = if axis == 2 { 1e-6 } else { 1e-5 };
            let moved = |sign: f64| {
                let mut moved = pose;
                moved[axis] += sign * by;
                pressed(&model, moved).map_or((0.0, 0.0), |p| (p.contact.energy.stored_j, p.force[axis]))
            };
            let ((more_j, after_n), (less_j, before_n)) = (moved(1.0), moved(-1.0));
            let slope_n = -(more_j - less_j) / (2.0 * by);
            let forces = [now.force[axis], after_n, before_n];
            let low_n = forces.iter().copied().fold(f64::INFINITY, f64::min);
            let high_n = forces.iter().copied().fold(f64::NEG_INFINITY, f64::max);
            let within = if axis == 2 { 40.0 } else { 1.0 } * (1e-4 * size_n + 1.0);
            prop_assert!(
                (low_n - within..=high_n + within).contains(&slope_n),
                "axis {}: {} by the energy, {:?}", axis, slope_n, forces
            );
        }
    }

    /// No other turn of the panel stores less energy than the turn that the panel takes.
    #[test]
    fn no_other_pose_has_less_energy(
        pose in poses(),
        cones_m in prop::collection::vec(-1.9..1.9_f64, 2..5),
    ) {
        let spread = cones_m.iter().fold(0.0_f64, |most, at| most.max((at - cones_m[0]).abs()));
        prop_assume!(spread > 0.3);
        let hull = barge();
        let corners: Vec<Vec2> = hull.vertices().to_vec();
        let model = Case::new(buckling(), &cones_m, hull).model();
        let Some(now) = pressed(&model, pose) else { return Ok(()) };
        let law = buckling();
        let stored_j = |deflection_m: f64| match deflection_m {
            m if m < 0.0 => 0.5 * (6e5 / 0.25) * m * m,
            m => law.energy_j(m),
        };
        let in_face = in_face(&corners, pose);
        prop_assume!(deepest_m(&in_face) < FOLLOWED_M);
        let mut places: Vec<f64> = (0..=400).map(|i| -2.0 + 0.01 * f64::from(i)).collect();
        places.extend(in_face.iter().map(|v| v.y).filter(|y| y.abs() <= 2.0));
        for i in -300..=300 {
            let tilt = f64::from(i) * 0.002;
            let middle_m = places.iter().map(|&y| depth_at(&in_face, y) - tilt * y).fold(f64::NEG_INFINITY, f64::max);
            let energy_j: f64 = cones_m.iter().map(|at| stored_j(middle_m + tilt * at)).sum();
            prop_assert!(
                now.contact.energy.stored_j <= energy_j * (1.0 + 1e-9) + 1e-6,
                "at a turn of {}: {} J, taken {} J", tilt, energy_j, now.contact.energy.stored_j
            );
        }
    }
}
