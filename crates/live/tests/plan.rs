//! Passage plans in a session: where a ship is on her plan, and the alarm outside the corridor.

use crate::support;

use fenderline_live::message::{Frame, PlanNow, Role, RunState};
use fenderline_live::{Fault, OtherAction, Session};

fn seen(session: &Session, role: &Role) -> Frame {
    let all = session.frame(0, RunState::default());
    session.in_fog(&all, role).unwrap_or(all)
}

/// The alarms about bridges and cables.
fn overhead(session: &Session) -> Vec<String> {
    let alarms = session.frame(0, RunState::default()).alarms.into_iter();
    alarms.filter(|alarm| alarm.key == "overhead ship").map(|alarm| alarm.text).collect()
}

#[test]
fn a_bridge_that_is_too_low_raises_an_alarm_ahead_of_the_ship_and_under_it() {
    let mut session = support::under_bridge();
    support::go(&mut session, 1);
    let ahead = overhead(&session);
    assert_eq!(ahead.len(), 1);
    let says = "ship: the bridge \"High Bridge\" ahead in ";
    assert!(ahead[0].starts_with(says) && ahead[0].ends_with(" s is 1.0 m too low"), "{ahead:?}");
    let mut steps = 0;
    while overhead(&session) != ["ship: 1.0 m too high for the bridge \"High Bridge\""]
        && steps < 3000
    {
        support::go(&mut session, 10);
        steps += 10;
    }
    // 350 m at 3 m/s, less half a ship.
    assert!((700..1500).contains(&steps), "{steps}");
    while !overhead(&session).is_empty() && steps < 3000 {
        support::go(&mut session, 10);
        steps += 10;
    }
    assert!(steps < 2500, "the alarm ends behind the bridge: {steps}");
}

fn plan(session: &Session, role: &Role) -> PlanNow {
    seen(session, role).vessels[0].plan.expect("a plan")
}

fn off_track(session: &Session) -> Vec<String> {
    let frame = session.frame(0, RunState::default());
    let all = frame.alarms.into_iter().filter(|alarm| alarm.key == "off track ship");
    all.map(|alarm| alarm.text).collect()
}

#[test]
fn a_ship_that_leaves_the_corridor_raises_an_alarm_that_says_how_far_and_to_which_side() {
    let mut session = support::planned();
    support::go(&mut session, 1);
    let start = plan(&session, &Role::PILOT);
    assert!(start.cross_track_m.abs() < 1.0 && start.leg == 0, "{start:?}");
    assert_eq!(off_track(&session), [""; 0]);
    support::command(&mut session, support::rudder(0.6));
    let mut steps = 0;
    while off_track(&session).is_empty() && steps < 6000 {
        support::go(&mut session, 10);
        steps += 10;
    }
    let now = plan(&session, &Role::PILOT);
    assert!(now.cross_track_m > 20.0 && now.cross_track_m < 25.0, "{now:?}");
    let text = off_track(&session).join("; ");
    assert!(text.contains("m to starboard of her track (planned 20 m)"), "{text}");
    assert!(now.to_waypoint_m < start.to_waypoint_m);
}

/// Her receiver keeps the old position: so does the plan on her bridge, and no alarm tells her pilot.
#[test]
fn a_frozen_position_keeps_the_cross_track_distance_of_her_pilot() {
    let mut session = support::planned();
    support::go(&mut session, 1);
    let fault = Fault::PositionFrozen;
    let action = OtherAction::Fault { vessel: "ship".into(), fault, on: true };
    support::command(&mut session, action.into());
    support::go(&mut session, 1);
    let before = plan(&session, &Role::PILOT);
    support::command(&mut session, support::rudder(0.6));
    support::go(&mut session, 1500);
    assert_eq!(plan(&session, &Role::PILOT), before);
    assert!(plan(&session, &Role::Instructor).cross_track_m > 20.0);
    assert_eq!(off_track(&session), [""; 0]);
}
