//! Lines that orders send to bollards: handlers, boat, heaving, letting go, and what is refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::Scenario;
use fenderline_sim::order::{Arguments, OrderName, Value};
use fenderline_sim::{Action, Order, OrderError, Simulation, WorldEventKind};

/// A barge held beside a quay, so that the lengths of lines follow from the places alone. Fairleads and bollards are at one height.
const BERTH: &str = r#"title = "Lines"

[time]
step = "1 s"
duration = "2 h"

[body.barge]
fixed = true
outline = [[-40, -8], [40, -8], [40, 8], [-40, 8]]
position = [0, -10]

[body.quay]
fixed = true
outline = [[-200, 0], [200, 0], [200, 20], [-200, 20]]

[line.head]
from = "barge"
fairlead = [36, 8]
rope = "polyester"
break_load = "600 kN"
winch = true

[line.spring]
from = "barge"
fairlead = [30, 8]
rope = "polyester"
break_load = "600 kN"
winch = true

[line.stern]
from = "barge"
fairlead = [-36, 8]
rope = "polyester"
break_load = "600 kN"

[bollard.near]
on = "quay"
at = [50, 2]

[bollard.far]
on = "quay"
at = [120, 2]
lines = 1

[bollard.own]
on = "barge"
at = [0, 0]
"#;

fn berth(changes: &[(&str, &str)]) -> Simulation {
    let text = changes.iter().fold(BERTH.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replace(from, to)
    });
    let scenario = Scenario::parse(&text, "lines.toml").expect("a good scenario");
    Simulation::new(scenario.setup).expect("a good set-up")
}

fn line(of: &Simulation, name: &str) -> usize {
    of.setup().world.lines.iter().position(|line| line.line.name == name).expect("a line")
}

fn send(of: &Simulation, name: &str, bollard: &str) -> Action {
    let mut all = of.setup().world.bollards.iter();
    let bollard = all.position(|other| other.name == bollard).expect("a bollard");
    let arguments = Arguments::new().with("bollard", Value::Index(bollard));
    OrderName::Send.build(line(of, name), &arguments, of.setup()).expect("a good order")
}

fn order(of: &mut Simulation, action: Action) {
    of.check_now(&action).expect("possible now");
    let at_s = of.time_s();
    of.order(Order { at_s, action }).expect("a good order");
}

fn winch(of: &Simulation, name: &str, order: OrderName, rate_mps: f64) -> Action {
    let arguments = Arguments::new().number("rate", rate_mps);
    order.build(line(of, name), &arguments, of.setup()).expect("a good order")
}

fn plain(of: &Simulation, name: &str, order: OrderName) -> Action {
    order.build(line(of, name), &Arguments::new(), of.setup()).expect("a good order")
}

/// Runs for a time, and returns the times at which lines were made fast, with their names.
fn run(of: &mut Simulation, seconds: f64) -> Vec<(f64, String)> {
    let until_s = of.time_s() + seconds;
    let mut fast = Vec::new();
    while of.time_s() < until_s - 1e-9 {
        let t_s = of.time_s();
        let record = of.step().expect("a good step");
        for event in record.world_events {
            if event.kind == WorldEventKind::LineMadeFast {
                fast.push((t_s, event.who));
            }
        }
    }
    let name = |who: usize| of.setup().world.lines[who].line.name.clone();
    fast.into_iter().map(|(t_s, who)| (t_s, name(who))).collect()
}

fn length_m(of: &Simulation, name: &str) -> f64 {
    of.lines()[line(of, name)].line.as_ref().expect("outboard").1.length_m
}

#[test]
fn a_line_is_sent_made_fast_with_slack_heaved_tight_and_held() {
    let mut of = berth(&[]);
    let to_near = send(&of, "head", "near");
    order(&mut of, to_near);
    // 14.0 m forward and 4 m across: within reach of a heaving line, which takes 60 s.
    assert_eq!(run(&mut of, 70.0), [(60.0, "head".to_owned())]);
    let span_m = f64::hypot(14.0, 4.0);
    assert!((length_m(&of, "head") - (1.02 * span_m + 1.0)).abs() < 1e-12);
    assert_eq!(of.lines()[line(&of, "head")].load.tension_n, 0.0);
    let heave = winch(&of, "head", OrderName::Heave, 0.2);
    order(&mut of, heave);
    run(&mut of, 60.0);
    // The motor stalls at 30 % of the break load.
    let tension_n = of.lines()[line(&of, "head")].load.tension_n;
    assert!((tension_n / 180e3 - 1.0).abs() < 1e-9, "{tension_n}");
    let hold = plain(&of, "head", OrderName::Hold);
    order(&mut of, hold);
    run(&mut of, 60.0);
    assert!((of.lines()[line(&of, "head")].load.tension_n / 180e3 - 1.0).abs() < 1e-9);
}

