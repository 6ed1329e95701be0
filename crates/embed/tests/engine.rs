//! The engine as a host uses it: the same bits as the simulation, calls out of order, arbitrary bytes.

use fenderline_contact::{
    BodyState, HostIntegration, HostSettings, Material, RestoreError, StepError, Wrench, vec2,
};
use fenderline_embed::{
    BodyDef, CoriolisTerms, Dump, DumpedOutcome, Engine, EngineBuilder, EngineError, Host, Results,
    Settings, is_dump,
};
use fenderline_scenario::Scenario;
use fenderline_sim::{MassProperties, Method, Simulation};

const TUG: &str = "scenarios/paper/experiment_2_4kn.toml";
const BERTH: &str = "scenarios/berth/eight_cones_at_5_deg.toml";

fn scenario(name: &str) -> Scenario {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../");
    Scenario::load(format!("{path}{name}").as_ref(), &[]).expect("a good scenario")
}

fn engine(name: &str, settings: &Settings) -> Engine {
    Engine::from_scenario(scenario(name), settings).expect("good settings")
}

fn co_simulation(delay_steps: u32) -> Settings {
    let host = HostSettings { delay_steps, integration: HostIntegration::ForwardEuler };
    Settings { host: Host::CoSimulation(host), ..Settings::default() }
}

/// Some steps of the tug, by a host that moves her by her own equations of motion.
fn run_steps(engine: &mut Engine, states: &mut [BodyState], steps: usize) {
    for _ in 0..steps {
        let wrenches = engine.advance(states, None, 0.1).expect("good states").to_vec();
        for (body, wrench) in wrenches.iter().enumerate() {
            let matrix = engine.model().bodies()[body].mobility.matrix().expect("both float");
            states[body].position_m += states[body].velocity_mps * 0.1;
            states[body].velocity_mps += wrench.force_n * (0.1 / matrix[0][0]);
        }
    }
}

/// `fenderline run` and an engine with the same states and loads give the same forces.
#[test]
fn the_same_states_give_the_same_bits_as_a_run() {
    for (name, steps) in [(TUG, 200), (BERTH, 3600)] {
        let mut engine = engine(name, &Settings::default());
        let setup = scenario(name).setup;
        let loads: Vec<Wrench> = (0..setup.bodies.len())
            .map(|body| {
                let own = setup.loads.iter().filter(|load| load.body == body);
                own.fold(Wrench::default(), |sum, load| Wrench {
                    force_n: sum.force_n + load.force_n,
                    moment_nm: sum.moment_nm + load.moment_nm,
                })
            })
            .collect();
        let loads = (setup.method == Method::Coupled).then_some(loads);
        let mut run = Simulation::new(setup).expect("a good set-up");
        let mut contacts = 0;
        for _ in 0..steps {
            let record = run.step().expect("a good run");
            engine.set_states(record.states).expect("good states");
            engine.set_loads(loads.as_deref()).expect("good loads");
            engine.step(0.1).expect("a good step");
            let results = engine.results().expect("a step was taken");
            assert_eq!(results.wrenches, record.wrenches, "{name} at {}", record.t_s);
            assert_eq!(results.contacts, record.contacts);
            assert_eq!(results.events, record.events);
            if loads.is_some() {
                assert_eq!(results.states_after, record.states_after);
            }
            contacts += results.contacts.len();
        }
        assert!(contacts > 10, "{name}");
    }
}

#[test]
fn notices_name_the_parts_that_are_left_to_the_host() {
    let notices = engine(BERTH, &Settings::default()).notices().join("\n");
    assert!(notices.contains("the engine leaves to the host: 1 load"), "{notices}");
}

#[test]
fn calls_out_of_order_are_errors_and_change_nothing() {
    let mut engine = engine(TUG, &Settings::default());
    let fresh = engine.save();
    assert_eq!(engine.results(), Err(EngineError::NoStepYet));
    let ship = || EngineError::StateNotSet { body: "ship".into() };
    assert_eq!(engine.step(0.1), Err(ship()));
    let states = engine.initial_states().to_vec();
    engine.set_state(1, &states[1]).expect("a good state");
    assert_eq!(engine.step(0.1), Err(ship()));
    assert!(matches!(engine.set_state(2, &states[1]), Err(EngineError::NoSuch { .. })));
    let loads = [Wrench::default(); 2];
    assert!(matches!(engine.set_loads(Some(&loads)), Err(EngineError::NotAvailable(_))));
    engine.set_state(0, &states[0]).expect("a good state");
    let bad_step = StepError::BadTimeStep { step_s: -0.1 };
    assert_eq!(engine.step(-0.1), Err(EngineError::Input(bad_step)));
    assert_eq!(engine.results(), Err(EngineError::NoStepYet));
    engine.step(0.1).expect("a good step");
    engine.reset();
    assert_eq!(engine.save(), fresh);
}

