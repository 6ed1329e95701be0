//! Ships adrift in waves, engine off.

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// The speed over the ground of a ship of 130 m after two hours in a sea of Hs 2 m [m/s], and her wave force at the
/// start, forward and to starboard [N].
fn adrift(period_s: f64, from_deg: f64) -> (f64, [f64; 2]) {
    let text = format!(
        r#"title = "Adrift"

[time]
step = "1 s"
duration = "2 h"

[environment]
waves = {{ height = "2 m", period = "{period_s} s", from = "{from_deg} deg", seed = 5 }}

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
    while !simulation.is_done() {
        simulation.step().expect("a good step");
    }
    (simulation.states()[0].velocity_mps.length(), [first.surge_n, first.sway_n])
}

/// A head sea of Hs 2 m drives her astern as slowly as ships at rest go, at 0.37 to 0.69 m/s by its period; the drift of
/// short waves for all of them gave 2.0 m/s. It is 0.60 m/s at 8 s, and
/// less than 0.6 m/s from 9 s on.
#[test]
fn a_ship_adrift_in_a_head_sea_of_two_metres_goes_slowly_astern() {
    for (period_s, most_mps) in
        [(5.0, 0.7), (6.0, 0.7), (7.0, 0.7), (8.0, 0.605), (9.0, 0.6), (12.0, 0.6)]
    {
        let (speed_mps, [surge_n, sway_n]) = adrift(period_s, 0.0);
        println!("Tp {period_s} s: {surge_n:.0} N, {speed_mps:.4} m/s");
        assert!(surge_n < 0.0 && sway_n.abs() < 1e-3);
        assert!(speed_mps > 0.05 && speed_mps < most_mps, "Tp {period_s} s: {speed_mps} m/s");
    }
}

/// From the bow, from abeam, from the quarter and from astern too.
#[test]
fn a_ship_adrift_in_any_sea_of_two_metres_goes_slowly() {
    for from_deg in [45.0, 90.0, 135.0, 180.0] {
        let (speed_mps, force_n) = adrift(7.0, from_deg);
        println!("from {from_deg} deg: {force_n:?} N, {speed_mps:.3} m/s");
        assert!(speed_mps > 0.05 && speed_mps < 0.7, "from {from_deg}: {speed_mps} m/s");
    }
}
