//! Replay, rewinding and branches give the same bits. A refused command changes nothing.

use crate::support;

use fenderline_live::message::Role;
use fenderline_live::{Action, Fault, OtherAction, Request, Session};
use fenderline_sim::OrderName;
use fenderline_sim::order::{Lead, SidePlace, TugWord, TugWords};
use proptest::prelude::*;
use support::{command, engine, go, harbour, open, order, replay, rudder, saved};

fn commands() -> Vec<Action> {
    vec![
        rudder(0.3),
        rudder(-0.6),
        engine(0.4),
        engine(-0.7),
        order(OrderName::Thruster, "ship").name("name", "bow").number("power", 0.9).into(),
        order(OrderName::Course, "ship").number("heading", 0.2).into(),
        order(OrderName::Speed, "ship").number("speed", 1.5).into(),
        order(OrderName::Hands, "ship").into(),
        order(OrderName::Push, "forward").number("force", 3e5).number("direction", 1.5).into(),
        order(OrderName::StandBy, "aft").into(),
        order(OrderName::Heave, "head").number("rate", 0.2).into(),
        order(OrderName::LetGo, "head").into(),
        words("aft", TugWord::Pull),
        OtherAction::ApproachLimit { speed_mps: 0.2 }.into(),
        OtherAction::Wind { speed_mps: 17.0, from_rad: 4.0, over_s: 0.0 }.into(),
        OtherAction::Current { speed_mps: 0.8, to_rad: 1.0, over_s: 0.0 }.into(),
        OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on: true }.into(),
        OtherAction::Wind { speed_mps: 4.0, from_rad: 1.0, over_s: 9.0 }.into(),
        OtherAction::Current { speed_mps: 0.3, to_rad: 3.0, over_s: 12.0 }.into(),
        OtherAction::Fault { vessel: "ship".into(), fault: Fault::FollowUpLost, on: true }.into(),
        OtherAction::TugOut { tug: "aft".into(), on: true }.into(),
        OtherAction::PartLine { line: "head".into() }.into(),
        planned(6.0, Fault::EngineLost),
        planned(15.0, Fault::RudderStuck),
        OtherAction::CancelPlanned { id: 1 }.into(),
        OtherAction::Fault { vessel: "ship".into(), fault: Fault::Blackout, on: true }.into(),
        OtherAction::Fault { vessel: "ship".into(), fault: Fault::Blackout, on: false }.into(),
    ]
}

/// A fault that is planned for a given time.
fn planned(at_s: f64, fault: Fault) -> Action {
    let event = Box::new(OtherAction::Fault { vessel: "ship".into(), fault, on: true });
    OtherAction::Plan { at_s, event }.into()
}

/// An order in words to a tug, at half her power.
fn words(tug: &str, word: TugWord) -> Action {
    let (lead, place) = (Lead::default(), SidePlace::default());
    Action::tug(tug, TugWords { word, power: 0.5, lead, place })
}

/// A random command to a session.
#[derive(Clone, Debug)]
enum UserAction {
    Steps(u64),
    Command(usize),
    Rewind(f64),
    Branch,
    Show(usize),
}

