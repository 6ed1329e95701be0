//! Acknowledgements and notes. They are recorded, they are kept over restart, rewinding and branches, and they have no
//! effect on the ship.

use crate::support;

use fenderline_live::message::Role;
use fenderline_live::{Action, Fault, OtherAction, Repeat, Session};
use support::{command, go, harbour, outline, replay, rudder, saved};

/// The key of the alarm of a stuck rudder.
const STUCK: &str = "rudder stuck ship";

fn fault(on: bool) -> Action {
    OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on }.into()
}

fn acknowledge() -> Action {
    OtherAction::Acknowledge { key: STUCK.into() }.into()
}

fn note(text: &str) -> Action {
    OtherAction::Note { text: text.into() }.into()
}

/// The states of the alarms of the stuck rudder: key, active, acknowledged.
fn alarms(session: &Session) -> Vec<(String, bool, bool)> {
    let all = session.alarms().messages().into_iter().filter(|alarm| alarm.key == STUCK);
    all.map(|alarm| (alarm.key, alarm.stands, alarm.acknowledged)).collect()
}

/// A rudder sticks. The alarm is acknowledged and the rudder is repaired. The rudder sticks again, and is repaired
/// before anybody acknowledges the second alarm.
fn session() -> Session {
    let mut session = harbour();
    session.command("pilot 1", 0, rudder(0.2)).expect("an order");
    go(&mut session, 20);
    session.command("instructor 2", 0, fault(true)).expect("a fault");
    go(&mut session, 10);
    session.command("pilot 1", 0, acknowledge()).expect("there is an alarm");
    session.command("instructor 2", 0, note("she has seen it")).expect("a note");
    go(&mut session, 10);
    session.command("instructor 2", 0, fault(false)).expect("repaired");
    go(&mut session, 10);
    session.command("instructor 2", 0, fault(true)).expect("a fault");
    go(&mut session, 10);
    session.command("instructor 2", 0, fault(false)).expect("repaired");
    go(&mut session, 10);
    session.command("instructor 2", 0, note("")).expect("a mark");
    session
}

#[test]
fn acknowledgements_and_notes_survive_a_restart_and_do_not_change_the_bits() {
    let mut session = session();
    let waits = vec![(STUCK.to_owned(), false, false)];
    assert_eq!(alarms(&session), waits);
    let text = saved(&mut session);
    let mut again = replay(&text).expect("the same bits").session;
    assert_eq!((again.bits(), alarms(&again)), (session.bits(), waits));
    // The next acknowledgement is a line after the lines that were read.
    let by = again.alarms().may_acknowledge(STUCK, &Role::PILOT).expect("it waits");
    assert!(by.contains("rudder stuck"), "{by}");
    command(&mut again, acknowledge());
    assert_eq!(alarms(&again), []);
    // The same session without a note or an acknowledgement has the same states.
    let mut plain = harbour();
    let steps = [
        (20, rudder(0.2)),
        (20, fault(true)),
        (10, fault(false)),
        (10, fault(true)),
        (10, fault(false)),
    ];
    for (ticks, action) in steps {
        command(&mut plain, action);
        go(&mut plain, ticks);
    }
    assert_eq!((plain.tick(), plain.bits()), (session.tick(), session.bits()));
}

#[test]
fn rewinding_and_branches_have_the_alarms_and_notes_of_their_time() {
    let mut session = session();
    session.rewind(35).expect("it is there");
    assert_eq!(alarms(&session), [(STUCK.to_owned(), true, true)]);
    assert!(session.command("instructor 2", 0, note("too late")).is_err());
    assert!(session.command("pilot 1", 0, acknowledge()).is_err());
    session.rewind(25).expect("it is there");
    assert_eq!(alarms(&session), [(STUCK.to_owned(), true, false)]);
    session.branch().expect("a branch");
    go(&mut session, 20);
    command(&mut session, note("nobody acknowledged it here"));
    assert_eq!(alarms(&session), [(STUCK.to_owned(), true, false)]);
    let notes = |branch| -> Vec<String> {
        let mut repeat = Repeat::of(session.clone(), branch).expect("a branch");
        while !repeat.is_done() {
            repeat.step(|_| ()).expect("a step");
        }
        repeat.log().notes.iter().map(|note| note.text.clone()).collect()
    };
    assert_eq!(notes(0), ["she has seen it", ""]);
    assert_eq!(notes(1), ["nobody acknowledged it here"]);
}

