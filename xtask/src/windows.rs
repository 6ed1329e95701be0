//! `cargo xtask windows [PROFILE]` runs the program, an FMU and the C library for Windows under Wine, beside those for
//! Linux. Everything that the Windows and the Linux programs compute and write must be the same to the bit.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};

use crate::command::{cargo, run, run_quietly};
use crate::compare::same_bytes;
use crate::program::{self, copy_stripped};
use crate::same_bits::add_target;
use crate::step::{Done, Step, run_all};
use crate::tools;
use crate::virtual_environment::target_folder;
use crate::wine;

const TRIPLE: &str = "x86_64-pc-windows-gnu";
const NAME: &str = "Windows: program, FMU and C library under Wine";

/// Scenarios that the programs for Windows and Linux both run.
const SCENARIOS: [&str; 3] = [
    "scenarios/paper/experiment_2_4kn.toml",
    "scenarios/berth/eight_cones_at_5_deg.toml",
    "scenarios/berth/alongside_with_two_tugs.toml",
];
/// The scenario of the FMUs, the communication step (s) and the number of steps.
const FMU: (&str, &str, &str) = ("scenarios/berth/eight_cones_at_5_deg.toml", "0.1", "300");
/// The scenario of the C example and the number of its steps.
const EXAMPLE: [&str; 2] = ["scenarios/paper/experiment_2_4kn.toml", "200"];

/// `cargo xtask windows`.
pub(crate) fn windows_command(profile: &str) -> ExitCode {
    run_all(&[if profile == "dev" {
        Step { name: NAME, run: || windows("dev") }
    } else {
        Step { name: NAME, run: || windows("release") }
    }])
}

fn windows(profile: &str) -> Result<Done, String> {
    wine::find()?;
    add_target(TRIPLE)?;
    let folder = target_folder().join("windows");
    let built = Built::new(profile, &folder)?;
    let results = folder.join("results");
    if results.exists() {
        std::fs::remove_dir_all(&results).map_err(|e| format!("{}: {e}", results.display()))?;
    }
    std::fs::create_dir_all(&results).map_err(|e| format!("{}: {e}", results.display()))?;
    for scenario in SCENARIOS {
        runs(&built, &results, scenario)?;
    }
    for scenario in SCENARIOS {
        run_quietly(wine::command(&built.windows)?.args(["check", scenario]))?;
    }
    println!("fenderline.exe check: {} scenarios are good", SCENARIOS.len());
    validation(&built, &results)?;
    fmus(&built, &results)?;
    example(profile, &folder)?;
    Ok(Done::Good)
}

/// The programs for Windows and Linux, each with the FMU libraries for both systems.
struct Built {
    linux: PathBuf,
    windows: PathBuf,
}

impl Built {
    fn new(profile: &str, folder: &Path) -> Result<Built, String> {
        let libraries = folder.join("fmu-libraries");
        let (target, subfolder) =
            (target_folder(), if profile == "dev" { "debug" } else { profile });
        let (linux, windows) = (target.join(subfolder), target.join(TRIPLE).join(subfolder));
        let build = ["build", "--quiet", "--profile", profile, "--package"];
        run(cargo(build).arg("fenderline-fmu"))?;
        let for_windows = ["fenderline-fmu", "--package", "fenderline-capi", "--target", TRIPLE];
        run(cargo(build).args(for_windows))?;
        for (strip, from, place) in [
            ("strip", linux.join("libfenderline_fmu.so"), "x86_64-linux/libfenderline_fmu.so"),
            (
                "x86_64-w64-mingw32-strip",
                windows.join("fenderline_fmu.dll"),
                "x86_64-windows/fenderline_fmu.dll",
            ),
        ] {
            copy_stripped(strip, &from, &libraries.join(place))?;
        }
        for target in [&[][..], &["--target", TRIPLE]] {
            let mut program = cargo(build);
            run(program.arg("fenderline").args(target).env(program::LIBRARIES, &libraries))?;
        }
        let own = folder.join("fenderline");
        copy_stripped("strip", &linux.join("fenderline"), &own)?;
        let exe = folder.join("fenderline.exe");
        copy_stripped("x86_64-w64-mingw32-strip", &windows.join("fenderline.exe"), &exe)?;
        Ok(Built { linux: own, windows: exe })
    }
}