/// A pause was refused. A restored engine reports its saved results in a pause, too.
#[test]
fn a_pause_changes_nothing() {
    for host in [Host::default(), co_simulation(0).host, co_simulation(1).host] {
        let settings = Settings { host, ..coupled() };
        let mut engine = engine(TUG, &settings);
        let mut states = engine.initial_states().to_vec();
        assert_eq!(engine.advance(&states, None, 0.0).expect("a pause"), [Wrench::default(); 2]);
        run_steps(&mut engine, &mut states, 12);
        let wrenches = engine.results().expect("steps were taken").wrenches.to_vec();
        assert!(wrenches[1].force_n.length() > 1e5);
        let (saved, mut twin) = (engine.save(), engine.clone());
        let mut restored = engine.clone();
        restored.reset();
        restored.restore(&saved).expect("its own bytes");
        for paused in [&mut engine, &mut restored] {
            for _ in 0..3 {
                paused.advance(&states, None, 0.0).expect("a pause");
                let results = paused.results().expect("steps were taken");
                assert_eq!(results.wrenches, wrenches);
                assert!(results.events.is_empty() && !results.contacts.is_empty());
            }
        }
        // After a pause the delayed states are newer.
        if host != co_simulation(1).host {
            let mut others = states.clone();
            run_steps(&mut engine, &mut states, 5);
            run_steps(&mut twin, &mut others, 5);
            assert_eq!(states, others);
        }
    }
}

fn coupled() -> Settings {
    Settings { method: Some(Method::Coupled), ..Settings::default() }
}

#[test]
fn a_non_finite_number_names_body_and_field() {
    let mut engine = engine(BERTH, &Settings::default());
    let good = engine.initial_states().to_vec();
    engine.set_states(&good).expect("good states");
    let before = engine.save();
    let mut bad = good.clone();
    bad[0].velocity_mps.y = f64::NAN;
    let error = engine.set_states(&bad).unwrap_err().to_string();
    assert_eq!(error, "east velocity of body `ship` is NaN");
    assert_eq!(engine.set_state(0, &bad[0]).unwrap_err().to_string(), error);
    assert_eq!(engine.advance(&bad, None, 0.1).unwrap_err().to_string(), error);
    let mut loads = [Wrench::default(); 2];
    loads[1].moment_nm = f64::INFINITY;
    let error = engine.set_loads(Some(&loads)).unwrap_err().to_string();
    assert_eq!(error, "moment of the load of body `quay` is inf");
    assert!(engine.advance(&good, Some(&loads), 0.1).is_err());
    assert!(engine.advance(&good[1..], None, 0.1).is_err());
    assert!(engine.advance(&good, Some(&[Wrench::default(); 2]), -1.0).is_err());
    assert_eq!(engine.save(), before);
}

/// The largest load on a mass near zero overflows.
#[test]
fn a_step_with_non_finite_results_is_refused_and_changes_nothing() {
    let hull = [vec2(-10.0, -4.0), vec2(10.0, -4.0), vec2(10.0, 4.0), vec2(-10.0, 4.0)];
    let mut builder = EngineBuilder::new();
    let rubber = Material {
        stiffness_npm2: 5e5,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.5,
        restitution: 0.1,
    };
    let rubber = builder.material("rubber", rubber).expect("a good name");
    for (name, east_m, mass_kg) in [("one", 0.0, 1e6), ("two", 7.0, 1e6), ("three", 50.0, 1e-300)] {
        let position_m = vec2(0.0, east_m);
        let mass = MassProperties { mass_kg, yaw_inertia_kgm2: 5e7, ..MassProperties::default() };
        let mass = Some(mass);
        let body = BodyDef { name, outline_m: &hull, mass, position_m, heading_rad: 0.0 };
        builder.body(&body).expect("a good body");
    }
    builder.all_other_pairs(rubber).expect("it is there");
    let mut engine = builder.build(&Settings::default()).expect("a good model");
    let states = engine.initial_states().to_vec();
    let mut loads = [Wrench::default(); 3];
    engine.advance(&states, Some(&loads), 0.1).expect("good states");
    let (before, results) = (engine.save(), engine.results().map(|r| r.wrenches.to_vec()));
    loads[2].force_n = vec2(1e15, 0.0);
    for _ in 0..2 {
        let error = engine.advance(&states, Some(&loads), 0.1).expect_err("too far");
        assert_eq!(error, EngineError::NotFinite);
        assert_eq!(engine.save(), before);
        assert_eq!(engine.results().map(|r| r.wrenches.to_vec()), results);
    }
}