#[test]
fn a_line_on_bitts_is_made_fast_hand_tight() {
    let mut of = berth(&[("at = [120, 2]", "at = [-60, 2]")]);
    let to_far = send(&of, "stern", "far");
    order(&mut of, to_far);
    assert_eq!(run(&mut of, 100.0).len(), 1);
    assert!((length_m(&of, "stern") - f64::hypot(24.0, 4.0)).abs() < 1e-12);
}

#[test]
fn lines_wait_for_line_handlers_in_the_order_in_which_they_were_sent() {
    let of = &mut berth(&[("[bollard.near]", "[line_handling]\ngangs = 1\n\n[bollard.near]")]);
    for name in ["spring", "head"] {
        let action = send(of, name, "near");
        order(of, action);
        run(of, 5.0);
    }
    let fast = run(of, 200.0);
    assert_eq!(fast, [(60.0, "spring".to_owned()), (121.0, "head".to_owned())]);
}

#[test]
fn a_boat_takes_its_time_and_without_one_the_bollard_is_out_of_reach() {
    let mut of = berth(&[]);
    let action = send(&of, "head", "far");
    order(&mut of, action);
    // 84 m at 1 m/s and 60 s.
    let expected_s = f64::hypot(84.0, 4.0) + 60.0;
    let fast = run(&mut of, 300.0);
    assert!((fast[0].0 - expected_s).abs() <= 1.0, "{fast:?}");

    let of = berth(&[("[bollard.near]", "[line_handling]\nboat = false\n\n[bollard.near]")]);
    let refused = of.check_now(&send(&of, "head", "far")).expect_err("out of reach");
    assert_eq!(
        refused.to_string(),
        "bollard `far` is 84 m from the fairlead of line `head`, but a heaving line reaches 30 m"
    );
    let short = berth(&[("winch = true", "winch = true\nrope_length = \"50 m\"")]);
    let refused = short.check_now(&send(&short, "head", "far")).expect_err("out of reach");
    assert_eq!(
        refused.to_string(),
        "bollard `far` is 84 m from the fairlead of line `head`, but the rope reaches 48 m"
    );
}

#[test]
fn what_cannot_be_done_with_a_line_now_is_refused_with_the_reason() {
    let of = &mut berth(&[]);
    let (heave, let_go) =
        (winch(of, "head", OrderName::Heave, 0.1), plain(of, "head", OrderName::LetGo));
    let why = |of: &Simulation, action: &Action| of.check_now(action).expect_err("refused");
    assert!(matches!(why(of, &heave), OrderError::LineAboard { .. }));
    assert!(matches!(why(of, &let_go), OrderError::LineAboard { .. }));
    let action = send(of, "head", "far");
    order(of, action.clone());
    run(of, 1.0);
    assert!(matches!(why(of, &action), OrderError::LineUnderWay { .. }));
    assert!(matches!(why(of, &heave), OrderError::LineUnderWay { .. }));
    assert_eq!(
        why(of, &send(of, "spring", "far")).to_string(),
        "bollard `far` takes 1 line and already has as many"
    );
    run(of, 200.0);
    assert!(matches!(why(of, &action), OrderError::LineInUse { .. }));
    order(of, let_go.clone());
    run(of, 1.0);
    assert!(matches!(why(of, &heave), OrderError::LineAboard { .. }));
}

