//! `cargo xtask attack`: every hostile check of the repository for a given time, from a given seed. Each part is a test
//! that also runs in seconds with all others; here it is told for how long.

use std::path::PathBuf;
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

use crate::command::{cargo, run};
use crate::fuzz;
use crate::live_load;
use crate::step::Done;

/// Time for all parts together where the caller does not say (s): that of continuous integration.
pub(crate) const SECONDS: u64 = 600;
/// The seed where the caller does not say.
pub(crate) const SEED: u64 = 20_261_122;

/// What is attacked.
struct Part {
    name: &'static str,
    /// What is done to it, for who reads the output.
    what: &'static str,
    attack: Kind,
}

enum Kind {
    /// A test of a package, by its file and the start of its name.
    Test { package: &'static str, file: &'static str, test: &'static str },
    /// The same for a test that is told how many: so many a second by each key, on a machine as slow as ours.
    Counted {
        package: &'static str,
        file: &'static str,
        tests: &'static [&'static str],
        counts: &'static [(&'static str, u64)],
    },
    /// The live server with steering and hostile clients.
    LiveLoad,
    /// Tests of the Python package, where `crates/python/test.py` has installed it.
    Python,
    /// The fuzz targets.
    Fuzz,
}

const fn test(package: &'static str, file: &'static str, test: &'static str) -> Kind {
    Kind::Test { package, file, test }
}

const PARTS: [Part; 12] = [
    Part {
        name: "files",
        what: "scenarios with something changed, checked and run",
        attack: test("fenderline", "attack_files", "a_changed_scenario"),
    },
    Part {
        name: "odd-files",
        what: "pipes, devices, folders, links and sockets in every place for a file",
        attack: test("fenderline", "attack_files", "what_is_no_file"),
    },
    Part {
        name: "one-folder",
        what: "eight runs at once into one folder, on slowed files",
        attack: Kind::Counted {
            package: "fenderline",
            file: "one_folder",
            tests: &["of_eight_runs"],
            counts: &[("FENDERLINE_ROUNDS", 1)],
        },
    },
    Part {
        name: "recordings",
        what: "recordings damaged and forged, in memory",
        attack: Kind::Counted {
            package: "fenderline-live",
            file: "recordings",
            tests: &["damaged", "forged", "absurd"],
            counts: &[("FENDERLINE_DAMAGED", 2000), ("FENDERLINE_FORGED", 200)],
        },
    },
    Part {
        name: "recording-files",
        what: "recordings damaged and forged, by `fenderline replay`",
        attack: Kind::Counted {
            package: "fenderline",
            file: "recordings",
            tests: &["damaged", "forged", "absurd"],
            counts: &[("FENDERLINE_DAMAGED_FILES", 40)],
        },
    },
    Part {
        name: "server",
        what: "broken heads and any command from every link",
        attack: test("fenderline", "attack_server", ""),
    },
    Part {
        name: "server-load",
        what: "fifty hostile clients beside eight that steer",
        attack: Kind::LiveLoad,
    },
    Part {
        name: "providers",
        what: "programs that answer with anything, at any time, or not at all",
        attack: test("fenderline", "attack_providers", ""),
    },
    Part {
        name: "hosts",
        what: "simulators in C that teleport, lie about speeds, step from 1e-9 to 1e6 s and alter saved states",
        attack: test("fenderline-capi", "attack_hosts", "inconsistent_hosts"),
    },
    Part {
        name: "fmi",
        what: "states of FMI 3 altered and absurd, inputs and steps of any size, calls in any order",
        attack: test("fenderline-fmu", "attack_fmi3", "altered_states"),
    },
    Part { name: "python", what: "hosts that lie, through Python", attack: Kind::Python },
    Part {
        name: "fuzz",
        what: "engine, clip, scenario and snapshot, by coverage",
        attack: Kind::Fuzz,
    },
];

