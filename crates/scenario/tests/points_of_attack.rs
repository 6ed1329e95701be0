//! A barge with hydrodynamic data held by forces whose points of attack move with her: her roll in beam waves against a linear solve whose stiffness
//! is the derivative of the exact forces and levers in six degrees of freedom.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]
#![allow(clippy::needless_range_loop, reason = "matrices by index read as their equations")]

use std::f64::consts::{FRAC_PI_2, TAU};
use std::fs;
use std::path::Path;

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::seakeeping::Motion;

const BARGE: &str = r#"
[time]
step = "0.1 s"
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
roll_damping = 0.05

[body.barge]
vessel = "barge"
outline = [[-40, -10], [40, -10], [40, 10], [-40, 10]]
position = [0, 0]

"#;
/// Four ropes of nylon abeam, square to the hull, from 5 m above the water at her corners.
const PIERS: &str = r#"
[body.piers]
fixed = true
outline = [[-1, -1], [1, -1], [1, 1], [-1, 1]]
position = [0, 200]

"#;
/// Wave heights (m): small, and where fenders meet her side. The program takes her side at heights and angles in whole numbers of 1 mm and 1e-5 rad: in
/// waves of 0.1 mm her roll of 5e-6 rad is none to the fenders, and roll differed by 4 %.
///
/// The barge starts pressed into her fenders: the engine takes that as placed by the host, and such a contact presses out slowly until it is hit anew at more
/// than 0.08 m/s (`coupled/press_out.rs`). In waves of 0.02 and 0.05 m it keeps to its law all the same, in waves of 0.4 m all fenders are hit anew, and roll
/// is within 0.1 % of the solve. In waves of 0.1 and 0.2 m some are not hit anew, their force is up to 17 % less, and roll is 11 and 20 % off.
const SMALL_M: f64 = 1e-4;
const AT_FENDERS_M: f64 = 0.02;
const SEVERAL: [f64; 6] = [0.5, 0.6, 0.7, 0.8, 0.9, 1.0];

fn scenario(omega_radps: f64, height_m: f64, held: &str) -> Scenario {
    scenario_of(BARGE, omega_radps, height_m, held)
}

fn scenario_of(barge: &str, omega_radps: f64, height_m: f64, held: &str) -> Scenario {
    let waves = format!(
        "{{ height = {height_m}, period = {}, from = \"270 deg\", regular = true }}",
        TAU / omega_radps
    );
    let text = barge.replace("WAVES", &waves) + held;
    let mut files = |name: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../hydrodynamics").join(name);
        Ok(fs::read_to_string(path).expect("a file of the repository"))
    };
    Scenario::parse_among(&text, "held.toml", &[], &mut files)
        .unwrap_or_else(|error| panic!("{error}"))
}

type Six = [f64; 6];

/// A point of the ship (forward, to starboard, up of her centre of gravity) after a motion: surge, sway, heave down, roll, pitch and yaw, with
/// exact rotations. Forward, to starboard, down.
fn moved([x, y, up]: [f64; 3], motion: &Six) -> [f64; 3] {
    let z = -up;
    let [roll, pitch, yaw] = [motion[3], motion[4], motion[5]];
    let (y, z) = (y * roll.cos() - z * roll.sin(), y * roll.sin() + z * roll.cos());
    let (x, z) = (x * pitch.cos() + z * pitch.sin(), z * pitch.cos() - x * pitch.sin());
    let (x, y) = (x * yaw.cos() - y * yaw.sin(), x * yaw.sin() + y * yaw.cos());
    [x + motion[0], y + motion[1], z + motion[2]]
}

/// Adds a force at a place to a load about the centre of gravity after a motion.
fn add(load: &mut Six, place: [f64; 3], force: [f64; 3], motion: &Six) {
    let [x, y, z] = [place[0] - motion[0], place[1] - motion[1], place[2] - motion[2]];
    let [fx, fy, fz] = force;
    let all = [fx, fy, fz, y * fz - z * fy, z * fx - x * fz, x * fy - y * fx];
    for (sum, part) in load.iter_mut().zip(all) {
        *sum += part;
    }
}

