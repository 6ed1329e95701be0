//! One table: cases whose state is known, and the verdict on each in terminal, exit code, `summary.json` and report.

mod support;

use support::{BERTH, Workplace, contains_all};

/// A case: its scenario, and what is to be said of it.
struct Case {
    name: &'static str,
    scenario: String,
    key: &'static str,
    gravity: &'static str,
    words: &'static str,
    /// Part of the sentence of the finding.
    sentence: &'static str,
}

/// The berth with the small fender gone, so that the large one alone takes the ship square on.
fn one_large_fender() -> String {
    let small = BERTH.find("[fender.\"small one\"]").expect("the small fender");
    let large = BERTH.find("[fender.large]").expect("the large fender");
    let mut text = BERTH.to_owned();
    text.replace_range(small..large, "");
    // Its panel is high enough for the hull.
    text.replace("position = [-40, 0]", "position = [0, 0]")
        .replace("face_height = \"4 m\"", "face_height = \"8 m\"")
}

/// A moored ship in a wind from the quay.
fn moored(wind_mps: f64, break_load: &str) -> String {
    format!(
        r#"
title = "A ship on two lines"
[time]
step = "0.5 s"
duration = "300 s"
[material.steel]
stiffness = "50 MN/m^2"
shear_stiffness = "10 MN/m"
friction_static = 0.3
friction_dynamic = 0.3
restitution = 0.1
[environment]
wind = {{ speed = "{wind_mps} m/s", from = "90 deg" }}
[vessel.coaster]
length_bp = "120 m"
beam = "18 m"
draught = "6 m"
block_coefficient = 0.7
propeller = {{ diameter = "4 m", full = "150 rpm" }}
rudder = {{ area = "12 m^2", span = "4 m" }}
windage = {{ frontal_area = "250 m^2", lateral_area = "1500 m^2", centroid_height = "8 m", type = "ferry" }}
[body.ship]
vessel = "coaster"
outline = [[-60, -9], [45, -9], [60, 0], [45, 9], [-60, 9]]
position = [0, 0]
[body.quay]
fixed = true
outline = [[-150, 0], [150, 0], [150, 10], [-150, 10]]
position = [0, 14]
[line.fore]
from = "ship"
fairlead = [50, 6]
to = "quay"
bollard = [50, 2]
rope = "hmpe"
break_load = "{break_load}"
pretension = "5 kN"
[line.aft]
from = "ship"
fairlead = [-55, 8]
to = "quay"
bollard = [-55, 2]
rope = "hmpe"
break_load = "{break_load}"
pretension = "5 kN"
[[pair]]
bodies = ["ship", "quay"]
material = "steel"
"#
    )
}

fn cases() -> Vec<Case> {
    let large = one_large_fender();
    let case = |name, scenario, key, gravity, words, sentence| Case {
        name,
        scenario,
        key,
        gravity,
        words,
        sentence,
    };
    vec![
        case("all well", large.clone(), "all_well", "ok", "verdict: all well", ""),
        case(
            "structure struck",
            // Beside the fender nothing keeps the bow off the quay.
            large.replace("position = [0, 0]\nfacing", "position = [-60, 0]\nfacing"),
            "structure_struck",
            "failed",
            "verdict: STRUCTURE STRUCK",
            "struck",
        ),
        case(
            "fender failed",
            BERTH.to_owned(),
            "fender_failed",
            "failed",
            "verdict: FENDER FAILED",
            "Fender small one was compressed",
        ),
        case(
            "fender over its rating",
            large.replace("rated_reaction = \"3500 kN\"", "rated_reaction = \"610 kN\""),
            "fender_over_rated",
            "attention",
            "verdict: FENDER OVER ITS RATING",
            "Fender large: ",
        ),
        case(
            "no fender touched",
            large
                .replace("velocity = { sway = \"0.2 m/s\" }", "velocity = { sway = \"-0.2 m/s\" }")
                .replace("force = [\"0 kN\", \"50 kN\"]", "force = [\"0 kN\", \"0 kN\"]"),
            "no_fender_touched",
            "note",
            "verdict: no fender was touched",
            "No fender was touched",
        ),
        case(
            "start inside the quay",
            large.replace("position = [0, -18.5]", "position = [0, -14]"),
            "structure_struck",
            "failed",
            "verdict: STRUCTURE STRUCK",
            "inside",
        ),
        case(
            "start inside a fender",
            large.replace("position = [0, -18.5]", "position = [0, -15.5]"),
            "start_inside",
            "",
            "",
            "Fender large starts compressed",
        ),
        case(
            "line over its working load",
            moored(20.0, "400 kN"),
            "line_over_working_load",
            "attention",
            "verdict: LINE OVER ITS WORKING LOAD",
            "of its working load",
        ),
        case(
            "line parted",
            moored(20.0, "60 kN"),
            "line_parted",
            "failed",
            "verdict: LINE PARTED",
            " parted at ",
        ),
        case(
            "aground",
            moored(0.0, "2000 kN").replace("[environment]\n", "[environment]\ndepth = \"5.8 m\"\n"),
            "aground",
            "attention",
            "verdict: AGROUND",
            "ship was aground from 0.0 s",
        ),
        case(
            "no rating",
            support::TUG.to_owned(),
            "not_rated",
            "note",
            "verdict: no rating to compare with",
            "quay and tug touched; no permissible load is known for them",
        ),
    ]
}

#[test]
fn the_verdict_on_a_known_case_is_the_same_in_terminal_exit_code_summary_and_report() {
    let place = Workplace::new("verdict");
    for case in cases() {
        place.write("case.toml", case.scenario.as_bytes());
        let run = place.run(&["run", "case.toml", "--out", "case"]);
        let told = format!("{}: {}{}", case.name, run.stdout, run.stderr);
        println!("{told}");
        let summary = place.json("case/summary.json");
        let verdict = &summary["verdict"];
        let findings = verdict["findings"].as_array().expect("findings");
        let checked = place.run(&["check", "case.toml"]);
        let is_reported = checked.stderr.contains(" starts ");
        assert_eq!(is_reported, case.name.starts_with("start inside"), "{told}{}", checked.stderr);
        if case.name == "start inside a fender" {
            // What else the ejected ship does is not known beforehand.
            assert!(findings.iter().any(|finding| finding["key"] == case.key), "{told}");
            assert!(run.stdout.contains(case.sentence), "{told}");
            continue;
        }
        assert_eq!(
            (&verdict["key"], &verdict["gravity"]),
            (&case.key.into(), &case.gravity.into()),
            "{told}"
        );
        assert_eq!(run.code, i32::from(case.gravity == "failed"), "{told}");
        assert!(run.stdout.contains(case.words) && run.stdout.contains(case.sentence), "{told}");
        contains_all(
            &place.text("case/report.html"),
            &[verdict["text"].as_str().expect("a text"), case.sentence],
        );
        assert_eq!(findings.is_empty(), case.key == "all_well", "{told}");
        let allowed = place.run(&["run", "case.toml", "--out", "case", "--allow-failures"]);
        assert_eq!(allowed.code, 0, "{told}");
    }
}
