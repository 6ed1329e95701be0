//! Sweeps of thrusters: a tunnel thruster by speed, an azimuth unit by angle and speed.

use fenderline_report::plot::plain;
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::{AzimuthThruster, Propeller, Series, TunnelThruster, Velocity, Water};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Thrusters";
const FULL_RPS: f64 = 4.0;

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![tunnel(), tunnel_by_order(), azimuth_by_angle(), azimuth_by_speed()]
}

fn ahead(knots: f64) -> Velocity {
    Velocity { surge_mps: knots * KNOT_MPS, ..Velocity::default() }
}

/// Sweep of the tunnel thruster's force divided by its thrust at rest, by speed.
fn tunnel() -> Sweep {
    let thruster = TunnelThruster { bollard_n: 1.0, along_m: 100.0 };
    let at = move |knots: f64, order: f64| thruster.force(order, &ahead(knots)).sway_n;
    let curves = [("full", 1.0), ("half", 0.5)].map(|(name, order)| {
        Curve::of(name, move |knots| at(knots, order))
            .mirrored(move |knots| -at(knots, -order))
            .never_negative("the thruster pushes to the ordered side")
            .at_most("the thruster never pushes more than at rest", move |_| order)
    });
    Sweep {
        key: "thruster_tunnel",
        subject: SUBJECT,
        title: "Force of a tunnel thruster by speed, from astern to ahead".to_owned(),
        axis: Axis::new("speed", "kn", -10.0, 20.0),
        value: ["force / thrust at rest", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

fn tunnel_by_order() -> Sweep {
    let thruster = TunnelThruster { bollard_n: 200.0, along_m: 100.0 };
    let curves = [0.0, 3.0, 8.0].map(|knots| {
        let at = move |order: f64| thruster.force(order, &ahead(knots)).sway_n;
        Curve::of(format!("{} kn", plain(knots, 3)), at)
            .odd()
            .value_law("the thruster pushes to the ordered side", |order, value| order * value)
            .growing_at_most(1.0)
    });
    Sweep {
        key: "thruster_order",
        subject: SUBJECT,
        title: "Force of a tunnel thruster of 200 kN by order".to_owned(),
        axis: Axis::new("order", "", -1.0, 1.0),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

/// The azimuth unit of the sweeps, on the centre line, 12 m abaft midship.
fn unit() -> AzimuthThruster {
    AzimuthThruster {
        propeller: Propeller {
            diameter_m: 2.4,
            thrust_polynomial: None,
            series: Series::B4Pitch10,
        },
        along_m: -12.0,
        across_m: 0.0,
        wake: 0.1,
        thrust_deduction: 0.05,
    }
}

fn azimuth_by_angle() -> Sweep {
    let unit = unit();
    let speeds = [-5.0, 0.0, 5.0, 10.0];
    let curves = speeds.map(|knots: f64| {
        let at = move |degrees: f64| {
            let force = unit.force(FULL_RPS, degrees.to_radians(), &ahead(knots), Water::SEA);
            1e-3 * force.sway_n
        };
        Curve::of(format!("{} kn", plain(knots, 3)), at)
            .odd()
            .value_law("the unit pushes where it points", |degrees, value| {
                value * libm::sin(degrees.to_radians())
            })
    });
    Sweep {
        key: "thruster_azimuth",
        subject: SUBJECT,
        title: "Azimuth unit of 2.4 m at full revolutions: side force by the unit's angle"
            .to_owned(),
        axis: Axis::new("angle off the bow", "°", -180.0, 180.0),
        value: ["side force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The thrust is that at the speed of advance along the unit's axis. The drag of the \
               unit across it is neglected.",
    }
}

fn azimuth_by_speed() -> Sweep {
    let unit = unit();
    let curves = [0.0, 45.0, 90.0, 180.0].map(|degrees: f64| {
        let at = move |knots: f64, side: f64| {
            let velocity = Velocity { sway_mps: side * 0.5, ..ahead(knots) };
            let force = unit.force(FULL_RPS, side * degrees.to_radians(), &velocity, Water::SEA);
            let (sin, cos) = libm::sincos(degrees.to_radians());
            1e-3 * (force.surge_n * cos + side * force.sway_n * sin)
        };
        Curve::of(format!("{degrees}° off the bow"), move |knots| at(knots, 1.0))
            .mirrored(move |knots| at(knots, -1.0))
    });
    Sweep {
        key: "thruster_azimuth_speed",
        subject: SUBJECT,
        title: "The same azimuth unit: thrust by speed of the ship, while she drifts at 0.5 m/s \
                to starboard"
            .to_owned(),
        axis: Axis::new("speed", "kn", -10.0, 15.0),
        value: ["thrust", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The unit runs at full revolutions, not at full power: when the ship goes astern \
               against the thrust, the propeller series asks for more torque.",
    }
}
