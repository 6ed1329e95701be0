//! `cargo xtask bench passage`: a made-up passage of 10 nautical miles, with a survey of 4 million cells and 20,000
//! corners of coast. The benchmark prints load time, speed compared with real time, peak memory, and time of one query
//! of the depth, each beside its limit.

#[path = "../../scenario/tests/support/long_passage.rs"]
mod long_passage;

use std::hint::black_box;
use std::path::Path;
use std::process::{Command, ExitCode};
use std::time::Instant;

use fenderline_contact::{Vec2, vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::Simulation;
use fenderline_sim::environment::DepthField;

/// Where the files of the passage are written, from the folder of the repository.
const FOLDER: &str = "target/passage";
/// Rounds of each measurement; the least time counts, because other programs only ever add to a time.
const ROUNDS: usize = 5;

fn main() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let folder = root.join(FOLDER);
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>().as_slice() {
        ["make"] => make(&folder),
        ["sail"] => sail(&folder),
        ["steps", count] => steps(&folder, count),
        // The files are made by a process of its own, whose memory does not count.
        [] => ["make", "sail"].into_iter().all(again).then_some(()).ok_or(String::new()),
        _ => Err("the arguments are none, `make`, `sail` or `steps` with a number".to_owned()),
    }
    .map_or_else(
        |message| {
            eprintln!("{message}");
            ExitCode::FAILURE
        },
        |()| ExitCode::SUCCESS,
    )
}

/// Runs this program with one argument.
fn again(argument: &str) -> bool {
    let program = std::env::current_exe().expect("the path of this program");
    Command::new(program).arg(argument).status().is_ok_and(|status| status.success())
}

fn make(folder: &Path) -> Result<(), String> {
    let files = long_passage::WHOLE.files();
    std::fs::create_dir_all(folder).map_err(|error| format!("{}: {error}", folder.display()))?;
    for (name, text) in [
        ("passage.toml", &files.scenario),
        ("passage.geojson", &files.chart),
        ("passage.asc", &files.survey),
    ] {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(|error| format!("{}: {error}", path.display()))?;
        println!("{FOLDER}/{name}: {:.1} MB", text.len() as f64 / 1e6);
    }
    Ok(())
}

fn sail(folder: &Path) -> Result<(), String> {
    let path = folder.join("passage.toml");
    let (mut load_s, mut ratio) = (f64::INFINITY, 0.0);
    let mut last = None;
    for round in 0..ROUNDS {
        drop(last.take());
        let began = Clock::now();
        let scenario = load(&path)?;
        let mut simulation = Simulation::new(scenario.setup).map_err(|error| error.to_string())?;
        let own_load_s = began.elapsed_s();
        load_s = libm::fmin(load_s, own_load_s);
        let began = Clock::now();
        let sailed = long_passage::sail(&mut simulation, u64::MAX);
        let run_s = began.elapsed_s();
        let passage_s = sailed.steps as f64 * simulation.setup().step_s;
        ratio = libm::fmax(ratio, passage_s / run_s);
        if round == 0 {
            println!(
                "{:.2} nautical miles in {passage_s:.0} s, Δt = {} s, {} steps; at most {:.0} m off the track, least depth \
                 under her {:.1} m",
                sailed.along_m / 1852.0,
                simulation.setup().step_s,
                sailed.steps,
                sailed.off_m,
                sailed.least_m
            );
        }
        println!(
            "round {}: loaded in {own_load_s:.2} s; {:.1} µs a step; load of the machine {}",
            round + 1,
            1e6 * run_s / sailed.steps as f64,
            machine_load()
        );
        last = Some(simulation);
    }
    let peak_mb = peak_mb();
    let simulation = last.expect("there is at least one round");
    let bottom = simulation.setup().world.environment.bottom.as_ref().expect("a bottom by place");
    let [depth_ns, both_ns] = queries_ns(&bottom.field);
    let verdict = |holds: bool| if holds { "holds" } else { "DOES NOT HOLD" };
    println!("load:             {load_s:.2} s, limit 3 s: {}", verdict(load_s <= 3.0));
    println!(
        "speed:            {ratio:.0} × real time on one core, limit 2000: {}",
        verdict(ratio >= 2000.0)
    );
    match peak_mb {
        Some(peak_mb) => println!(
            "peak memory:      {peak_mb:.0} MB, limit 300 MB: {}",
            verdict(peak_mb <= 300.0)
        ),
        None => println!("peak memory:      not known on this system"),
    }
    println!(
        "depth:            {depth_ns:.0} ns a query, limit 100 ns: {}",
        verdict(depth_ns <= 100.0)
    );
    println!(
        "depth, gradient:  {both_ns:.0} ns a query, limit 100 ns: {}",
        verdict(both_ns <= 100.0)
    );
    Ok(())
}

/// Loads the passage and sails a number of steps, for counts of instructions: the difference between two numbers of
/// steps is the steps alone.
fn steps(folder: &Path, count: &str) -> Result<(), String> {
    let count = count.parse().map_err(|_| format!("{count} is not a number of steps"))?;
    let scenario = load(&folder.join("passage.toml"))?;
    let mut simulation = Simulation::new(scenario.setup).map_err(|error| error.to_string())?;
    black_box(long_passage::sail(&mut simulation, count));
    Ok(())
}

fn load(path: &Path) -> Result<Scenario, String> {
    Scenario::load(path, &[]).map_err(|error| error.to_string())
}

/// Times of a query of the depth, and of depth and gradient (ns), at places all over the field.
fn queries_ns(field: &DepthField) -> [f64; 2] {
    let [low, high] = field.corners_m();
    let share = |index: u32, by: f64| (f64::from(index) * by).fract();
    let place = |index: u32| {
        let size = high - low;
        low + vec2(size.x * share(index, 0.754_877_666), size.y * share(index, 0.569_840_291))
    };
    let places: Vec<Vec2> = (1..=200_000).map(place).collect();
    let mut least_ns = [f64::INFINITY; 2];
    for batch in places.chunks(2000) {
        let count = batch.len() as f64;
        let began = Instant::now();
        for &at_m in batch {
            black_box(field.depth_m(black_box(at_m)));
        }
        least_ns[0] = libm::fmin(least_ns[0], began.elapsed().as_nanos() as f64 / count);
        let began = Instant::now();
        for &at_m in batch {
            black_box(field.sounding(black_box(at_m)));
        }
        least_ns[1] = libm::fmin(least_ns[1], began.elapsed().as_nanos() as f64 / count);
    }
    least_ns
}

/// Largest memory that this process has had (MB), from Linux.
fn peak_mb() -> Option<f64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kib: f64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024.0 * kib / 1e6)
}

/// Measures the time for which this thread has had a processor, from Linux. Other programs on the machine take processor
/// time from this program, and this time does not count. On other systems, the clock's time counts.
struct Clock {
    began: Instant,
    had_s: Option<f64>,
}

impl Clock {
    fn now() -> Clock {
        Clock { began: Instant::now(), had_s: Clock::had_s() }
    }

    fn had_s() -> Option<f64> {
        let text = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
        Some(1e-9 * text.split_whitespace().next()?.parse::<f64>().ok()?)
    }

    fn elapsed_s(&self) -> f64 {
        match (self.had_s, Clock::had_s()) {
            (Some(before_s), Some(now_s)) => now_s - before_s,
            _ => self.began.elapsed().as_secs_f64(),
        }
    }
}

/// Mean number of processes that wanted to run in the last minute, from Linux.
fn machine_load() -> String {
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    load.split_whitespace().next().unwrap_or("not known").to_owned()
}
