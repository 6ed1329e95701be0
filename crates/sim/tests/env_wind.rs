//! Wind coefficients compared with printed numbers, and gusts compared with the laws of their spectra.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3, PI};

use fenderline_contact::vec2;
use fenderline_sim::environment::wind::*;
use proptest::prelude::*;

/// The ship of validation/independent/ship_formulas.py: 298 × 46 m, A_L 9000 m², A_F 1700 m², centroid amidships.
fn container_ship(method: WindMethod) -> ShipWindage {
    ShipWindage {
        length_m: 298.0,
        beam_m: 46.0,
        frontal_m2: 1700.0,
        lateral_m2: 9000.0,
        centroid_forward_m: 0.0,
        centroid_height_m: 15.0,
        method,
    }
}

fn isherwood() -> ShipWindage {
    container_ship(WindMethod::Isherwood(Isherwood {
        perimeter_m: 700.0,
        superstructure_m2: 1500.0,
        mast_groups: 1.0,
    }))
}

fn blendermann() -> ShipWindage {
    let of_type = Blendermann::of_type("container ship, loaded").expect("a type of the table");
    container_ship(WindMethod::Blendermann(of_type))
}

fn fujiwara() -> ShipWindage {
    container_ship(WindMethod::Fujiwara(Fujiwara {
        on_deck_m2: 5500.0,
        on_deck_forward_m: 0.0,
        top_height_m: 45.0,
    }))
}

fn all() -> [ShipWindage; 3] {
    [isherwood(), blendermann(), fujiwara()]
}

/// Checks that `ours` is within half a unit of the last printed digit.
fn printed(ours: f64, theirs: f64) {
    assert!((ours - theirs).abs() <= 0.5e-3, "{ours} for {theirs}");
}

/// Numbers of validation/independent/ship_formulas.py, to the printed digits.
#[test]
fn isherwood_of_the_container_ship() {
    printed(isherwood().coefficients(FRAC_PI_2).sway, 0.781);
    printed(isherwood().coefficients(FRAC_PI_3).sway, 0.664);
    // Straight ahead only A_F/B² and L/B count, neither perimeter nor masts.
    printed(isherwood().coefficients(0.0).surge, -0.467);
}

/// Numbers of the same script, to the printed digits; the side force at 20 m/s to 1 kN.
#[test]
fn blendermann_of_the_container_ship() {
    printed(blendermann().coefficients(FRAC_PI_2).sway, 0.900);
    printed(blendermann().coefficients(FRAC_PI_3).sway, 0.899);
    printed(blendermann().coefficients(0.0).surge, -0.55);
    let abeam = RelativeWind { speed_mps: 20.0, angle_rad: FRAC_PI_2 };
    let [x_n, y_n, n_nm] = blendermann().force(&abeam, 1.224);
    assert!((y_n - 1.983e6).abs() < 0.5e3, "{y_n}");
    assert!(x_n.abs() < 1e-6 && n_nm.abs() < 1e-6);
    assert_eq!(blendermann().roll_moment_nm(y_n), 1.4 * 15.0 * y_n);
}

/// Three regressions for one ship have the same sign, and differ by less than a third of their mean at 90°.
#[test]
fn the_three_methods_agree_on_the_side_force_abeam() {
    let sways = all().map(|ship| ship.coefficients(FRAC_PI_2).sway);
    let mean = sways.iter().sum::<f64>() / 3.0;
    println!("CY(90°) {sways:?}");
    assert!(sways.iter().all(|sway| (sway / mean - 1.0).abs() < 0.34), "{sways:?}");
}

/// The angles include 180°: wind straight from astern gives no side force, and −180° is the same as +180°.
#[test]
fn port_and_starboard_mirror_each_other_bit_for_bit() {
    for ship in all() {
        for step in 0..=720 {
            let angle_rad = f64::from(step) * PI / 720.0;
            let (port, starboard) = (ship.coefficients(angle_rad), ship.coefficients(-angle_rad));
            assert_eq!(port.surge, starboard.surge);
            assert_eq!(port.sway, -starboard.sway);
            assert_eq!(port.yaw, -starboard.yaw);
        }
        assert_eq!(ship.coefficients(PI).sway, 0.0);
        assert_eq!(ship.coefficients(PI).yaw, 0.0);
        assert!(ship.coefficients(PI).surge > 0.2, "a following wind pushes ahead");
    }
}

