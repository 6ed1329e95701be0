//! The instructor's script: changes over a time, planned events, and faults by name.

use crate::support;

use fenderline_live::{Action, Fault, OtherAction, Session};
use support::{command, engine, go, harbour, open, replay, rudder, saved};

fn wind(speed_mps: f64, from_rad: f64, over_s: f64) -> Action {
    OtherAction::Wind { speed_mps, from_rad, over_s }.into()
}

fn fault(fault: Fault) -> OtherAction {
    OtherAction::Fault { vessel: "ship".into(), fault, on: true }
}

fn plan(at_s: f64, event: OtherAction) -> Action {
    OtherAction::Plan { at_s, event: Box::new(event) }.into()
}

/// The present mean wind: speed (m/s), and direction from which it comes (rad).
fn mean(session: &Session) -> (f64, f64) {
    let wind = session.simulation().setup().world.environment.wind.as_ref().expect("a wind");
    wind.mean_at(session.simulation().time_s())
}

#[test]
fn a_ramp_changes_speed_and_direction_by_a_straight_line_over_the_shorter_turn() {
    let mut session = harbour();
    command(&mut session, wind(4.0, 6.0, 0.0));
    command(&mut session, wind(12.0, 0.5, 20.0));
    let turn = 0.5 + std::f64::consts::TAU - 6.0;
    for tick in 1..=250_u32 {
        go(&mut session, 1);
        let share = f64::from(tick.min(200)) * 0.1 / 20.0;
        let (speed_mps, from_rad) = mean(&session);
        assert!((speed_mps - (4.0 + 8.0 * share)).abs() < 1e-9, "{tick}: {speed_mps}");
        let off = libm_remainder(from_rad - (6.0 + turn * share));
        assert!(off.abs() < 1e-9, "{tick}: {from_rad}");
    }
    for (speed_mps, over_s) in [(0.4, 0.0), (1.0, 10.0)] {
        let current = OtherAction::Current { speed_mps, to_rad: 0.7, over_s };
        command(&mut session, current.into());
    }
    go(&mut session, 50);
    let environment = &session.simulation().setup().world.environment;
    let water = environment.current.as_ref().expect("a current");
    let water = water.velocity(fenderline_contact::Vec2::ZERO, 0.0, 5.0);
    assert!((water.length() - 0.7).abs() < 1e-9, "{water:?}");
}

/// An angle within half a turn.
fn libm_remainder(angle_rad: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle_rad - turn * (angle_rad / turn).round()
}

#[test]
fn a_ramp_keeps_the_gusts() {
    // The gusts are the same. At the end of a ramp the wind equals, bit for bit, the wind of a run in which it was set
    // at once.
    let mut ramp = open("scenarios/live/berthing.toml", &[]);
    let mut jump = ramp.clone();
    command(&mut ramp, wind(10.0, 4.0, 5.0));
    command(&mut jump, wind(10.0, 4.0, 0.0));
    for session in [&mut ramp, &mut jump] {
        go(session, 60);
    }
    let air = |session: &Session| {
        let simulation = session.simulation();
        let wind = simulation.setup().world.environment.wind.as_ref().expect("a wind");
        wind.velocity(10.0, simulation.time_s())
    };
    assert_eq!(air(&ramp), air(&jump));
    assert!((air(&ramp).length() - 10.0).abs() > 1e-3, "gusts: {:?}", air(&ramp));
}

#[test]
fn planned_events_fire_at_their_time_or_are_cancelled_and_survive_a_restart() {
    let mut session = harbour();
    command(&mut session, plan(2.0, fault(Fault::EngineLost)));
    command(&mut session, plan(3.0, fault(Fault::Blackout)));
    command(&mut session, plan(1.0, OtherAction::TugOut { tug: "aft".into(), on: true }));
    command(&mut session, OtherAction::CancelPlanned { id: 2 }.into());
    let states = |session: &Session| -> Vec<(u64, &'static str)> {
        session.planned().iter().map(|planned| (planned.id, planned.state)).collect()
    };
    assert_eq!(states(&session), [(3, "waits"), (1, "waits"), (2, "cancelled")]);
    go(&mut session, 20);
    assert!(session.simulation().tugs()[1].out || session.simulation().tugs()[0].out);
    assert!(!session.simulation().vessels()[0].faults.engine_lost);
    // The recording of a server that was killed here continues.
    let mut again = replay(&saved(&mut session)).expect("the same bits").session;
    for session in [&mut session, &mut again] {
        go(session, 1);
        assert!(session.simulation().vessels()[0].faults.engine_lost, "in the step of its time");
        go(session, 30);
        assert!(!session.simulation().vessels()[0].faults.blackout, "it was cancelled");
        assert_eq!(states(session), [(3, "fired"), (1, "fired"), (2, "cancelled")]);
    }
    assert_eq!(session.bits(), again.bits());
    session.rewind(15).expect("it is there");
    assert_eq!(states(&session), [(3, "fired"), (1, "waits"), (2, "cancelled")]);
}

