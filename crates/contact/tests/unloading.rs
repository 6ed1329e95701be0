//! Unloading of rubber fenders: the energy that they return, and the unloading curve.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use fenderline_contact::*;
use proptest::prelude::*;

const RUBBER: Material = Material {
    stiffness_npm2: 400e3,
    damping_nspm2: 0.0,
    shear_stiffness_npm: 0.0,
    friction_static: 0.0,
    friction_dynamic: 0.0,
    restitution: 0.1,
};

fn outline(points: &[(f64, f64)]) -> Outline {
    let vertices: Vec<Vec2> = points.iter().map(|&(x, y)| vec2(x, y)).collect();
    Outline::new(&vertices).expect("a good outline").0
}

fn cone() -> FenderLaw {
    FenderLaw::Curve(vec![[0.0, 0.0], [0.25, 6e5], [0.5, 5e5], [0.8, 6e5], [1.0, 9e5]])
}

/// A fender on a quay faces north, with its face at the origin. A barge of 5,000 t lies side on.
fn model(law: FenderLaw, unloading: Unloading) -> Model {
    let mut builder = Model::builder();
    let quay = builder.body(Body {
        name: "quay".into(),
        key: 0,
        outline: outline(&[(-20.0, -50.0), (-1.2, -50.0), (-1.2, 50.0), (-20.0, 50.0)]),
        mobility: Mobility::Fixed,
    });
    let barge = builder.body(Body {
        name: "barge".into(),
        key: 1,
        outline: outline(&[(-10.0, -30.0), (10.0, -30.0), (10.0, 30.0), (-10.0, 30.0)]),
        mobility: Mobility::Free { mass_kg: 5e6, yaw_inertia_kgm2: 1e9 },
    });
    let material = builder.material(RUBBER);
    builder.fender(Fender {
        name: "fender".into(),
        key: 0,
        body: quay,
        position_m: vec2(-1.2, 0.0),
        facing_rad: 0.0,
        width_m: 3.0,
        projection_m: 1.2,
        law,
        unloading: Some(unloading),
        material,
        rated_deflection_m: 0.8,
        stop: Some(Stop { from_m: 1.0, stiffness_npm: 3e7 }),
        factors: ReactionFactors { constant: 1.1, ..ReactionFactors::default() },
        panel: None,
    });
    builder.pair(Pair { bodies: [quay, barge], material });
    builder.build().expect("a good model")
}

struct Run {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
}

impl Run {
    /// The barge starts with her side at `gap_m` from the face, with a speed towards it.
    fn new(model: Model, gap_m: f64, speed_mps: f64) -> Run {
        let (memory, work) = (Memory::new(&model), Workspace::new(&model));
        let barge = BodyState {
            position_m: vec2(10.0 + gap_m, 0.0),
            velocity_mps: vec2(-speed_mps, 0.0),
            ..BodyState::default()
        };
        Run { model, memory, work, states: vec![BodyState::default(), barge] }
    }

    fn step(&mut self, push_n: f64, step_s: f64) {
        let loads = [Wrench::default(), Wrench { force_n: vec2(-push_n, 0.0), moment_nm: 0.0 }];
        let Run { model, memory, work, states } = self;
        advance_in_place(model, memory, work, states, &loads, step_s).expect("a good step");
    }

    fn speed_mps(&self) -> f64 {
        self.states[1].velocity_mps.x
    }

    fn deflection_m(&self) -> f64 {
        10.0 - self.states[1].position_m.x
    }
}

/// The square of rebound speed over approach speed.
fn returned(law: &FenderLaw, unloading: &Unloading, speed_mps: f64, step_s: f64) -> f64 {
    let mut run = Run::new(model(law.clone(), unloading.clone()), 0.37 * speed_mps, speed_mps);
    let mut time_s = 0.0;
    while run.speed_mps() < 0.0 || run.deflection_m() > 0.0 {
        run.step(0.0, step_s);
        time_s += step_s;
        assert!(time_s < 300.0, "it stays");
    }
    (run.speed_mps() / speed_mps).powi(2)
}

/// Time step (s), and the tolerance for the share of energy returned. In long steps the tolerance is the error of
/// sub-steps of 0.15 rad, 0.3 %. It includes a curve's corners and the change from one curve to the other.
const STEPS: [(f64, f64); 5] = [(0.02, 1e-4), (0.1, 1e-3), (0.5, 4e-3), (1.0, 4e-3), (2.0, 4e-3)];

