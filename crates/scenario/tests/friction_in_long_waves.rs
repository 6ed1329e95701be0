//! What friction at the fenders does to a ship on constant-tension winches in long waves. The long forms are ignored: they take minutes.
//!
//!     cargo test -p fenderline-scenario --test all friction_in_long_waves:: -- --ignored --nocapture

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use std::fs;
use std::path::Path;
use std::thread;

use fenderline_scenario::{Override, Scenario};
use fenderline_sim::Simulation;

/// A scenario of the berths with keys set, and parts of its text replaced.
fn scenario(file: &str, settings: &[String], change: impl Fn(String) -> String) -> Scenario {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/berth");
    let read = |name: &str| fs::read_to_string(folder.join(name)).map_err(|why| why.to_string());
    let text = change(read(file).expect("the scenario"));
    let settings: Vec<Override> =
        settings.iter().map(|text| Override::parse(text).expect("a setting")).collect();
    Scenario::parse_among(&text, file, &settings, &mut |name| read(name)).expect("a good scenario")
}

/// Surge over a run without its first ten minutes.
#[derive(Clone, Copy, Debug, Default)]
struct Surge {
    /// Standard deviation about the mean of the run (m).
    deviation_m: f64,
    /// The same about a straight line in each piece of ten minutes, root mean square over the pieces (m): what long waves do, without
    /// where she goes meanwhile.
    swing_m: f64,
    /// Range of the means of those pieces (m).
    wander_m: f64,
    /// Mean of the fenders' normal forces together (N).
    press_n: f64,
    /// Share of the time in which friction is 0.95 of the most: she slips.
    slips: f64,
    /// Standard deviation of the lines' force along the quay (N).
    lines_n: f64,
}

fn surge(scenario: Scenario, friction: f64, duration_s: f64) -> Surge {
    let mut simulation = Simulation::new(scenario.setup).expect("a good set-up");
    let (mut places_m, mut press, mut along) = (Vec::new(), Vec::new(), Vec::new());
    let mut used = Vec::new();
    while simulation.time_s() < duration_s {
        let record = simulation.step().expect("a good step");
        if record.t_s < 600.0 {
            continue;
        }
        places_m.push(record.states_after[0].position_m.x);
        let normal_n: f64 = record.contacts.iter().map(|c| c.normal_force_n).sum();
        let shear_n: f64 = record.contacts.iter().map(|c| c.tangential_force_n.abs()).sum();
        press.push(normal_n);
        used.push(if normal_n > 0.0 { shear_n / normal_n } else { 0.0 });
        along.push(record.lines.iter().map(|line| line.load.on_ship_n[0]).sum::<f64>());
    }
    let pieces: Vec<&[f64]> = places_m.chunks(3000).filter(|piece| piece.len() == 3000).collect();
    let means: Vec<f64> = pieces.iter().map(|piece| mean(piece)).collect();
    let squares = pieces.iter().map(|piece| about_a_line(piece).powi(2)).sum::<f64>();
    let most = |numbers: &[f64]| numbers.iter().copied().fold(f64::MIN, f64::max);
    let least = |numbers: &[f64]| numbers.iter().copied().fold(f64::MAX, f64::min);
    Surge {
        deviation_m: deviation(&places_m),
        swing_m: (squares / pieces.len() as f64).sqrt(),
        wander_m: most(&means) - least(&means),
        press_n: mean(&press),
        slips: used.iter().filter(|used| **used > 0.95 * friction).count() as f64
            / used.len() as f64,
        lines_n: deviation(&along),
    }
}

fn mean(numbers: &[f64]) -> f64 {
    numbers.iter().sum::<f64>() / numbers.len() as f64
}

fn deviation(numbers: &[f64]) -> f64 {
    let mean = mean(numbers);
    (numbers.iter().map(|number| (number - mean).powi(2)).sum::<f64>() / numbers.len() as f64)
        .sqrt()
}

/// The standard deviation about a straight line.
fn about_a_line(numbers: &[f64]) -> f64 {
    let middle = 0.5 * (numbers.len() - 1) as f64;
    let (mut by, mut squares) = (0.0, 0.0);
    for (k, number) in numbers.iter().enumerate() {
        let at = k as f64 - middle;
        by += at * number;
        squares += at * at;
    }
    let slope = by / squares;
    let left: Vec<f64> =
        numbers.iter().enumerate().map(|(k, x)| x - slope * (k as f64 - middle)).collect();
    deviation(&left)
}

/// All lines on winches that hold a tension (N).
fn on_winches(text: &str, tension_kn: f64) -> String {
    text.replace(
        "pretension = \"100 kN\"",
        &format!(
            "pretension = \"{tension_kn} kN\"\nwinch = true\nconstant_tension = {{ tension = \"{tension_kn} kN\" }}"
        ),
    )
}

fn of_friction(friction: f64) -> Vec<String> {
    ["static", "dynamic"].map(|kind| format!("material.facing.friction_{kind}={friction}")).to_vec()
}

