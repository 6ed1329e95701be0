//! The table `verdict/cases.json`: cases whose state is known, and the verdict on each in terminal, exit code,
//! `summary.json`, report and the frames of the live pages. `crates/python/tests/test_verdict.py` reads the same table.

use crate::support;

use std::path::{Path, PathBuf};

use fenderline_live::message::RunState;
use fenderline_live::{Session, Source};
use fenderline_sim::Law;
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
    /// The law that the run leaves, where the finding is of one.
    law: Option<String>,
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
            law: case.get("law").map(|_| field("law")),
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
        let beside = |name: &str| {
            std::fs::read_to_string(folder().join(name)).map_err(|error| error.to_string())
        };
        let (source, _) =
            Source::collect("case.toml", text, self.set.clone(), beside).expect("a good scenario");
        let mut session = Session::open(source).expect("a session");
        while session.tick() < ticks {
            session.step().expect("a step");
        }
        let frame = session.frame(0, RunState::default());
        serde_json::to_value(frame.verdict).expect("JSON")
    }

    /// A campaign of one case, this one; `duration_s` is that of its scenario.
    fn campaign(&self, duration_s: f64) -> String {
        let scenario = self.scenario.to_str().expect("a path in UTF-8");
        format!(
            "title = \"One case\"\nscenario = {scenario:?}\nset = {:?}\n\n[variable.duration]\nkey = \"time.duration\"\nvalues = [\"{duration_s} s\"]\n",
            self.set
        )
    }
}

/// The sentences of a list of findings.
fn sentences(findings: &Value) -> Vec<&str> {
    let all = findings.as_array().expect("findings").iter();
    all.map(|finding| finding["text"].as_str().expect("a text")).collect()
}

fn found_of(verdict: &Value) -> impl Iterator<Item = &Value> {
    verdict["findings"].as_array().expect("findings").iter()
}

/// A sentence as a report has it: keys between backticks are code.
fn in_html(sentence: &str) -> String {
    let escaped = sentence.replace('&', "&amp;").replace('<', "&lt;").replace('"', "&quot;");
    let parts = escaped.split('`').enumerate().map(|(index, part)| match index % 2 {
        0 => part.to_owned(),
        _ => format!("<code>{part}</code>"),
    });
    parts.collect()
}

/// The most findings that a report lists.
const SHOWN_IN_A_REPORT: usize = 8;
/// Files of long waves must reach to the end of the run, but a live session can go on after it; only the commands of the program start
/// providers (`provider.rs`).
const NOT_IN_THE_TABLE: [Law; 2] = [Law::LongWavesHeld, Law::ProviderSilent];

#[test]
fn every_law_that_a_run_can_leave_has_a_case() {
    let cases = cases();
    for row in Law::TABLE {
        let has_case = cases.iter().any(|case| case.law.as_deref() == Some(row.key));
        assert_eq!(has_case, !NOT_IN_THE_TABLE.contains(&row.law), "{}", row.key);
    }
}

#[test]
fn the_guide_has_the_table_of_laws() {
    let guide = include_str!("../../../docs/start/engineer.md");
    for row in Law::TABLE {
        let verdict = row.verdict.text();
        let line = format!("  | `{}` | {} | {} | {verdict} |\n", row.key, row.when, row.then);
        assert!(guide.contains(&line), "not in the guide: {line}");
    }
}

#[test]
fn a_session_that_goes_on_after_its_long_waves_says_so() {
    let case = Case {
        name: "long waves end".to_owned(),
        scenario: folder().join("drifting.toml"),
        set: vec![
            "environment.depth=30 m".to_owned(),
            "environment.long_waves={ file = \"long_waves.csv\" }".to_owned(),
        ],
        is_worst: true,
        law: None,
        key: String::new(),
        gravity: String::new(),
        text: String::new(),
        sentence: String::new(),
    };
    assert_eq!(case.on_pages(20)["key"], "all_well");
    let after = case.on_pages(40);
    assert_eq!(after["key"], "outside_data");
    contains_all(
        sentences(&after["findings"])[0],
        &["long waves", "from 10.5 s for 9.5 s (48 % of the run)"],
    );
}

#[test]
fn strict_refuses_a_result_outside_its_data() {
    let place = Workplace::new("verdict_strict");
    let all = cases();
    let of = |law: &str| all.iter().find(|case| case.law.as_deref() == Some(law)).expect(law);
    let run = |law: &str, more: &[&str]| {
        let case = of(law);
        place.run(&[&case.command("run")[..], &["--out", "case"], more].concat())
    };
    assert_eq!(run("wind_held", &[]).code, 0);
    let refused = run("wind_held", &["--strict"]);
    assert_eq!(refused.code, 1, "{}", refused.stderr);
    contains_all(&refused.stderr, &["outside the range of its data", "the results are complete"]);
    assert_eq!(run("wind_held", &["--strict", "--allow-failures"]).code, 0);
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

        let has_finding = found_of(verdict).any(|finding| finding["key"] == *case.key);
        assert_eq!(has_finding, case.key != "all_well", "{told}");
        assert!(
            findings.is_empty() || findings.iter().any(|f| f.contains(&case.sentence)),
            "{told}"
        );
        if let Some(law) = &case.law {
            let mut of_law = found_of(verdict).filter(|finding| finding["law"] == **law);
            let finding = of_law.next().unwrap_or_else(|| panic!("{told}{summary:#}"));
            assert_eq!(finding["key"], *case.key, "{told}");
            let share = finding["share_of_run"].as_f64().expect("a share");
            assert!(share > 0.0 && share <= 1.0, "{told}");
            let text = finding["text"].as_str().expect("a text");
            assert!(text.ends_with(" of the run)") || text.ends_with(" whole run"), "{told}");
        }
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
        // A report has the worst findings and says how many more there are.
        for finding in findings.iter().take(SHOWN_IN_A_REPORT) {
            contains_all(&report, &[&in_html(finding)]);
        }

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

        // Campaigns.
        if case.law.is_some() {
            let duration_s = summary["duration_s"].as_f64().expect("a duration");
            place.write("study.toml", case.campaign(duration_s).as_bytes());
            let run = place.run(&["campaign", "study.toml", "--out", "study", "--replace"]);
            let table = place.text("study/cases.csv");
            assert_eq!(run.code, 0, "{told}{}{}", run.stdout, run.stderr);
            let key = verdict["key"].as_str().expect("a key");
            contains_all(&table, &[&format!(",{key},"), &findings[0].replace('"', "\"\"")]);
        }

        let allowed = [&case.command("run")[..], &["--out", "case", "--allow-failures"]].concat();
        assert_eq!(place.run(&allowed).code, 0, "{told}");
    }
}
