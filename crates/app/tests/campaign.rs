//! `fenderline campaign`: many runs as a table and a figure, shared, interrupted and replayed.

use crate::support;

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
        &["54 of 54 cases done", "most used fender: fender_", "out/study/cases.csv"],
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
    refused(
        "values = [\"0.1 m/s\"]\n",
        both,
        &[],
        &["does not go together", "`values` and `choice`"],
    );
}

/// A random campaign of the example's scenario.
const RANDOM: &str = r#"
scenario = "quay.toml"
number = 60
seed = 7
outputs = ["fender.fender_3.reaction", "body.ship.largest_yaw"]

[variable.speed]
key = "body.ship.approach.speed_normal"
distribution = "lognormal"
mean = "7.1 cm/s"
standard_deviation = "4.47 cm/s"
at_most = "40 cm/s"

[variable.angle]
key = "body.ship.approach.angle"
distribution = "triangular"
lower = "-5 deg"
mode = "0 deg"
upper = "5 deg"

[variable.doubled]
expression = "2 * speed"
unit = "cm/s"

[variable.ship.choice."9 m"]
weight = 3
set = ["body.ship.mass=30000 t", "berthing.draught=6.5 m", "berthing.under_keel_clearance=6 m"]

[variable.ship.choice."12 m"]
set = ["body.ship.mass=45000 t"]

[[correlation]]
variables = ["speed", "angle"]
coefficient = 0.3

[output.margin]
expression = "930 - reaction"
unit = "kN"
"#;

const TABLES: [&str; 2] = ["cases.csv", "cases.parquet"];

fn bytes(place: &Workplace, folder: &str) -> Vec<Vec<u8>> {
    TABLES.map(|name| std::fs::read(place.path(&format!("{folder}/{name}"))).expect(name)).to_vec()
}

