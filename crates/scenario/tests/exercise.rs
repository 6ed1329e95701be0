//! Exercises: what a scenario may say, and the marks of runs whose values are known.

use fenderline_scenario::{Override, Scenario};
use fenderline_sim::Simulation;
use fenderline_sim::exercise::{Assessment, Measure, State, Subject};

const BERTHING: &str = include_str!("../../../scenarios/live/berthing.toml");

fn scenario(set: &[&str]) -> Result<Scenario, String> {
    let set: Vec<Override> = set.iter().map(|s| Override::parse(s).expect("an override")).collect();
    Scenario::parse_with(BERTHING, "berthing.toml", &set).map_err(|error| error.to_string())
}

/// The simulation with its exercise, before the first step.
fn begun(set: &[&str]) -> (Simulation, Assessment) {
    let scenario = scenario(set).expect("a scenario");
    let simulation = Simulation::new(scenario.setup).expect("a set-up");
    let exercise = scenario.exercise.expect("it has an exercise");
    let assessment = Assessment::new(exercise, &simulation);
    (simulation, assessment)
}

fn steps(simulation: &mut Simulation, assessment: &mut Assessment, count: usize) {
    for _ in 0..count {
        simulation.step().expect("a step");
        assessment.update(simulation);
    }
}

/// The ship in calm water at a place, heading and velocity; the fenders' faces are at 1.9 m off the quay, her side is 15 m from
/// her middle.
fn at(off_m: f64, heading_deg: f64, sway_mps: f64, surge_mps: f64) -> Vec<String> {
    vec![
        "environment.wind.speed=0".into(),
        "environment.wind.gusts=false".into(),
        format!("body.ship.position=[0, {}]", -1.9 - 15.0 - off_m),
        format!("body.ship.heading=\"{heading_deg} deg\""),
        format!("body.ship.velocity={{ surge = {surge_mps}, sway = {sway_mps} }}"),
        "body.forward_tug.position=[40, -90]".into(),
        "body.after_tug.position=[-80, -90]".into(),
    ]
}

fn marked(set: &[String], count: usize) -> (Simulation, Assessment) {
    let set: Vec<&str> = set.iter().map(String::as_str).collect();
    let (mut simulation, mut assessment) = begun(&set);
    steps(&mut simulation, &mut assessment, count);
    (simulation, assessment)
}

fn worst(assessment: &Assessment, measure: Measure) -> Option<(f64, Subject, f64)> {
    let place = assessment.setup().limits.iter().position(|limit| limit.measure == measure);
    assessment.marks()[place.expect("there is such a limit")].worst
}

#[test]
fn limits_measure_what_the_set_up_says() {
    // 4 m off, closing at 0.2 m/s, nothing else: both ends close at the same speed, the first of equals is the bow.
    let (_, assessment) = marked(&at(4.0, 0.0, 0.2, 0.0), 1);
    let (speed_mps, whose, at_s) = worst(&assessment, Measure::ApproachSpeed).expect("near");
    assert!((speed_mps - 0.2).abs() < 1e-3 && whose == Subject::Bow, "{speed_mps} {whose:?}");
    assert!((at_s - 0.1).abs() < 1e-12);
    assert!(worst(&assessment, Measure::Angle).expect("near").0 < 1e-4);
    // A third of 25 points for 0.05 of 0.15 m/s above the limit; the hull's drag of one step takes less than 1e-3 m/s.
    assert!((assessment.score() - (100.0 - 25.0 / 3.0)).abs() < 0.3, "{}", assessment.score());
    assert_eq!(assessment.deductions().count(), 1);
    // The same farther off than the limit reaches.
    let (_, assessment) = marked(&at(8.0, 0.0, 0.2, 0.0), 1);
    assert_eq!(worst(&assessment, Measure::ApproachSpeed), None);
    assert!(worst(&assessment, Measure::Angle).is_some(), "that limit reaches to 10 m");
    assert_eq!(assessment.score(), 100.0);
    // 5 degrees is two fifths of the way from 3 to 8; 0.65 m/s ahead is half of the way from 0.3 to 1.
    let (_, assessment) = marked(&at(12.0, 5.0, 0.0, 0.65), 1);
    let points = |measure: Measure| {
        let found = assessment.deductions().find(|of| of.limit.measure == measure);
        found.map(|of| of.points)
    };
    let angle = points(Measure::Angle).expect("it is exceeded");
    assert!((angle - 0.4 * 15.0).abs() < 0.02, "{angle}");
    let ahead = points(Measure::AheadSpeed).expect("it is exceeded");
    assert!((ahead - 0.5 * 15.0).abs() < 0.1, "{ahead}");
}

