//! An exercise at anchor: what a scenario may say, the goal as it is reached step by step, and the marks.

use fenderline_contact::number::lesser;
use fenderline_scenario::{Override, Scenario};
use fenderline_sim::anchor::SHACKLE_M;
use fenderline_sim::exercise::{Assessment, Measure, State, Subject};
use fenderline_sim::order::{AnchorAction, VesselAction};
use fenderline_sim::{Action, Order, Simulation};

const COME_TO_ANCHOR: &str = include_str!("../../../scenarios/live/come_to_anchor.toml");

fn scenario(set: &[&str]) -> Result<Scenario, String> {
    let set: Vec<Override> = set.iter().map(|s| Override::parse(s).expect("an override")).collect();
    Scenario::parse_with(COME_TO_ANCHOR, "come_to_anchor.toml", &set).map_err(|e| e.to_string())
}

fn begun(set: &[&str]) -> (Simulation, Assessment) {
    let scenario = scenario(set).expect("a scenario");
    let simulation = Simulation::new(scenario.setup).expect("a set-up");
    let assessment = Assessment::new(scenario.exercise.expect("an exercise"), &simulation);
    (simulation, assessment)
}

fn give(of: &mut Simulation, action: Action) {
    of.check_now(&action).expect("possible now");
    let at_s = of.time_s();
    of.order(Order { at_s, action }).expect("a good order");
}

fn steps(of: &mut Simulation, assessment: &mut Assessment, seconds: f64) {
    let until_s = of.time_s() + seconds;
    while of.time_s() < until_s - 1e-9 {
        of.step().expect("a step");
        assessment.update(of);
    }
}

fn now(assessment: &Assessment) -> &str {
    &assessment.conditions()[0].now
}

/// Over the place, in light wind, dead in the water: the anchor is let go, veered to four shackles and held.
#[test]
fn the_goal_follows_anchor_chain_and_brake_and_is_reached_when_she_is_brought_up() {
    // Her hawse pipe is over the place.
    let set = [
        "body.ship.position=[-62, 0]",
        "body.ship.heading=0",
        "body.ship.velocity={ surge = -0.2 }",
        "environment.wind={ speed = 5, from = 0 }",
    ];
    let (mut of, mut assessment) = begun(&set);
    let goal = &assessment.setup().goal;
    assert_eq!(
        goal[0].words(),
        "1 anchor holds, at least 4.0 shackles out, on the bottom within 50 m of north 0.00 m, east 0.00 m"
    );
    assert_eq!(now(&assessment), "no anchor down");
    assert_eq!(assessment.setup().berth, None, "an anchorage needs no berth");
    give(&mut of, Action::Anchor(0, AnchorAction::LetGo { chain_m: SHACKLE_M }));
    steps(&mut of, &mut assessment, 2.0);
    assert_eq!(now(&assessment), "port not on the bottom, 0.4 shackles of chain out");
    steps(&mut of, &mut assessment, 60.0);
    assert!(now(&assessment).starts_with("port 1.0 shackles out, "), "{}", now(&assessment));
    assert!(!assessment.conditions()[0].is_met, "a shackle is not four");
    give(&mut of, Action::Anchor(0, AnchorAction::Veer { chain_m: 4.0 * SHACKLE_M }));
    steps(&mut of, &mut assessment, 60.0);
    assert!(now(&assessment).contains(", chain runs out"), "{}", now(&assessment));
    for _ in 0..60 {
        steps(&mut of, &mut assessment, 60.0);
    }
    let State::Reached(at_s) = assessment.state() else { panic!("{}", now(&assessment)) };
    assert!(at_s > 500.0, "after the chain is out, at 9 m a minute: {at_s}");
    assert!(now(&assessment).starts_with("port 4.0 shackles out, "), "{}", now(&assessment));
    assert!(assessment.conditions().iter().all(|condition| condition.is_met));
    let worst = |measure| {
        let place = assessment.setup().limits.iter().position(|limit| limit.measure == measure);
        assessment.marks()[place.expect("a limit")].worst.expect("it counted")
    };
    let (share, whose, _) = worst(Measure::Chain);
    assert!(whose == Subject::Anchor(0) && share > 0.0 && share < 0.2, "{share}");
    assert_eq!(assessment.is_passed(), Some(true), "{}", assessment.sentence());
}

