//! Files that mean it ill: scenarios, vessels and fenders with something changed at random, and names of things that are
//! no files. Whatever it is, the program ends by itself with one of its own exit codes, and says what was wrong.

use crate::attack;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::time::Duration;

use attack::{Attack, Draw, Ended, program, watch};

/// Longer than any check of a scenario in the repository takes, in a build for tests on a busy machine.
const PATIENCE: Duration = Duration::from_secs(20);
/// A run goes on for so long before it is interrupted.
const RUN: Duration = Duration::from_secs(2);

/// Values that hardly fit where they are put.
const VALUES: [&str; 34] = [
    "0",
    "-0.0",
    "-1",
    "1e308",
    "-1e308",
    "5e-324",
    "1e400",
    "nan",
    "inf",
    "-inf",
    "9223372036854775807",
    "true",
    "\"\"",
    "\"0 m\"",
    "\"-5 kn\"",
    "\"1e308 m\"",
    "\"300 degC\"",
    "\"5 furlongs\"",
    "\"\\u202e\"",
    "\"quay\"",
    "\"../../../etc/passwd\"",
    "\"/dev/zero\"",
    "[]",
    "[[]]",
    "[0, 0]",
    "[nan, 1]",
    "{}",
    "{ file = \"pipe\" }",
    "{ file = \"/dev/zero\", column = \"a\" }",
    "[[1, 2], [3, 4], [1, 2]]",
    "[[0, 0], [1, 1], [1, 0], [0, 1]]",
    "1979-05-27",
    "\"a\\nb\"",
    "'''x'''",
];

fn files_under(folder: &str) -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let mut found = Vec::new();
    let mut folders = vec![root];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "toml") {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// One change of a text.
fn change(bytes: &mut Vec<u8>, draw: &mut Draw, other: &[u8]) {
    let lines: Vec<(usize, usize)> = {
        let mut start = 0;
        bytes
            .split_inclusive(|&byte| byte == b'\n')
            .map(|line| {
                let from = start;
                start += line.len();
                (from, start)
            })
            .collect()
    };
    if lines.is_empty() {
        return;
    }
    let (from, to) = *draw.of(&lines);
    match draw.below(11) {
        // A value of a line.
        0..=3 => {
            let line = &bytes[from..to];
            if let Some(equals) = line.iter().position(|&byte| byte == b'=') {
                let value = format!("= {}\n", draw.of(&VALUES));
                bytes.splice(from + equals..to, value.bytes());
            }
        }
        4 => drop(bytes.drain(from..to)),
        5 => {
            let line = bytes[from..to].to_vec();
            let (at, _) = *draw.of(&lines);
            bytes.splice(at..at, line);
        }
        6 => {
            let at = draw.below(bytes.len());
            bytes[at] ^= 1 << draw.below(8);
        }
        7 => bytes.truncate(draw.below(bytes.len())),
        // A part of another file.
        8 => {
            let start = draw.below(other.len().max(1)).min(other.len());
            let end = (start + draw.below(400)).min(other.len());
            bytes.splice(from..from, other[start..end].iter().copied());
        }
        // Digits.
        9 => {
            for byte in &mut bytes[from..to] {
                if byte.is_ascii_digit() && draw.below(2) == 0 {
                    *byte = b'0' + draw.below(10) as u8;
                }
            }
        }
        // Brackets within brackets.
        _ => {
            let depth = 1 + draw.below(5000);
            let tower = format!("x = {}{}\n", "[".repeat(depth), "]".repeat(draw.below(depth + 1)));
            bytes.splice(from..from, tower.bytes());
        }
    }
}

struct Place(PathBuf);

impl Place {
    fn new(name: &str) -> Place {
        let folder = std::env::temp_dir().join(format!("fenderline-{name}-{}", std::process::id()));
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).expect("a folder");
        Place(folder)
    }
}

