//! The worked scenario of a container ship moored in swell, gusts and long waves. The long forms are ignored: they take minutes.
//!
//!     cargo test -p fenderline-scenario --test all moored_in_waves:: -- --ignored --nocapture

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::fs;
use std::path::Path;

use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;

fn scenario(change: impl Fn(String) -> String) -> Scenario {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/berth");
    let read = |name: &str| fs::read_to_string(folder.join(name)).map_err(|why| why.to_string());
    let text = change(read("moored_in_waves.toml").expect("the scenario"));
    Scenario::parse_among(&text, "moored_in_waves.toml", &[], &mut |name| read(name))
        .expect("a good scenario")
}

/// Motions about their means over a run without its first ten minutes: surge, sway, heave (m), roll, pitch, yaw (rad).
#[derive(Debug)]
struct Statistics {
    deviation: [f64; 6],
    largest: [f64; 6],
    line_n: f64,
    fender_n: f64,
    /// The largest force of a passing ship, along the moored ship or across her.
    passing_n: f64,
    residual: f64,
}

fn run(scenario: Scenario, duration_s: f64) -> Statistics {
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut sum, mut squares, mut count) = ([0.0; 6], [0.0; 6], 0.0);
    let (mut low, mut high) = ([f64::MAX; 6], [f64::MIN; 6]);
    let (mut line_n, mut fender_n, mut passing_n, mut residual) = (0.0_f64, 0.0_f64, 0.0_f64, 0.0);
    while simulation.time_s() < duration_s {
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
        residual = record.energy().residual_j.abs() / record.energy().exchanged_j().max(1.0);
        if record.t_s < 600.0 {
            continue;
        }
        line_n = record.lines.iter().map(|line| line.load.tension_n).fold(line_n, f64::max);
        fender_n = record.contacts.iter().map(|c| c.normal_force_n).fold(fender_n, f64::max);
        let passing = record.vessel_forces[0].passing;
        passing_n = passing_n.max(passing.surge_n.abs()).max(passing.sway_n.abs());
        count += 1.0;
        for k in 0..6 {
            sum[k] += now[k];
            squares[k] += now[k] * now[k];
            (low[k], high[k]) = (low[k].min(now[k]), high[k].max(now[k]));
        }
    }
    let mean = sum.map(|sum| sum / count);
    Statistics {
        deviation: std::array::from_fn(|k| {
            (squares[k] / count - mean[k] * mean[k]).max(0.0).sqrt()
        }),
        largest: std::array::from_fn(|k| (high[k] - mean[k]).max(mean[k] - low[k])),
        line_n,
        fender_n,
        passing_n,
        residual,
    }
}

#[test]
fn a_ship_moored_in_waves_stays_at_her_berth_and_her_ledger_closes() {
    let statistics = run(scenario(|text| text), 900.0);
    println!("{statistics:?}");
    let [surge, sway, heave, roll, ..] = statistics.largest;
    assert!(surge < 5.0 && sway < 3.0 && heave < 1.5 && roll < 0.1, "{statistics:?}");
    assert!(statistics.line_n > 0.0 && statistics.fender_n > 0.0, "{statistics:?}");
    assert!(statistics.residual < 1e-3, "{statistics:?}");
}

/// Deviations of the six motions at some steps over those at the last of them.
fn deviation_ratios<const N: usize>(steps: [&str; N], duration_s: f64) -> Vec<(usize, [f64; 6])> {
    let all = steps.map(|step| {
        let statistics =
            run(scenario(|text| text.replace("\"0.2 s\"", &format!("\"{step}\""))), duration_s);
        println!("step {step}: {statistics:?}");
        statistics.deviation
    });
    let finest = all[N - 1];
    let ratios = |of: &[f64; 6]| std::array::from_fn(|k| of[k] / finest[k]);
    all[..N - 1].iter().map(ratios).enumerate().collect()
}

/// Deviations within 2 %, as the design sheet asks.
fn assert_same_statistics<const N: usize>(steps: [&str; N], duration_s: f64) {
    for (index, ratios) in deviation_ratios(steps, duration_s) {
        println!("step {} over {}: {ratios:.4?}", steps[index], steps[N - 1]);
        for (k, ratio) in ratios.into_iter().enumerate() {
            assert!((ratio - 1.0).abs() < 0.02, "step {}, motion {k}: {ratio}", steps[index]);
        }
    }
}

#[test]
fn half_an_hour_at_steps_of_0_1_to_0_5_s_has_the_same_statistics() {
    assert_same_statistics(["0.5 s", "0.2 s", "0.1 s"], 1800.0);
}

