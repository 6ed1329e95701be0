//! `cargo xtask attack` runs every hostile check of the repository for a given time, from a given seed. Each part of
//! the attack is a test that otherwise runs for seconds, together with all other tests.

use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::{Instant, SystemTime, UNIX_EPOCH};

use crate::built;
use crate::command::{run, run_quietly};
use crate::fuzz;
use crate::live_load;
use crate::step::{Done, Step};

/// Default time for all parts of the attack together (s).
const SECONDS: u64 = 600;
/// Time of the attack in continuous integration (s): long enough to show that each part works.
const SECONDS_OF_GATE: u64 = 60;
/// Seed of the attack in continuous integration: a fixed seed, so that the outcome depends only on the change under
/// test.
const SEED_OF_GATE: u64 = 20_261_122;

/// This step belongs to `cargo xtask test all`.
pub(crate) const STEP: Step = Step { name: "attacks", run: attack_of_gate };

/// All parts but the fuzz targets, which are built once more, for seconds of fuzzing: `cargo xtask once-more` has them.
fn attack_of_gate() -> Result<Done, String> {
    let names: Vec<&str> =
        PARTS.iter().map(|part| part.name).filter(|name| *name != FUZZ).collect();
    attack(SECONDS_OF_GATE, SEED_OF_GATE, &names)
}

/// Name of the part with the fuzz targets.
const FUZZ: &str = "fuzz";

/// One part of the attack on the program.
struct Part {
    name: &'static str,
    /// What the part of the attack does, for the output.
    what: &'static str,
    attack: Kind,
}

enum Kind {
    /// One test, named by its file and its function.
    Test { test: &'static str },
    /// Tests that take a number of cases in place of a time. `counts` names environment variables, each with the number
    /// of cases to try for each second of the attack.
    Counted { tests: &'static [&'static str], counts: &'static [(&'static str, u64)] },
    /// A test of the live server with steering and hostile clients.
    LiveLoad,
    /// Tests of the Python package, which `crates/python/test.py` must have installed.
    Python,
    /// The fuzz targets.
    Fuzz,
}

const fn test(test: &'static str) -> Kind {
    Kind::Test { test }
}

const PARTS: [Part; 12] = [
    Part {
        name: "files",
        what: "scenarios with random changes, checked and run",
        attack: test("attack_files::a_changed_scenario_is_refused_or_runs"),
    },
    Part {
        name: "odd-files",
        what: "paths to pipes, devices, folders, links and sockets in every place for a file",
        attack: test("attack_files::paths_without_a_regular_file_are_refused_at_once"),
    },
    Part {
        name: "one-folder",
        what: "eight runs at once into one folder, on a slowed file system",
        attack: Kind::Counted {
            tests: &[
                "one_folder::one_of_eight_runs_at_once_writes_the_folder_and_seven_are_refused",
            ],
            counts: &[("FENDERLINE_ROUNDS", 1)],
        },
    },
    Part {
        name: "recordings",
        what: "recordings that are damaged and forged, replayed in memory",
        attack: Kind::Counted {
            tests: &[
                "recordings::a_thousand_damaged_recordings_are_all_detected",
                "recordings::a_forged_recording_is_refused_at_the_forged_line",
                "recordings::recordings_with_absurd_numbers_and_correct_check_sums_are_refused_or_replayed_in_time",
            ],
            counts: &[("FENDERLINE_DAMAGED", 2000), ("FENDERLINE_FORGED", 200)],
        },
    },
    Part {
        name: "recording-files",
        what: "recordings that are damaged and forged, replayed by `fenderline replay`",
        attack: Kind::Counted {
            tests: &[
                "recordings::damaged_recordings_are_never_reported_as_whole_and_never_take_long",
            ],
            counts: &[("FENDERLINE_DAMAGED_FILES", 40)],
        },
    },
    Part {
        name: "server",
        what: "malformed heads of requests, and all commands from the links of all roles",
        attack: test("attack_server::the_server_survives_any_message"),
    },
    Part {
        name: "server-load",
        what: "fifty hostile clients beside eight clients that steer",
        attack: Kind::LiveLoad,
    },
    Part {
        name: "providers",
        what: "providers that reply with anything, at any time, or never",
        attack: test("attack_providers::no_provider_stops_a_run_or_outlives_it"),
    },
    Part {
        name: "hosts",
        what: "hosts in C that teleport bodies, pass wrong velocities, step by 1e-9 to 1e6 s and alter \
               saved states",
        attack: test("attack_hosts::inconsistent_hosts"),
    },
    Part {
        name: "fmi",
        what: "FMI 3: altered and invented states, inputs and steps of any size, calls in any order",
        attack: test("attack_fmi3::altered_states_of_fmi_3"),
    },
    Part { name: "python", what: "inconsistent hosts, through Python", attack: Kind::Python },
    Part {
        name: FUZZ,
        what: "fuzz targets for engine, clip, scenario and snapshot, guided by coverage",
        attack: Kind::Fuzz,
    },
];

