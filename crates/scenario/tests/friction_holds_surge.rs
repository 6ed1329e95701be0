//! A ship who is pressed on fenders and surges in resonance, with and without friction at them.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::f64::consts::{PI, TAU};

use fenderline_contact::{Wrench, vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

/// 20 000 t on two fenders, 60 m apart.
const SHIP: &str = r#"
[time]
step = "0.1 s"
duration = "3 h"

[body.ship]
mass = "20000 t"
gyradius = "25 m"
outline = [[-50, -14], [50, -14], [50, 14], [-50, 14]]
position = [0, -15.4]

[body.quay]
fixed = true
outline = [[-120, 5], [120, 5], [120, 20], [-120, 20]]

[material.rubber]
stiffness = "1 MN/m^2"
shear_stiffness = "60 MN/m"
# friction

[fender_row.face]
on = "quay"
first = [-30, 0]
spacing = "60 m"
number = 2
facing = "-90 deg"
width = "2 m"
projection = "1.5 m"
stiffness = "4 MN/m"
returned_energy = "100 %"
material = "rubber"

[[pair]]
bodies = ["ship", "quay"]
material = "rubber"
"#;

const PRESSING_N: f64 = 150e3;
const PERIOD_S: f64 = 100.0;
const MASS_KG: f64 = 2e7;
/// 5 % of the critical damping.
const DAMPING: f64 = 0.1 * MASS_KG * TAU / PERIOD_S;
const LONG_WAVE_N: f64 = 40e3;

/// Half of the range of surge (m) at the end of fifty periods on a spring in resonance with the long wave.
fn surge_m(friction: f64) -> f64 {
    let lines = format!("friction_static = {friction}\nfriction_dynamic = {friction}");
    let text = SHIP.replace("# friction", &lines);
    let mut simulation =
        Simulation::new(Scenario::parse(&text, "surge.toml").unwrap().setup).unwrap();
    let w = TAU / PERIOD_S;
    let (mut low_m, mut high_m) = (f64::INFINITY, f64::NEG_INFINITY);
    while simulation.time_s() < 50.0 * PERIOD_S {
        let (t_s, state) = (simulation.time_s(), simulation.states()[0]);
        let spring_n = -MASS_KG * w * w * state.position_m.x - DAMPING * state.velocity_mps.x;
        // The pressing force begins softly, and dampers keep her parallel and quiet across.
        let across_n = PRESSING_N * (t_s / 100.0).min(1.0) - 4e6 * state.velocity_mps.y;
        let ship = Wrench {
            force_n: vec2(spring_n + LONG_WAVE_N * (w * t_s).sin(), across_n),
            moment_nm: -1e10 * state.yaw_rate_radps,
        };
        simulation.set_external(&[ship, Wrench::default()]);
        simulation.step().unwrap();
        if t_s > 45.0 * PERIOD_S {
            (low_m, high_m) = (low_m.min(state.position_m.x), high_m.max(state.position_m.x));
        }
    }
    0.5 * (high_m - low_m)
}

/// In resonance the spring and the mass balance, and the long wave does the work of the damping and the friction: F₀ = c ω a + 4 μN/π. So
/// friction of μ takes 4 μN/(π c ω) of the amplitude, and all of it from μN = F₀ π/4 on. 3 %: the rubber's shear gives way a little, and the motion is not quite a sine.
#[test]
fn friction_takes_from_the_amplitude_of_surge_what_its_work_says() {
    let w = TAU / PERIOD_S;
    let free_m = LONG_WAVE_N / (DAMPING * w);
    let smooth_m = surge_m(0.0);
    assert!((smooth_m / free_m - 1.0).abs() < 0.01, "{smooth_m} of {free_m}");
    let rough_m = surge_m(0.1);
    let by_hand_m = free_m - 4.0 * 0.1 * PRESSING_N / (PI * DAMPING * w);
    println!(
        "surge {smooth_m:.3} m without friction, {rough_m:.3} m with 0.1; by hand {free_m:.3} and {by_hand_m:.3} m"
    );
    assert!((rough_m - by_hand_m).abs() < 0.03 * free_m, "{rough_m} of {by_hand_m}");
    // Stuck: the shear springs alone give way.
    let stuck_m = surge_m(0.4);
    assert!(stuck_m < 0.02 * free_m, "{stuck_m}");
}
