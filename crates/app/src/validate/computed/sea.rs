//! Waves, mooring cable and tug.

use std::f64::consts::{FRAC_PI_2, PI};

use fenderline_sim::environment::waves::Jonswap;
use fenderline_sim::mooring::{Cable, catenary};
use fenderline_sim::tug::TugEnvelope;

use super::Values;
use super::ships::SEA_KGPM3;

/// Acceleration of gravity [m/s²].
const GRAVITY_MPS2: f64 = 9.806_65;
/// Metres a second in a knot.
const KNOT_MPS: f64 = 1852.0 / 3600.0;

pub(super) fn compute(values: &mut Values) {
    let m0_m2 = jonswap_m0_m2();
    values.put("jonswap/m0", m0_m2, "m²");
    values.put("jonswap/height", 4.0 * m0_m2.sqrt(), "m");
    cable(values);
    tug(values);
}

/// Hs 2 m, Tp 8 s, γ 3.3, from 0.2 to 4 rad/s, in strips of 1e-3 rad/s.
fn jonswap_m0_m2() -> f64 {
    let sea = Jonswap { height_m: 2.0, peak_period_s: 8.0, peak_enhancement: 3.3 };
    let strip_radps = 1e-3;
    let densities = (200..4000).map(|strip| sea.density(strip_radps * (f64::from(strip) + 0.5)));
    densities.sum::<f64>() * strip_radps
}

/// EA 1e9 N, 200 kg/m, ø 0.1 m in sea water, 210 m over a span of 200 m and a depth of 50 m.
fn cable(values: &mut Values) {
    let displaced_kgpm = SEA_KGPM3 * PI * 0.1 * 0.1 / 4.0;
    let weight_npm = (200.0 - displaced_kgpm) * GRAVITY_MPS2;
    let cable = Cable { length_m: 210.0, axial_stiffness_n: 1e9, weight_npm };
    let hanging = catenary(&cable, 200.0, 50.0, true);
    values.put("cable/tension", hanging.upper_tension_n() / 1e3, "kN");
    values.put("cable/horizontal", hanging.horizontal_n / 1e3, "kN");
    values.put("cable/vertical", hanging.upper_vertical_n / 1e3, "kN");
}

/// Beam-on push of a tug of 60 t bollard pull, 32 × 4.5 m, Cd 0.73, over the bollard pull.
fn tug(values: &mut Values) {
    let bollard_pull_n = 60e3 * GRAVITY_MPS2;
    let envelope = TugEnvelope {
        bollard_pull_n,
        length_m: 32.0,
        beam_m: 13.0,
        draught_m: 4.5,
        drag_coefficient: 0.73,
    };
    for (knots, name) in [(5.0, "5"), (6.0, "6")] {
        let push_n = envelope.available_n(FRAC_PI_2, knots * KNOT_MPS, SEA_KGPM3);
        values.put(format!("tug/{name}"), push_n / bollard_pull_n, "");
    }
}
