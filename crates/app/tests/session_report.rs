//! `fenderline run` and `fenderline report` of a session that people steered.

use crate::support;

use std::path::Path;

use fenderline_live::{Action, Fault, NamedOrder, OtherAction, Session, Source};
use fenderline_sim::OrderName;
use support::{Workplace, contains_all};

/// Steps of the session, of 0.1 s.
const TICKS: u64 = 300;

/// The pilot's orders to the ship: tick, word, argument and its value.
const ORDERS: [(u64, OrderName, &str, f64); 3] = [
    (0, OrderName::Engine, "share", 0.4),
    (20, OrderName::Rudder, "angle", 0.3),
    (90, OrderName::Rudder, "angle", -0.2),
];

/// A bulk carrier off her berth with two tugs; the scenario has no orders.
fn harbour() -> String {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/live/berthing.toml");
    std::fs::read_to_string(file).expect("a scenario")
}

fn session() -> Session {
    let none = |name: &str| Err(format!("{name}: none is needed"));
    let (source, _) =
        Source::collect("berthing.toml", harbour(), vec![], none).expect("a scenario");
    Session::open(source).expect("a set-up")
}

/// Steps the session to a tick, with the pilot's orders on the way.
fn steer(session: &mut Session, to_tick: u64) {
    while session.tick() < to_tick {
        let tick = session.tick();
        for (_, order, name, value) in ORDERS.iter().filter(|(at, ..)| *at == tick) {
            let order = NamedOrder::new(*order, "ship").number(name, *value);
            session.command("pilot 1", 0, order.into()).expect("a good order");
        }
        session.step().expect("a good step");
    }
}

fn recording(mut session: Session) -> String {
    session.mark();
    session.take_lines() + &session.end_line()
}

#[test]
fn tables_of_a_session_are_those_of_a_scenario_with_the_same_orders() {
    let place = Workplace::new("session_tables");
    let mut live = session();
    steer(&mut live, TICKS);
    place.write("a.session.jsonl", recording(live).as_bytes());
    let orders: String = ORDERS
        .iter()
        .map(|(tick, order, _, value)| {
            let word = order.spec().word;
            let at_s = *tick as f64 * 0.1;
            let unit = if word == "rudder" { "\"" } else { "" };
            let value = if word == "rudder" {
                format!("{unit}{value} rad{unit}")
            } else {
                format!("{value}")
            };
            format!("[[order]]\nat = {at_s}\nvessel = \"ship\"\n{word} = {value}\n")
        })
        .collect();
    place.write("same.toml", (harbour() + "\n" + &orders).as_bytes());
    let steered = place.run(&["run", "a.session.jsonl"]);
    assert_eq!(steered.code, 0, "{}", steered.stderr);
    let same = place.run(&["run", "same.toml", "--set", "time.duration=30"]);
    assert_eq!(same.code, 0, "{}", same.stderr);
    for table in ["bodies.csv", "vessels.csv", "tugs.csv", "energy.csv", "azimuths.csv"] {
        let name = |of: &str| format!("out/{of}/{table}");
        if !place.exists(&name("same")) {
            assert!(!place.exists(&name("a")), "{table}");
            continue;
        }
        assert!(place.read(&name("a")) == place.read(&name("same")), "{table}");
    }
    let summary = place.json("out/a/summary.json");
    assert_eq!(summary["duration_s"], 30.0);
    assert_eq!(summary["interrupted"], false);
    assert_eq!(summary["session"]["log"].as_array().map(Vec::len), Some(3));
    assert_eq!(
        place.text("out/a/log.csv").lines().nth(2),
        Some("2.0,,command,pilot 1,ship: rudder 17.2° to starboard,")
    );
    assert!(!place.exists("out/same/log.csv"));
}

#[test]
fn a_report_of_a_session_has_its_commands_faults_and_alarms() {
    let place = Workplace::new("session_report");
    let mut live = session();
    steer(&mut live, 100);
    let fault = OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on: true };
    live.command("instructor 1", 0, fault.into()).expect("a fault");
    let tug: Action = serde_json::from_str(
        r#"{"do":"tug","tug":"forward_tug","order":"push","power":0.5,"lead":"square","place":"nearest"}"#,
    )
    .expect("an order in words");
    live.command("pilot 1", 0, tug).expect("an order to a tug");
    steer(&mut live, 120);
    let seen = OtherAction::Acknowledge { key: "rudder stuck ship".into() };
    live.command("pilot 1", 0, seen.into()).expect("there is an alarm");
    let note = OtherAction::Note { text: "late with the <tug>".into() };
    live.command("instructor 1", 0, note.into()).expect("a note");
    live.command("instructor 1", 0, OtherAction::Note { text: String::new() }.into())
        .expect("a mark");
    steer(&mut live, TICKS);
    live.rewind(50).expect("it is there");
    live.branch().expect("a branch");
    steer(&mut live, 150);
    place.write("a.session.jsonl", recording(live).as_bytes());
    let report = place.run(&["report", "a.session.jsonl", "--branch", "0"]);
    assert_eq!(report.code, 0, "{}", report.stderr);
    let page = place.text("a.html");
    contains_all(
        &page,
        &[
            "a.session.jsonl, branch 0",
            "Log of the session",
            "ship: rudder 17.2° to starboard",
            "ship: rudder stuck",
            "forward_tug: push 50 %, square",
            "instructor 1",
            "to the end",
            "0:12.0, pilot 1",
            "acknowledgement",
            "late with the &lt;tug&gt;",
            "2 notes",
            "The same recording gives this page again",
        ],
    );
    // The branch that was steered last has the pilot's orders up to its begin, and no fault.
    let last = place.run(&["report", "a.session.jsonl", "--html", "last.html"]);
    assert_eq!(last.code, 0, "{}", last.stderr);
    let page = place.text("last.html");
    contains_all(&page, &["a.session.jsonl, branch 1", "ship: rudder 17.2° to starboard"]);
    assert!(!page.contains("rudder stuck"));
}

