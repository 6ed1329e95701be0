//! A host places bodies in others. They are pressed out slowly, for any host and depth.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    Body, BodyId, BodyState, Event, EventKind, Fender, FenderLaw, HostIntegration, HostSettings,
    MAX_PUSH_OUT_MPS, Memory, Mobility, Model, ReactionFactors, Stop, Unloading, Workspace, Wrench,
    advance_in_place, vec2,
};
use master::{Master, Scene, Service, model, rectangle, rubber};

const MASS_KG: f64 = 1.5e8;
const BEAM_M: f64 = 36.0;

/// A ship of 200 m whose side is `depth_m` deep in a quay.
fn ship_placed_in_quay(depth_m: f64, stiffness_npm2: f64, restitution: f64) -> Scene {
    let ship = Mobility::Free { mass_kg: MASS_KG, yaw_inertia_kgm2: MASS_KG * 2500.0 };
    let bodies = [(rectangle(BEAM_M, 200.0), ship), (rectangle(60.0, 400.0), Mobility::Fixed)];
    let quay_m = 0.5 * BEAM_M + 30.0;
    Scene {
        model: model(&bodies, rubber(stiffness_npm2, restitution, 0.3)),
        states: vec![
            BodyState { position_m: vec2(depth_m, 0.0), ..BodyState::default() },
            BodyState { position_m: vec2(quay_m, 0.0), ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

fn has_event(events: &[Event], kind: EventKind) -> bool {
    events.iter().any(|event| event.kind == kind)
}

/// Limit of the contact force, not counting the loads: an acceleration of 0.02 m/s².
const LARGEST_N: f64 = 0.021 * MASS_KG;

/// From a depth of 3 m the force was 1.15 GN and the speed 1.5 m/s. From 9 m the values were 6.5 GN and 8.5 m/s. There
/// was no event.
#[test]
fn a_ship_placed_up_to_half_her_beam_in_a_quay_is_pressed_out_slowly() {
    for depth_m in [1.0, 3.0, 9.0, 0.5 * BEAM_M] {
        for (stiffness_npm2, restitution) in [(1e6, 0.0), (1e6, 0.1), (1e6, 0.9), (1e8, 0.1)] {
            for step_s in [1.0 / 60.0, 0.5] {
                let Scene { model, mut states, loads } =
                    ship_placed_in_quay(depth_m, stiffness_npm2, restitution);
                let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
                let who =
                    format!("{depth_m} m, {stiffness_npm2} N/m², γ {restitution}, Δt {step_s}");
                let (mut placements, mut out_s) = (0, 0.0);
                while states[0].position_m.x > 0.0 {
                    advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, step_s)
                        .expect("good states");
                    placements += usize::from(has_event(work.events(), EventKind::PlacedInOverlap));
                    let wrench_n = work.wrenches()[0].force_n.length();
                    assert!(wrench_n < LARGEST_N, "{who}: {wrench_n} N");
                    let speed_mps = states[0].velocity_mps.length();
                    assert!(speed_mps <= MAX_PUSH_OUT_MPS + 1e-9, "{who}: {speed_mps} m/s");
                    out_s += step_s;
                    assert!(out_s < 5.0 + depth_m / MAX_PUSH_OUT_MPS, "{who}: {:?}", states[0]);
                }
                assert_eq!(placements, 1, "{who}");
            }
        }
    }
}

/// The same for hosts that move her themselves, with and without a mark, by less and by more than a tenth of her
/// radius.
#[test]
fn a_placed_ship_leaves_slowly_with_any_host() {
    for integration in [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit] {
        for delay_steps in 0..=2 {
            for (depth_m, says_so) in [(3.0, false), (3.0, true), (15.0, false), (15.0, true)] {
                for step_s in [1.0 / 60.0, 0.2, 1.0] {
                    let mut master = Master::known(
                        ship_placed_in_quay(-5.0, 1e6, 0.1),
                        integration,
                        delay_steps,
                    );
                    master.run(step_s, 20.0);
                    master.past.last_mut().expect("never empty")[0].position_m.x = depth_m;
                    let who =
                        format!("{integration:?}, delay {delay_steps}, {depth_m} m, Δt {step_s}");
                    let (mut placements, mut time_s) = (false, 0.0);
                    for k in 0.. {
                        if says_so && k == delay_steps {
                            master.host.mark_teleported(&master.scene.model, BodyId(0));
                        }
                        master.step(step_s);
                        placements |= has_event(master.work.events(), EventKind::PlacedInOverlap);
                        let wrench_n = master.work.wrenches()[0].force_n.length();
                        assert!(wrench_n < LARGEST_N, "{who}: {wrench_n} N");
                        let speed_mps = master.states()[0].velocity_mps.length();
                        assert!(speed_mps <= MAX_PUSH_OUT_MPS + 1e-6, "{who}: {speed_mps} m/s");
                        time_s += step_s;
                        if time_s > 20.0 + depth_m / MAX_PUSH_OUT_MPS {
                            break;
                        }
                    }
                    assert!(placements, "{who}");
                    let place_m = master.states()[0].position_m.x;
                    assert!(place_m < 0.0, "{who}: {place_m} m");
                }
            }
        }
    }
}

/// A ship that is pressed out against a load rests at her static depth. A ship that is placed there with 1 m/s is
/// stopped without a shock.
#[test]
fn a_placed_ship_with_load_and_speed_comes_to_rest_at_her_static_depth() {
    for (load_n, speed_mps) in [(2e6, 0.0), (2e6, 1.0), (2e7, 0.3)] {
        let Scene { model, mut states, mut loads } = ship_placed_in_quay(6.0, 1e6, 0.1);
        loads[0].force_n.x = load_n;
        states[0].velocity_mps.x = speed_mps;
        let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
        for _ in 0..20_000 {
            advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.1).unwrap();
            let wrench_n = work.wrenches()[0].force_n.length();
            // She may leave and return at the same speed. The force is then v √(k m).
            let back_n = MAX_PUSH_OUT_MPS * (200e6 * MASS_KG).sqrt();
            let largest_n = load_n + LARGEST_N.max(back_n) + 0.51 * MASS_KG * speed_mps;
            assert!(wrench_n < largest_n, "{load_n} N, {speed_mps} m/s: {wrench_n} N");
        }
        let depth_m = states[0].position_m.x;
        // Along her side the quay has a stiffness of 200 MN/m.
        let right_m = load_n / 200e6;
        assert!((depth_m / right_m - 1.0).abs() < 0.01, "{load_n} N, {speed_mps} m/s: {depth_m} m");
    }
}

/// An impact that reaches the same depth is not affected. It returns the whole energy that γ allows.
#[test]
fn a_deep_impact_is_not_a_placement() {
    let Scene { model, mut states, loads } = ship_placed_in_quay(-1.0, 50e3, 0.9);
    states[0].velocity_mps.x = 1.0;
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut deepest_m = 0.0_f64;
    for _ in 0..400 {
        advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, 0.1).unwrap();
        deepest_m = deepest_m.max(states[0].position_m.x);
        assert!(!has_event(work.events(), EventKind::PlacedInOverlap));
    }
    assert!(deepest_m > 3.0, "{deepest_m} m");
    let left_mps = -states[0].velocity_mps.x;
    assert!((left_mps - 0.9).abs() < 0.01, "{left_mps} m/s");
}

/// A mark takes effect once, and is saved.
#[test]
fn a_marked_body_begins_its_contacts_anew_once() {
    let Scene { model, mut states, loads } = ship_placed_in_quay(0.1, 1e6, 0.1);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut teleported = |memory: &mut Memory, states: &mut Vec<BodyState>| {
        advance_in_place(&model, memory, &mut work, states, &loads, 0.1).unwrap();
        has_event(work.events(), EventKind::Teleported)
    };
    assert!(!teleported(&mut memory, &mut states));
    memory.mark_teleported(&model, BodyId(0));
    let mut other = Memory::new(&model);
    other.restore(&model, &memory.snapshot()).expect("its own bytes");
    assert_eq!(other, memory);
    assert!(teleported(&mut other, &mut states));
    assert!(!teleported(&mut other, &mut states));
}

/// A ship of 200 m whose side is `depth_m` deep in fenders along a quay. The fenders return 55 % of the absorbed
/// energy. Their curve is that of a cone, 3 MN at 0.5 m, 2.7 MN at 0.8 m and 4 MN at 1 m, times a factor.
#[derive(Clone, Copy, Debug)]
struct Berth {
    fenders: u32,
    depth_m: f64,
    mass_kg: f64,
    stiffer: f64,
}

const TWO_FENDERS: Berth = Berth { fenders: 2, depth_m: 1.0, mass_kg: MASS_KG, stiffer: 1.0 };

fn ship_placed_in_rubber(berth: Berth) -> Scene {
    let Berth { fenders, depth_m, mass_kg, stiffer } = berth;
    let mut builder = Model::builder();
    let free = Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 2500.0 };
    let mut body = |name: &str, key, outline, mobility| {
        builder.body(Body { name: name.into(), key, outline, mobility })
    };
    body("ship", 1, rectangle(BEAM_M, 200.0), free);
    let quay = body("quay", 2, rectangle(60.0, 400.0), Mobility::Fixed);
    let material = builder.material(rubber(1e6, 0.1, 0.3));
    let curve = [[0.0, 0.0], [0.5, 3e6], [0.8, 2.7e6], [1.0, 4e6]];
    for number in 0..fenders {
        let along_m = 30.0 * (f64::from(number) - 0.5 * f64::from(fenders - 1));
        builder.fender(Fender {
            name: format!("fender {number}"),
            key: u64::from(number) + 1,
            body: quay,
            position_m: vec2(-30.0, along_m),
            facing_rad: std::f64::consts::PI,
            width_m: 3.0,
            projection_m: 1.4,
            rated_deflection_m: 1.0,
            law: FenderLaw::Curve(curve.map(|[at_m, force_n]| [at_m, stiffer * force_n]).to_vec()),
            unloading: Some(Unloading::ReturnedEnergy(0.55)),
            stop: Some(Stop { from_m: 1.0, stiffness_npm: 2e8 }),
            factors: ReactionFactors::default(),
            panel: None,
            material,
        });
    }
    builder.all_other_pairs(material);
    let quay_m = 0.5 * BEAM_M + 1.4 + 30.0;
    let at = |north_m: f64| BodyState { position_m: vec2(north_m, 0.0), ..BodyState::default() };
    Scene {
        model: builder.build().expect("a good model"),
        states: vec![at(depth_m), at(quay_m)],
        loads: vec![Wrench::default(); 2],
    }
}

