//! The session against itself: replay, rewind and branches give the same bits; what cannot be is refused and
//! changes none.

mod support;

use fenderline_live::{Action, Fault, Request, Session, TugWord, WinchWord};
use proptest::prelude::*;
use support::{engine, go, harbour, open, replay, rudder, saved, say};

fn commands() -> Vec<Action> {
    let ship = || "ship".to_owned();
    let push_n = Some(3e5);
    vec![
        rudder(0.3),
        rudder(-0.6),
        engine(0.4),
        engine(-0.7),
        Action::Thruster { vessel: ship(), thruster: "bow".into(), share: 0.9 },
        Action::Course { vessel: ship(), heading_rad: 0.2 },
        Action::Speed { vessel: ship(), speed_mps: 1.5 },
        Action::Hands { vessel: ship() },
        Action::Tug {
            tug: "forward".into(),
            order: TugWord::Push,
            force_n: push_n,
            direction_rad: Some(1.5),
        },
        Action::Tug {
            tug: "aft".into(),
            order: TugWord::StandBy,
            force_n: None,
            direction_rad: None,
        },
        Action::Winch { line: "head".into(), order: WinchWord::Heave, rate_mps: 0.2 },
        Action::LetGo { line: "head".into() },
        Action::Wind { speed_mps: 17.0, from_rad: 4.0 },
        Action::Current { speed_mps: 0.8, to_rad: 1.0 },
        Action::Fault { vessel: ship(), fault: Fault::RudderStuck, on: true },
        Action::Fault { vessel: ship(), fault: Fault::Blackout, on: true },
        Action::Fault { vessel: ship(), fault: Fault::Blackout, on: false },
    ]
}

/// What a hand may do to a session, drawn at random.
#[derive(Clone, Debug)]
enum Deed {
    Step(u64),
    Command(usize),
    Rewind(f64),
    Branch,
    Show(usize),
}