#[test]
fn the_state_of_a_fixed_body_need_not_be_set() {
    let mut engine = engine(BERTH, &Settings::default());
    let ship = engine.initial_states()[0];
    engine.set_state(0, &ship).expect("a good state");
    engine.step(0.1).expect("the quay stays at its position in the scenario");
}

#[test]
fn a_restored_engine_has_the_same_results_and_continues_with_the_same_bits() {
    let direct = Host::Direct { coriolis: Some(CoriolisTerms::InLoads) };
    let coupled = Settings { method: Some(Method::Coupled), host: direct };
    let delayed = Settings { method: Some(Method::Coupled), ..co_simulation(2) };
    for settings in [Settings::default(), coupled, delayed] {
        let mut one = engine(TUG, &settings);
        let mut states = one.initial_states().to_vec();
        run_steps(&mut one, &mut states, 15);
        let bytes = one.save();
        assert!(!one.results().expect("stepped").contacts.is_empty());
        let mut two = engine(TUG, &settings);
        two.restore(&bytes).expect("its own bytes");
        assert_eq!(two.save(), bytes);
        assert_eq!(two.results(), one.results());
        assert_eq!((two.states(), two.loads()), (one.states(), one.loads()));
        let mut again = states.clone();
        run_steps(&mut one, &mut states, 40);
        run_steps(&mut two, &mut again, 40);
        assert_eq!(again, states);
        assert_eq!(two.save(), one.save());
        // The engine that has run on returns to the older state.
        one.restore(&bytes).expect("its own bytes");
        assert_eq!(one.save(), bytes);
    }
}

#[test]
fn changed_truncated_and_foreign_bytes_are_refused_and_change_nothing() {
    let settings = Settings { method: Some(Method::Coupled), ..co_simulation(1) };
    let mut own = engine(TUG, &settings);
    let mut states = own.initial_states().to_vec();
    run_steps(&mut own, &mut states, 15);
    let bytes = own.save();
    for end in 0..bytes.len() {
        assert!(own.restore(&bytes[..end]).is_err(), "cut at {end}");
    }
    for place in 0..bytes.len() {
        let mut changed = bytes.clone();
        changed[place] ^= 0x10;
        assert!(own.restore(&changed).is_err(), "changed at {place}");
    }
    let more: Vec<u8> = bytes.iter().copied().chain([0]).collect();
    assert!(own.restore(&more).is_err());
    assert_eq!(own.save(), bytes);

    let other_model = engine(BERTH, &co_simulation(1)).save();
    assert_eq!(own.restore(&other_model), Err(RestoreError::OtherModel.into()));
    let later = Settings { method: Some(Method::Coupled), ..co_simulation(2) };
    let other_delay = engine(TUG, &later).save();
    assert_eq!(own.restore(&other_delay), Err(EngineError::OtherSettings));
    assert_eq!(own.save(), bytes);
}

#[test]
fn conflicting_settings_are_refused() {
    let refused = |settings| Engine::from_scenario(scenario(TUG), &settings).unwrap_err();
    assert!(matches!(refused(co_simulation(0)), EngineError::Settings(_)));
    let late = Settings { method: Some(Method::Coupled), ..co_simulation(1001) };
    assert!(matches!(refused(late), EngineError::Settings(_)));
}

#[test]
fn a_clone_runs_independently() {
    let mut one = engine(TUG, &Settings::default());
    let mut states = one.initial_states().to_vec();
    run_steps(&mut one, &mut states, 15);
    let (mut two, mut there) = (one.clone(), states.clone());
    there[1].position_m += vec2(0.0, -100.0);
    run_steps(&mut two, &mut there, 5);
    run_steps(&mut one, &mut states, 5);
    assert!(two.results().expect("stepped").contacts.is_empty());
    assert!(!one.results().expect("stepped").contacts.is_empty());
}

