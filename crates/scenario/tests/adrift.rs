//! Ships adrift in waves, engine off.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// The motion of a ship of 130 m adrift for two hours in a sea of Hs 2 m.
struct Adrift {
    /// Her wave force at the start, forward and to starboard (N).
    first_n: [f64; 2],
    /// Her greatest speed over the ground while her bow was within 5° of the waves (m/s); 0 if it never was.
    bow_on_mps: f64,
    /// Her speed over the ground at the end (m/s), and the wave force there (N).
    last_mps: f64,
    last_n: f64,
}

fn adrift(period_s: f64, from_deg: f64, spreading: &str) -> Adrift {
    let text = format!(
        r#"title = "Adrift"

[time]
step = "1 s"
duration = "2 h"

[environment]
waves = {{ height = "2 m", period = "{period_s} s", from = "{from_deg} deg", seed = 5{spreading} }}

[vessel.coaster]
length_bp = "130 m"
beam = "20 m"
draught = "7.5 m"
block_coefficient = 0.74
propeller = {{ diameter = "4.4 m", full = "130 rpm" }}
rudder = {{ area = "18 m^2", span = "5 m" }}

[body.ship]
vessel = "coaster"
outline = [[-65, -10], [45, -10], [65, 0], [45, 10], [-65, 10]]
"#
    );
    let scenario = Scenario::parse(&text, "adrift.toml").unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).unwrap_or_else(|error| panic!("{error}"));
    let first = simulation.step().expect("a good step").vessel_forces[0].waves;
    let (mut bow_on_mps, mut last) = (0.0_f64, first);
    while !simulation.is_done() {
        last = simulation.step().expect("a good step").vessel_forces[0].waves;
        let ship = &simulation.states()[0];
        let off_rad = (ship.heading_rad - from_deg.to_radians()).rem_euclid(std::f64::consts::TAU);
        if off_rad.min(std::f64::consts::TAU - off_rad) < 5_f64.to_radians() {
            bow_on_mps = bow_on_mps.max(ship.velocity_mps.length());
        }
    }
    Adrift {
        first_n: [first.surge_n, first.sway_n],
        bow_on_mps,
        last_mps: simulation.states()[0].velocity_mps.length(),
        last_n: (last.surge_n * last.surge_n + last.sway_n * last.sway_n).sqrt(),
    }
}

/// A head sea of Hs 2 m drives her astern at less than 0.6 m/s at every period, as is observed. (Applying the
/// short-wave drift force at every period gave 2.0 m/s.)
///
/// No ship keeps her bow to the sea without help. In an hour or two she lies abeam; the next test is about that drift.
#[test]
fn a_ship_adrift_in_a_head_sea_of_two_metres_goes_slowly_astern() {
    for period_s in [5.0, 6.0, 7.0, 8.0, 9.0, 10.0, 12.0] {
        let Adrift { first_n: [surge_n, sway_n], bow_on_mps, last_mps, .. } =
            adrift(period_s, 0.0, "");
        println!(
            "Tp {period_s} s: {surge_n:.0} N, bow on {bow_on_mps:.3} m/s, at last {last_mps:.3} m/s"
        );
        assert!(surge_n < 0.0 && sway_n.abs() < 1e-3);
        assert!(bow_on_mps > 0.05 && bow_on_mps < 0.6, "Tp {period_s} s: {bow_on_mps} m/s");
        assert!(last_mps < 0.7, "Tp {period_s} s: {last_mps} m/s");
    }
}

/// ρg Hs²/16 · L: the force if all waves are reflected over the whole length (N).
const ALL_REFLECTED_N: f64 = 1025.0 * 9.806_65 * 4.0 / 16.0 * 130.0;

/// Abeam she drifts at up to 0.69 m/s in long crests, and 0.64 m/s in the short crests of a wind sea.
///
/// The speed is plausible. If the ship reflected all waves over her whole length, the force would be 327 kN. At rest
/// she has 0.81 to 0.94 of that (a panel code gives 0.73 to 1.14 for two other ships, `validation/wave_drift.toml`),
/// and moving with the waves removes four tenths. To drift at only 0.6 m/s under the rest, she would need a transverse
/// drag coefficient of up to 1.1; Hoerner has 0.76 for her section, and Esso Osaka's tests give 0.97.
#[test]
fn a_ship_adrift_abeam_drifts_at_the_speed_that_reflected_waves_give() {
    for (spreading, most_mps, least) in [("", 0.7, 0.8), (", spreading = 2", 0.65, 0.6)] {
        for period_s in [5.0, 6.0, 7.0] {
            let Adrift { first_n: [_, sway_n], last_mps, last_n, .. } =
                adrift(period_s, 90.0, spreading);
            let share = -sway_n / ALL_REFLECTED_N;
            // The force falls in proportion to her speed.
            let at_limit_n = -sway_n - (-sway_n - last_n) * 0.6 / last_mps;
            let drag = at_limit_n / (0.5 * 1025.0 * 130.0 * 7.5 * 0.6 * 0.6);
            println!(
                "Tp {period_s} s{spreading}: {share:.3} of all, {last_mps:.3} m/s; 0.6 m/s by a drag coefficient of {drag:.3}"
            );
            assert!(share > least && share < 1.0, "Tp {period_s} s: {share}");
            assert!(last_mps > 0.5 && last_mps < most_mps, "Tp {period_s} s: {last_mps} m/s");
            assert!(drag > 0.76 && drag < 1.12, "Tp {period_s} s: {drag}");
        }
    }
}

/// Waves from the bow, the quarter and astern.
#[test]
fn a_ship_adrift_in_any_sea_of_two_metres_goes_slowly() {
    for from_deg in [45.0, 135.0, 180.0] {
        let Adrift { first_n, last_mps, .. } = adrift(7.0, from_deg, "");
        println!("from {from_deg} deg: {first_n:?} N, {last_mps:.3} m/s");
        assert!(last_mps > 0.05 && last_mps < 0.7, "from {from_deg}: {last_mps} m/s");
    }
}
