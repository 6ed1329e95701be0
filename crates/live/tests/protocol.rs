//! What messages hold in sessions, and the names of orders in `web/src/orders.ts`.

use crate::support;

use std::collections::{BTreeMap, BTreeSet};

use fenderline_live::message::{self, Hello, Role, RunState};
use fenderline_live::{
    COMMAND_LIMITS, Conduct, Request, Session, Source, berth_info, library_info,
};
use fenderline_sim::OrderName;
use fenderline_sim::order::Argument;
use serde_json::Value;

/// The orders in the file with their fields.
fn orders(text: &str) -> BTreeMap<String, BTreeSet<String>> {
    let body = text.split("export interface Orders {").nth(1).expect("the orders");
    let body = body.split("\n}").next().expect("their end");
    let rows = body.lines().filter_map(|line| line.trim().split_once(": {"));
    rows.map(|(name, fields)| {
        let fields = fields.split(';').filter_map(|field| field.split_once(':'));
        (
            name.to_owned(),
            fields.map(|(field, _)| field.trim().trim_end_matches('?').to_owned()).collect(),
        )
    })
    .collect()
}

fn each<'v>(value: &'v Value, key: &str) -> impl Iterator<Item = &'v Value> {
    let list = value[key].as_array().unwrap_or_else(|| panic!("{key}"));
    assert!(!list.is_empty(), "{key} is empty: nothing is tested");
    list.iter()
}

fn messages(session: &Session) -> (Value, Value) {
    let info = session.info();
    let run = RunState { pace: 1.0, ..RunState::default() };
    let frame = message::text(&session.frame(7, run));
    let events = [message::EventNow { t_s: 1.0, text: "x".into() }];
    let frame = message::with_events(
        &frame,
        &events,
        session.exercise_marks().map(|marks| message::text(&marks)).as_deref(),
    );
    let claims: Vec<message::Claim> = session
        .cast()
        .controls()
        .into_iter()
        .map(|control| message::Claim { control, holder: None, connected: false })
        .collect();
    let links = [message::Link { role: Role::PILOT, path: "/".into() }];
    let hello = Hello {
        protocol: message::PROTOCOL,
        role: &Role::Tugmaster { tug: "aft".into() },
        title: session.title(),
        file: &session.source().file,
        step_s: 0.1,
        bodies: &info.bodies,
        vessels: &info.vessels,
        fenders: &info.fenders,
        lines: &info.lines,
        anchors: &info.anchors,
        bollards: &info.bollards,
        tugs: &info.tugs,
        traffic: &info.traffic,
        orders: &info.orders,
        telegraph: &info.telegraph,
        limits: COMMAND_LIMITS,
        mine: vec![],
        claims: &claims,
        gallery: &[],
        berth: info.berth.as_ref().map(berth_info),
        depth_m: info.depth_m,
        highest_water_m: info.highest_water_m,
        clearance_datum_m: info.clearance_datum_m,
        sea: &info.sea,
        daylight: info.daylight,
        rain: info.rain,
        chart: &info.chart,
        exercise: session.exercise_info(),
        ghost: None,
        links: Some(&links),
        library: Some(library_info()),
        deleted: Some(&[]),
    };
    let read = |text: &str| serde_json::from_str(text).expect("JSON");
    (read(&frame), read(&message::text(&hello)))
}

#[test]
fn a_ship_at_her_berth_is_shown_with_her_distances_the_pressed_fenders_and_the_history() {
    let mut session = support::open(
        "scenarios/berth/alongside_with_two_tugs.toml",
        &[
            "line.head.made_fast=\"0 s\"",
            "exercise={ vessel = \"ship\", goal = \"alongside\", limit = { fender = { most = 0, points = 1 } } }",
        ],
    );
    support::go(&mut session, 21_000);
    let (frame, hello) = messages(&session);
    assert_eq!((&frame["type"], &hello["type"]), (&"frame".into(), &"hello".into()));
    let history: Value = serde_json::from_str(&message::text(
        &session.history(None, &Role::PILOT).expect("it is kept"),
    ))
    .expect("the history as JSON");
    assert_eq!(history["type"], "history");
    assert_eq!(each(&history, "t_s").count(), each(&history, "of_energy").count());
    assert_eq!(each(&frame["marks"], "limits").count(), 1);
    assert_eq!(hello["exercise"]["place"], Value::Null, "her goal has none");
    let berth = &frame["vessels"][0]["berth"];
    // Eight compressed fenders hold the ship, who is nearly at rest.
    assert!(berth["bow_m"].as_f64().is_some_and(|m| m < 0.0 && m > -1.0), "{berth}");
    let mut pressed = each(&frame, "fenders").filter_map(|fender| fender["reaction_n"].as_f64());
    assert!(pressed.any(|n| n > 0.0), "wind and lines press her on");
    assert_eq!(hello["role"], serde_json::json!({ "name": "tugmaster", "tug": "aft" }));
    assert_eq!(hello["claims"][1]["control"], serde_json::json!({ "tug": "forward" }));
}

#[test]
fn a_passing_ship_is_shown_beside_the_moored_one() {
    let near = "passing.kcs.time=\"30 s\"";
    let mut session = support::open("scenarios/live/moored_while_a_ship_passes.toml", &[near]);
    support::go(&mut session, 1);
    let (frame, _) = messages(&session);
    assert_eq!(each(&frame, "passages").count(), 1);
}

