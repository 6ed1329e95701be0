//! Pages make rows and elements of some lists. The entries of these lists have unique keys. Refused orders cost a small
//! part of a tick.

use crate::support;

use std::collections::BTreeSet;
use std::time::Instant;

use fenderline_live::message::RunState;
use fenderline_live::{Action, Fault, NamedOrder, OtherAction, Session};
use fenderline_sim::OrderName;
use support::{command, engine, go, open};

/// Fails if a key occurs twice.
fn unique(what: &str, keys: impl IntoIterator<Item = String>) -> usize {
    let mut all = BTreeSet::new();
    for key in keys {
        assert!(all.insert(key.clone()), "{what}: `{key}` twice");
    }
    all.len()
}

/// Checks the keys of all rows of a frame.
fn check(session: &Session) -> usize {
    let frame = session.frame(0, RunState::default());
    unique("finding", frame.verdict.findings.iter().map(|f| format!("{} {}", f.key, f.text)));
    unique("branch", frame.run.branches.iter().map(|branch| branch.id.to_string()));
    unique("planned", session.planned().iter().map(|planned| planned.id.to_string()));
    unique("alarm", frame.alarms.iter().map(|alarm| alarm.key.clone()))
}

#[test]
fn alarms_findings_and_names_have_keys_of_their_own() {
    // The ship goes ahead along the quay's fenders and onto the concrete, with every possible fault.
    let set = [
        "body.ship.position=[-10, -16.5]",
        "body.ship.heading=\"6 deg\"",
        "body.ship.velocity={ surge = \"2 kn\", sway = \"1 m/s\" }",
        "body.forward_tug.position=[60, -75]",
        "body.after_tug.position=[-70, -75]",
    ];
    let mut session = open("scenarios/live/berthing.toml", &set);
    let info = session.info();
    unique("line", info.lines.iter().map(|line| line.name.clone()));
    unique("bollard", info.bollards.iter().map(|bollard| bollard.name.clone()));
    unique("fender", info.fenders.iter().map(|fender| fender.name.clone()));
    unique("body", info.bodies.iter().map(|body| body.name.clone()));
    unique("order", info.orders.iter().map(|order| order.name.to_owned()));
    unique("control", session.cast().controls().iter().map(|control| format!("{control:?}")));
    for vessel in session.cast().vessels.clone() {
        for fault in [Fault::RudderStuck, Fault::EngineLost, Fault::ThrustersLost, Fault::Blackout]
        {
            let fault = OtherAction::Fault { vessel: vessel.clone(), fault, on: true };
            // A tug without a rudder does not have this fault.
            let _ = session.command("test", 0, fault.into());
        }
    }
    for line in ["forward_tow", "after_tow"] {
        go(&mut session, 2);
        command(&mut session, OtherAction::PartLine { line: line.into() }.into());
    }
    for at_s in [5.0, 5.0, 9.0] {
        let event = OtherAction::Visibility { distance_m: Some(500.0), over_s: 0.0 };
        command(&mut session, OtherAction::Plan { at_s, event: Box::new(event) }.into());
    }
    let mut most = 0;
    for _ in 0..300 {
        go(&mut session, 1);
        most = check(&session).max(most);
    }
    // There are faults of three vessels, two lines, fenders and a touch, so that there is something to compare.
    assert!(most >= 12, "{most} alarms at once");
}

#[test]
fn ten_thousand_orders_to_lines_that_cannot_be_change_nothing_and_cost_little() {
    let order = |name, line: &str| NamedOrder::new(name, line);
    let wrong: [Action; 6] = [
        order(OrderName::Heave, "head").number("rate", 0.1).into(),
        order(OrderName::LetGo, "stern").into(),
        order(OrderName::Hold, "none").into(),
        order(OrderName::Send, "head").name("bollard", "b99").into(),
        order(OrderName::Send, "forward_tow").name("bollard", "b3").into(),
        order(OrderName::PayOut, "stern").number("rate", -1.0).into(),
    ];
    let mut session = open("scenarios/live/berthing.toml", &[]);
    let mut left_alone = session.clone();
    for session in [&mut session, &mut left_alone] {
        command(session, engine(0.2));
        go(session, 5);
    }
    let begun = Instant::now();
    for number in 0..10_000 {
        let refused = session.command("test", 0, wrong[number % wrong.len()].clone());
        assert!(!refused.expect_err("it cannot be").to_string().is_empty());
    }
    let each_ms = begun.elapsed().as_secs_f64() * 1e3 / 1e4;
    println!("{:.1} us for each order that is refused", each_ms * 1e3);
    // The limit is a hundredth of a tick of 100 ms. On a machine without other work an order takes a thousandth of this
    // limit.
    assert!(each_ms < 1.0, "{each_ms} ms");
    for session in [&mut session, &mut left_alone] {
        go(session, 50);
    }
    assert_eq!(session.bits(), left_alone.bits());
    assert_eq!(session.take_lines(), left_alone.take_lines(), "nothing of it is recorded");
}
