//! `cargo xtask c` tests the C interface by programs in C. The examples and the guide are compiled with all warnings as
//! errors and run under the address and undefined-behaviour sanitizers, and their numbers are compared with
//! `fenderline run`. Then random sequences of calls to the C interface are run.

use std::path::Path;
use std::process::{Child, Command, ExitCode, Stdio};

use crate::built;
use crate::c_build::{Build, SANITIZERS, WARNINGS};
use crate::command::run_quietly;
use crate::guide;
use crate::step::Done;
use crate::tools;
use crate::wrappers;

/// Default number of random sequences of calls.
pub(crate) const SEQUENCES: u64 = 100_000;
/// Sanitizers and valgrind are slow: they run the full number of sequences divided by `SANITIZED_SHARE` and by
/// `VALGRIND_SHARE`.
const SANITIZED_SHARE: u64 = 4;
const VALGRIND_SHARE: u64 = 1000;

/// The scenario whose run the first C example repeats, and the number of its steps.
const SCENARIO: (&str, &str) = ("scenarios/paper/experiment_2_4kn.toml", "200");

/// `cargo xtask c`.
pub(crate) fn c_command(sequences: u64) -> ExitCode {
    let parts: [&dyn Fn() -> Result<Done, String>; 4] =
        [&examples, &wrappers::cpp, &wrappers::csharp, &|| random_calls(sequences)];
    for part in parts {
        match part() {
            Ok(Done::Good) => {}
            Ok(Done::NotRun(missing)) => {
                eprintln!("{} is missing; install: {}", missing.tool, missing.install);
                return ExitCode::FAILURE;
            }
            Err(message) => {
                eprintln!("{message}");
                return ExitCode::FAILURE;
            }
        }
    }
    ExitCode::SUCCESS
}

/// Compiles and runs the C examples and the guide.
pub(crate) fn examples() -> Result<Done, String> {
    if let Err(missing) = tools::c_compiler() {
        return Ok(Done::NotRun(missing));
    }
    let build = Build::new("examples")?;
    let done = examples_in(&build);
    build.remove()?;
    done.map(|()| Done::Good)
}

fn examples_in(build: &Build) -> Result<(), String> {
    let mut cpp = Command::new("c++");
    cpp.args(["-x", "c++", "-std=c++11", "-fsyntax-only"]).args(WARNINGS);
    run_quietly(cpp.arg("include/fenderline.h"))?;
    for example in ["examples/c/ship.c", "examples/c/by_calls.c"] {
        is_also_cpp(Path::new(example))?;
    }
    let ship = build.compile("ship", Path::new("examples/c/ship.c"), &SANITIZERS)?;
    let printed = run_quietly(Command::new(&ship).arg(SCENARIO.0).arg(SCENARIO.1))?;
    let out = build.folder.join("run");
    let mut program = Command::new(built::program("release")?);
    run_quietly(program.args(["run", SCENARIO.0, "--out"]).arg(&out))?;
    let bodies = out.join("bodies.csv");
    let bodies =
        std::fs::read_to_string(&bodies).map_err(|e| format!("{}: {e}", bodies.display()))?;
    let forces = same_forces(&printed, &bodies)?;
    println!(
        "examples/c/ship.c prints {forces} forces and moments with the same bits as `fenderline run`"
    );

    let tug = build.compile("by_calls", Path::new("examples/c/by_calls.c"), &SANITIZERS)?;
    let printed = run_quietly(&mut Command::new(&tug))?;
    // At rest the deflection is thrust over stiffness, and the force is the thrust.
    let rest = printed.lines().last().unwrap_or_default();
    let numbers: Vec<f64> = rest.split(',').filter_map(|cell| cell.parse().ok()).collect();
    let near = |index: usize, right: f64| {
        numbers.get(index).is_some_and(|number| (number / right - 1.0).abs() < 1e-6)
    };
    if !(near(0, 500e3 / 6.5e6) && near(1, 500e3)) {
        return Err(format!(
            "the body of examples/c/by_calls.c does not rest where thrust over stiffness says:\n{printed}"
        ));
    }
    println!("examples/c/by_calls.c: the body rests at thrust over stiffness");

    let text =
        std::fs::read_to_string("docs/guides/c.md").map_err(|e| format!("the guide: {e}"))?;
    let guide = guide::Guide::read(&text, "c")?;
    let source = build.folder.join("guide.c");
    std::fs::write(&source, &guide.program).map_err(|e| format!("{}: {e}", source.display()))?;
    is_also_cpp(&source)?;
    // Both ways of linking in the guide.
    for (name, linking) in [("static", &SANITIZERS[..]), ("shared", &[])] {
        let program = build.compile(name, &source, linking)?;
        // Cargo's own path would find the debug build of the shared library first.
        let printed = run_quietly(Command::new(&program).env_remove("LD_LIBRARY_PATH"))?;
        guide.expects(&printed)?;
    }
    println!(
        "the guide docs/guides/c.md prints the stated output, with the static and the shared library"
    );
    build.exports()
}

