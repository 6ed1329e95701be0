//! Compares the names in messages and orders with `web/src/protocol.ts` and `web/src/orders.ts`.

use crate::support;

use std::collections::{BTreeMap, BTreeSet};

use fenderline_live::message::{self, Hello, Role, RunState};
use fenderline_live::{
    COMMAND_LIMITS, Conduct, Fault, OtherAction, Request, Session, Source, berth_info, library_info,
};
use fenderline_sim::OrderName;
use fenderline_sim::chart::{ChartKind, MarkColour, MarkMeaning, MarkShape, MarkSide};
use fenderline_sim::order::Argument;
use serde_json::Value;

/// The interfaces in the file: for each name its fields, and whether each field is optional.
fn interfaces(text: &str) -> BTreeMap<String, Vec<(String, bool)>> {
    let mut all = BTreeMap::new();
    let mut rest = text;
    while let Some(at) = rest.find("export interface ") {
        rest = &rest[at + "export interface ".len()..];
        let name = rest.split([' ', '{']).next().expect("a name").to_owned();
        let body = &rest[rest.find('{').expect("a body") + 1..];
        let mut fields = Vec::new();
        for line in body.lines().take_while(|line| !line.starts_with('}')) {
            // The formatter indents the interface's own fields by two spaces, and nested fields by more.
            let Some((key, _)) = line.strip_prefix("  ").and_then(|line| line.split_once(':'))
            else {
                continue;
            };
            if key.chars().all(|c| c.is_ascii_alphanumeric() || c == '_' || c == '?') {
                fields.push((key.trim_end_matches('?').to_owned(), key.ends_with('?')));
            }
        }
        all.insert(name, fields);
    }
    all
}

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

/// The words of all commands in the file, except orders.
fn other_commands(text: &str) -> BTreeSet<String> {
    let union = text.split("export interface Command {").nth(1).expect("the commands");
    let union = union.split("export type Fault").next().expect("their end");
    let words = union.split("do: \"").skip(1);
    words.map(|rest| rest.split('"').next().expect("a word").to_owned()).collect()
}

fn protocol() -> String {
    let path = support::repository("web/src/protocol.ts");
    std::fs::read_to_string(path).expect("the protocol")
}

fn has_fields(value: &Value, name: &str, interfaces: &BTreeMap<String, Vec<(String, bool)>>) {
    let fields = interfaces.get(name).unwrap_or_else(|| panic!("no interface {name}"));
    let ours: BTreeSet<&str> = value
        .as_object()
        .unwrap_or_else(|| panic!("{name}: {value}"))
        .keys()
        .map(String::as_str)
        .collect();
    let all: BTreeSet<&str> = fields.iter().map(|(name, _)| name.as_str()).collect();
    let needed = fields.iter().filter(|(_, may_lack)| !may_lack).map(|(name, _)| name.as_str());
    assert!(ours.is_subset(&all), "{name}: {ours:?} beside {all:?}");
    let needed: BTreeSet<&str> = needed.collect();
    assert!(needed.is_subset(&ours), "{name}: {ours:?} beside {needed:?}");
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
        chart: &info.chart,
        exercise: session.exercise_info(),
        links: Some(&links),
        library: Some(library_info()),
        deleted: Some(&[]),
    };
    let read = |text: &str| serde_json::from_str(text).expect("JSON");
    (read(&frame), read(&message::text(&hello)))
}

