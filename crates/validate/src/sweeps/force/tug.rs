//! Sweeps of tugs as vectors: the force that they can give by angle and speed, and the force of an order.

use fenderline_contact::vec2;
use fenderline_sim::constants::{KNOT_MPS, SEA_WATER_KGPM3, STANDARD_GRAVITY_MPS2};
use fenderline_sim::step_time::StepTime;
use fenderline_sim::tug::{TugEnvelope, TugOrder, TugState, VectorTug};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Tugs";
const BOLLARD_N: f64 = 60e3 * STANDARD_GRAVITY_MPS2;
const WITHIN: &str = "the tug's force is between nothing and the bollard pull";

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![by_angle(), by_speed(), of_order()]
}

/// The tug of the sweeps: 60 t bollard pull, 32 × 13 × 4.5 m.
fn envelope() -> TugEnvelope {
    TugEnvelope {
        bollard_pull_n: BOLLARD_N,
        length_m: 32.0,
        beam_m: 13.0,
        draught_m: 4.5,
        drag_coefficient: 0.73,
    }
}

/// Over the bollard pull.
fn available(degrees: f64, knots: f64) -> f64 {
    let speed_mps = knots * KNOT_MPS;
    envelope().available_n(degrees.to_radians(), speed_mps, SEA_WATER_KGPM3) / BOLLARD_N
}

fn by_angle() -> Sweep {
    let curves = [0.0, 2.0, 4.0, 5.0, 6.0, 8.0].map(|knots| {
        Curve::of(format!("{knots} kn"), move |degrees| available(degrees, knots))
            .even()
            .value_law(WITHIN, |_, value| if value <= 0.5 { value } else { 1.0 - value })
    });
    Sweep {
        key: "tug_angle",
        subject: SUBJECT,
        title: "Force that a tug of 60 t bollard pull can give, by the angle of her force to the \
                motion"
            .to_owned(),
        axis: Axis::new("force off the direction of motion", "°", 0.0, 180.0),
        value: ["force / bollard pull", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "0°: she drives the ship on; 180°: she brakes. Drag that helps her is neglected.",
    }
}

fn by_speed() -> Sweep {
    let curves = [0.0, 45.0, 90.0, 135.0, 180.0].map(|degrees| {
        Curve::of(format!("{degrees}°"), move |knots| available(degrees, knots))
            .value_law(WITHIN, |_, value| if value <= 0.5 { value } else { 1.0 - value })
            .falling("a faster tug never gives more force than a slow one", 0.02)
    });
    Sweep {
        key: "tug_speed",
        subject: SUBJECT,
        title: "The same tug of 60 t bollard pull: force that she can give by speed".to_owned(),
        axis: Axis::new("speed", "kn", 0.0, 14.0),
        value: ["force / bollard pull", ""],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}

/// Sweep of the force on a ship of a tug that pushes with all her force at 90°, by the direction in which the ship
/// moves.
fn of_order() -> Sweep {
    let at = |degrees: f64, side: f64| {
        let tug = VectorTug {
            name: "tug".to_owned(),
            envelope: envelope(),
            push_at_m: vec2(40.0, -side * 20.0),
            pull_at_m: vec2(40.0, -side * 20.0),
            delay_s: 0.0,
            force_lag_s: 0.0,
            direction_lag_s: 0.0,
        };
        let mut state = TugState::default();
        let order = TugOrder::Push {
            force_n: 2.0 * BOLLARD_N,
            direction_rad: side * std::f64::consts::FRAC_PI_2,
        };
        tug.order(&mut state, 0.0, order).expect("a good order");
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let water_mps = vec2(cos, side * sin) * (5.0 * KNOT_MPS);
        let force = tug
            .step(&mut state, StepTime { t_s: 0.0, step_s: 1.0 }, water_mps, SEA_WATER_KGPM3)
            .force;
        [force[0], side * force[1], side * force[2]].map(|part| 1e-3 * part)
    };
    let curves =
        [("side force", 1, 1.0), ("yaw moment / 100 m", 2, 0.01)].map(|(name, part, unit)| {
            Curve::of(name, move |degrees| unit * at(degrees, 1.0)[part])
                .mirrored(move |degrees| unit * at(degrees, -1.0)[part])
                .never_negative("the tug pushes in the ordered direction")
        });
    Sweep {
        key: "tug_order",
        subject: SUBJECT,
        title: "The same tug of 60 t pushes to starboard with all her force on a ship at 5 kn, by \
                the ship's motion"
            .to_owned(),
        axis: Axis::new("motion off the bow, to starboard", "°", -180.0, 180.0),
        value: ["force", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "",
    }
}
