//! A vessel in the simulation, compared with the model of three degrees of freedom, in still water and in a current.
//! The manoeuvres are validated with that model.

use crate::ships;
use crate::support;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::environment::current::Current;
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::vessels::Origin;
use fenderline_sim::hydro::{Model3, Water, manoeuvres};
use fenderline_sim::{
    Action, Environment, Faults, Integrator, LineAction, Looks, MassProperties, Method, Order,
    Setup, Simulation, VesselAction, VesselSetup, WorldSetup,
};
use support::{fixed, rectangle};

/// KVLCC2 at full scale on a northerly course. Her rudder is put over at once.
fn kvlcc2(rudder_deg: f64, current_mps: Vec2, step_s: f64) -> (Setup, f64) {
    let vessel = ships::kvlcc2();
    let model = Model3::new(vessel.ship, Water::SEA);
    let approach =
        manoeuvres::Approach::at(&model, vessel.approach_mps.unwrap(), vessel.steering, 0.5)
            .expect("she goes");
    let mut body = fixed("kvlcc2", rectangle(320.0, 58.0));
    body.mass = Some(MassProperties { mass_kg: 1.0, yaw_inertia_kgm2: 1.0, ..Default::default() });
    body.velocity.surge_mps = vessel.approach_mps.unwrap() + current_mps.x;
    body.velocity.sway_mps = current_mps.y;
    let shaft_rps = approach.shaft_rps;
    let setup = Setup {
        step_s,
        duration_s: 900.0,
        integrator: Integrator::SemiImplicit,
        method: Method::Coupled,
        bodies: vec![body],
        materials: vec![],
        pairs: vec![],
        all_other_pairs: None,
        approaches: vec![],
        fenders: vec![],
        berthing: None,
        loads: vec![],
        world: WorldSetup {
            environment: Environment {
                current: Some(Current::uniform(current_mps).expect("a current")),
                ..Environment::default()
            },
            vessels: vec![VesselSetup {
                body: 0,
                origin: Origin::default(),
                ship: vessel.ship,
                deep: vessel.ship,
                rudder: vessel.steering,
                shaft: RateLimited { value: shaft_rps, rate_per_s: 0.1, stop: shaft_rps },
                thrusters: vec![],
                azimuths: vec![],
                current_table: None,
                windage: None,
                float: None,
                response: None,
                drift: None,
                seakeeping: None,
                plan: None,
                looks: Looks::default(),
            }],
            orders: vec![Order {
                at_s: 0.0,
                action: Action::Vessel(0, VesselAction::Rudder(rudder_deg.to_radians())),
            }],
            ..WorldSetup::default()
        },
    };
    (setup, approach.shaft_rps)
}

/// Advance and tactical diameter of midship (m).
fn circle(setup: Setup, current_mps: Vec2) -> (f64, f64) {
    let ahead_m = setup.world.vessels[0].ship.particulars.centre_of_gravity_m;
    let mut simulation = Simulation::new(setup).expect("a good set-up");
    let midship = |state: &fenderline_contact::BodyState, t_s: f64| {
        state.pose().apply(vec2(-ahead_m, 0.0)) - current_mps * t_s
    };
    let start = midship(&simulation.states()[0], 0.0);
    let (mut advance_m, mut diameter_m) = (f64::NAN, f64::NAN);
    let mut before = (0.0, start);
    while !simulation.is_done() {
        simulation.step().expect("a good step");
        let state = simulation.states()[0];
        let (heading, place) = (state.heading_rad.abs(), midship(&state, simulation.time_s()));
        let crossed = |at: f64| before.0 < at && heading >= at;
        let between = |at: f64| {
            before.1 + (place - before.1) * ((at - before.0) / (heading - before.0)) - start
        };
        if crossed(core::f64::consts::FRAC_PI_2) {
            advance_m = between(core::f64::consts::FRAC_PI_2).x;
        }
        if crossed(core::f64::consts::PI) {
            diameter_m = between(core::f64::consts::PI).y.abs();
            break;
        }
        before = (heading, place);
    }
    (advance_m, diameter_m)
}