#[test]
#[ignore = "minutes: three hours at four steps"]
fn steps_of_0_05_to_0_5_s_give_the_same_statistics() {
    assert_same_statistics(["0.5 s", "0.2 s", "0.1 s", "0.05 s"], 10_800.0);
}

/// Ten hours with a ship that passes: the ledger closes as after one, and a second run has the same bits.
#[test]
#[ignore = "minutes"]
fn ten_hours_have_no_drift_of_energy_and_repeat_to_the_bit() {
    let begun = std::time::Instant::now();
    let [one, two] = [0, 1].map(|_| run(scenario(|text| text), 36_000.0));
    let times_real = 72_000.0 / begun.elapsed().as_secs_f64();
    println!("{one:?}\n{times_real:.0} times real time on one core");
    assert_eq!(format!("{one:?}"), format!("{two:?}"));
    assert!(one.residual < 1e-6, "{}", one.residual);
    assert!(one.passing_n > 1e5, "{} N", one.passing_n);
}

/// The passing ship adds to the surge of the moored one: five minutes with her passage against the same without it.
#[test]
fn a_passing_ship_pulls_the_moored_ship_in_waves() {
    let with = |time: &str| {
        run(scenario(|text| text.replace("time = \"5 h\"", &format!("time = \"{time}\""))), 900.0)
    };
    let (near, far) = (with("12 min"), with("5 h"));
    println!("{near:?}\n{far:?}");
    assert!(near.passing_n > 1e5 && far.passing_n < 1e3, "{} {}", near.passing_n, far.passing_n);
    assert!(near.deviation[0] > 1.05 * far.deviation[0], "{near:?} {far:?}");
    assert!(near.residual < 1e-3, "{near:?}");
}

/// Surge in long waves alone, root mean square (m).
fn surge_in_long_waves(change: impl Fn(String) -> String, duration_s: f64) -> f64 {
    let still = |text: String| text.replace("height = \"0.8 m\"", "height = 0");
    run(scenario(|text| change(still(text))), duration_s).deviation[0]
}

fn without_friction(text: String) -> String {
    text.replace("friction_static = 0.2", "friction_static = 0")
        .replace("friction_dynamic = 0.2", "friction_dynamic = 0")
}

/// All lines on winches that hold a tension.
fn on_winches(text: &str, tension: &str) -> String {
    text.replace(
        "pretension = \"100 kN\"",
        &format!(
            "pretension = \"{tension}\"\nwinch = true\nconstant_tension = {{ tension = \"{tension}\" }}"
        ),
    )
}

#[test]
fn friction_of_fenders_holds_the_surge_of_a_ship_on_constant_tension_winches() {
    let rough = surge_in_long_waves(|text| on_winches(&text, "200 kN"), 1500.0);
    let smooth = surge_in_long_waves(|text| without_friction(on_winches(&text, "200 kN")), 1500.0);
    println!("surge: {rough:.3} m with friction 0.2, {smooth:.3} m without");
    assert!(rough < 0.8 * smooth, "{rough} {smooth}");
}

#[test]
fn a_constant_tension_without_a_winch_is_refused_with_its_line() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/berth");
    let read = |name: &str| fs::read_to_string(folder.join(name)).map_err(|why| why.to_string());
    let of = |more: &str| {
        let text = read("moored_in_waves.toml").expect("the scenario");
        let text = text.replacen(
            "pretension = \"100 kN\"",
            &format!("pretension = \"100 kN\"\n{more}"),
            1,
        );
        Scenario::parse_among(&text, "moored_in_waves.toml", &[], &mut |name| read(name))
            .expect_err("a mistake")
            .to_string()
    };
    let no_winch = of("constant_tension = { tension = \"100 kN\" }");
    assert!(no_winch.contains("`line.head_1.constant_tension` needs `winch = true`"), "{no_winch}");
    let over = of("winch = true\nconstant_tension = { tension = \"700 kN\" }");
    assert!(over.contains("head_1") && over.contains("upper edge"), "{over}");
    let none = of("winch = true\nconstant_tension = { band = 0.1 }");
    assert!(none.contains("line.head_1.constant_tension.tension"), "{none}");
}

/// The trend of Geraldton (JMSE 2016 4(1):3): friction at the fenders holds surge, the more the lines press her on.
#[test]
#[ignore = "minutes: surge in long waves with and without friction, on fixed lines and on winches"]
fn friction_of_fenders_and_winches_holds_surge_in_long_waves() {
    let surge = |change: &dyn Fn(String) -> String| surge_in_long_waves(change, 7200.0);
    let rough = surge(&|text| text);
    let smooth = surge(&without_friction);
    let taut = |text: String| text.replace("pretension = \"100 kN\"", "pretension = \"300 kN\"");
    let tight = surge(&taut);
    println!(
        "surge, root mean square: {rough:.3} m with friction 0.2, {smooth:.3} m without, {tight:.3} m with lines at 300 kN"
    );
    for tension in ["100 kN", "200 kN", "300 kN"] {
        let held = surge(&|text| on_winches(&text, tension));
        let free = surge(&|text| without_friction(on_winches(&text, tension)));
        println!("winches at {tension}: {held:.3} m with friction, {free:.3} m without");
    }
    assert!(tight < rough && rough < smooth);
}

