//! Computes values for waves, mooring cables and tugs.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use fenderline_sim::constants::{KNOT_MPS, SEA_WATER_KGPM3, STANDARD_GRAVITY_MPS2};
use fenderline_sim::environment::waves::{DriftHull, Jonswap};
use fenderline_sim::mooring::{Cable, catenary};
use fenderline_sim::tug::TugEnvelope;

use super::Values;

pub(super) fn compute(values: &mut Values) {
    let m0_m2 = jonswap_m0_m2();
    values.put("jonswap/m0", m0_m2, "m²");
    values.put("jonswap/height", 4.0 * m0_m2.sqrt(), "m");
    drift(values);
    cable(values);
    tug(values);
}

/// Mean wave drift of the two ships of the MSS toolbox, divided by ρga², in deep water: −X for waves from ahead, Y for
/// waves from port.
fn drift(values: &mut Values) {
    let tanker = DriftHull {
        length_m: 246.0,
        beam_m: 46.0,
        draught_m: 10.0,
        block_coefficient: 92_309.0 / (246.0 * 46.0 * 10.0),
    };
    let fpso = DriftHull {
        length_m: 200.0,
        beam_m: 44.0,
        draught_m: 12.0,
        block_coefficient: 97_961.0 / (200.0 * 44.0 * 12.0),
    };
    for (ship, hull) in [("tanker", tanker), ("fpso", fpso)] {
        for period_s in [5.95, 7.16, 8.63, 10.44, 15.32] {
            let frequency_radps = TAU / period_s;
            let number = frequency_radps * frequency_radps / STANDARD_GRAVITY_MPS2;
            let [ahead_m, ..] = hull.coefficients(number, PI);
            let [_, abeam_m, _] = hull.coefficients(number, FRAC_PI_2);
            values.put(format!("drift/{ship}/ahead/{period_s}"), -ahead_m, "m");
            values.put(format!("drift/{ship}/abeam/{period_s}"), abeam_m, "m");
        }
    }
}

/// Variance m₀ (m²) of a JONSWAP spectrum with Hs 2 m, Tp 8 s and γ 3.3: the integral from 0.2 to 4 rad/s, in strips of
/// 1e-3 rad/s.
fn jonswap_m0_m2() -> f64 {
    let sea = Jonswap { height_m: 2.0, peak_period_s: 8.0, peak_enhancement: 3.3 };
    let strip_radps = 1e-3;
    let densities = (200..4000).map(|strip| sea.density(strip_radps * (f64::from(strip) + 0.5)));
    densities.sum::<f64>() * strip_radps
}

/// Tensions of a mooring cable in sea water with EA 1e9 N, 200 kg/m, a diameter of 0.1 m and a length of 210 m, over a
/// span of 200 m and a depth of 50 m.
fn cable(values: &mut Values) {
    let displaced_kgpm = SEA_WATER_KGPM3 * PI * 0.1 * 0.1 / 4.0;
    let weight_npm = (200.0 - displaced_kgpm) * STANDARD_GRAVITY_MPS2;
    let cable = Cable { length_m: 210.0, axial_stiffness_n: 1e9, weight_npm };
    let hanging = catenary(&cable, 200.0, 50.0, true);
    values.put("cable/tension", hanging.upper_tension_n() / 1e3, "kN");
    values.put("cable/horizontal", hanging.horizontal_n / 1e3, "kN");
    values.put("cable/vertical", hanging.upper_vertical_n / 1e3, "kN");
}

/// Push of a tug beam-on to the flow, divided by her bollard pull. The tug has a bollard pull of 60 t, a length of 32
/// m, a draught of 4.5 m and the drag coefficient 0.73.
fn tug(values: &mut Values) {
    let bollard_pull_n = 60e3 * STANDARD_GRAVITY_MPS2;
    let envelope = TugEnvelope {
        bollard_pull_n,
        length_m: 32.0,
        beam_m: 13.0,
        draught_m: 4.5,
        drag_coefficient: 0.73,
    };
    for (knots, name) in [(5.0, "5"), (6.0, "6")] {
        let push_n = envelope.available_n(FRAC_PI_2, knots * KNOT_MPS, SEA_WATER_KGPM3);
        values.put(format!("tug/{name}"), push_n / bollard_pull_n, "");
    }
}