#[test]
fn a_vessel_turns_in_the_simulation_as_in_the_validated_model() {
    let vessel = ships::kvlcc2();
    let model = Model3::new(vessel.ship, Water::SEA);
    let approach =
        manoeuvres::Approach::at(&model, vessel.approach_mps.unwrap(), vessel.steering, 0.5)
            .expect("she goes");
    for rudder_deg in [35.0, -35.0_f64] {
        let turn = manoeuvres::turning_circle(&model, &approach, rudder_deg.to_radians()).unwrap();
        // Forces are constant during a step, so the error decreases with the step.
        for (step_s, tolerance) in [(0.1, 0.002), (1.0, 0.02)] {
            let (advance_m, diameter_m) =
                circle(kvlcc2(rudder_deg, Vec2::ZERO, step_s).0, Vec2::ZERO);
            let off = |ours: f64, theirs: f64| (ours / theirs - 1.0).abs();
            assert!(off(advance_m, turn.advance_m) < tolerance, "{advance_m}, {}", turn.advance_m);
            assert!(
                off(diameter_m, turn.tactical_diameter_m.abs()) < tolerance,
                "{diameter_m}, {}",
                turn.tactical_diameter_m
            );
        }
    }
}

#[test]
fn a_uniform_current_carries_a_manoeuvre_along_and_changes_nothing_else() {
    let still = circle(kvlcc2(35.0, Vec2::ZERO, 0.5).0, Vec2::ZERO);
    let current_mps = vec2(0.7, -1.1);
    let carried = circle(kvlcc2(35.0, current_mps, 0.5).0, current_mps);
    assert!((still.0 - carried.0).abs() < 1e-6 && (still.1 - carried.1).abs() < 1e-6);
}

#[test]
fn an_order_during_a_run_equals_one_of_the_set_up_bit_for_bit() {
    let (mut setup, _) = kvlcc2(35.0, Vec2::ZERO, 0.5);
    setup.duration_s = 100.0;
    let later = Order { at_s: 40.0, action: Action::Vessel(0, VesselAction::Rudder(-0.2)) };
    let mut planned = setup.clone();
    planned.world.orders.push(later.clone());
    let mut planned = Simulation::new(planned).expect("a good set-up");
    // The set-up has no orders. Both orders are given during the run, the later one long before its time.
    setup.world.orders.clear();
    let mut steered = Simulation::new(setup).expect("a good set-up");
    steered.order(later).expect("she has a rudder");
    let first =
        Order { at_s: 0.0, action: Action::Vessel(0, VesselAction::Rudder(35.0_f64.to_radians())) };
    steered.order(first).expect("she has a rudder");
    while !planned.is_done() {
        planned.step().expect("a good step");
        steered.step().expect("a good step");
        assert_eq!(planned.states(), steered.states(), "{} s", planned.time_s());
    }
}

#[test]
fn an_impossible_order_is_refused_and_changes_nothing() {
    let (mut setup, _) = kvlcc2(35.0, Vec2::ZERO, 0.5);
    setup.duration_s = 50.0;
    let mut left_alone = Simulation::new(setup.clone()).expect("a good set-up");
    let mut bothered = Simulation::new(setup).expect("a good set-up");
    let push = fenderline_sim::tug::TugOrder::Push { force_n: 1e5, direction_rad: 0.0 };
    while !left_alone.is_done() {
        let vessel = |action| Action::Vessel(0, action);
        for (at_s, action) in [
            (f64::NAN, vessel(VesselAction::Rudder(0.1))),
            (0.0, vessel(VesselAction::Rudder(f64::NAN))),
            (0.0, vessel(VesselAction::Engine(f64::INFINITY))),
            (0.0, vessel(VesselAction::Engine(1.5))),
            (0.0, vessel(VesselAction::Speed(-31.0))),
            (0.0, Action::Vessel(1, VesselAction::Engine(0.5))),
            (0.0, vessel(VesselAction::Thruster(0, 0.5))),
            (0.0, vessel(VesselAction::Azimuth { unit: 0, power: Some(1.0), direction_rad: None })),
            (0.0, Action::Tug(0, push)),
            (0.0, Action::Line(0, LineAction::LetGo)),
        ] {
            let order = Order { at_s, action };
            bothered.order(order.clone()).expect_err(&format!("{order:?}"));
        }
        left_alone.step().expect("a good step");
        bothered.step().expect("a good step");
        assert_eq!(left_alone.states(), bothered.states());
    }
}