#[test]
fn a_touch_without_a_fender_fails_the_exercise_and_is_explained() {
    // Her side is 0.5 m in the concrete, away from the fenders.
    let mut set = at(-2.4, 0.0, 0.0, 0.0);
    set.push("body.ship.position=[-130, -14.5]".into());
    set.push("body.forward_tug.position=[-90, -70]".into());
    set.push("body.after_tug.position=[-210, -70]".into());
    let (simulation, assessment) = marked(&set, 3);
    assert_eq!(assessment.is_passed(), Some(false), "at once");
    assert_eq!(assessment.state(), State::Running);
    let touch = assessment.deductions().find(|of| of.limit.measure == Measure::Touch);
    let touch = touch.expect("she touches");
    assert_eq!((touch.points, touch.subject), (50.0, Subject::Body(3)));
    let sentence = touch.sentence(simulation.setup());
    assert!(sentence.starts_with("Touch without a fender (quay) at 0:00 min"), "{sentence}");
}

#[test]
fn the_goal_is_reached_after_its_hold_and_nothing_counts_afterwards() {
    let mut set = at(0.3, 0.0, 0.0, 0.0);
    set.extend(["exercise.goal=\"alongside\"".into(), "exercise.hold=2".into()]);
    let text = BERTHING
        .replace("least_tension = \"20 kN\"\n", "")
        .replace("most_tension = \"400 kN\"\n", "");
    let set: Vec<Override> = set.iter().map(|s| Override::parse(s).expect("an override")).collect();
    let scenario = Scenario::parse_with(&text, "berthing.toml", &set).expect("a scenario");
    let mut simulation = Simulation::new(scenario.setup).expect("a set-up");
    let mut assessment = Assessment::new(scenario.exercise.expect("an exercise"), &simulation);
    steps(&mut simulation, &mut assessment, 20);
    // Fulfilled since the first step, at 0.1 s.
    assert_eq!(assessment.state(), State::Running);
    assert!((assessment.held_s(simulation.time_s()) - 1.9).abs() < 1e-9);
    steps(&mut simulation, &mut assessment, 1);
    let State::Reached(at_s) = assessment.state() else { panic!("{:?}", assessment.state()) };
    assert!((at_s - 2.1).abs() < 1e-9);
    assert_eq!((assessment.score(), assessment.is_passed()), (100.0, Some(true)));
    let ended = assessment.clone();
    steps(&mut simulation, &mut assessment, 5);
    assert_eq!(assessment, ended);
    assert_eq!(assessment.sentence(), "Goal reached at 0:02 min; score 100 of 100, passed");
}

#[test]
fn the_time_limit_ends_an_exercise_without_its_goal() {
    let (_, assessment) = {
        let mut set = at(20.0, 0.0, 0.0, 0.0);
        set.push("exercise.time_limit=1".into());
        marked(&set, 15)
    };
    assert!(matches!(assessment.state(), State::TimeOver(at_s) if (at_s - 1.0).abs() < 1e-9));
    assert_eq!(assessment.is_passed(), Some(false));
}

#[test]
fn a_goal_or_limit_that_cannot_be_is_refused_with_its_key() {
    for (set, expected) in [
        ("exercise.vessel=\"quay\"", "body \"quay\" is no vessel"),
        ("exercise.berth=\"forward_tuk\"", "did you mean"),
        ("exercise.berth=\"ship\"", "cannot be her own berth"),
        ("exercise.lines=[\"head\", \"stren\"]", "there is no line \"stren\""),
        ("exercise.lines=[\"head\", \"head\"]", "twice"),
        ("exercise.lines=[]", "has no lines"),
        ("exercise.at_least=7", "whole number of at most 6"),
        ("exercise.at_least=1.5", "whole number of at most 6"),
        ("exercise.most_tension=\"1 kN\"", "less than `least_tension`"),
        ("exercise.goal=\"alongside\"", "does not go together with the goal \"alongside\""),
        ("exercise.goal=\"moored\"", "exercise.goal"),
        ("exercise.limit.angle.worst=0", "costs all points"),
        ("exercise.limit.fender={ most = 1 }", "points"),
        ("exercise.limit.speed={ most = 1, points = 1 }", "speed"),
    ] {
        let error = scenario(&[set]).expect_err(set);
        assert!(error.contains(expected), "{set}: {error}");
    }
}

