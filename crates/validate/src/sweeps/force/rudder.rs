//! Sweeps of the rudder's force: all angles of the blade, drift angles, speeds, propeller ahead and astern.

use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::{Controls, Mmg, Velocity, Water};

use crate::computed::ships::vessel;
use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Rudder";
/// The states of the ship: speed (kn) and revolutions of the propeller (rpm).
const STATES: [(&str, f64, f64); 6] = [
    ("15 kn, 75 rpm ahead", 15.0, 75.0),
    ("5 kn, 40 rpm ahead", 5.0, 40.0),
    ("5 kn, stopped", 5.0, 0.0),
    ("at rest, 40 rpm ahead", 0.0, 40.0),
    ("5 kn, 40 rpm astern", 5.0, -40.0),
    ("5 kn astern, 40 rpm astern", -5.0, -40.0),
];

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![by_blade(), by_blade_yaw(), by_drift(), by_speed()]
}

#[derive(Clone, Copy)]
struct State {
    surge_mps: f64,
    sway_mps: f64,
    yaw_radps: f64,
    shaft_rps: f64,
    rudder_deg: f64,
}

impl State {
    fn of(knots: f64, rpm: f64) -> State {
        State {
            surge_mps: knots * KNOT_MPS,
            sway_mps: 0.0,
            yaw_radps: 0.0,
            shaft_rps: rpm / 60.0,
            rudder_deg: 0.0,
        }
    }

    /// Forces and moment [X, Y, N] of the rudder (kN, kN, MN·m) in this state of the ship; with `side` −1 in the mirror
    /// image of the state, with the signs turned back.
    fn force(&self, ship: &Mmg, side: f64) -> [f64; 3] {
        let velocity = Velocity {
            surge_mps: self.surge_mps,
            sway_mps: side * self.sway_mps,
            yaw_radps: side * self.yaw_radps,
        };
        let controls =
            Controls { shaft_rps: self.shaft_rps, rudder_rad: side * self.rudder_deg.to_radians() };
        let force = ship.parts(&velocity, &controls, Water::SEA).rudder;
        [1e-3 * force.surge_n, 1e-3 * side * force.sway_n, 1e-6 * side * force.yaw_nm]
    }
}

fn by_blade() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let curves = STATES.map(|(name, knots, rpm)| {
        let at = move |rudder_deg: f64, side: f64| {
            State { rudder_deg, ..State::of(knots, rpm) }.force(&ship, side)[1]
        };
        let curve = Curve::of(name, move |degrees| at(degrees, 1.0)).mirrored(move |d| at(d, -1.0));
        match knots {
            _ if knots >= 0.0 && rpm >= 0.0 => curve.value_law(
                "a rudder to starboard pushes the ship's stern to port",
                |degrees, value| -value * libm::sin(degrees.to_radians()),
            ),
            _ => curve,
        }
    });
    Sweep {
        key: "rudder_sway",
        subject: SUBJECT,
        title: "KVLCC2: side force of the rudder by the rudder's angle".to_owned(),
        axis: Axis::new("rudder", "°", -90.0, 90.0),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The force includes the force that the rudder makes on the hull. A positive rudder \
               angle turns the ship to starboard as she goes ahead. The law of the MMG method has \
               no stall: beyond 35° or so it gives too large a force.",
    }
}

fn by_blade_yaw() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let curves = STATES.map(|(name, knots, rpm)| {
        let at = move |rudder_deg: f64, side: f64| {
            State { rudder_deg, ..State::of(knots, rpm) }.force(&ship, side)[2]
        };
        let curve = Curve::of(name, move |degrees| at(degrees, 1.0)).mirrored(move |d| at(d, -1.0));
        match knots {
            _ if knots >= 0.0 && rpm >= 0.0 => curve.value_law(
                "a rudder to starboard turns the ship's bow to starboard",
                |degrees, value| value * libm::sin(degrees.to_radians()),
            ),
            _ => curve,
        }
    });
    Sweep {
        key: "rudder_yaw",
        subject: SUBJECT,
        title: "KVLCC2: yaw moment of the rudder by the rudder's angle".to_owned(),
        axis: Axis::new("rudder", "°", -90.0, 90.0),
        value: ["yaw moment", "MN·m"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "About midship.",
    }
}

fn by_drift() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let states = [("40 rpm ahead", 40.0), ("stopped", 0.0), ("40 rpm astern", -40.0)];
    let curves = states.map(|(name, rpm)| {
        let at = move |degrees: f64| {
            let (sin, cos) = libm::sincos(degrees.to_radians());
            let speed_mps = 5.0 * KNOT_MPS;
            State { surge_mps: speed_mps * cos, sway_mps: speed_mps * sin, ..State::of(0.0, rpm) }
                .force(&ship, 1.0)[1]
        };
        Curve::of(name, at).same_as("a whole turn later", move |degrees| at(degrees - 360.0))
    });
    Sweep {
        key: "rudder_drift",
        subject: SUBJECT,
        title:
            "KVLCC2 drifting at 5 kn, rudder amidships: side force by the direction of the drift"
                .to_owned(),
        axis: Axis::new("motion off the bow, to starboard", "°", 0.0, 360.0),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The forces on the two sides differ, because the ship's measured flow straightening \
               differs.",
    }
}

fn by_speed() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let states = [
        ("80 rpm ahead", 80.0),
        ("40 rpm ahead", 40.0),
        ("stopped", 0.0),
        ("55 rpm astern", -55.0),
    ];
    let curves = states.map(|(name, rpm)| {
        let at = move |knots: f64, side: f64| {
            State { rudder_deg: 20.0, ..State::of(knots, rpm) }.force(&ship, side)[1]
        };
        let curve = Curve::of(name, move |knots| at(knots, 1.0)).mirrored(move |k| at(k, -1.0));
        match rpm {
            _ if rpm == 0.0 => curve
                .value_law(
                    "without a propeller race the force turns its sign with the motion",
                    |knots, value| -value * knots,
                )
                .growing_at_most(2.0),
            _ => curve,
        }
    });
    Sweep {
        key: "rudder_speed",
        subject: SUBJECT,
        title: "KVLCC2, rudder 20° to starboard: side force by speed, from astern to ahead"
            .to_owned(),
        axis: Axis::new("speed", "kn", -8.0, 16.0),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}
