//! Trial manoeuvres show what the run would do, and do not change the run.

use crate::support;

use fenderline_live::message::{Reply, ShipPath};
use fenderline_live::{Action, OtherAction, Session};
use fenderline_sim::OrderName;
use fenderline_sim::order::{Lead, SidePlace, TugWord, TugWords};
use support::{command, engine, go, harbour, open, order, rudder, saved};

fn push(tug: &str, power: f64) -> Action {
    let (lead, place) = (Lead::default(), SidePlace::default());
    Action::tug(tug, TugWords { word: TugWord::Push, power, lead, place })
}

/// A trial that runs to its end: the paths and the findings.
fn tried(session: &Session, orders: &[Action], horizon_s: f64) -> (Vec<ShipPath>, Vec<String>) {
    let trial = session.trial(orders, horizon_s).expect("good orders");
    match trial.run(7, |_| true) {
        Reply::Trial { id: 7, complete: true, paths, findings, .. } => (paths, findings),
        other => panic!("{other:?}"),
    }
}

#[test]
fn trials_leave_the_bits_and_the_recording_of_the_run_untouched() {
    let mut with = open("scenarios/live/berthing.toml", &[]);
    let mut without = with.clone();
    for round in 0..6 {
        let orders = [engine(-0.5), rudder(0.1 * f64::from(round)), push("forward_tug", 0.5)];
        let _ = tried(&with, &orders, 20.0);
        assert!(with.trial(&[engine(9.0)], 20.0).is_err());
        for session in [&mut with, &mut without] {
            command(session, rudder(0.02 * f64::from(round)));
            go(session, 20);
        }
        assert_eq!(with.bits(), without.bits());
        assert_eq!(with.take_events(), without.take_events());
        assert_eq!(with.alarms(), without.alarms());
    }
    assert_eq!(saved(&mut with), saved(&mut without));
}

#[test]
fn a_trial_is_the_path_that_the_same_orders_then_give() {
    let mut session = harbour();
    go(&mut session, 30);
    let orders = [engine(0.4), rudder(0.3), push("forward", 0.8)];
    let (paths, _) = tried(&session, &orders, 60.0);
    assert_eq!((paths.len(), paths[0].vessel, paths[0].path.len()), (1, 0, 61));
    let tick = session.tick();
    assert_eq!(session.command_all("test", 0, orders.to_vec()), Ok(tick), "at one tick");
    for [t_s, north_m, east_m, heading_rad] in &paths[0].path {
        let state = session.simulation().states()[0];
        assert_eq!(*t_s, session.simulation().time_s());
        let now = [state.position_m.x, state.position_m.y, state.heading_rad];
        assert_eq!([*north_m, *east_m, *heading_rad], now);
        go(&mut session, 10);
    }
}

#[test]
fn a_trial_refuses_what_a_real_order_refuses_and_in_its_words() {
    let mut session = harbour();
    go(&mut session, 5);
    let mut other = session.clone();
    let of_nobody = order(OrderName::Hands, "nobody");
    for action in [engine(7.0), of_nobody.into(), order(OrderName::LetGo, "no_line").into()] {
        let tried = session.trial(std::slice::from_ref(&action), 60.0).expect_err("a bad order");
        let given = session.command("test", 0, action.clone()).expect_err("a bad order");
        assert_eq!(tried, given);
        let second = session.command_all("test", 0, vec![rudder(0.1), action]).expect_err("bad");
        assert_eq!(second.to_string(), format!("order 2: {given}"));
    }
    let wind = OtherAction::Wind { speed_mps: 5.0, from_rad: 0.0, over_s: 0.0 };
    let many = vec![rudder(0.1); 17];
    for (orders, horizon_s, why) in [
        (vec![wind.into()], 60.0, "ships, tugs and lines only"),
        (vec![], 60.0, "1 to 16 orders"),
        (many, 60.0, "1 to 16 orders"),
        (vec![rudder(0.1)], 1e9, "s ahead"),
        (vec![rudder(0.1)], f64::NAN, "s ahead"),
    ] {
        let reason = session.trial(&orders, horizon_s).expect_err(why).to_string();
        assert!(reason.contains(why), "{reason}");
    }
    // None of the refused orders was given.
    go(&mut session, 20);
    go(&mut other, 20);
    assert_eq!(session.bits(), other.bits());
    assert_eq!(saved(&mut session), saved(&mut other));
}

#[test]
fn a_rewound_run_can_be_tried_and_not_ordered() {
    let mut session = harbour();
    go(&mut session, 100);
    session.rewind(50).expect("it is there");
    let (paths, _) = tried(&session, &[engine(0.5)], 30.0);
    assert_eq!(paths[0].path[0][0], 5.0);
    let refused = session.command_all("test", 0, vec![engine(0.5)]).expect_err("it is the past");
    assert!(refused.to_string().contains("rewound"), "{refused}");
}

#[test]
fn a_trial_says_what_would_be_struck() {
    let mut session = open("scenarios/live/berthing.toml", &[]);
    go(&mut session, 10);
    // Full ahead past the end of the quay, with the rudder towards the quay.
    let (_, findings) = tried(&session, &[engine(1.0), rudder(0.1)], 300.0);
    assert!(findings.iter().any(|text| text.contains("quay")), "{findings:?}");
    let (_, findings) = tried(&session, &[engine(0.0)], 20.0);
    assert!(findings.is_empty(), "{findings:?}");
}
