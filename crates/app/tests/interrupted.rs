//! A run that its user interrupts, and the processes of its providers when it ends.
#![cfg(target_os = "linux")]

use crate::support;

use std::fs;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use support::{PROGRAM, TUG, Workplace, contains_all, limited};

/// A provider that starts a process of its own, which writes its number to `grandchild` and sleeps. It answers each
/// question after a while (s).
fn provider(wait_s: f64, ends_itself: bool) -> String {
    let end = if ends_itself { "" } else { "time.sleep(1000)" };
    format!(
        r#"
import json, signal, subprocess, sys, time
signal.signal(signal.SIGTERM, signal.SIG_IGN)
other = subprocess.Popen(["sleep", "1000"], stdout=subprocess.DEVNULL, stdin=subprocess.DEVNULL)
open("new", "w").write(str(other.pid))
__import__("os").rename("new", "grandchild")
sys.stdin.readline()
for line in sys.stdin:
    time.sleep({wait_s})
    print(json.dumps({{"n": json.loads(line)["n"], "body_force_n": [0, 0], "moment_nm": 0}}), flush=True)
{end}
"#
    )
}

fn with_provider(name: &str, program: &str) -> Option<Workplace> {
    let found = Command::new("python3").arg("--version").output().is_ok_and(|o| o.status.success());
    if !found {
        assert!(std::env::var_os("CI").is_none(), "python3 is missing in CI");
        println!("skipped: python3 is missing");
        return None;
    }
    let place = Workplace::new(name);
    place.write("provider.py", program.as_bytes());
    let scenario = format!(
        "{TUG}\n[[provider]]\nbody = \"tug\"\ncommand = [\"python3\", \"provider.py\"]\ntimeout = \"100 s\"\n"
    );
    place.write("case.toml", scenario.as_bytes());
    Some(place)
}

/// Whether a process is at work: one that has ended may stay in the table where nobody asks for it.
fn is_at_work(number: &str) -> bool {
    let stat = fs::read_to_string(format!("/proc/{number}/stat")).unwrap_or_default();
    stat.rsplit(')').next().is_some_and(|rest| !rest.is_empty() && !rest.trim().starts_with('Z'))
}