#[test]
fn frames_and_hellos_have_the_fields_of_the_protocol() {
    let text = protocol();
    let known = interfaces(&text);
    let mut session = support::open(
        "scenarios/berth/alongside_with_two_tugs.toml",
        &[
            "line.head.made_fast=\"0 s\"",
            "anchor={ port = { on = \"ship\", side = \"port\", hawse_height = 8, mass = 8000, chain_diameter = 0.076, chain_length = 300 } }",
            "exercise={ vessel = \"ship\", goal = \"alongside\", limit = { fender = { most = 0, points = 1 } } }",
        ],
    );
    // The session runs until the ship lies at the fenders, so that every part of a frame is filled.
    support::go(&mut session, 21_000);
    // The fault puts an alarm in the frame.
    let fault = OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on: true };
    support::command(&mut session, fault.into());
    let fault = OtherAction::TugOut { tug: "aft".into(), on: true };
    let at_s = session.simulation().time_s() + 60.0;
    support::command(&mut session, OtherAction::Plan { at_s, event: Box::new(fault) }.into());
    support::go(&mut session, 1);
    let planned = message::text(&session.planned()[0]);
    has_fields(&serde_json::from_str(&planned).expect("JSON"), "PlannedNow", &known);
    let (frame, hello) = messages(&session);
    assert_eq!((&frame["type"], &hello["type"]), (&"frame".into(), &"hello".into()));
    has_fields(&frame, "Frame", &known);
    has_fields(&hello, "Hello", &known);
    has_fields(&hello["limits"], "CommandLimits", &known);
    has_fields(&hello["library"], "LibraryInfo", &known);
    each(&hello["library"], "vessels").for_each(|value| has_fields(value, "LibraryVessel", &known));
    has_fields(&frame["run"], "RunState", &known);
    for (key, name) in [
        ("vessels", "VesselNow"),
        ("fenders", "FenderNow"),
        ("contacts", "ContactNow"),
        ("lines", "LineNow"),
        ("anchors", "AnchorNow"),
        ("tugs", "TugNow"),
        ("alarms", "Alarm"),
    ] {
        each(&frame, key).for_each(|value| has_fields(value, name, &known));
    }
    for (key, name) in [
        ("bodies", "BodyInfo"),
        ("vessels", "VesselInfo"),
        ("fenders", "FenderInfo"),
        ("lines", "LineInfo"),
        ("anchors", "AnchorInfo"),
        ("tugs", "TugInfo"),
        ("orders", "OrderInfo"),
        ("telegraph", "TelegraphInfo"),
    ] {
        each(&hello, key).for_each(|value| has_fields(value, name, &known));
    }
    has_fields(&frame["verdict"], "VerdictNow", &known);
    let history: Value = serde_json::from_str(&message::text(
        &session.history(None, &Role::PILOT).expect("it is kept"),
    ))
    .expect("the history as JSON");
    assert_eq!(history["type"], "history");
    has_fields(&history, "Past", &known);
    each(&history, "events").for_each(|value| has_fields(value, "Then", &known));
    assert_eq!(each(&history, "t_s").count(), each(&history, "of_energy").count());
    has_fields(&frame["exercise"], "ExerciseNow", &known);
    has_fields(&frame["marks"], "ExerciseMarks", &known);
    each(&frame["marks"], "limits").for_each(|value| has_fields(value, "LimitNow", &known));
    has_fields(&hello["exercise"], "ExerciseInfo", &known);
    each(&hello["exercise"], "limits").for_each(|value| has_fields(value, "LimitInfo", &known));
    assert_eq!(hello["exercise"]["place"], Value::Null, "her goal has none");
    let berth = &frame["vessels"][0]["berth"];
    has_fields(berth, "BerthNow", &known);
    // Eight compressed fenders hold the ship, who is nearly at rest.
    assert!(berth["bow_m"].as_f64().is_some_and(|m| m < 0.0 && m > -1.0), "{berth}");
    let mut pressed = each(&frame, "fenders").filter_map(|fender| fender["reaction_n"].as_f64());
    assert!(pressed.any(|n| n > 0.0), "wind and lines press her on");
    assert_eq!(hello["role"], serde_json::json!({ "name": "tugmaster", "tug": "aft" }));
    assert_eq!(hello["claims"][1]["control"], serde_json::json!({ "tug": "forward" }));
    for (reply, name) in [
        (message::Reply::Planned { events: session.planned() }, "Planned"),
        (message::Reply::Ack { id: 1, tick: 2 }, "Ack"),
        (message::Reply::Refused { id: None, reason: "x".into() }, "Refused"),
        (message::Reply::Notice { text: "x".into() }, "Notice"),
        (
            session.trial(&[support::rudder(0.1)], 10.0).expect("a good order").run(1, |_| true),
            "Trial",
        ),
        (session.prediction().expect("a ship").run(5.0, 1.0, |_| true), "Prediction"),
    ] {
        let value: Value = serde_json::from_str(&message::text(&reply)).expect("JSON");
        has_fields(&value, name, &known);
        let first = &known[name][0];
        assert_eq!(first.0, "type");
        assert_eq!(value["type"], name.to_lowercase());
    }
}

