//! Sweeps of mooring lines: each rope by stretch, with and without tail, by direction, and a cable that hangs.

use std::f64::consts::PI;

use fenderline_sim::constants::{SEA_WATER_KGPM3, STANDARD_GRAVITY_MPS2};
use fenderline_sim::mooring::{
    Cable, InboardEnd, InitialLength, Line as MooringLine, LineDetails, LineEnds, LineKind,
    LineLoad, LineSetup, LineState, Rope, RopeCurve, Tail, Winch, WinchOrder, catenary,
};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Lines";
const BREAK_N: f64 = 1e6;
const PULLS: &str = "the line pulls the ship, and never pushes her";
const STIFFENS: &str = "more stretch never gives the line less tension";

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![
        by_strain(
            "line_stiff",
            "Tension of stiff ropes by strain, from slack to beyond the break",
            Axis::new("strain", "%", -0.5, 4.0),
            [("wire", RopeCurve::wire()), ("HMPE", RopeCurve::hmpe())],
        ),
        by_strain(
            "line_soft",
            "Tension of soft ropes by strain, from slack to beyond the break",
            Axis::new("strain", "%", -2.0, 28.0),
            [("polyester", RopeCurve::polyester()), ("nylon", RopeCurve::nylon())],
        ),
        by_span(),
        by_direction(),
        cable(),
        cable_on_bottom(),
    ]
}

/// Makes the sweep for ropes of one kind, from slack to beyond the break.
fn by_strain(key: &'static str, title: &str, axis: Axis, ropes: [(&str, RopeCurve); 2]) -> Sweep {
    let curves = ropes.map(|(name, rope)| {
        Curve::of(name, move |percent| rope.share(0.01 * percent))
            .never_negative(PULLS)
            .rising(STIFFENS, 0.01)
    });
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis,
        value: ["tension / break load", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "A line parts at a tension of 1 times its break load. The ropes are bedded-in, with \
               one curve for loading and unloading.",
    }
}

/// The mooring line of the sweeps: 50 m long, on bitts or a winch.
fn line(tail: bool, inboard_end: InboardEnd) -> (MooringLine, LineState) {
    let main = Rope { break_load_n: BREAK_N, curve: RopeCurve::hmpe() };
    let nylon = Rope { break_load_n: 1.25 * BREAK_N, curve: RopeCurve::nylon() };
    let setup = LineSetup {
        name: "line".to_owned(),
        kind: LineKind::Light {
            main,
            tail: tail.then_some(Tail { rope: nylon, length_m: 11.0 }),
            details: LineDetails::default(),
        },
        inboard_end,
        initial_length: InitialLength::Outboard(50.0),
    };
    MooringLine::new(setup, &ends(40.0, 0.0)).expect("a good line")
}

fn ends(span_m: f64, bearing_rad: f64) -> LineEnds {
    let (sin, cos) = libm::sincos(bearing_rad);
    LineEnds { ship_m: [0.0, 0.0, 6.0], shore_m: [span_m * cos, span_m * sin, 3.0] }
}

fn load((line, state): &(MooringLine, LineState), ends: &LineEnds) -> LineLoad {
    let mut state = *state;
    line.step(&mut state, ends, WinchOrder::Hold, 0.1)
}

fn by_span() -> Sweep {
    let winch = || InboardEnd::Winch(Winch::of_design(BREAK_N, 100.0));
    let bare = line(false, InboardEnd::Bitts);
    let tailed = line(true, InboardEnd::Bitts);
    let rendering = line(false, winch());
    let curve = |name: &str, line: (MooringLine, LineState)| {
        Curve::of(name, move |span_m| 1e-3 * load(&line, &ends(span_m, 0.0)).tension_n)
            .never_negative(PULLS)
    };
    let parts = "the line parts when its tension is above the break load";
    Sweep {
        key: "line_span",
        subject: SUBJECT,
        title: "Tension of a line of 50 m of HMPE of 1,000 kN by the distance of its ends"
            .to_owned(),
        axis: Axis::new("horizontal distance", "m", 45.0, 54.0),
        value: ["tension", "kN"],
        curves: vec![
            curve("on bitts", bare).jumping(parts),
            curve("with a nylon tail of 11 m", tailed).jumping(parts),
            curve("on a winch", rendering),
        ],
        lines: Vec::new(),
        note: "The shore end of the line is 3 m lower than the ship's end. A line on a winch has \
               a brake that renders at 60 % of the break load.",
    }
}