fn is_soon(what: impl Fn() -> bool) -> bool {
    let start = Instant::now();
    while !what() {
        if start.elapsed() > Duration::from_secs(20) {
            return false;
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    true
}

/// Starts the program with SIGINT as a terminal has it: a shell may have it ignored in what it runs in the background.
fn start(place: &Workplace, args: &[&str]) -> Child {
    Command::new("env")
        .args(["--default-signal=INT", PROGRAM])
        .args(args)
        .current_dir(place.path("."))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .expect("env of the GNU core utilities starts the program")
}

fn send(child: &Child, signal: &str) {
    let sent = Command::new("kill").args([signal, &child.id().to_string()]).status().expect("kill");
    assert!(sent.success());
}

/// Exit code, standard output and standard error, once it has ended.
fn outcome(child: Child) -> (Option<i32>, String, String) {
    let output = limited::output_of(child);
    let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
    (output.status.code(), text(&output.stdout), text(&output.stderr))
}

#[test]
fn an_interrupted_run_leaves_its_results_so_far_marked_as_such() {
    let place = Workplace::new("interrupted");
    let long = ["run", "tug.toml", "--step", "1e-4", "--duration", "100000", "--interval", "0.1"];
    let child = start(&place, &long);
    place.wait_for("out/tug/bodies.csv.part");
    send(&child, "-INT");
    let (code, out, told) = outcome(child);
    assert_eq!(code, Some(130), "{told}");
    contains_all(&told, &["interrupted: the results so far are written"]);
    contains_all(
        &out,
        &["INTERRUPTED: stopped by the user after ", " of 1000000000 steps", "summary.json"],
    );
    assert_eq!(place.files("out/tug"), ["bodies.csv", "energy.csv", "report.html", "summary.json"]);
    let summary = place.json("out/tug/summary.json");
    assert_eq!(summary["interrupted"], true);
    let steps = summary["steps"].as_u64().expect("steps");
    assert!(0 < steps && steps < 1_000_000_000, "{steps}");
    // Two bodies a row, which stands for 1000 of the 1e9 steps: the tables end where the summary says.
    let rows = 2 * steps.div_ceil(1000);
    assert_eq!(place.text("out/tug/bodies.csv").lines().count() as u64, 1 + rows);
    contains_all(
        &place.text("out/tug/report.html"),
        &["<strong>Interrupted: </strong>", "of 100000 s"],
    );
    // A run to the end says that it is none.
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    assert_eq!(place.json("out/tug/summary.json")["interrupted"], false);
    assert!(!place.text("out/tug/report.html").contains("Interrupted"));
}

#[test]
fn an_interrupted_campaign_keeps_the_rows_so_far() {
    let place = Workplace::new("interrupted_campaign");
    place.write("quay.toml", include_bytes!("../../../campaigns/quay.toml"));
    let gyradii: Vec<String> = (0..20_000).map(|number| format!("{}", 40_000 + number)).collect();
    let many = format!(
        "scenario = \"quay.toml\"\n[variable.gyradius]\nkey = \"body.ship.gyradius\"\nvalues = [\"{} mm\"]\n",
        gyradii.join(" mm\", \"")
    );
    place.write("many.toml", many.as_bytes());
    let child = start(&place, &["campaign", "many.toml"]);
    place.wait_for("out/many");
    std::thread::sleep(std::time::Duration::from_secs(1));
    send(&child, "-INT");
    let (code, out, told) = outcome(child);
    assert_eq!(code, Some(130), "{told}");
    contains_all(&out, &["of 20000 cases done", "out/many/cases.csv"]);
    let csv = place.text("out/many/cases.csv");
    let rows: Vec<&str> = csv.lines().skip(1).collect();
    assert!(!rows.is_empty() && rows.len() < 20_000, "{} rows", rows.len());
    let numbers: Vec<usize> =
        rows.iter().map(|row| row.split(',').next().unwrap().parse().unwrap()).collect();
    assert!(numbers.is_sorted());
    let files = ["campaign.json", "cases.csv", "cases.parquet", "figure.html", "rows.journal"];
    assert!(files.iter().all(|file| place.exists(&format!("out/many/{file}"))));
}

#[test]
fn a_second_interrupt_ends_at_once_and_leaves_no_process_of_a_provider() {
    let Some(place) = with_provider("interrupted_twice", &provider(60.0, false)) else { return };
    for (signals, code) in [(&["-INT", "-INT"][..], 130), (&["-TERM"], 143)] {
        let _ = fs::remove_file(place.path("grandchild"));
        let child = start(&place, &["run", "case.toml"]);
        place.wait_for("grandchild");
        let grandchild = place.text("grandchild");
        assert!(is_at_work(&grandchild));
        let start = Instant::now();
        for signal in signals {
            send(&child, signal);
            std::thread::sleep(Duration::from_millis(300));
        }
        let (ended, _, told) = outcome(child);
        assert_eq!(ended, Some(code), "{told}");
        assert!(start.elapsed() < Duration::from_secs(20), "{:?}", start.elapsed());
        assert!(is_soon(|| !is_at_work(&grandchild)), "{signals:?}: {grandchild} is still there");
        assert!(!place.exists("out/case/summary.json"));
    }
}

#[test]
fn processes_of_a_provider_do_not_outlive_the_run() {
    for (name, ends_itself) in [("grandchild_of_good", true), ("grandchild_of_stubborn", false)] {
        let Some(place) = with_provider(name, &provider(0.0, ends_itself)) else { return };
        let run = place.run(&["run", "case.toml"]);
        assert_eq!(run.code, 0, "{}", run.stderr);
        let grandchild = place.text("grandchild");
        assert!(is_soon(|| !is_at_work(&grandchild)), "{name}: {grandchild} is still there");
    }
}
