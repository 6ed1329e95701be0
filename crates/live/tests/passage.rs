//! A ship passes a moored ship. The moored ship surges, lines part when they should, and the messages say why.

use crate::support;

use fenderline_live::message::{Role, RunState};
use fenderline_live::{NamedOrder, Session};
use fenderline_sim::OrderName;
use support::{command, go, open};

const MOORED: &str = "scenarios/live/moored_while_a_ship_passes.toml";
/// Time in the scenario at which the passing ship is abreast (s).
const ABREAST_S: f64 = 480.0;

fn until(session: &mut Session, t_s: f64) {
    while session.simulation().time_s() < t_s - 1e-6 {
        go(session, 1);
    }
}

fn caution(session: &Session) -> Option<String> {
    let alarms = session.alarms().messages().into_iter();
    alarms.filter(|alarm| alarm.key == "passing ship kcs").map(|alarm| alarm.text).next()
}

fn parted(session: &Session) -> Vec<String> {
    let lines = session.simulation().lines().iter().zip(&session.info().lines);
    lines.filter(|(line, _)| line.has_parted()).map(|(_, info)| info.name.clone()).collect()
}

#[test]
fn a_ship_that_passes_too_fast_parts_the_aft_spring_and_everybody_reads_why() {
    let mut session = open(MOORED, &[]);
    until(&mut session, 170.0);
    assert_eq!(caution(&session), None, "she is announced five minutes before");
    until(&mut session, 300.0);
    assert_eq!(
        caution(&session).as_deref(),
        Some("Ship kcs will pass ship in 3 min, 56 m off at 12.0 kn")
    );
    assert!(session.frame(0, RunState::default()).passages.is_empty());

    // The ship is abreast. The gap is drawn between the sides. The force across is at its largest, and the force along
    // is near zero.
    until(&mut session, ABREAST_S);
    let [passage] = session.frame(0, RunState::default()).passages[..] else { panic!("one") };
    let [from, to] = passage.between_m;
    let apart_m = libm::hypot(to[0] - from[0], to[1] - from[1]);
    assert!((apart_m - passage.gap_m).abs() < 1e-9 && (54.0..57.0).contains(&passage.gap_m));
    assert!(passage.force_n[1].abs() > 10.0 * passage.force_n[0].abs(), "{:?}", passage.force_n);
    let text = caution(&session).expect("a caution");
    assert!(text.starts_with("Ship kcs passes ship 55 m off at 12.0 kn and pushes her "), "{text}");

    // The aft spring parts after the passage. Both log and alarm give the reason.
    until(&mut session, 560.0);
    assert_eq!(parted(&session), ["aft_spring"]);
    let alarms = session.alarms().messages();
    let alarm = alarms.iter().find(|alarm| alarm.key == "line aft_spring").expect("an alarm");
    assert!(
        alarm
            .text
            .starts_with("Line aft_spring has parted at 1204 kN (breaking load 1200 kN), as kcs has passed 55 m off at 12.0 kn and pushed up to "),
        "{}",
        alarm.text
    );
    assert!(alarm.text.contains("12.0 kn and push"), "{}", alarm.text);
    let events = session.history(None, &Role::Instructor).expect("a past").events;
    let log: Vec<&str> = events.iter().map(|event| &*event.text).collect();
    let at = |begins: &str| {
        let found = log.iter().position(|text| text.starts_with(begins));
        found.unwrap_or_else(|| panic!("{begins}: {log:#?}"))
    };
    let announced = at("Caution: Ship kcs will pass ship in 5 min");
    let loaded = at("Caution: Line aft_spring: 80 % of its working load, as kcs passes");
    let over = at("ALARM: Line aft_spring: 100 % of its working load, as kcs passes");
    let broke = at("LINE aft_spring HAS PARTED at 1204 kN (breaking load 1200 kN), as kcs ");
    assert!(announced < loaded && loaded < over && over < broke, "{log:#?}");

    // The alarm keeps its reason. The text at the end of the passage has the largest forces.
    until(&mut session, 600.0);
    let later = session.alarms().messages();
    assert!(later.iter().any(|other| other.text == alarm.text), "{later:?}");
    let events = session.history(None, &Role::Instructor).expect("a past").events;
    let end =
        events.iter().find(|event| event.text.starts_with("ship kcs has passed ship, 55 m off"));
    assert!(end.is_some_and(|end| end.t_s > ABREAST_S), "{events:#?}");
    assert_eq!(caution(&session), None);
}

#[test]
fn with_both_spare_springs_ashore_no_line_parts() {
    let mut session = open(MOORED, &[]);
    for (line, bollard) in [("second_fore_spring", "b5"), ("second_aft_spring", "b4")] {
        let send = NamedOrder::new(OrderName::Send, line).name("bollard", bollard);
        command(&mut session, send.into());
    }
    until(&mut session, 240.0);
    for line in ["second_fore_spring", "second_aft_spring"] {
        command(&mut session, NamedOrder::new(OrderName::Heave, line).number("rate", 0.15).into());
    }
    until(&mut session, 300.0);
    for line in ["second_fore_spring", "second_aft_spring"] {
        command(&mut session, NamedOrder::new(OrderName::Hold, line).into());
    }
    until(&mut session, 640.0);
    assert_eq!(parted(&session), [""; 0]);
}

#[test]
fn fog_hides_the_gap_to_a_ship_that_the_pilot_does_not_see_and_a_slow_one_is_harmless() {
    let mut session =
        open(MOORED, &["passing.kcs.speed=\"5 kn\"", "environment.visibility=\"100 m\""]);
    until(&mut session, ABREAST_S - 120.0);
    let all = session.frame(0, RunState::default());
    assert_eq!(all.passages.len(), 1);
    let seen = session.in_fog(&all, &Role::PILOT).expect("fog hides her");
    assert!(seen.passages.is_empty() && seen.traffic == [None]);
    until(&mut session, ABREAST_S + 150.0);
    assert_eq!(parted(&session), [""; 0]);
    let alarms = session.alarms().messages();
    assert!(alarms.iter().all(|alarm| alarm.level == "caution"), "{alarms:?}");
}