/// An impact within one step: the wrench is the mean, the peak is reported beside it, also after restoring.
#[test]
fn results_have_peak_wrenches_beside_the_means() {
    for host in [Host::default(), co_simulation(0).host] {
        let settings = Settings { host, ..coupled() };
        let mut engine = engine(TUG, &settings);
        let mut states = engine.initial_states().to_vec();
        states[1].position_m.y += 1.0;
        engine.advance(&states, None, 4.0).expect("a good step");
        let Results { wrenches, peak_wrenches: peaks, .. } = engine.results().expect("stepped");
        let (mean_n, peak_n) = (wrenches[1].force_n.length(), peaks[1].force_n.length());
        assert!(peak_n > 3.0 * mean_n && mean_n > 0.0, "{host:?}: {peak_n} N, {mean_n} N");
        let peaks = peaks.to_vec();
        let saved = engine.save();
        engine.advance(&states, None, 0.0).expect("a pause");
        assert_eq!(engine.results().expect("stepped").peak_wrenches, peaks);
        engine.reset();
        engine.restore(&saved).expect("its own bytes");
        assert_eq!(engine.results().expect("stepped").peak_wrenches, peaks);
    }
    // The paper's method has no sub-steps.
    let mut engine = engine(TUG, &Settings::default());
    let mut states = engine.initial_states().to_vec();
    states[1].position_m.y += 3.0;
    engine.advance(&states, None, 0.1).expect("a good step");
    let Results { wrenches, peak_wrenches: peaks, .. } = engine.results().expect("stepped");
    assert!(wrenches == peaks && wrenches[1].force_n.length() > 0.0);
}

/// A ship of 20 000 t that approaches a quay with one fender by keys. The direction "out" of the quay is east.
fn quay_with(keys: &str) -> Result<EngineBuilder, EngineError> {
    let mut builder = EngineBuilder::new();
    let rubber = Material {
        stiffness_npm2: 5e6,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 3e6,
        friction_static: 0.2,
        friction_dynamic: 0.2,
        restitution: 0.1,
    };
    let rubber = builder.material("rubber", rubber)?;
    let wall = [vec2(-60.0, -5.0), vec2(60.0, -5.0), vec2(60.0, 0.0), vec2(-60.0, 0.0)];
    let position_m = vec2(0.0, 0.0);
    let quay =
        BodyDef { name: "the quay", outline_m: &wall, mass: None, position_m, heading_rad: 0.0 };
    builder.body(&quay)?;
    let hull = [vec2(-60.0, -10.0), vec2(60.0, -10.0), vec2(60.0, 10.0), vec2(-60.0, 10.0)];
    let mass = MassProperties { mass_kg: 2e7, yaw_inertia_kgm2: 2e10, ..Default::default() };
    let position_m = vec2(0.0, 11.3);
    let (name, mass) = ("ship", Some(mass));
    builder.body(&BodyDef { name, outline_m: &hull, mass, position_m, heading_rad: 0.0 })?;
    builder.all_other_pairs(rubber)?;
    builder.fender_by_keys("f 1", keys)?;
    Ok(builder)
}

const CONE: &str =
    "on=\"the quay\"\nmaterial=rubber\ntype=cone\nsize=1050 F1.1\nposition=[0, 0]\nwidth=2 m";

/// The ship moves against the quay at 0.15 m/s; the engine moves her.
fn berthed(builder: &EngineBuilder, yaw_rate_radps: f64, steps: usize) -> Engine {
    let mut engine = builder.build(&Settings::default()).expect("a good model");
    let mut states = engine.initial_states().to_vec();
    states[1].velocity_mps = vec2(0.0, -0.15);
    states[1].yaw_rate_radps = yaw_rate_radps;
    for _ in 0..steps {
        engine.advance(&states, None, 0.1).expect("good states");
        states.copy_from_slice(engine.results().expect("stepped").states_after);
    }
    engine
}

