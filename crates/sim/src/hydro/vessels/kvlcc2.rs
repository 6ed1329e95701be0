//! KVLCC2, a tanker of 320 m.

use super::{
    DEDUCTION_ASTERN, DEDUCTION_ASTERN_ESTIMATED, LOW_SPEED_ESTIMATED, SERIES_FOR_OTHER_QUADRANTS,
    Source, Standing, Vessel,
};
use crate::hydro::actuator::RateLimited;
use crate::hydro::added_mass::AddedMass;
use crate::hydro::blend::Hull;
use crate::hydro::mmg::{Mmg, Polynomial, Propulsion, SwayPolynomial, Wake};
use crate::hydro::particulars::Particulars;
use crate::hydro::propeller::{Propeller, Series};
use crate::hydro::rudder::Rudder;

const YASUKAWA: &str = "Yasukawa & Yoshimura, J. Mar. Sci. Technol. 20 (2015), tables 1 and 3";

const SOURCES: &[Source] = &[
    Source { group: "particulars", source: YASUKAWA, standing: Standing::Published },
    Source {
        group: "hull polynomial, added mass",
        source: YASUKAWA,
        standing: Standing::Published,
    },
    Source {
        group: "propeller in its first quadrant",
        source: YASUKAWA,
        standing: Standing::Published,
    },
    Source { group: "rudder and interaction", source: YASUKAWA, standing: Standing::Published },
    Source {
        group: "place of the propeller x'P = −0.48, rudder rate and stop",
        source: "recalled; the rate is that of the free-running tests",
        standing: Standing::Recalled,
    },
    LOW_SPEED_ESTIMATED,
    SERIES_FOR_OTHER_QUADRANTS,
    DEDUCTION_ASTERN_ESTIMATED,
];

const POLYNOMIAL: Polynomial = Polynomial::Sway(SwayPolynomial {
    resistance: 0.022,
    x_vv: -0.040,
    x_vr: 0.002,
    x_rr: 0.011,
    x_vvvv: 0.771,
    y_v: -0.315,
    y_r: 0.083,
    y_vvv: -1.607,
    y_vvr: 0.379,
    y_vrr: -0.391,
    y_rrr: 0.008,
    n_v: -0.137,
    n_r: -0.049,
    n_vvv: -0.030,
    n_vvr: -0.294,
    n_vrr: 0.055,
    n_rrr: -0.013,
});

/// Dimensions that differ between the model and the ship.
struct Scale {
    particulars: Particulars,
    propeller_m: f64,
    rudder_span_m: f64,
    rudder_m2: f64,
    wake: f64,
}

/// The ship of 320 m, approach at 15.5 knots, rudder 1.76°/s.
pub fn kvlcc2() -> Vessel {
    Vessel {
        name: "KVLCC2, 320 m",
        ship: model_of(&Scale {
            particulars: Particulars {
                length_m: 320.0,
                beam_m: 58.0,
                draught_m: 20.8,
                volume_m3: 312_600.0,
                centre_of_gravity_m: 11.2,
                yaw_gyradius_ratio: 0.25,
            },
            propeller_m: 9.86,
            rudder_span_m: 15.8,
            rudder_m2: 112.5,
            wake: 0.35,
        }),
        approach_mps: 15.5 * 1852.0 / 3600.0,
        steering: RateLimited::rudder(1.76, 35.0),
        sources: SOURCES,
    }
}

/// The model of 7 m, approach at the same Froude number, rudder at the same rate in model time.
pub fn kvlcc2_model() -> Vessel {
    let time_scale = (320.0_f64 / 7.0).sqrt();
    Vessel {
        name: "KVLCC2, model of 7 m",
        ship: model_of(&Scale {
            particulars: Particulars {
                length_m: 7.0,
                beam_m: 1.27,
                draught_m: 0.46,
                volume_m3: 3.27,
                centre_of_gravity_m: 0.25,
                yaw_gyradius_ratio: 0.25,
            },
            propeller_m: 0.216,
            rudder_span_m: 0.345,
            rudder_m2: 0.0539,
            wake: 0.40,
        }),
        approach_mps: 15.5 * 1852.0 / 3600.0 / time_scale,
        steering: RateLimited::rudder(1.76 * time_scale, 35.0),
        sources: SOURCES,
    }
}

fn model_of(scale: &Scale) -> Mmg {
    let particulars = scale.particulars;
    let added_mass = AddedMass::from_mmg(&particulars, 0.022, 0.223, 0.011);
    Mmg {
        particulars,
        added_mass,
        hull: Hull::from_polynomial(POLYNOMIAL, &particulars, &added_mass),
        propulsion: Some(Propulsion {
            propeller: Propeller {
                diameter_m: scale.propeller_m,
                thrust_polynomial: Some([0.2931, -0.2753, -0.1385]),
                series: Series::B4Pitch08,
            },
            thrust_deduction: 0.220,
            thrust_deduction_astern: DEDUCTION_ASTERN,
            wake: Wake { straight: scale.wake, rate: 2.0, limits: [1.1, 1.6], place: -0.48 },
            rudder: Rudder {
                area_m2: scale.rudder_m2,
                lift_gradient: 2.747,
                propeller_to_span: scale.propeller_m / scale.rudder_span_m,
                wake_ratio: 1.09,
                race_gain: 0.50,
                straightening: [0.395, 0.640],
                straightening_place: -0.710,
                resistance_deduction: 0.387,
                hull_gain: 0.312,
                hull_place: -0.464,
                place: -0.5,
            },
        }),
    }
}
