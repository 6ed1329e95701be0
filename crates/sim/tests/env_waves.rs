//! Waves, compared with linear theory and with the energy of their spectrum, and limits of ship motion that need no
//! data.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use fenderline_contact::vec2;
use fenderline_sim::constants::STANDARD_GRAVITY_MPS2 as G;
use fenderline_sim::environment::waves::*;
use proptest::prelude::*;

const SEA: Jonswap = Jonswap { height_m: 2.0, peak_period_s: 8.0, peak_enhancement: 3.3 };

fn sea(harmonics: usize, seed: u64) -> Sea {
    Sea::jonswap(&SEA, 0.0, 1000.0, Realisation { harmonics, seed }).unwrap()
}

/// Values of validation/independent/ship_formulas.py for Hs 2 m, Tp 8 s and γ 3.3: m₀ is 0.2503 and 4√m₀ is 2.001.
/// These are integrals to 4 rad/s, by trapezoids of 1e-4 rad/s. With the tail beyond, 0.2054 (ω_p/ω)⁴ in closed form,
/// m₀ is 0.2506.
#[test]
fn the_spectrum_holds_its_energy() {
    let dw = 1e-4;
    let m0_to = |radps: f64| -> f64 {
        (2000..(radps / dw) as u32).map(|k| SEA.density(dw * f64::from(k)) * dw).sum()
    };
    let m0 = m0_to(4.0);
    println!("m0 {m0:.5} to 4 rad/s, {:.5} to 20 rad/s, 4√m0 {:.4}", m0_to(20.0), 4.0 * m0.sqrt());
    assert!((m0 - 0.2503).abs() < 0.5e-4, "{m0}");
    assert!((4.0 * m0.sqrt() - 2.001).abs() < 0.5e-3);
    let tail = 0.3125 * (1.0 - 0.287 * 3.3_f64.ln()) * (SEA.peak_radps() / 4.0).powi(4);
    assert!((m0_to(20.0) - m0 - tail).abs() < 1e-5);
}

/// With γ = 1 the spectrum is that of Pierson and Moskowitz. In closed form its m₀ is Hs²/16. The peak lies at ω_p.
#[test]
fn without_enhancement_it_is_pierson_moskowitz() {
    let sea = Jonswap { peak_enhancement: 1.0, ..SEA };
    let dw = 1e-4;
    let m0: f64 = (1..=500_000).map(|k| sea.density(dw * f64::from(k)) * dw).sum();
    // The tail beyond 50 rad/s is below 1e-5.
    assert!((m0 / 0.25 - 1.0).abs() < 1e-4, "{m0}");
    let wp = SEA.peak_radps();
    assert!(SEA.density(wp) > SEA.density(1.01 * wp));
    assert!(SEA.density(wp) > SEA.density(0.99 * wp));
}

/// For any number of harmonics, 4√m₀ equals Hs to rounding.
#[test]
fn a_sea_keeps_its_significant_height() {
    for harmonics in [1, 10, 200] {
        assert!((sea(harmonics, 5).significant_height_m() - 2.0).abs() < 1e-12);
    }
    let calm = Jonswap { height_m: 0.0, ..SEA };
    let realisation = Realisation { harmonics: 20, seed: 1 };
    let calm = Sea::jonswap(&calm, 0.0, 50.0, realisation).unwrap();
    assert_eq!(calm.elevation_m(vec2(3.0, 4.0), 5.0), 0.0);
}

/// A record of 100 000 s at 2 Hz, with 60 harmonics, each of which turns thousands of times. The tolerance of the
/// deviation is 2 %.
#[test]
fn a_long_record_has_the_height_of_its_spectrum() {
    let sea = sea(60, 9);
    let n = 200_000;
    let squares: f64 =
        (0..n).map(|k| sea.elevation_m(vec2(0.0, 0.0), 0.5 * f64::from(k)).powi(2)).sum();
    let height_m = 4.0 * (squares / f64::from(n)).sqrt();
    assert!((height_m / 2.0 - 1.0).abs() < 0.02, "{height_m}");
}