impl Drop for Place {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

/// Ends by itself, with one of `codes`, without a panic, and with words where it refuses.
fn ends_well(
    place: &Path,
    arguments: &[&str],
    patience: Duration,
    codes: &[i32],
    why: &str,
) -> i32 {
    let Ended::ByItself(output) = watch(program(place, arguments), place, patience) else {
        panic!("{why}: `{arguments:?}` hangs");
    };
    let told = String::from_utf8_lossy(&output.stderr);
    let code = output.status.code();
    assert!(
        code.is_some_and(|code| codes.contains(&code)) && !told.contains("panicked"),
        "{why}: `{arguments:?}` ends with {:?}: {told}",
        output.status
    );
    // What a person reads writes nothing to the terminal that the terminal obeys.
    let obeyed = |c: char| {
        c.is_control() && c != '\n' && c != '\t' || ('\u{202a}'..='\u{202e}').contains(&c)
    };
    let printed = String::from_utf8_lossy(&output.stdout).into_owned() + &told;
    assert!(!printed.contains(obeyed), "{why}: `{arguments:?}` prints {printed:?}");
    assert!(code == Some(0) || code == Some(130) || !told.trim().is_empty(), "{why}: says nothing");
    code.unwrap_or(-1)
}

#[test]
fn a_changed_scenario_is_refused_or_runs() {
    let place = Place::new("attack-files");
    let mut attack = Attack::begin("files");
    let all: Vec<Vec<u8>> =
        files_under("scenarios").iter().map(|path| fs::read(path).expect("a file")).collect();
    // What scenarios read beside themselves.
    for folder in ["scenarios/environment", "scenarios/live"] {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
        for entry in fs::read_dir(folder).expect("a folder") {
            let path = entry.expect("an entry").path();
            if path.extension().is_some_and(|ending| ending == "csv") {
                fs::copy(&path, place.0.join(path.file_name().expect("a name"))).expect("copied");
            }
        }
    }
    Command::new("mkfifo").arg(place.0.join("pipe")).status().expect("a pipe");
    let (mut refused, mut run) = (0, 0);
    while let Some(number) = attack.next_try() {
        let mut bytes = attack.draw.of(&all).clone();
        let other = attack.draw.of(&all).clone();
        for _ in 0..=attack.draw.below(4) {
            change(&mut bytes, &mut attack.draw, &other);
        }
        fs::write(place.0.join("case.toml"), &bytes).expect("written");
        let why = attack.here();
        if ends_well(&place.0, &["check", "case.toml"], PATIENCE, &[0, 2], &why) == 2 {
            refused += 1;
        } else if number.is_multiple_of(8) {
            run += 1;
            let _ = fs::remove_dir_all(place.0.join("out"));
            let run = ["run", "case.toml", "--out", "out", "--set", "time.duration=\"20 s\""];
            ends_well(&place.0, &run, RUN, &[0, 1, 2, 130], &why);
        }
    }
    attack.end(&format!("{refused} refused, {run} run"));
}

#[test]
fn paths_without_a_regular_file_are_refused_at_once() {
    let place = Place::new("attack-odd");
    let mut attack = Attack::begin("odd files");
    let name = |name: &str| place.0.join(name);
    Command::new("mkfifo").arg(name("pipe")).status().expect("a pipe");
    fs::create_dir_all(name("folder")).expect("a folder");
    fs::write(name("empty"), "").expect("a file");
    fs::write(name("noise"), (0..=255).cycle().take(5000).collect::<Vec<u8>>()).expect("a file");
    fs::File::create(name("huge")).and_then(|file| file.set_len(1 << 40)).expect("a sparse file");
    std::os::unix::fs::symlink("loop", name("loop")).expect("a link");
    std::os::unix::fs::symlink("/dev/zero", name("to_zero")).expect("a link");
    let _socket = std::os::unix::net::UnixListener::bind(name("socket")).expect("a socket");
    let odd = [
        "pipe",
        "folder",
        "empty",
        "noise",
        "huge",
        "loop",
        "to_zero",
        "socket",
        "/dev/zero",
        "/dev/random",
        "/dev/stdin",
        "/dev/null",
        "/proc/self/mem",
        "/proc/kmsg",
        "none",
        "",
        "\u{202e}",
        "none/../pipe",
    ];
    let good = files_under("scenarios/berth");
    let good = good.first().expect("a scenario").to_string_lossy();
    while attack.next_try().is_some() {
        let odd = *attack.draw.of(&odd);
        let (fender, wind) =
            (format!("fender_files=[{odd:?}]"), format!("environment.wind={{ file = {odd:?} }}"));
        let commands: [&[&str]; 11] = [
            &["check", odd],
            &["run", odd],
            &["check", &good, "--set", &fender],
            &["run", &good, "--set", &wind],
            &["replay", odd],
            &["fender", "fit", odd, "-o", "fit.toml", "--height", "1", "--length", "1"],
            &["vessels", "--file", odd],
            &["manoeuvre", "kvlcc2", "turning", "--file", odd],
            &["fmu", odd, "--kind", "engine", "-o", "x.fmu"],
            &["serve", odd, "--port", "0"],
            &["run", &good, "--out", "huge", "--duration", "1"],
        ];
        let command = *attack.draw.of(&commands);
        let why = attack.here();
        // Empty files of vessels may be good; nothing else is.
        ends_well(&place.0, command, PATIENCE, &[0, 1, 2], &why);
    }
    attack.end("pipes, devices, folders, links, sockets in every place for a file");
}
