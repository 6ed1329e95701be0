//! Anchors of scenario files: orders, what is refused, and whole runs at anchor.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::Scenario;
use fenderline_sim::anchor::{AnchorEvent, AnchorFaults, AnchorPosition, LostBy, SHACKLE_M, Stay};
use fenderline_sim::order::{Arguments, OrderName};
use fenderline_sim::{Action, Finding, Order, OrderError, Simulation, WorldEventKind};

/// A coaster in wind from ahead, with both anchors home.
const ROADS: &str = r#"title = "Roads"

[time]
step = "0.2 s"
duration = "3 h"

[environment]
depth = "15 m"
wind = { speed = "12 m/s", from = "0 deg" }

[vessel.coaster]
length_bp = "130 m"
beam = "20 m"
draught = "7.5 m"
block_coefficient = 0.74
windage = { frontal_area = "350 m^2", lateral_area = "1300 m^2", centroid_height = "7 m", type = "container ship, loaded" }

[body.ship]
vessel = "coaster"
outline = [[-68, -8], [-60, -10], [40, -10], [58, -6], [68, 0], [58, 6], [40, 10], [-60, 10], [-68, 8]]

[anchor.port]
on = "ship"
side = "port"
hawse = [62, -3]
hawse_height = "6 m"
mass = "3.8 t"
chain_diameter = "52 mm"
chain_length = "9 shackles"

[anchor.starboard]
on = "ship"
side = "starboard"
hawse = [62, 3]
hawse_height = "6 m"
mass = "3.8 t"
chain_diameter = "52 mm"
chain_length = "9 shackles"
"#;