/// Lets both programs run the scenario, and checks that all of their files are the same.
fn runs(built: &Built, results: &Path, scenario: &str) -> Result<(), String> {
    let name = Path::new(scenario).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    let (here, there) =
        (results.join(format!("{name}_linux")), results.join(format!("{name}_windows")));
    // A verdict of the run makes the exit code 1.
    let play = |mut program: Command, out: &Path| {
        program.args(["run", scenario, "--allow-failures", "--out"]).arg(relative(out));
        run_quietly(&mut program)
    };
    play(Command::new(&built.linux), &here)?;
    play(wine::command(&built.windows)?, &there)?;
    // Windows does not remove a file that is open, so the lock of the folder stays.
    let lock = there.join(".fenderline.lock");
    std::fs::remove_file(&lock).map_err(|e| format!("{}: {e}", lock.display()))?;
    same_bytes(&here, &there)?;
    println!("fenderline.exe run {scenario}: all files are the same as on Linux");
    Ok(())
}

/// A path relative to the present folder, which both systems understand.
fn relative(path: &Path) -> &Path {
    let Ok(current) = std::env::current_dir() else { return path };
    path.strip_prefix(current).unwrap_or(path)
}

fn validation(built: &Built, results: &Path) -> Result<(), String> {
    let (here, there) = (results.join("validation_linux"), results.join("validation_windows"));
    run_quietly(Command::new(&built.linux).args(["validate", "--out"]).arg(relative(&here)))?;
    let mut validate = wine::command(&built.windows)?;
    run_quietly(validate.args(["validate", "--out"]).arg(relative(&there)))?;
    same_bytes(&here, &there)?;
    println!(
        "fenderline.exe validate: all cases pass, and pages and tables are the same as on Linux"
    );
    Ok(())
}

/// Lets both programs write an FMU with the libraries of both systems, and checks that the files in the FMUs are the
/// same. A master then steps the library of each system.
fn fmus(built: &Built, results: &Path) -> Result<(), String> {
    let (scenario, step_s, steps) = FMU;
    let python = tools::python().map_err(|missing| format!("{} is missing", missing.tool))?;
    let write = |mut program: Command, name: &str| {
        // One name of the model in both.
        let folder = results.join(name);
        std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        let file = folder.join("ship.fmu");
        program.args(["fmu", scenario, "--kind", "simulation", "-o"]).arg(relative(&file));
        let printed = run_quietly(&mut program)?;
        for platform in ["x86_64-linux", "x86_64-windows"] {
            if !printed.contains(platform) {
                return Err(format!("the FMU has no library for {platform}:\n{printed}"));
            }
        }
        let unpacked = folder.join("unpacked");
        run_quietly(Command::new(python).args(["-m", "zipfile", "-e"]).arg(&file).arg(&unpacked))?;
        Ok(unpacked)
    };
    let here = write(Command::new(&built.linux), "fmu_linux")?;
    let there = write(wine::command(&built.windows)?, "fmu_windows")?;
    for folder in ["resources", "binaries/linux64", "binaries/win64"] {
        same_bytes(&here.join(folder), &there.join(folder))?;
    }
    let description = |unpacked: &Path| {
        let file = unpacked.join("modelDescription.xml");
        std::fs::read_to_string(&file).map_err(|e| format!("{}: {e}", file.display()))
    };
    let (description, other) = (description(&here)?, description(&there)?);
    if description != other {
        return Err("the model descriptions of the two FMUs differ".into());
    }
    let guid = attribute(&description, "guid").ok_or("the model description has no guid")?;
    let references: Vec<&str> = description
        .split("<ScalarVariable ")
        .skip(1)
        .filter(|variable| variable.contains("causality=\"output\"") && variable.contains("<Real"))
        .filter_map(|variable| attribute(variable, "valueReference"))
        .collect();
    let absolute =
        |path: &Path| std::path::absolute(path).map_err(|e| format!("{}: {e}", path.display()));
    let arguments = |library: &Path, uri: String| {
        let mut all = vec![relative(library).display().to_string(), uri];
        all.extend([guid, step_s, steps].map(str::to_owned));
        all.extend(references.iter().map(|reference| (*reference).to_owned()));
        all
    };
    let source = Path::new("crates/fmu/hosts/master.c");
    let options = ["-std=c99", "-O1", "-Wall", "-Wextra", "-Werror", "-o"];
    let (master, master_exe) = (results.join("master"), results.join("master.exe"));
    run_quietly(Command::new("cc").args(options).arg(&master).arg(source).arg("-ldl"))?;
    let mut compile = Command::new("x86_64-w64-mingw32-gcc");
    run_quietly(compile.args(options).arg(&master_exe).arg(source))?;
    let resources = absolute(&there.join("resources"))?;
    let mut own = Command::new(&master);
    let uri = format!("file://{}", resources.display());
    let library = absolute(&there.join("binaries/linux64/ship.so"))?;
    let mut linux = arguments(&library, uri);
    // The system looks for a name without a folder elsewhere.
    linux[0] = library.display().to_string();
    let linux = run_quietly(own.args(linux))?;
    let mut wine = wine::command(&master_exe)?;
    // Wine's drive Z is the root folder.
    let uri = format!("file:///Z:{}", resources.display());
    let windows = run_quietly(wine.args(arguments(&there.join("binaries/win64/ship.dll"), uri)))?;
    compare_lines(&linux, &windows, steps.parse().unwrap_or(0))?;
    println!(
        "the FMU that fenderline.exe wrote gave {} outputs of win64 and linux64 in {steps} steps, with the same bits",
        references.len()
    );
    Ok(())
}

