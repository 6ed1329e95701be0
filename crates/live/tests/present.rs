//! The present state as a scenario file. The file gives the same state again, apart from what it says that it rounds
//! and leaves out.

use crate::support;

use std::path::Path;

use fenderline_live::{Fault, NamedOrder, OtherAction, Session, Source};
use fenderline_sim::anchor::AnchorPosition;
use fenderline_sim::{Change, OrderName, Verdict};

use support::{command, engine, go, rudder};

/// A session in a scenario of a folder. The files that the scenario names lie beside it.
fn open_of(scenario: &str, text: Option<String>) -> Session {
    let path = support::repository(scenario);
    let text = text.unwrap_or_else(|| std::fs::read_to_string(&path).expect("a scenario"));
    let beside = |name: &str| {
        let path: &Path = &path;
        std::fs::read_to_string(path.with_file_name(name)).map_err(|why| why.to_string())
    };
    let (source, _) = Source::collect("a.toml", text, vec![], beside).expect("a good scenario");
    Session::open(source).expect("a good set-up")
}

/// Checks that bodies are at the same places and have the same speeds. Positions are written to 0.1 mm, angles to 10⁻⁷
/// deg, speeds to 10⁻⁶ m/s. The tolerance is half a unit of the last digit in each coordinate.
fn same_places(before: &Session, after: &Session, scenario: &str) {
    let [before, after] = [before, after].map(Session::simulation);
    for (index, body) in before.setup().bodies.iter().enumerate() {
        let [one, other] = [before.states()[index], after.states()[index]];
        let off_m = (one.position_m - other.position_m).length();
        let turn = (one.heading_rad - other.heading_rad) / core::f64::consts::TAU;
        let off_rad = (turn - turn.round()) * core::f64::consts::TAU;
        let off_mps = (one.velocity_mps - other.velocity_mps).length();
        assert!(off_m < 1e-4, "{scenario}: {} is {off_m} m off", body.name);
        assert!(off_rad.abs() < 1e-8, "{scenario}: {} is {off_rad} rad off", body.name);
        // The heading turns the velocity: 10⁻⁹ of some m/s.
        assert!(off_mps < 1e-5, "{scenario}: {} is {off_mps} m/s off", body.name);
    }
}

#[test]
fn each_live_scenario_is_saved_and_begins_where_it_was() {
    for scenario in [
        "scenarios/live/berthing.toml",
        "scenarios/live/harbour.toml",
        "scenarios/live/moored_in_a_squall.toml",
        "scenarios/live/ship_to_ship.toml",
        "scenarios/live/tug_escort.toml",
        "scenarios/live/two_pilots_in_a_fairway.toml",
        "scenarios/live/unberthing.toml",
    ] {
        let mut session = open_of(scenario, None);
        go(&mut session, 600);
        let file = session.present_file("Saved").expect(scenario);
        let mut again = open_of(scenario, Some(file.text.clone()));
        assert_eq!(again.title(), "Saved");
        same_places(&session, &again, scenario);
        // A file that is saved from the start of a saved file is the same, except for the first comment.
        let keys = |text: &str| text.split_once("title = ").expect("a title").1.to_owned();
        let twice = again.present_file("Saved").expect(scenario);
        assert_eq!(keys(&twice.text), keys(&file.text), "{scenario}");
        go(&mut again, 10);
        let worst = again.simulation().verdict();
        assert!(
            worst <= session.simulation().verdict().max(Verdict::NoFenderTouched),
            "{scenario}: {worst:?}"
        );
    }
}

#[test]
fn a_ship_under_way_goes_on_as_she_would_have() {
    let scenario = "scenarios/live/berthing.toml";
    let mut session = open_of(scenario, None);
    command(&mut session, engine(0.4));
    command(&mut session, rudder(0.2));
    go(&mut session, 600);
    let mut again = open_of(scenario, Some(session.present_file("On").expect("a file").text));
    go(&mut session, 600);
    go(&mut again, 600);
    let [one, other] = [&session, &again].map(|of| of.simulation().states()[0]);
    // The ship's rudder begins amidships and takes some seconds to its angle, and the gusts begin anew. Within a minute
    // her place differs by less than a tenth of the way that she made.
    let way_m = 0.1 * 60.0 * one.velocity_mps.length();
    assert!((one.position_m - other.position_m).length() < way_m, "{one:?} {other:?}");
    assert!((one.velocity_mps - other.velocity_mps).length() < 0.1, "{one:?} {other:?}");
    let orders = &again.simulation().vessels()[0].orders;
    assert_eq!((orders.shaft, orders.rudder_rad), (0.4, 0.2));
}