/// −dF/dξ by central differences.
fn stiffness(of: impl Fn(&Six) -> Six) -> [Six; 6] {
    let mut matrix = [[0.0; 6]; 6];
    for column in 0..6 {
        let by = 1e-5;
        let mut motion = [0.0; 6];
        motion[column] = by;
        let after = of(&motion);
        motion[column] = -by;
        let before = of(&motion);
        for row in 0..6 {
            matrix[row][column] = -(after[row] - before[row]) / (2.0 * by);
        }
    }
    matrix
}

/// Solves a complex system, as real pairs.
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

/// Amplitude of roll over that of the wave by the linear solve.
fn roll_by_solve(scenario: &Scenario, w: f64, held: &[Six; 6]) -> f64 {
    let ship = scenario.setup.world.vessels[0].seakeeping.as_ref().expect("data");
    let data = &ship.data;
    let (_, added, damping) =
        data.radiation().find(|(at, ..)| (at - w).abs() < 1e-9).expect("a frequency of the data");
    let motion = Motion::new(ship, 0.1);
    let critical = 2.0 * (data.restoring()[3][3] * motion.mass()[3][3]).sqrt();
    let matrix = std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let inert = -w * w * (data.rigid_mass()[i][j] + added[i][j]);
            let viscous = if i == 3 && j == 3 { ship.roll_damping * critical } else { 0.0 };
            (inert + data.restoring()[i][j] + held[i][j], w * (damping[i][j] + viscous))
        })
    });
    let force = data.excitation_towards(w, FRAC_PI_2).map(|part| (part.re, part.im));
    let (re, im) = solve(matrix, force)[3];
    re.hypot(im)
}

/// The same by the program: a sine beside a parabola through ten minutes.
fn roll_by_run(scenario: Scenario, w: f64, height_m: f64) -> f64 {
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let mut a = [[0.0; 6]; 5];
    while simulation.time_s() < 900.0 {
        let record = simulation.step().expect("a good step");
        let roll = record.vessels[0].attitude.roll.value / (0.5 * height_m);
        let t = simulation.time_s();
        if t < 400.0 {
            continue;
        }
        let s = (t - 650.0) / 250.0;
        let basis = [1.0, s, s * s, (w * t).cos(), (w * t).sin(), roll];
        for i in 0..5 {
            for j in 0..6 {
                a[i][j] += basis[i] * basis[j];
            }
        }
    }
    for column in 0..5 {
        let pivot = a[column];
        for (row, line) in a.iter_mut().enumerate() {
            if row != column {
                let factor = line[column] / pivot[column];
                for (value, own) in line.iter_mut().zip(pivot) {
                    *value -= factor * own;
                }
            }
        }
    }
    f64::hypot(a[3][5] / a[3][3], a[4][5] / a[4][4])
}

fn compare(what: &str, held: &str, height_m: f64, force: impl Fn(&Six) -> Six) {
    compare_of(what, scenario, held, height_m, force);
}

fn compare_of(
    what: &str,
    scenario: impl Fn(f64, f64, &str) -> Scenario,
    held: &str,
    height_m: f64,
    force: impl Fn(&Six) -> Six,
) {
    let stiffness = stiffness(force);
    for w in SEVERAL {
        let wanted = roll_by_solve(&scenario(w, height_m, held), w, &stiffness);
        let found = roll_by_run(scenario(w, height_m, held), w, height_m);
        let off = found / wanted - 1.0;
        println!("{what}, {w} rad/s: roll {found:.5} rad/m, {wanted:.5} by the solve, {off:+.4}");
        assert!(off.abs() < 0.01, "{what}, {w} rad/s: {found} {wanted}");
    }
}

