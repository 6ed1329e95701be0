//! Files that a user names, or that lie in the folder of results, and that are none to be read or written: pipes,
//! devices, folders, links.
#![cfg(unix)]

use crate::support;

use std::process::Command;

use support::{TUG, Workplace, contains_all};

/// A workplace with a pipe in it that nobody writes.
fn with_pipe(name: &str) -> Workplace {
    let place = Workplace::new(name);
    let made = Command::new("mkfifo").arg(place.path("pipe")).status().expect("mkfifo");
    assert!(made.success());
    place
}

/// Runs the program for at most ten seconds: a shell's code 124 is one that hangs.
fn run(place: &Workplace, args: &str) -> support::Run {
    place.shell(&format!("exec timeout -k 1 10 \"$FENDERLINE\" {args}"))
}

#[test]
fn a_pipe_or_a_device_does_not_hang_any_command_that_reads_a_file() {
    let place = with_pipe("pipes");
    let current = "\n[environment.current]\nfile = \"pipe\"\n";
    place.write("current.toml", format!("{TUG}{current}").as_bytes());
    let none = "\n[environment.current]\nfile = \"none.csv\"\n";
    place.write("none.toml", format!("{TUG}{none}").as_bytes());
    place.write("fenders.toml", format!("fender_files = [\"pipe\"]\n{TUG}").as_bytes());
    place.write("vessels.toml", format!("vessel_files = [\"pipe\"]\n{TUG}").as_bytes());
    for command in [
        "check pipe",
        "run pipe",
        "run /dev/stdin < pipe",
        "check current.toml",
        "run current.toml",
        "check none.toml --set environment.current.file=pipe",
        "run none.toml --set environment.current.file=pipe",
        "check fenders.toml",
        "check vessels.toml",
        "check tug.toml --set 'fender_files=[\"pipe\"]'",
        "fender fit pipe --out fitted.toml --height 1",
        "manoeuvre kcs --file pipe",
        "vessels --file pipe",
        "fmu pipe --kind engine --out x.fmu",
        "serve pipe --port 0",
        "replay pipe",
    ] {
        // The shell waits for a writer where it opens the pipe itself.
        let command = command.replace("< pipe", "0<> pipe");
        let told = run(&place, &command);
        assert_eq!(told.code, 2, "{command}: {}{}", told.stdout, told.stderr);
        contains_all(&told.stderr, &["it is a pipe, and only regular files are read"]);
    }
    for device in ["/dev/zero", "/dev/null", "/dev/full"] {
        let told = run(&place, &format!("check {device}"));
        assert_eq!(told.code, 2, "{device}: {}", told.stderr);
        contains_all(&told.stderr, &[device, "it is a device"]);
    }
}

#[test]
fn a_pipe_or_a_link_in_the_folder_of_results_is_neither_waited_for_nor_overwritten() {
    for name in
        ["summary.json.part", "bodies.csv.part", "bodies.csv", "summary.json", ".fenderline.lock"]
    {
        let place = with_pipe("odd_results");
        place.write("precious.txt", b"precious");
        place.write("out/tug/energy.csv", b"of an earlier run");
        for (line, what) in [
            (format!("ln -s ../../precious.txt out/tug/{name}"), "a symbolic link"),
            (format!("ln -s ../../none.txt out/tug/{name}"), "a symbolic link"),
            (format!("mkfifo out/tug/{name}"), "a pipe"),
            (format!("mkdir out/tug/{name}"), "a folder"),
        ] {
            assert_eq!(place.shell(&line).code, 0);
            let told = run(&place, "run tug.toml");
            assert_eq!(told.code, 2, "{line}: {}", told.stderr);
            contains_all(&told.stderr, &[&format!("out/tug/{name}: the path is {what}")]);
            assert_eq!(place.text("precious.txt"), "precious", "{line}");
            assert!(!place.exists("none.txt"), "{line}");
            assert_eq!(place.text("out/tug/energy.csv"), "of an earlier run", "{line}");
            assert_eq!(place.files("out/tug"), {
                let mut left = vec!["energy.csv".to_owned(), name.to_owned()];
                left.sort();
                left
            });
            assert_eq!(place.shell(&format!("rm -r out/tug/{name}")).code, 0);
        }
    }
}

