//! Computes a box barge with hydrodynamic data: motions in regular waves, the memory of the water beside direct
//! convolution, and drift.

use std::f64::consts::TAU;

use fenderline_contact::number::greater;
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::seakeeping::{MOTIONS, Motion, Seakeeping, matrix};

use super::Values;

const DATA: &str = include_str!(concat!(env!("FENDERLINE_DATA"), "/hydrodynamics/barge_20m.hydro"));
const BARGE: &str = r#"
[time]
step = "0.2 s"
duration = "20 min"

[environment]
depth = "20 m"
squat = "none"
waves = WAVES

[vessel.barge]
length_bp = "80 m"
beam = "20 m"
draught = "5 m"
block_coefficient = 1.0
gyradius = "20 m"
hydrodynamics = "barge_20m.hydro"
roll_damping = 0

[body.barge]
vessel = "barge"
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
"#;
/// Height of the regular waves (m), so small that drag and drift do not matter.
const HEIGHT_M: f64 = 1e-4;

/// # Panics
/// Panics if the scenario cannot be read or stepped, which would be a bug.
pub(super) fn compute(values: &mut Values) {
    for (w, heading_deg) in [(0.6, 60), (0.9, 90), (1.2, 150)] {
        for (motion, size) in MOTIONS.iter().zip(regular(w, f64::from(heading_deg))) {
            let is_angle = ["roll", "pitch", "yaw"].contains(motion);
            let (value, unit) = if is_angle { (size.to_degrees(), "°") } else { (size, "m") };
            values.put(format!("barge/{w}/{heading_deg}/{motion}"), value, unit);
        }
    }
    let ship = barge("{ height = 0, period = 8, from = 0 }").setup.world.vessels[0].clone();
    let ship = ship.seakeeping.expect("data");
    for (index, motion) in MOTIONS.iter().enumerate() {
        values.put(format!("barge/memory/{motion}"), off_the_convolution(&ship, index), "");
    }
    values.put("barge/drift/short", short_beam_wave_kn(), "kN");
}

fn barge(waves: &str) -> Scenario {
    let text = BARGE.replace("WAVES", waves);
    Scenario::parse_among(&text, "barge.toml", &[], &mut |_| Ok(DATA.to_owned()))
        .unwrap_or_else(|error| panic!("the built-in {error}"))
}

fn simulation(waves: &str) -> Simulation {
    Simulation::new(barge(waves).setup).expect("a good set-up")
}

/// Amplitudes of the barge's six motions, divided by that of a regular wave which runs towards a heading (m/m, rad/m):
/// a sine plus a parabola is fitted to each motion by least squares, over the last five minutes of ten.
fn regular(w: f64, heading_deg: f64) -> [f64; 6] {
    let (period_s, from_deg) = (TAU / w, heading_deg + 180.0);
    let mut simulation = simulation(&format!(
        "{{ height = {HEIGHT_M}, period = {period_s}, from = \"{from_deg} deg\", regular = true }}"
    ));
    let (mut normal, mut right) = ([[0.0; 5]; 5], [[0.0; 5]; 6]);
    while simulation.time_s() < 600.0 {
        simulation.step().expect("a good step");
        let t_s = simulation.time_s();
        if t_s < 300.0 {
            continue;
        }
        let (body, attitude) = (simulation.states()[0], simulation.vessels()[0].attitude);
        let [heave, roll, pitch] =
            [attitude.heave, attitude.roll, attitude.pitch].map(|motion| motion.value);
        let now = [body.position_m.x, body.position_m.y, heave, roll, pitch, body.heading_rad];
        let share = (t_s - 450.0) / 150.0;
        let basis = [1.0, share, share * share, libm::cos(w * t_s), libm::sin(w * t_s)];
        for i in 0..5 {
            for j in 0..5 {
                normal[i][j] += basis[i] * basis[j];
            }
            for (right, now) in right.iter_mut().zip(now) {
                right[i] += basis[i] * now;
            }
        }
    }
    right.map(|right| {
        let [.., cos, sin] = matrix::solve(&normal, &right).expect("sines are independent");
        libm::hypot(cos, sin) / (0.5 * HEIGHT_M)
    })
}

/// The largest difference between the force of the water's memory and the convolution of the retardation function K by
/// the trapezoidal rule, divided by the largest force. The motion has two frequencies and begins softly; the step is
/// 0.05 s.
fn off_the_convolution(ship: &Seakeeping, index: usize) -> f64 {
    let (step_s, count) = (0.05, 1200_usize);
    let motion = Motion::new(ship, step_s);
    let retardation = ship.data.retardation();
    let velocity = |t_s: f64| {
        let begun = 1.0 - libm::exp(-t_s / 10.0);
        begun * begun * (libm::sin(0.55 * t_s) + 0.6 * libm::sin(0.9 * t_s + 1.0))
    };
    let time_s = |step: usize| step_s * step as f64;
    let in_the_middles: Vec<[f64; 6]> = (0..count)
        .map(|step| {
            let mut all = [0.0; 6];
            all[index] = velocity(time_s(step) + 0.5 * step_s);
            all
        })
        .collect();
    let found = motion.memory_force(&in_the_middles);
    let kernel: Vec<f64> =
        (0..count).map(|step| retardation.at(index, index, time_s(step))).collect();
    let velocities: Vec<f64> = (0..count).map(|step| velocity(time_s(step))).collect();
    let as_mass = motion.mass()[index][index] - ship.data.total_mass()[index][index];
    let (mut most, mut off) = (0.0_f64, 0.0_f64);
    for now in (1..count).step_by(7) {
        let ends = 0.5 * (kernel[0] * velocities[now] + kernel[now] * velocities[0]);
        let within: f64 = (1..now).map(|k| kernel[k] * velocities[now - k]).sum();
        let wanted = step_s * (ends + within);
        let t_s = time_s(now);
        let acceleration = (velocity(t_s + 1e-4) - velocity(t_s - 1e-4)) / 2e-4;
        most = greater(most, wanted.abs());
        off = greater(off, (found[now][index] + as_mass * acceleration - wanted).abs());
    }
    off / most
}

/// Mean drift force on the barge by the hydrodynamic data, in a beam wave of 2 rad/s (kN, divided by the square of the
/// wave's amplitude in m).
fn short_beam_wave_kn() -> f64 {
    let waves = format!(
        "{{ height = {HEIGHT_M}, period = {}, from = \"270 deg\", regular = true }}",
        TAU / 2.0
    );
    let mut simulation = simulation(&waves);
    let record = simulation.step().expect("a good step");
    1e-3 * record.vessel_forces[0].waves.sway_n / (0.25 * HEIGHT_M * HEIGHT_M)
}