#[test]
fn lines_weather_faults_and_what_is_planned_are_in_the_file() {
    let scenario = "scenarios/live/moored_in_a_squall.toml";
    let mut session = open_of(scenario, None);
    let lines: Vec<String> = session.info().lines.iter().map(|line| line.name.clone()).collect();
    go(&mut session, 300);
    for action in [
        OtherAction::Wind { speed_mps: 9.0, from_rad: 1.0, over_s: 0.0 },
        OtherAction::Wind { speed_mps: 15.0, from_rad: 2.0, over_s: 120.0 },
        OtherAction::Current { speed_mps: 0.5, to_rad: 3.0, over_s: 0.0 },
        OtherAction::Visibility { distance_m: Some(400.0), over_s: 0.0 },
        OtherAction::Fault { vessel: "ship".into(), fault: Fault::HeadingFrozen, on: true },
        OtherAction::PartLine { line: lines[1].clone() },
        OtherAction::Plan {
            at_s: 90.0,
            event: Box::new(OtherAction::PartLine { line: lines[2].clone() }),
        },
    ] {
        command(&mut session, action.into());
    }
    command(&mut session, NamedOrder::new(OrderName::LetGo, &lines[0]).into());
    go(&mut session, 300);
    let file = session.present_file("Squall").expect("a file");
    let mut again = open_of(scenario, Some(file.text.clone()));
    let of = |session: &Session, line: usize| session.simulation().lines()[line].clone();
    go(&mut again, 3);
    assert!(of(&again, 0).aboard, "{}", file.text);
    assert!(of(&again, 1).has_parted() && !of(&again, 2).has_parted());
    for (line, name) in lines.iter().enumerate().skip(2) {
        let [one, other] = [&session, &again].map(|of_session| of(of_session, line).load.tension_n);
        // The motion during a tenth of a second changes the tension little.
        assert!((one - other).abs() < 0.02 * one + 2e3, "{name}: {one} N, {other} N");
    }
    let frame = again.frame(0, Default::default());
    assert_eq!(frame.visibility_m, Some(400.0));
    assert_eq!(frame.vessels[0].faults, ["heading_frozen"]);
    assert!((frame.current.speed_mps - 0.5).abs() < 1e-6);
    let [begun, now] = [&session, &again].map(|of| {
        let wind = of.simulation().setup().world.environment.wind.clone();
        wind.expect("a wind").mean_at(of.simulation().time_s())
    });
    // The wind has gone a quarter of the way from 9 to 15 m/s. Three more steps of the change follow.
    assert!((begun.0 - 10.5).abs() < 0.01 && (now.0 - begun.0 - 0.015).abs() < 0.01, "{now:?}");
    let waits: Vec<f64> =
        again.planned().iter().filter(|of| of.state == "waits").map(|of| of.at_s).collect();
    assert_eq!(waits, [30.0]);
    go(&mut again, 300);
    assert!(of(&again, 2).has_parted());
}

#[test]
fn a_run_without_a_session_carries_out_the_events_of_the_file_too() {
    let text = std::fs::read_to_string(support::repository("scenarios/live/berthing.toml"))
        .expect("a scenario");
    let text = format!(
        "{text}\n[[event]]\nat = 5\nvessel = \"ship\"\nfault = \"engine_lost\"\n\n[[event]]\nat = 5\n\
         wind = {{ speed = 12, from = 0, over = 10 }}\n\n[[event]]\nat = 6\nline_parts = \"head\"\n"
    );
    let mut session = open_of("scenarios/live/berthing.toml", Some(text.clone()));
    let scenario = fenderline_scenario::Scenario::parse(&text, "a.toml").expect("a scenario");
    assert_eq!(scenario.setup.world.planned.len(), 3);
    assert!(matches!(scenario.setup.world.planned[2].change, Change::PartLine(_)));
    let mut run = fenderline_sim::Simulation::new(scenario.setup).expect("a set-up");
    let mut not_parted = 0;
    for tick in 0..200 {
        session.step().expect("a step");
        let record = run.step().expect("a step");
        let kind = fenderline_sim::WorldEventKind::LineNotParted;
        not_parted += record.world_events.iter().filter(|event| event.kind == kind).count();
        // The states are the same bit by bit, whether the session or the file carries out the events.
        assert_eq!(run.states(), session.simulation().states(), "{tick}");
        assert_eq!(run.vessels()[0].faults.engine_lost, tick >= 50, "{tick}");
    }
    assert_eq!(not_parted, 1, "a line on board cannot part, and this is reported");
    let wind = run.setup().world.environment.wind.as_ref().expect("a wind");
    assert_eq!(wind.mean_at(20.0), (12.0, 0.0));
}

#[test]
fn anchors_lie_where_they_are_with_their_chains() {
    let scenario = "scenarios/environment/anchored_in_wind_and_stream.toml";
    let mut session = open_of(scenario, None);
    go(&mut session, 3000);
    let file = session.present_file("At anchor").expect("a file");
    let again = open_of(scenario, Some(file.text.clone()));
    same_places(&session, &again, scenario);
    let mut lying = 0;
    for (one, other) in session.simulation().anchors().iter().zip(again.simulation().anchors()) {
        // Lengths and places are written to 0.1 mm.
        assert!((one.state.chain_m - other.state.chain_m).abs() < 1e-4, "{one:?} {other:?}");
        match (one.state.position, other.state.position) {
            (AnchorPosition::OnBottom(one), AnchorPosition::OnBottom(other)) => {
                assert!((one - other).length() < 1e-4);
                lying += 1;
            }
            (one, other) => assert_eq!(one, other),
        }
    }
    assert!(lying > 0, "{}", file.text);
}