/// Steps of 0.01° round the whole circle. No coefficient changes faster than 6 per radian. This bound is above the
/// slope of every table and series used here.
#[test]
fn coefficients_are_continuous_in_the_angle() {
    let step_rad = PI / 18_000.0;
    for ship in all() {
        let mut last = ship.coefficients(-PI);
        for k in -18_000..=18_000 {
            let now = ship.coefficients(f64::from(k) * step_rad);
            for (a, b) in [(now.surge, last.surge), (now.sway, last.sway), (now.yaw, last.yaw)] {
                assert!((a - b).abs() <= 6.0 * step_rad, "a jump at {} hundredths", k);
            }
            last = now;
        }
    }
}

/// Wind from the north-west comes over the port bow of a ship that heads north. If she steams into it, the speeds add
/// up.
#[test]
fn relative_wind_knows_its_side() {
    let mean = MeanWind {
        speed_mps: 10.0,
        from_rad: 315.0_f64.to_radians(),
        profile: WindProfile::Uniform,
    };
    let air_mps = Wind::steady(mean).unwrap().velocity(10.0, 0.0);
    let felt = RelativeWind::of(air_mps, vec2(0.0, 0.0), 0.0);
    assert!((felt.speed_mps - 10.0).abs() < 1e-12);
    assert!((felt.angle_rad - 0.25 * PI).abs() < 1e-12);
    let steaming = RelativeWind::of(air_mps, vec2(5.0, 0.0), 0.0);
    let ahead_mps = 5.0 + 10.0 * 0.5_f64.sqrt();
    assert!((steaming.speed_mps - ahead_mps.hypot(50.0_f64.sqrt())).abs() < 1e-12);
    let [x_n, y_n, _] = blendermann().force(&felt, 1.224);
    assert!(x_n < 0.0 && y_n > 0.0, "over the port bow: astern and to starboard");
}

#[test]
fn profiles_pass_through_ten_metres_and_grow() {
    for profile in [
        WindProfile::Power { exponent: 1.0 / 7.0 },
        WindProfile::Logarithmic { roughness_m: 0.0002 },
    ] {
        let mean = MeanWind { speed_mps: 15.0, from_rad: 0.0, profile };
        assert!((mean.speed_at(10.0) - 15.0).abs() < 1e-12);
        assert!(mean.speed_at(5.0) < 15.0 && mean.speed_at(40.0) > 15.0);
        assert!(mean.speed_at(-3.0) > 0.0);
    }
    // (40/10)^(1/7) = 1.21901.
    let power = WindProfile::Power { exponent: 1.0 / 7.0 };
    let mean = MeanWind { speed_mps: 1.0, from_rad: 0.0, profile: power };
    assert!((mean.speed_at(40.0) - 1.219_013_654).abs() < 1e-9);
}

/// The integral ∫S df with the substitution f = eˣ: 20 000 trapezoids from 1e-9 to 1e5 Hz. For spectra that fall with
/// f^(−5/3), the part outside is below 1e-3 of the whole.
fn variance(spectrum: GustSpectrum, mean_mps: f64) -> f64 {
    let (low, high, steps) = (1e-9_f64.ln(), 1e5_f64.ln(), 20_000);
    let dx = (high - low) / f64::from(steps);
    let value = |k: i32| {
        let f_hz = (low + dx * f64::from(k)).exp();
        spectrum.density(f_hz, mean_mps) * f_hz
    };
    (0..steps).map(|k| 0.5 * (value(k) + value(k + 1)) * dx).sum()
}

/// Closed forms: Davenport 6κU²; Harris 4κU² 2^(−1/3) ½B(½, ⅓) = 6.6775κU²; API σ².
#[test]
fn spectra_hold_the_variance_of_their_closed_forms() {
    let (u, kappa) = (20.0, 0.002);
    let close =
        |ours: f64, exact: f64| assert!((ours / exact - 1.0).abs() < 1e-3, "{ours} {exact}");
    close(variance(GustSpectrum::Davenport { surface_drag: kappa }, u), 6.0 * kappa * u * u);
    close(variance(GustSpectrum::Harris { surface_drag: kappa }, u), 6.6775 * kappa * u * u);
    let sigma_mps = 0.15 * u * 0.5_f64.powf(-0.125);
    close(variance(GustSpectrum::Api { peak: 0.025 }, u), sigma_mps * sigma_mps);
}

