//! Runs scenarios in a native program; the tests of the npm package compare their runs in WebAssembly with these runs.
//!
//! `native hash STEPS SCENARIO...` prints, for each scenario, the fingerprint of the state after at most STEPS steps.
//! `native time SCENARIO` prints the time that a step of the scenario's whole run takes (ns), the median of several
//! runs.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::ExitCode;
use std::time::Instant;

use fenderline_wasm::run::{Run, Source, Wanted};

/// Runs that are timed.
const RUNS: usize = 9;

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let printed = match arguments.as_slice() {
        ["hash", steps, scenarios @ ..] => hashes(steps, scenarios),
        ["time", scenario] => time(scenario),
        _ => Err("usage: native hash STEPS SCENARIO... | native time SCENARIO".into()),
    };
    match printed {
        Ok(text) => {
            print!("{text}");
            ExitCode::SUCCESS
        }
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

fn hashes(steps: &str, scenarios: &[&str]) -> Result<String, String> {
    let steps: u32 = steps.parse().map_err(|e| format!("{steps}: {e}"))?;
    let line = |scenario: &&str| {
        let mut run = start(scenario)?;
        run.advance(steps).map_err(|problem| problem.details().text.clone())?;
        Ok(format!("{} {}\n", run.state_hash(), run.simulation().steps_taken()))
    };
    scenarios.iter().map(line).collect()
}

fn time(scenario: &str) -> Result<String, String> {
    let mut times_ns = Vec::new();
    for _ in 0..RUNS {
        let mut run = start(scenario)?;
        let begun = Instant::now();
        let steps = run.advance(u32::MAX).map_err(|problem| problem.details().text.clone())?;
        times_ns.push(begun.elapsed().as_nanos() as f64 / f64::from(steps));
    }
    times_ns.sort_by(f64::total_cmp);
    Ok(format!("{}\n", times_ns[RUNS / 2]))
}

fn start(scenario: &str) -> Result<Run, String> {
    let text = std::fs::read_to_string(scenario).map_err(|e| format!("{scenario}: {e}"))?;
    let files = tables(Path::new(scenario)).map_err(|e| format!("{scenario}: {e}"))?;
    let source = Source { text: &text, file: scenario, files, ..Source::default() };
    Run::new(&source, Wanted::default()).map_err(|problem| problem.details().text.clone())
}

/// The texts of the CSV files in the scenario's folder, by file name; the scenario may refer to these files.
fn tables(scenario: &Path) -> std::io::Result<BTreeMap<String, String>> {
    let mut tables = BTreeMap::new();
    for entry in std::fs::read_dir(scenario.parent().unwrap_or(Path::new(".")))? {
        let path = entry?.path();
        if path.extension().is_some_and(|extension| extension == "csv") {
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            tables.insert(name, std::fs::read_to_string(&path)?);
        }
    }
    Ok(tables)
}