fn user_action() -> impl Strategy<Value = UserAction> {
    prop_oneof![
        4 => (1..180_u64).prop_map(UserAction::Steps),
        4 => (0..commands().len()).prop_map(UserAction::Command),
        2 => (0.0..1.0).prop_map(UserAction::Rewind),
        1 => Just(UserAction::Branch),
        1 => (0..4_usize).prop_map(UserAction::Show),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// The replay of any session gives the end of every branch, bit for bit. Rewinding in any order does so too. A
    /// refused command leaves no trace.
    #[test]
    fn a_session_replays_to_the_same_bits(actions in prop::collection::vec(user_action(), 1..40)) {
        let mut session = harbour();
        let mut text = String::new();
        for action in actions {
            match action {
                UserAction::Steps(ticks) => go(&mut session, ticks),
                UserAction::Command(index) => {
                    let _ = session.command("test", 0, commands()[index].clone());
                }
                UserAction::Rewind(share) => {
                    let ends = session.branches()[session.current_branch()].ends_tick;
                    session.rewind((share * ends as f64) as u64).expect("it is there");
                }
                UserAction::Branch => {
                    let _ = session.branch();
                }
                UserAction::Show(branch) => {
                    let _ = session.go_to_branch(branch);
                }
            }
            text += &session.take_lines();
        }
        text += &saved(&mut session);
        let mut again = replay(&text).expect("the same bits").session;
        prop_assert_eq!(again.branches().len(), session.branches().len());
        for branch in 0..session.branches().len() {
            session.go_to_branch(branch).expect("it is there");
            again.go_to_branch(branch).expect("it is there");
            let ends = again.branches()[branch].ends_tick;
            prop_assert_eq!(ends, session.branches()[branch].ends_tick);
            for tick in [ends, ends / 2, ends / 3, ends] {
                session.rewind(tick).expect("it is there");
                again.rewind(tick).expect("it is there");
                prop_assert_eq!(again.bits(), session.bits(), "branch {} tick {}", branch, tick);
            }
        }
        // Both sessions continue alike, so the delayed orders of tugs and the states of pilots are equal too. The
        // recording continues where the first session ended.
        for session in [&mut session, &mut again] {
            session.go_to_branch(0).expect("it is there");
            go(session, 120);
        }
        prop_assert_eq!(again.bits(), session.bits());
        let end = text.trim_end().rfind('\n').expect("several lines") + 1;
        text.truncate(end);
        text += &saved(&mut again);
        let more = replay(&text).expect("the same bits").session;
        prop_assert_eq!(more.bits(), session.bits());
    }
}

proptest! {
    /// Any message of a page is read or refused.
    #[test]
    fn no_text_is_too_strange_to_be_refused(text in ".{0,200}") {
        let _ = Request::parse(&text);
        let wrapped = format!("{{\"type\":\"command\",\"id\":1,\"action\":{text}}}");
        let _ = Request::parse(&wrapped);
    }
}

#[test]
fn a_rewound_session_replays_its_recording_to_the_same_end() {
    let mut session = harbour();
    let mut bits = Vec::new();
    for tick in 0..600 {
        if tick == 150 {
            command(&mut session, rudder(0.4));
        }
        if tick == 300 {
            command(&mut session, engine(-0.5));
        }
        bits.push(session.bits());
        go(&mut session, 1);
    }
    session.rewind(40).expect("it is there");
    assert!(session.is_rewound());
    for (tick, bits) in bits.iter().enumerate().skip(40) {
        assert_eq!(*bits, session.bits(), "tick {tick}");
        assert_eq!(session.tick(), tick as u64);
        go(&mut session, 1);
    }
    assert!(!session.is_rewound() && session.tick() == 600);
}

#[test]
fn a_new_branch_does_not_change_its_parent() {
    let mut session = harbour();
    go(&mut session, 200);
    command(&mut session, rudder(0.5));
    go(&mut session, 400);
    let first_end = session.bits();
    assert!(session.branch().is_err(), "at its end there is nothing to leave");
    session.rewind(200).expect("it is there");
    assert!(session.command("test", 0, rudder(0.1)).is_err(), "nothing is ordered in the past");
    assert_eq!(session.branch(), Ok(1));
    command(&mut session, rudder(-0.5));
    go(&mut session, 400);
    assert_ne!(session.bits(), first_end);
    let second_end = session.bits();
    session.go_to_branch(0).expect("it is there");
    assert_eq!(session.bits(), first_end);
    session.go_to_branch(1).expect("it is there");
    assert_eq!(session.bits(), second_end);
    assert!(session.go_to_branch(2).is_err() && session.rewind(601).is_err());
    assert_eq!(session.bits(), second_end);
}

#[test]
fn an_impossible_command_is_refused_with_a_reason_and_changes_nothing() {
    let (mut bothered, mut left_alone) = (harbour(), harbour());
    go(&mut bothered, 30);
    go(&mut left_alone, 30);
    let before = bothered.take_lines();
    for (bad, reason) in [
        (order(OrderName::Rudder, "shop").number("angle", 0.1).into(), "no vessel `shop`"),
        (order(OrderName::Rudder, "quay").number("angle", 0.1).into(), "no vessel `quay`"),
        (rudder(f64::NAN), "must be between"),
        (engine(1.5), "must be between -1 and 1"),
        (engine(f64::INFINITY), "must be between"),
        (
            order(OrderName::Thruster, "ship").name("name", "stern").number("power", 0.1).into(),
            "no thruster",
        ),
        (order(OrderName::Azimuth, "ship").name("name", "a").into(), "no azimuth unit"),
        (order(OrderName::StandBy, "third").into(), "no tug `third`"),
        (
            order(OrderName::Push, "aft").number("direction", 1.0).into(),
            "needs the argument `force`",
        ),
        (
            order(OrderName::Pull, "aft").number("force", -1.0).number("direction", 1.0).into(),
            "must be between",
        ),
        (order(OrderName::LetGo, "none").into(), "no line `none`"),
        (order(OrderName::Heave, "head").number("rate", -1.0).into(), "must be between"),
        (
            order(OrderName::PushShip, "ship")
                .name("ship", "ship")
                .place("at", [0.0, 0.0])
                .number("force", 1.0)
                .into(),
            "the tug herself",
        ),
        (
            order(OrderName::PushShip, "ship")
                .name("ship", "quay")
                .place("at", [900.0, 0.0])
                .number("force", 1.0)
                .into(),
            "from the ship's outline",
        ),
        (
            order(OrderName::FollowShip, "ship")
                .name("ship", "quay")
                .place("at", [0.0, 0.0])
                .number("heading", 0.0)
                .into(),
            "azimuth",
        ),
        (
            order(OrderName::PullShip, "ship")
                .name("line", "head")
                .number("direction", 0.0)
                .number("force", 1.0)
                .into(),
            "no azimuth units",
        ),
        (
            order(OrderName::PullShip, "ship")
                .name("line", "none")
                .number("direction", 0.0)
                .number("force", 1.0)
                .into(),
            "no line `none`",
        ),
        (OtherAction::Wind { speed_mps: 400.0, from_rad: 0.0, over_s: 0.0 }.into(), "wind speed"),
        (
            OtherAction::Wind { speed_mps: f64::NAN, from_rad: 0.0, over_s: 0.0 }.into(),
            "wind speed",
        ),
        (
            OtherAction::Current { speed_mps: -1.0, to_rad: 0.0, over_s: 0.0 }.into(),
            "must be between",
        ),
        (
            OtherAction::Fault { vessel: "x".into(), fault: Fault::Blackout, on: true }.into(),
            "no vessel",
        ),
        (OtherAction::ApproachLimit { speed_mps: 2.0 }.into(), "is not between"),
        (words("third", TugWord::Push), "no tug `third`"),
        (words("ship", TugWord::Push), "no tug `ship`"),
    ] {
        let why = bothered.command("test", 0, bad.clone()).expect_err("refused").to_string();
        assert!(why.contains(reason), "{bad:?}: {why}");
    }
    assert!(!before.is_empty() && bothered.take_lines().is_empty());
    go(&mut bothered, 200);
    go(&mut left_alone, 200);
    assert_eq!(bothered.bits(), left_alone.bits());
}

#[test]
fn a_manual_order_drops_the_timed_orders_of_the_scenario_to_that_control() {
    // The scenario would engage the station pilot at 90 s.
    let mut session = harbour();
    command(&mut session, rudder(0.0));
    command(&mut session, engine(0.1));
    go(&mut session, 1000);
    let vessel = &session.simulation().vessels()[0];
    assert!(vessel.pilots.station.is_none() && vessel.pilots.course.is_none());
    assert_eq!((vessel.orders.rudder_rad, vessel.orders.shaft), (0.0, 0.1));
    let texts: Vec<String> = session.take_events().into_iter().map(|(_, text)| text).collect();
    assert!(texts.iter().any(|text| text.contains("under manual control")), "{texts:?}");
}

#[test]
fn a_tug_that_is_a_vessel_pulls_the_ship_off_on_her_line() {
    let mut session = open("scenarios/live/berthing.toml", &["body.ship.velocity.surge=0"]);
    let towards_quay = |session: &Session| session.simulation().states()[0].velocity_mps.y;
    let mut left_alone = open("scenarios/live/berthing.toml", &["body.ship.velocity.surge=0"]);
    for tug in ["forward_tug", "after_tug"] {
        command(&mut session, words(tug, TugWord::Pull));
    }
    go(&mut session, 1800);
    go(&mut left_alone, 1800);
    let [pulled, alone] = [&session, &left_alone].map(towards_quay);
    // About 600 kN during more than a minute, on 47,000 t and as much added mass, give at least 0.4 m/s.
    assert!(pulled < alone - 0.3, "{pulled} beside {alone} m/s");
}

#[test]
fn a_tug_takes_no_manual_orders_while_the_station_pilot_uses_her() {
    let mut session = harbour();
    go(&mut session, 1000);
    let push: Action =
        order(OrderName::Push, "aft").number("force", 1e5).number("direction", 1.5).into();
    let why = session.command("test", 0, push.clone()).expect_err("refused").to_string();
    assert!(why.contains("station"), "{why}");
    command(&mut session, order(OrderName::Hands, "ship").into());
    go(&mut session, 1);
    command(&mut session, push);
}

#[test]
fn the_history_of_a_rewound_and_a_replayed_session_is_that_of_the_run() {
    let mut session = harbour();
    command(&mut session, engine(0.4));
    go(&mut session, 300);
    let fault = OtherAction::Fault { vessel: "ship".into(), fault: Fault::RudderStuck, on: true };
    command(&mut session, fault.into());
    command(&mut session, OtherAction::Note { text: "late".into() }.into());
    go(&mut session, 105);
    let whole = session.history(None, &Role::PILOT).expect("it is kept");
    assert_eq!(whole.t_s.len(), 40);
    let texts: Vec<&str> = whole.events.iter().map(|event| event.text.as_str()).collect();
    assert!(texts.iter().any(|text| text.starts_with("ALARM: ship: rudder stuck")), "{texts:?}");
    assert!(texts.iter().any(|text| text.ends_with("notes: late")), "{texts:?}");
    // After going back, the past contains only what was before. After going on again it is the same.
    session.rewind(205).expect("it is there");
    let before = session.history(None, &Role::PILOT).expect("it is kept");
    assert_eq!(before.t_s, whole.t_s[..20]);
    assert!(before.events.iter().all(|event| event.t_s <= 20.5));
    session.rewind(405).expect("it is there");
    assert_eq!(session.history(None, &Role::PILOT).expect("it is kept"), whole);
    // From there on a branch has its own past, and the first run keeps its own past.
    session.rewind(205).expect("it is there");
    session.branch().expect("it is rewound");
    command(&mut session, engine(-0.7));
    go(&mut session, 200);
    let branch = session.history(None, &Role::PILOT).expect("it is kept");
    assert_eq!(branch.t_s, whole.t_s);
    assert_eq!(branch.ahead_mps[..20], whole.ahead_mps[..20]);
    assert!(branch.ahead_mps[39] < whole.ahead_mps[39]);
    session.go_to_branch(0).expect("there is one");
    assert_eq!(session.history(None, &Role::PILOT).expect("it is kept"), whole);
    session.go_to_branch(1).expect("there is one");
    // The past is the same after a restart of the server.
    assert_eq!(
        replay(&saved(&mut session))
            .expect("a good recording")
            .session
            .history(None, &Role::PILOT)
            .expect("it is kept"),
        branch
    );
}

#[test]
fn the_history_has_every_ship_that_can_be_conned() {
    let mut session = open("scenarios/live/two_pilots_in_a_fairway.toml", &[]);
    go(&mut session, 300);
    let names = &session.cast().vessels;
    let [bulker, coaster] = ["bulker", "coaster"].map(|name| {
        let vessel = names.iter().position(|other| other == name).expect("she is there");
        session.history(Some(vessel), &Role::PILOT).expect("it is kept")
    });
    assert_eq!(session.history(None, &Role::PILOT), Ok(bulker.clone()));
    assert_eq!((bulker.vessel, coaster.vessel), (Some(0), Some(1)));
    assert_eq!((bulker.t_s.len(), &coaster.t_s), (30, &bulker.t_s));
    // The speeds at the start are 7 and 8 knots.
    let knots =
        |history: &fenderline_live::message::History| history.ahead_mps[0] * 3600.0 / 1852.0;
    assert!((knots(&bulker) - 7.0).abs() < 0.2 && (knots(&coaster) - 8.0).abs() < 0.2);
    assert_eq!(coaster.events, bulker.events);
    let again = replay(&saved(&mut session)).expect("a good recording").session;
    assert_eq!(again.history(Some(1), &Role::PILOT), Ok(coaster));
    // A tug has no past, and nobody gets the past of a ship that does not exist.
    let session = open("scenarios/live/berthing.toml", &[]);
    assert!(session.history(Some(0), &Role::PILOT).is_ok());
    for vessel in [1, 2, 3] {
        let why = session.history(Some(vessel), &Role::PILOT).expect_err("no ship").to_string();
        assert!(why.contains("not kept"), "{why}");
    }
}

/// The harbour with a second ship beside the after tug. The after tug has her line to this ship.
fn two_ships_and_two_tugs() -> Session {
    let path = support::repository("scenarios/live/berthing.toml");
    let text = std::fs::read_to_string(path).expect("a scenario");
    let outline = "[[-93, -15], [92, -15], [92, 15], [-93, 15]]";
    let more = format!(
        "[body.coaster]\nvessel = \"bulker\"\noutline = {outline}\nposition = [-240, -200]\n\n[[pair]]\n\
         bodies = [\"after_tug\", \"coaster\"]\nmaterial = \"concrete\"\n\n[body.quay]"
    );
    let text = text.replace("[body.quay]", &more);
    let (before, after) = text.split_once("[line.after_tow]").expect("a line");
    let after = after.replacen("to = \"ship\"", "to = \"coaster\"", 1);
    let after = after.replacen("bollard = [-70, -13]", "bollard = [0, 13]", 1);
    let after = after.replacen("length = \"60 m\"", "length = \"130 m\"", 1);
    let text = format!("{before}[line.after_tow]{after}");
    let none = |name: &str| Err(format!("{name}: none is needed"));
    let (source, _) =
        fenderline_live::Source::collect("two.toml", text, vec![], none).expect("a scenario");
    Session::open(source).expect("a set-up")
}

/// A pilot ordered a pull, and for a minute saw only that the tug takes up slack.
#[test]
fn a_tug_that_is_to_pull_says_how_much_slack_her_line_has() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    let tug = |session: &Session| {
        let index = session.cast().vessels.iter().position(|name| name == "after_tug");
        let frame = session.frame(0, fenderline_live::message::RunState::default());
        frame.vessels[index.expect("a tug")].assist.expect("her pilot works")
    };
    let pull = TugWords {
        word: TugWord::Pull,
        power: 0.25,
        lead: Lead::default(),
        place: SidePlace::PortQuarter,
    };
    command(&mut session, Action::tug("after_tug", pull));
    let mut slack_m = Vec::new();
    for _ in 0..20 {
        go(&mut session, 100);
        let assist = tug(&session);
        assert_eq!(assist.slack_m.is_some(), assist.force_n <= 1e3, "{assist:?}");
        slack_m.extend(assist.slack_m);
    }
    let [first, last] = [slack_m[0], slack_m[slack_m.len() - 1]];
    assert!(first > 1.0 && last < 0.5 * first, "{slack_m:?}");
    assert!(tug(&session).force_n > 1e4, "she pulls at the end: {:?}", tug(&session));
}

