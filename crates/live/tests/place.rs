//! Ships are placed before the start. A place where a ship cannot be is refused with a reason. Placing is recorded like
//! any command.

use crate::support;

use fenderline_live::{OtherAction, Session};

fn place(vessel: &str, at_m: [f64; 2], heading_deg: f64) -> OtherAction {
    let heading_rad = heading_deg.to_radians();
    OtherAction::Place { vessel: vessel.into(), at_m, heading_rad, ahead_mps: None }
}

fn refusal(session: &mut Session, action: OtherAction) -> String {
    let before = session.bits();
    let why = session.command("instructor", 0, action.into()).expect_err("it is refused");
    assert_eq!(session.bits(), before, "nothing is changed");
    why.to_string()
}

#[test]
fn a_ship_is_placed_and_begins_there_with_her_speed_along_her_new_heading() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    support::command(&mut session, support::engine(0.3));
    support::command(&mut session, place("ship", [-400.0, -150.0], 45.0).into());
    let state = session.simulation().states()[0];
    assert_eq!([state.position_m.x, state.position_m.y], [-400.0, -150.0]);
    let ahead = 1.5 * 1852.0 / 3600.0 * core::f64::consts::FRAC_1_SQRT_2;
    assert!((state.velocity_mps.x - ahead).abs() < 1e-12, "{state:?}");
    assert!((state.velocity_mps.y - ahead).abs() < 1e-12, "{state:?}");
    // The tugs on her lines came along. Each is at the same place beside her.
    let tug = session.simulation().states()[1];
    let beside = [tug.position_m.x - state.position_m.x, tug.position_m.y - state.position_m.y];
    // Sine and cosine of the turn by 43°.
    let (sin, cos) = (0.681_998_360_062_498_5, 0.731_353_701_619_170_5);
    let before = [-125.0 + 180.0, -110.0 + 60.0];
    let expected = [before[0] * cos - before[1] * sin, before[0] * sin + before[1] * cos];
    assert!((0..2).all(|k| (beside[k] - expected[k]).abs() < 1e-9), "{beside:?} {expected:?}");
    let far = refusal(&mut session, place("forward_tug", [-100.0, -400.0], 0.0));
    assert!(far.contains("line `forward_tow` is 60 m long"), "{far}");
    let with_speed = OtherAction::Place {
        vessel: "forward_tug".into(),
        at_m: [tug.position_m.x, tug.position_m.y],
        heading_rad: 103f64.to_radians(),
        ahead_mps: Some(2.0),
    };
    support::command(&mut session, with_speed.into());
    let speed_mps = session.simulation().states()[1].velocity_mps.length();
    assert!((speed_mps - 2.0).abs() < 1e-12);
    support::go(&mut session, 100);
    // The order from before the placing still holds.
    assert_eq!(session.simulation().vessels()[0].orders.shaft, 0.3);
    let bits = session.bits();
    let text = support::saved(&mut session);
    assert_eq!(support::replay(&text).expect("a good recording").session.bits(), bits);
    session.rewind(0).expect("it is there");
    session.rewind(100).expect("it is there");
    assert_eq!(session.bits(), bits);
}

#[test]
fn a_place_in_a_hull_a_quay_a_fender_or_the_past_is_refused_with_the_reason() {
    let mut session = support::open("scenarios/live/berthing.toml", &[]);
    for (action, why) in [
        // One tug is placed across the ship's side, and one in the middle of the ship, where no edges cross.
        (
            place("forward_tug", [-150.0, -55.0], 90.0),
            "the hull of forward_tug would overlap that of ship",
        ),
        (
            place("forward_tug", [-180.0, -60.0], 2.0),
            "the hull of forward_tug would overlap that of ship",
        ),
        (place("ship", [0.0, 5.0], 0.0), "ship would be ashore on quay"),
        // The fenders project 1.9 m. The ship's side is 15 m from her axis.
        (place("ship", [0.0, -16.0], 0.0), "ship would lie in the fender cone"),
        (place("nobody", [0.0, 0.0], 0.0), "no vessel `nobody`"),
        (place("ship", [f64::NAN, 0.0], 0.0), "within 1000 km"),
        (place("ship", [0.0, 2e6], 0.0), "within 1000 km"),
    ] {
        let reason = refusal(&mut session, action);
        assert!(reason.contains(why), "{reason}");
    }
    support::command(&mut session, place("ship", [0.0, -17.0], 0.0).into());
    support::go(&mut session, 1);
    let late = refusal(&mut session, place("ship", [0.0, -50.0], 0.0));
    assert!(late.contains("before the start"), "{late}");
    // At the start of another branch the ship is placed again.
    session.rewind(0).expect("it is there");
    session.branch().expect("a branch");
    support::command(&mut session, place("ship", [0.0, -50.0], 0.0).into());
    assert_eq!(session.simulation().states()[0].position_m.y, -50.0);
}

#[test]
fn a_ship_is_not_placed_on_the_land_of_a_chart() {
    let path = support::repository("scenarios/live/harbour.toml");
    let text = std::fs::read_to_string(&path).expect("a scenario");
    let beside = |name: &str| {
        std::fs::read_to_string(path.with_file_name(name)).map_err(|why| why.to_string())
    };
    let (source, scenario) =
        fenderline_live::Source::collect("a.toml", text, vec![], beside).expect("a scenario");
    let coast = scenario.setup.world.chart.features.iter().find_map(|feature| {
        let is_coast = feature.kind == fenderline_sim::chart::ChartKind::Coast;
        is_coast.then(|| feature.shape.points_m().next()).flatten()
    });
    let coast = coast.expect("the chart has a coast");
    let mut session = Session::open(source).expect("a set-up");
    let ship = session.cast().vessels[0].clone();
    let reason = refusal(&mut session, place(&ship, [coast.x, coast.y], 0.0));
    assert!(reason.contains("ashore"), "{reason}");
}