fn roads(changes: &[(&str, &str)], more: &str) -> Simulation {
    let text = changes.iter().fold(ROADS.to_owned() + more, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    let scenario = Scenario::parse(&text, "anchors.toml").unwrap_or_else(|e| panic!("{e}"));
    Simulation::new(scenario.setup).expect("a good set-up")
}

fn refused(changes: &[(&str, &str)], more: &str) -> String {
    let text = changes.iter().fold(ROADS.to_owned() + more, |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    Scenario::parse(&text, "anchors.toml").map(|_| ()).expect_err("it is refused").to_string()
}

fn action(of: &Simulation, anchor: usize, name: OrderName, shackles: Option<f64>) -> Action {
    let arguments =
        shackles.map_or_else(Arguments::new, |of| Arguments::new().number("chain", of * SHACKLE_M));
    name.build(anchor, &arguments, of.setup()).expect("a good order")
}

fn order(of: &mut Simulation, anchor: usize, name: OrderName, shackles: Option<f64>) {
    let action = action(of, anchor, name, shackles);
    of.check_now(&action).expect("possible now");
    let at_s = of.time_s();
    of.order(Order { at_s, action }).expect("a good order");
}

/// Runs for a time, and returns the events of anchors.
fn run(of: &mut Simulation, seconds: f64) -> Vec<(usize, AnchorEvent)> {
    let until_s = of.time_s() + seconds;
    let mut events = Vec::new();
    while of.time_s() < until_s - 1e-9 {
        for event in of.step().expect("a good step").world_events {
            if let WorldEventKind::Anchor(what) = event.kind {
                events.push((event.who, what));
            }
        }
    }
    events
}

/// She lets go, falls back on the wind, brings up, and rides to it. The ledger closes, and the chain took energy. Over half an
/// hour chain, wind and the drag of her yawing balance in the mean, to the change of her momentum: 0.1 m/s of
/// 15 000 t over 1800 s is 850 N.
#[test]
fn a_ship_comes_to_anchor_and_the_ledger_closes() {
    let mut of = roads(&[("\"12 m/s\"", "\"6 m/s\"")], "");
    order(&mut of, 0, OrderName::LetGoAnchor, Some(4.0));
    let events = run(&mut of, 3600.0);
    assert_eq!(events[0], (0, AnchorEvent::OnBottom));
    let state = of.anchors()[0].state;
    assert_eq!(state.chain_m, 4.0 * SHACKLE_M);
    // She may snub the anchor when her chain first comes taut.
    assert!(state.dragged_m < 10.0 && !state.dragging, "{state:?}");
    let (mut chain_n, mut wind_n, mut hull_n) = (0.0, 0.0, 0.0);
    for _ in 0..9000 {
        let record = of.step().expect("a good step");
        let forces = &record.vessel_forces[0];
        let (sine, cosine) = record.states[0].heading_rad.sin_cos();
        chain_n += record.anchors[0].load.on_ship_n[0];
        wind_n += forces.wind.surge_n * cosine - forces.wind.sway_n * sine;
        hull_n += forces.hull.surge_n * cosine - forces.hull.sway_n * sine;
    }
    let [chain_n, wind_n, hull_n] = [chain_n, wind_n, hull_n].map(|sum| sum / 9000.0);
    println!("mean north: chain {chain_n} N, wind {wind_n} N, hull {hull_n} N");
    assert!(chain_n > 0.0 && wind_n < 0.0);
    assert!((chain_n + wind_n + hull_n).abs() < 850.0);
    let energy = of.energy();
    assert!(energy.loads.anchors_j < 0.0, "{}", energy.loads.anchors_j);
    // Rounding: no contacts.
    assert!(energy.residual_j.abs() < 1e-9 * energy.exchanged_j(), "{}", energy.residual_j);
}

/// Wind that is more than the anchor holds: it drags, which is a finding.
#[test]
fn an_anchor_drags_in_too_much_wind() {
    let mut of = roads(&[("\"12 m/s\"", "\"35 m/s\"")], "");
    order(&mut of, 1, OrderName::LetGoAnchor, Some(2.0));
    let events = run(&mut of, 900.0);
    assert!(events.contains(&(1, AnchorEvent::Drags)), "{events:?}");
    let findings = of.findings();
    let [Finding::AnchorDragged { anchor: 1, dragged_m, .. }] = findings[..] else {
        panic!("{findings:?}")
    };
    assert!(dragged_m > 20.0, "{dragged_m}");
    assert_eq!(of.verdict().key(), "anchor_dragged");
    assert!(findings[0].sentence(of.setup()).starts_with("Anchor starboard dragged "));
    let state = of.anchors()[1].state;
    assert!((state.dragged_m - dragged_m).abs() < 1e-9 && state.dragged_j > 0.0);
    let energy = of.energy();
    assert!(energy.residual_j.abs() < 1e-9 * energy.exchanged_j(), "{}", energy.residual_j);
    // The energy that the bottom took is a part of what the chain took from the ship.
    assert!(state.dragged_j < -energy.loads.anchors_j, "{} {:?}", state.dragged_j, energy);
}

/// Port and starboard mirrored in a symmetric ship and wind: the same track on the other side, bit for bit.
#[test]
fn port_and_starboard_are_symmetric() {
    let end = |anchor: usize| {
        let mut of = roads(&[], "");
        order(&mut of, anchor, OrderName::LetGoAnchor, Some(3.0));
        run(&mut of, 900.0);
        (of.states()[0], of.anchors()[anchor].load)
    };
    let ((port, on_port), (starboard, on_starboard)) = (end(0), end(1));
    assert_eq!(port.position_m.x, starboard.position_m.x);
    assert_eq!(port.position_m.y, -starboard.position_m.y);
    assert_eq!(port.heading_rad, -starboard.heading_rad);
    assert_eq!(on_port.tension_n, on_starboard.tension_n);
}

/// The chain leads up and down when it is hove short, and the anchor comes home.
#[test]
fn the_anchor_is_hove_home() {
    let mut of = roads(&[("\"12 m/s\"", "\"3 m/s\"")], "");
    order(&mut of, 0, OrderName::LetGoAnchor, Some(2.0));
    run(&mut of, 120.0);
    order(&mut of, 0, OrderName::HeaveIn, Some(0.0));
    let mut stays = Vec::new();
    let mut events = Vec::new();
    while of.anchors()[0].state.position != AnchorPosition::Housed {
        events.extend(run(&mut of, 1.0));
        let stay = of.anchors()[0].load.stay();
        if stays.last() != Some(&stay) {
            stays.push(stay);
        }
        assert!(of.time_s() < 1800.0);
    }
    // At short stay it drags before it breaks out.
    events.retain(|(_, event)| !matches!(event, AnchorEvent::Drags | AnchorEvent::Holds));
    assert_eq!(events, [(0, AnchorEvent::Aweigh), (0, AnchorEvent::Home)]);
    assert!(stays.contains(&Some(Stay::UpAndDown)), "{stays:?}");
    // 0.15 m/s for 55 m is 367 s.
    assert!((of.time_s() - 120.0 - 55.0 / 0.15).abs() < 30.0, "{}", of.time_s());
}

#[test]
fn orders_that_cannot_be_carried_out_are_refused() {
    let mut of = roads(&[], "");
    let now = |of: &Simulation, name, shackles| of.check_now(&action(of, 0, name, shackles));
    let home = OrderError::AnchorHome { anchor: "port".into() };
    for name in [OrderName::HoldChain, OrderName::Slip] {
        assert_eq!(now(&of, name, None), Err(home.clone()));
    }
    assert_eq!(now(&of, OrderName::HeaveIn, Some(0.0)), Err(home));
    order(&mut of, 0, OrderName::LetGoAnchor, Some(2.0));
    run(&mut of, 60.0);
    let down = OrderError::AnchorDown { anchor: "port".into() };
    assert_eq!(now(&of, OrderName::LetGoAnchor, Some(3.0)), Err(down));
    let text = now(&of, OrderName::Veer, Some(1.0)).expect_err("more is out").to_string();
    assert_eq!(
        text,
        "anchor `port` has 55.0 m of chain out (2.0 shackles): ask for more than this length"
    );
    let text = now(&of, OrderName::HeaveIn, Some(3.0)).expect_err("less is out").to_string();
    assert!(text.ends_with("ask for less than this length"), "{text}");
    let faults = AnchorFaults { windlass_failed: true, ..AnchorFaults::default() };
    of.set_anchor_faults(0, faults).expect("an anchor");
    let failed = OrderError::WindlassFailed { anchor: "port".into() };
    assert_eq!(now(&of, OrderName::HeaveIn, Some(1.0)), Err(failed));
    assert!(of.set_anchor_faults(2, faults).is_err());
    order(&mut of, 0, OrderName::Slip, None);
    run(&mut of, 1.0);
    let gone = OrderError::AnchorLost { anchor: "port".into(), by: LostBy::Slipped };
    assert_eq!(now(&of, OrderName::HeaveIn, Some(0.0)), Err(gone.clone()));
    assert_eq!(gone.to_string(), "anchor `port` is lost: its chain was slipped");
    assert!(of.findings().is_empty());
}

/// Each order is checked against what the orders before it in the same step leave: none is acknowledged and then dropped.
#[test]
fn the_second_of_two_orders_for_one_anchor_in_one_step_is_not_acknowledged_and_dropped() {
    let mut of = roads(&[], "");
    let now = |of: &Simulation, name, shackles| of.check_now(&action(of, 0, name, shackles));
    // Let go, and stopped in the same step: nothing runs out.
    order(&mut of, 0, OrderName::LetGoAnchor, Some(2.0));
    order(&mut of, 0, OrderName::HoldChain, None);
    assert_eq!(
        now(&of, OrderName::HoldChain, None),
        Err(OrderError::AnchorHome { anchor: "port".into() })
    );
    assert_eq!(run(&mut of, 30.0), []);
    assert_eq!(of.anchors()[0].state.position, AnchorPosition::Housed);
    // Slipped, and hove in in the same step: the second is told.
    order(&mut of, 0, OrderName::LetGoAnchor, Some(2.0));
    run(&mut of, 60.0);
    order(&mut of, 0, OrderName::Slip, None);
    let gone = OrderError::AnchorLost { anchor: "port".into(), by: LostBy::Slipped };
    assert_eq!(now(&of, OrderName::HeaveIn, Some(0.0)), Err(gone.clone()));
    assert_eq!(now(&of, OrderName::Slip, None), Err(gone));
    // The other anchor is not concerned.
    order(&mut of, 1, OrderName::LetGoAnchor, Some(2.0));
    assert_eq!(run(&mut of, 0.2), [], "no order is refused");
    assert_eq!(of.anchors()[0].state.position, AnchorPosition::Lost(LostBy::Slipped));
    assert!(of.anchors()[1].state.chain_m > 0.0);
}

/// What a file says wrongly is found before the run, with its key.
#[test]
fn an_anchor_that_finds_no_bottom_is_refused_with_its_key() {
    let let_go = "\n[[order]]\nanchor = \"port\"\nlet_go_anchor = \"3 shackles\"\n";
    let deep = refused(&[("depth = \"15 m\"\n", "")], let_go);
    assert!(deep.contains("order.0.let_go_anchor") && deep.contains("finds no bottom"), "{deep}");
    let deep = refused(&[("\"15 m\"", "\"300 m\"")], let_go);
    assert!(deep.contains("too deep for anchor `port`"), "{deep}");
    assert!(deep.contains("306.0 m above the bottom"), "{deep}");
    let long = refused(&[], "\n[[order]]\nanchor = \"port\"\nveer = \"10 shackles\"\n");
    assert!(long.contains("the chain of anchor `port` is 247.5 m long (9.0 shackles)"), "{long}");
    let none = refused(&[], "\n[[order]]\nanchor = \"prot\"\nslip = true\n");
    assert!(
        none.contains("there is no anchor") && none.contains("did you mean \"port\"?"),
        "{none}"
    );
    let line = refused(&[], "\n[[order]]\nanchor = \"port\"\nheave = 0.1\n");
    assert!(line.contains("is not an order to an anchor"), "{line}");
    let placed = (
        "chain_length = \"9 shackles\"\n",
        "chain_length = \"9 shackles\"\nplaced = [100, 0]\nchain_out = \"40 m\"\n",
    );
    let short = refused(&[placed], "");
    assert!(short.contains("40.0 m of chain out at the start, but is 43.5 m"), "{short}");
    let alone = refused(&[("side = \"port\"", "side = \"port\"\nplaced = [100, 0]")], "");
    assert!(alone.contains("`anchor.port.placed` needs `chain_out`"), "{alone}");
    let body = refused(&[("on = \"ship\"", "on = \"sheep\"")], "");
    assert!(body.contains("there is no body \"sheep\""), "{body}");
    let more = refused(&[("side = \"port\"", "side = \"port\"\ndragging_factor = 4")], "");
    assert!(more.contains("more than the holding factor"), "{more}");
}

/// Orders of a file that cannot be carried out when their time comes are events; an anchor can be on the bottom at the start.
#[test]
fn a_file_places_an_anchor_and_orders_it() {
    let placed =
        ("side = \"port\"", "side = \"port\"\nplaced = [120, 0]\nchain_out = \"3 shackles\"");
    let orders = "\n[[order]]\nanchor = \"port\"\nlet_go_anchor = \"4 shackles\"\n\n[[order]]\nat = 5\nanchor = \"port\"\nslip = true\n";
    let mut of = roads(&[placed], orders);
    assert_eq!(of.anchors()[0].state.chain_m, 82.5);
    let events = run(&mut of, 10.0);
    assert_eq!(events, [(0, AnchorEvent::OrderRefused)]);
    assert_eq!(of.anchors()[0].state.position, AnchorPosition::Lost(LostBy::Slipped));
}

/// A rising tide lengthens what the chain has to span; the same bits again.
#[test]
fn a_tide_and_a_repetition() {
    let tide = "[environment.tide]\nlevel = 0\nconstituent = [{ amplitude = \"4 m\", period = \"1 h\", lag = \"90 deg\" }]\n\n[vessel.coaster]";
    let ends = [0, 1].map(|_| {
        let mut of = roads(&[("[vessel.coaster]", tide)], "");
        order(&mut of, 0, OrderName::LetGoAnchor, Some(3.0));
        run(&mut of, 300.0);
        let low = of.anchors()[0].load.on_bottom_m;
        run(&mut of, 600.0);
        (of.states()[0], of.anchors()[0], low)
    });
    assert_eq!(ends[0], ends[1]);
}
