//! Fog: what it hides from whom. The visibility is a part of the session.

use crate::support;

use fenderline_live::message::{Frame, Role, RunState};
use fenderline_live::{OtherAction, Session};

fn set(session: &mut Session, distance_m: Option<f64>) {
    support::command(session, OtherAction::Visibility { distance_m, over_s: 0.0 }.into());
}

fn frame(session: &Session) -> Frame {
    session.frame(0, RunState::default())
}

/// The names of the bodies that a role does not see.
fn hidden(session: &Session, role: &Role) -> Vec<String> {
    let all = frame(session);
    let Some(seen) = session.in_fog(&all, role) else { return Vec::new() };
    let names = session.simulation().setup().bodies.iter().map(|body| body.name.clone());
    names.zip(&seen.bodies).filter(|(_, state)| state.is_none()).map(|(name, _)| name).collect()
}

#[test]
fn fog_hides_ships_beyond_it_from_pilot_and_tugmasters_but_not_from_the_instructor() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    let master = |tug: &str| Role::Tugmaster { tug: tug.to_owned() };
    assert_eq!(hidden(&session, &Role::PILOT), [""; 0], "it is clear at first");
    // The tugs are about 66 m from the ship's centre, and the ship's side is about 35 m from the tugs.
    set(&mut session, Some(50.0));
    assert_eq!(hidden(&session, &Role::PILOT), ["forward_tug", "after_tug"]);
    assert_eq!(hidden(&session, &Role::Observer), ["forward_tug", "after_tug"]);
    assert_eq!(hidden(&session, &master("forward_tug")), ["after_tug"]);
    assert_eq!(hidden(&session, &Role::Instructor), [""; 0]);
    let all = frame(&session);
    let seen = session.in_fog(&all, &Role::PILOT).expect("something is hidden");
    // The own ship, the quay and the instruments stay visible.
    assert_eq!((&seen.bodies[0], &seen.fenders), (&all.bodies[0], &all.fenders));
    assert_eq!(seen.vessels[0], all.vessels[0]);
    assert_eq!(seen.vessels[2].berth, None);
    for clear in [Some(100.0), None] {
        set(&mut session, clear);
        assert_eq!(hidden(&session, &Role::PILOT), [""; 0]);
    }
}

#[test]
fn the_visibility_of_the_scenario_holds_until_it_is_set_and_rewinds_with_the_run() {
    let mut session =
        support::open("scenarios/live/berthing.toml", &["environment.visibility=\"200 m\""]);
    assert_eq!(frame(&session).visibility_m, Some(200.0));
    let bits = session.bits();
    support::go(&mut session, 10);
    set(&mut session, None);
    support::go(&mut session, 10);
    assert_eq!(frame(&session).visibility_m, None);
    session.rewind(5).expect("it is recorded");
    assert_eq!(frame(&session).visibility_m, Some(200.0));
    session.rewind(0).expect("it is recorded");
    assert_eq!(session.bits(), bits, "fog changes nothing in the simulated world");
    session.rewind(20).expect("it is recorded");
    assert_eq!(frame(&session).visibility_m, None);
}

#[test]
fn a_visibility_beyond_its_limits_is_refused() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    for distance_m in [49.0, 50_001.0, -1.0, f64::NAN] {
        let action = OtherAction::Visibility { distance_m: Some(distance_m), over_s: 0.0 };
        let refused = session.command("instructor", 0, action.into()).expect_err("a limit");
        assert!(refused.to_string().contains("visibility [m]"), "{refused}");
    }
    assert_eq!(frame(&session).visibility_m, None);
}
