//! Providers that mean it ill: programs that answer with anything, at any time, or not at all. The run goes on without
//! them or ends with a reason; it is never stopped by them, and no process of theirs outlives it.
#![cfg(unix)]

use crate::attack;

use std::fs;
use std::process::Command;
use std::time::{Duration, Instant};

use attack::{Attack, Draw, Ended, program, watch};

/// What an answer may be, in Python; `n` is the question's number.
const ANSWERS: [&str; 22] = [
    r#"say('{"n": %d, "body_force_n": [1e3, 0], "moment_nm": 0}' % n)"#,
    r#"say('{"n": %d, "body_force_n": [NaN, Infinity], "moment_nm": -0.0}' % n)"#,
    r#"say('{"n": %d, "body_force_n": [1e308, -1e308], "moment_nm": 1e308}' % n)"#,
    r#"say('{"n": %d, "body_force_n": [1], "moment_nm": 0}' % n)"#,
    r#"say('{"n": %d, "body_force_n": null}' % n)"#,
    r#"say('{"n": %d, "body_force_n": [1e3, 0], "moment_nm": 0}' % (n + 1))"#,
    r#"say('{"n": -1, "body_force_n": [1e3, 0], "moment_nm": 0}')"#,
    r#"say('{"n": 1e400}')"#,
    r#"say('[' * 100000)"#,
    r#"say('')"#,
    r#"say('\x1b[2J\u202e{{{')"#,
    r#"out.write(b'\xff\xfe\x00' * 1000); out.flush()"#,
    r#"out.write(b'x' * 3000000); out.flush()"#,
    r#"[say('{"n": %d, "body_force_n": [5e3, 0], "moment_nm": 0}' % n) for _ in range(1000)]"#,
    r#"sys.stderr.write('E' * 300000); sys.stderr.flush()"#,
    r#"time.sleep(0.05)"#,
    r#"time.sleep(600)"#,
    r#"sys.exit(n % 256)"#,
    r#"os.kill(os.getpid(), 9)"#,
    r#"os.close(1); out = open(os.devnull, 'wb')"#,
    r#"os.close(0)"#,
    r#"subprocess.Popen(['sleep', '4711'])"#,
];

/// A provider: now and then something else than a good answer.
fn provider(draw: &mut Draw) -> String {
    let first = *draw.of(&["hear()", "pass", "time.sleep(0.2); hear()", "say('hello?'); hear()"]);
    let [often, seldom, rare] = [draw.of(&ANSWERS), draw.of(&ANSWERS), draw.of(&ANSWERS)];
    let (second, third) = (2 + draw.below(6), 2 + draw.below(12));
    format!(
        r#"
import json, os, subprocess, sys, time
out = sys.stdout.buffer
def hear():
    return sys.stdin.readline()
def say(text):
    out.write(text.encode('utf8', 'replace') + b'\n')
    out.flush()
try:
    {first}
    while True:
        line = hear()
        if not line:
            break
        n = json.loads(line).get('n', 0)
        if n % {second} == 1:
            {seldom}
        elif n % {third} == 2:
            {rare}
        else:
            {often}
except Exception:
    pass
"#
    )
}

fn is_left(folder: &std::path::Path) -> bool {
    // By the folder that it was started in.
    let Ok(all) = fs::read_dir("/proc") else { return false };
    all.flatten()
        .any(|process| fs::read_link(process.path().join("cwd")).is_ok_and(|cwd| cwd == folder))
}

#[test]
fn no_provider_stops_a_run_or_outlives_it() {
    if !Command::new("python3").arg("--version").output().is_ok_and(|o| o.status.success()) {
        assert!(std::env::var_os("CI").is_none(), "python3 is missing in CI");
        println!("skipped: python3 is missing");
        return;
    }
    let folder = std::env::temp_dir().join(format!("fenderline-attack-p-{}", std::process::id()));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    let folder = folder.canonicalize().expect("a folder");
    let mut attack = Attack::begin("providers");
    let mut ended = [0_u32; 3];
    while attack.next_try().is_some() {
        fs::write(folder.join("provider.py"), provider(&mut attack.draw)).expect("written");
        let timeout_ms = 20 + attack.draw.below(300);
        let hold = *attack.draw.of(&["0 s", "1 s", "1000 s"]);
        let case = format!(
            "[time]\nstep = \"0.5 s\"\nduration = \"20 s\"\n\n[body.ship]\n\
             outline = [[-45, -7], [45, -7], [45, 7], [-45, 7]]\nmass = \"4200 t\"\n\
             gyradius = \"22 m\"\nvelocity = {{ surge = \"1 m/s\" }}\n\n[[provider]]\nbody = \"ship\"\n\
             command = [\"python3\", \"provider.py\"]\ntimeout = \"{timeout_ms} ms\"\nhold = \"{hold}\"\n"
        );
        fs::write(folder.join("case.toml"), case).expect("written");
        let _ = fs::remove_dir_all(folder.join("out"));
        let why = attack.here();
        // 41 answers that are waited for, and Python's start.
        let patience = Duration::from_secs(30);
        let run = program(&folder, &["run", "case.toml", "--out", "out"]);
        let Ended::ByItself(output) = watch(run, &folder, patience) else {
            panic!("{why}: the run hangs");
        };
        let told = String::from_utf8_lossy(&output.stderr);
        let code = output.status.code();
        assert!(
            matches!(code, Some(0..=2)) && !told.contains("panicked"),
            "{why}: {:?}: {told}",
            output.status
        );
        ended[code.map_or(0, |code| code as usize)] += 1;
        if code == Some(0) {
            let table = fs::read_to_string(folder.join("out/bodies.csv")).expect("a table");
            assert!(!table.contains("NaN") && !table.contains("inf"), "{why}");
            let summary = fs::read(folder.join("out/summary.json")).expect("a summary");
            let summary: Result<serde_json::Value, _> = serde_json::from_slice(&summary);
            assert!(summary.is_ok(), "{why}");
        }
        // The group of its processes is killed; give the system a moment to end them.
        let gone_by = Instant::now() + Duration::from_secs(3);
        while is_left(&folder) {
            assert!(Instant::now() < gone_by, "{why}: a process of the provider outlives the run");
            std::thread::sleep(Duration::from_millis(10));
        }
    }
    let [done, failed, refused] = ended;
    attack.end(&format!("{done} runs done, {failed} failed with a reason, {refused} refused"));
    let _ = fs::remove_dir_all(&folder);
}
