//! `fenderline campaign`: every combination of values as a table and a figure.

mod support;

use calamine::{Data, DataType as _, Reader as _, Xlsx, open_workbook};
use fenderline_contact::number::greater;
use support::{Workplace, contains_all};

const SCENARIO: &str = include_str!("../../../campaigns/quay.toml");
const CAMPAIGN: &str = include_str!("../../../campaigns/quay_54_cases.toml");

/// A place with the example's files; the runs are short.
fn place(name: &str, campaign: &str) -> Workplace {
    let place = Workplace::new(name);
    place.write(
        "quay.toml",
        SCENARIO.replace("distance = \"3 m\"", "distance = \"2 m\"").as_bytes(),
    );
    place.write("study.toml", campaign.as_bytes());
    place
}

/// The cells of a column.
fn column<'t>(csv: &'t str, name: &str) -> Vec<&'t str> {
    let mut lines = csv.lines();
    let heads: Vec<&str> = lines.next().expect("a header").split(',').collect();
    let at = heads.iter().position(|head| *head == name);
    let at = at.unwrap_or_else(|| panic!("{name} is not in {heads:?}"));
    // The cells before the sentence of a finding have no commas.
    lines.map(|line| line.split(',').nth(at).unwrap_or_default()).collect()
}

#[test]
fn every_combination_is_a_row_and_the_bits_do_not_depend_on_the_threads() {
    let place = place("campaign", CAMPAIGN);
    let run = place.run(&["campaign", "study.toml", "--threads", "1", "--xlsx", "cases.xlsx"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stdout,
        &["54 of 54 cases done", "most used: fender_", "out/study/cases.csv"],
    );
    let csv = place.text("out/study/cases.csv");
    assert_eq!(csv.lines().count(), 55);
    assert_eq!(column(&csv, "case").last(), Some(&"54"));
    // The last variable changes fastest.
    assert_eq!(column(&csv, "spacing [m]")[..4], ["12", "15", "18", "12"]);
    assert_eq!(column(&csv, "draught [m]")[..7], ["6.5", "6.5", "6.5", "9.5", "9.5", "9.5", "6.5"]);
    assert_eq!(column(&csv, "speed [m/s]")[17..19], ["0.08", "0.12"]);
    let threads = place.run(&["campaign", "study.toml", "--threads", "5", "--out", "again"]);
    assert_eq!(threads.code, 0, "{}", threads.stderr);
    assert_eq!(place.text("again/cases.csv"), csv);
    assert_eq!(place.text("again/figure.html"), place.text("out/study/figure.html"));
    let figure = place.text("out/study/figure.html");
    // Three quantities; six charts each for two draughts and three spacings, a line for each angle.
    assert_eq!(figure.matches("<figure").count(), 18);
    contains_all(&figure, &["draught 9.5 m, spacing 18 m", "angle 6 deg", "speed [m/s]", "rated"]);
    assert!(!figure.contains("<link") && !figure.contains("src="), "nothing is loaded");
    let mut book: Xlsx<_> = open_workbook(place.path("cases.xlsx")).expect("a workbook");
    let sheet = book.worksheet_range("Cases").expect("the sheet");
    assert_eq!(sheet.height(), 2 + 54);
    assert_eq!(sheet.get((0, 1)), Some(&Data::String("speed".to_owned())));
    assert_eq!(sheet.get((1, 1)), Some(&Data::String("m/s".to_owned())));
    assert_eq!(sheet.get((55, 1)), Some(&Data::Float(0.18)));
    // A fender that fails does not flatten its chart.
    let heads = sheet.rows().next().expect("heads");
    let share =
        heads.iter().position(|head| head.to_string().replace('_', " ") == "governing share");
    let share = share.expect("the column");
    let shares = sheet.rows().skip(2).map(|row| row[share].get_float().expect("a number"));
    let most = shares.fold(0.0, greater);
    assert!(most > 200.0, "{most}");
    contains_all(&figure, &["Values beyond 200 % are drawn at 200 %"]);
}

/// A case of the table is the same run as that of its command.
#[test]
fn a_case_is_the_run_of_its_command() {
    let place = place("campaign_command", CAMPAIGN);
    assert_eq!(place.run(&["campaign", "study.toml"]).code, 0);
    let command = place.run(&["campaign", "study.toml", "--command", "32"]);
    assert_eq!(command.code, 0, "{}", command.stderr);
    let words: Vec<String> = command
        .stdout
        .trim()
        .split('\'')
        .enumerate()
        .flat_map(|(part, text)| match part % 2 {
            0 => text.split_whitespace().map(str::to_owned).collect::<Vec<_>>(),
            _ => vec![text.to_owned()],
        })
        .collect();
    let words: Vec<&str> = words.iter().map(String::as_str).collect();
    assert_eq!(words[..3], ["fenderline", "run", "quay.toml"]);
    let run = place.run(&[&words[1..], &["--allow-failures"]].concat());
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary: serde_json::Value =
        serde_json::from_str(&place.text("out/case_32/summary.json")).expect("JSON");
    let fenders = summary["fenders"].as_array().expect("a list");
    let peak_j = fenders.iter().filter_map(|fender| fender["peak_energy_j"].as_f64());
    let peak_kj = peak_j.max_by(f64::total_cmp).expect("a fender was touched") * 1e-3;
    let csv = place.text("out/study/cases.csv");
    let verdict = column(&csv, "verdict")[31];
    assert_eq!(summary["verdict"]["key"], verdict);
    let line = csv.lines().nth(32).expect("a row");
    assert!(line.contains(&format!(",{peak_kj},")), "{peak_kj} is not in {line}");
}

#[test]
fn a_case_that_cannot_run_is_a_row_with_its_error() {
    let few = r#"scenario = "quay.toml"
[variable.distance]
key = "body.ship.approach.distance"
values = ["2 m", "0.1 m"]
[variable.angle]
key = "body.ship.approach.angle"
values = ["0 deg", "6 deg"]
"#;
    let place = place("campaign_error", few);
    let run = place.run(&["campaign", "study.toml"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    contains_all(&run.stderr, &["1 case did not run", "case 4 did not run", "starts inside"]);
    let csv = place.text("out/study/cases.csv");
    assert_eq!(column(&csv, "verdict")[3], "error");
    assert!(csv.lines().nth(4).expect("a row").contains("starts inside"), "{csv}");
    assert_eq!(csv.lines().count(), 5);
}

#[test]
fn mistakes_in_a_campaign_say_what_was_expected() {
    let good = "scenario = \"quay.toml\"\n[variable.speed]\nkey = \"body.ship.approach.speed_normal\"\nvalues = [\"0.1 m/s\"]\n";
    let place = place("campaign_bad", good);
    let refused = |part: &str, mistake: &str, more: &[&str], fragments: &[&str]| {
        assert!(good.contains(part), "{part}");
        place.write("bad.toml", good.replacen(part, mistake, 1).as_bytes());
        let run = place.run(&[&["campaign", "bad.toml"], more].concat());
        assert_eq!(run.code, 2, "{mistake}: {}", run.stderr);
        contains_all(&run.stderr, fragments);
        assert!(!place.path("out/bad").exists(), "{mistake}");
    };
    refused("speed_normal", "sped_normal", &[], &["did you mean `speed_normal`?", "no case"]);
    refused("0.1 m/s", "0.1 kN", &[], &["must be a speed", "no case of the campaign can be run"]);
    refused("[\"0.1 m/s\"]", "[]", &[], &["bad.toml:4", "`variable.speed.values` is empty"]);
    refused("[\"0.1 m/s\"]", "\"0.1 m/s\"", &[], &["bad.toml:4", "must be a list of numbers"]);
    refused("[\"0.1 m/s\"]", "[1, 1]", &[], &["has \"1\" twice"]);
    refused("values = [\"0.1 m/s\"]\n", "", &[], &["`variable.speed.values` is missing", "choice"]);
    refused("values", "value", &[], &["did you mean `values`?"]);
    refused("quay.toml", "kway.toml", &[], &["cannot read", "kway.toml"]);
    refused("[variable.speed]", "[variables.speed]", &[], &["did you mean `variable`?"]);
    refused("", "set = [\"time.step\"]\n", &[], &["bad.toml:1", "there is no `=`", "KEY=VALUE"]);
    refused("", "", &["--x", "angle"], &["--x angle: the variables are speed"]);
    refused("", "", &["--command", "2"], &["there is no case 2", "from 1 to 1"]);
    refused("", "", &["--threads", "0"], &["--threads"]);
    let both = "values = [\"0.1 m/s\"]\n[variable.speed.choice.a]\nset = [\"time.step=1\"]\n";
    refused("values = [\"0.1 m/s\"]\n", both, &[], &["does not go together with `choice`"]);
}
