//! Hours of a year that a berth loses to the weather: `fenderline campaign` of a file with [downtime].

use crate::support;

use support::{Workplace, contains_all};

/// A ship adrift in steady wind: from ahead she goes astern, from her side sideways, and farther in stronger wind.
const SHIP: &str = r#"
[time]
step = "1 s"
duration = "120 s"

[environment]
depth = "20 m"
wind = { speed = "1 m/s", from = 0 }

[vessel.tanker]
length_bp = 243.5
beam = 39
draught = 15.3
block_coefficient = 0.8
rudder = { area = "60 m^2", span = "9 m" }
propeller = { diameter = "7 m", full = "90 rpm" }
windage = { frontal_area = "1000 m^2", lateral_area = "3500 m^2", centroid_height = "16 m", type = "tanker, loaded" }

[body.ship]
vessel = "tanker"
outline = [[-121.75, -19.5], [121.75, -19.5], [121.75, 19.5], [-121.75, 19.5]]

[limit."ahead and astern"]
of = "surge"
statistic = "maximum"
distance = "0.3 m"

[limit.sideways]
of = "sway"
statistic = "maximum"
distance = "1 m"
"#;

const DOWNTIME: &str = r#"
title = "Hours lost"
scenario = "ship.toml"
seed = 4
[downtime]
file = "weather.csv"
states = 10
sample = 12
"#;

/// Hours of four kinds: light and strong wind from ahead and from starboard. Of 1,000 h from the end of January on.
fn weather() -> String {
    let mut text = String::from("time,wind_speed_mps,wind_from_deg\n");
    for hour in 0..1000_usize {
        let (month, day) = match 20 + hour / 24 {
            day @ ..=31 => (1, day),
            day @ 32..=59 => (2, day - 31),
            day => (3, day - 59),
        };
        let speed = if hour % 10 == 0 { 30 } else { 3 };
        let from = if hour % 100 < 30 { 0 } else { 90 };
        let clock = hour % 24;
        text += &format!("2025-{month:02}-{day:02}T{clock:02}:00,{speed},{from}\n");
    }
    text
}

fn place(name: &str) -> Workplace {
    let place = Workplace::new(name);
    place.write("ship.toml", SHIP.as_bytes());
    place.write("weather.csv", weather().as_bytes());
    place.write("year.toml", DOWNTIME.as_bytes());
    place
}