/// The value of an XML attribute.
fn attribute<'t>(text: &'t str, name: &str) -> Option<&'t str> {
    text.split_once(&format!("{name}=\""))?.1.split_once('"').map(|(value, _)| value)
}

/// Checks that two texts have the same lines, but for the line ends of Windows.
fn compare_lines(linux: &str, windows: &str, least: usize) -> Result<(), String> {
    let (linux, windows): (Vec<&str>, Vec<&str>) =
        (linux.lines().collect(), windows.lines().collect());
    if linux.len() < least || linux != windows {
        let same = linux.iter().zip(&windows).take_while(|(a, b)| a == b).count();
        return Err(format!(
            "{} lines on Linux, {} on Windows, the first {same} are the same",
            linux.len(),
            windows.len()
        ));
    }
    Ok(())
}

/// Runs the C example, linked with the DLL for Windows and with the library for Linux.
fn example(profile: &str, folder: &Path) -> Result<(), String> {
    let subfolder = if profile == "dev" { "debug" } else { profile };
    let built = target_folder().join(TRIPLE).join(subfolder);
    let exe = folder.join("ship.exe");
    let mut compile = Command::new("x86_64-w64-mingw32-gcc");
    compile.args(["-std=c99", "-Wall", "-Wextra", "-Werror", "-Iinclude", "examples/c/ship.c"]);
    run_quietly(compile.arg("-L").arg(&built).arg("-l:libfenderline.dll.a").arg("-o").arg(&exe))?;
    copy_stripped(
        "x86_64-w64-mingw32-strip",
        &built.join("fenderline.dll"),
        &folder.join("fenderline.dll"),
    )?;
    let windows = run_quietly(wine::command(&exe)?.args(EXAMPLE))?;

    run(&mut cargo(["build", "--quiet", "--profile", profile, "--package", "fenderline-capi"]))?;
    let library = target_folder().join(subfolder).join("libfenderline.a");
    let ship = folder.join("ship");
    let mut compile = Command::new("cc");
    compile.args(["-std=c99", "-Iinclude", "examples/c/ship.c"]).arg(library);
    run_quietly(compile.args(["-lpthread", "-ldl", "-lm", "-o"]).arg(&ship))?;
    let linux = run_quietly(Command::new(&ship).args(EXAMPLE))?;
    compare_lines(&linux, &windows, 100)?;
    println!(
        "examples/c/ship.c with fenderline.dll: {} lines, those of Linux",
        linux.lines().count()
    );
    Ok(())
}