#[test]
fn shares_and_threads_give_the_same_bytes() {
    let place = place("campaign_shares", RANDOM);
    let run = place.run(&["campaign", "study.toml", "--threads", "1"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let whole = bytes(&place, "out/study");
    let csv = place.text("out/study/cases.csv");
    for (speed, doubled) in column(&csv, "speed [cm/s]").iter().zip(column(&csv, "doubled [cm/s]"))
    {
        let (speed, doubled): (f64, f64) = (speed.parse().unwrap(), doubled.parse().unwrap());
        assert!(doubled == 2.0 * speed && speed <= 40.0, "{speed} {doubled}");
    }
    assert_eq!(place.run(&["campaign", "study.toml", "--threads", "3", "--out", "three"]).code, 0);
    assert_eq!(bytes(&place, "three"), whole);
    let report = place.text("out/study/report.html");
    contains_all(
        &report,
        &["60 runs of quay.toml", "fenderline campaign replay study.toml", "lognormal, median"],
    );
    assert!(!report.contains("<link") && !report.contains("src="), "nothing is loaded");
    assert_eq!(place.text("three/report.html"), report);
    let book = place.run(&["campaign", "study.toml", "--replace", "--xlsx", "cases.xlsx"]);
    assert_eq!(book.code, 0, "{}", book.stderr);
    let mut workbook: Xlsx<_> = open_workbook(place.path("cases.xlsx")).expect("a workbook");
    assert_eq!(workbook.worksheet_range("Cases").expect("the sheet").height(), 2 + 60);
    assert_eq!(bytes(&place, "out/study"), whole);
    for share in ["1/3", "3/3", "2/3"] {
        let run = place.run(&["campaign", "study.toml", "--shard", share]);
        assert_eq!(run.code, 0, "{}", run.stderr);
    }
    let shares = [1, 2, 3].map(|number| format!("out/study/shard_{number}_of_3"));
    let merge = |parts: &[&str]| {
        place.run(&[&["campaign", "merge", "study.toml"], parts, &["--out", "merged"]].concat())
    };
    let two = merge(&[&shares[2], &shares[0]]);
    assert_eq!(two.code, 2);
    contains_all(&two.stderr, &["shards are missing: 2 of 3"]);
    let twice = merge(&[&shares[0], &shares[0]]);
    contains_all(&twice.stderr, &["shard 1/3 is also in"]);
    let all = merge(&[&shares[2], &shares[0], &shares[1]]);
    assert_eq!(all.code, 0, "{}", all.stderr);
    assert_eq!(bytes(&place, "merged"), whole);
    assert_eq!(place.text("merged/report.html"), report);
    std::fs::remove_file(place.path("merged/report.html")).expect("removed");
    assert_eq!(place.run(&["campaign", "report", "study.toml", "--out", "merged"]).code, 0);
    assert_eq!(place.text("merged/report.html"), report);
    let bad = place.run(&["campaign", "study.toml", "--shard", "4/3"]);
    contains_all(&bad.stderr, &["numbered from 1 to 3"]);
}

/// Fifty kills at moments that differ: some seconds. `--ignored` runs it.
#[cfg(unix)]
#[test]
#[ignore = "long: the full form of the test below"]
fn a_campaign_that_is_killed_fifty_times_loses_nothing() {
    let many = RANDOM.replace("number = 60", "number = 4000");
    let place = place("campaign_killed_often", &many);
    assert_eq!(place.run(&["campaign", "study.toml"]).code, 0);
    let whole = bytes(&place, "out/study");
    let mut kills = 0;
    for attempt in 0.. {
        let resume = if place.exists("killed/campaign.json") { "--resume" } else { "--replace" };
        // Moments between 0.02 and 0.42 s, in no order: a generator of remainders.
        let limit = 0.02 + 0.4 * f64::from(attempt * 193 % 257) / 257.0;
        let killer =
            if kills < 50 { format!("timeout -s KILL {limit:.3} ") } else { String::new() };
        let line = format!(
            "{killer}\"$FENDERLINE\" campaign study.toml --out killed {resume} --threads 2"
        );
        if place.shell(&line).code == 0 {
            break;
        }
        kills += 1;
    }
    assert_eq!(kills, 50);
    assert_eq!(bytes(&place, "killed"), whole);
}

/// The program is killed again and again; the table is that of a campaign without interruption.
#[cfg(unix)]
#[test]
fn a_killed_campaign_goes_on_and_loses_nothing() {
    let place = place("campaign_killed", RANDOM);
    assert_eq!(place.run(&["campaign", "study.toml"]).code, 0);
    let whole = bytes(&place, "out/study");
    let mut kills = 0;
    for attempt in 0.. {
        assert!(attempt < 400, "it never ends");
        let resume = if place.exists("killed/campaign.json") { "--resume" } else { "--replace" };
        // Longer from attempt to attempt, so that it ends on any machine.
        let limit = format!("{:.3}", 0.02 + 0.005 * f64::from(attempt));
        let line = format!(
            "timeout -s KILL {limit} \"$FENDERLINE\" campaign study.toml --out killed {resume} --threads 2"
        );
        if place.shell(&line).code == 0 {
            break;
        }
        kills += 1;
    }
    assert!(kills > 0);
    assert_eq!(bytes(&place, "killed"), whole);
    // Killed between its table and its report, it makes the report.
    std::fs::remove_file(place.path("killed/report.html")).expect("removed");
    let again = place.run(&["campaign", "study.toml", "--out", "killed", "--resume"]);
    assert_eq!(again.code, 0, "{}", again.stderr);
    contains_all(&again.stdout, &["finished already"]);
    assert_eq!(place.text("killed/report.html"), place.text("out/study/report.html"));
}

#[test]
fn a_folder_is_never_overwritten_and_never_goes_on_with_another_campaign() {
    let place = place("campaign_folder", RANDOM);
    assert_eq!(place.run(&["campaign", "study.toml", "--shard", "1/2", "--out", "part"]).code, 0);
    let refused = |more: &[&str], parts: &[&str]| {
        let run = place.run(&[&["campaign", "study.toml"], more].concat());
        assert_eq!(run.code, 2, "{}", run.stderr);
        contains_all(&run.stderr, parts);
    };
    refused(&["--out", "part"], &["holds a campaign already", "--resume", "--replace"]);
    refused(&["--out", "part", "--resume"], &["the folder holds shard 1/2, not 1/1"]);
    refused(&["--out", "new", "--resume"], &["no campaign to go on with"]);
    place.write("study.toml", RANDOM.replace("7.1 cm/s", "7.2 cm/s").as_bytes());
    refused(&["--shard", "1/2", "--out", "part", "--resume"], &["differs from this campaign"]);
    place.write("study.toml", RANDOM.replace("number = 60", "number = 61").as_bytes());
    refused(
        &["--shard", "1/2", "--out", "part", "--resume"],
        &["has 60 runs, but this campaign has 61"],
    );
    place.write("study.toml", RANDOM.as_bytes());
    let scenario = place.text("quay.toml");
    place.write(
        "quay.toml",
        scenario.replace("gyradius = \"46 m\"", "gyradius = \"47 m\"").as_bytes(),
    );
    refused(&["--shard", "1/2", "--out", "part", "--resume"], &["differs from this campaign"]);
}

#[test]
fn a_case_of_a_random_campaign_is_replayed_with_its_report() {
    let place = place("campaign_replay", RANDOM);
    assert_eq!(place.run(&["campaign", "study.toml"]).code, 0);
    let report = place.text("out/study/report.html");
    contains_all(&report, &["seed 7. The same file gives the same runs"]);
    // A report of rows that another file drew would be false.
    place.write("other.toml", RANDOM.replace("7.1 cm/s", "7.2 cm/s").as_bytes());
    let run = place.run(&["campaign", "report", "other.toml", "--out", "out/study"]);
    assert_eq!(run.code, 2, "{}", run.stderr);
    contains_all(&run.stderr, &["differs from this campaign"]);
    assert_eq!(place.run(&["campaign", "report", "study.toml"]).code, 0);
    assert_eq!(place.text("out/study/report.html"), report);
    let csv = place.text("out/study/cases.csv");
    let run = place.run(&["campaign", "replay", "study.toml", "5", "--out", "fifth"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let summary = place.json("fifth/summary.json");
    assert_eq!(summary["verdict"]["key"], column(&csv, "verdict")[4]);
    let fenders = summary["fenders"].as_array().expect("a list");
    let peak_n = fenders.iter().filter_map(|fender| fender["peak_reaction_n"].as_f64());
    let peak_kn = peak_n.max_by(f64::total_cmp).expect("a fender was touched") * 1e-3;
    let line = csv.lines().nth(5).expect("a row");
    assert!(line.contains(&format!(",{peak_kn},")), "{peak_kn} is not in {line}");
    assert!(place.exists("fifth/report.html"));
}

/// The rows that a stop rule ends with do not depend on the threads.
#[test]
fn a_stop_rule_ends_at_the_same_run_for_any_number_of_threads() {
    let stop = format!("{RANDOM}\n[stop]\noutput = \"energy\"\nhalf_width = 0.5\nevery = 10\n");
    let place = place("campaign_stop", &stop);
    let run = place.run(&["campaign", "study.toml", "--threads", "1"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["ended by its stop rule"]);
    let rows = place.text("out/study/cases.csv").lines().count() - 1;
    assert!(rows.is_multiple_of(10) && rows < 60, "{rows}");
    assert_eq!(place.run(&["campaign", "study.toml", "--threads", "4", "--out", "four"]).code, 0);
    assert_eq!(bytes(&place, "four"), bytes(&place, "out/study"));
}

#[test]
fn mistakes_in_a_random_campaign_are_found_before_the_first_run() {
    let place = place("campaign_mistakes", RANDOM);
    place.write("speeds.csv", b"speed [cm/s]\n3\n\n5\n,\n");
    place.write("gap.csv", b"speed,other\n3,1\n,2\n");
    let refused = |part: &str, mistake: &str, fragments: &[&str]| {
        assert!(RANDOM.contains(part), "{part}");
        place.write("bad.toml", RANDOM.replacen(part, mistake, 1).as_bytes());
        let run = place.run(&["campaign", "bad.toml"]);
        assert_eq!(run.code, 2, "{mistake}: {}{}", run.stdout, run.stderr);
        contains_all(&run.stderr, fragments);
        assert!(!place.path("out/bad").exists(), "{mistake}");
    };
    refused("standard_deviation = \"4.47 cm/s\"", "standard_deviation = 0", &["one unit"]);
    refused("\"4.47 cm/s\"", "\"0 cm/s\"", &["must be above 0", "bad.toml:9"]);
    refused("at_most = \"40 cm/s\"", "at_most = \"1e-9 cm/s\"", &["too little to draw from"]);
    refused(
        "standard_deviation = \"4.47 cm/s\"\n",
        "",
        &["needs `mean` and `standard_deviation`", "given is `mean`"],
    );
    refused("\"lognormal\"", "\"lognormall\"", &["lognormal"]);
    refused("upper = \"5 deg\"", "upper = \"-6 deg\"", &["is not below"]);
    refused("number = 60", "", &["`number` is missing"]);
    refused(
        "number = 60",
        "number = 60\nplan = \"Sobol\"\ntable = \"x.csv\"",
        &["`table` goes with"],
    );
    refused("number = 60", "number = 70000\nplan = \"Sobol\"", &["at most 65536"]);
    refused("number = 60", "plan = \"full factorial\"", &["goes with a random plan"]);
    refused("coefficient = 0.3", "coefficient = 1", &["not positive definite"]);
    refused("[\"speed\", \"angle\"]", "[\"speed\", \"angel\"]", &["did you mean \"angle\"?"]);
    refused("[\"speed\", \"angle\"]", "[\"speed\", \"ship\"]", &["has no distribution"]);
    refused("fender.fender_3.reaction", "fender.fender_99.reaction", &["no fender `fender_99`"]);
    refused(
        "fender.fender_3.reaction",
        "fender.fender_3.force",
        &["a fender has no `force`", "reaction"],
    );
    refused(
        "930 - reaction",
        "930 - reation",
        &["no number `reation`", "did you mean `reaction`?"],
    );
    refused("930 - reaction", "930 -", &["output.margin"]);
    refused("2 * speed", "2 * sped", &["did you mean `speed`?"]);
    refused("2 * speed", "2 * doubled", &["needs another formula that needs this formula"]);
    refused("speed_normal", "sped_normal", &["did you mean `speed_normal`?"]);
    refused(
        "cm/s\"\nstandard",
        "cm/s\"\nfile = \"x.csv\"\nstandard",
        &["goes with an \"empirical\""],
    );
    let law = "distribution = \"lognormal\"\nmean = \"7.1 cm/s\"\nstandard_deviation = \"4.47 cm/s\"\nat_most = \"40 cm/s\"";
    refused(law, "distribution = \"empirical\"\nfile = \"none.csv\"", &["none.csv"]);
    refused(
        law,
        "distribution = \"empirical\"\nfile = \"gap.csv\"",
        &["gap.csv", "no value in row 2"],
    );
    refused(
        law,
        "distribution = \"empirical\"\nfile = \"gap.csv\"\ncolumn = \"sped\"",
        &["did you mean `speed`"],
    );
    refused(
        "seed = 7",
        "seed = 7\nstop = { output = \"reation\", half_width = 0.1 }",
        &["did you mean `reaction`"],
    );
}

/// A table of the user's own: a row a run, with names in it.
#[test]
fn the_rows_of_a_table_are_runs() {
    let table = r#"
scenario = "quay.toml"
plan = "table"
table = "runs.csv"
[variable.speed]
key = "body.ship.approach.speed_normal"
[variable.side]
key = "body.ship.approach.contact"
column = "where"
"#;
    let place = place("campaign_table", table);
    place.write(
        "runs.csv",
        "speed [cm/s],where\n5,quarter point\n7.5,quarter point\n10,midship\n".as_bytes(),
    );
    let run = place.run(&["campaign", "study.toml"]);
    assert!(run.code <= 1, "{}", run.stderr);
    let csv = place.text("out/study/cases.csv");
    assert_eq!(column(&csv, "speed [cm/s]"), ["5", "7.5", "10"]);
    assert_eq!(column(&csv, "side")[0], "quarter point");
    // Another value in the middle is another campaign.
    let share = ["campaign", "study.toml", "--shard", "1/2", "--out", "share"];
    assert!(place.run(&share).code <= 1);
    let again = [&share[..], &["--resume"]].concat();
    assert!(place.run(&again).code <= 1);
    place.write(
        "runs.csv",
        "speed [cm/s],where\n5,quarter point\n7.6,quarter point\n10,midship\n".as_bytes(),
    );
    contains_all(&place.run(&again).stderr, &["differs from this campaign"]);
    place.write("runs.csv", b"speed [cm/s],where\n5,\n");
    let run = place.run(&["campaign", "study.toml", "--out", "gap"]);
    assert_eq!(run.code, 2, "{}", run.stdout);
    contains_all(&run.stderr, &["runs.csv", "where"]);
}

#[test]
fn a_run_with_too_many_steps_is_a_row_with_its_reason() {
    let few = RANDOM
        .replace("seed = 7", "seed = 7\nmost_steps = 20000")
        .replace("mass=45000 t\"", "mass=45000 t\", \"time.duration=10 h\"");
    let place = place("campaign_steps", &few);
    let run = place.run(&["campaign", "study.toml"]);
    assert_eq!(run.code, 1, "{}", run.stdout);
    contains_all(&run.stderr, &["cases did not run", "more than `most_steps` 20000"]);
    // None of them: no run is begun.
    let none = RANDOM.replace("seed = 7", "seed = 7\nmost_steps = 100");
    place.write("none.toml", none.as_bytes());
    let run = place.run(&["campaign", "none.toml"]);
    assert_eq!(run.code, 2, "{}", run.stdout);
    contains_all(&run.stderr, &["more than `most_steps` 100", "no case of the campaign"]);
}

#[test]
fn limits_are_drawn_counted_and_have_a_return_period() {
    let limits = "[limit.\"yard's own\"]\noutput = \"reaction\"\nvalue = \"40 tf\"\n\n[limit.turn]\noutput = \"body.ship.largest_yaw\"\nvalue = \"1 deg\"\n\n[design]\nberthings_per_year = 120\n";
    let place = place("campaign_limits", &format!("{RANDOM}\n{limits}"));
    let run = place.run(&["campaign", "study.toml"]);
    assert!(run.code <= 1, "{}", run.stderr);
    let report = place.text("out/study/report.html");
    contains_all(&report, &["Your limits", "limit: yard's own", "once in years", "limit: turn"]);
    let csv = place.text("out/study/cases.csv");
    // From the right: the sentence of a finding has commas.
    let heads: Vec<&str> = csv.lines().next().expect("heads").rsplit(',').collect();
    let at = heads.iter().position(|head| *head == "reaction [kN]").expect("the column");
    let reactions = csv.lines().skip(1).map(|row| row.rsplit(',').nth(at).expect("a cell"));
    let above = reactions.filter(|r| r.parse::<f64>().expect("a number") > 392.266).count();
    assert!(above > 0, "none above");
    contains_all(&report, &[&format!("{above}<small>of 60")]);
    // A limit is no part of the rows: the campaign is the same one.
    place.write("study.toml", RANDOM.as_bytes());
    let again = place.run(&["campaign", "study.toml", "--resume"]);
    contains_all(&again.stdout, &["finished already"]);
    for (from, to, words) in [
        ("\"40 tf\"", "\"40 kJ\"", "but must be written as \"1.5 kN\""),
        ("\"40 tf\"", "40", "without a unit"),
        ("output = \"reaction\"", "output = \"reactoin\"", "did you mean `reaction`?"),
    ] {
        let wrong = limits.replace(from, to);
        place.write("wrong.toml", format!("{RANDOM}\n{wrong}").as_bytes());
        let run = place.run(&["campaign", "wrong.toml"]);
        assert_eq!(run.code, 2, "{}", run.stdout);
        contains_all(&run.stderr, &["limit.yard's own", words]);
    }
}

/// A scenario without fenders has no most used one, and none is printed.
#[test]
fn a_campaign_without_fenders_names_no_most_used_one() {
    let place = place("campaign_no_fenders", CAMPAIGN);
    let scenario = "[time]\nstep = 0.1\nduration = 2\n[body.ship]\nmass = 1e6\ngyradius = 9\noutline = [[-20, -5], [20, -5], [20, 5], [-20, 5]]\n";
    place.write("adrift.toml", scenario.as_bytes());
    let study = "scenario = \"adrift.toml\"\n[variable.surge]\nkey = \"body.ship.velocity.surge\"\nvalues = [0.1, 0.2]\n";
    place.write("adrift_study.toml", study.as_bytes());
    let run = place.run(&["campaign", "adrift_study.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert!(run.stdout.contains("2 of 2 cases done"), "{}", run.stdout);
    assert!(!run.stdout.contains("most used"), "{}", run.stdout);
}

/// The worked campaigns of the repository, with few runs: each makes its table and its report.
#[test]
fn the_worked_campaigns_run() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let place = Workplace::new("campaign_worked");
    std::fs::create_dir_all(place.path("campaigns")).expect("a folder");
    std::fs::create_dir_all(place.path("scenarios/berth")).expect("a folder");
    for file in [
        "campaigns/quay.toml",
        "scenarios/berth/alongside_with_two_tugs.toml",
        "scenarios/berth/moored_three_hours_in_gusts.toml",
    ] {
        std::fs::copy(root.join(file), place.path(file)).expect(file);
    }
    for (name, number, parts) in [
        ("terminal_mix", 100, &["Design values", "50 years", "Beside the formula", "Cho 2018"][..]),
        ("two_tugs_in_wind", 16, &["Operability", "berthed", "The worst runs"]),
        ("moored_in_gusts", 8, &["Inputs", "225 deg: 26 %"]),
    ] {
        let text =
            std::fs::read_to_string(root.join(format!("campaigns/{name}.toml"))).expect(name);
        let lines = text.lines().map(|line| match line.starts_with("number = ") {
            true => format!("number = {number}\n"),
            false => format!("{line}\n"),
        });
        let file = format!("campaigns/{name}.toml");
        place.write(&file, lines.collect::<String>().as_bytes());
        let run = place.run(&["campaign", &file]);
        assert_eq!(run.code, 0, "{name}: {}", run.stderr);
        assert_eq!(place.text(&format!("out/{name}/cases.csv")).lines().count(), number + 1);
        contains_all(&place.text(&format!("out/{name}/report.html")), parts);
    }
}

/// A mistake in a value points at its line of the campaign's file, or of the file of measured values, not at a `--set` that nobody wrote.
#[test]
fn a_mistake_in_a_value_names_the_line_of_the_campaign() {
    let place = place("campaign_lines", RANDOM);
    let refused = |file: &str, fragments: &[&str]| {
        place.write("bad.toml", file.as_bytes());
        let run = place.run(&["campaign", "bad.toml"]);
        assert_eq!(run.code, 2, "{file}: {}{}", run.stdout, run.stderr);
        contains_all(&run.stderr, fragments);
        assert!(!run.stderr.contains("--set"), "{}", run.stderr);
    };
    let values = "scenario = \"quay.toml\"\n[variable.speed]\nkey = \"body.ship.approach.speed_normal\"\nvalues = [\n    \"0.1 kN\",\n    \"0.2 kN\"]\n";
    refused(values, &["must be a speed", "--> bad.toml:5:5", "5 |     \"0.1 kN\","]);
    let key = values.replace("speed_normal", "sped_normal");
    refused(&key, &["did you mean `speed_normal`?", "--> bad.toml:3:7"]);
    let common =
        format!("set = [\"time.step=0.1\", \"time.step=3 m\"]\n{values}").replace("kN", "m/s");
    refused(&common, &["must be a time", "--> bad.toml:1:25"]);
    let law = RANDOM.replace("cm/s", "kg");
    refused(
        &law,
        &["must be a speed", "bad.toml:9:16", "distribution = \"lognormal\"", "run 1 sets"],
    );
    let formula =
        RANDOM.replace("[variable.doubled]\n", "[variable.doubled]\nkey = \"time.step\"\n");
    refused(&formula, &["bad.toml:23:14", "expression = \"2 * speed\""]);
    let choice = RANDOM
        .replace("berthing.draught=6.5 m", "berthing.draught=6.5 s")
        .replace("set = [\"body.ship.mass=45000 t\"]", "set = [\"berthing.draught=6.5 s\"]");
    refused(&choice, &["must be a length", "--> bad.toml:", "berthing.draught=6.5 s"]);
    let table = "scenario = \"quay.toml\"\nplan = \"table\"\ntable = \"runs.csv\"\n[variable.speed]\nkey = \"body.ship.approach.speed_normal\"\n[variable.distance]\nkey = \"body.ship.approach.distance\"\n";
    place.write("runs.csv", b"distance [m],speed [cm/s]\n\n2,-5\n2,-6\n");
    refused(table, &["--> runs.csv:3:3", "3 | 2,-5", "run 1 sets", "no case of the campaign"]);
    // One bad value among good ones is a row, which names file and line.
    place.write("runs.csv", b"distance [m],speed [cm/s]\n2,5\n2,-6\n");
    let run = place.run(&["campaign", "bad.toml"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    contains_all(&run.stderr, &["case 2 did not run", "runs.csv, line 3"]);
    contains_all(&place.text("out/bad/cases.csv"), &["runs.csv, line 3"]);
    let law = "distribution = \"lognormal\"\nmean = \"7.1 cm/s\"\nstandard_deviation = \"4.47 cm/s\"\nat_most = \"40 cm/s\"";
    let measured = RANDOM.replace(law, "distribution = \"empirical\"\nfile = \"speeds.csv\"");
    place.write("speeds.csv", b"speed [kN]\n3\n4\n");
    refused(
        &measured.replace("unit = \"cm/s\"\n", ""),
        &["must be a speed", "--> speeds.csv:", "run 1 sets"],
    );
}

/// Where a line of the file stands is no part of what a campaign is: a comment more, and it goes on.
#[test]
fn a_comment_more_does_not_make_another_campaign() {
    let place = place("campaign_comment", RANDOM);
    let share = ["campaign", "study.toml", "--shard", "1/2", "--out", "share", "--resume"];
    assert!(place.run(&share[..6]).code <= 1);
    place.write("study.toml", format!("# A comment.\n{RANDOM}").as_bytes());
    let again = place.run(&share);
    assert!(again.code <= 1, "{}", again.stderr);
}
