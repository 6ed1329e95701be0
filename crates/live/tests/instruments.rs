//! Frozen instruments. The ship's pilot reads the old values and sees the true motion out of the window, the instructor
//! sees the true values, and nobody else is told. Also: a single thruster trips.

use crate::support;

use fenderline_live::message::{Frame, Role, RunState};
use fenderline_live::{Fault, OtherAction, Session};

fn seen(session: &Session, role: &Role) -> Frame {
    let all = session.frame(0, RunState::default());
    session.in_fog(&all, role).unwrap_or(all)
}

fn fault(session: &mut Session, fault: Fault, on: bool) {
    let action = OtherAction::Fault { vessel: "ship".into(), fault, on };
    support::command(session, action.into());
}

#[test]
fn each_frozen_instrument_stays_for_her_pilot_alone() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    support::command(&mut session, support::engine(0.5));
    support::command(&mut session, support::rudder(0.5));
    support::go(&mut session, 300);
    let master = Role::Tugmaster { tug: "forward_tug".into() };
    let ship =
        |session: &Session, role: &Role| seen(session, role).bodies[0].expect("she is there");
    for (of, kept) in [
        (Fault::HeadingFrozen, &[2][..]),
        (Fault::SpeedFrozen, &[3, 4][..]),
        (Fault::PositionFrozen, &[0, 1][..]),
    ] {
        let before = ship(&session, &Role::PILOT);
        let speeds = seen(&session, &Role::PILOT).vessels[0].ground_mps;
        fault(&mut session, of, true);
        support::go(&mut session, 200);
        let truth = ship(&session, &Role::Instructor);
        let shown = ship(&session, &Role::PILOT);
        for index in 0..5 {
            let expected = if kept.contains(&index) { before[index] } else { truth[index] };
            assert_eq!(shown[index], expected, "{of:?}: {index}");
            assert_ne!(truth[index], before[index], "{of:?}: she moves");
        }
        for other in [&master, &Role::Observer] {
            assert_eq!(ship(&session, other), truth, "{of:?}");
            assert_eq!(seen(&session, other).vessels[0].faults, [""; 0]);
        }
        let frame = seen(&session, &Role::PILOT);
        assert_eq!(frame.vessels[0].ground_mps == speeds, of == Fault::SpeedFrozen, "{of:?}");
        assert!(frame.vessels[0].faults.is_empty());
        assert!(!frame.alarms.iter().any(|alarm| alarm.text.contains("frozen")));
        assert_eq!(seen(&session, &Role::Instructor).vessels[0].faults.len(), 1);
        // The ship's predicted path would show where she is.
        assert_eq!(session.hidden_vessels(&Role::PILOT), [0]);
        assert!(session.hidden_vessels(&master).is_empty());
        fault(&mut session, of, false);
        assert_eq!(ship(&session, &Role::PILOT), ship(&session, &Role::Instructor));
    }
}

/// The view out of the window stood still with the frozen compass: the pilot could not find the fault by looking.
#[test]
fn out_of_the_window_her_pilot_alone_sees_how_she_moves_while_an_instrument_is_frozen() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    support::command(&mut session, support::engine(0.5));
    support::command(&mut session, support::rudder(0.5));
    support::go(&mut session, 300);
    let pilot = |session: &Session| seen(session, &Role::PILOT);
    assert_eq!(pilot(&session).eyes, None, "no instrument is frozen");
    for of in [Fault::HeadingFrozen, Fault::SpeedFrozen, Fault::PositionFrozen] {
        fault(&mut session, of, true);
        let before = pilot(&session);
        support::go(&mut session, 100);
        let (truth, shown) = (seen(&session, &Role::Instructor), pilot(&session));
        let eyes = shown.eyes.expect("an instrument is frozen");
        assert_eq!((eyes.body, Some(eyes.now)), (0, truth.bodies[0]), "{of:?}");
        assert_eq!(eyes.water_mps, truth.vessels[0].water_mps, "{of:?}");
        assert_ne!(shown.bodies[0], truth.bodies[0], "{of:?}: the instruments show old values");
        assert_ne!(before.eyes, shown.eyes, "{of:?}: she moves");
        assert_eq!(truth.eyes, None);
        for tug in ["forward_tug", "after_tug"] {
            let master = Role::Tugmaster { tug: tug.into() };
            assert_eq!(seen(&session, &master).eyes, None, "{of:?}: {tug}");
        }
        assert_eq!(seen(&session, &Role::Observer).eyes, None, "{of:?}");
        fault(&mut session, of, false);
        assert_eq!(pilot(&session).eyes, None, "{of:?}");
    }
}