/// The branches of Ochi & Shin meet: 583·0.003 and 420·0.003^0.7/(1+0.003^0.35)^11.5 agree within the three digits of
/// the coefficients.
#[test]
fn the_branches_of_ochi_and_shin_meet() {
    let spectrum = GustSpectrum::OchiShin { surface_drag: surface_drag(20.0) };
    for f_star in [0.003, 0.1] {
        let f_hz = f_star * 2.0;
        let below = spectrum.density(f_hz * (1.0 - 1e-9), 20.0);
        let above = spectrum.density(f_hz * (1.0 + 1e-9), 20.0);
        assert!((below / above - 1.0).abs() < 2e-3, "{below} {above}");
    }
}

fn spectra() -> [GustSpectrum; 5] {
    let surface_drag = surface_drag(20.0);
    [
        GustSpectrum::Davenport { surface_drag },
        GustSpectrum::Harris { surface_drag },
        GustSpectrum::OchiShin { surface_drag },
        GustSpectrum::Npd,
        GustSpectrum::Api { peak: 0.025 },
    ]
}

const MEAN: MeanWind = MeanWind { speed_mps: 20.0, from_rad: 0.0, profile: WindProfile::Uniform };

/// The harmonics hold the energy of their band for any number of harmonics. The turbulence is between 5 and 20 % of the
/// mean, as is found over the sea.
#[test]
fn gusts_hold_the_energy_of_the_band() {
    for spectrum in spectra() {
        let deviation = |harmonics| {
            let realisation = Realisation { harmonics, seed: 1 };
            Gusts::new(&MEAN, &spectrum, realisation).unwrap().deviation_mps()
        };
        let (few, many) = (deviation(40), deviation(400));
        println!("{spectrum:?}: {many:.3} m/s");
        // Simpson's rule within each of 40 bins has an error below 1e-4.
        assert!((few / many - 1.0).abs() < 1e-4, "{few} {many}");
        assert!((0.05..0.2).contains(&(many / 20.0)), "{spectrum:?} {many}");
    }
}

/// The record has the mean and the deviation of its spectrum. Over 200 hours at 1 Hz, each harmonic above 1/3600 Hz
/// turns at least 200 times. The mean agrees to 0.02 m/s and the deviation to 2 %.
#[test]
fn a_long_record_has_the_deviation_of_its_spectrum() {
    let realisation = Realisation { harmonics: 60, seed: 42 };
    let gusts = Gusts::new(&MEAN, &GustSpectrum::Npd, realisation).unwrap();
    let n = 720_000;
    let (mut sum, mut squares) = (0.0, 0.0);
    for t in 0..n {
        let speed_mps = gusts.speed_mps(f64::from(t));
        sum += speed_mps;
        squares += speed_mps * speed_mps;
    }
    let (mean, deviation) = (sum / f64::from(n), (squares / f64::from(n)).sqrt());
    assert!(mean.abs() < 0.02, "{mean}");
    assert!((deviation / gusts.deviation_mps() - 1.0).abs() < 0.02, "{deviation}");
}

#[test]
fn the_same_seed_gives_the_same_bits_and_another_one_another_record() {
    let record = |seed| {
        let realisation = Realisation { harmonics: 50, seed };
        let gusts = Gusts::new(&MEAN, &GustSpectrum::Npd, realisation).unwrap();
        (0..100).map(|t| gusts.speed_mps(f64::from(t)).to_bits()).collect::<Vec<_>>()
    };
    assert_eq!(record(3), record(3));
    assert_ne!(record(3), record(4));
}

/// An instructor who sets the wind keeps its gusts. They are those of the same seed about the new mean, from calm to a
/// storm and back.
#[test]
fn a_changed_mean_keeps_the_gusts() {
    let gusts = |mean: &MeanWind| {
        let realisation = Realisation { harmonics: 50, seed: 3 };
        Gusts::new(mean, &GustSpectrum::Npd, realisation).unwrap()
    };
    let wind = Wind::with_gusts(MEAN, gusts(&MEAN)).unwrap();
    let storm = MeanWind { speed_mps: 30.0, from_rad: 2.0, ..MEAN };
    let changed = wind.changed_to(30.0, 2.0).unwrap();
    assert_eq!(changed, Wind::with_gusts(storm, gusts(&storm)).unwrap());
    let calm = changed.changed_to(0.0, 2.0).unwrap();
    assert_eq!(calm.velocity(10.0, 77.0).length(), 0.0);
    assert_eq!(calm.changed_to(MEAN.speed_mps, MEAN.from_rad).unwrap(), wind);
    assert!(wind.changed_to(-1.0, 0.0).is_err());
    let steady = Wind::steady(MEAN).unwrap().changed_to(5.0, 1.0).unwrap();
    assert_eq!(steady.velocity(10.0, 1.0), steady.velocity(10.0, 100.0));
}

