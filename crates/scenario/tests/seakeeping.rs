//! A vessel with hydrodynamic data: her motion in regular waves, her free decay, and mistakes in the data.
//!
//! The expected motions are solutions of the frequency-domain equation with the file's numbers, solved here.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]
#![allow(clippy::needless_range_loop, reason = "matrices by index read as their equations")]

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::Simulation;
use fenderline_sim::attitude::{Attitude, AttitudeLoad};
use fenderline_sim::seakeeping::{Hydrodynamics, Motion, StepLoad};

const BARGE: &str = r#"
[time]
step = "0.1 s"
duration = "20 min"

[environment]
depth = "20 m"
squat = "none"
# environment

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
position = [0, 0]
"#;

fn data_file(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hydrodynamics").join(name);
    fs::read_to_string(path).expect("a file of the repository")
}

/// A scenario beside the files of the repository; `change` changes their text.
fn read(text: &str, change: impl Fn(&str) -> String) -> Result<Scenario, ScenarioError> {
    let mut files = |name: &str| Ok(change(&data_file(name)));
    Scenario::parse_among(text, "barge.toml", &[], &mut files)
}

fn barge(environment: &str, step: &str) -> Scenario {
    let text = BARGE
        .replace("# environment", environment)
        .replace("step = \"0.1 s\"", &format!("step = \"{step}\""));
    read(&text, str::to_owned).expect("a good scenario")
}

fn data(scenario: &Scenario) -> &Hydrodynamics {
    &scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").data
}

/// Solves a complex system by elimination, as real pairs.
fn solve(matrix: [[(f64, f64); 6]; 6], right: [(f64, f64); 6]) -> [(f64, f64); 6] {
    let mut a = [[0.0; 13]; 12];
    for i in 0..6 {
        for j in 0..6 {
            let (re, im) = matrix[i][j];
            (a[i][j], a[i][j + 6], a[i + 6][j], a[i + 6][j + 6]) = (re, -im, im, re);
        }
        (a[i][12], a[i + 6][12]) = right[i];
    }
    for column in 0..12 {
        let pivot = (column..12).max_by(|&i, &j| a[i][column].abs().total_cmp(&a[j][column].abs()));
        a.swap(column, pivot.expect("a row"));
        for row in 0..12 {
            if row != column {
                let factor = a[row][column] / a[column][column];
                for k in column..13 {
                    a[row][k] -= factor * a[column][k];
                }
            }
        }
    }
    std::array::from_fn(|i| (a[i][12] / a[i][i], a[i + 6][12] / a[i + 6][i + 6]))
}

/// Complex amplitudes of the motion in a wave of 1 m amplitude at a frequency of the data and a heading.
fn in_frequency_domain(data: &Hydrodynamics, w: f64, towards_deg: f64) -> [(f64, f64); 6] {
    let (_, added, damping) =
        data.radiation().find(|(at, ..)| (at - w).abs() < 1e-9).expect("a frequency of the data");
    let mass = data.rigid_mass();
    let restoring = data.restoring();
    let matrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let inert = -w * w * (mass[i][j] + added[i][j]) + restoring[i][j];
            (inert, w * damping[i][j])
        })
    });
    let force = data.excitation_towards(w, towards_deg.to_radians()).map(|part| (part.re, part.im));
    solve(matrix, force)
}

/// Complex amplitude at a frequency of a record, beside a parabola: least squares by normal equations.
fn harmonic(record: &[(f64, f64)], w: f64) -> (f64, f64) {
    let middle = record[record.len() / 2].0;
    let mut a = [[0.0; 6]; 5];
    for &(t, y) in record {
        let s = (t - middle) / 100.0;
        let basis = [1.0, s, s * s, (w * t).cos(), -(w * t).sin()];
        for i in 0..5 {
            for j in 0..5 {
                a[i][j] += basis[i] * basis[j];
            }
            a[i][5] += basis[i] * y;
        }
    }
    for column in 0..5 {
        let pivot = a[column];
        for row in 0..5 {
            if row != column {
                let factor = a[row][column] / pivot[column];
                for k in 0..6 {
                    a[row][k] -= factor * pivot[k];
                }
            }
        }
    }
    (a[3][5] / a[3][3], a[4][5] / a[4][4])
}