/// What an instructor asks first comes before the assumptions and results, and the wind is not that of the start alone.
#[test]
fn the_log_is_at_the_front_of_the_report_and_the_wind_is_told_with_its_ramp() {
    let place = Workplace::new("session_order");
    let mut live = session();
    steer(&mut live, 50);
    let wind = OtherAction::Wind { speed_mps: 14.0, from_rad: 4.0_f64.to_radians(), over_s: 10.0 };
    live.command("instructor 1", 0, wind.into()).expect("it may blow");
    steer(&mut live, TICKS);
    place.write("a.session.jsonl", recording(live).as_bytes());
    let report = place.run(&["report", "a.session.jsonl"]);
    assert_eq!(report.code, 0, "{}", report.stderr);
    let page = place.text("a.html");
    let at = |heading: &str| {
        page.find(&format!("<h2>{heading}</h2>")).unwrap_or_else(|| panic!("no {heading}"))
    };
    assert!(at("Log of the session") < at("Results") && at("Results") < at("Assumptions"));
    contains_all(
        &page,
        &[
            "; changing from 0:05.0 until 0:15.0 to 14 m/s (27.2 kn) from 004°",
            " to 14 m/s (",
            "at the end from 004°",
        ],
    );
}

/// The cells of the table of branches, row by row.
fn table_of_branches(page: &str) -> Vec<Vec<String>> {
    let (_, section) = page.split_once("Branches side by side").expect("the section");
    let (_, body) = section.split_once("<tbody>").expect("the table");
    let (body, _) = body.split_once("</tbody>").expect("its end");
    let text = |cell: &str| {
        let (_, rest) = cell.split_once('>').expect("the tag's end");
        rest.split('<').next().unwrap_or("").trim().to_owned()
    };
    let cells = |row: &str| row.split("<td").skip(1).map(text).collect();
    body.split("<tr").skip(1).map(cells).collect()
}

/// The ship drifts towards the fenders, 4 m off; in the branch she is pushed. Each number of the table is that of `fenderline run` of the
/// branch.
#[test]
fn the_table_of_branches_has_the_numbers_of_the_run_of_each_branch() {
    let place = Workplace::new("session_branches");
    let set = [
        "environment.wind.speed=0",
        "environment.wind.gusts=false",
        "body.ship.position=[0, -20.9]",
        "body.ship.heading=\"0 deg\"",
        "body.ship.velocity={ surge = 0, sway = 0.25 }",
        "body.forward_tug.position=[40, -90]",
        "body.after_tug.position=[-80, -90]",
    ];
    let set = set.map(str::to_owned).to_vec();
    let none = |name: &str| Err(format!("{name}: none is needed"));
    let (source, _) = Source::collect("berthing.toml", harbour(), set, none).expect("a scenario");
    let mut live = Session::open(source).expect("a set-up");
    while live.tick() < 400 {
        live.step().expect("a good step");
    }
    live.rewind(100).expect("it is there");
    live.branch().expect("a branch");
    let fault = OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on: true };
    live.command("instructor 1", 0, fault.into()).expect("a fault");
    steer(&mut live, 350);
    place.write("a.session.jsonl", recording(live).as_bytes());
    let report = place.run(&["report", "a.session.jsonl", "--allow-failures"]);
    assert_eq!(report.code, 0, "{}", report.stderr);
    let rows = table_of_branches(&place.text("a.html"));
    assert_eq!(rows.len(), 2, "{rows:?}");
    for (branch, row) in rows.iter().enumerate() {
        let (number, out) = (branch.to_string(), format!("branch_{branch}"));
        let run =
            ["run", "a.session.jsonl", "--branch", &number, "--out", &out, "--allow-failures"];
        let run = place.run(&run);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let summary = place.json(&format!("{out}/summary.json"));
        let largest = |list: &str, key: &str| {
            let shares = summary[list].as_array().into_iter().flatten();
            shares
                .filter_map(|of| of[key].as_f64())
                .fold(0.0_f64, |most, share| if share > most { share } else { most })
        };
        let log = place.text(&format!("{out}/log.csv"));
        let count =
            |kind: &str| log.lines().filter(|line| line.split(',').nth(2) == Some(kind)).count();
        let ends = summary["duration_s"].as_f64().expect("a duration");
        println!("{row:?}");
        assert_eq!(row[2], format!("0:{ends:.1}"));
        assert_eq!(row[3], summary["verdict"]["text"].as_str().expect("a verdict"));
        let score = summary["exercise"]["score"].as_f64().expect("a score");
        assert!(row[4].starts_with(&format!("{score:.1} ")), "{row:?} {score}");
        assert_eq!(row[6], format!("{:.0}", 100.0 * largest("fenders", "share_of_rated_energy")));
        assert_eq!(row[7], format!("{:.0}", 100.0 * largest("lines", "share_of_break_load")));
        assert_eq!(row[8], count("command").to_string(), "{log}");
        assert_eq!(row[9], (count("alarm") + count("caution")).to_string(), "{log}");
        // She drifts at 0.25 m/s without a rudder: both ends close at what is left of it.
        assert_eq!(row[5], "0.25");
    }
    assert_eq!((rows[0][0].as_str(), rows[0][1].as_str()), ("First run", "the start"));
    assert_eq!((rows[1][0].as_str(), rows[1][1].as_str()), ("Branch 1", "the first run at 0:10.0"));
    assert_eq!((rows[0][2].as_str(), rows[1][2].as_str()), ("0:40.0", "0:35.0"));
}