#[test]
fn absurd_winds_are_refused_by_name() {
    let wind = |speed_mps| MeanWind { speed_mps, ..MEAN }.check().unwrap_err().to_string();
    assert_eq!(wind(1e6), "wind speed [m/s] must be between 0 and 120, but is 1000000");
    assert!(wind(f64::NAN).contains("wind speed"));
    assert!(wind(-1.0).contains("wind speed"));
    assert!(wind(f64::INFINITY).contains("wind speed"));
    let flat = ShipWindage { lateral_m2: 0.0, ..blendermann() };
    assert!(flat.check().unwrap_err().to_string().contains("lateral wind area"));
    assert!(all().iter().all(|ship| ship.check().is_ok()));
    let realisation = Realisation { harmonics: 0, seed: 0 };
    assert!(Gusts::new(&MEAN, &GustSpectrum::Npd, realisation).is_err());
    assert!(Blendermann::of_type("submarine").is_none());
}

proptest! {
    /// The forces are finite for any ship and angle within the checks.
    #[test]
    fn forces_are_finite(angle_rad in -1e3..1e3_f64, speed_mps in 0.0..120.0_f64) {
        for ship in all() {
            let force = ship.force(&RelativeWind { speed_mps, angle_rad }, 1.224);
            prop_assert!(force.iter().all(|f| f.is_finite()));
        }
    }
}

/// Variance of the wind averaged over the ship's side. It is ∫ S(f) χ²(f) df over the band of the gusts, by Simpson's
/// rule with the closed integral of the coherence for χ². The tolerance is for the harmonics: each stands for a bin of
/// 4 % in frequency.
#[test]
fn the_variance_of_the_averaged_gusts_is_the_integral_of_spectrum_and_admittance() {
    let realisation = Realisation { harmonics: 200, seed: 7 };
    let gusts = Gusts::new(&MEAN, &GustSpectrum::Npd, realisation).unwrap();
    let line = |a: f64| 2.0 * (a - 1.0 + (-a).exp()) / (a * a);
    for (width_m, height_m) in [(298.0, 30.0), (100.0, 12.0), (46.0, 30.0)] {
        let front = WindFront { width_m, height_m };
        let density = |f_hz: f64| {
            let a = 9.2 * f_hz / MEAN.speed_mps;
            GustSpectrum::Npd.density(f_hz, MEAN.speed_mps) * line(a * width_m) * line(a * height_m)
        };
        // The integration variable is ln f.
        let (low, high, steps) = ((1.0 / 3600.0_f64).ln(), 0.5_f64.ln(), 4000);
        let width = (high - low) / f64::from(steps);
        let variance: f64 = (0..=steps)
            .map(|k| {
                let f_hz = (low + width * f64::from(k)).exp();
                let weight = if k == 0 || k == steps { 1.0 } else { f64::from(2 + 2 * (k % 2)) };
                weight * density(f_hz) * f_hz * width / 3.0
            })
            .sum();
        let ours = gusts.deviation_over_mps(&front);
        assert!((ours / variance.sqrt() - 1.0).abs() < 5e-3, "{width_m}: {ours} {variance}");
        // The series has this variance over six days, in steps that are not a multiple of any harmonic's period.
        let samples = 40_000;
        let mean_square: f64 = (0..samples)
            .map(|k| gusts.speed_over_mps(&front, 12.7 * f64::from(k)).powi(2))
            .sum::<f64>()
            / f64::from(samples);
        assert!((mean_square.sqrt() / ours - 1.0).abs() < 0.01, "{width_m}: {mean_square}");
    }
    // The wind averages over the whole of her side, with bow or side to the wind, and without averaging.
    let ship = isherwood();
    assert!((ship.front(FRAC_PI_2).width_m - 298.0).abs() < 1e-9);
    assert!((ship.front(PI).width_m - 46.0).abs() < 1e-9);
    assert!((ship.front(0.0).height_m - 9000.0 / 298.0).abs() < 1e-12);
    let uniform = gusts.clone().uniform();
    assert_eq!(uniform.speed_over_mps(&ship.front(1.0), 60.0), gusts.speed_mps(60.0));
    assert_eq!(gusts.speed_over_mps(&WindFront::POINT, 60.0), gusts.speed_mps(60.0));
}