#[test]
fn an_impact_returns_its_share_of_the_energy_at_any_step() {
    for law in [FenderLaw::Area, FenderLaw::linear(2e6), cone()] {
        for share in [0.3, 0.55, 0.8, 1.0] {
            for speed_mps in [0.05, 0.2, 0.45] {
                for (step_s, within) in STEPS {
                    let unloading = Unloading::ReturnedEnergy(share);
                    let off = returned(&law, &unloading, speed_mps, step_s) - share;
                    let law = if law == FenderLaw::Area { "area" } else { "curve" };
                    assert!(
                        off.abs() < within,
                        "{law} {share} {speed_mps} m/s {step_s} s: {off:+.4}"
                    );
                }
            }
        }
    }
}

#[test]
fn an_impact_returns_the_energy_under_the_unloading_curve() {
    let points = vec![[0.0, 0.0], [0.1, 0.0], [0.4, 2e5], [0.8, 4e5]];
    let unloading = Unloading::Curve(points);
    let law = cone();
    for speed_mps in [0.1, 0.3] {
        // The largest deflection follows from the energy of the loading curve.
        let factor = 1.1;
        let taken_j = 0.5 * 5e6 * speed_mps * speed_mps / factor;
        let (mut low_m, mut high_m) = (0.0, 1.0);
        for _ in 0..60 {
            let middle_m = 0.5 * (low_m + high_m);
            if law.energy_j(middle_m) < taken_j { low_m = middle_m } else { high_m = middle_m }
        }
        let share = unloading.returned_share(&law, low_m);
        for (step_s, within) in STEPS {
            let off = returned(&law, &unloading, speed_mps, step_s) - share;
            assert!(off.abs() < within, "{speed_mps} m/s {step_s} s: {off:+.4} beside {share}");
        }
    }
}

/// F·dr = dV + heat holds for any small displacement of the hull, including sideways and rotation. While the peak
/// deflection does not grow, the returnable energy is the potential of the force.
fn gradient_holds(
    law: FenderLaw,
    unloading: Unloading,
    pose: [f64; 3],
    back_m: f64,
    way: [f64; 3],
) {
    let model = model(law, unloading);
    let at = |pose: [f64; 3]| {
        [
            BodyState::default(),
            BodyState {
                position_m: vec2(10.0 - pose[0], pose[1]),
                heading_rad: pose[2],
                ..BodyState::default()
            },
        ]
    };
    let mut work = Workspace::new(&model);
    // The heat of the first sub-step, the stored energy, and the force on the barge.
    let mut look = |memory: &mut Memory, pose: [f64; 3]| {
        advance(&model, memory, &mut work, &at(pose), &[Wrench::default(); 2], 1e-6)
            .expect("a good step");
        let contact =
            work.contacts().iter().find(|c| c.fender.is_some() && c.depth_m <= 1.2).copied()?;
        let force = contact.normal * (contact.parts.spring_n + contact.parts.stop_n);
        let moment = contact.arm_2_m.cross(force);
        Some((contact.energy.stored_j, contact.energy.hysteresis_j, [-force.x, force.y, moment]))
    };
    let mut memory = Memory::new(&model);
    if look(&mut memory, pose).is_none() {
        return;
    }
    // The hull moves back some way, within the hysteresis loop or beyond it.
    let back = [pose[0] - back_m, pose[1], pose[2]];
    let Some((before_j, _, force)) = look(&mut memory, back) else { return };
    let Some((after_j, heat_j, force_after)) =
        look(&mut memory, [0, 1, 2].map(|i| back[i] + way[i]))
    else {
        return;
    };
    // Work of the hull on the fender, by the mean force.
    let work_j: f64 = (0..3).map(|i| -0.5 * (force[i] + force_after[i]) * way[i]).sum();
    let off_j = work_j - (after_j - before_j) - heat_j;
    let scale_j: f64 = (0..3).map(|i| (force[i] * way[i]).abs()).sum();
    assert!(
        off_j.abs() < 1e-3 * scale_j + 1e-6,
        "{off_j} of {work_j} J: {before_j} to {after_j} J, heat {heat_j}"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]
    #[test]
    fn the_force_is_the_gradient_of_the_returnable_energy(
        deep in 0.1..1.1_f64,
        aside in -32.0..32.0_f64,
        tilt in -0.3..0.3_f64,
        back in 0.0..0.1_f64,
        way in prop::array::uniform3(-1.0..1.0_f64),
        which in 0..3_usize,
        share in 0.1..1.0_f64,
    ) {
        let (law, unloading) = match which {
            0 => (FenderLaw::Area, Unloading::ReturnedEnergy(share)),
            1 => (cone(), Unloading::ReturnedEnergy(share)),
            _ => (cone(), Unloading::Curve(vec![[0.0, 0.0], [0.2, 1e5], [0.8, share * 6e5]])),
        };
        let way = [1e-6 * way[0], 1e-6 * way[1], 1e-8 * way[2]];
        // `deep` is the depth at the face.
        gradient_holds(law, unloading, [deep + aside * tilt, aside, tilt], back * deep, way);
    }
}