/// Amplitudes of the six motions in a regular wave of 1 m amplitude. In the run it is so small that drag does not matter, nor the way that
/// a ship goes who was at rest when the wave began.
fn in_the_simulation(period_s: f64, from_deg: f64, step: &str) -> [(f64, f64); 6] {
    let wave = format!(
        "waves = {{ height = 1e-4, period = {period_s}, from = \"{from_deg} deg\", regular = true }}"
    );
    let scenario = barge(&wave, step);
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let mut records: [Vec<(f64, f64)>; 6] = Default::default();
    while simulation.time_s() < 600.0 {
        let record = simulation.step().expect("a good step");
        let (body, attitude) = (record.states_after[0], record.vessels[0].attitude);
        let motion = [
            body.position_m.x,
            body.position_m.y,
            attitude.heave.value,
            attitude.roll.value,
            attitude.pitch.value,
            body.heading_rad,
        ];
        let t_s = simulation.time_s();
        if t_s > 300.0 {
            for (record, value) in records.iter_mut().zip(motion) {
                record.push((t_s, value / 0.5e-4));
            }
        }
    }
    records.map(|record| harmonic(&record, TAU / period_s))
}

/// The largest difference of the six motions over their size: rotations count by half the length or beam.
fn difference(one: &[(f64, f64); 6], other: &[(f64, f64); 6]) -> f64 {
    let arms = [1.0, 1.0, 1.0, 10.0, 40.0, 40.0];
    let size = |&(re, im): &(f64, f64)| f64::hypot(re, im);
    let most = other.iter().zip(arms).map(|(z, arm)| arm * size(z)).fold(0.0, f64::max);
    let off = one.iter().zip(other).map(|(a, b)| size(&(a.0 - b.0, a.1 - b.1)));
    off.zip(arms).map(|(off, arm)| arm * off / most).fold(0.0, f64::max)
}

#[test]
fn a_barge_in_regular_waves_moves_as_the_frequency_domain_says() {
    // Headings 0, 60 and 90 degrees of the data; the barge heads north.
    let cases = [
        (0.4, 3, "0.1 s"),
        (0.6, 2, "0.05 s"),
        (0.6, 2, "0.5 s"),
        (0.9, 0, "0.2 s"),
        (0.9, 3, "0.1 s"),
        (1.2, 5, "0.2 s"),
    ];
    for (w, heading, step) in cases {
        let towards_deg = 30.0 * heading as f64;
        let scenario = barge("", step);
        let expected = in_frequency_domain(data(&scenario), w, towards_deg);
        let found = in_the_simulation(TAU / w, towards_deg + 180.0, step);
        let off = difference(&found, &expected);
        println!("ω {w}, heading {towards_deg}, step {step}: {off:.5}");
        assert!(off < 0.01, "ω {w}, heading {towards_deg}, step {step}: {off}");
    }
}

/// The memory's force on a varying motion is that of the convolution with K, computed here by the trapezoidal rule. K is the cosine
/// transform of the damping. Tolerance of the design sheet: 0.5 % of the largest force, the fit of the bank being the error.
#[test]
fn the_memory_is_the_convolution_with_the_retardation_function() {
    let scenario = barge("", "0.05 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data");
    let (step_s, count) = (0.05, 1200);
    let motion = Motion::new(ship, step_s);
    let retardation = ship.data.retardation();
    let velocity = |t: f64| {
        (1.0 - (-t / 10.0).exp()).powi(2) * ((0.55 * t).sin() + 0.6 * (0.9 * t + 1.0).sin())
    };
    for (row, column) in [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (1, 3), (0, 4)] {
        let velocities: Vec<[f64; 6]> = (0..count)
            .map(|n| {
                let mut all = [0.0; 6];
                all[column] = velocity(step_s * (n as f64 + 0.5));
                all
            })
            .collect();
        let found = motion.memory_force(&velocities);
        let kernel: Vec<f64> =
            (0..count).map(|n| retardation.at(row, column, step_s * n as f64)).collect();
        let as_mass = motion.mass()[row][column] - ship.data.total_mass()[row][column];
        let (mut most, mut off): (f64, f64) = (0.0, 0.0);
        for n in (1..count).step_by(7) {
            let mut expected = 0.0;
            for k in 0..=n {
                let weight = if k == 0 || k == n { 0.5 } else { 1.0 };
                expected += weight * step_s * kernel[k] * velocity(step_s * (n - k) as f64);
            }
            let t = step_s * n as f64;
            let acceleration = (velocity(t + 1e-4) - velocity(t - 1e-4)) / 2e-4;
            let own = found[n][row] + as_mass * acceleration;
            most = most.max(expected.abs());
            off = off.max((own - expected).abs());
        }
        println!("{row} and {column}: {:.5}", off / most);
        assert!(off < 0.005 * most, "{row} and {column}: {}", off / most);
    }
}

