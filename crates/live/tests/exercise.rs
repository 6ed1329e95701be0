//! The exercise of a session: its end, rewinding, branches, and a recording that is played again.

use crate::support;

use fenderline_live::message::{PlaceInfo, RunState, text};
use fenderline_live::{Repeat, Session};
use fenderline_sim::OrderName;
use fenderline_sim::exercise::State;

/// The ship is at rest 0.3 m off the fenders. The goal is reached when she has been alongside for two seconds.
fn alongside() -> Session {
    support::open(
        "scenarios/live/berthing.toml",
        &[
            "environment.wind.speed=0",
            "environment.wind.gusts=false",
            "body.ship.position=[0, -17.2]",
            "body.ship.heading=\"0 deg\"",
            "body.ship.velocity.surge=0",
            "body.forward_tug.position=[40, -90]",
            "body.after_tug.position=[-80, -90]",
            "exercise={ vessel = \"ship\", goal = \"alongside\", hold = 2, limit = { touch = { points = 5 } } }",
        ],
    )
}

fn reached_s(session: &Session) -> Option<f64> {
    match session.exercise().expect("there is one").state() {
        State::Reached(at_s) => Some(at_s),
        State::Running => None,
        State::TimeOver(at_s) => panic!("it has no time limit: {at_s}"),
    }
}

#[test]
fn an_exercise_is_that_of_the_shown_time_and_of_the_recording() {
    let mut session = alongside();
    support::go(&mut session, 15);
    assert_eq!(reached_s(&session), None);
    session.take_events();
    support::go(&mut session, 10);
    let at_s = reached_s(&session).expect("it held for two seconds");
    assert!((at_s - 2.1).abs() < 1e-9, "{at_s}");
    let events = session.take_events();
    let ends = events.iter().filter(|(_, text)| text.contains("The exercise has ended"));
    assert_eq!(ends.count(), 1, "{events:?}");
    // After a rewind the exercise goes on as it did then. At the end it has ended again, without another event.
    session.rewind(15).expect("it is there");
    assert_eq!(reached_s(&session), None);
    session.rewind(25).expect("it is there");
    assert_eq!(reached_s(&session), Some(at_s));
    assert!(session.take_events().is_empty());
    // A branch from before the end has an exercise of its own.
    session.rewind(10).expect("it is there");
    session.branch().expect("a branch");
    support::go(&mut session, 5);
    assert_eq!(reached_s(&session), None);
    support::go(&mut session, 10);
    assert_eq!(reached_s(&session), Some(at_s));
    // A server that starts again from the recording, and the report, have the same exercise.
    let recording = support::saved(&mut session);
    let again = support::replay(&recording).expect("a good recording").session;
    assert_eq!(again.exercise(), session.exercise());
    let mut repeat = Repeat::of(session, 0).expect("a branch");
    while !repeat.is_done() {
        repeat.step(|_| ()).expect("a step");
    }
    let exercise = repeat.exercise().expect("there is one");
    assert_eq!(exercise.state(), State::Reached(at_s));
}

#[test]
fn the_score_is_not_a_part_of_the_frame_that_everybody_gets() {
    let session = alongside();
    let frame = text(&session.frame(0, RunState::default()));
    assert!(frame.contains("\"exercise\":{\"state\":\"running\"") && !frame.contains("score"));
    let marks = text(&session.exercise_marks().expect("marks"));
    assert!(marks.starts_with("{\"score\":100.0,\"passed\":null"), "{marks}");
}

#[test]
fn the_place_of_an_anchor_is_told_so_that_pages_draw_it() {
    let session = support::open("scenarios/live/come_to_anchor.toml", &[]);
    let info = session.exercise_info().expect("an exercise");
    assert_eq!(info.place, Some(PlaceInfo { at_m: [0.0, 0.0], within_m: 50.0 }));
    assert_eq!(alongside().exercise_info().expect("an exercise").place, None);
    let frame = text(&session.frame(0, RunState::default()));
    assert!(frame.contains("\"now\":\"no anchor down\""), "{frame}");
}

/// The goal asks for tight lines with the winches on hold, and was reached while a winch heaved.
#[test]
fn a_line_whose_winch_heaves_does_not_count_for_a_goal_with_tensions() {
    let exercise = "exercise={ vessel = \"ship\", goal = \"all_fast\", least_tension = \"1 kN\", \
                    rest_speed = \"5 m/s\", hold = 2 }";
    let mut session = support::open(
        "scenarios/live/moored_while_a_ship_passes.toml",
        &["line.head.winch=true", exercise],
    );
    let now = |session: &Session| {
        let frame = session.frame(0, RunState::default());
        let conditions = frame.exercise.expect("an exercise").conditions;
        let of_lines = conditions.iter().find(|of| of.now.contains("lines fast"));
        of_lines.expect("a condition of lines").now.clone()
    };
    support::go(&mut session, 5);
    let before = now(&session);
    let heave = support::order(OrderName::Heave, "head").number("rate", 0.05);
    support::command(&mut session, heave.into());
    support::go(&mut session, 5);
    assert_ne!(now(&session), before);
    support::command(&mut session, support::order(OrderName::Hold, "head").into());
    support::go(&mut session, 5);
    assert_eq!(now(&session), before);
}
