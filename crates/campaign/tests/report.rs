//! The report of a campaign, from a table in a file.

use crate::support;

use std::path::PathBuf;

fn written(name: &str, text: &str) -> PathBuf {
    let path =
        std::env::temp_dir().join(format!("fenderline-report-{}-{name}", std::process::id()));
    std::fs::write(&path, text).unwrap();
    path
}

#[test]
fn a_report_has_each_of_its_parts_once() {
    let path = written("runs.csv", &support::table(2000));
    let page = support::report(&path).unwrap();
    assert_eq!(page, support::report(&path).unwrap(), "the same table gives the same bytes");
    let headings = [
        "Verdicts",
        "Energy",
        "Reaction",
        "Hull pressure",
        "Beside the formula",
        "The worst runs",
        "Convergence",
        "Sensitivity",
        "Operability",
        "Inputs",
        "How it was computed",
    ];
    for heading in headings {
        assert_eq!(page.matches(&format!("<h2>{heading}</h2>")).count(), 1, "{heading}");
    }
    for fragment in [
        "2 runs could not be made",
        "fenderline campaign replay",
        "not stated",
        "post_panamax",
        "Inputs in words have no rank: ship",
        "beyond the data",
        "the designer must judge whether they meet a guideline",
    ] {
        assert!(page.contains(fragment), "{fragment}");
    }
    assert!(!page.contains("NaN") && !page.contains("inf "), "numbers that are none");
    std::fs::remove_file(path).unwrap();
}

#[test]
fn a_table_without_verdicts_winds_or_formula_gives_a_shorter_report() {
    let rows: String =
        (1..100).map(|i| format!("{},{},a,1,1,{i},{i},{i}\n", i * 7 % 100, i * 3 % 50)).collect();
    let heads = "speed,angle,ship,wind_speed,wind_direction,energy,reaction,hull_pressure\n";
    let path = written("short.csv", &format!("{heads}{rows}"));
    let page = support::report(&path).unwrap();
    assert!(page.contains("The table has no columns `verdict` and `gravity`."));
    assert!(
        !page.contains("<h2>Operability</h2>") && !page.contains("<h2>Beside the formula</h2>")
    );
    let path_of_missing = written("missing.csv", "speed,energy\n1,2\n3,4\n");
    let error = support::report(&path_of_missing).unwrap_err().to_string();
    assert!(error.contains("no column `reaction`"), "{error}");
    std::fs::remove_file(path).unwrap();
    std::fs::remove_file(path_of_missing).unwrap();
}

/// Columns of which some output has no value at all, as hull pressure where no panel has one.
#[test]
fn an_output_without_values_says_so() {
    let table = support::table(300);
    let lines: Vec<String> = table
        .lines()
        .enumerate()
        .map(|(line, text)| {
            let mut cells: Vec<&str> = text.split(',').collect();
            if line > 0 {
                cells[9] = "";
            }
            cells.join(",")
        })
        .collect();
    let path = written("empty.csv", &lines.join("\n"));
    let page = support::report(&path).unwrap();
    assert!(
        page.contains("at least 2 values are needed, but there are 0"),
        "no word about the empty column"
    );
    std::fs::remove_file(path).unwrap();
}