/// Radiation takes energy from every motion at every step size: the work of the memory's force and of the damping that makes good its fit.
#[test]
fn radiation_only_takes_energy() {
    let scenario = barge("", "0.05 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data");
    for step_s in [0.05, 0.1, 0.25, 0.5, 1.0] {
        let motion = Motion::new(ship, step_s);
        for seed in 1..16_u64 {
            // Random motions: of one frequency each, of any size in any direction, switched on and off.
            let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
            let mut random = || {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
                (state >> 11) as f64 / (1_u64 << 53) as f64 - 0.5
            };
            let size: [f64; 6] = std::array::from_fn(|k| random() / motion.mass()[k][k].sqrt());
            let phase: [f64; 6] = std::array::from_fn(|_| 6.0 * random());
            let w = 0.95 * std::f64::consts::PI / step_s * (random() + 0.5).powi(3);
            let velocities: Vec<[f64; 6]> = (0..800)
                .map(|n| {
                    let on = if (100..500).contains(&n) { 1.0 } else { 0.0 };
                    std::array::from_fn(|k| on * size[k] * (w * step_s * n as f64 + phase[k]).sin())
                })
                .collect();
            let forces = motion.memory_force(&velocities);
            let (mut taken, mut least, mut exchanged) = (0.0_f64, 0.0_f64, 0.0);
            for n in 1..velocities.len() {
                let mean: [f64; 6] =
                    std::array::from_fn(|k| 0.5 * (velocities[n][k] + velocities[n - 1][k]));
                let damped: f64 = (0..6)
                    .map(|k| mean[k] * (0..6).map(|j| motion.rest()[k][j] * mean[j]).sum::<f64>())
                    .sum();
                let work = step_s * ((0..6).map(|k| forces[n][k] * mean[k]).sum::<f64>() + damped);
                taken += work;
                exchanged += work.abs();
                least = least.min(taken);
            }
            assert!(least >= -1e-9 * exchanged, "step {step_s}, seed {seed}, ω {w}: {least}");
        }
    }
}

#[test]
fn the_memory_has_damping_and_added_mass_of_the_data() {
    let scenario = barge("", "0.1 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data");
    for step_s in [0.05, 0.2, 0.5] {
        let motion = Motion::new(ship, step_s);
        for (i, j) in [(0, 0), (1, 1), (2, 2), (3, 3), (4, 4), (5, 5), (0, 4), (1, 3)] {
            let rows: Vec<_> = ship.data.radiation().collect();
            let most = rows.iter().map(|(w, a, b)| {
                b[i][j].abs().max(w * (a[i][j] - ship.data.infinite()[i][j]).abs())
            });
            let most = most.fold(0.0, f64::max);
            let off: Vec<(f64, f64, f64)> = rows
                .iter()
                .map(|(w, a, b)| {
                    let [damping, added] = motion.answer([i, j], *w);
                    let own = a[i][j] - ship.data.infinite()[i][j];
                    (*w, (damping - b[i][j]) / most, w * (added - own) / most)
                })
                .collect();
            let worst = off.iter().map(|(_, b, a)| b.abs().max(a.abs())).fold(0.0, f64::max);
            println!("step {step_s}, {i} and {j}: {worst:.4}");
        }
    }
}