/// Of 1,000 h of four kinds, 100 h are of strong wind: 30 h from ahead and 70 h from starboard.
#[test]
fn hours_are_lost_by_the_limits_that_their_states_exceed() {
    let place = place("downtime");
    let run = place.run(&["campaign", "year.toml", "--threads", "1"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["16 of 16 cases done", "lost: 100 h of 1000 h, 10.0 %"]);
    contains_all(&run.stdout, &["70 h  sideways", "30 h  ahead and astern"]);
    let csv = place.text("out/year/downtime.csv");
    let january = "month,January,288,29,10.069";
    let of_sea = ["all,all,1000,100,10,,,0", "reason,sideways,1000,70,7,70,70,0", january];
    contains_all(&csv, &of_sea);
    contains_all(&csv, &["wind direction,N,300,30,10,,,0", "wind direction,E,700,70,10,,,0"]);
    assert!(!csv.contains("wave direction"), "{csv}");
    let hours = place.text("out/year/hours.csv");
    assert_eq!(hours.lines().count(), 1001);
    contains_all(&hours, &["2025-01-20T00:00,1,", ",1,ahead and astern"]);
    // Hours of one kind are one state, so that all agree.
    let json = place.json("out/year/downtime.json");
    assert_eq!(json["states"], 4);
    assert_eq!(json["sample"]["hours_compared"], 12);
    assert_eq!(json["sample"]["disagree"]["share"], 0.0);
    assert_eq!(json["lost_hours_a_year"], 876.0);
    let report = place.text("out/year/report.html");
    contains_all(&report, &["By month", "By wind direction", "Error of the states", "<circle"]);
    // A table has the limits' shares, and the reasons.
    let cases = place.text("out/year/cases.csv");
    contains_all(&cases, &["limit.ahead and astern [%]", "lost_by", "limit_exceeded"]);
    // A state by itself.
    let replay = place.run(&["campaign", "replay", "year.toml", "1", "--out", "one"]);
    assert_eq!(replay.code, 0, "{}", replay.stderr);
    assert!(place.exists("one/report.html"));
}

#[test]
fn tables_and_report_have_the_same_bytes_from_threads_shares_and_after_a_stop() {
    let place = place("downtime_bytes");
    assert_eq!(place.run(&["campaign", "year.toml", "--threads", "1"]).code, 0);
    assert_eq!(place.run(&["campaign", "year.toml", "--threads", "3", "--out", "threads"]).code, 0);
    for share in ["1/2", "2/2"] {
        let out = format!("share_{}", &share[..1]);
        let args = ["campaign", "year.toml", "--shard", share, "--out", &out];
        assert_eq!(place.run(&args).code, 0);
    }
    let merged =
        place.run(&["campaign", "merge", "year.toml", "share_1", "share_2", "--out", "merged"]);
    assert_eq!(merged.code, 0, "{}", merged.stderr);
    // The journal of a share is what a killed program leaves, but for its share.
    let journal = std::fs::read(place.path("share_1/rows.journal")).expect("rows");
    std::fs::create_dir(place.path("killed")).expect("a folder");
    std::fs::copy(place.path("out/year/campaign.json"), place.path("killed/campaign.json"))
        .expect("copied");
    place.write("killed/rows.journal", &journal[..journal.len() - 5]);
    let resumed = place.run(&["campaign", "year.toml", "--resume", "--out", "killed"]);
    assert_eq!(resumed.code, 0, "{}", resumed.stderr);
    for other in ["threads", "merged", "killed"] {
        for file in ["cases.csv", "downtime.csv", "downtime.json", "hours.csv", "report.html"] {
            let own = place.text(&format!("out/year/{file}"));
            assert_eq!(place.text(&format!("{other}/{file}")), own, "{other}/{file}");
        }
    }
}

#[test]
fn a_scatter_diagram_is_a_state_a_class() {
    let place = place("downtime_diagram");
    place.write(
        "weather.csv",
        b"wind_speed_mps,wind_from_deg,share\n3,0,0.5\n30,0,0.1\n3,90,0.1\n10,90,0\n30,90,0.3\n",
    );
    let run = place.run(&["campaign", "year.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["4 of 4 cases done", "lost: 3504 h of 8760 h, 40.0 %"]);
    contains_all(&place.text("out/year/report.html"), &["Each class of the diagram is a state"]);
    assert!(!place.text("out/year/downtime.csv").contains("month"));
}

/// Mistakes name file, line and reason.
#[test]
fn bad_weathers_are_refused() {
    let place = place("downtime_bad");
    let refused = |fragments: &[&str]| {
        let run = place.run(&["campaign", "year.toml"]);
        assert_eq!(run.code, 2, "{}{}", run.stdout, run.stderr);
        contains_all(&run.stderr, fragments);
        assert!(!place.exists("out/year"), "nothing is left");
    };
    place.write("year.toml", DOWNTIME.replace("sample = 12", "sample = 2").as_bytes());
    for (weather, fragments) in [
        ("", &["weather.csv: the file is empty"][..]),
        ("time,wind_speed_mps,wind_from_deg\n", &["no rows"]),
        ("time,wind_sped_mps,wind_from_deg\n", &["did you mean `wind_speed_mps`?"]),
        ("time,wind_speed_mps\n2025-01-01T00:00,3\n", &["`wind_from_deg` is missing"]),
        ("time,level_m\n2025-01-01T00:00,3\n", &["neither waves"]),
        ("wind_speed_mps,wind_from_deg\n3,0\n", &["`time` or `t_s`"]),
        (
            "time,hours,wind_speed_mps,wind_from_deg\n2025-01-01T00:00,1,3,0\n",
            &["do not go together"],
        ),
        ("wind_speed_mps,wind_from_deg,share\n3,0,0.5\n", &["sums to 0.5"]),
        ("wind_speed_mps,wind_from_deg,hours\n3,0,0\n", &["no class of the diagram has hours"]),
        (
            "time,wind_speed_mps,wind_from_deg\n2025-01-01T00:00,3,0\n2025-01-01T01:00,-3,0\n",
            &["weather.csv:3:18", "between 0 and 120, but is -3"],
        ),
        (
            "time,wind_speed_mps,wind_from_deg\n2025-01-01T00:00,3,0\n2025-01-01T01:00,,0\n",
            &["weather.csv:3:18", "is empty here"],
        ),
        (
            "time,wind_speed_mps,wind_from_deg\n2025-01-01T00:00,3,0\n2025-01-01T01:00,x,0\n",
            &["weather.csv:3", "`x` is not a number"],
        ),
        (
            "time,wind_speed_mps,wind_from_deg\n1.1.2025,3,0\n",
            &["weather.csv:2:1", "`1.1.2025` is not a time as 2025-01-31T23:00"],
        ),
        (
            "time,wind_speed_mps,wind_from_deg\n2025-01-01T00:00,3,0\n2025-01-01T01:00,3,0\n2025-01-01T04:00,3,0\n",
            &["weather.csv:4:1", "3 h after the row before, but the step of the series is 1 h"],
        ),
        (
            "t_s,wind_speed_mps,wind_from_deg\n0,3,0\n3600,3,0\n3600,3,0\n",
            &["weather.csv:4:1", "not later than the row before"],
        ),
        (
            "t_s,hs_m,tp_s,wave_from_deg\n0,3,9,0\n3600,15.7,9,0\n",
            &[
                "weather.csv:3:6",
                "waves break at 0.78 of the water depth (McCowan 1894), here at 15.60 m",
            ],
        ),
    ] {
        place.write("weather.csv", weather.as_bytes());
        refused(fragments);
    }
    place.write("year.toml", DOWNTIME.as_bytes());
    place.write("weather.csv", b"t_s,wind_speed_mps,wind_from_deg\n0,3,0\n3600,3,0\n");
    refused(&["fewer than the 12 of `sample`"]);
    place.write("weather.csv", weather().as_bytes());
    let limits = SHIP.find("[limit").expect("limits");
    place.write("ship.toml", &SHIP.as_bytes()[..limits]);
    refused(&["the scenario has no [limit.NAME]"]);
    place.write("ship.toml", SHIP.replace("limit.sideways", "limit.\"side;ways\"").as_bytes());
    refused(&["`side;ways` has a semicolon"]);
    place.write("ship.toml", SHIP.as_bytes());
    for (part, mistake, fragments) in [
        ("seed = 4", "plan = \"Sobol\"", &["`plan` does not go with [downtime]"][..]),
        ("seed = 4", "number = 3", &["`number` does not go with [downtime]"]),
        (
            "[downtime]",
            "[limit.a]\noutput = \"energy\"\nvalue = \"3 kJ\"\n[downtime]",
            &["the limits of the scenario"],
        ),
        (
            "[downtime]",
            "[variable.a]\nkey = \"time.step\"\nvalues = [1]\n[downtime]",
            &["`variable` does not go"],
        ),
        ("states = 10", "states = 0", &["downtime.states", "year.toml:7"]),
        ("states = 10", "states = 1.5", &["must be a whole number"]),
        ("states = 10", "stats = 10", &["did you mean `states`?"]),
        ("weather.csv", "wether.csv", &["wether.csv"]),
    ] {
        assert!(DOWNTIME.contains(part));
        place.write("year.toml", DOWNTIME.replacen(part, mistake, 1).as_bytes());
        refused(fragments);
    }
}

/// The worked example in a small form: a year of weather as two states of six minutes, and an hour as it is.
#[test]
fn the_worked_example_runs() {
    let root = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let place = Workplace::new("downtime_worked");
    for folder in ["campaigns", "scenarios/berth"] {
        std::fs::create_dir_all(place.path(folder)).expect("a folder");
    }
    for file in ["moored_with_limits.toml", "container_ship_20m.hydro"] {
        let file = format!("scenarios/berth/{file}");
        std::fs::copy(root.join(&file), place.path(&file)).expect("copied");
    }
    let script = root.join("campaigns/synthetic_year.py");
    let made = std::process::Command::new("python3").arg(&script).args(["--seed", "1"]).output();
    let Ok(made) = made else {
        eprintln!("no python3: the example is not run");
        return;
    };
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    assert_eq!(made.stdout.iter().filter(|byte| **byte == b'\n').count(), 8761);
    place.write("campaigns/year.csv", &made.stdout);
    let text = std::fs::read_to_string(root.join("campaigns/downtime.toml")).expect("the example");
    place.write("campaigns/downtime.toml", text.as_bytes());
    let check = place.run(&["check", "campaigns/downtime.toml"]);
    assert_eq!(check.code, 0, "{}", check.stderr);
    contains_all(&check.stdout, &["360 cases of 18000 time steps", "wave_height: "]);
    let small = text.replace(
        "\n[downtime]\n",
        "\nset = [\"time.duration=2 min\", \"statistics.from=1 min\"]\n[downtime]\nstates = 2\nsample = 1\n",
    );
    place.write("campaigns/small.toml", small.as_bytes());
    let run = place.run(&["campaign", "campaigns/small.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["3 of 3 cases done", "of 8760 h"]);
    contains_all(
        &place.text("out/small/report.html"),
        &["By wave direction", "each run for 2.00 min"],
    );
    let csv = place.text("out/small/downtime.csv");
    contains_all(&csv, &["month,December,744,", "reason,surge,8760,", "wave direction,SSW,"]);
}