#[test]
fn a_limit_that_nothing_can_exceed_gets_a_notice() {
    let scenario = scenario(&[
        "exercise.limit.clearance={ least = 5, points = 1 }",
        "exercise.limit.cross_track={ most = 5, points = 1 }",
    ]);
    let notices = scenario.expect("a scenario").notices;
    let about = notices.iter().find(|notice| notice.key == "exercise.limit.cross_track");
    assert!(about.expect("a notice").message.contains("no passage plan"));
    let about = notices.iter().find(|notice| notice.key == "exercise.limit.clearance");
    assert!(about.expect("a notice").message.contains("no fixed body but the berth"));
}

#[test]
fn an_exercise_changes_no_bit_of_the_run() {
    let (mut with, mut assessment) = begun(&[]);
    let (mut without, _) = begun(&[]);
    for _ in 0..50 {
        with.step().expect("a step");
        assessment.update(&with);
        without.step().expect("a step");
    }
    assert_eq!(with.states(), without.states());
}

#[test]
fn the_cross_track_distance_counts_between_the_waypoints() {
    // Her midship is 11 m to port of the track, which goes north at 13.9 m west of the quay.
    let mut set = at(8.0, 0.0, 0.0, 0.0);
    set.push("exercise.limit.cross_track={ most = 1, worst = 21, points = 20 }".into());
    let set: Vec<Override> = set.iter().map(|s| Override::parse(s).expect("an override")).collect();
    let marked = |from_m: f64, to_m: f64| {
        let plan = format!(
            "{BERTHING}\n[plan.on]\nvessel = \"ship\"\n[[plan.on.waypoint]]\nposition = [{from_m}, -13.9]\n\
             [[plan.on.waypoint]]\nposition = [{to_m}, -13.9]\n"
        );
        let scenario = Scenario::parse_with(&plan, "berthing.toml", &set).expect("a scenario");
        let mut simulation = Simulation::new(scenario.setup).expect("a set-up");
        let mut assessment = Assessment::new(scenario.exercise.unwrap(), &simulation);
        steps(&mut simulation, &mut assessment, 1);
        assessment
    };
    let assessment = marked(-300.0, 300.0);
    let (off_m, whose, _) = worst(&assessment, Measure::CrossTrack).expect("on a leg");
    assert!((off_m - 11.0).abs() < 1e-3 && whose == Subject::Ship, "{off_m} {whose:?}");
    let cost = assessment.deductions().find(|of| of.limit.measure == Measure::CrossTrack);
    assert!((cost.expect("it is exceeded").points - 10.0).abs() < 1e-2);
    assert_eq!(worst(&marked(-900.0, -300.0), Measure::CrossTrack), None, "the plan is over");
    assert_eq!(worst(&marked(300.0, 900.0), Measure::CrossTrack), None, "the plan has not begun");
}

#[test]
fn the_way_to_go_to_the_mark_of_the_berth_is_positive_ahead() {
    let to_go_m = |heading_deg: f64, mark: &str| {
        let mut set = at(40.0, heading_deg, 0.0, 0.0);
        set.extend([mark.to_owned(), "body.ship.position=[-30, -56.9]".to_owned()]);
        // The tugs stay where they are when she heads south.
        set.extend(["forward", "after"].map(|tow| format!("line.{tow}_tow.length=300")));
        let set: Vec<&str> = set.iter().map(String::as_str).collect();
        let (simulation, assessment) = begun(&set);
        assessment.to_go_m(&simulation)
    };
    let of_ship = "exercise.mark={ at = [20, 1.5], of_ship = 10 }";
    // 10 m forward of her origin she is at 20 m south of the quay's middle; the mark is at 20 m north of it.
    assert!((to_go_m(0.0, of_ship).unwrap() - 40.0).abs() < 1e-9);
    // Heading south she has to go 60 m astern.
    assert!((to_go_m(180.0, of_ship).unwrap() + 60.0).abs() < 1e-9);
    // Her bow is 92 m forward of her origin.
    assert!((to_go_m(0.0, "exercise.mark={ at = [20, 1.5] }").unwrap() + 42.0).abs() < 1e-9);
    // At 10 degrees to the berth: along the berth.
    let cosine = libm::cos(10_f64.to_radians());
    assert!((to_go_m(10.0, of_ship).unwrap() - (50.0 - 10.0 * cosine)).abs() < 1e-9);
    assert_eq!(to_go_m(0.0, "exercise.hold=1"), None);
}