fn deed() -> impl Strategy<Value = Deed> {
    prop_oneof![
        4 => (1..180_u64).prop_map(Deed::Step),
        4 => (0..commands().len()).prop_map(Deed::Command),
        2 => (0.0..1.0).prop_map(Deed::Rewind),
        1 => Just(Deed::Branch),
        1 => (0..4_usize).prop_map(Deed::Show),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    /// However it was played, a session's recording makes every branch's end again, bit for bit, and so does
    /// scrubbing to and fro; a command that was refused leaves no trace.
    #[test]
    fn a_session_replays_to_the_same_bits(deeds in prop::collection::vec(deed(), 1..40)) {
        let mut session = harbour();
        let mut text = String::new();
        for deed in deeds {
            match deed {
                Deed::Step(ticks) => go(&mut session, ticks),
                Deed::Command(index) => {
                    let _ = session.command("test", 0, commands()[index].clone());
                }
                Deed::Rewind(share) => {
                    let ends = session.branches()[session.shown()].ends_tick;
                    session.rewind((share * ends as f64) as u64).expect("it is there");
                }
                Deed::Branch => {
                    let _ = session.branch();
                }
                Deed::Show(branch) => {
                    let _ = session.show(branch);
                }
            }
            text += &session.take_lines();
        }
        text += &saved(&mut session);
        let mut again = replay(&text).expect("the same bits").session;
        prop_assert_eq!(again.branches().len(), session.branches().len());
        for branch in 0..session.branches().len() {
            session.show(branch).expect("it is there");
            again.show(branch).expect("it is there");
            let ends = again.branches()[branch].ends_tick;
            prop_assert_eq!(ends, session.branches()[branch].ends_tick);
            for tick in [ends, ends / 2, ends / 3, ends] {
                session.rewind(tick).expect("it is there");
                again.rewind(tick).expect("it is there");
                prop_assert_eq!(again.bits(), session.bits(), "branch {} tick {}", branch, tick);
            }
        }
        // And both go on alike: orders that wait in tugs and pilots are the same too. What is recorded then goes on
        // where the first recording ended.
        for session in [&mut session, &mut again] {
            session.show(0).expect("it is there");
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
    /// Whatever a page says: it is read or refused.
    #[test]
    fn no_text_is_too_strange_to_be_refused(text in ".{0,200}") {
        let _ = Request::parse(&text);
        let wrapped = format!("{{\"type\":\"command\",\"id\":1,\"action\":{text}}}");
        let _ = Request::parse(&wrapped);
    }
}

#[test]
fn a_rewound_session_plays_what_is_recorded_and_comes_to_the_same_end() {
    let mut session = harbour();
    let mut bits = Vec::new();
    for tick in 0..600 {
        if tick == 150 {
            say(&mut session, rudder(0.4));
        }
        if tick == 300 {
            say(&mut session, engine(-0.5));
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
fn a_branch_goes_its_own_way_and_leaves_the_other_as_it_was() {
    let mut session = harbour();
    go(&mut session, 200);
    say(&mut session, rudder(0.5));
    go(&mut session, 400);
    let first_end = session.bits();
    assert!(session.branch().is_err(), "at its end there is nothing to leave");
    session.rewind(200).expect("it is there");
    assert!(session.command("test", 0, rudder(0.1)).is_err(), "nothing is ordered in the past");
    assert_eq!(session.branch(), Ok(1));
    say(&mut session, rudder(-0.5));
    go(&mut session, 400);
    assert_ne!(session.bits(), first_end);
    let second_end = session.bits();
    session.show(0).expect("it is there");
    assert_eq!(session.bits(), first_end);
    session.show(1).expect("it is there");
    assert_eq!(session.bits(), second_end);
    assert!(session.show(2).is_err() && session.rewind(601).is_err());
    assert_eq!(session.bits(), second_end);
}

#[test]
fn what_cannot_be_is_refused_with_a_reason_and_changes_nothing() {
    let (mut bothered, mut left_alone) = (harbour(), harbour());
    go(&mut bothered, 30);
    go(&mut left_alone, 30);
    let ship = || "ship".to_owned();
    let before = bothered.take_lines();
    for (bad, reason) in [
        (Action::Rudder { vessel: "shop".into(), angle_rad: 0.1 }, "no vessel `shop`"),
        (Action::Rudder { vessel: "quay".into(), angle_rad: 0.1 }, "no vessel `quay`"),
        (rudder(f64::NAN), "is not within"),
        (engine(1.5), "is not within"),
        (engine(f64::INFINITY), "is not within"),
        (Action::Thruster { vessel: ship(), thruster: "stern".into(), share: 0.1 }, "no thruster"),
        (
            Action::Azimuth { vessel: ship(), unit: "a".into(), power: None, direction_rad: None },
            "no azimuth unit",
        ),
        (
            Action::Tug {
                tug: "third".into(),
                order: TugWord::StandBy,
                force_n: None,
                direction_rad: None,
            },
            "no tug `third`",
        ),
        (
            Action::Tug {
                tug: "aft".into(),
                order: TugWord::Push,
                force_n: None,
                direction_rad: Some(1.0),
            },
            "needs `force_n`",
        ),
        (
            Action::Tug {
                tug: "aft".into(),
                order: TugWord::Pull,
                force_n: Some(-1.0),
                direction_rad: Some(1.0),
            },
            "is not within",
        ),
        (Action::LetGo { line: "none".into() }, "no line `none`"),
        (
            Action::Winch { line: "head".into(), order: WinchWord::Heave, rate_mps: -1.0 },
            "is not within",
        ),
        (
            Action::PushShip { vessel: ship(), ship: ship(), at_m: [0.0, 0.0], force_n: 1.0 },
            "push herself",
        ),
        (
            Action::PushShip {
                vessel: ship(),
                ship: "quay".into(),
                at_m: [900.0, 0.0],
                force_n: 1.0,
            },
            "from the ship's outline",
        ),
        (
            Action::FollowShip {
                vessel: ship(),
                ship: "quay".into(),
                at_m: [0.0, 0.0],
                heading_rad: 0.0,
            },
            "azimuth",
        ),
        (
            Action::PullShip {
                vessel: ship(),
                line: "head".into(),
                direction_rad: 0.0,
                force_n: 1.0,
            },
            "not between `ship` and a ship",
        ),
        (
            Action::PullShip {
                vessel: ship(),
                line: "none".into(),
                direction_rad: 0.0,
                force_n: 1.0,
            },
            "no line `none`",
        ),
        (Action::Wind { speed_mps: 400.0, from_rad: 0.0 }, "wind speed"),
        (Action::Wind { speed_mps: f64::NAN, from_rad: 0.0 }, "wind speed"),
        (Action::Current { speed_mps: -1.0, to_rad: 0.0 }, "is not within"),
        (Action::Fault { vessel: "x".into(), fault: Fault::Blackout, on: true }, "no vessel"),
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
fn a_hand_on_a_control_takes_it_from_the_scenarios_own_orders_for_good() {
    // At 90 s the scenario would put its station pilot on.
    let mut session = harbour();
    say(&mut session, rudder(0.0));
    say(&mut session, engine(0.1));
    go(&mut session, 1000);
    let vessel = &session.simulation().vessels()[0];
    assert!(vessel.pilots.station.is_none() && vessel.pilots.course.is_none());
    assert_eq!((vessel.orders.rudder_rad, vessel.orders.shaft), (0.0, 0.1));
    let texts: Vec<String> = session.take_events().into_iter().map(|(_, text)| text).collect();
    assert!(texts.iter().any(|text| text.contains("own orders")), "{texts:?}");
}

#[test]
fn a_tug_that_is_a_vessel_pulls_the_ship_off_on_her_line() {
    let mut session = open("scenarios/live/berthing.toml", &["body.ship.velocity.surge=0"]);
    let towards_quay = |session: &Session| session.simulation().states()[0].velocity_mps.y;
    let mut left_alone = open("scenarios/live/berthing.toml", &["body.ship.velocity.surge=0"]);
    for tug in ["forward", "after"] {
        say(
            &mut session,
            Action::PullShip {
                vessel: format!("{tug}_tug"),
                line: format!("{tug}_tow"),
                direction_rad: -1.57,
                force_n: 3e5,
            },
        );
    }
    go(&mut session, 1800);
    go(&mut left_alone, 1800);
    let [pulled, alone] = [&session, &left_alone].map(towards_quay);
    // 600 kN for a good minute on 47,000 t and as much added mass is 0.4 m/s and more.
    assert!(pulled < alone - 0.3, "{pulled} beside {alone} m/s");
}

#[test]
fn a_tug_is_not_ordered_by_hand_while_the_station_pilot_uses_her() {
    let mut session = harbour();
    go(&mut session, 1000);
    let push = Action::Tug {
        tug: "aft".into(),
        order: TugWord::Push,
        force_n: Some(1e5),
        direction_rad: Some(1.5),
    };
    let why = session.command("test", 0, push.clone()).expect_err("refused").to_string();
    assert!(why.contains("station"), "{why}");
    say(&mut session, Action::Hands { vessel: "ship".into() });
    go(&mut session, 1);
    say(&mut session, push);
}