#[test]
fn the_same_seed_gives_the_same_bits() {
    let at = |seed| sea(40, seed).elevation_m(vec2(12.0, -7.0), 345.6).to_bits();
    assert_eq!(at(2), at(2));
    assert_ne!(at(2), at(3));
}

/// The equation ω² = gk tanh kh holds to rounding, in deep and shallow water.
#[test]
fn wave_lengths_follow_the_dispersion_relation() {
    for depth_m in [0.5, 5.0, 12.0, 50.0, 5000.0] {
        for frequency in [0.05, 0.3, 0.8, 2.0, 10.0] {
            let k = wave_number(frequency, depth_m);
            let back = (G * k * (k * depth_m).tanh()).sqrt();
            assert!((back / frequency - 1.0).abs() < 1e-12, "{depth_m} {frequency}");
        }
    }
    // Long waves travel at √(gh).
    assert!((0.001 / wave_number(0.001, 10.0) / (G * 10.0).sqrt() - 1.0).abs() < 1e-5);
}

/// The crest is in the origin at t = 0, and there again one wave length further and one period later. The wave travels
/// towards the east.
#[test]
fn a_regular_wave_propagates_in_its_direction() {
    let wave = RegularWave { height_m: 2.0, period_s: 8.0, phase_rad: 0.0 };
    let sea = Sea::regular(wave, FRAC_PI_2, 20.0).unwrap();
    let length_m = TAU / wave_number(TAU / 8.0, 20.0);
    assert!((sea.elevation_m(vec2(0.0, 0.0), 0.0) - 1.0).abs() < 1e-12);
    assert!((sea.elevation_m(vec2(77.0, length_m), 0.0) - 1.0).abs() < 1e-9);
    assert!((sea.elevation_m(vec2(0.0, 0.25 * length_m), 2.0) - 1.0).abs() < 1e-9);
    assert!((sea.variance_m2() - 0.5).abs() < 1e-12);
    assert!((sea.mean_period_s() - 8.0).abs() < 1e-12);
}

/// The paper's container ship: 298 × 46 × 9 m, Cb 0.694, roll period 16.5 s at GM 5 m.
const SHIP: BoxShip = BoxShip {
    length_m: 298.0,
    beam_m: 46.0,
    draught_m: 9.0,
    block_coefficient: 0.694,
    roll_period_s: 16.5,
    roll_damping: 0.15,
};

/// In very long waves a ship follows the surface: heave is the elevation, and pitch and roll are the slope. With ω =
/// 0.02 rad/s the wave is 154 km long, and the error is of order kL = 0.012.
#[test]
fn in_long_waves_the_ship_follows_the_surface() {
    let w = 0.02;
    let k = w * w / G;
    for direction_rad in [0.0, 0.7, FRAC_PI_2, 2.5, PI] {
        let [_, _, heave, roll, pitch, _] = SHIP.at(w, direction_rad, 0.0);
        assert!((heave.re + 1.0).abs() < 0.02 && heave.im.abs() < 0.02, "{heave:?}");
        // ζ = cos(ωt − kx cos μ − ky sin μ), so ∂ζ/∂x = k cos μ sin ωt = Re(−i k cos μ e^{iωt}). The bow goes up with
        // ∂ζ/∂x, and the starboard side goes down with ∂ζ/∂y.
        assert!((pitch.im + k * direction_rad.cos()).abs() < 0.02 * k, "{pitch:?}");
        assert!((roll.im - k * direction_rad.sin()).abs() < 0.02 * k, "{roll:?}");
    }
}

/// Waves with a tenth of the ship's length move her by less than 2 % of their amplitude.
#[test]
fn short_waves_do_not_move_a_ship() {
    let w = (TAU * G / 29.8).sqrt();
    let [_, _, heave, _, pitch, _] = SHIP.at(w, PI, 0.0);
    assert!(heave.modulus() < 0.02, "{heave:?}");
    assert!(pitch.modulus() < 0.02 * w * w / G, "{pitch:?}");
}