/// Free decays from 1 m of heave, 0.1 rad of roll and 0.02 rad of pitch are those of the equation with the data's added mass and damping,
/// in all six motions, since roll takes sway with it and pitch surge: the inverse transform of the frequency-domain response, integrated here on
/// a fine grid between the data's frequencies. 1 % of the start.
#[test]
fn free_decays_are_those_of_added_mass_and_damping_by_frequency() {
    let scenario = barge("", "0.1 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").clone();
    let (mass, restoring) = (ship.data.rigid_mass(), ship.data.restoring());
    let retardation = ship.data.retardation();
    for (motion_index, start, name) in [(2, 1.0, "heave"), (3, 0.1, "roll"), (4, 0.02, "pitch")] {
        // The motion from rest is ξ₀ − y(t), with y that of a force Cξ₀ stepped on at 0: y(t) = (2/π)∫ Re{Y(ω)} sin(ωt)/ω dω with
        // (C − ω²(M + A) + iωB) Y = Cξ₀.
        let width = 0.002;
        let w_at = |k: usize| width * (k as f64 + 0.5);
        let response: Vec<f64> = (0..5000)
            .map(|k| {
                let w = w_at(k);
                let matrix = std::array::from_fn(|i| {
                    std::array::from_fn(|j| {
                        let added =
                            ship.data.infinite()[i][j] + retardation.added_mass_change(i, j, w);
                        let inert = restoring[i][j] - w * w * (mass[i][j] + added);
                        (inert, w * retardation.damping(i, j, w))
                    })
                });
                let right = std::array::from_fn(|i| (restoring[i][motion_index] * start, 0.0));
                solve(matrix, right)[motion_index].0
            })
            .collect();
        let expected = |t: f64| {
            let sum: f64 =
                response.iter().enumerate().map(|(k, re)| re * (w_at(k) * t).sin() / w_at(k)).sum();
            start - 2.0 / std::f64::consts::PI * width * sum
        };
        let motion = Motion::new(&ship, 0.1);
        let mut state = motion.start([0.0; 3]);
        let mut attitude = Attitude::default();
        [&mut attitude.heave, &mut attitude.roll, &mut attitude.pitch][motion_index - 2].value =
            start;
        let mut velocity = [0.0; 3];
        let mut worst: f64 = 0.0;
        for n in 0..400 {
            let acts_s = if n == 0 { 0.05 } else { 0.1 };
            let load = StepLoad { force: [0.0; 6], acts_s };
            let load = motion.predict(&mut state, &attitude, velocity, &load);
            let change = fenderline_sim::seakeeping::matrix::solve(motion.plane_mass(), &load)
                .expect("mass");
            for k in 0..3 {
                velocity[k] += acts_s * change[k];
            }
            motion.settle(&mut state, &mut attitude, velocity, &AttitudeLoad::default(), acts_s);
            let found = [attitude.heave, attitude.roll, attitude.pitch][motion_index - 2].value;
            worst = worst.max((found - expected(0.1 * f64::from(n + 1))).abs());
        }
        println!("{name}: largest difference {:.5} of the start", worst / start);
        assert!(worst < 0.01 * start, "{name}: {worst}");
    }
}

/// A wave train that ends leaves less and less energy, and the run gives the same bits again, from the start and from a copy in the middle.
#[test]
fn a_run_is_repeated_to_the_bit_and_settles_after_the_waves() {
    let waves = "waves = { height = 1, period = 7, from = \"240 deg\", seed = 3 }";
    let scenario = barge(waves, "0.2 s");
    let mut one = Simulation::new(scenario.setup.clone()).expect("a good set-up");
    let mut two = Simulation::new(scenario.setup).expect("a good set-up");
    let run = |simulation: &mut Simulation, steps: usize| {
        for _ in 0..steps {
            simulation.step().expect("a good step");
        }
    };
    run(&mut one, 500);
    let mut copy = one.clone();
    run(&mut one, 500);
    run(&mut copy, 500);
    run(&mut two, 1000);
    let end =
        |simulation: &Simulation| (simulation.states().to_vec(), simulation.vessels().to_vec());
    assert_eq!(end(&one), end(&copy));
    assert_eq!(end(&one), end(&two));
    let most = one.vessels()[0].attitude.heave.value.abs();
    assert!(most < 3.0, "{most}");
}

