//! KCS, a container ship of 230 m.

use super::{
    DEDUCTION_ASTERN, DEDUCTION_ASTERN_ESTIMATED, LOW_SPEED_ESTIMATED, SERIES_FOR_OTHER_QUADRANTS,
    Source, Standing, Vessel,
};
use crate::hydro::actuator::RateLimited;
use crate::hydro::added_mass::AddedMass;
use crate::hydro::blend::Hull;
use crate::hydro::mmg::{DriftPolynomial, Mmg, Polynomial, Propulsion, Wake};
use crate::hydro::particulars::Particulars;
use crate::hydro::propeller::{Propeller, Series};
use crate::hydro::rudder::Rudder;

const SHEET: &str = "published set in the β-form, by the design sheet";

const SOURCES: &[Source] = &[
    Source { group: "particulars", source: SHEET, standing: Standing::Published },
    Source { group: "hull polynomial, added mass", source: SHEET, standing: Standing::Published },
    Source {
        group: "propeller in its first quadrant",
        source: SHEET,
        standing: Standing::Published,
    },
    Source { group: "rudder and interaction", source: SHEET, standing: Standing::Published },
    Source {
        group: "γR by the sign of βR, place of the rudder x'R = −0.5, gyradius 0.25 L",
        source: "chosen; the sheet chooses γR by the sign of βP, where the force would jump",
        standing: Standing::Estimated,
    },
    LOW_SPEED_ESTIMATED,
    SERIES_FOR_OTHER_QUADRANTS,
    DEDUCTION_ASTERN_ESTIMATED,
];

const POLYNOMIAL: Polynomial = Polynomial::Drift(DriftPolynomial {
    x_0: -0.0167,
    x_bb: -0.0549,
    x_br: -0.1084,
    x_rr: -0.0120,
    x_bbbb: -0.0417,
    y_b: 0.2252,
    y_r: 0.0398,
    y_bbb: 1.7179,
    y_bbr: -0.4832,
    y_brr: 0.8341,
    y_rrr: -0.005,
    n_b: 0.1111,
    n_r: -0.0465,
    n_bbb: 0.1752,
    n_bbr: -0.6168,
    n_brr: 0.0512,
    n_rrr: -0.0387,
});

/// Aspect ratio of the rudder.
const ASPECT: f64 = 2.164;

/// The ship of 230 m, approach at a Froude number of 0.26, rudder 2.32°/s.
pub fn kcs() -> Vessel {
    let (length_m, beam_m, draught_m) = (230.0, 32.2, 10.8);
    let particulars = Particulars {
        length_m,
        beam_m,
        draught_m,
        volume_m3: 0.651 * length_m * beam_m * draught_m,
        centre_of_gravity_m: -3.404,
        yaw_gyradius_ratio: 0.25,
    };
    let added_mass = AddedMass { surge_m3: 1790.85, sway_m3: 44_324.18, yaw_m5: 140_067_300.0 };
    let ship = Mmg {
        particulars,
        added_mass,
        hull: Hull::from_polynomial(POLYNOMIAL, &particulars, &added_mass),
        propulsion: Some(Propulsion {
            propeller: Propeller {
                diameter_m: 7.9,
                thrust_polynomial: Some([0.5228, -0.4390, -0.0609]),
                series: Series::B4Pitch10,
            },
            thrust_deduction: 1.0 - 0.793,
            thrust_deduction_astern: DEDUCTION_ASTERN,
            wake: Wake { straight: 1.0 - 0.645, rate: 0.0, limits: [1.0, 1.0], place: -0.4565 },
            rudder: Rudder {
                area_m2: length_m * draught_m / 54.86,
                // Fujii's formula.
                lift_gradient: 6.13 * ASPECT / (2.25 + ASPECT),
                propeller_to_span: 0.798,
                wake_ratio: 0.956,
                race_gain: 0.633,
                straightening: [0.338, 0.492],
                straightening_place: -0.755,
                resistance_deduction: 1.0 - 0.742,
                hull_gain: 0.361,
                hull_place: -0.436,
                place: -0.5,
            },
        }),
    };
    Vessel {
        name: "KCS, 230 m",
        ship,
        approach_mps: 0.26 * (9.81 * length_m).sqrt(),
        steering: RateLimited::rudder(2.32, 35.0),
        sources: SOURCES,
    }
}