/// Roll is greatest near its natural period. There it is about 1/(2ζ) times the effective slope.
#[test]
fn roll_is_greatest_at_its_natural_period() {
    let roll = |w: f64| SHIP.at(w, FRAC_PI_2, 0.0)[3].modulus() * G / (w * w);
    let natural = TAU / 16.5;
    assert!(roll(natural) > 2.5 && roll(natural) < 1.0 / 0.3 + 1e-9, "{}", roll(natural));
    assert!(roll(natural) > roll(0.7 * natural) && roll(natural) > roll(1.5 * natural));
}

fn still(heading_rad: f64) -> ShipInWaves {
    let zero = vec2(0.0, 0.0);
    ShipInWaves { position_m: zero, velocity_mps: zero, heading_rad }
}

/// For waves from port and from starboard, heave and pitch are equal and roll is opposite, with both responses.
#[test]
fn port_and_starboard_mirror_each_other() {
    let directions: Vec<f64> = (0..=12).map(|k| f64::from(k) * PI / 12.0).collect();
    let frequencies: Vec<f64> = (1..=40).map(|k| 0.05 * f64::from(k)).collect();
    let mut operators = vec![];
    for &w in &frequencies {
        operators.extend(directions.iter().map(|&mu| SHIP.at(w, mu, 0.0)));
    }
    let table = RaoTable::new(frequencies, directions, operators).unwrap();
    for response in [MotionResponse::Table(table), MotionResponse::Estimate(SHIP)] {
        for mu in [0.3, 1.2, 2.9] {
            let port = first_order_motion(&sea(30, 1), &response, &still(-mu), 12.3).motion;
            let starboard = first_order_motion(&sea(30, 1), &response, &still(mu), 12.3).motion;
            for k in [0, 2, 4] {
                assert!((port[k] - starboard[k]).abs() < 1e-12);
            }
            assert!((port[3] + starboard[3]).abs() < 1e-12);
        }
    }
}

/// At its entries a table gives the entries' numbers. Between and beyond them the values are finite and continuous.
#[test]
fn a_table_gives_its_entries() {
    let entry = |k: f64| [Complex::new(k, -k); 6];
    let table = RaoTable::new(
        vec![0.5, 1.0],
        vec![0.0, FRAC_PI_2, PI],
        (0..6).map(|k| entry(f64::from(k))).collect(),
    )
    .unwrap();
    assert_eq!(table.at(1.0, FRAC_PI_2)[0], Complex::new(4.0, -4.0));
    assert_eq!(table.at(0.75, FRAC_PI_2)[2], Complex::new(2.5, -2.5));
    assert_eq!(table.at(0.5, -FRAC_PI_2)[1], Complex::new(-1.0, 1.0));
    assert_eq!(table.at(99.0, 0.0)[0], Complex::new(3.0, -3.0));
}

/// The rate is the derivative of the motion, for a ship under way through a sea. The test uses central differences of
/// 1e-4 s. Their error, of order ω³h²/6, is below 1e-7.
#[test]
fn rates_are_the_derivatives_of_motions() {
    let response = MotionResponse::Estimate(SHIP);
    let velocity_mps = vec2(4.0, 3.0);
    let at = |t_s: f64| {
        let ship =
            ShipInWaves { position_m: velocity_mps * t_s, velocity_mps, heading_rad: 0.6435 };
        first_order_motion(&sea(30, 8), &response, &ship, t_s)
    };
    let (h, t) = (1e-4, 77.7);
    let (before, now, after) = (at(t - h), at(t), at(t + h));
    for k in 0..6 {
        let slope = (after.motion[k] - before.motion[k]) / (2.0 * h);
        assert!((slope - now.rate[k]).abs() < 1e-6, "{k}: {slope} {}", now.rate[k]);
    }
}

/// The tanker of 246 m and the FPSO of 200 m of the MSS toolbox (Fossen & Perez; github.com/cybergalactic/MSS,
/// HYDRO/vessels_wamit). Draught and displaced volume are those in WAMIT's files.
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

fn deep_number_radpm(period_s: f64) -> f64 {
    (TAU / period_s).powi(2) / G
}