#[test]
fn the_master_of_a_tug_with_frozen_instruments_sees_her_own_true_motion() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    let master = Role::Tugmaster { tug: "forward_tug".into() };
    let action =
        OtherAction::Fault { vessel: "forward_tug".into(), fault: Fault::PositionFrozen, on: true };
    support::command(&mut session, action.into());
    support::go(&mut session, 100);
    let (truth, shown) = (seen(&session, &Role::Instructor), seen(&session, &master));
    let eyes = shown.eyes.expect("her receiver is frozen");
    assert_eq!(Some(eyes.now), truth.bodies[eyes.body]);
    assert_ne!(shown.bodies[eyes.body], truth.bodies[eyes.body]);
    assert_eq!(seen(&session, &Role::PILOT).eyes, None, "the ship's own instruments are well");
}

/// Bow speed, speed ahead and rate of turn in the ship's charts, at the times of the past that a role gets.
fn charts(session: &Session, role: &Role) -> Vec<[f64; 4]> {
    let past = session.history(None, role).expect("it is kept");
    let bow_mps = past.bow_mps.iter().map(|speed| speed.expect("she has a bow"));
    let all = past.t_s.iter().zip(bow_mps).zip(past.ahead_mps.iter().zip(&past.turn_radps));
    all.map(|((t_s, bow_mps), (ahead_mps, turn))| [*t_s, bow_mps, *ahead_mps, *turn]).collect()
}

/// The values that the ship's page would have drawn while the session went on, once a second, as the past contains
/// them.
fn drawn(session: &mut Session, seconds: usize, role: &Role) -> Vec<[f64; 4]> {
    let rounded = |value: f64, digits: f64| (value * digits).round() / digits;
    let second = |session: &mut Session| {
        support::go(session, 10);
        let frame = seen(session, role);
        let (own, body) = (&frame.vessels[0], frame.bodies[0].expect("she is there"));
        let bow_mps = own.berth.as_ref().map_or(own.bow_mps, |berth| berth.bow_mps);
        [
            rounded(frame.t_s, 1e4),
            rounded(bow_mps, 1e4),
            rounded(own.ground_mps[0], 1e4),
            rounded(body[5], 1e6),
        ]
    };
    (0..seconds).map(|_| second(session)).collect()
}

/// After a reload the charts showed the true speeds, which no instrument had shown.
#[test]
fn the_charts_of_the_past_show_what_frozen_instruments_showed() {
    for scenario in ["scenarios/live/berthing.toml", "scenarios/live/come_to_anchor.toml"] {
        let mut session = support::open(scenario, &[]);
        let mut page = drawn(&mut session, 20, &Role::PILOT);
        support::command(&mut session, support::engine(0.9));
        support::command(&mut session, support::rudder(0.5));
        for of in [Fault::SpeedFrozen, Fault::HeadingFrozen] {
            fault(&mut session, of, true);
        }
        page.extend(drawn(&mut session, 30, &Role::PILOT));
        fault(&mut session, Fault::SpeedFrozen, false);
        page.extend(drawn(&mut session, 20, &Role::PILOT));
        fault(&mut session, Fault::HeadingFrozen, false);
        page.extend(drawn(&mut session, 20, &Role::PILOT));
        assert_eq!(charts(&session, &Role::PILOT), page, "{scenario}");
        let truth = charts(&session, &Role::Instructor);
        assert_eq!(truth[..20], page[..20], "{scenario}");
        assert_ne!(truth[20..50], page[20..50], "{scenario}");
        assert!(page[21..50].iter().all(|[.., ahead, turn]| [*ahead, *turn] == [page[21][2], 0.0]));
        assert!(
            truth[60][3] != 0.0 && page[60][3] == 0.0,
            "{scenario}: the compass is still frozen"
        );
        assert_eq!(truth[60][2], page[60][2], "{scenario}: the log goes again");
        assert_eq!(truth[70..], page[70..], "{scenario}");
        for other in [Role::Observer, Role::Tugmaster { tug: "forward_tug".into() }] {
            assert_eq!(charts(&session, &other), truth, "{scenario}: {other:?}");
        }
        // The same in a branch, and when the frozen time is played again.
        session.rewind(450).expect("it is there");
        session.branch().expect("a branch");
        page.truncate(45);
        page.extend(drawn(&mut session, 10, &Role::PILOT));
        assert_eq!(charts(&session, &Role::PILOT), page, "{scenario}");
        assert!(page[44..].iter().all(|values| values[3] == 0.0));
    }
}