/// In one step, before the first order is carried out.
#[test]
fn two_orders_to_a_line_in_one_step_are_checked_one_after_the_other() {
    let of = &mut berth(&[]);
    let give = |of: &mut Simulation, action: &Action| {
        of.check_now(action).expect("it can be carried out");
        order(of, action.clone());
    };
    let (head, spring) = (send(of, "head", "far"), send(of, "spring", "far"));
    let (heave, let_go) =
        (winch(of, "head", OrderName::Heave, 0.1), plain(of, "head", OrderName::LetGo));
    let why = |of: &Simulation, action: &Action| of.check_now(action).expect_err("refused");
    give(of, &head);
    assert!(matches!(why(of, &head), OrderError::LineUnderWay { .. }));
    assert!(matches!(why(of, &heave), OrderError::LineUnderWay { .. }));
    // The bollard takes one line.
    assert!(matches!(why(of, &spring), OrderError::BollardTaken { .. }));
    give(of, &let_go);
    assert!(matches!(why(of, &let_go), OrderError::LineAboard { .. }));
    assert!(matches!(why(of, &heave), OrderError::LineAboard { .. }));
    give(of, &spring);
    let events = of.step().expect("a step").world_events.len();
    assert_eq!(events, 0, "all three are carried out");
    assert!(matches!(why(of, &spring), OrderError::LineUnderWay { .. }));
    of.check_now(&send(of, "head", "near")).expect("it is on board");
}

#[test]
fn a_line_that_was_let_go_is_hauled_in_before_it_is_sent_again() {
    let of = &mut berth(&[]);
    let (far, near) = (send(of, "head", "far"), send(of, "head", "near"));
    order(of, far);
    run(of, 300.0);
    let outboard_m = length_m(of, "head");
    let let_go = plain(of, "head", OrderName::LetGo);
    order(of, let_go);
    run(of, 1.0);
    order(of, near);
    // Hauled in at the winch's 0.25 m/s, then 60 s with a heaving line.
    let fast = run(of, 1000.0);
    let expected_s = 300.0 + outboard_m / 0.25 + 60.0;
    assert!((fast[0].0 - expected_s).abs() <= 1.0, "{fast:?} {expected_s}");
}

#[test]
fn a_line_on_its_way_can_be_called_back() {
    let of = &mut berth(&[]);
    let (far, let_go) = (send(of, "head", "far"), plain(of, "head", OrderName::LetGo));
    order(of, far.clone());
    run(of, 10.0);
    order(of, let_go);
    assert!(run(of, 300.0).is_empty());
    of.check_now(&far).expect("the bollard is free again");
}

#[test]
fn a_timed_order_that_cannot_be_carried_out_is_an_event() {
    let orders = r#"
[[order]]
line = "head"
send = { bollard = "far" }

[[order]]
at = "10 s"
line = "spring"
send = { bollard = "far" }
"#;
    let scenario = Scenario::parse(&format!("{BERTH}{orders}"), "lines.toml").expect("good");
    let mut of = Simulation::new(scenario.setup).expect("good");
    let mut kinds = Vec::new();
    for _ in 0..300 {
        kinds.extend(of.step().expect("good").world_events.iter().map(|event| event.kind));
    }
    assert_eq!(kinds, [WorldEventKind::LineNotMadeFast, WorldEventKind::LineMadeFast]);
}

#[test]
fn mistakes_in_lines_and_bollards_are_refused_where_they_stand() {
    for (from, to, expected) in [
        (
            "winch = true\n\n[line.spring]",
            "length = \"20 m\"\n\n[line.spring]",
            "`line.head.length` needs `to`",
        ),
        ("lines = 1", "lines = 1.5", "`bollard.far.lines` must be a whole number, but is 1.5"),
        ("lines = 1", "lines = 0", "bollard.far.lines"),
        ("on = \"barge\"", "on = \"barg\"", "there is no body \"barg\""),
        (
            "[bollard.near]",
            "[line_handling]\nboat = false\nboat_speed = 2\n\n[bollard.near]",
            "does not go together",
        ),
    ] {
        assert!(BERTH.contains(from), "{from}");
        let error = Scenario::parse(&BERTH.replace(from, to), "lines.toml").expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}");
    }
    for (order, expected) in [
        ("send = { bollard = \"fra\" }", "did you mean \"far\"?"),
        ("send = { bollard = \"own\" }", "bollard `own` is on the body that holds line `head`"),
        ("send = { }", "bollard"),
    ] {
        let text = format!("{BERTH}\n[[order]]\nline = \"head\"\n{order}\n");
        let error = Scenario::parse(&text, "lines.toml").expect_err(expected);
        assert!(error.to_string().contains(expected), "{error}");
    }
}
