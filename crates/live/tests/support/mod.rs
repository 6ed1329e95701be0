//! Sessions in scenarios of the repository.
#![allow(dead_code, reason = "each test file uses its own part")]

use std::path::{Path, PathBuf};

use fenderline_live::{Action, NamedOrder, Outline, Replay, Replayed, Session, Source};
use fenderline_sim::OrderName;

/// A path of the repository.
pub(crate) fn repository(path: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(path)
}

/// A session in a scenario of the repository with overrides of keys.
pub(crate) fn open(scenario: &str, set: &[&str]) -> Session {
    let path = repository(scenario);
    let text = std::fs::read_to_string(&path).expect("a scenario");
    let set = set.iter().map(|&s| s.to_owned()).collect();
    let file = path.file_name().expect("a name").to_string_lossy().into_owned();
    let (source, _) =
        Source::collect(&file, text, set, |name| Err(format!("{name}: none is needed")))
            .expect("a good scenario");
    Session::open(source).expect("a good set-up")
}

/// The harbour scene: a ship, two vector tugs, six lines, eight fenders.
pub(crate) fn harbour() -> Session {
    open("scenarios/berth/alongside_with_two_tugs.toml", &["line.head.made_fast=\"0 s\""])
}

/// A coaster that goes north at 6 knots. The table of her body is the last.
const COASTER: &str = r#"
[time]
step = "0.1 s"
duration = "1 h"
[vessel.coaster]
length_bp = 100
beam = 16
draught = 6
block_coefficient = 0.7
rudder = { area = "12 m^2", span = "4 m" }
propeller = { diameter = "4 m", full = "130 rpm" }
[body.ship]
vessel = "coaster"
outline = [[-50, -8], [50, -8], [50, 8], [-50, 8]]
velocity = { surge = "6 kn" }
running = 0.4
"#;

/// A ship on the first leg of a passage plan, with a corridor of 40 m; her rudder to starboard takes her out of it.
pub(crate) fn planned() -> Session {
    const PLAN: &str = r#"
[plan.inbound]
vessel = "ship"
[[plan.inbound.waypoint]]
name = "Sea buoy"
position = [0, 0]
[[plan.inbound.waypoint]]
name = "Bend"
position = [3000, 0]
turning_radius = "400 m"
speed = "6 kn"
half_width = "20 m"
[[plan.inbound.waypoint]]
position = [3000, 1200]
"#;
    let none = |name: &str| Err(format!("{name}: none is needed"));
    let (source, _) = Source::collect("planned.toml", format!("{COASTER}{PLAN}"), vec![], none)
        .expect("a good scenario");
    Session::open(source).expect("a good set-up")
}

/// A ship on her way to a bridge 350 m ahead that is 1 m too low for her.
pub(crate) fn under_bridge() -> Session {
    before_bridge("air_draught = \"33 m\"")
}

/// A ship on her way to a bridge 350 m ahead; `of_ship`: more keys of the ship.
pub(crate) fn before_bridge(of_ship: &str) -> Session {
    const MORE: &str = r#"
[chart]
files = ["bridge.geojson"]
coordinates = "metres"
clearance_datum = "2 m"
"#;
    const CHART: &str = r#"{ "type": "FeatureCollection", "features": [{ "type": "Feature",
"properties": { "OBJL": 11, "OBJNAM": "High Bridge", "VERCLR": 30 }, "geometry": { "type": "LineString",
"coordinates": [[-200, 350], [200, 350]] } }] }"#;
    let chart = |_: &str| Ok(CHART.to_owned());
    let (source, _) =
        Source::collect("bridge.toml", format!("{COASTER}{of_ship}{MORE}"), vec![], chart)
            .expect("a good scenario");
    Session::open(source).expect("a good set-up")
}

pub(crate) fn go(session: &mut Session, ticks: u64) {
    for _ in 0..ticks {
        session.step().expect("a good step");
    }
}

pub(crate) fn command(session: &mut Session, action: Action) -> u64 {
    session.command("test", 0, action).expect("a good command")
}

/// An order without arguments to a vessel, tug or line with a name.
pub(crate) fn order(order: OrderName, to: &str) -> NamedOrder {
    NamedOrder::new(order, to)
}

pub(crate) fn rudder(angle_rad: f64) -> Action {
    order(OrderName::Rudder, "ship").number("angle", angle_rad).into()
}

pub(crate) fn engine(share: f64) -> Action {
    order(OrderName::Engine, "ship").number("share", share).into()
}

/// The recording of a session up to now, with its last line.
pub(crate) fn saved(session: &mut Session) -> String {
    session.mark();
    session.take_lines() + &session.end_line()
}

/// Checks a recording and replays it to its end.
pub(crate) fn replay(text: &str) -> Result<Replayed, String> {
    let outline = outline(text)?;
    let mut replay = Replay::begin(text.as_bytes(), outline).map_err(|e| e.to_string())?;
    while !replay.play(1000).map_err(|e| e.to_string())? {}
    replay.finish().map_err(|e| e.to_string())
}

/// Checks a recording.
pub(crate) fn outline(text: &str) -> Result<Outline, String> {
    Outline::read(text.as_bytes(), |_| Ok(())).map_err(|e| e.to_string())
}