/// Their pull turns her upright: T y of each line is a tenth of her own restoring in all.
#[test]
fn a_barge_on_four_taut_lines_rolls_as_the_linear_solve_says() {
    let (tension_n, span_m) = (800e3, 60.0);
    let mut held = PIERS.to_owned();
    for (name, x, y) in [("a", 35, 10), ("b", -35, 10), ("c", 35, -10), ("d", -35, -10)] {
        let bollard_y = if y > 0 { 70 } else { -70 } - 200;
        held += &format!(
            "[line.{name}]\nfrom = \"barge\"\nfairlead = [{x}, {y}]\nfairlead_height = \"5 m\"\nto = \"piers\"\n\
             bollard = [{x}, {bollard_y}]\nbollard_height = \"5 m\"\nrope = \"nylon\"\nbreak_load = \"4000 kN\"\n\
             pretension = \"800 kN\"\n\n"
        );
    }
    // Nylon: 15 % at half of the break load.
    let axial_n = 4000e3 * 0.5 / 0.15;
    let length_m = span_m / (1.0 + tension_n / axial_n);
    compare("four lines", &held, SMALL_M, |motion| {
        let mut load = [0.0; 6];
        for (x, y) in [(35.0, 10.0), (-35.0, 10.0), (35.0, -10.0), (-35.0, -10.0_f64)] {
            let place = moved([x, y, 5.0], motion);
            let bollard = [x, 70.0_f64.copysign(y), -5.0];
            let d: [f64; 3] = std::array::from_fn(|k| bollard[k] - place[k]);
            let stretched_m = (d[0] * d[0] + d[1] * d[1] + d[2] * d[2]).sqrt();
            let pull_n = axial_n * (stretched_m / length_m - 1.0);
            add(&mut load, place, d.map(|part| pull_n * part / stretched_m), motion);
        }
        load
    });
}

/// A tug that pulls outwards from a fairlead 8 m above the water, against a steady load at the centre of gravity.
#[test]
fn a_barge_with_a_tug_on_a_line_rolls_as_the_linear_solve_says() {
    let held = r#"
[tug.puller]
vessel = "barge"
bollard_pull = "3000 kN"
push_at = [0, 10]
above_water = "8 m"
delay = 0
lag = 0

[[order]]
tug = "puller"
pull = "2500 kN"
direction = "90 deg"

[[load]]
body = "barge"
force = ["0 kN", "-2500 kN"]
"#;
    compare("a tug", held, SMALL_M, |motion| {
        let mut load = [0.0; 6];
        add(&mut load, moved([0.0, 10.0, 8.0], motion), [0.0, 2500e3, 0.0], motion);
        load
    });
}

/// A gale abeam on a high side, against a steady load at the centre of gravity. The wind's force keeps its direction; its
/// point, the centroid of the side 12 m above the water, moves with the barge.
#[test]
fn a_barge_in_a_gale_abeam_rolls_as_the_linear_solve_says() {
    const WIND: &str = "[environment.wind]\nspeed = \"30 m/s\"\nfrom = \"270 deg\"\n\n";
    let sides = "windage = { frontal_area = \"300 m^2\", lateral_area = \"1600 m^2\", centroid_height = \"12 m\", type = \"container ship, loaded\" }\n";
    let held = WIND;
    let windy = |omega_radps: f64, height_m: f64, held: &str| {
        scenario_of(
            &BARGE.replace("roll_damping", &format!("{sides}roll_damping")),
            omega_radps,
            height_m,
            held,
        )
    };
    let mut still = Simulation::new(windy(0.7, SMALL_M, held).setup).expect("a good set-up");
    let [x_n, y_n, z_nm] = {
        let wind = still.step().expect("a good step").vessel_forces[0].wind;
        [wind.surge_n, wind.sway_n, wind.yaw_nm]
    };
    println!("wind: {x_n} N, {y_n} N, {z_nm} N m");
    let held = format!(
        "{held}[[load]]\nbody = \"barge\"\nforce = [{}, {}]\nmoment = {}\n",
        -x_n, -y_n, -z_nm
    );
    compare_of("wind", windy, &held, SMALL_M, |motion| {
        let mut load = [0.0; 6];
        add(&mut load, moved([0.0, 0.0, 12.0], motion), [x_n, y_n, 0.0], motion);
        load
    });
}

