//! Sweeps of the mean wave drift: frequencies, headings, speeds.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use fenderline_contact::vec2;
use fenderline_sim::constants::{KNOT_MPS, SEA_WATER_KGPM3, STANDARD_GRAVITY_MPS2};
use fenderline_sim::environment::waves::{DriftHull, RegularWave, Sea, mean_drift};

use crate::sweeps::sweep::{Axis, Curve, Sweep};

const SUBJECT: &str = "Wave drift";
const PERIODS_S: [f64; 3] = [6.0, 9.0, 14.0];

/// The tanker of the MSS toolbox; [`FPSO`] is the other ship of this toolbox.
const TANKER: DriftHull = DriftHull {
    length_m: 246.0,
    beam_m: 46.0,
    draught_m: 10.0,
    block_coefficient: 92_309.0 / (246.0 * 46.0 * 10.0),
};
const FPSO: DriftHull = DriftHull {
    length_m: 200.0,
    beam_m: 44.0,
    draught_m: 12.0,
    block_coefficient: 97_961.0 / (200.0 * 44.0 * 12.0),
};

pub(super) fn sweeps() -> Vec<Sweep> {
    vec![
        by_period(
            "drift_ahead",
            "From ahead, by period",
            PI,
            |[x, _, _]| -x,
            "force astern / ρga²",
        ),
        by_period(
            "drift_abeam",
            "From abeam, by period",
            FRAC_PI_2,
            |[_, y, _]| y,
            "side force / ρga²",
        ),
        by_heading(
            "drift_heading_surge",
            "Mean drift of a tanker by heading: longitudinal force",
            0,
            "longitudinal force / ρga²",
            "m",
        ),
        by_heading(
            "drift_heading_sway",
            "Mean drift of a tanker by heading: side force",
            1,
            "side force / ρga²",
            "m",
        ),
        by_heading(
            "drift_heading_yaw",
            "Mean drift of a tanker by heading: yaw moment",
            2,
            "yaw moment / ρga²",
            "m²",
        ),
        by_speed(),
    ]
}

/// Wave number of a wave in deep water, by its period (rad/m).
fn number_radpm(period_s: f64) -> f64 {
    let frequency_radps = TAU / period_s;
    frequency_radps * frequency_radps / STANDARD_GRAVITY_MPS2
}

fn by_period(
    key: &'static str,
    title: &str,
    direction_rad: f64,
    part: fn([f64; 3]) -> f64,
    value: &'static str,
) -> Sweep {
    let curve = |(name, hull): (&str, DriftHull)| {
        Curve::of(name, move |period_s| {
            part(hull.coefficients(number_radpm(period_s), direction_rad))
        })
        .never_negative("the drift force is in the direction of the waves")
    };
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis: Axis::new("period", "s", 3.0, 20.0),
        value: [value, "m"],
        curves: [("tanker 246 × 46 × 10 m", TANKER), ("FPSO 200 × 44 × 12 m", FPSO)]
            .map(curve)
            .into(),
        lines: Vec::new(),
        note: "The ships are at rest in regular waves in deep water.",
    }
}

fn by_heading(
    key: &'static str,
    title: &str,
    part: usize,
    value: &'static str,
    unit: &'static str,
) -> Sweep {
    let curves = PERIODS_S.map(|period_s| {
        let of = move |degrees: f64| {
            // Waves from an angle off the bow to port run towards 180° minus it.
            TANKER.coefficients(number_radpm(period_s), PI - degrees.to_radians())
        };
        let curve = Curve::of(format!("{period_s} s"), move |degrees| of(degrees)[part]);
        match part {
            0 => curve.even().law("the drift force is not against the waves", move |degrees| {
                let [surge, sway, _] = of(degrees);
                let (sin, cos) = libm::sincos(degrees.to_radians());
                sway * sin - surge * cos
            }),
            _ => curve.odd(),
        }
    });
    Sweep {
        key,
        subject: SUBJECT,
        title: title.to_owned(),
        axis: Axis::off_the_bow("waves off the bow, from port"),
        value: [value, unit],
        curves: curves.into(),
        lines: Vec::new(),
        note: "Positive values are ahead, to starboard, and bow to starboard.",
    }
}

fn by_speed() -> Sweep {
    let curves = PERIODS_S.map(|period_s| {
        let wave = RegularWave { height_m: 1.0, period_s, phase_rad: 0.0 };
        let at = move |knots: f64| {
            let sea = Sea::regular(wave, PI, 500.0).expect("a good sea");
            let going = (0.0, vec2(knots * KNOT_MPS, 0.0));
            -1e-3 * mean_drift(&sea, &TANKER, going, SEA_WATER_KGPM3)[0]
        };
        Curve::of(format!("{period_s} s"), at)
            .never_negative("the drift force is in the direction of the waves")
    });
    Sweep {
        key: "drift_speed",
        subject: SUBJECT,
        title: "Mean drift of a tanker in waves of 1 m from ahead, by speed, from astern to ahead"
            .to_owned(),
        axis: Axis::new("speed", "kn", -10.0, 16.0),
        value: ["force astern", "kN"],
        curves: curves.into(),
        lines: Vec::new(),
        note: "The speed enters by Aranha's correction of first order, which is held constant \
               beyond a quarter of the waves' speed.",
    }
}