/// Mean drift over ρga² (m) at zero speed by WAMIT's pressure integration, from the toolbox (tanker.out, fpso.out). The
/// columns are the period (s), −X in head sea, and Y in beam sea. The five lengths of waves go from a fifth of the
/// ship's length to one and a half.
const WAMIT_TANKER: [(f64, f64, f64); 5] = [
    (5.95, 6.467, 90.02),
    (7.16, 8.246, 96.25),
    (8.63, 11.201, 93.61),
    (10.44, 8.567, 31.15),
    (15.32, 0.579, 1.00),
];
const WAMIT_FPSO: [(f64, f64, f64); 5] = [
    (5.95, 11.877, 90.84),
    (7.16, 10.274, 91.12),
    (8.63, 14.649, 113.83),
    (10.44, 25.562, 89.68),
    (15.32, 1.744, -0.09),
];

/// A formula without the ship's own motions is compared with a panel code that has them. If the wave is shorter than
/// 0.45 of the ship, they agree to 45 % (head sea) and 30 % (beam sea). In longer waves the formula gives at least a
/// third of the peak that heave and pitch cause. Where the code's drift falls off, the formula's falls off to within 3
/// % of the short waves' force.
#[test]
fn drift_by_frequency_agrees_with_a_panel_code_within_the_limits_of_the_formula() {
    for (hull, table) in [(TANKER, WAMIT_TANKER), (FPSO, WAMIT_FPSO)] {
        for (period_s, head_m, beam_m) in table {
            let number = deep_number_radpm(period_s);
            let [x_m, ..] = hull.coefficients(number, PI);
            let [_, y_m, _] = hull.coefficients(number, FRAC_PI_2);
            let longer = TAU / number / hull.length_m;
            println!("T {period_s} s, λ/L {longer:.2}: {:.2} {head_m}, {y_m:.2} {beam_m}", -x_m);
            let (head, beam) = (-x_m / head_m, y_m / beam_m);
            if longer < 0.45 {
                assert!((0.55..=1.45).contains(&head) && (0.7..=1.3).contains(&beam));
            } else if longer < 1.2 {
                assert!((0.35..=1.5).contains(&head) && (0.45..=1.5).contains(&beam));
            } else {
                assert!((-x_m - head_m).abs() < 0.05 * hull.beam_m);
                assert!((y_m - beam_m).abs() < 0.03 * 0.5 * hull.length_m);
            }
        }
    }
}

/// Waves of 10 m abeam. A wall over the whole length would be pushed with ½ρga² per metre. Rounded ends take off less
/// than a tenth. Long waves do not push her.
#[test]
fn short_waves_are_reflected_and_long_ones_pass() {
    for hull in [TANKER, FPSO] {
        let at =
            |length_m: f64, direction_rad: f64| hull.coefficients(TAU / length_m, direction_rad);
        let wall = at(10.0, FRAC_PI_2)[1] / (0.5 * hull.length_m);
        assert!(wall > 0.9 && wall < 1.0, "{wall}");
        let [short_m, ..] = at(10.0, PI);
        let [long_m, ..] = at(4.0 * hull.length_m, PI);
        assert!(short_m < 0.0 && long_m.abs() < 0.01 * short_m.abs(), "{short_m}, {long_m}");
        assert!(at(4.0 * hull.length_m, FRAC_PI_2)[1] < 0.01 * 0.5 * hull.length_m);
    }
}

/// The drift from port mirrors the drift from starboard, and waves from ahead give no side force. The drift has no jump
/// for any turn of the ship, in steps of a tenth of a degree.
#[test]
fn drift_is_continuous_in_heading_and_mirrors() {
    for number in [0.01, 0.03, 0.1, 0.5] {
        let at = |degrees: f64| TANKER.coefficients(number, degrees.to_radians());
        let [_, y_m, n_m2] = at(180.0);
        assert!(y_m.abs() < 1e-9 && n_m2.abs() < 1e-7);
        let mut last = at(-180.0);
        for step in -1800..=1800 {
            let degrees = 0.1 * f64::from(step);
            let now = at(degrees);
            let [x_m, y_m, n_m2] = at(-degrees);
            assert!((now[0] - x_m).abs() < 1e-9, "{degrees}");
            assert!((now[1] + y_m).abs() < 1e-9 && (now[2] + n_m2).abs() < 1e-6, "{degrees}");
            for (index, most) in [0.2, 0.6, 60.0].into_iter().enumerate() {
                assert!(
                    (now[index] - last[index]).abs() < most,
                    "{index} at {degrees}, k {number}"
                );
            }
            last = now;
        }
    }
}