#[test]
fn a_tug_that_is_a_vessel_assists_the_ship_on_her_line() {
    let mut session = two_ships_and_two_tugs();
    let cast = session.cast();
    assert_eq!(cast.other_ships(), ["coaster"]);
    assert_eq!(cast.served_by("forward_tug"), Some("ship"));
    assert_eq!(cast.served_by("after_tug"), Some("coaster"));
    let index = |name: &str| cast.vessels.iter().position(|other| other == name).expect("a vessel");
    let [forward, after, coaster] = ["forward_tug", "after_tug", "coaster"].map(index);
    let info = &session.info().vessels;
    assert_eq!((info[after].serves, info[coaster].serves), (Some(coaster), None));
    assert!(info[forward].has_towline && info[after].has_towline);
    assert!(info[coaster].places.len() == 7 && info[after].places.is_empty());
    let push = TugWords {
        word: TugWord::Push,
        power: 0.5,
        lead: Lead::default(),
        place: SidePlace::StarboardMidships,
    };
    command(&mut session, Action::tug("after_tug", push));
    go(&mut session, 1800);
    let frame = session.frame(0, fenderline_live::message::RunState::default());
    let assist = frame.vessels[after].assist.expect("her pilot works");
    assert_eq!((assist.order, assist.place), ("push", Some("starboard midships")), "{assist:?}");
    assert!(assist.force_n > 1e5, "{assist:?}");
    assert_eq!(assist.slack_m, None);
    // The velocity is westward, away from the tug.
    let body = session.simulation().setup().world.vessels[coaster].body;
    assert!(session.simulation().states()[body].velocity_mps.y < -0.05);
}
