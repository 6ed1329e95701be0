//! The table `verdict/cases.json`: cases whose state is known, and the verdict on each in terminal, exit code,
//! `summary.json`, report and the frames of the live pages. `crates/python/tests/test_verdict.py` reads the same table.

use crate::support;

use std::path::{Path, PathBuf};

use fenderline_live::message::RunState;
use fenderline_live::{Session, Source};
use serde_json::Value;
use support::{Workplace, contains_all};

/// A case: its scenario, and the verdict on it.
struct Case {
    name: String,
    scenario: PathBuf,
    /// Overrides, as `KEY=VALUE`.
    set: Vec<String>,
    /// The verdict is that of the finding.
    is_worst: bool,
    key: String,
    gravity: String,
    text: String,
    /// Part of the sentence of the finding.
    sentence: String,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/verdict")
}

fn cases() -> Vec<Case> {
    let text = std::fs::read_to_string(folder().join("cases.json")).expect("the table");
    let table: Value = serde_json::from_str(&text).expect("JSON");
    let all = table["cases"].as_array().expect("cases").iter();
    let case = |case: &Value| {
        let field = |name: &str| case[name].as_str().expect(name).to_owned();
        let set = case["set"].as_object().expect("overrides").iter();
        Case {
            name: field("name"),
            scenario: folder().join(field("scenario")),
            set: set.map(|(key, value)| format!("{key}={}", value.as_str().expect(key))).collect(),
            is_worst: case.get("is_worst").is_none_or(|is| is == true),
            key: field("key"),
            gravity: field("gravity"),
            text: field("text"),
            sentence: field("sentence"),
        }
    };
    all.map(case).collect()
}

impl Case {
    /// The command `name` on this scenario.
    fn command<'a>(&'a self, name: &'a str) -> Vec<&'a str> {
        let scenario = self.scenario.to_str().expect("a path in UTF-8");
        let set = self.set.iter().flat_map(|set| ["--set", set]);
        [name, scenario].into_iter().chain(set).collect()
    }

    /// The verdict in the frame that live pages get after `ticks` steps.
    fn on_pages(&self, ticks: u64) -> Value {
        let text = std::fs::read_to_string(&self.scenario).expect("a scenario");
        let none = |name: &str| Err(format!("{name} is not expected"));
        let (source, _) =
            Source::collect("case.toml", text, self.set.clone(), none).expect("a good scenario");
        let mut session = Session::open(source).expect("a session");
        while session.tick() < ticks {
            session.step().expect("a step");
        }
        let frame = session.frame(0, RunState::default());
        serde_json::to_value(frame.verdict).expect("JSON")
    }
}

/// The sentences of a list of findings.
fn sentences(findings: &Value) -> Vec<&str> {
    let all = findings.as_array().expect("findings").iter();
    all.map(|finding| finding["text"].as_str().expect("a text")).collect()
}

#[test]
fn the_verdict_on_a_known_case_is_the_same_everywhere() {
    let place = Workplace::new("verdict");
    for case in cases() {
        let run = place.run(&[&case.command("run")[..], &["--out", "case"]].concat());
        let told = format!("{}: {}{}", case.name, run.stdout, run.stderr);
        let summary = place.json("case/summary.json");
        let verdict = &summary["verdict"];
        let findings = sentences(&verdict["findings"]);

        let found = verdict["findings"].as_array().expect("findings").iter();
        let has_finding = found.into_iter().any(|finding| finding["key"] == *case.key);
        assert_eq!(has_finding, case.key != "all_well", "{told}");
        assert!(
            findings.is_empty() || findings.iter().any(|f| f.contains(&case.sentence)),
            "{told}"
        );
        if case.is_worst {
            let ours = [&verdict["key"], &verdict["gravity"], &verdict["text"]];
            assert_eq!(ours, [&case.key, &case.gravity, &case.text], "{told}");
        }

        // Exit code and terminal.
        let is_failed = verdict["gravity"] == "failed";
        assert_eq!(run.code, i32::from(is_failed), "{told}");
        let words = verdict["text"].as_str().expect("a text");
        let is_grave = is_failed || verdict["gravity"] == "attention";
        let printed = if is_grave { words.to_uppercase() } else { words.to_owned() };
        assert!(run.stdout.contains(&format!("verdict: {printed}\n")), "{told}");
        contains_all(&run.stdout, &findings);

        // Report.
        let report = place.text("case/report.html");
        contains_all(&report, &[words]);
        contains_all(&report, &findings);

        // Live pages.
        let on_pages = case.on_pages(summary["steps"].as_u64().expect("steps"));
        for field in ["key", "gravity", "text"] {
            assert_eq!(on_pages[field], verdict[field], "{told}");
        }
        assert_eq!(sentences(&on_pages["findings"]), findings, "{told}");

        // Before the run only a bad start is known.
        let checked = place.run(&case.command("check"));
        let is_reported = checked.stderr.contains(" starts ");
        assert_eq!(is_reported, case.name.starts_with("start inside"), "{told}{}", checked.stderr);

        let allowed = [&case.command("run")[..], &["--out", "case", "--allow-failures"]].concat();
        assert_eq!(place.run(&allowed).code, 0, "{told}");
    }
}