/// The drift in a sea is the sum of the drift in its waves. A regular wave gives ρga²·C. A spectrum gives 2ρg∫S·C dω;
/// trapezoids of 1e-3 rad/s and 400 harmonics agree to 2 %.
#[test]
fn the_drift_in_a_sea_is_the_sum_over_its_waves() {
    let wave = RegularWave { height_m: 2.0, period_s: 8.0, phase_rad: 0.3 };
    let regular = Sea::regular(wave, FRAC_PI_2, 100.0).unwrap();
    let force = mean_drift(&regular, &TANKER, (0.4, vec2(0.0, 0.0)), 1025.0);
    let one = TANKER.coefficients(wave_number(TAU / 8.0, 100.0), FRAC_PI_2 - 0.4);
    for (force, one) in force.iter().zip(one) {
        assert!((force / (1025.0 * G * one) - 1.0).abs() < 1e-9);
    }
    let [x_n, y_n, _] = mean_drift(&sea(400, 3), &TANKER, (2.3, vec2(0.0, 0.0)), 1025.0);
    let mut sum = [0.0; 2];
    for step in 300..4000 {
        let w = 1e-3 * f64::from(step);
        let [x_m, y_m, _] = TANKER.coefficients(wave_number(w, 1000.0), -2.3);
        sum[0] += 2.0 * 1025.0 * G * SEA.density(w) * x_m * 1e-3;
        sum[1] += 2.0 * 1025.0 * G * SEA.density(w) * y_m * 1e-3;
    }
    assert!((x_n / sum[0] - 1.0).abs() < 0.02, "{x_n}, {sum:?}");
    assert!((y_n / sum[1] - 1.0).abs() < 0.02, "{y_n}, {sum:?}");
}

/// Short crests keep the height of the sea. Waves that are short compared with the draught push a box abeam as the
/// integral over all directions says, within the 1 % that fifteen directions leave open. For her sides alone the factor
/// is (n + 1)/(n + 2) with a spreading of cosⁿ: the mean of cos² by parts. Her ends, each a twentieth of her, add 2 %.
#[test]
fn short_crests_push_less_by_their_spreading() {
    let box_ship =
        DriftHull { length_m: 130.0, beam_m: 20.0, draught_m: 15.0, block_coefficient: 1.0 };
    let spectrum = Jonswap { peak_period_s: 4.0, ..SEA };
    let realisation = Realisation { harmonics: 200, seed: 3 };
    let long = Sea::jonswap(&spectrum, FRAC_PI_2, 1000.0, realisation).unwrap();
    let push = |sea: &Sea| mean_drift(sea, &box_ship, (0.0, vec2(0.0, 0.0)), 1025.0);
    let [_, along_n, _] = push(&long);
    let mut before = 0.0;
    for exponent in [2.0, 4.0, 20.0, 100.0] {
        let short = long.clone().short_crested(exponent).unwrap();
        assert!((short.significant_height_m() - long.significant_height_m()).abs() < 1e-12);
        assert_eq!(short.towards_rad(), long.towards_rad());
        assert!(short.is_short_crested() && !long.is_short_crested());
        let [_, sway_n, _] = push(&short);
        let share = sway_n / along_n;
        let number = wave_number(TAU / 4.0, 1000.0);
        let [mut all, mut weights] = [0.0; 2];
        for step in -500..=500 {
            let off_rad = FRAC_PI_2 * f64::from(step) / 500.0;
            let weight = off_rad.cos().max(0.0).powf(exponent);
            all += weight * box_ship.coefficients(number, FRAC_PI_2 + off_rad)[1];
            weights += weight;
        }
        let expected = all / weights / box_ship.coefficients(number, FRAC_PI_2)[1];
        let sides = (exponent + 1.0) / (exponent + 2.0);
        println!("n {exponent}: {share:.4}, integral {expected:.4}, sides {sides:.4}");
        assert!((share / expected - 1.0).abs() < 0.01, "{exponent}: {share}");
        assert!((share / sides - 1.0).abs() < 0.03, "{exponent}: {share}");
        assert!(share > before);
        before = share;
    }
    assert!(long.clone().short_crested(0.5).is_err());
    assert!(long.clone().short_crested(f64::NAN).is_err());
}