/// The fender of the catalogue has the height, the rating and the temperature factor of its family's file.
#[test]
fn a_fender_by_keys_is_that_of_the_catalogue() {
    let builder = quay_with(CONE).expect("good keys");
    let engine = builder.build(&Settings::default()).expect("a good model");
    let fender = &engine.model().fenders()[0];
    // fenders/cone.toml: 1050 mm, rated at 72 % of the height.
    assert_eq!((fender.projection_m, fender.facing_rad), (1.05, core::f64::consts::FRAC_PI_2));
    assert!((fender.rated_deflection_m - 0.72 * 1.05).abs() < 1e-12);
    assert_eq!(fender.factors.constant, 1.0);
    let cold = quay_with(&format!("{CONE}\ntemperature=-30 degC")).expect("good keys");
    let cold = cold.build(&Settings::default()).expect("a good model");
    assert_eq!(cold.model().fenders()[0].factors.constant, 1.54);
    let of_two = quay_with(&format!("{CONE}\ncones=[{{ at = -0.8 }}, {{ at = 0.8 }}]"));
    let of_two = of_two.expect("good keys").build(&Settings::default()).expect("a good model");
    let panel = of_two.model().fenders()[0].panel.as_ref().expect("a panel");
    assert_eq!(panel.cones_m, [-0.8, 0.8]);
}

#[test]
fn mistakes_in_the_keys_of_a_fender_name_their_line_and_add_nothing() {
    let refused = |keys: &str| quay_with(keys).unwrap_err().to_string();
    assert!(refused("material=rubber").contains("lack `on=`"));
    assert!(refused("on=quay\nmaterial=rubber").contains("no body is named `quay`"));
    let unknown = refused(&CONE.replace("type=cone", "type=conne"));
    assert!(unknown.contains("--> type=conne") && unknown.contains("cone"), "{unknown}");
    let hot = refused(&format!("{CONE}\ntemperature=90 degC"));
    assert!(hot.contains("`fender.fender.temperature` must be at most 80 °C"), "{hot}");
    assert!(refused(&format!("{CONE}\nfacing")).contains("no value"), "a line without `=`");
    let mut builder = quay_with(CONE).expect("good keys");
    assert!(builder.fender_by_keys("f 1", CONE).is_err(), "the name is used");
    assert!(builder.fender_by_keys("f2", "on=ship").is_err());
    assert!(builder.fender_named("f2").is_err());
    assert_eq!(builder.fender_named("f 1"), Ok(0));
}

/// Mounting, face and compression of all fenders: by hand.
#[test]
fn fenders_can_be_drawn_at_rest_and_compressed() {
    let builder = quay_with(CONE).expect("good keys");
    let engine = builder.build(&Settings::default()).expect("a good model");
    let at_rest = engine.fender_views().next().expect("one fender");
    let near = |a: fenderline_contact::Vec2, b: [f64; 2]| (a - vec2(b[0], b[1])).length() < 1e-12;
    // It looks east: its left, looking out, is north.
    assert!(near(at_rest.mount_m[0], [1.0, 0.0]) && near(at_rest.mount_m[1], [-1.0, 0.0]));
    assert!(near(at_rest.face_m[0], [1.0, 1.05]) && near(at_rest.face_m[1], [-1.0, 1.05]));
    assert_eq!((at_rest.hull, at_rest.deflection_m), (None, 0.0));
    let engine = berthed(&builder, 0.0, 40);
    let pressed = engine.fender_views().next().expect("one fender");
    let contact = engine.results().expect("stepped").contacts[0];
    assert_eq!(pressed.hull.map(|hull| hull.0), Some(1));
    assert_eq!(pressed.deflection_m, contact.depth_m);
    assert_eq!(pressed.normal_force_n, contact.normal_force_n);
    assert!(pressed.deflection_m > 0.2 && pressed.peak_deflection_m >= pressed.deflection_m);
    assert!(near(pressed.face_m[0], [1.0, 1.05 - pressed.deflection_m]));
}

/// A panel on two cones that is pressed by a ship that turns follows her side.
#[test]
fn a_panel_that_turns_is_drawn_along_the_side_that_presses_it() {
    let keys = format!("{CONE}\ncones=[{{ at = -0.8 }}, {{ at = 0.8 }}]");
    let engine = berthed(&quay_with(&keys).expect("good keys"), 0.004, 40);
    let pressed = engine.fender_views().next().expect("one fender");
    assert!(pressed.panel_turn_rad.abs() > 2e-3, "{pressed:?}");
    // The hull's side lies along the panel: the slope of the face is her heading.
    let along = pressed.face_m[0] - pressed.face_m[1];
    let heading_rad = engine.states()[1].heading_rad;
    let slope_rad = libm::atan2(along.y, along.x);
    assert!(
        (slope_rad - heading_rad).abs() < 0.1 * heading_rad.abs(),
        "{slope_rad}, {heading_rad}"
    );
    let mut again = engine.clone();
    again.restore(&engine.save()).expect("its own bytes");
    assert_eq!(again.fender_views().next(), Some(pressed));
}

