//! The program as a user meets it: exit codes, files, columns, and what happens when things break.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::support;

use std::fs;

use fenderline_embed::{Engine, Settings};
use fenderline_scenario::{Override, Scenario};
use support::{Workplace, contains_all};

#[test]
fn a_good_run_writes_all_files_and_prints_the_pairs() {
    let place = Workplace::new("good_run");
    let run = place.run(&["run", "tug.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stdout, &["A tug at a quay", "quay - tug", "peak force", "summary.json"]);
    assert_eq!(
        place.files("out/tug"),
        ["bodies.csv", "contacts.csv", "energy.csv", "report.html", "summary.json"]
    );
}

#[test]
fn exit_codes_tell_bad_input_from_a_failed_case() {
    let place = Workplace::new("exit_codes");
    place.write("broken.toml", b"[time\nstep = 1");
    place.write("latin1.toml", b"title = \"\xe9\"\n");
    place.write("occupied", b"a file where the results should go");
    let table: [(&[&str], i32, &str); 13] = [
        (&["check", "tug.toml"], 0, ""),
        (&["schema"], 0, ""),
        (&["--version"], 0, ""),
        (&["run", "none.toml"], 2, "none.toml"),
        (&["run", "."], 2, "cannot read"),
        (&["run", "none.toml"], 2, "= help: a scenario is a TOML text file"),
        (&["run", "broken.toml"], 2, "broken.toml"),
        (&["run", "latin1.toml"], 2, "line 1"),
        (&["run", "tug.toml", "--set", "time.stepp=1"], 2, "step"),
        (&["run", "tug.toml", "--step", "nan"], 2, "step"),
        (&["run", "tug.toml", "--frmat", "csv"], 2, "--frmat"),
        (&["run"], 2, "SCENARIO"),
        (&["run", "tug.toml", "--out", "occupied"], 2, "occupied"),
    ];
    for (args, code, word) in table {
        let run = place.run(args);
        assert_eq!(run.code, code, "{args:?}: {}", run.stderr);
        assert!(run.stderr.contains(word), "{args:?}: {}", run.stderr);
        assert!(!run.stderr.contains("panicked"), "{args:?}: {}", run.stderr);
    }
    assert!(!place.exists("out"), "bad input writes nothing");
}

#[test]
fn the_version_names_commit_and_features_in_its_long_form_alone() {
    let place = Workplace::new("version");
    let version = format!("fenderline {}", env!("CARGO_PKG_VERSION"));
    assert_eq!(place.run(&["-V"]).stdout, format!("{version}\n"));
    let long = place.run(&["--version"]).stdout;
    let lines: Vec<&str> = long.lines().collect();
    assert_eq!(lines.len(), 3, "{long}");
    assert_eq!(lines[0], version);
    let commit = lines[1].strip_prefix("commit: ").expect("the second line names the commit");
    let number = commit.strip_suffix(", modified").unwrap_or(commit);
    let is_number = number.len() >= 8 && number.bytes().all(|byte| byte.is_ascii_hexdigit());
    assert!(is_number || commit == "not known", "{long}");
    assert!(lines[2].starts_with("features: "), "{long}");
    // What a run writes names the version alone.
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let summary = String::from_utf8(place.read("out/tug/summary.json")).expect("text");
    let named = format!("\"fenderline_version\": \"{}\"", env!("CARGO_PKG_VERSION"));
    assert!(summary.contains(&named), "{summary}");
}

#[test]
fn a_refused_scenario_leaves_an_earlier_result_alone() {
    let place = Workplace::new("refused");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let before = place.read("out/tug/summary.json");
    assert_eq!(place.run(&["run", "tug.toml", "--set", "time.step=-1"]).code, 2);
    assert_eq!(place.read("out/tug/summary.json"), before);
}

#[test]
fn an_earlier_run_is_removed_and_foreign_files_stay() {
    let place = Workplace::new("earlier");
    place.write("out/tug/bodies.parquet", b"old");
    place.write("out/tug/contacts.csv.part", b"old");
    place.write("out/tug/notes.txt", b"mine");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    assert_eq!(
        place.files("out/tug"),
        ["bodies.csv", "contacts.csv", "energy.csv", "notes.txt", "report.html", "summary.json"]
    );
}

#[test]
fn the_columns_are_those_that_others_rely_on() {
    let place = Workplace::new("columns");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let header = |name: &str| {
        let text = place.text(&format!("out/tug/{name}.csv"));
        text.lines().next().unwrap_or_default().to_owned()
    };
    assert_eq!(
        header("bodies"),
        "t_s,body,x_m,y_m,heading_rad,u_mps,v_mps,r_radps,force_x_n,force_y_n,moment_z_nm,\
         peak_force_n"
    );
    assert_eq!(
        header("contacts"),
        "t_s,body_1,body_2,area_m2,depth_m,point_x_m,point_y_m,normal_x,normal_y,v_normal_mps,\
         v_tangential_mps,shear_m,normal_force_n,tangential_force_n,friction_state,limited,patch,fender,\
         spring_n,stop_n,damper_n,limiter_n,stored_j,tilt_rad,normal_work_j,tangential_work_j"
    );
    assert_eq!(
        header("energy"),
        "t_s,kinetic_j,load_work_j,hull_work_j,propeller_work_j,rudder_work_j,thrusters_work_j,\
         wind_work_j,waves_work_j,radiation_work_j,banks_work_j,passing_work_j,bottom_work_j,current_work_j,\
         tugs_work_j,lines_work_j,anchors_work_j,piles_work_j,other_work_j,stored_j,shear_stored_j,hysteresis_j,damping_j,restitution_j,\
         friction_j,contact_residual_j,residual_j"
    );
}

/// Options named like the keys of `[output]`; summary and report are those of every step.
#[test]
fn an_output_interval_and_a_choice_of_tables() {
    let place = Workplace::new("output");
    assert_eq!(place.run(&["run", "tug.toml", "--out", "all"]).code, 0);
    let few = ["run", "tug.toml", "--out", "few", "--interval", "2 s", "--tables", "bodies,energy"];
    let told = place.run(&few);
    assert_eq!(told.code, 0, "{}", told.stderr);
    assert_eq!(place.files("few"), ["bodies.csv", "energy.csv", "report.html", "summary.json"]);
    assert_eq!(place.text("few/bodies.csv").lines().count(), 1 + 2 * 5);
    assert_eq!(place.text("few/energy.csv").lines().count(), 1 + 1 + 5);
    let mut summaries = ["all", "few"].map(|folder| place.json(&format!("{folder}/summary.json")));
    let files = summaries.each_mut().map(|summary| summary["files"].take());
    assert_eq!(summaries[0], summaries[1]);
    assert_ne!(files[0], files[1]);
    assert_eq!(place.text("all/report.html").len(), place.text("few/report.html").len());

    let refused = place.run(&["run", "tug.toml", "--interval", "0.25"]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("--interval 0.25"), "{}", refused.stderr);
    let refused = place.run(&["run", "tug.toml", "--tables", "bodies,forces"]);
    assert_eq!(refused.code, 2);
    assert!(refused.stderr.contains("there is no result table \"forces\""), "{}", refused.stderr);
}

#[test]
fn the_table_of_bodies_has_one_row_per_body_and_step() {
    let place = Workplace::new("rows");
    assert_eq!(place.run(&["run", "tug.toml", "--step", "0.5 s"]).code, 0);
    let text = place.text("out/tug/bodies.csv");
    let rows: Vec<&str> = text.lines().skip(1).collect();
    assert_eq!(rows.len(), 2 * 20);
    assert!(rows[0].starts_with("0.0,quay,") && rows[1].starts_with("0.0,tug,"), "{rows:?}");
    assert!(rows[3].starts_with("0.5,tug,"), "{}", rows[3]);
    // u and v are in the body's axes: the tug heads east at 1 m/s.
    let fields: Vec<&str> = rows[1].split(',').collect();
    let number = |i: usize| fields[i].parse::<f64>().expect("a number");
    assert!((number(5) - 1.0).abs() < 1e-12 && number(6).abs() < 1e-12, "{fields:?}");
}

#[test]
fn the_summary_has_the_promised_keys_and_agrees_with_the_table() {
    let place = Workplace::new("summary");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let summary = place.json("out/tug/summary.json");
    let pair = &summary["pairs"][0];
    assert_eq!(pair["bodies"], serde_json::json!(["quay", "tug"]));
    for key in [
        "first_touch_s",
        "peak_normal_force_n",
        "peak_depth_m",
        "impulse_ns",
        "approach_speed_mps",
        "final_speed_mps",
    ] {
        assert!(pair[key].is_f64(), "{key}: {pair}");
    }
    let contacts = place.text("out/tug/contacts.csv");
    let forces = contacts
        .lines()
        .skip(1)
        .map(|row| row.split(',').nth(12).and_then(|f| f.parse::<f64>().ok()).expect("a force"));
    assert_eq!(pair["peak_normal_force_n"].as_f64(), Some(forces.fold(0.0, f64::max)));
    let files = &summary["files"];
    assert_eq!(files[1]["rows"].as_u64(), Some(contacts.lines().count() as u64 - 1));
    assert_eq!(summary["events"]["counts"]["contact_began"], 1);
    assert_eq!(summary["bodies"][1]["name"], "tug");
}

#[test]
fn two_runs_give_the_same_bytes() {
    let place = Workplace::new("same_bytes");
    for (scenario, format) in [
        ("tug.toml", "csv"),
        ("tug.toml", "parquet"),
        ("berth.toml", "csv"),
        ("berth.toml", "parquet"),
    ] {
        for out in ["a", "b"] {
            assert_eq!(
                place
                    .run(&["run", scenario, "--allow-failures", "--out", out, "--format", format])
                    .code,
                0
            );
        }
        for name in place.files("a") {
            let [a, b] = ["a", "b"].map(|out| place.read(&format!("{out}/{name}")));
            assert!(a == b, "{name} differs");
        }
    }
}

#[test]
fn a_title_cannot_put_markup_into_the_report() {
    let place = Workplace::new("markup");
    let scenario = support::TUG
        .replace("A tug at a quay", "<script>alert(1)</script> & more")
        .replace("[body.tug]", "[body.\"<img src=x onerror=alert(1)>\"]")
        .replace("\"tug\"", "\"<img src=x onerror=alert(1)>\"");
    place.write("evil.toml", scenario.as_bytes());
    let run = place.run(&["run", "evil.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    let report = place.text("out/evil/report.html");
    assert!(!report.contains("<script>alert") && !report.contains("<img"));
    assert!(report.contains("&lt;script&gt;alert(1)&lt;/script&gt; &amp; more"));
    // One script, ours; and nothing is loaded from elsewhere.
    assert_eq!(report.matches("<script").count(), 1);
    for word in ["<img", "<link", "http:", "https:", "url(", "NaN"] {
        let found = report.replace("http://www.w3.org/2000/svg", "").contains(word);
        assert!(!found, "the report holds {word}");
    }
}

#[test]
fn no_bar_is_drawn_when_piped() {
    let place = Workplace::new("piped");
    let run = place.run(&["run", "tug.toml", "--step", "1e-4", "--duration", "80"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(run.stderr, "");
    assert!(!run.stdout.contains('\u{1b}'));
}

#[test]
fn notices_go_to_standard_error_and_into_the_summary() {
    let place = Workplace::new("notices");
    let clockwise = support::TUG.replace(
        "[[-100, 0], [100, 0], [100, 5], [-100, 5]]",
        "[[-100, 5], [100, 5], [100, 0], [-100, 0]]",
    );
    place.write("turned.toml", clockwise.as_bytes());
    let run = place.run(&["run", "turned.toml"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(&run.stderr, &["notice: ", "body.quay.outline"]);
    let notices = &place.json("out/turned/summary.json")["notices"];
    assert!(notices[0].as_str().is_some_and(|n| n.starts_with("line 21, ")), "{notices}");
}

#[test]
fn a_closed_pipe_ends_quietly() {
    let place = Workplace::new("closed_pipe");
    for args in ["schema", "--help", "check tug.toml"] {
        let run = place.shell(&format!("\"$FENDERLINE\" {args} | true"));
        assert_eq!((run.code, run.stderr.as_str()), (0, ""), "{args}");
    }
    let run = place.shell("set -o pipefail; \"$FENDERLINE\" schema | head -c 1 > /dev/null");
    assert_eq!((run.code, run.stderr.as_str()), (0, ""));
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_size_limit_leaves_no_file_that_reads_as_complete() {
    let place = Workplace::new("size_limit");
    for (format, blocks) in [("csv", 8), ("parquet", 8), ("csv", 60)] {
        let run = place.shell(&format!(
            "trap '' XFSZ; ulimit -f {blocks}; exec \"$FENDERLINE\" run tug.toml --step 0.01 \
             --format {format}"
        ));
        assert_eq!(run.code, 1, "{format}: {}", run.stderr);
        contains_all(&run.stderr, &["cannot write", ".part"]);
        assert_eq!(place.files("out/tug"), Vec::<String>::new(), "{format}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_under_standard_output_fails_the_command() {
    let place = Workplace::new("full");
    let run = place.shell("\"$FENDERLINE\" schema > /dev/full");
    assert_eq!(run.code, 1);
    contains_all(&run.stderr, &["standard output"]);
}

#[test]
fn a_simulation_that_fails_leaves_no_result_of_this_or_an_earlier_run() {
    let place = Workplace::new("failed_simulation");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let load = "[[load]]\nbody = \"tug\"\nforce = [\"1e14 N\", \"0 N\"]\n";
    let wild = support::TUG.replace("930 t", "1 kg") + load;
    place.write("tug.toml", wild.as_bytes());
    let run = place.run(&["run", "tug.toml"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    contains_all(&run.stderr, &["error", "tug"]);
    assert_eq!(place.files("out/tug"), Vec::<String>::new());
}

#[test]
fn the_contact_is_the_same_far_from_the_origin() {
    let place = Workplace::new("far");
    assert_eq!(place.run(&["run", "tug.toml", "--out", "near"]).code, 0);
    let far = support::TUG
        .replace("position = [0, 20]", "position = [6400000, 500020]")
        .replace("position = [3, 2]", "position = [6400003, 500002]");
    place.write("far.toml", far.as_bytes());
    assert_eq!(place.run(&["run", "far.toml", "--out", "far"]).code, 0);
    let [near, far] = ["near", "far"].map(|out| {
        let summary = place.json(&format!("{out}/summary.json"));
        summary["pairs"][0]["peak_normal_force_n"].as_f64().expect("a force")
    });
    assert!((near - far).abs() < 1e-6 * near, "{near} and {far}");
    assert!(!place.text("far/report.html").contains("NaN"));
}

#[test]
fn a_killed_run_leaves_only_part_files_and_the_next_one_clears_them() {
    let place = Workplace::new("killed");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    let mut child = place.spawn(&["run", "tug.toml", "--step", "1e-5", "--duration", "1000"]);
    place.wait_for("out/tug/bodies.csv.part");
    child.kill().expect("the child runs");
    child.wait().expect("the child ends");
    let files = place.files("out/tug");
    let is_left = |name: &String| name.ends_with(".part") || name == ".fenderline.lock";
    assert!(!files.is_empty() && files.iter().all(is_left), "{files:?}");
    assert_eq!(place.run(&["run", "tug.toml"]).code, 0);
    assert!(!place.files("out/tug").iter().any(is_left));
}

#[test]
fn two_runs_do_not_write_to_one_folder_at_once() {
    let place = Workplace::new("locked");
    let mut first = place.spawn(&["run", "tug.toml", "--step", "1e-5", "--duration", "1000"]);
    place.wait_for("out/tug/bodies.csv.part");
    let second = place.run(&["run", "tug.toml"]);
    first.kill().expect("the child runs");
    first.wait().expect("the child ends");
    assert_eq!(second.code, 2, "{}", second.stderr);
    contains_all(&second.stderr, &["another run"]);
}

#[test]
fn an_endless_file_is_refused() {
    let place = Workplace::new("endless");
    let big = vec![b'#'; (16 << 20) + 1];
    place.write("big.toml", &big);
    let run = place.run(&["check", "big.toml"]);
    assert_eq!(run.code, 2);
    contains_all(&run.stderr, &["big.toml", "MiB"]);
    fs::remove_file(place.path("big.toml")).expect("it is there");
}

/// Steps of an engine that a simulator recorded and sent.
#[test]
fn a_dump_of_an_engine_is_replayed_to_the_same_bits() {
    let place = Workplace::new("dump");
    let path = place.path("tug.toml");
    let overrides = [Override::parse("contact.method=coupled").expect("a key")];
    let scenario = Scenario::load(&path, &overrides).expect("a good scenario");
    let mut engine = Engine::from_scenario(scenario, &Settings::default()).expect("good settings");
    engine.record(50).expect("not too many");
    let mut states = engine.initial_states().to_vec();
    for _ in 0..60 {
        engine.advance(&states, None, 0.1).expect("good states");
        states.copy_from_slice(engine.results().expect("stepped").states_after);
    }
    engine.step(-1.0).expect_err("a step back");
    let dump = engine.dump().expect("recorded");
    place.write("steps.dump", &dump);
    let run = place.run(&["replay", "steps.dump"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    contains_all(
        &run.stdout,
        &["61 steps", "1 refused", "all steps gave the same bits as recorded"],
    );
    contains_all(&run.stderr, &["step 61 of 61, of -1 s, is refused"]);
    place.write("cut.dump", &dump[..dump.len() / 2]);
    let run = place.run(&["replay", "cut.dump"]);
    assert_eq!(run.code, 2);
    contains_all(&run.stderr, &["cut.dump", "checksum"]);
}