/// A run in which the engine moves the bodies.
struct Run {
    scene: Scene,
    memory: Memory,
    work: Workspace,
    /// Number of events of a body placed in another.
    placements: usize,
}

impl Run {
    fn new(scene: Scene) -> Run {
        let (memory, work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
        Run { scene, memory, work, placements: 0 }
    }

    /// Runs, and returns the largest speed of the first body.
    fn go(&mut self, step_s: f64, duration_s: f64) -> f64 {
        let (mut fastest_mps, mut time_s) = (0.0_f64, 0.0);
        let Scene { model, states, loads } = &mut self.scene;
        while time_s < duration_s {
            advance_in_place(model, &mut self.memory, &mut self.work, states, loads, step_s)
                .expect("good states");
            self.placements +=
                usize::from(has_event(self.work.events(), EventKind::PlacedInOverlap));
            fastest_mps = fastest_mps.max(states[0].velocity_mps.length());
            time_s += step_s;
        }
        fastest_mps
    }

    fn ship(&mut self) -> &mut BodyState {
        &mut self.scene.states[0]
    }
}

const OUT_MPS: f64 = MAX_PUSH_OUT_MPS + 1e-6;

/// From 1 m the speed was 0.245 m/s: the rubber returned energy that the host had created by placing the ship.
#[test]
fn a_ship_placed_in_rubber_leaves_slowly() {
    for fenders in [1, 2, 4] {
        for (depth_m, mass_kg, stiffer) in [
            (0.1, MASS_KG, 1.0),
            (0.3, MASS_KG, 1.0),
            (0.6, MASS_KG, 1.0),
            (1.0, MASS_KG, 1.0),
            (1.2, MASS_KG, 1.0),
            (3.0, MASS_KG, 1.0),
            (1.0, MASS_KG, 0.1),
            (1.0, 2e7, 1.0),
            (0.2, 2e7, 1.0),
        ] {
            for step_s in [1.0 / 60.0, 0.1, 0.5, 2.0] {
                let berth = Berth { fenders, depth_m, mass_kg, stiffer };
                let mut run = Run::new(ship_placed_in_rubber(berth));
                let fastest_mps = run.go(step_s, 20.0 + depth_m / MAX_PUSH_OUT_MPS);
                let who = format!("{berth:?}, Δt {step_s}");
                assert!(fastest_mps < OUT_MPS, "{who}: {fastest_mps} m/s");
                // An event reports the placing if the contact would accelerate her to 0.08 m/s.
                let energy_j = 0.5 * mass_kg * MAX_PUSH_OUT_MPS * MAX_PUSH_OUT_MPS;
                let held_j = 0.55 * f64::from(fenders) * stiffer * 3e6 * depth_m * depth_m;
                if depth_m < 0.5 {
                    assert_eq!(run.placements, usize::from(held_j > energy_j), "{who}");
                }
                assert!(run.placements < 2 && (depth_m < 1.1 || run.placements == 1), "{who}");
            }
        }
    }
}

/// The same with a host that moves her itself, with and without a mark.
#[test]
fn a_ship_placed_in_rubber_leaves_slowly_with_any_host() {
    for integration in [HostIntegration::ForwardEuler, HostIntegration::SemiImplicit] {
        let following = |delay_steps| {
            let settings = HostSettings { delay_steps, integration };
            (delay_steps, Service::CoSim(settings))
        };
        for (delay_steps, service) in
            [following(0), following(1), following(2), (0, Service::Direct)]
        {
            for says_so in [false, true] {
                for step_s in [1.0 / 60.0, 0.2, 1.0] {
                    let away = Berth { depth_m: -5.0, ..TWO_FENDERS };
                    let scene = ship_placed_in_rubber(away);
                    let mut master = Master::new(scene, integration, delay_steps, service);
                    master.run(step_s, 20.0);
                    master.past.last_mut().expect("never empty")[0].position_m.x = 1.0;
                    let who = format!("{integration:?}, {service:?}, {says_so}, Δt {step_s}");
                    let (mut placements, mut time_s) = (false, 0.0);
                    for k in 0.. {
                        if says_so && k == delay_steps {
                            master.host.mark_teleported(&master.scene.model, BodyId(0));
                            master.direct.mark_teleported(&master.scene.model, BodyId(0));
                        }
                        master.step(step_s);
                        placements |= has_event(master.events(), EventKind::PlacedInOverlap);
                        let speed_mps = master.states()[0].velocity_mps.length();
                        // In some seconds a direct host gets the correction of its velocity.
                        assert!(speed_mps < 0.082, "{who}: {speed_mps} m/s");
                        time_s += step_s;
                        if time_s > 40.0 {
                            break;
                        }
                    }
                    assert!(placements, "{who}");
                    let place_m = master.states()[0].position_m.x;
                    assert!(place_m < 0.0, "{who}: {place_m} m");
                }
            }
        }
    }
}

/// The wind presses her on and then dies. It must not release the energy that the placing created.
#[test]
fn a_ship_placed_in_rubber_under_wind_leaves_slowly_when_it_dies() {
    for (wind_n, step_s) in [(5e5, 0.1), (2e6, 0.1), (2e6, 1.0), (6e6, 0.1), (6e6, 1.0)] {
        let mut run = Run::new(ship_placed_in_rubber(TWO_FENDERS));
        run.scene.loads[0].force_n.x = wind_n;
        let who = format!("{wind_n} N, Δt {step_s}");
        let fastest_mps = run.go(step_s, 600.0);
        assert!(fastest_mps < OUT_MPS, "{who}: {fastest_mps} m/s");
        let (at_rest_mps, depth_m) = (run.go(step_s, 10.0), run.ship().position_m.x);
        assert!(at_rest_mps < 1e-3 && depth_m > 0.0, "{who}: {at_rest_mps} m/s at {depth_m} m");
        let held_n = -run.work.wrenches()[0].force_n.x;
        // She still swings by less than 1 mm/s, which rubber hardly damps.
        assert!((held_n / wind_n - 1.0).abs() < 0.02, "{who}: {held_n} N");
        run.scene.loads[0].force_n.x = 0.0;
        let fastest_mps = run.go(step_s, 60.0);
        assert!(fastest_mps < OUT_MPS, "{who}: {fastest_mps} m/s");
        assert!(run.ship().position_m.x < 0.0, "{who}");
    }
}

/// The ship is dragged by a centimetre per frame, as in an editor.
#[test]
fn a_ship_dragged_into_rubber_leaves_slowly() {
    for translation_m in [0.002, 0.01, 0.05] {
        let mut run = Run::new(ship_placed_in_rubber(Berth { depth_m: -0.05, ..TWO_FENDERS }));
        let mut depth_m = -0.05;
        while depth_m < 1.0 {
            depth_m += translation_m;
            *run.ship() = BodyState { position_m: vec2(depth_m, 0.0), ..BodyState::default() };
            run.go(0.1, 0.1);
        }
        let fastest_mps = run.go(0.1, 40.0);
        assert!(fastest_mps < OUT_MPS, "{translation_m} m a frame: {fastest_mps} m/s");
        assert!(run.placements > 0 && run.ship().position_m.x < 0.0, "{translation_m} m a frame");
    }
}

/// A ship that arrives under way gets the returned energy of rubber, even if her host moves her slightly differently.
#[test]
fn an_impact_with_a_slightly_different_motion_is_not_a_placement() {
    let mut run = Run::new(ship_placed_in_rubber(Berth { depth_m: -0.5, ..TWO_FENDERS }));
    run.ship().velocity_mps.x = 0.2;
    while run.ship().velocity_mps.x > 0.0 {
        run.go(0.1, 0.1);
    }
    for _ in 0..3 {
        run.ship().position_m.x += 0.002;
        run.go(0.1, 0.1);
    }
    run.go(0.1, 60.0);
    let left = -run.ship().velocity_mps.x / (0.2 * 0.55_f64.sqrt());
    assert!((left - 1.0).abs() < 0.02, "{left}");
    assert_eq!(run.placements, 0);
}

/// Both bodies float, and neither is thrown off.
#[test]
fn a_ship_placed_in_another_leaves_slowly() {
    let free = |mass_kg: f64| Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 2500.0 };
    for (depth_m, restitution) in [(1.0, 0.1), (3.0, 0.9), (10.0, 0.1), (18.0, 0.0)] {
        for step_s in [1.0 / 60.0, 0.5] {
            let bodies =
                [(rectangle(BEAM_M, 200.0), free(MASS_KG)), (rectangle(BEAM_M, 150.0), free(3e7))];
            let at = |x: f64| BodyState { position_m: vec2(x, 7.0), ..BodyState::default() };
            let scene = Scene {
                model: model(&bodies, rubber(1e6, restitution, 0.3)),
                states: vec![BodyState::default(), at(BEAM_M - depth_m)],
                loads: vec![Wrench::default(); 2],
            };
            let mut run = Run::new(scene);
            run.go(step_s, 60.0 + depth_m / MAX_PUSH_OUT_MPS);
            let who = format!("{depth_m} m, γ {restitution}, Δt {step_s}");
            let [one, two] = [0, 1].map(|ship| run.scene.states[ship].velocity_mps);
            // The contact is off the middle of one body, which is turned.
            assert!((two - one).length() < 0.09, "{who}: {one:?}, {two:?}");
            assert_eq!((run.placements, run.work.contacts().len()), (1, 0), "{who}");
        }
    }
}