/// Recorded steps are replayed to the same bits from the dump alone, by each method and kind of host.
#[test]
fn a_dump_replays_to_the_same_bits() {
    let delayed = Settings { method: Some(Method::Coupled), ..co_simulation(2) };
    for settings in [Settings::default(), coupled(), delayed] {
        let mut engine = engine(TUG, &settings);
        assert_eq!(engine.dump(), Err(EngineError::NotRecorded));
        engine.record(10).expect("not too many");
        let mut states = engine.initial_states().to_vec();
        run_steps(&mut engine, &mut states, 25);
        engine.mark_teleported(1).expect("it is there");
        states[1].position_m.y -= 3.0;
        run_steps(&mut engine, &mut states, 3);
        engine.step(0.0).expect("a pause");
        assert!(engine.step(-1.0).is_err());
        let bytes = engine.dump().expect("recorded");
        assert!(is_dump(&bytes));
        let mut dump = Dump::read(&bytes).expect("its own bytes");
        // Two segments of 10 steps, of which the second is full but for one of the last 30: 10 + 10.
        assert_eq!(dump.steps(), 20);
        let mut refused = 0;
        while let Some(step) = dump.next_step() {
            assert!(step.is_same, "{step:?}");
            refused += usize::from(step.outcome == DumpedOutcome::Refused);
        }
        assert_eq!(refused, 1);
        assert_eq!(dump.engine().save(), engine.save());
        assert_eq!(dump.engine().results(), engine.results());
    }
}

/// Everything that a model can have goes through a dump: a curve, unloading, a stop, factors, a panel with chains.
#[test]
fn a_dump_has_the_whole_model() {
    let chains = "chains=[{ kind = \"tension\", at = \"0.7 m\", slack = \"20 mm\", stiffness = \"20 MN/m\", break_load = \"500 kN\" }]";
    let keys =
        format!("{CONE}\ntemperature=-10 degC\ncones=[{{ at = -0.8 }}, {{ at = 0.8 }}]\n{chains}");
    let builder = quay_with(&keys).expect("good keys");
    let mut engine = builder.build(&Settings::default()).expect("a good model");
    engine.record(1000).expect("not too many");
    let mut states = engine.initial_states().to_vec();
    states[1].velocity_mps = vec2(0.0, -0.15);
    for _ in 0..30 {
        engine.advance(&states, None, 0.1).expect("good states");
        states.copy_from_slice(engine.results().expect("stepped").states_after);
    }
    let mut dump = Dump::read(&engine.dump().expect("recorded")).expect("its own bytes");
    assert_eq!(dump.engine().model().fenders(), engine.model().fenders());
    while let Some(step) = dump.next_step() {
        assert!(step.is_same, "{step:?}");
    }
    assert_eq!(dump.into_engine().save(), engine.save());
}

#[test]
fn a_dump_that_was_changed_or_cut_is_refused() {
    let mut engine = engine(TUG, &coupled());
    engine.record(5).expect("not too many");
    let mut states = engine.initial_states().to_vec();
    run_steps(&mut engine, &mut states, 2);
    let bytes = engine.dump().expect("recorded");
    for end in (0..bytes.len()).step_by(7) {
        assert!(Dump::read(&bytes[..end]).is_err(), "cut at {end}");
    }
    // The sum of changed content is made right, as an attacker would.
    for place in 8..bytes.len() - 8 {
        let mut changed = bytes[..bytes.len() - 8].to_vec();
        changed[place] ^= 0x41;
        let sum = fenderline_contact::hash::Fnv1a::of(&changed);
        changed.extend_from_slice(&sum.to_le_bytes());
        if let Ok(mut dump) = Dump::read(&changed) {
            while dump.next_step().is_some() {}
        }
    }
    assert!(engine.record(2_000_000).is_err());
    engine.record(0).expect("it ends");
    assert_eq!(engine.dump(), Err(EngineError::NotRecorded));
}