/// `cargo xtask attack [together] [SECONDS] [SEED] [PART...]`.
pub(crate) fn attack_command(arguments: &[&str]) -> ExitCode {
    let mut left = arguments.iter().copied().peekable();
    let at_once = left.next_if_eq(&"together").is_some();
    let mut number = |otherwise: u64| match left.peek().map(|text| text.parse()) {
        Some(Ok(number)) => {
            left.next();
            number
        }
        _ => otherwise,
    };
    let (seconds, seed) = (number(SECONDS), number(SEED));
    let asked: Vec<&str> = left.collect();
    if let Some(unknown) = asked.iter().find(|name| PARTS.iter().all(|part| part.name != **name)) {
        let names: Vec<&str> = PARTS.iter().map(|part| part.name).collect();
        eprintln!("there is no part `{unknown}`; there are {}", names.join(", "));
        return ExitCode::from(2);
    }
    let done = if at_once { together } else { attack }(seconds, seed, &asked);
    match done {
        Ok(_) => ExitCode::SUCCESS,
        Err(why) => {
            eprintln!("{why}");
            ExitCode::FAILURE
        }
    }
}

/// Those that are asked for, or all where none is.
fn parts(asked: &[&str]) -> Vec<&'static Part> {
    PARTS.iter().filter(|part| asked.is_empty() || asked.contains(&part.name)).collect()
}

/// Each part for the whole time, all at once, with its output in `target/attack`: an hour of each in an hour.
///
/// # Errors
/// Which parts did not survive.
fn together(seconds: u64, seed: u64, asked: &[&str]) -> Result<Done, String> {
    let folder = PathBuf::from("target/attack");
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let own = std::env::current_exe().map_err(|e| format!("this program: {e}"))?;
    let mut running = Vec::new();
    for part in parts(asked) {
        let output = folder.join(part.name).with_extension("txt");
        let told = |e| format!("{}: {e}", output.display());
        let file = std::fs::File::create(&output).map_err(told)?;
        let errors = file.try_clone().map_err(told)?;
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
        let said =
            std::fs::read_to_string(&output).map_err(|e| format!("{}: {e}", output.display()))?;
        println!("-- {name}: {}", if status.success() { "survived" } else { "DID NOT SURVIVE" });
        said.lines().filter(|line| line.contains(" tried") || line.contains("seed ")).for_each(
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

/// One part after the other; the time is shared out evenly.
///
/// # Errors
/// What did not survive.
pub(crate) fn attack(seconds: u64, seed: u64, asked: &[&str]) -> Result<Done, String> {
    let parts = parts(asked);
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
        Kind::Test { package, file, test } => {
            let mut command = cargo(["test", "--quiet", "--package", package, "--test", file]);
            command.args(["--", "--nocapture", "--include-ignored", test]);
            command.env("FENDERLINE_ATTACK_SECONDS", seconds.to_string());
            run(command.env("FENDERLINE_ATTACK_SEED", seed.to_string()))
        }
        Kind::Counted { package, file, tests, counts } => {
            let mut command = cargo(["test", "--quiet", "--package", package, "--test", file]);
            command.args(["--", "--nocapture"]).args(tests);
            for (key, a_second) in counts {
                command.env(key, (a_second * seconds).to_string());
            }
            run(command.env("FENDERLINE_SEED", seed.to_string()))
        }
        // Times are told: other programs may have the processor too.
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

/// By the environment that the tests of the package made.
fn python(seconds: u64, seed: u64) -> Result<(), String> {
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| "target".into(), PathBuf::from);
    let python = target.join("python-package/bin/python");
    if !python.is_file() {
        println!(
            "   not run: the package is not installed; `python3 crates/python/test.py` does it"
        );
        return Ok(());
    }
    let mut pytest = Command::new(python);
    pytest.args(["-B", "-m", "pytest", "-s", "crates/python/tests/test_attack.py"]);
    pytest.env("FENDERLINE_ATTACK_SECONDS", seconds.to_string());
    run(pytest.env("FENDERLINE_ATTACK_SEED", seed.to_string()))
}
