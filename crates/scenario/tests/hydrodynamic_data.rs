//! The hydrodynamic data of the repository: each file is read, and moves a moored ship in waves.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::fs;
use std::path::Path;

use fenderline_contact::{Wrench, vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::seakeeping::{MOTIONS, Motion};

const RUN: &str = r#"
[time]
step = "0.2 s"
duration = "10 min"

[environment]
depth = "DEPTH"
waves = { height = 1, period = 9, from = "220 deg", seed = 4 }
"#;

const BARGE: &str = r#"
[vessel.moored]
length_bp = "80 m"
beam = "20 m"
draught = "5 m"
block_coefficient = 1.0
gyradius = "20 m"
hydrodynamics = "data.hydro"

[body.ship]
vessel = "moored"
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
"#;

const SHIP: &str = r#"
[vessel.moored]
from = "container-ship"
hydrodynamics = "data.hydro"

[body.ship]
vessel = "moored"
"#;

/// Names and texts of the files, in their order.
fn files() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hydrodynamics");
    let entries =
        fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("a file").path());
    let mut paths: Vec<_> =
        entries.filter(|path| path.extension().is_some_and(|end| end == "hydro")).collect();
    paths.sort();
    let text = |path: &Path| fs::read_to_string(path).expect("a text");
    paths
        .iter()
        .map(|path| (path.file_stem().expect("a name").to_string_lossy().into_owned(), text(path)))
        .collect()
}

