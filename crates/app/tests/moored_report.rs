//! The report of a moored ship: what a mooring engineer hands to a client.

use crate::support;

use std::path::Path;

use support::{Workplace, contains_all};

/// The report of a scenario in the folder of this crate, with overrides.
fn report(place: &Workplace, scenario: &str, set: &[&str]) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(scenario);
    let path = path.to_str().expect("a path in UTF-8");
    let set = set.iter().flat_map(|set| ["--set", set]);
    let args: Vec<&str> =
        ["run", path, "--allow-failures", "--out", "out"].into_iter().chain(set).collect();
    let run = place.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    place.text("out/report.html")
}

/// Eleven minutes of the worked terminal, of which one counts.
#[test]
fn the_worked_terminal_has_motions_limits_lines_and_what_is_not_covered() {
    let place = Workplace::new("worked_terminal");
    let page = report(
        &place,
        "../../scenarios/terminal/moored_at_the_terminal.toml",
        &["time.duration=\"11 min\""],
    );
    contains_all(
        &page,
        &[
            "FL-EX-024",
            "Example Port Authority",
            "Motion nearest to its limit",
            "with gusts",
            "the fastest of a table",
            "mean period",
            "Motions and limits",
            "surge of ship, largest range",
            "Zero-crossing period",
            "A peak is the largest distance from the mean between two crossings",
            "ship moves in six degrees of freedom by her hydrodynamic data (",
            "With hydrodynamic data (ship): motion in six degrees of freedom",
            "Surge, ahead of the place at the start, ship",
            "Tension of the lines, 3 of 3",
            "Above the chart: break load 1200 kN, working load 600 kN.",
            "Cycles of the lines",
            "passing.kcs",
        ],
    );
    assert!(!page.contains("NO HYDRODYNAMIC DATA") && !page.contains("Thruster bow"));
}

#[test]
fn a_ship_without_hydrodynamic_data_says_so() {
    let place = Workplace::new("no_hydrodynamic_data");
    let page = report(&place, "tests/verdict/moored.toml", &["statistics={ from = \"10 s\" }"]);
    contains_all(
        &page,
        &[
            "NO HYDRODYNAMIC DATA",
            "Heave, roll and pitch of ship are oscillators",
            "Without hydrodynamic data (ship):",
        ],
    );
}