#[test]
fn frozen_values_are_those_of_the_shown_time_after_a_rewind() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    support::go(&mut session, 50);
    fault(&mut session, Fault::PositionFrozen, true);
    support::go(&mut session, 250);
    let shown = seen(&session, &Role::PILOT).bodies[0];
    session.rewind(20).expect("it is there");
    assert_eq!(seen(&session, &Role::PILOT), seen(&session, &Role::Instructor));
    session.rewind(300).expect("it is there");
    assert_eq!(seen(&session, &Role::PILOT).bodies[0], shown);
    let bits = session.bits();
    let mut other = support::open("scenarios/live/berthing.toml", &[]);
    support::go(&mut other, 300);
    assert_eq!(other.bits(), bits, "the ship goes on as without the fault");
}

#[test]
fn one_thruster_trips_by_its_name_now_or_planned_and_comes_back() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    let tug = "forward_tug".to_owned();
    let names: Vec<String> =
        session.info().vessels[1].azimuths.iter().map(|unit| unit.name.clone()).collect();
    let out = |thruster: &str, on| OtherAction::ThrusterOut {
        vessel: tug.clone(),
        thruster: thruster.to_owned(),
        on,
    };
    let missing = session.command("test", 0, out("none", true).into()).expect_err("no such unit");
    assert!(missing.to_string().contains("no thruster `none`"), "{missing}");
    support::go(&mut session, 300);
    let event = Box::new(out(&names[1], true));
    support::command(&mut session, OtherAction::Plan { at_s: 40.0, event }.into());
    support::command(&mut session, out(&names[0], true).into());
    support::go(&mut session, 99);
    assert_eq!(seen(&session, &Role::PILOT).vessels[1].tripped, [names[0].clone()]);
    support::go(&mut session, 202);
    let frame = seen(&session, &Role::PILOT);
    assert_eq!(frame.vessels[1].tripped, names);
    assert!(frame.vessels[1].azimuths.iter().all(|unit| unit.power < 0.01), "{frame:?}");
    let texts: Vec<&str> = frame.alarms.iter().map(|alarm| alarm.text.as_str()).collect();
    assert!(
        texts.contains(&format!("forward_tug: thruster {} tripped", names[0]).as_str()),
        "{texts:?}"
    );
    support::command(&mut session, out(&names[0], false).into());
    support::command(&mut session, out(&names[1], false).into());
    support::go(&mut session, 10);
    assert!(seen(&session, &Role::PILOT).vessels[1].tripped.is_empty());
}

#[test]
fn fog_comes_over_a_time_by_equal_ratios_and_clears_again() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    let visibility = |distance_m, over_s| OtherAction::Visibility { distance_m, over_s };
    support::command(&mut session, visibility(Some(200.0), 60.0).into());
    support::go(&mut session, 300);
    // Clear air counts as 20 km. Half-way to 200 m the visibility is 2 km.
    let half_m = seen(&session, &Role::PILOT).visibility_m.expect("fog");
    assert!((half_m - 2000.0).abs() < 1e-6, "{half_m}");
    support::go(&mut session, 300);
    assert_eq!(seen(&session, &Role::PILOT).visibility_m, Some(200.0));
    support::command(&mut session, visibility(None, 10.0).into());
    support::go(&mut session, 100);
    assert_eq!(seen(&session, &Role::PILOT).visibility_m, None);
}