#[test]
fn mistakes_in_hydrodynamic_data_are_shown_at_their_line() {
    let refused = |from: &str, to: &str, fragments: &[&str]| {
        let change = |text: &str| {
            assert!(text.contains(from), "{from} is not in the file");
            text.replacen(from, to, 1)
        };
        let message = read(BARGE, change).expect_err(to).to_string();
        for fragment in fragments {
            assert!(message.contains(fragment), "{message}\nlacks {fragment}");
        }
    };
    let line = |start: &str| {
        let text = data_file("barge_20m.hydro");
        let line = text.lines().find(|line| line.starts_with(start)).expect("a line");
        line.to_owned()
    };
    refused("= fenderline hydrodynamic data 1", "= data", &["first line", "barge_20m.hydro:1:1"]);
    refused("= radiation", "= radiaton", &["no table \"radiaton\"", "did you mean `= radiation`"]);
    refused("= infinite", "= ship", &["second table `= ship`"]);
    let row = line("0.5,");
    let cells: Vec<&str> = row.split(',').collect();
    let negative = row.replace(&format!(",{},", cells[2]), ",-3e5,");
    let above = data_file("barge_20m.hydro").lines().take_while(|own| *own != row).count();
    let at = format!("barge_20m.hydro:{}", above + 1);
    refused(&row, &negative, &["damping of surge is negative", &at]);
    let gap = line("0.6,120");
    refused(&format!("{gap}\n"), "", &["no row for omega_radps = 0.6, heading_deg = 120"]);
    refused("8.2e6,", "7.5e6,", &["are for a ship of 7500 t, but the vessel has 8200 t"]);
    refused("8.2e6,", "8200,", &["restoring in heave [N/m]", "are the units kg, m, s, N?"]);
    let text = data_file("barge_20m.hydro");
    let infinite = text.lines().skip_while(|line| *line != "= infinite").nth(2).expect("a row");
    let in_tonnes: Vec<String> = infinite
        .split(',')
        .map(|cell| format!("{:e}", cell.parse::<f64>().unwrap() / 1e3))
        .collect();
    refused(infinite, &in_tonnes.join(","), &["added mass in heave [kg]", "units"]);
    // Without the frequencies around the peak, and without those beyond it.
    let text = data_file("barge_20m.hydro");
    let without = |rows: std::ops::Range<usize>| {
        let kept = text.lines().enumerate().filter(|(number, _)| !rows.contains(number));
        kept.map(|(_, line)| format!("{line}\n")).collect::<String>()
    };
    let message = |text: String| read(BARGE, |_| text.clone()).expect_err("bad data").to_string();
    let first = text.lines().position(|line| line.starts_with("omega_radps,a11")).unwrap() + 1;
    let omega = |line: &str| line.split(',').next().and_then(|cell| cell.parse::<f64>().ok());
    // The row of the radiation that is the first above a frequency, or the end.
    let above = |w: f64| {
        let rows = text.lines().skip(first).take_while(|line| !line.is_empty());
        first + rows.filter(|line| omega(line).is_some_and(|own| own <= w + 1e-9)).count()
    };
    let coarse = message(without(above(0.45)..above(1.1)));
    assert!(coarse.contains("too far apart") || coarse.contains("contradict"), "{coarse}");
    let short = message(without(above(1.3)..above(9.0)));
    assert!(short.contains("does not decay") && short.contains("1.3 rad/s"), "{short}");
    let late = message(without(first..above(0.55)));
    assert!(late.contains("add lower frequencies"), "{late}");
    let unknown = BARGE.replace("roll_damping = 0", "wave_response = \"barge_20m.hydro\"");
    let message = read(&unknown, str::to_owned).expect_err("two answers").to_string();
    assert!(message.contains("does not go together with `hydrodynamics`"), "{message}");
    let elsewhere = BARGE.replace("depth = \"20 m\"", "depth = \"12 m\"");
    let notices = read(&elsewhere, str::to_owned).expect("a notice only").notices;
    assert!(notices.iter().any(|notice| notice.message.contains("the run has 12 m")));
}

/// The barge on linear springs in surge, sway and yaw, stepped by hand around [`Motion`]: her motion in a regular wave near her natural period
/// in sway and away from it, against the frequency domain (1 % of the largest motion).
#[test]
fn a_barge_on_linear_moorings_moves_as_the_frequency_domain_says() {
    let scenario = barge("", "0.1 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").clone();
    let data = &ship.data;
    let springs: [f64; 3] = [4e5, 6e6, 2e9];
    let (step_s, towards_rad) = (0.1, 60_f64.to_radians());
    let motion = Motion::new(&ship, step_s);
    for w in [0.4, 0.6, 0.9] {
        let (_, added, damping) =
            data.radiation().find(|(at, ..)| (at - w).abs() < 1e-9).expect("a frequency");
        let (mass, restoring) = (data.rigid_mass(), data.restoring());
        let spring = |i: usize| [springs[0], springs[1], 0.0, 0.0, 0.0, springs[2]][i];
        let matrix = std::array::from_fn(|i| {
            std::array::from_fn(|j| {
                let moored = if i == j { spring(i) } else { 0.0 };
                let inert = -w * w * (mass[i][j] + added[i][j]) + restoring[i][j] + moored;
                (inert, w * damping[i][j])
            })
        });
        let waves = data.excitation_towards(w, towards_rad).map(|part| (part.re, part.im));
        let expected = solve(matrix, waves);

        let mut state = motion.start([0.0; 3]);
        let mut attitude = Attitude::default();
        let (mut place, mut velocity) = ([0.0; 3], [0.0; 3]);
        let mut records: [Vec<(f64, f64)>; 6] = Default::default();
        let theta: f64 = 0.5 * w * step_s;
        let mean = (theta.sin() / theta).powi(2);
        for n in 0..15_000 {
            let t = step_s * f64::from(n);
            let acts_s = if n == 0 { 0.5 * step_s } else { step_s };
            let mut force: [f64; 6] = std::array::from_fn(|k| {
                mean * (waves[k].0 * (w * t).cos() - waves[k].1 * (w * t).sin())
            });
            for (k, index) in [0, 1, 5].into_iter().enumerate() {
                force[index] -= springs[k] * place[k];
            }
            let load = motion.predict(&mut state, &attitude, velocity, &StepLoad { force, acts_s });
            let change = fenderline_sim::seakeeping::matrix::solve(motion.plane_mass(), &load)
                .expect("mass");
            for k in 0..3 {
                velocity[k] += acts_s * change[k];
                place[k] += step_s * velocity[k];
            }
            motion.settle(&mut state, &mut attitude, velocity, &AttitudeLoad::default(), acts_s);
            if n > 9000 {
                let now = [
                    place[0],
                    place[1],
                    attitude.heave.value,
                    attitude.roll.value,
                    attitude.pitch.value,
                    place[2],
                ];
                for (record, value) in records.iter_mut().zip(now) {
                    record.push((t + step_s, value));
                }
            }
        }
        let found = records.map(|record| harmonic(&record, w));
        let off = difference(&found, &expected);
        println!("moored, ω {w}: {off:.5}");
        assert!(off < 0.01, "ω {w}: {off}\n{found:?}\n{expected:?}");
    }
}