/// Checks that C++11 also accepts the program of the guide.
fn is_also_cpp(source: &Path) -> Result<(), String> {
    let mut cpp = Command::new("c++");
    cpp.args(["-x", "c++", "-std=c++11", "-fsyntax-only", "-Iinclude"]).args(WARNINGS);
    run_quietly(cpp.arg(source)).map(|_| ())
}

/// Checks that every force in the table of the example is that of the run's table, bit for bit. Returns their number.
fn same_forces(printed: &str, bodies: &str) -> Result<usize, String> {
    const COLUMNS: [&str; 5] = ["t_s", "body", "force_x_n", "force_y_n", "moment_z_nm"];
    let table = |text: &str| -> Result<Vec<(u64, String, [u64; 3])>, String> {
        let mut lines = text.lines();
        let header: Vec<&str> = lines.next().unwrap_or_default().split(',').collect();
        let place = |name| header.iter().position(|column| *column == name);
        let places: Option<Vec<usize>> = COLUMNS.into_iter().map(place).collect();
        let places = places.ok_or_else(|| format!("columns {header:?}"))?;
        let row = |line: &str| {
            let cells: Vec<&str> = line.split(',').collect();
            let bits =
                |column: usize| Some(cells.get(places[column])?.parse::<f64>().ok()?.to_bits());
            let body = (*cells.get(places[1])?).to_owned();
            Some((bits(0)?, body, [bits(2)?, bits(3)?, bits(4)?]))
        };
        lines.map(|line| row(line).ok_or_else(|| format!("the line `{line}`"))).collect()
    };
    let (ours, run) = (table(printed)?, table(bodies)?);
    if ours.is_empty() || ours.len() > run.len() {
        return Err(format!("the example has {} rows, the run {}", ours.len(), run.len()));
    }
    for (own, other) in ours.iter().zip(&run) {
        if own != other {
            let (t_s, body) = (f64::from_bits(own.0), &own.1);
            return Err(format!(
                "at {t_s} s, the force on {body} in the example is not that of the run"
            ));
        }
    }
    if ours.iter().all(|row| row.2 == [0; 3]) {
        return Err("no body was in contact during the run".to_owned());
    }
    Ok(3 * ours.len())
}

/// Random sequences of calls. A plain build runs all sequences, and a build with sanitizers runs a part of them at the
/// same time. The results of both builds must be the same.
pub(crate) fn random_calls(sequences: u64) -> Result<Done, String> {
    if let Err(missing) = tools::c_compiler() {
        return Ok(Done::NotRun(missing));
    }
    let build = Build::new("calls")?;
    let done = random_calls_in(&build, sequences);
    build.remove()?;
    done.map(|()| Done::Good)
}

fn random_calls_in(build: &Build, sequences: u64) -> Result<(), String> {
    let source = Path::new("crates/capi/fuzz/fuzz.c");
    let plain = build.compile("plain", source, &["-O1"])?;
    let options = [&SANITIZERS[..], &["-O1"]].concat();
    let sanitized = build.compile("sanitized", source, &options)?;
    let all = start(Command::new(&plain).arg(sequences.to_string()))?;
    let part = start(Command::new(&sanitized).arg((sequences / SANITIZED_SHARE).to_string()))?;
    let (all, part) = (end(all)?, end(part)?);
    println!("{}", all.lines().last().unwrap_or_default());
    println!("under sanitizers: {}", part.lines().last().unwrap_or_default());
    let digests = |printed: &str| -> Vec<String> {
        let lines = printed.lines().filter(|line| line.starts_with("digest"));
        lines.map(str::to_owned).collect()
    };
    let (all, part) = (digests(&all), digests(&part));
    if part.iter().zip(&all).any(|(one, other)| one != other) {
        return Err("the same calls gave different results under sanitizers".to_owned());
    }
    if tools::valgrind().is_ok() {
        let some = (sequences / VALGRIND_SHARE).to_string();
        let mut valgrind = Command::new("valgrind");
        valgrind.args(["--quiet", "--error-exitcode=9", "--leak-check=full"]);
        run_quietly(valgrind.arg(&plain).arg(&some))?;
        println!("valgrind has found no invalid read or write and no leak in {some} sequences");
    } else {
        println!("valgrind is not installed: no sequences were run under it");
    }
    Ok(())
}

fn start(command: &mut Command) -> Result<Child, String> {
    let command = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.spawn().map_err(|e| format!("{command:?}: {e}"))
}

fn end(child: Child) -> Result<String, String> {
    let output = child.wait_with_output().map_err(|e| e.to_string())?;
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    if output.status.success() {
        return Ok(printed);
    }
    let complaint = String::from_utf8_lossy(&output.stderr);
    Err(format!("random calls: {}\n{printed}{complaint}", output.status))
}
