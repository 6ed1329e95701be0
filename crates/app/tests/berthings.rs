//! `fenderline berthings`: from logs to a table and a report, and the table into other commands.

use crate::support;

use support::{Workplace, contains_all};

const BERTH: &str = include_str!("../../../examples/measured/berth.toml");
const LOG: &str = include_str!("../../../examples/measured/portable.tsv");
const MAPPING: &str = include_str!("../../../examples/measured/portable.toml");

fn place(name: &str) -> Workplace {
    let place = Workplace::new(name);
    place.write("berth.toml", BERTH.as_bytes());
    place.write("log.tsv", LOG.as_bytes());
    place.write("mapping.toml", MAPPING.as_bytes());
    place
}

#[test]
fn a_log_gives_a_table_and_a_report_and_the_table_goes_on() {
    let place = place("berthings");
    let command =
        "berthings log.tsv --berth berth.toml --mapping mapping.toml --report page.html -o";
    let mut args: Vec<&str> = command.split(' ').collect();
    args.push("table.csv");
    let run = place.run(&args);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stdout,
        &[
            "1. 2025-07-14T11:3",
            "cm/s",
            "first at cone_",
            "2 berthings",
            "written: table.csv, page.html",
        ],
    );
    assert!(!run.stderr.contains("left out"), "{}", run.stderr);
    contains_all(&place.text("page.html"), &["<svg", "Most used fender", "first touch"]);
    let table = place.text("table.csv");
    contains_all(
        &table,
        &[
            "berthing,time,ship",
            "speed [m/s],speed_sd [m/s]",
            "fender.cone_1.reaction [kN]",
            "Pilot",
        ],
    );
    *args.last_mut().expect("a table") = "table.parquet";
    assert_eq!(place.run(&args).code, 0);
    for table in ["table.csv", "table.parquet"] {
        let list = place.run(&["statistics", table]);
        contains_all(&list.stdout, &["speed [m/s]", "energy [kJ]"]);
    }
    place.write(
        "campaign.toml",
        b"scenario = \"berth.toml\"\nnumber = 2\nset = [\"time.duration=1 s\"]\n[variable.speed]\n\
          key = \"body.ship.velocity.sway\"\ndistribution = \"empirical\"\nfile = \"table.csv\"\ncolumn = \"speed\"\nunit = \"m/s\"\n",
    );
    let campaign = place.run(&["check", "campaign.toml"]);
    assert_eq!(campaign.code, 0, "{}", campaign.stderr);
}

#[test]
fn bad_input_of_berthings_is_named() {
    let place = place("berthings_bad");
    place.write("no_berth.toml", BERTH.split("[berthing]").next().expect("a part").as_bytes());
    place.write("bad.toml", b"bow_senor = 1\n");
    place.write("other.csv", b"a,b\n1,2\n");
    for (command, words) in [
        (
            "berthings other.csv --berth berth.toml",
            "other.csv:1: the log has no column of the time",
        ),
        ("berthings log.tsv --berth no_berth.toml", "has no [berthing]"),
        ("berthings log.tsv --berth berth.toml --mapping bad.toml", "bad.toml:1:1"),
        ("berthings log.tsv --berth berth.toml -o table.txt", "must end in .parquet or .csv"),
        ("berthings none.csv --berth berth.toml", "none.csv"),
        ("berthings log.tsv", "--berth"),
    ] {
        let run = place.run(&command.split(' ').collect::<Vec<_>>());
        assert_eq!(run.code, 2, "{command}: {}", run.stderr);
        assert!(run.stderr.contains(words), "{command}: {}", run.stderr);
    }
    // A bad log beside a good one: the good one's berthings are kept.
    let run = place.run(&[
        "berthings",
        "other.csv",
        "log.tsv",
        "--berth",
        "berth.toml",
        "--mapping",
        "mapping.toml",
    ]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["2 berthings, 1 left out"]);
}