#[test]
fn failed_controls_do_not_move_until_they_are_repaired() {
    let (setup, _) = kvlcc2(35.0, Vec2::ZERO, 0.5);
    let mut run = Simulation::new(setup).expect("a good set-up");
    let go = |run: &mut Simulation, seconds: f64| {
        for _ in 0..(seconds / 0.5) as u32 {
            run.step().expect("a good step");
        }
        (run.vessels()[0].rudder.value, run.vessels()[0].shaft.value)
    };
    let (stuck_rad, full_rps) = go(&mut run, 5.0);
    assert!(stuck_rad > 0.0 && stuck_rad < 0.5 && full_rps > 0.0, "on its way: {stuck_rad}");
    run.set_faults(0, Faults { rudder_stuck: true, ..Faults::default() }).expect("she is there");
    assert_eq!(go(&mut run, 60.0), (stuck_rad, full_rps));
    run.set_faults(0, Faults { blackout: true, ..Faults::default() }).expect("she is there");
    assert_eq!(go(&mut run, 200.0), (stuck_rad, 0.0));
    run.set_faults(0, Faults::default()).expect("she is there");
    let (over_rad, again_rps) = go(&mut run, 200.0);
    assert!(over_rad > 0.6 && again_rps == full_rps, "{over_rad}, {again_rps}");
    assert!(run.set_faults(1, Faults::default()).is_err(), "there is one vessel");
}

#[test]
fn a_current_set_during_a_run_carries_a_drifting_ship_as_one_from_the_start() {
    let drift = |at_start: bool| {
        let current_mps = vec2(0.0, 0.5);
        let (mut setup, _) = kvlcc2(0.0, if at_start { current_mps } else { Vec2::ZERO }, 0.5);
        setup.bodies[0].velocity = fenderline_sim::BodyVelocity::default();
        setup.world.orders =
            vec![Order { at_s: 0.0, action: Action::Vessel(0, VesselAction::Engine(0.0)) }];
        setup.duration_s = 600.0;
        let mut run = Simulation::new(setup).expect("a good set-up");
        if !at_start {
            run.set_current(Some(Current::uniform(current_mps).expect("a current")));
        }
        while !run.is_done() {
            run.step().expect("a good step");
        }
        run.states()[0]
    };
    let (one, other) = (drift(true), drift(false));
    assert!(other.velocity_mps.y > 0.1, "{other:?}");
    assert_eq!(one, other);
}

#[test]
fn dropped_orders_are_not_carried_out_and_the_others_are() {
    let (mut setup, _) = kvlcc2(0.0, Vec2::ZERO, 0.5);
    setup.duration_s = 60.0;
    setup.world.orders = vec![
        Order { at_s: 10.0, action: Action::Vessel(0, VesselAction::Rudder(0.3)) },
        Order { at_s: 20.0, action: Action::Vessel(0, VesselAction::Engine(0.2)) },
    ];
    let mut run = Simulation::new(setup).expect("a good set-up");
    run.retain_orders(|order| matches!(order.action, Action::Vessel(_, VesselAction::Engine(_))));
    while !run.is_done() {
        run.step().expect("a good step");
    }
    let orders = &run.vessels()[0].orders;
    assert_eq!((orders.rudder_rad, orders.shaft), (0.0, 0.2));
}
