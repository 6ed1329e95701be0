//! Sweeps of an anchor's force: distance, depth, direction, and the angle at which the chain lifts the shank.

use fenderline_contact::number::lesser;
use fenderline_contact::vec2;
use fenderline_sim::ChainGrade;
use fenderline_sim::anchor::{
    AnchorFaults, AnchorGear, AnchorLoad, AnchorState, AnchorStep, Hawse, Windlass, uplift_share,
};
use fenderline_sim::{ChainLink, ChainSize};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Anchor";
const WATER_KGPM3: f64 = 1025.0;
const CHAIN_M: f64 = 165.0;
const DEPTH_M: f64 = 20.0;

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![by_distance(), by_depth(), by_direction(), uplift()]
}

/// The anchor of the sweeps: a stockless anchor of 10 t on a chain of 81 mm.
fn gear() -> AnchorGear {
    let chain = ChainSize { diameter_m: 0.081, grade: ChainGrade::U3, link: ChainLink::Stud };
    AnchorGear {
        name: "anchor".to_owned(),
        mass_kg: 10e3,
        chain_diameter_m: chain.diameter_m,
        chain_grade: chain.grade,
        chain_length_m: 330.0,
        holding_factor: 3.0,
        dragging_factor: AnchorGear::DRAGGING_FACTOR,
        chain_friction: AnchorGear::CHAIN_FRICTION,
        windlass: Windlass::of_rules(&chain),
    }
}

/// The force of anchor and chain in a first step, with the anchor at rest on the bottom at the origin. `bites` is false
/// for an anchor that only drags.
fn load(distance_m: f64, bearing_rad: f64, above_bottom_m: f64, bites: bool) -> AnchorLoad {
    let mut state = AnchorState::on_bottom(vec2(0.0, 0.0), CHAIN_M);
    state.faults = AnchorFaults { does_not_bite: !bites, ..AnchorFaults::default() };
    let (sin, cos) = libm::sincos(bearing_rad);
    let hawse = Hawse {
        at_m: vec2(distance_m * cos, distance_m * sin),
        above_bottom_m: Some(above_bottom_m),
    };
    let given = AnchorStep { last_n: 0.0, water_kgpm3: WATER_KGPM3, step_s: 0.1 };
    gear().step(&mut state, &hawse, given, &mut |_| {})
}

fn horizontal_kn(load: &AnchorLoad) -> f64 {
    let [north_n, east_n, _] = load.on_ship_n;
    1e-3 * libm::hypot(north_n, east_n)
}

fn by_distance() -> Sweep {
    let curve = |name: &str, bites: bool| {
        Curve::of(name, move |m| horizontal_kn(&load(m, 0.0, DEPTH_M + 8.0, bites)))
            .never_negative("the anchor pulls the ship, and never pushes her")
            .law("the pull is never more than anchor and chain hold", move |m| {
                let load = load(m, 0.0, DEPTH_M + 8.0, bites);
                1e-3 * load.holding_n - horizontal_kn(&load) + 1e-3
            })
            .noisy(1e-6)
    };
    Sweep {
        key: "anchor_distance",
        subject: SUBJECT,
        title: "Stockless anchor of 10 t, six shackles in 20 m of water: pull by distance"
            .to_owned(),
        axis: Axis::new("distance of the hawse pipe", "m", 100.0, 172.0),
        value: ["horizontal pull", "kN"],
        curves: vec![
            curve("holding", true)
                .jumping("an anchor that breaks out holds half as much as before"),
            curve("dragging", false),
        ],
        lines: Vec::new(),
        note: "The chain is of 81 mm, and the hawse pipe is 8 m above the water. Each place on \
               the axis is a first step, in which the anchor has not yet dragged after the ship.",
    }
}

fn by_depth() -> Sweep {
    let curves = [120.0, 150.0].map(|distance_m| {
        Curve::of(format!("{distance_m} m off"), move |depth_m| {
            horizontal_kn(&load(distance_m, 0.0, depth_m + 8.0, false))
        })
        .never_negative("the anchor pulls the ship, and never pushes her")
        .noisy(1e-6)
    });
    Sweep {
        key: "anchor_depth",
        subject: SUBJECT,
        title: "The same stockless anchor with a fault, so that it does not bite: pull by depth"
            .to_owned(),
        axis: Axis::new("depth", "m", 0.0, 90.0),
        value: ["horizontal pull", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "With more depth the pull of the anchor rises until the anchor drags, and then \
               falls as less chain lies on the bottom.",
    }
}

fn by_direction() -> Sweep {
    let part = |name: &str, index: usize, sign: f64| {
        let at = move |degrees: f64| {
            1e-3 * load(150.0, degrees.to_radians(), DEPTH_M + 8.0, true).on_ship_n[index]
        };
        Curve::of(name, at).mirrored(move |degrees| sign * at(-degrees)).noisy(1e-8)
    };
    Sweep {
        key: "anchor_direction",
        subject: SUBJECT,
        title:
            "The same stockless anchor 150 m off: force on the ship by her bearing from the anchor"
                .to_owned(),
        axis: Axis::new("bearing of the ship", "°", -180.0, 180.0),
        value: ["force", "kN"],
        curves: vec![
            part("to the north", 0, 1.0).value_law("towards the anchor", |degrees, value| {
                -value * libm::cos(degrees.to_radians())
            }),
            part("to the east", 1, -1.0).value_law("towards the anchor", |degrees, value| {
                -value * libm::sin(degrees.to_radians())
            }),
        ],
        lines: Vec::new(),
        note: "",
    }
}

fn uplift() -> Sweep {
    let at = |degrees: f64| uplift_share(libm::sin(degrees.to_radians()));
    let share = Curve::of("share", at)
        .never_negative("the anchor holds, and never pushes")
        .law("an anchor on a steeper chain never holds more", move |degrees| {
            at(degrees) - at(lesser(degrees + 0.05, 90.0))
        });
    Sweep {
        key: "anchor_uplift",
        subject: SUBJECT,
        title: "Share of the holding power by the angle between shank and bottom".to_owned(),
        axis: Axis::new("angle", "°", 0.0, 90.0),
        value: ["share", ""],
        curves: vec![share],
        lines: Vec::new(),
        note: "",
    }
}