#[test]
fn a_line_between_a_tug_and_the_ship_is_a_towline_and_one_to_a_quay_is_not() {
    let towlines = |file: &str| -> Vec<String> {
        let (_, hello) = messages(&support::open(file, &[]));
        let all = each(&hello, "lines").filter(|line| line["is_towline"] == true);
        all.map(|line| line["name"].as_str().expect("a name").to_owned()).collect()
    };
    assert_eq!(towlines("scenarios/live/berthing.toml"), ["forward_tow", "after_tow"]);
    // Six lines are fast at the quay from the start: once they were taken for towlines.
    assert_eq!(towlines("scenarios/live/moored_while_a_ship_passes.toml"), [""; 0]);
}

/// The bars of the lines had a frame of all tensions as the goal, where the goal asks for none.
#[test]
fn a_goal_without_tensions_asks_for_none() {
    let file = "scenarios/live/berthing.toml";
    let tension = |overrides: &[&str]| {
        messages(&support::open(file, overrides)).1["exercise"]["tension"].clone()
    };
    assert_eq!(tension(&[])["least_n"], 2e4);
    let exercise = "exercise={ vessel = \"ship\", goal = \"all_fast\" }";
    assert_eq!(tension(&[exercise]), Value::Null);
}

#[test]
fn a_quay_from_the_chart_has_its_corners() {
    let file = "scenarios/live/harbour.toml";
    let text = std::fs::read_to_string(support::repository(file)).expect("the scenario");
    let beside = |name: &str| {
        std::fs::read_to_string(support::repository(&format!("scenarios/live/{name}")))
            .map_err(|why| why.to_string())
    };
    let (source, _) = Source::collect("harbour.toml", text, vec![], beside).expect("a scenario");
    let session = Session::open(source).expect("a set-up");
    let (_, hello) = messages(&session);
    // The quay has the corners of the chart.
    let quay = each(&hello, "bodies").find(|body| body["name"] == "quay").expect("a quay");
    assert_eq!(quay["outline"].as_array().map(Vec::len), Some(8));
}

#[test]
fn the_orders_of_the_protocol_are_those_of_the_table_field_by_field() {
    let table = OrderName::ALL.iter().map(|order| {
        let spec = order.spec();
        let target = std::iter::once(spec.target.word().to_owned());
        (spec.word.to_owned(), target.chain(spec.arguments.iter().map(Argument::field)).collect())
    });
    let page = std::fs::read_to_string(support::repository("web/src/orders.ts"));
    assert_eq!(
        orders(&page.expect("the page's orders")),
        table.collect::<BTreeMap<String, BTreeSet<String>>>()
    );
}

#[test]
fn the_words_of_all_commands_to_the_session_are_read() {
    for word in Conduct::WORDS {
        let text = format!(r#"{{"type":"command","id":1,"action":{{"do":"{word}"}}}}"#);
        if let Err(reason) = Request::parse(&text).1 {
            assert!(!reason.to_string().contains("unknown variant"), "{word}: {reason}");
        }
    }
}

#[test]
fn a_prediction_is_her_path_without_further_orders() {
    let mut session = support::harbour();
    support::command(&mut session, support::rudder(0.2));
    support::command(&mut session, support::engine(0.3));
    support::go(&mut session, 50);
    let message::Reply::Prediction { tick, paths } =
        session.prediction().expect("a ship").run(60.0, 10.0, |_| true)
    else {
        panic!("a prediction")
    };
    let [message::ShipPath { vessel: 0, path }] = &paths[..] else { panic!("{paths:?}") };
    assert_eq!((tick, path.len()), (50, 7));
    for &[t_s, north_m, east_m, heading_rad] in path {
        let state = session.simulation().states()[0];
        assert_eq!(t_s, session.simulation().time_s());
        assert_eq!(
            [north_m, east_m, heading_rad],
            [state.position_m.x, state.position_m.y, state.heading_rad]
        );
        support::go(&mut session, 100);
    }
}

/// The guide names every type of message, every role, and the version.
#[test]
fn the_guide_of_the_protocol_names_what_the_pages_know() {
    let guide = include_str!("../../../docs/guides/protocol.md");
    let pages = include_str!("../../../web/src/protocol.ts");
    let mut words: BTreeSet<&str> = BTreeSet::new();
    for key in ["type: \"", "{ name: \""] {
        words.extend(pages.split(key).skip(1).filter_map(|rest| rest.split('"').next()));
    }
    for word in ["hello", "frame", "history", "refused", "command", "tugmaster"] {
        assert!(words.contains(word), "{word} is not in web/src/protocol.ts: {words:?}");
    }
    let is_named = |word: &&str| {
        guide.contains(&format!("`{word}`")) || guide.contains(&format!("\"{word}\""))
    };
    let missing: Vec<&str> = words.iter().copied().filter(|word| !is_named(word)).collect();
    assert_eq!(missing, Vec::<&str>::new(), "docs/guides/protocol.md does not name them");
    assert!(guide.contains(&format!("describes version {}.", message::PROTOCOL)));
}