/// A table of rows by frequency and heading with every second of both, in a text whose other rows are kept.
fn thinned(text: &str) -> String {
    let (mut kept, mut table) = (String::new(), "");
    let (mut omegas, mut headings): (Vec<&str>, Vec<&str>) = (Vec::new(), Vec::new());
    let place = |seen: &mut Vec<&'_ str>, cell: &str| seen.iter().position(|own| *own == cell);
    for line in text.lines() {
        if let Some(name) = line.strip_prefix("= ") {
            (table, omegas, headings) = (name, Vec::new(), Vec::new());
        }
        let cells: Vec<&str> = line.split(',').collect();
        if ["excitation", "drift"].contains(&table) && cells[0].parse::<f64>().is_ok() {
            for (seen, cell) in [(&mut omegas, cells[0]), (&mut headings, cells[1])] {
                if place(seen, cell).is_none() {
                    seen.push(cell);
                }
            }
            let at = [place(&mut omegas, cells[0]), place(&mut headings, cells[1])];
            if at.iter().any(|at| at.is_some_and(|at| at % 2 == 1)) {
                continue;
            }
        }
        kept += line;
        kept.push('\n');
    }
    kept
}

/// Standard deviations of the six motions in an hour of the moored ship with these data, in a sea of 1.5 m and 10 s from 225
/// degrees.
fn deviations_from_225_deg(data: &str) -> [f64; 6] {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let text = fs::read_to_string(folder.join("scenarios/berth/moored_in_waves.toml"))
        .expect("the scenario")
        .replace(
            "height = \"0.8 m\", period = \"10 s\", from = \"200 deg\"",
            "height = \"1.5 m\", period = \"10 s\", from = \"225 deg\"",
        );
    assert!(text.contains("225 deg"));
    let mut read = |name: &str| match name.ends_with(".hydro") {
        true => Ok(data.to_owned()),
        false => fs::read_to_string(folder.join("scenarios/berth").join(name))
            .map_err(|why| why.to_string()),
    };
    let scenario = Scenario::parse_among(&text, "moored_in_waves.toml", &[], &mut read);
    run(scenario.expect("a good scenario"), 4200.0).deviation
}

fn assert_alike(what: &str, [fine, coarse]: [[f64; 6]; 2]) {
    let off: [f64; 6] = std::array::from_fn(|k| coarse[k] / fine[k] - 1.0);
    println!("{what}: {fine:.4?} with the finer data, with the coarser {off:+.4?}");
    assert!(off.iter().all(|off| off.abs() < 0.03), "{what}: {off:?}");
}

/// The sea comes from a heading of the shipped data which those lack that have every second heading and frequency of them:
/// standard deviations of the six motions within 3 %. With and without drift in the data.
#[test]
#[ignore = "five hours of simulation"]
fn an_hour_between_headings_does_not_depend_on_the_steps_of_the_data() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for file in ["scenarios/berth/container_ship_20m.hydro", "hydrodynamics/ship_20m.hydro"] {
        let whole = fs::read_to_string(folder.join(file)).expect("a file of the repository");
        let both = [&whole, &thinned(&whole)].map(|data| deviations_from_225_deg(data));
        assert_alike(file, both);
    }
}

/// The shipped data beside data of half the steps, of this file:
///
///     python3 hydrodynamics/capytaine_hulls.py ship_20m FOLDER --half-steps
///     HALF_STEPS=FOLDER/ship_20m.hydro cargo test -p fenderline-scenario --test all half_the_steps -- --ignored --nocapture
#[test]
#[ignore = "needs a panel run of several minutes; two hours of simulation"]
fn data_of_half_the_steps_give_the_same_motions_of_the_moored_ship() {
    let path = std::env::var("HALF_STEPS").expect("the environment variable HALF_STEPS");
    let read = |path: &Path| fs::read_to_string(path).expect("a file");
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let shipped = read(&folder.join("hydrodynamics/ship_20m.hydro"));
    let finer = read(Path::new(&path));
    assert!(finer.len() > 3 * shipped.len(), "{path} has not half the steps");
    assert_alike("ship_20m", [finer, shipped].map(|data| deviations_from_225_deg(&data)));
}