#[test]
fn what_cannot_be_planned_is_refused_with_a_reason() {
    let mut session = harbour();
    go(&mut session, 10);
    let note = OtherAction::Note { text: "x".into() };
    let nested = OtherAction::Plan { at_s: 5.0, event: Box::new(fault(Fault::Blackout)) };
    let nobody = OtherAction::Fault { vessel: "nobody".into(), fault: Fault::Blackout, on: true };
    for (action, why) in [
        (plan(5.0, note), "only changes of the weather and faults"),
        (plan(5.0, nested), "only changes of the weather and faults"),
        (plan(0.5, fault(Fault::Blackout)), "from now"),
        (plan(f64::NAN, fault(Fault::Blackout)), "from now"),
        (plan(1e6, fault(Fault::Blackout)), "from now"),
        (plan(5.0, nobody), "no vessel `nobody`"),
        (OtherAction::CancelPlanned { id: 1 }.into(), "has happened, or was cancelled"),
        (OtherAction::PartLine { line: "no_line".into() }.into(), "no line `no_line`"),
        (OtherAction::TugOut { tug: "ship".into(), on: true }.into(), "no vector tug"),
        (wind(5.0, 0.0, -1.0), "time of the change"),
    ] {
        let reason = session.command("test", 0, action).expect_err(why).to_string();
        assert!(reason.contains(why), "{reason}");
    }
    assert!(session.planned().is_empty());
    for _ in 0..100 {
        command(&mut session, plan(500.0, fault(Fault::Blackout)));
    }
    let reason = session.command("test", 0, plan(500.0, fault(Fault::Blackout)));
    assert!(reason.expect_err("too many").to_string().contains("at most 100"));
}

#[test]
fn a_rudder_that_does_not_follow_runs_to_its_stop_on_the_side_of_the_order() {
    let mut session = harbour();
    let rudder_now = |session: &Session| session.simulation().vessels()[0].rudder.value;
    command(&mut session, rudder(-0.1));
    command(&mut session, fault(Fault::FollowUpLost).into());
    go(&mut session, 400);
    let stop_rad = session.info().vessels[0].rudder_stop_rad.expect("a rudder");
    assert!((rudder_now(&session) + stop_rad).abs() < 1e-9, "{}", rudder_now(&session));
    command(&mut session, rudder(0.0));
    go(&mut session, 100);
    assert!((rudder_now(&session) + stop_rad).abs() < 1e-9, "it stays there");
    command(&mut session, rudder(0.05));
    go(&mut session, 800);
    assert!((rudder_now(&session) - stop_rad).abs() < 1e-9);
}

#[test]
fn a_line_parts_and_a_tug_drops_out_by_name() {
    let mut session = harbour();
    command(&mut session, engine(0.0));
    go(&mut session, 20);
    command(&mut session, OtherAction::PartLine { line: "head".into() }.into());
    go(&mut session, 1);
    let head = session.info().lines.iter().position(|line| line.name == "head").expect("a line");
    assert!(session.simulation().lines()[head].has_parted());
    assert!(session.alarms().messages().iter().any(|alarm| alarm.text == "Line head has parted"));
    let again = session.command("test", 0, OtherAction::PartLine { line: "head".into() }.into());
    assert!(again.expect_err("it has parted").to_string().contains("is not fast"));
    let push = support::order(fenderline_sim::OrderName::Push, "aft").number("force", 3e5);
    command(&mut session, push.into());
    go(&mut session, 600);
    let aft = session.info().tugs.iter().position(|tug| tug.name == "aft").expect("a tug");
    assert!(session.simulation().tugs()[aft].state.force_n > 1e5);
    command(&mut session, OtherAction::TugOut { tug: "aft".into(), on: true }.into());
    go(&mut session, 600);
    assert!(session.simulation().tugs()[aft].state.force_n < 1e3);
    assert!(session.alarms().messages().iter().any(|alarm| alarm.text.contains("dropped out")));
}

#[test]
fn a_predicted_path_does_not_know_what_the_instructor_prepares() {
    let plain = harbour();
    let mut prepared = plain.clone();
    command(&mut prepared, wind(30.0, 3.0, 60.0));
    let current = OtherAction::Current { speed_mps: 1.0, to_rad: 0.7, over_s: 60.0 };
    command(&mut prepared, current.into());
    command(&mut prepared, plan(5.0, fault(Fault::Blackout)));
    let path = |session: &Session| session.prediction().expect("a ship").run(60.0, 5.0, |_| true);
    assert_eq!(path(&prepared), path(&plain));
}
