//! Predictions that continue the one before have the same bits as predictions from the beginning.

use crate::support;

use fenderline_live::message::Reply;
use fenderline_live::{Action, OtherAction, Outlook, Session};
use fenderline_sim::order::{Lead, SidePlace, TugWord, TugWords};
use support::{command, engine, go, harbour, open, rudder};

const AHEAD_S: f64 = 20.0;
const EVERY_S: f64 = 2.0;

/// Makes the next prediction of an outlook, and checks that it equals a prediction from the beginning. Returns true if
/// it continued the one before.
fn is_continued(outlook: &mut Outlook, session: &Session) -> bool {
    let of_now = || session.prediction().expect("ships");
    let mut asked = 0;
    let shown = outlook.run(of_now(), AHEAD_S, EVERY_S, || {
        asked += 1;
        true
    });
    let anew = of_now().run(AHEAD_S, EVERY_S, |_| true);
    let tick = session.tick();
    let (Reply::Prediction { tick: at, paths }, Reply::Prediction { paths: expected, .. }) =
        (shown, anew)
    else {
        panic!("predictions")
    };
    assert_eq!(at, tick);
    assert_eq!(paths, expected, "at tick {tick}");
    asked <= 1
}

#[test]
fn a_continued_prediction_has_the_bits_of_one_that_is_made_anew() {
    let mut session = open("scenarios/live/berthing.toml", &[]);
    let mut outlook = Outlook::default();
    let mut anew = Vec::new();
    let push = TugWords {
        word: TugWord::Push,
        power: 0.6,
        lead: Lead::default(),
        place: SidePlace::default(),
    };
    let push = Action::tug("after_tug", push);
    let wind = |over_s| OtherAction::Wind { speed_mps: 9.0 + over_s, from_rad: 4.0, over_s }.into();
    for tick in 0..240 {
        match tick {
            20 => command(&mut session, rudder(0.3)),
            21 => command(&mut session, engine(0.4)),
            60 => command(&mut session, wind(0.0)),
            90 => command(&mut session, push.clone()),
            // A line parts 3 s later, when nobody gives an order.
            120 => {
                let event = OtherAction::PartLine { line: "after_tow".into() };
                let plan = OtherAction::Plan { at_s: 15.0, event: Box::new(event) };
                command(&mut session, plan.into())
            }
            200 => command(&mut session, wind(3.0)),
            _ => session.tick(),
        };
        if !is_continued(&mut outlook, &session) {
            anew.push(tick);
        }
        go(&mut session, 1);
    }
    // Predictions from the beginning: the first, after each order, after the event at 15 s, and while the wind changes
    // over 3 s.
    let ramp = 200..=230;
    assert_eq!(anew, [0, 20, 21, 60, 90, 120, 151].into_iter().chain(ramp).collect::<Vec<_>>());
}

#[test]
fn a_prediction_after_rewinding_or_on_another_branch_is_made_anew() {
    let mut session = harbour();
    let mut outlook = Outlook::default();
    go(&mut session, 100);
    assert!(!is_continued(&mut outlook, &session));
    // Some ticks pass without a prediction, as on a slow machine.
    go(&mut session, 7);
    assert!(is_continued(&mut outlook, &session));
    session.rewind(80).expect("a tick of the run");
    assert!(!is_continued(&mut outlook, &session));
    session.branch().expect("a branch");
    command(&mut session, rudder(-0.4));
    assert!(!is_continued(&mut outlook, &session));
    go(&mut session, 27);
    assert!(is_continued(&mut outlook, &session));
    session.go_to_branch(0).expect("the first branch");
    assert!(!is_continued(&mut outlook, &session));
    outlook.forget();
    assert!(!is_continued(&mut outlook, &session));
}

#[test]
fn an_order_of_the_scenario_that_comes_due_is_in_the_next_prediction() {
    let mut session = open("scenarios/berth/asd_tugs_push_alongside.toml", &[]);
    go(&mut session, 1695);
    let mut outlook = Outlook::default();
    let mut anew = Vec::new();
    for tick in 1695..1710 {
        if !is_continued(&mut outlook, &session) {
            anew.push(tick);
        }
        go(&mut session, 1);
    }
    // Predictions from the beginning: the first, and that before the step in which the orders of 170 s are due.
    assert_eq!(anew, [1695, 1700]);
}

#[test]
fn a_prediction_that_ends_early_is_not_continued() {
    let mut session = harbour();
    let mut outlook = Outlook::default();
    let prediction = session.prediction().expect("a ship");
    let Reply::Prediction { paths, .. } = outlook.run(prediction, AHEAD_S, EVERY_S, || false)
    else {
        panic!("a prediction")
    };
    assert_eq!(paths[0].path.len(), 1);
    go(&mut session, 1);
    assert!(!is_continued(&mut outlook, &session));
}
