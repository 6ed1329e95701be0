//! Anchors of a live session: orders, faults, alarms, the forecastle's report, replay.

use crate::support;

use fenderline_live::message::{AnchorNow, RunState};
use fenderline_live::{Action, AnchorFault, OtherAction, Session};
use fenderline_sim::OrderName;
use support::{command, go};

/// The coaster from the example of a dredged anchor. She has sternway and no orders.
fn roads() -> Session {
    support::open(
        "scenarios/environment/dredged_anchor.toml",
        &["order=[]", "time.duration=\"3 h\"", "body.ship.velocity.surge=\"-0.3 kn\""],
    )
}

fn chain(order: OrderName, chain_m: f64) -> Action {
    support::order(order, "weather").number("chain", chain_m).into()
}

fn now(session: &Session) -> AnchorNow {
    session.frame(0, RunState::default()).anchors[0].clone()
}

fn refused(session: &mut Session, action: Action) -> String {
    session.command("test", 0, action).expect_err("it is refused").to_string()
}

fn alarms(session: &Session) -> Vec<String> {
    session.alarms().messages().into_iter().map(|alarm| alarm.text).collect()
}

#[test]
fn an_anchor_is_let_go_reported_veered_and_slipped_and_the_recording_replays() {
    let mut session = roads();
    assert_eq!(session.info().anchors[0].name, "weather");
    assert_eq!(now(&session).report, "home");
    let text = refused(&mut session, chain(OrderName::HeaveIn, 0.0));
    assert_eq!(text, "anchor `weather` is home in its hawse pipe");
    let text = refused(&mut session, chain(OrderName::LetGoAnchor, 400.0));
    assert!(text.contains("247.5 m long (9.0 shackles)"), "{text}");
    command(&mut session, chain(OrderName::LetGoAnchor, 55.0));
    go(&mut session, 5);
    assert_eq!((now(&session).windlass, now(&session).to_m), ("let_go", Some(55.0)));
    go(&mut session, 300);
    let here = now(&session);
    assert_eq!((here.state, here.windlass, here.chain_m), ("on_bottom", "hold", 55.0));
    assert!(here.report.starts_with("2 shackles out, "), "{}", here.report);
    assert!(here.place_m.is_some() && here.holding_n > 1e5);
    let text = refused(&mut session, chain(OrderName::LetGoAnchor, 82.5));
    assert_eq!(text, "anchor `weather` is already on the bottom: veer chain instead");
    command(&mut session, chain(OrderName::Veer, 82.5));
    go(&mut session, 1000);
    assert_eq!(now(&session).chain_m, 82.5);
    command(&mut session, support::order(OrderName::Slip, "weather").into());
    go(&mut session, 5);
    assert_eq!((now(&session).state, now(&session).report.as_str()), ("lost", "gone: slipped"));
    let text = refused(&mut session, chain(OrderName::HeaveIn, 0.0));
    assert_eq!(text, "anchor `weather` is lost: its chain was slipped");
    // An anchor that was slipped by order raises no alarm.
    assert!(alarms(&session).iter().all(|text| !text.contains("nchor")), "{:?}", alarms(&session));
    let text = support::saved(&mut session);
    support::replay(&text).expect("the same run again");
}

/// Two people give orders to one windlass within a tick. The second person gets the reason for the refusal. No event
/// later reports a refused order.
#[test]
fn the_second_of_two_orders_for_one_anchor_in_one_tick_is_not_acknowledged_and_dropped() {
    let mut session = roads();
    command(&mut session, chain(OrderName::LetGoAnchor, 55.0));
    go(&mut session, 100);
    command(&mut session, support::order(OrderName::Slip, "weather").into());
    let text = refused(&mut session, chain(OrderName::HeaveIn, 0.0));
    assert_eq!(text, "anchor `weather` is lost: its chain was slipped");
    session.take_events();
    go(&mut session, 1);
    let events = session.take_events();
    assert!(events.iter().all(|(_, text)| !text.contains("could not")), "{events:?}");
}

#[test]
fn faults_of_windlass_and_anchor_and_the_alarm_that_it_drags() {
    let mut session = roads();
    let fault = |fault, on| OtherAction::AnchorFault { anchor: "weather".into(), fault, on };
    assert!(fault(AnchorFault::DoesNotBite, true).can_be_planned());
    command(&mut session, chain(OrderName::LetGoAnchor, 55.0));
    command(&mut session, fault(AnchorFault::WindlassFailed, true).into());
    go(&mut session, 100);
    assert_eq!(now(&session).faults, [AnchorFault::WindlassFailed]);
    let text = refused(&mut session, chain(OrderName::HeaveIn, 0.0));
    assert!(text.contains("has no power"), "{text}");
    assert!(alarms(&session).contains(&"Anchor weather: the windlass has no power".to_owned()));
    command(&mut session, fault(AnchorFault::WindlassFailed, false).into());
    command(&mut session, fault(AnchorFault::DoesNotBite, true).into());
    // A gale on the beam takes the ship and her anchor along.
    command(
        &mut session,
        OtherAction::Wind { speed_mps: 30.0, from_rad: 1.57, over_s: 0.0 }.into(),
    );
    let mut drags = false;
    for _ in 0..60 {
        go(&mut session, 50);
        drags |= alarms(&session).contains(&"Anchor weather drags".to_owned());
    }
    assert!(drags, "{:?}", alarms(&session));
    assert!(now(&session).dragged_m > 5.0 && now(&session).report.contains("shackles out"));
    let unknown = OtherAction::AnchorFault {
        anchor: "none".into(),
        fault: AnchorFault::DoesNotBite,
        on: true,
    };
    assert_eq!(refused(&mut session, unknown.into()), "there is no anchor `none`");
}
