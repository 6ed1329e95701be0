//! Times a campaign: berthings of a ship at eight fenders, each 60 s long, at steps of 0.1 s. The time of a whole run,
//! which also draws random values and writes a table row, stands beside the time of the run's time steps alone. The
//! time on two threads stands beside the time on one thread.

use std::hint::black_box;
use std::path::PathBuf;

use fenderline_campaign::Campaign;
use fenderline_campaign::{RunNumbers, Runner, Runs, make};
use fenderline_sim::Simulation;

use crate::rounds::{Contender, least, median_ratio, nanoseconds_a_call};
use fenderline_bench_scenes::table::Table;

const SCENARIO: &str = include_str!("../../scenarios/berth/eight_cones_at_5_deg.toml");

const CAMPAIGN: &str = r#"
scenario = "eight.toml"
number = 1000000
set = ["time.duration=60 s"]
[variable.sway]
key = "body.ship.velocity.sway"
distribution = "lognormal"
mean = "10 cm/s"
standard_deviation = "4.47 cm/s"
at_most = "30 cm/s"
[variable.heading]
key = "body.ship.heading"
distribution = "normal"
mean = "0 deg"
standard_deviation = "1.5 deg"
at_least = "-4 deg"
at_most = "4 deg"
"#;

/// Runs in a round: so few that some rounds are not disturbed by other programs of the machine.
const RUNS: u64 = 40;

/// Runs in a round on threads: so many that starting the threads takes little of the time.
const RUNS_ON_THREADS: u64 = 400;

/// Goal for two threads: how many times as fast as one thread they must be.
const AIM_OF_TWO: f64 = 1.9;

/// Minutes that 10⁶ runs may take on two cores.
const AIM_MIN: f64 = 10.0;

fn runs() -> Result<(Runs, PathBuf), String> {
    let folder =
        std::env::temp_dir().join(format!("fenderline-bench-campaign-{}", std::process::id()));
    std::fs::create_dir_all(&folder).map_err(|e| e.to_string())?;
    // Without the study of the berthing, which is not part of a step.
    let scenario = SCENARIO.split("[berthing]").next().unwrap_or(SCENARIO);
    std::fs::write(folder.join("eight.toml"), scenario).map_err(|e| e.to_string())?;
    let file = folder.join("campaign.toml");
    std::fs::write(&file, CAMPAIGN).map_err(|e| e.to_string())?;
    let campaign = Campaign::load(&file).map_err(|e| e.to_string())?;
    Ok((Runs::new(campaign).map_err(|e| e.to_string())?, folder))
}

/// The time steps alone of the campaign's runs, without tables: one simulation, started again for each run.
fn steps(runs: &Runs, simulation: &mut Simulation) {
    let base = runs.base();
    let mut start = base.setup.start();
    for run in 0..RUNS {
        let own = runs.draws().of_run(run).overrides().expect("good values");
        assert!(base.start_with(&own, &mut start), "the start alone differs");
        simulation.restart(&start).expect("a restart in place");
        while !simulation.is_done() {
            black_box(simulation.step().expect("a good step"));
        }
    }
}

/// Times a campaign, and the time steps alone of its runs.
///
/// # Errors
/// Fails if the scenario is not good or the folder for temporary files cannot be made.
pub(crate) fn bench(rounds: usize) -> Result<Table, String> {
    let (runs, folder) = runs()?;
    let mut runner = Runner::new(&runs);
    let mut simulation = Simulation::new(runs.base().setup.clone()).map_err(|e| e.to_string())?;
    let campaign = || {
        for run in 0..RUNS {
            black_box(runner.run(run, &|| false));
        }
    };
    let numbers = RunNumbers::from(0..RUNS_ON_THREADS);
    let on_threads = |threads: usize| {
        make(&runs, &numbers, threads, &|| false, &mut |row| {
            black_box(row);
            Ok(true)
        })
        .expect("every row is used");
    };
    let mut contenders = [
        Contender::clocked(campaign, RUNS as usize),
        Contender::clocked(|| steps(&runs, &mut simulation), RUNS as usize),
        Contender::clocked(|| on_threads(1), RUNS_ON_THREADS as usize),
        Contender::clocked(|| on_threads(2), RUNS_ON_THREADS as usize),
    ];
    let times = nanoseconds_a_call(&mut contenders, rounds);
    let [run_ns, steps_ns, _, two_ns] = [0, 1, 2, 3].map(|way| least(&times[way]));
    let of_two = median_ratio(&times[2], &times[3]);
    let mut table = Table::new(&[
        "",
        "a run [µs]",
        "over the bare steps",
        "10⁶ runs on two cores [min]",
        "to reach",
        "",
    ]);
    let minutes = run_ns * 1e6 / 2.0 / 60e9;
    let verdict = |good: bool| if good { "✓" } else { "✗" }.to_owned();
    table.row(vec![
        "a campaign".to_owned(),
        format!("{:.1}", 1e-3 * run_ns),
        format!("{:.3}", run_ns / steps_ns),
        format!("{minutes:.1}"),
        format!("≤ 1.1, ≤ {AIM_MIN}"),
        verdict(run_ns <= 1.1 * steps_ns && minutes <= AIM_MIN),
    ]);
    table.row(vec![
        "bare steps".to_owned(),
        format!("{:.1}", 1e-3 * steps_ns),
        "1".to_owned(),
        String::new(),
        String::new(),
        String::new(),
    ]);
    table.row(vec![
        "a campaign on two threads".to_owned(),
        format!("{:.1}", 1e-3 * two_ns),
        String::new(),
        format!("{:.1}", two_ns * 1e6 / 60e9),
        format!("{of_two:.2} of ≥ {AIM_OF_TWO}"),
        verdict(of_two >= AIM_OF_TWO),
    ]);
    table.note("Times are the least of the rounds by the clock: a ship of 300 m at eight cone fenders, 600 steps a run.");
    table.note("The time on two cores is computed as half the time of one thread.");
    table.note("The last row says how many times as fast as one thread two threads are: the median of the rounds.");
    table.note("Two threads can be no faster than two processes of one thread each.");
    // An error is ignored: it is a folder for temporary files.
    let _ = std::fs::remove_dir_all(folder);
    Ok(table)
}