fn scenario(name: &str, data: &str) -> Scenario {
    let depth = name.split('_').nth(1).expect("a depth in the name").trim_end_matches('m');
    let run = RUN.replace("DEPTH", &format!("{depth} m"));
    let text = run + if name.starts_with("barge") { BARGE } else { SHIP };
    let mut read = |_: &str| Ok(data.to_owned());
    Scenario::parse_among(&text, "moored.toml", &[], &mut read)
        .unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Ten minutes on linear springs in a sea of 1 m: no motion is larger than the wave's orbit at her ends would make it, and the ledger closes.
/// Data in open water have a drift, which is that of the file: in the sea's direction. Data at a quay have none, and other headings.
#[test]
fn every_file_is_read_and_moves_a_moored_ship() {
    let files = files();
    // Barge and ship in two depths, in open water and at a quay.
    assert_eq!(files.len(), 8);
    for (name, text) in &files {
        let scenario = scenario(name, text);
        let doubts = scenario.notices.iter().map(|notice| notice.to_string());
        let about_data = doubts.filter(|said| said.contains("data.hydro:"));
        assert_eq!(about_data.collect::<Vec<_>>(), [""; 0], "{name}");
        let data = scenario.setup.world.vessels[0].seakeeping.clone().expect("data").data;
        let at_quay = name.ends_with("quay");
        assert_eq!(data.has_drift(), !at_quay, "{name}");
        assert!(text.contains(&format!("({name})")), "{name}: the file says which case made it");
        let mass_kg = data.mass_kg();
        let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
        let mut most = [0.0_f64; 6];
        let mut drift_n = vec2(0.0, 0.0);
        while !simulation.is_done() {
            // Periods of 60 s, a tenth of the critical damping.
            let state = simulation.states()[0];
            let w = std::f64::consts::TAU / 60.0;
            let spring = |x: f64, v: f64| -mass_kg * (w * w * x + 0.2 * w * v);
            let turning =
                mass_kg * 500.0 * (w * w * state.heading_rad + 0.2 * w * state.yaw_rate_radps);
            let force_n = vec2(
                spring(state.position_m.x, state.velocity_mps.x),
                spring(state.position_m.y, state.velocity_mps.y),
            );
            simulation.set_external(&[Wrench { force_n, moment_nm: -turning }]);
            let record = simulation.step().expect("a good step");
            let (body, attitude) = (record.states_after[0], record.vessels[0].attitude);
            let now = [
                body.position_m.x,
                body.position_m.y,
                attitude.heave.value,
                attitude.roll.value,
                attitude.pitch.value,
                body.heading_rad,
            ];
            for (most, now) in most.iter_mut().zip(now) {
                *most = most.max(now.abs());
            }
            let waves = record.vessel_forces[0].waves;
            drift_n += vec2(waves.surge_n, waves.sway_n);
        }
        println!("{name}: {most:.3?}");
        assert!(most.iter().all(|motion| motion.is_finite() && *motion > 0.0), "{name}: {most:?}");
        // A wall throws the wave back, and its orbits are twice as large.
        let walls = if at_quay { 2.0 } else { 1.0 };
        let [surge, sway, heave, roll, pitch, yaw] = most.map(|motion| motion / walls);
        assert!(surge < 3.0 && sway < 3.0 && heave < 1.5, "{name}: {most:?}");
        assert!(roll < 0.2 && pitch < 0.05 && yaw < 0.05, "{name}: {most:?}");
        if !at_quay {
            assert!(drift_n.x > 0.0 && drift_n.y > 0.0, "{name}: {drift_n:?}");
        }
        let energy = simulation.energy();
        assert!(energy.residual_j.abs() < 1e-3 * energy.exchanged_j(), "{name}");
    }
}

/// Added mass and damping of the memory as it steps at 0.2 s beside those of the data: the error of the water's force over the force that the mass
/// takes, the mean over the frequencies. The bank of resonators is a fit. Where the data's added mass and damping contradict each other a little,
/// as panel runs do, the fit lies between them: of the ship in 15 m of water by 1.2 % in heave, of the others by less than 1 %.
#[test]
fn the_memory_has_the_added_mass_and_the_damping_of_each_file() {
    for (name, text) in &files() {
        let scenario = scenario(name, text);
        let ship = scenario.setup.world.vessels[0].seakeeping.clone().expect("data");
        let motion = Motion::new(&ship, 0.2);
        let off = [0, 1, 2, 3, 4, 5].map(|k| {
            let (infinite, total) = (ship.data.infinite()[k][k], ship.data.total_mass()[k][k]);
            let of_row = |(w, a, b): (f64, &[[f64; 6]; 6], &[[f64; 6]; 6])| {
                let [damping, added] = motion.answer([k, k], w);
                f64::hypot(added + infinite - a[k][k], (damping - b[k][k]) / w) / total
            };
            let all: Vec<f64> = ship.data.radiation().map(of_row).collect();
            all.iter().sum::<f64>() / all.len() as f64
        });
        for (motion, off) in MOTIONS.iter().zip(off) {
            println!("{name}, {motion}: {:.2} %", 100.0 * off);
        }
        assert!(off.iter().all(|off| *off < 0.015), "{name}: {off:?}");
    }
}

/// A free ship follows a wave much longer than her beam and throws nothing back: next to no drift abeam, over that of a wall of her length. The waves
/// that she makes by moving cancel those that she throws back; without them a fifth of a wall's drift was left at 0.3 rad/s.
#[test]
fn a_ship_that_follows_a_long_beam_wave_has_no_drift() {
    for (name, text) in files().iter().filter(|(name, _)| !name.ends_with("quay")) {
        let scenario = scenario(name, text);
        let data = scenario.setup.world.vessels[0].seakeeping.clone().expect("data").data;
        let length_m = if name.starts_with("barge") { 80.0 } else { 285.0 };
        let wall_npm2 = 0.5 * 1025.0 * 9.81 * length_m;
        for w in [data.wave_range_radps()[0], 0.2, 0.3] {
            let [_, sway, _] = data.drift_towards(w, std::f64::consts::FRAC_PI_2).expect("drift");
            println!("{name}, {w} rad/s: {:.5} of a wall's drift", sway / wall_npm2);
            assert!(sway.abs() < 0.01 * wall_npm2, "{name}, {w} rad/s: {sway}");
        }
    }
}