/// A chain ahead to an anchor, partly on the bottom, against a steady load at the centre of gravity. The chain's form is
/// the catenary s² = h² + 2 h a, x = a arsinh(s/a), in the vertical plane through hawse pipe and anchor.
#[test]
fn a_barge_at_anchor_rolls_as_the_linear_solve_says() {
    let (hawse, out_m, depth_m) = ([36.0, 0.0, 9.0], 200.0_f64, 20.0);
    let anchor_m = 231.0;
    let chain = format!(
        "[anchor.bow]\non = \"barge\"\nside = \"starboard\"\nhawse = [36, 0]\nhawse_height = \"9 m\"\n\
         mass = \"30 t\"\nchain_diameter = \"120 mm\"\ngrade = \"u3\"\nchain_length = \"300 m\"\n\
         placed = [{anchor_m}, 0]\nchain_out = \"{out_m} m\"\n\n"
    );
    let mut still = Simulation::new(scenario(0.7, SMALL_M, &chain).setup).expect("a good set-up");
    let [north_n, east_n, up_n] = still.step().expect("a good step").anchors[0].load.on_ship_n;
    // 21.9 d² t/m, less the water's share.
    let weight_npm = 21.9e3 * 0.12 * 0.12 * (1.0 - 1025.0 / 7850.0) * 9.80665;
    let pull = |place: [f64; 3]| -> [f64; 3] {
        let (ahead_m, aside_m) = (anchor_m - place[0], -place[1]);
        let (span_m, height_m) = (ahead_m.hypot(aside_m), depth_m - place[2]);
        let (mut low_m, mut high_m) = (1.0_f64, 1e5_f64);
        for _ in 0..200 {
            let a_m = 0.5 * (low_m + high_m);
            let hung_m = (height_m * height_m + 2.0 * height_m * a_m).sqrt();
            let reach_m = out_m - hung_m + a_m * (hung_m / a_m).asinh();
            if reach_m < span_m { low_m = a_m } else { high_m = a_m }
        }
        let hung_m = (height_m * height_m + 2.0 * height_m * low_m).sqrt();
        let flat_n = weight_npm * low_m;
        [flat_n * ahead_m / span_m, flat_n * aside_m / span_m, weight_npm * hung_m]
    };
    let found = pull(moved(hawse, &[0.0; 6]));
    println!("chain: {north_n} N, {east_n} N, {up_n} N up; catenary {found:?}");
    // The chain stretches in the program, and not here.
    assert!((north_n / found[0] - 1.0).abs() < 0.05 && (-up_n / found[2] - 1.0).abs() < 0.05);
    let held = format!("{chain}[[load]]\nbody = \"barge\"\nforce = [{}, {}]\n", -north_n, -east_n);
    compare("an anchor", &held, SMALL_M, |motion| {
        let mut load = [0.0; 6];
        let place = moved(hawse, motion);
        add(&mut load, place, pull(place), motion);
        load
    });
}

/// Fenders without friction 4 m above the water on both sides of the barge, each pressed in by 0.8 m: stiffness 400 kN/m.
fn fenders(on: [&str; 2], y_m: f64, outwards: f64) -> String {
    let mut held = String::new();
    for (name, at_m) in [("starboard", 1.0), ("port", -1.0)] {
        held += &format!(
            "[body.{name}]\nfixed = true\noutline = [[-80, {a}], [80, {a}], [80, {b}], [-80, {b}]]\nposition = [0, 0]\n\n\
             [[pair]]\nbodies = [\"barge\", \"{name}\"]\nmaterial = \"rubber\"\n\n",
            a = 11.2 * at_m,
            b = 31.2 * at_m,
        );
        for x_m in [-35, 35] {
            let on = if at_m > 0.0 { on[0] } else { on[1] };
            held += &format!(
                "[fender.{name}_{}]\non = \"{on}\"\nposition = [{x_m}, {}]\nfacing = \"{} deg\"\nwidth = \"1 m\"\n\
                 projection = \"2 m\"\nabove_water = \"4 m\"\nstiffness = \"400 kN/m\"\nreturned_energy = \"100 %\"\n\
                 material = \"rubber\"\n\n",
                if x_m < 0 { "aft" } else { "fore" },
                y_m * at_m,
                90.0 * at_m * outwards,
            );
        }
    }
    held + "[material.rubber]\nstiffness = \"1 MN/m^2\"\n"
}

