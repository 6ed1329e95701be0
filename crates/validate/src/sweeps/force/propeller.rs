//! Sweeps of the propeller's force in all four quadrants.

use std::f64::consts::PI;

use fenderline_report::plot::plain;
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::hydro::{Controls, Propeller, Series, Velocity, Water};

use crate::computed::ships::vessel;
use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Propeller";

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![
        by_angle(
            "propeller_thrust",
            "Thrust of propellers by angle of advance, through all four quadrants",
            "C_T*",
            thrust,
        ),
        by_angle(
            "propeller_torque",
            "Torque of propellers by angle of advance, through all four quadrants",
            "C_Q*",
            torque,
        ),
        ahead(),
        behind_ship(),
        by_revolutions(),
        astern(),
    ]
}

fn propellers() -> [(&'static str, Propeller); 4] {
    let series = |series| Propeller { diameter_m: 1.0, thrust_polynomial: None, series };
    let own = |name| vessel(name).ship.propulsion.expect("she has a propeller").propeller;
    [
        ("B4-70, pitch 0.8", series(Series::B4Pitch08)),
        ("B4-70, pitch 1.0", series(Series::B4Pitch10)),
        ("KVLCC2", own("kvlcc2")),
        ("KCS", own("kcs")),
    ]
}

/// Speed of advance and revolutions of a propeller at an angle β (°), for a resultant of 1 m/s of the speed of advance
/// and the blades' speed at 0.7 of the radius.
fn flow(propeller: &Propeller, degrees: f64) -> (f64, f64) {
    let (sin, cos) = libm::sincos(degrees.to_radians());
    (sin, cos / (0.7 * PI * propeller.diameter_m))
}

fn disc_n(propeller: &Propeller) -> f64 {
    0.5 * Water::SEA.density_kgpm3 * 0.25 * PI * propeller.diameter_m * propeller.diameter_m
}

fn thrust(propeller: &Propeller, degrees: f64) -> f64 {
    let (advance_mps, rps) = flow(propeller, degrees);
    propeller.thrust_n(advance_mps, rps, Water::SEA) / disc_n(propeller)
}

fn torque(propeller: &Propeller, degrees: f64) -> f64 {
    let (advance_mps, rps) = flow(propeller, degrees);
    let unit_nm = disc_n(propeller) * propeller.diameter_m;
    propeller.torque_nm(advance_mps, rps, Water::SEA) / unit_nm
}

fn by_angle(
    key: &'static str,
    title: &str,
    value: &'static str,
    of: fn(&Propeller, f64) -> f64,
) -> Sweep {
    let curve = |(name, propeller): (&str, Propeller)| {
        Curve::of(name, move |degrees| of(&propeller, degrees))
            .law(
                "the propeller of a ship at a bollard pushes in the sense of its revolutions",
                move |degrees| match degrees {
                    _ if degrees == 0.0 => of(&propeller, 0.0),
                    _ if degrees == 180.0 => -of(&propeller, 180.0),
                    _ => 0.0,
                },
            )
            .law("a stopped propeller brakes", move |degrees| match degrees {
                _ if degrees == 90.0 => -of(&propeller, 90.0),
                _ if degrees == 270.0 => of(&propeller, 270.0),
                _ => 0.0,
            })
            .same_as("a whole turn later", move |degrees| of(&propeller, degrees - 360.0))
    };
    // The KCS has a propeller of KVLCC2's kind: torque is of the series for both.
    let curves = propellers().map(curve);
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis: Axis::new("angle of advance β", "°", 0.0, 360.0),
        value: [value, ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "0 to 90° ahead, going ahead; 90 to 180° astern, going ahead; 180 to 270° astern, going astern; 270 to 360° ahead, going \
               astern. Over ½ρ(V² + (0.7πnD)²)πD²/4, and that times D. The ships have polynomials of their own for the thrust ahead, \
               the series for the rest.",
    }
}

/// K_T ahead by J.
fn ahead() -> Sweep {
    let curve = |(name, propeller): (&str, Propeller)| {
        Curve::of(name, move |advance: f64| {
            let square = propeller.diameter_m * propeller.diameter_m;
            let thrust_n = propeller.thrust_n(advance * propeller.diameter_m, 1.0, Water::SEA);
            thrust_n / (Water::SEA.density_kgpm3 * square * square)
        })
        .falling("thrust falls with speed", 0.01)
    };
    Sweep {
        key: "propeller_ahead",
        subject: SUBJECT,
        title: "K_T ahead by J".to_owned(),
        axis: Axis::new("J", "", 0.0, 1.0),
        value: ["K_T", ""],
        curves: propellers().map(curve).into(),
        lines: Vec::new(),
        note: "",
    }
}

/// Curve of the force of KVLCC2's propeller on the ship, by her speed.
fn behind_ship() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let at = move |knots: f64, shaft_rps: f64, side: f64| {
        let velocity =
            Velocity { surge_mps: knots * KNOT_MPS, sway_mps: side * 0.5, yaw_radps: side * 0.003 };
        let controls = Controls { shaft_rps, rudder_rad: 0.0 };
        1e-3 * ship.parts(&velocity, &controls, Water::SEA).propeller.surge_n
    };
    let orders = [
        ("80 rpm ahead", 80.0),
        ("40 rpm ahead", 40.0),
        ("stopped", 0.0),
        ("55 rpm astern", -55.0),
    ];
    let curves = orders.map(|(name, rpm)| {
        let curve = Curve::of(name, move |knots| at(knots, rpm / 60.0, 1.0));
        match rpm {
            _ if rpm == 0.0 => curve
                .value_law("a stopped propeller brakes", |knots, value| -value * knots)
                .growing_at_most(2.0),
            _ => curve,
        }
    });
    Sweep {
        key: "propeller_behind",
        subject: SUBJECT,
        title: "KVLCC2: force of the propeller on the ship by her speed, from astern to ahead"
            .to_owned(),
        axis: Axis::new("speed", "kn", -8.0, 16.0),
        value: ["force ahead", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The force includes wake and thrust deduction; the ship drifts at 0.5 m/s and turns \
               at 0.17 °/s to starboard.",
    }
}

/// Sweep of the force of KVLCC2's propeller by revolutions, at three speeds.
fn by_revolutions() -> Sweep {
    let ship = vessel("kvlcc2").ship;
    let curves = [-5.0, 0.0, 5.0, 15.0].map(|knots| {
        let at = move |rpm: f64| {
            let velocity = Velocity { surge_mps: knots * KNOT_MPS, ..Velocity::default() };
            let controls = Controls { shaft_rps: rpm / 60.0, rudder_rad: 0.0 };
            1e-3 * ship.parts(&velocity, &controls, Water::SEA).propeller.surge_n
        };
        let curve = Curve::of(format!("{} kn", plain(knots, 3)), at);
        match knots {
            _ if knots == 0.0 => curve
                .value_law(
                    "the propeller of a ship at a bollard pushes in the sense of its revolutions",
                    |rpm, value| value * rpm,
                )
                .growing_at_most(2.0),
            _ => curve,
        }
    });
    Sweep {
        key: "propeller_revolutions",
        subject: SUBJECT,
        title: "KVLCC2: force of the propeller on the ship by its revolutions".to_owned(),
        axis: Axis::new("revolutions", "rpm", -80.0, 90.0),
        value: ["force ahead", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

/// Sweep of the force on KVLCC2 divided by ρn²D⁴ with her propeller astern, by Js = u/(nD).
fn astern() -> Sweep {
    let propulsion = vessel("kvlcc2").ship.propulsion.expect("she has a propeller");
    let at = move |js: f64| {
        let diameter_m = propulsion.propeller.diameter_m;
        let square = diameter_m * diameter_m;
        let advance_mps = -(1.0 - propulsion.wake.straight) * js * diameter_m;
        let thrust_n = propulsion.propeller.thrust_n(advance_mps, -1.0, Water::SEA);
        let force_n = (1.0 - propulsion.thrust_deduction_astern) * thrust_n;
        force_n / (Water::SEA.density_kgpm3 * square * square)
    };
    Sweep {
        key: "propeller_astern",
        subject: SUBJECT,
        title: "KVLCC2: force of the propeller going astern, by the ship's speed".to_owned(),
        axis: Axis::new("u/(nD): negative ahead, positive astern", "", -0.6, 0.4),
        value: ["X / (ρn²D⁴)", ""],
        curves: vec![Curve::of("KVLCC2", at).never_positive("it pulls her astern")],
        lines: Vec::new(),
        note: "",
    }
}