/// The small form: forty minutes of the worked scenario. She lies on winches of 200 kN; half is far from the twentieth that was found.
#[test]
fn friction_holds_the_swing_of_the_worked_ship_in_long_waves() {
    let swings_m = [0.2, 0.0].map(|friction| {
        let mut settings = of_friction(friction);
        settings.push("environment.long_waves.height=0.06".to_owned());
        let of = scenario("moored_in_long_waves.toml", &settings, |text| text);
        surge(of, friction, 2400.0).swing_m
    });
    println!("swing {swings_m:.4?} m with friction of 0.2, and without");
    assert!(swings_m[0] < 0.5 * swings_m[1], "{swings_m:?}");
}

/// Why she surged no less at 200 kN than at 100 kN: the deviation of two hours has where she wanders to. Without that, friction leaves the less
/// swing the more the lines press her on.
#[test]
#[ignore = "minutes"]
fn a_ship_on_winches_wanders_and_friction_holds_her_swing() {
    let mut before_m = f64::INFINITY;
    for tension_kn in [100.0, 150.0, 200.0, 250.0, 300.0] {
        for friction in [0.2, 0.0] {
            let mut settings = of_friction(friction);
            settings.push("environment.waves.height=0".to_owned());
            let of =
                scenario("moored_in_waves.toml", &settings, |text| on_winches(&text, tension_kn));
            let surge = surge(of, friction, 7200.0);
            println!(
                "{tension_kn} kN, friction {friction}: {:.1} cm, of which swing {:.1} cm; places of ten minutes {:.2} m apart; pressed on by \
                 {:.0} kN; slips in {:.0} % of the time; lines along the quay {:.0} kN",
                100.0 * surge.deviation_m,
                100.0 * surge.swing_m,
                surge.wander_m,
                surge.press_n / 1e3,
                100.0 * surge.slips,
                surge.lines_n / 1e3
            );
            if friction > 0.0 {
                assert!(surge.swing_m < before_m, "{surge:?} {before_m}");
                before_m = surge.swing_m;
            }
        }
    }
}

/// What holds the lines.
#[derive(Clone, Copy, Debug)]
enum Hold {
    /// Brakes, at a pretension (kN).
    Brakes(f64),
    /// Winches that hold a tension (kN).
    Winches(f64),
}

/// The significant height of long waves about 100 s (m) at which the significant range of swing passes half a metre, by bisection to 4 %.
fn threshold_m(hold: Hold, friction: f64) -> f64 {
    let passes = |height_m: f64| {
        let mut settings = of_friction(friction);
        settings.push(format!("environment.long_waves.height={height_m}"));
        let of = scenario("moored_in_long_waves.toml", &settings, |text| match hold {
            Hold::Winches(kn) => text.replace("\"200 kN\"", &format!("\"{kn} kN\"")),
            Hold::Brakes(kn) => text
                .replace("constant_tension = { tension = \"200 kN\" }", "")
                .replace("\"200 kN\"", &format!("\"{kn} kN\"")),
        });
        let surge = surge(of, friction, 4200.0);
        println!(
            "  {hold:?}, friction {friction}, {:.1} cm: significant range {:.3} m, places of ten minutes {:.2} m apart",
            100.0 * height_m,
            4.0 * surge.swing_m,
            surge.wander_m
        );
        4.0 * surge.swing_m > 0.5
    };
    let (mut low_m, mut high_m) = (0.01, 0.03);
    while !passes(high_m) {
        (low_m, high_m) = (high_m, 1.5 * high_m);
    }
    while high_m > 1.04 * low_m {
        let middle_m = (low_m * high_m).sqrt();
        if passes(middle_m) {
            high_m = middle_m;
        } else {
            low_m = middle_m;
        }
    }
    (low_m * high_m).sqrt()
}

/// Geraldton (JMSE 2016 4(1):3, of which the abstract was read): pneumatic fenders and winches that hold 30 t raise the threshold of the long
/// wave to one and a half times that of the mooring that is there, as she is pulled onto the fenders and their friction holds her. Here the
/// mooring that is there has brakes and 100 kN; ship, lines, fenders and waves are others. Friction raises both thresholds, but here winches of
/// 30 t and friction come to 0.9 of brakes and friction, not 1.5: her lines alone hold her well at this period. So only what friction does is
/// asserted.
#[test]
#[ignore = "minutes"]
fn friction_raises_the_threshold_of_the_long_wave() {
    let holds = [Hold::Brakes(100.0), Hold::Winches(300.0)];
    // A thread a search: they share nothing.
    let all = thread::scope(|scope| {
        let searches = holds.map(|hold| {
            [0.2, 0.0].map(|friction| scope.spawn(move || threshold_m(hold, friction)))
        });
        searches.map(|two| two.map(|search| search.join().expect("a threshold")))
    });
    for (hold, [rough_m, smooth_m]) in holds.iter().zip(all) {
        println!(
            "{hold:?}: threshold {:.1} cm with friction 0.2, {:.1} cm without: {:.2} times",
            100.0 * rough_m,
            100.0 * smooth_m,
            rough_m / smooth_m
        );
    }
    let [[there_m, bare_m], [held_m, free_m]] = all;
    println!(
        "winches and friction over brakes: {:.2} with friction 0.2, {:.2} without",
        held_m / there_m,
        free_m / bare_m
    );
    assert!(there_m > bare_m && held_m > 1.5 * free_m, "{all:?}");
}