/// The barge on soft linear springs in surge, sway and yaw, let go out of her place in each: the period between crossings of zero against the
/// root of C − ω²(M + A(ω)) of the motion, with A by the data at that frequency. 1 %: the damping lengthens a period by less than 0.1 % at these
/// frequencies, and the file has five digits.
#[test]
fn a_moored_barge_has_her_natural_periods() {
    let scenario = barge("", "0.2 s");
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data").clone();
    let data = &ship.data;
    let springs: [f64; 3] = [4e5, 6e5, 5e8];
    let arms = [0.5, 0.5, 0.01];
    let added_at = |index: usize, w: f64| {
        let rows: Vec<(f64, f64)> =
            data.radiation().map(|(w, a, _)| (w, a[index][index])).collect();
        let next = rows.iter().position(|row| row.0 > w).expect("a frequency above").max(1);
        let ((w0, a0), (w1, a1)) = (rows[next - 1], rows[next]);
        a0 + (w - w0) / (w1 - w0) * (a1 - a0)
    };
    let step_s = 0.2;
    let motion = Motion::new(&ship, step_s);
    for (own, index) in [0, 1, 5].into_iter().enumerate() {
        let mut natural = 0.2;
        for _ in 0..50 {
            let mass = data.rigid_mass()[index][index] + added_at(index, natural);
            natural = (springs[own] / mass).sqrt();
        }
        let mut state = motion.start([0.0; 3]);
        let mut attitude = Attitude::default();
        let (mut place, mut velocity) = ([0.0; 3], [0.0; 3]);
        place[own] = arms[own];
        let mut crossings = Vec::new();
        for n in 0..3000 {
            let acts_s = if n == 0 { 0.5 * step_s } else { step_s };
            let mut force = [0.0; 6];
            for (k, index) in [0, 1, 5].into_iter().enumerate() {
                force[index] -= springs[k] * place[k];
            }
            let load = motion.predict(&mut state, &attitude, velocity, &StepLoad { force, acts_s });
            let change = fenderline_sim::seakeeping::matrix::solve(motion.plane_mass(), &load)
                .expect("mass");
            let before = place[own];
            for k in 0..3 {
                velocity[k] += acts_s * change[k];
                place[k] += step_s * velocity[k];
            }
            motion.settle(&mut state, &mut attitude, velocity, &AttitudeLoad::default(), acts_s);
            if before > 0.0 && place[own] <= 0.0 {
                crossings.push(step_s * (f64::from(n) + before / (before - place[own])));
            }
        }
        // Without the first swing, in which the water is still at rest.
        let count = crossings.len() - 2;
        let period_s = (crossings[count + 1] - crossings[1]) / count as f64;
        println!(
            "motion {index}: {period_s:.3} s, natural {:.3} s, {count} periods",
            TAU / natural
        );
        assert!(count >= 5, "motion {index}: {count} periods");
        let off = period_s * natural / TAU - 1.0;
        assert!(off.abs() < 0.01, "motion {index}: {period_s} {}", TAU / natural);
    }
}