#[test]
fn a_link_or_a_pipe_where_one_file_is_written_is_left_alone() {
    let place = with_pipe("odd_single");
    place.write("precious.txt", b"precious");
    let curve = "deflection_mm,reaction_kn\n100,40\n200,80\n300,100\n400,150\n";
    place.write("curve.csv", curve.as_bytes());
    for name in ["fitted.toml", "fitted.toml.part"] {
        for line in [format!("ln -s precious.txt {name}"), format!("mkfifo {name}")] {
            assert_eq!(place.shell(&line).code, 0);
            let told = run(&place, "fender fit curve.csv --out fitted.toml --height 1");
            assert_eq!(told.code, 2, "{line}: {}", told.stderr);
            contains_all(&told.stderr, &[name, "which fenderline does not replace"]);
            assert_eq!(place.text("precious.txt"), "precious", "{line}");
            assert_eq!(place.shell(&format!("rm {name}")).code, 0);
        }
    }
    let told = run(&place, "fender fit curve.csv --out fitted.toml --height 1");
    assert_eq!(told.code, 0, "{}", told.stderr);
    assert!(place.exists("fitted.toml") && !place.exists("fitted.toml.part"));
}

#[test]
fn a_folder_for_results_that_cannot_be_one_is_bad_input() {
    let place = Workplace::new("bad_out");
    place.write("occupied", b"a file where the results should go");
    for command in [
        "run tug.toml --out occupied",
        "run tug.toml --out occupied/below",
        "run tug.toml --out /dev/null",
        "run tug.toml --out /proc/none",
        "run tug.toml --out ''",
        "manoeuvre kcs crabbing --out occupied",
    ] {
        let told = run(&place, command);
        assert_eq!(told.code, 2, "{command}: {}", told.stderr);
        contains_all(&told.stderr, &["error: "]);
    }
    assert_eq!(place.text("occupied"), "a file where the results should go");
}

/// Runs a script in a mount namespace of its own, with `small` a file system in memory with these options; `None` where
/// that is not permitted.
#[cfg(target_os = "linux")]
fn with_small_disk(place: &Workplace, options: &str, script: &str) -> Option<support::Run> {
    let map = if place.shell("id -u").stdout.trim() == "0" { "" } else { "--user --map-root-user" };
    let namespace = format!("unshare {map} --mount");
    if place.shell(&format!("{namespace} mount -t tmpfs none .")).code != 0 {
        println!("skipped: mount namespaces are not permitted here");
        return None;
    }
    let mount = format!("mkdir -p small && mount -t tmpfs -o {options} none small");
    Some(place.shell(&format!("{namespace} bash -c '{mount} && {script}'")))
}

/// Commands that write, by what they write into `small`.
#[cfg(target_os = "linux")]
const WRITERS: [&str; 9] = [
    "run tug.toml --out small/run",
    "run tug.toml --out small/run --format parquet",
    "report tug.toml --html small/r.html",
    "report tug.toml --xlsx small/r.xlsx",
    "campaign many.toml --out small/study",
    "fmu tug.toml --kind engine -o small/x.fmu",
    "init tugs -o small/x.toml",
    "man --out small/man",
    "manoeuvre kcs turning --out small/tracks",
];

#[cfg(target_os = "linux")]
fn with_study(name: &str) -> Workplace {
    let place = Workplace::new(name);
    let study =
        "scenario = \"tug.toml\"\n[variable.step]\nkey = \"time.step\"\nvalues = [0.1, 0.2]\n";
    place.write("many.toml", study.as_bytes());
    place
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_leaves_no_file_under_its_final_name() {
    let place = with_study("full_disk");
    for command in WRITERS {
        // One page of 4 KiB: folders fit, and no larger file as a whole.
        let script = format!(
            "\"$FENDERLINE\" {command}; code=$?; find small -type f ! -size 0 ! -name \"*.part\"; exit $code"
        );
        let Some(run) = with_small_disk(&place, "size=4k", &script) else { return };
        assert_eq!(run.code, 1, "{command}: {}{}", run.stdout, run.stderr);
        contains_all(&run.stderr, &["error: cannot write", "No space left on device"]);
        // Small files of several: those that fitted are whole.
        // A campaign goes on from its journal.
        let whole = |name: &str| {
            [".1", "cases.csv", "campaign.json", "rows.journal"]
                .iter()
                .any(|end| name.ends_with(end))
        };
        let left: Vec<&str> = run.stdout.lines().filter(|name| !whole(name)).collect();
        assert!(!left.iter().any(|name| name.starts_with("small/")), "{command}: {left:?}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_read_only_folder_is_refused_before_the_run() {
    let place = with_study("read_only");
    for command in WRITERS {
        let script = format!("mount -o remount,ro small && \"$FENDERLINE\" {command}");
        let Some(run) = with_small_disk(&place, "size=1m", &script) else { return };
        assert_eq!(run.code, 2, "{command}: {}{}", run.stdout, run.stderr);
        contains_all(&run.stderr, &["error: cannot write small/", "Read-only file system"]);
    }
}