/// `cargo xtask attack [together] [SECONDS] [SEED] [PART...]`.
pub(crate) fn attack_command(arguments: &[&str]) -> ExitCode {
    let mut left = arguments.iter().copied().peekable();
    let in_parallel = left.next_if_eq(&"together").is_some();
    let mut number = |default: u64| match left.peek().map(|text| text.parse()) {
        Some(Ok(number)) => {
            left.next();
            number
        }
        _ => default,
    };
    let (seconds, seed) = (number(SECONDS), number(seed_of_the_day()));
    let named: Vec<&str> = left.collect();
    if let Some(unknown) = named.iter().find(|name| PARTS.iter().all(|part| part.name != **name)) {
        let names: Vec<&str> = PARTS.iter().map(|part| part.name).collect();
        eprintln!("there is no part `{unknown}`; there are {}", names.join(", "));
        return ExitCode::from(2);
    }
    let done = if in_parallel { together } else { attack }(seconds, seed, &named);
    match done {
        Ok(_) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// The seed of an attack that is given no seed: the number of the day, so that each day tries other things.
fn seed_of_the_day() -> u64 {
    const DAY_S: u64 = 86_400;
    SystemTime::now().duration_since(UNIX_EPOCH).map_or(0, |time| time.as_secs() / DAY_S)
}

/// The parts of the attack that have the given names; all parts if no name is given.
fn parts(named: &[&str]) -> Vec<&'static Part> {
    PARTS.iter().filter(|part| named.is_empty() || named.contains(&part.name)).collect()
}

/// Runs the parts of the attack in parallel, each for the whole time, with its output in `target/attack`.
///
/// # Errors
/// Fails with the names of the parts that found a fault.
fn together(seconds: u64, seed: u64, named: &[&str]) -> Result<Done, String> {
    let folder = PathBuf::from("target/attack");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let own = std::env::current_exe().map_err(|e| format!("this program: {e}"))?;
    let mut running = Vec::new();
    for part in parts(named) {
        let output = folder.join(part.name).with_extension("txt");
        let failed = |e| format!("{}: {e}", output.display());
        let file = std::fs::File::create(&output).map_err(failed)?;
        let errors = file.try_clone().map_err(failed)?;
        let mut command = Command::new(&own);
        command.args(["attack", &seconds.to_string(), &seed.to_string(), part.name]);
        command.stdin(Stdio::null()).stdout(file).stderr(errors);
        let child = command.spawn().map_err(|e| format!("{}: {e}", part.name))?;
        println!(
            "-- {}: {}; {seconds} s, seed {seed}, to {}",
            part.name,
            part.what,
            output.display()
        );
        running.push((part.name, output, child));
    }
    let mut lost = Vec::new();
    for (name, output, mut child) in running {
        let status = child.wait().map_err(|e| format!("{name}: {e}"))?;
        let printed =
            std::fs::read_to_string(&output).map_err(|e| format!("{}: {e}", output.display()))?;
        println!("-- {name}: {}", if status.success() { "survived" } else { "DID NOT SURVIVE" });
        printed.lines().filter(|line| line.contains(" tried") || line.contains("seed ")).for_each(
            |line| {
                println!("   {}", line.trim_start_matches(['-', '.', ' ']));
            },
        );
        if !status.success() {
            lost.push(format!("{name} (see {})", output.display()));
        }
    }
    if lost.is_empty() { Ok(Done::Good) } else { Err(format!("lost: {}", lost.join(", "))) }
}

/// Runs the parts of the attack one after the other, each for an equal share of the time.
///
/// # Errors
/// What did not survive.
fn attack(seconds: u64, seed: u64, named: &[&str]) -> Result<Done, String> {
    let parts = parts(named);
    let each = (seconds / parts.len() as u64).max(1);
    for part in parts {
        println!("-- {}: {}; {each} s, seed {seed}", part.name, part.what);
        let began = Instant::now();
        attack_part(part, each, seed).map_err(|why| format!("{}: {why}", part.name))?;
        println!("   survived, {:.0} s", began.elapsed().as_secs_f64());
    }
    Ok(Done::Good)
}

fn attack_part(part: &Part, seconds: u64, seed: u64) -> Result<(), String> {
    match part.attack {
        Kind::Test { test } => {
            let mut command = named_tests(&[test]);
            command.env("FENDERLINE_ATTACK_SECONDS", seconds.to_string());
            run_named(command.env("FENDERLINE_ATTACK_SEED", seed.to_string()), 1)
        }
        Kind::Counted { tests, counts } => {
            let mut command = named_tests(tests);
            for (key, per_second) in counts {
                command.env(key, (per_second * seconds).to_string());
            }
            run_named(command.env("FENDERLINE_SEED", seed.to_string()), tests.len())
        }
        // Times are reported, not required: other programs may use the processor too.
        Kind::LiveLoad => live_load::live_load(seconds, true),
        Kind::Python => python(seconds, seed),
        Kind::Fuzz => match fuzz::fuzz((seconds / fuzz::TARGETS.len() as u64).max(1))? {
            Done::Good => Ok(()),
            Done::NotRun(missing) => {
                println!("   not run: {} is missing; install: {}", missing.tool, missing.install);
                Ok(())
            }
        },
    }
}

fn named_tests(names: &[&str]) -> Command {
    let mut command = built::tests(&["--nocapture", "--include-ignored", "--exact"]);
    command.args(names);
    command
}

/// Runs the tests that have the given names. A name that no test has is a failure, because nothing would be attacked.
fn run_named(command: &mut Command, count: usize) -> Result<(), String> {
    let printed = run_quietly(command)?;
    println!("{}", printed.trim());
    let passed =
        |line: &str| line.split_once(" passed")?.0.rsplit(' ').next()?.parse::<usize>().ok();
    if printed.lines().filter_map(passed).sum::<usize>() == count {
        Ok(())
    } else {
        Err(format!("{command:?}: not {count} tests of these names"))
    }
}

/// Runs the Python part of the attack in the virtual environment that the tests of the package made.
fn python(seconds: u64, seed: u64) -> Result<(), String> {
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    let python = target.join("python-package/bin/python");
    if !python.is_file() {
        println!(
            "   not run: the Python package is not installed; `python3 crates/python/test.py` installs it"
        );
        return Ok(());
    }
    let mut pytest = Command::new(python);
    pytest.args(["-B", "-m", "pytest", "-s", "crates/python/tests/test_attack.py"]);
    pytest.env("FENDERLINE_ATTACK_SECONDS", seconds.to_string());
    run(pytest.env("FENDERLINE_ATTACK_SEED", seed.to_string()))
}