/// At a place 200 m off, the same anchor does not count; a chain that parts or drags is marked.
#[test]
fn an_anchor_elsewhere_or_dragging_is_not_brought_up_and_dragging_costs_points() {
    let set = [
        "body.ship.position=[-262, 0]",
        "body.ship.heading=0",
        "body.ship.velocity={ surge = 0 }",
        "environment.wind={ speed = 28, from = 0 }",
        "exercise.time_limit=900",
    ];
    let (mut of, mut assessment) = begun(&set);
    give(&mut of, Action::Anchor(1, AnchorAction::LetGo { chain_m: 2.0 * SHACKLE_M }));
    let mut dragged = false;
    for _ in 0..91 {
        steps(&mut of, &mut assessment, 10.0);
        dragged |= now(&assessment).ends_with(", drags");
        assert!(!assessment.conditions()[0].is_met);
    }
    assert!(dragged && now(&assessment).contains(" from the place"), "{}", now(&assessment));
    assert!(matches!(assessment.state(), State::TimeOver(_)));
    let deduction = assessment.deductions().find(|of| of.limit.measure == Measure::Dragged);
    let deduction = deduction.expect("she dragged");
    assert_eq!(deduction.subject, Subject::Anchor(1));
    let sentence = deduction.sentence(of.setup());
    assert!(sentence.starts_with("Way of a dragging anchor (starboard): "), "{sentence}");
    assert!(sentence.contains(", at most 20 m"), "{sentence}");
}

/// From the start of the scenario: the way is taken off her on her course, the nearer the slower; she lets go with sternway when her
/// hawse pipe is at the place, veers with the chain growing, and is brought up.
#[test]
fn the_example_is_reached_and_passed_by_a_careful_pilot() {
    let (mut of, mut assessment) = begun(&[]);
    let ship = |action| Action::Vessel(0, action);
    let hawse_m = of.setup().world.anchors[0].hawse_m;
    give(&mut of, ship(VesselAction::Course(10_f64.to_radians())));
    let (mut is_down, mut is_veered) = (false, false);
    while assessment.state() == State::Running {
        let short_m = -of.states()[0].pose().apply(hawse_m).x;
        let ahead_mps = of.states()[0].velocity_mps.x;
        if !is_down {
            let speed_mps = if short_m < 60.0 { -0.4 } else { lesser(short_m / 200.0, 2.5) };
            give(&mut of, ship(VesselAction::Speed(speed_mps)));
        }
        if !is_down && short_m < 60.0 && ahead_mps < -0.1 {
            give(&mut of, ship(VesselAction::Hands));
            give(&mut of, ship(VesselAction::Engine(0.0)));
            give(&mut of, Action::Anchor(0, AnchorAction::LetGo { chain_m: 1.5 * SHACKLE_M }));
            is_down = true;
        }
        let anchor = &of.anchors()[0];
        let is_growing = is_down && !is_veered && anchor.state.chain_m > 41.0;
        if is_growing && anchor.load.on_bottom_m < 15.0 {
            is_veered = true;
            give(&mut of, Action::Anchor(0, AnchorAction::Veer { chain_m: 4.0 * SHACKLE_M }));
        }
        steps(&mut of, &mut assessment, 1.0);
    }
    println!("{}; {}", assessment.sentence(), now(&assessment));
    for deduction in assessment.deductions() {
        println!("{}", deduction.sentence(of.setup()));
    }
    assert!(matches!(assessment.state(), State::Reached(_)), "{}", now(&assessment));
    assert_eq!(assessment.is_passed(), Some(true), "{}", assessment.sentence());
}

#[test]
fn a_goal_at_anchor_that_cannot_be_is_refused_with_its_key() {
    for (set, expected) in [
        ("exercise.anchors=[\"prot\"]", "did you mean \"port\"?"),
        ("exercise.anchors=[\"port\", \"port\"]", "twice"),
        ("exercise.anchors=[]", "has no anchors"),
        ("exercise.at_least=3", "whole number of at most 2 anchors"),
        (
            "exercise.chain_out=\"10 shackles\"",
            "`exercise.chain_out`: 0 of the anchors have a chain of 275 m",
        ),
        ("exercise.least_tension=5", "does not go together with the goal \"anchored\""),
        ("exercise.lines=[\"a\"]", "does not go together with the goal \"anchored\""),
        ("exercise.goal=\"clear\"", "does not go together with the goal \"clear\""),
        ("exercise={ vessel = \"ship\", goal = \"anchored\", distance = 20 }", "needs `position`"),
        ("exercise.limit.chain={ most = 1, worst = 0.5, points = 1 }", "costs all points"),
    ] {
        let error = scenario(&[set]).expect_err(set);
        assert!(error.contains(expected), "{set}: {error}");
    }
    let plain = "exercise={ vessel = \"ship\", goal = \"anchored\" }";
    let exercise = scenario(&[plain]).expect("good").exercise.expect("there is one");
    assert_eq!(exercise.goal[0].words(), "1 anchor holds");
}