#[test]
fn a_session_cannot_be_changed_and_a_torn_one_is_reported_up_to_its_end() {
    let place = Workplace::new("session_mistakes");
    let mut live = session();
    steer(&mut live, 40);
    let whole = recording(live);
    place.write("a.session.jsonl", whole.as_bytes());
    for (args, words) in [
        (
            &["run", "a.session.jsonl", "--set", "time.step=0.2"][..],
            "`time.step` cannot be changed",
        ),
        (&["run", "a.session.jsonl", "--branch", "3"], "there is no branch 3"),
        (&["run", "berthing.toml", "--branch", "0"], "is not a recorded session"),
    ] {
        place.write("berthing.toml", harbour().as_bytes());
        let run = place.run(args);
        assert_eq!(run.code, 2, "{args:?}");
        contains_all(&run.stderr, &[words]);
        assert!(!place.exists("out/a"), "{args:?}");
    }
    let interval = place.run(&["run", "a.session.jsonl", "--interval", "1 s", "--out", "whole"]);
    assert_eq!(interval.code, 0, "{}", interval.stderr);
    assert_eq!(place.json("whole/summary.json")["session"]["is_complete"], true);
    place.write("torn.session.jsonl", &whole.as_bytes()[..whole.len() - 20]);
    let torn = place.run(&["run", "torn.session.jsonl"]);
    assert_eq!(torn.code, 0, "{}", torn.stderr);
    contains_all(&torn.stderr, &["its last line is incomplete"]);
    assert_eq!(place.json("out/torn/summary.json")["session"]["is_complete"], false);
    let damaged = whole.replacen("\"value\"", "\"valve\"", 1).replacen("berthing", "berthink", 1);
    place.write("damaged.session.jsonl", damaged.as_bytes());
    let run = place.run(&["run", "damaged.session.jsonl"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    // A session that has no steps.
    place.write("empty.session.jsonl", recording(session()).as_bytes());
    contains_all(&place.run(&["run", "empty.session.jsonl"]).stderr, &["the session has no steps"]);
}

/// Prints the time of the report of a session of thirty minutes, in which the ship is pushed to her berth:
/// `cargo test --release -p fenderline --test all session_report:: -- --ignored --nocapture`.
#[test]
#[ignore = "a measurement"]
fn the_report_of_thirty_minutes() {
    let place = Workplace::new("session_long");
    let mut live = session();
    let mut give = |tick: u64, command: &str| {
        steer(&mut live, tick);
        let action: Action = serde_json::from_str(command).expect("a command");
        live.command("pilot 1", 0, action).expect("a good command");
    };
    give(100, r#"{"do":"tug","tug":"forward_tug","order":"push","power":0.3}"#);
    give(110, r#"{"do":"tug","tug":"after_tug","order":"push","power":0.3}"#);
    give(600, r#"{"do":"engine","vessel":"ship","share":-0.3}"#);
    give(1500, r#"{"do":"engine","vessel":"ship","share":0}"#);
    give(9000, r#"{"do":"fault","vessel":"ship","fault":"engine_lost","on":true}"#);
    give(9600, r#"{"do":"fault","vessel":"ship","fault":"engine_lost","on":false}"#);
    give(17_000, r#"{"do":"wind","speed_mps":12,"from_rad":3.14}"#);
    steer(&mut live, 18_000);
    place.write("long.session.jsonl", recording(live).as_bytes());
    let began = std::time::Instant::now();
    let run = place.run(&["report", "long.session.jsonl", "--allow-failures"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    println!("report of 30 minutes: {:.2} s", began.elapsed().as_secs_f64());
}