/// Sweep of the line's force on the ship by the bearing of the bollard.
fn by_direction() -> Sweep {
    let line = line(false, InboardEnd::Bitts);
    let part = |name: &str, index: usize, sign: f64| {
        let (own, mirror) = (line.clone(), line.clone());
        let at = move |line: &(MooringLine, LineState), degrees: f64| {
            1e-3 * load(line, &ends(50.6, degrees.to_radians())).on_ship_n[index]
        };
        Curve::of(name, move |degrees| at(&own, degrees))
            .mirrored(move |degrees| sign * at(&mirror, -degrees))
    };
    let pulls = |degrees: f64, value: f64| value * libm::cos(degrees.to_radians());
    let side = |degrees: f64, value: f64| value * libm::sin(degrees.to_radians());
    Sweep {
        key: "line_direction",
        subject: SUBJECT,
        title:
            "The same line of HMPE on bitts, 50.6 m long: force on the ship by the bearing of the \
             bollard"
                .to_owned(),
        axis: Axis::new("bearing of the bollard", "°", -180.0, 180.0),
        value: ["force", "kN"],
        curves: vec![
            part("to the north", 0, 1.0).value_law("towards the bollard", pulls),
            part("to the east", 1, -1.0).value_law("towards the bollard", side),
            part("up", 2, 1.0).never_positive("towards the lower end"),
        ],
        lines: Vec::new(),
        note: "",
    }
}

/// The mooring cable of the sweeps: EA 1e9 N, 200 kg/m, a diameter of 0.1 m in sea water, 210 m long.
fn reference_cable() -> Cable {
    let displaced_kgpm = SEA_WATER_KGPM3 * PI * 0.1 * 0.1 / 4.0;
    let weight_npm = (200.0 - displaced_kgpm) * STANDARD_GRAVITY_MPS2;
    Cable { length_m: 210.0, axial_stiffness_n: 1e9, weight_npm }
}

fn cables(rise_m: f64) -> Vec<Curve> {
    let cable = reference_cable();
    let tension =
        move |span_m: f64| 1e-3 * catenary(&cable, span_m, rise_m, true).upper_tension_n();
    let horizontal = move |span_m: f64| 1e-3 * catenary(&cable, span_m, rise_m, true).horizontal_n;
    // What hangs straight down is stretched by its own weight.
    let straight_n = cable.weight_npm * rise_m;
    let hanging_kn = 1e-3 * straight_n / (1.0 + straight_n / cable.axial_stiffness_n);
    let curves = vec![
        Curve::of("tension", tension)
            .value_law(
                "the tension is no less than the weight of the cable that hangs",
                move |_, value| value - hanging_kn,
            )
            .rising(STIFFENS, 0.05)
            .noisy(1e-9),
        Curve::of("horizontal", horizontal)
            .never_negative(PULLS)
            .rising(STIFFENS, 0.05)
            .noisy(1e-9),
    ];
    curves
}

fn cable() -> Sweep {
    Sweep {
        key: "line_cable",
        subject: SUBJECT,
        title: "Tension of a cable of 210 m in 50 m of water by its span".to_owned(),
        axis: Axis::new("span", "m", 120.0, 204.0),
        value: ["tension", "kN"],
        curves: cables(50.0),
        lines: Vec::new(),
        note: "The cable has EA 1,000 MN, 200 kg/m and a diameter of 0.1 m, and lies on a bottom \
               without friction.",
    }
}

/// Sweep of the same cable by depth, at a span with which it is slack at first and taut at last.
fn cable_on_bottom() -> Sweep {
    let cable = reference_cable();
    let curves = [150.0, 180.0, 200.0].map(|span_m| {
        Curve::of(format!("span {span_m} m"), move |rise_m| {
            1e-3 * catenary(&cable, span_m, rise_m, true).upper_tension_n()
        })
        .never_negative(PULLS)
        .rising("the cable in deeper water never has less tension", 0.05)
        .noisy(1e-9)
    });
    Sweep {
        key: "line_cable_depth",
        subject: SUBJECT,
        title: "Tension of the same cable by depth, from the bottom on".to_owned(),
        axis: Axis::new("depth", "m", 0.0, 60.0),
        value: ["tension", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}