const FENDERS: [(f64, f64); 4] = [(-35.0, 1.0), (35.0, 1.0), (-35.0, -1.0), (35.0, -1.0)];

/// Each fender stays at its place of the quay, and presses square to her side where her side is at that place and height, as she has heaved, rolled,
/// pitched and yawed.
#[test]
fn a_barge_pressed_on_fenders_of_quays_rolls_as_the_linear_solve_says() {
    compare(
        "fenders of quays",
        &fenders(["starboard", "port"], 11.2, -1.0),
        AT_FENDERS_M,
        |motion| {
            let mut load = [0.0; 6];
            for (x_m, side) in FENDERS {
                let mut own = [x_m, 10.0 * side, 4.0];
                let mut place = moved(own, motion);
                for _ in 0..8 {
                    own[0] -= place[0] - x_m;
                    own[2] -= -place[2] - 4.0;
                    place = moved(own, motion);
                }
                let still = moved([0.0; 3], motion);
                let inwards = moved([0.0, -side, 0.0], motion);
                let normal: [f64; 3] = std::array::from_fn(|k| inwards[k] - still[k]);
                let push_n = 400e3 * (0.8 + side * place[1] - 10.0);
                let flat = normal[0].hypot(normal[1]);
                add(&mut load, place, normal.map(|part| push_n * part / flat), motion);
            }
            load
        },
    );
}

/// Fenders that she carries turn with her, and press square to the upright walls of the quays, where they touch them: 11.2 m
/// from her middle line, as each fender is pressed in by 0.8 m.
#[test]
fn a_barge_with_fenders_of_her_own_rolls_as_the_linear_solve_says() {
    compare("her own fenders", &fenders(["barge", "barge"], 10.0, 1.0), AT_FENDERS_M, |motion| {
        let mut load = [0.0; 6];
        for (x_m, side) in FENDERS {
            let place = moved([x_m, 11.2 * side, 4.0], motion);
            let push_n = 400e3 * (0.8 + side * place[1] - 11.2);
            add(&mut load, place, [0.0, -side * push_n, 0.0], motion);
        }
        load
    });
}

/// Roll moves fenders that she carries, and so compresses them. The ledger books this energy as work of height, and the
/// balance of the contacts closes with it: within 0.2 % of the work at 0.1 s, and the better the shorter the step is. At the
/// start the balance lacks the energy of the fenders into which she was placed.
#[test]
fn what_leaning_fenders_take_from_roll_is_in_the_ledger() {
    let held = fenders(["barge", "barge"], 10.0, 1.0);
    let run = |step: &str| {
        let barge = BARGE.replace("0.1 s", step);
        let mut simulation =
            Simulation::new(scenario_of(&barge, 0.7, 0.4, &held).setup).expect("a good set-up");
        let (mut most_j, mut off_j, mut start_j) = (0.0_f64, 0.0_f64, None);
        while simulation.time_s() < 300.0 {
            let record = simulation.step().expect("a good step");
            let energy = record.energy();
            let placed_j = *start_j.get_or_insert(energy.contact_residual_j);
            most_j = most_j.max(energy.height_work_j.abs());
            off_j = off_j.max((energy.contact_residual_j - placed_j).abs());
            assert!(energy.residual_j.abs() < 1e-9 * energy.exchanged_j().max(1.0));
        }
        println!("step {step}: work of height up to {most_j:.0} J, balance off by {off_j:.0} J");
        assert!(most_j > 1e6 && off_j < 2e-3 * most_j, "{most_j} J, {off_j} J");
        off_j
    };
    let (long_j, short_j) = (run("0.1 s"), run("0.05 s"));
    assert!(short_j < 0.6 * long_j, "{long_j} {short_j}");
}