/// Under a steady wind she rests where she stops and does not creep. In gusts the reaction stays between the two
/// curves.
#[test]
fn under_wind_and_gusts_she_does_not_creep_and_keeps_her_fender() {
    let share = 0.55;
    for step_s in [0.05, 0.5, 2.0] {
        let unloading = Unloading::ReturnedEnergy(share);
        let law = cone();
        let mut run = Run::new(model(law.clone(), unloading.clone()), 0.0, 0.0);
        let steps = (7200.0 / step_s) as u32;
        for i in 0..steps {
            let t_s = f64::from(i) * step_s;
            let gust_n = 1e5 * (libm::sin(t_s * 0.11) + libm::sin(t_s * 0.037));
            run.step(3e5 + gust_n, step_s);
            let contact = run.work.contacts().iter().find(|c| c.fender.is_some());
            let Some(contact) = contact.filter(|_| t_s > 60.0) else { continue };
            let loading_n = law.reaction_n(contact.depth_m);
            let lower_n = unloading.reaction_n(&law, contact.depth_m, loading_n) * contact.factor;
            let reaction_n = contact.parts.spring_n;
            // Compares the mean over the step with the curve at the start of the step.
            if step_s < 0.1 {
                assert!(reaction_n > 0.99 * lower_n, "{t_s} s: {reaction_n} N over {lower_n} N");
            }
        }
        // Ten minutes of steady wind.
        for _ in 0..(600.0 / step_s) as u32 {
            run.step(3e5, step_s);
        }
        let rest_m = run.deflection_m();
        for _ in 0..(86_400.0 / step_s.max(0.5)) as u32 {
            run.step(3e5, step_s.max(0.5));
        }
        let drift_m = run.deflection_m() - rest_m;
        println!(
            "{step_s} s: rests at {rest_m:.5} m, speed {:.2e}, drift {drift_m:.2e}",
            run.speed_mps()
        );
        assert!(drift_m.abs() < 2e-3, "{drift_m} m in a day");
    }
}

#[test]
fn a_run_continues_from_a_snapshot_within_a_loop_bit_for_bit() {
    let mut run = Run::new(model(cone(), Unloading::ReturnedEnergy(0.55)), 0.05, 0.3);
    while run.speed_mps() < 0.02 {
        run.step(0.0, 0.1);
    }
    let (saved, states) = (run.memory.snapshot(), run.states.clone());
    let rest = |mut run: Run| {
        (0..100).for_each(|_| run.step(2e5, 0.1));
        (format!("{:?}", run.states), run.memory.snapshot())
    };
    let mut again = Run::new(model(cone(), Unloading::ReturnedEnergy(0.55)), 0.05, 0.3);
    again.memory.restore(&run.model, &saved).expect("a good snapshot");
    again.states = states;
    assert_eq!(rest(run), rest(again));
}

/// A host with states one step late and without loads rebounds with the same share of energy.
#[test]
fn a_cosim_host_rebounds_with_the_root_of_the_returned_energy() {
    let model = model(FenderLaw::linear(2e6), Unloading::ReturnedEnergy(0.55));
    let settings = HostSettings { delay_steps: 1, integration: HostIntegration::ForwardEuler };
    for step_s in [0.05, 0.2] {
        let mut host = CoSimHost::new(&model, settings);
        let mut work = HostWorkspace::new(&model);
        let mut barge = BodyState {
            position_m: vec2(10.1, 0.0),
            velocity_mps: vec2(-0.3, 0.0),
            ..BodyState::default()
        };
        let mut input = barge;
        for _ in 0..(20.0 / step_s) as u32 {
            let states = [BodyState::default(), input];
            let wrench = host.step(&model, &mut work, &states, None, step_s).expect("good")[1];
            input = barge;
            barge.position_m += barge.velocity_mps * step_s;
            barge.velocity_mps += wrench.force_n * (step_s / 5e6);
        }
        let share = barge.velocity_mps.x / 0.3;
        assert!((share / libm::sqrt(0.55) - 1.0).abs() < 0.01, "{step_s} s: {share}");
    }
}