#[test]
fn a_passage_has_the_fields_of_the_protocol() {
    let near = "passing.kcs.time=\"30 s\"";
    let mut session = support::open("scenarios/live/moored_while_a_ship_passes.toml", &[near]);
    support::go(&mut session, 1);
    let (frame, _) = messages(&session);
    let known = interfaces(&protocol());
    each(&frame, "passages").for_each(|value| has_fields(value, "PassageNow", &known));
}

#[test]
fn a_passage_plan_has_the_fields_of_the_protocol() {
    let mut session = support::planned();
    support::go(&mut session, 1);
    let (frame, hello) = messages(&session);
    let known = interfaces(&protocol());
    let plan = &hello["vessels"][0]["plan"];
    has_fields(plan, "PlanInfo", &known);
    each(plan, "waypoints").for_each(|value| has_fields(value, "WaypointInfo", &known));
    each(plan, "wheel_overs").for_each(|value| has_fields(value, "WheelOverInfo", &known));
    has_fields(&frame["vessels"][0]["plan"], "PlanNow", &known);
}

#[test]
fn the_chart_has_the_fields_and_words_of_the_protocol() {
    let file = "scenarios/live/harbour.toml";
    let text = std::fs::read_to_string(support::repository(file)).expect("the scenario");
    let beside = |name: &str| {
        std::fs::read_to_string(support::repository(&format!("scenarios/live/{name}")))
            .map_err(|why| why.to_string())
    };
    let (source, _) = Source::collect("harbour.toml", text, vec![], beside).expect("a scenario");
    let session = Session::open(source).expect("a set-up");
    let (_, hello) = messages(&session);
    let text = protocol();
    let known = interfaces(&text);
    each(&hello, "chart").for_each(|value| has_fields(value, "ChartInfo", &known));
    let interface = text.split("export interface ChartInfo {").nth(1).expect("the chart");
    let interface = interface.split("\n}").next().expect("its end");
    let kinds = ChartKind::ALL.map(ChartKind::word).into_iter();
    let marks = MarkColour::ALL.map(MarkColour::word).into_iter();
    let meanings = MarkMeaning::ALL.map(MarkMeaning::word).into_iter();
    let forms = MarkShape::ALL.map(MarkShape::word).into_iter();
    let marks = marks.chain(MarkSide::ALL.map(MarkSide::word)).chain(meanings).chain(forms);
    for word in kinds.chain(marks) {
        assert!(interface.contains(&format!("\"{word}\"")), "{word}");
    }
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
fn the_other_commands_of_the_protocol_are_those_of_the_program() {
    let words = other_commands(&protocol());
    for word in &words {
        let text = format!(r#"{{"type":"command","id":1,"action":{{"do":"{word}"}}}}"#);
        if let Err(reason) = Request::parse(&text).1 {
            assert!(!reason.to_string().contains("unknown variant"), "{word}: {reason}");
        }
    }
    let text = r#"{"type":"command","id":1,"action":{"do":"fly"}}"#;
    let reason = Request::parse(text).1.expect_err("no such command").to_string();
    let ours = reason.split('`').skip(3).step_by(2).chain(Conduct::WORDS.iter().copied());
    assert_eq!(words, ours.map(str::to_owned).collect());
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