#[test]
fn the_log_has_who_acknowledged_what_and_when() {
    let mut repeat = Repeat::of(session(), 0).expect("a branch");
    while !repeat.is_done() {
        repeat.step(|_| ()).expect("a step");
    }
    let log = repeat.log();
    let seconds = |t_s: f64| (10.0 * t_s).round() / 10.0;
    let stuck: Vec<_> = log
        .alarms
        .iter()
        .filter(|alarm| alarm.key == STUCK)
        .map(|alarm| {
            let seen = alarm.acknowledged.as_ref().map(|(t_s, who)| (seconds(*t_s), who.as_str()));
            (seconds(alarm.t_s), alarm.until_s.map(seconds), seen)
        })
        .collect();
    assert_eq!(
        stuck,
        [(2.1, Some(4.1), Some((3.0, "pilot 1"))), (5.1, Some(6.1), None)],
        "acknowledged while active, then over without anybody"
    );
    let [seen] = &log.acknowledgements[..] else { panic!("{:?}", log.acknowledgements) };
    assert_eq!((seconds(seen.t_s), &*seen.who), (3.0, "pilot 1"));
    let notes: Vec<_> =
        log.notes.iter().map(|note| (seconds(note.t_s), &*note.who, &*note.text)).collect();
    assert_eq!(notes, [(3.0, "instructor 2", "she has seen it"), (7.0, "instructor 2", "")]);
    assert_eq!(log.commands.len(), 5, "the notes are no commands");
}

#[test]
fn a_recording_that_is_torn_within_a_note_loses_that_note_alone() {
    let mut session = harbour();
    go(&mut session, 5);
    command(&mut session, note("kept"));
    command(&mut session, note("torn"));
    let text = session.take_lines();
    let cut = &text[..text.len() - 7];
    assert!(matches!(
        outline(cut).expect("its whole lines are sound").ending,
        fenderline_live::Ending::Torn { .. }
    ));
    let again = replay(cut).expect("the same bits").session;
    let line = r#""do":"note","text":"kept""#;
    assert!(cut.contains(line) && again.tick() == 5, "{cut}");
    assert_eq!(outline(cut).expect("sound").commands, 1);
}

#[test]
fn a_note_is_one_line_of_limited_length_and_notes_are_limited_in_number() {
    let mut session = harbour();
    go(&mut session, 1);
    let before = session.recorded_bytes();
    for (text, reason) in [
        ("x".repeat(301), "300 characters"),
        ("a\nb".into(), "one line"),
        ("\u{1b}[2J".into(), "one line"),
    ] {
        let refusal = session.command("instructor 1", 0, note(&text)).expect_err("too much");
        assert!(refusal.to_string().contains(reason), "{refusal}");
    }
    assert_eq!(session.recorded_bytes(), before, "a refused note leaves no trace");
    for _ in 0..20 {
        command(&mut session, note(&"ö".repeat(300)));
    }
    let refusal = session.command("instructor 1", 0, note("")).expect_err("too many");
    assert!(refusal.to_string().contains("20 notes"), "{refusal}");
    go(&mut session, 100);
    command(&mut session, note(""));
    assert!(replay(&saved(&mut session)).is_ok());
}

#[test]
fn the_acknowledgement_of_an_alarm_that_this_version_lacks_does_no_harm() {
    let mut session = harbour();
    go(&mut session, 3);
    command(&mut session, acknowledge());
    go(&mut session, 3);
    let text = saved(&mut session);
    let again = replay(&text).expect("the same bits").session;
    assert_eq!((again.bits(), alarms(&again)), (session.bits(), vec![]));
    let mut repeat = Repeat::of(again, 0).expect("a branch");
    while !repeat.is_done() {
        repeat.step(|_| ()).expect("a step");
    }
    assert!(repeat.log().acknowledgements.is_empty());
}
