//! Many runs started at once into one folder, on a file system that is slow: one writes it, the others say so.
//!
//! `FENDERLINE_ROUNDS=1000 cargo test -p fenderline --test all one_folder:: -- --nocapture` tries a thousand times, and
//! prints what came out; without the variable it is a few times.
#![cfg(target_os = "linux")]

use crate::support;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use support::{PROGRAM, Workplace, contains_all, limited};

/// Runs that are started at once.
const RUNS: usize = 8;
/// Rounds where nobody asks for more.
const ROUNDS: u64 = 5;
/// Longest wait before and after a call to the file system (µs).
const LONGEST_WAIT_US: u64 = 8000;
/// The last of the runs comes this long after the first at most (µs): about as long as one takes, so that the others
/// meet it at its beginning, at work and at its end.
const SPREAD_US: u64 = 300_000;
/// A round that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(50);

/// The slow file system as a shared library; `None` if there is no C compiler. Continuous integration must have one.
fn slow_files(place: &Workplace) -> Option<PathBuf> {
    let library = place.path("slow_files.so");
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/support/slow_files.c");
    let compiled = Command::new("cc")
        .args(["-shared", "-fPIC", "-O1", "-Wall", "-Werror", "-o"])
        .args([&library, &source])
        .arg("-ldl")
        .output();
    match compiled {
        Ok(output) => {
            let told = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{told}");
            Some(library)
        }
        Err(why) => {
            assert!(std::env::var_os("CI").is_none(), "no C compiler in CI: {why}");
            println!("skipped: no C compiler: {why}");
            None
        }
    }
}

/// What run `index` is to do: each has other results than the others, in every file.
fn arguments(index: usize, out: &str) -> Vec<String> {
    let title = format!("title=\"run {index}\"");
    let duration = format!("{}", 3 + index);
    ["run", "tug.toml", "--out", out, "--set", &title, "--duration", &duration]
        .map(str::to_owned)
        .to_vec()
}

/// Name and content of every file in a folder.
fn contents(place: &Workplace, folder: &str) -> Vec<(String, Vec<u8>)> {
    let names = place.files(folder).into_iter();
    names.map(|name| (name.clone(), place.read(&format!("{folder}/{name}")))).collect()
}

/// Waits until `wanted` of the runs have ended, and hands back the exit code of each that has.
fn ended(runs: &mut [Child], wanted: usize) -> Vec<Option<i32>> {
    let start = Instant::now();
    loop {
        let codes: Vec<Option<i32>> = runs
            .iter_mut()
            .map(|run| {
                run.try_wait().expect("it can be waited for").map(|s| s.code().unwrap_or(-1))
            })
            .collect();
        if codes.iter().flatten().count() >= wanted || start.elapsed() > PATIENCE {
            return codes;
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn one_of_eight_runs_at_once_writes_the_folder_and_seven_are_refused() {
    let place = Workplace::new("one_folder");
    let Some(library) = slow_files(&place) else { return };
    let whole: Vec<_> = (0..RUNS)
        .map(|index| {
            let out = format!("alone-{index}");
            let arguments = arguments(index, &out);
            let run = place.run(&arguments.iter().map(String::as_str).collect::<Vec<_>>());
            assert_eq!(run.code, 0, "{}", run.stderr);
            contents(&place, &out)
        })
        .collect();
    let rounds = std::env::var("FENDERLINE_ROUNDS")
        .map_or(ROUNDS, |text| text.parse().expect("FENDERLINE_ROUNDS is a number"));
    let began = Instant::now();
    let (mut refused, mut wins) = (0, [0; RUNS]);
    for round in 0..rounds {
        // Every other round finds the results of the last: they are whole until they are gone.
        if round % 2 == 0 {
            let _ = fs::remove_dir_all(place.path("out"));
        }
        let (start, end) = (place.path("start"), place.path("end"));
        let _ = (fs::remove_file(&start), fs::remove_file(&end));
        let mut runs: Vec<Child> = (0..RUNS)
            .map(|index| {
                Command::new(PROGRAM)
                    .args(arguments(index, "out"))
                    .current_dir(place.path("."))
                    .env("LD_PRELOAD", &library)
                    .env("SLOW_FILES_SEED", (round * 100 + index as u64).to_string())
                    .env("SLOW_FILES_US", LONGEST_WAIT_US.to_string())
                    .env("SLOW_FILES_SPREAD_US", SPREAD_US.to_string())
                    .env("SLOW_FILES_START", &start)
                    .env("SLOW_FILES_END", &end)
                    .stdout(Stdio::null())
                    .stderr(Stdio::piped())
                    .spawn()
                    .expect("the program starts")
            })
            .collect();
        fs::write(&start, b"").expect("written");
        let before = ended(&mut runs, RUNS - 1);
        fs::write(&end, b"").expect("written");
        let codes = ended(&mut runs, RUNS);
        for run in &mut runs {
            let _ = run.kill();
        }
        let told: Vec<String> = runs
            .into_iter()
            .map(|run| limited::output_of(run).stderr)
            .map(|bytes| String::from_utf8_lossy(&bytes).into_owned())
            .collect();
        let told_of = || format!("round {round}: {before:?}, then {codes:?}\n{}", told.join("\n"));
        let winners: Vec<usize> = (0..RUNS).filter(|i| codes[*i] == Some(0)).collect();
        let [winner] = winners[..] else { panic!("{} runs wrote: {}", winners.len(), told_of()) };
        for index in (0..RUNS).filter(|index| *index != winner) {
            assert_eq!(codes[index], Some(2), "{}", told_of());
            contains_all(&told[index], &["another run is writing to this folder"]);
            refused += 1;
        }
        let written = contents(&place, "out");
        let names: Vec<&String> = written.iter().map(|(name, _)| name).collect();
        assert!(
            written == whole[winner],
            "not the files of run {winner}: {names:?}, {}",
            told_of()
        );
        wins[winner] += 1;
    }
    println!(
        "{rounds} rounds of {RUNS} runs at once in {:.0} s: each time one whole set of files, {refused} runs refused with \
         exit code 2; sets written by each run: {wins:?}",
        began.elapsed().as_secs_f64()
    );
}

#[test]
fn a_folder_that_cannot_be_made_durable_keeps_no_result() {
    let place = Workplace::new("not_durable");
    let Some(library) = slow_files(&place) else { return };
    // The folder's sync fails once its first result has its name, and once its last has.
    for name in ["bodies.csv", "summary.json"] {
        let run = place.shell(&format!(
            "LD_PRELOAD='{}' SLOW_FILES_FAIL_SYNC={name} \"$FENDERLINE\" run tug.toml",
            library.display()
        ));
        assert_eq!(run.code, 1, "{name}: {}", run.stderr);
        contains_all(&run.stderr, &["cannot write out/tug", "power cut, so all were removed"]);
        assert_eq!(place.files("out/tug"), Vec::<String>::new(), "{name}");
    }
}