/// The surface slopes as much as before. With n = 2 a quarter of the slope is across the mean direction.
#[test]
fn short_crests_slope_across_too() {
    let long = sea(200, 9);
    let short = long.clone().short_crested(2.0).unwrap();
    let step_m = 0.05;
    let slopes = |sea: &Sea| {
        let mut sum = [0.0; 2];
        for sample in 0..20_000 {
            let t_s = 3.7 * f64::from(sample);
            let at = |x: f64, y: f64| sea.elevation_m(vec2(x, y), t_s);
            let slope = [at(step_m, 0.0) - at(-step_m, 0.0), at(0.0, step_m) - at(0.0, -step_m)];
            for (sum, slope) in sum.iter_mut().zip(slope) {
                *sum += slope * slope;
            }
        }
        sum
    };
    let ([along, none], [mean, across]) = (slopes(&long), slopes(&short));
    println!("across {:.3} of {:.3}", across / along, (mean + across) / along);
    assert_eq!(none, 0.0);
    // The tolerance of some per cent is for 20 000 samples and for the number of directions.
    assert!(((mean + across) / along - 1.0).abs() < 0.03);
    assert!((across / along - 0.25).abs() < 0.02);
}

#[test]
fn absurd_seas_are_refused_by_name() {
    let realisation = Realisation { harmonics: 10, seed: 0 };
    let high = Jonswap { height_m: 1e6, ..SEA };
    let error = Sea::jonswap(&high, 0.0, 10.0, realisation).unwrap_err().to_string();
    assert_eq!(error, "significant wave height [m] must be between 0 and 30, but is 1000000");
    assert!(Sea::jonswap(&SEA, f64::NAN, 10.0, realisation).is_err());
    assert!(Sea::jonswap(&SEA, 0.0, 0.0, realisation).is_err());
    let steep = RegularWave { height_m: 10.0, period_s: 4.0, phase_rad: 0.0 };
    assert!(Sea::regular(steep, 0.0, 10.0).unwrap_err().to_string().contains("wave height"));
    let one = vec![[Complex::default(); 6]; 2];
    assert!(RaoTable::new(vec![1.0], vec![0.0, 1.0], one.clone()).is_err());
    assert!(RaoTable::new(vec![1.0], vec![0.0, PI], one[..1].to_vec()).is_err());
    assert!(RaoTable::new(vec![1.0], vec![0.0, PI], one).is_ok());
    let hull = DriftHull { draught_m: 0.0, ..TANKER };
    assert!(hull.check().unwrap_err().to_string().contains("draught"));
    assert!(SHIP.check().is_ok());
    assert!(BoxShip { draught_m: 1.0, ..SHIP }.check().is_err());
}

proptest! {
    /// The estimate is finite for any ship, wave, direction and speed. No motion is larger than ten times the wave.
    #[test]
    fn the_estimate_is_finite(
        w in 0.01..6.0_f64,
        mu in -7.0..7.0_f64,
        speed_mps in -5.0..15.0_f64,
        draught_m in 4.0..20.0_f64,
    ) {
        let ship = BoxShip { draught_m, ..SHIP };
        prop_assert!(ship.check().is_ok());
        let operators = ship.at(w, mu, speed_mps);
        let heave = operators[2].modulus();
        prop_assert!(heave.is_finite() && heave < 10.0, "{}", heave);
        prop_assert!(operators.iter().all(|o| o.modulus().is_finite()));
    }
}
