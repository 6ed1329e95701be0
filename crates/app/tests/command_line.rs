//! The command line as its users know it from other programs: standard input, quiet, JSON, completions, manual pages, colours,
//! progress, lists and examples.

#![allow(clippy::disallowed_methods, reason = "what is expected, not what is computed")]

use crate::support;

use serde_json::Value;
use support::{TUG, Workplace, contains_all};

fn json(text: &str) -> Value {
    serde_json::from_str(text).unwrap_or_else(|e| panic!("{e}: {text}"))
}

#[test]
fn a_scenario_from_standard_input_gives_the_results_of_its_file() {
    let place = Workplace::new("stdin");
    let run = place.shell("\"$FENDERLINE\" run - < tug.toml && \"$FENDERLINE\" run tug.toml");
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(place.read("out/stdin/bodies.csv"), place.read("out/tug/bodies.csv"));
    let piped = place.shell("cat tug.toml | \"$FENDERLINE\" check - --set time.step=0.2");
    assert_eq!(piped.code, 0, "{}", piped.stderr);
    contains_all(&piped.stdout, &["stdin: good; 2 bodies", "50 steps"]);
    let report = place.shell("\"$FENDERLINE\" report - < tug.toml");
    assert_eq!(report.code, 0, "{}", report.stderr);
    assert!(place.exists("stdin.html"));
    let fmu = place.shell("\"$FENDERLINE\" fmu - --kind engine -o x.fmu < tug.toml");
    assert_eq!(fmu.code, 0, "{}", fmu.stderr);
    // A file that the scenario names lies in the current folder.
    place.write("own.toml", format!("fender_files = [\"none.toml\"]\n{TUG}").as_bytes());
    let missing = place.shell("\"$FENDERLINE\" check - < own.toml");
    assert_eq!(missing.code, 2);
    contains_all(&missing.stderr, &["none.toml", "stdin:1:"]);
}

#[test]
fn standard_input_that_is_no_scenario_is_refused() {
    let place = Workplace::new("bad_stdin");
    place.write("broken.toml", b"title = \"x\"\n[time\n");
    let broken = place.shell("\"$FENDERLINE\" check - < broken.toml");
    assert_eq!(broken.code, 2);
    contains_all(&broken.stderr, &["--> stdin:2:6"]);
    let latin = place.shell("printf 'a\\n\\xe9' | \"$FENDERLINE\" check -");
    assert_eq!(latin.code, 2);
    contains_all(&latin.stderr, &["cannot read stdin: line 2 is not UTF-8 text"]);
    let endless = place.shell("yes '# x' | \"$FENDERLINE\" run -");
    assert_eq!(endless.code, 2);
    contains_all(&endless.stderr, &["stdin: it is larger than the 16 MiB"]);
    for command in ["serve -", "campaign -", "replay -", "vessels --file -"] {
        let refused = place.shell(&format!("\"$FENDERLINE\" {command} < tug.toml"));
        assert_eq!(refused.code, 2, "{command}");
        contains_all(&refused.stderr, &["does not read standard input"]);
    }
    assert!(!place.exists("out"));
}

#[test]
fn standard_output_is_no_place_for_files() {
    let place = Workplace::new("out_dash");
    for (command, words) in [
        ("run tug.toml --out -", "needs a folder and not standard output"),
        ("campaign x.toml --out -", "needs a folder"),
        ("validate --out -", "needs a folder"),
        ("manoeuvre kcs --out -", "needs a folder"),
        ("serve tug.toml --sessions -", "needs a folder"),
        ("man --out -", "needs a folder"),
        ("run tug.toml --pdf -", "cannot be written to standard output"),
        ("run tug.toml --xlsx -", "cannot be written to standard output"),
        ("report tug.toml --html -", "cannot be written to standard output"),
        ("fmu tug.toml --kind engine -o -", "cannot be written to standard output"),
        ("fender fit tug.toml -o - --height 1", "cannot be written to standard output"),
        ("init -o -", "cannot be written to standard output"),
    ] {
        let refused = place.run(&command.split(' ').collect::<Vec<_>>());
        assert_eq!(refused.code, 2, "{command}: {}", refused.stdout);
        contains_all(&refused.stderr, &["error: invalid value '-'", words, "./-"]);
    }
    assert_eq!(place.files("."), ["berth.toml", "tug.toml"]);
    // As with other programs, a path reaches such a folder.
    assert_eq!(place.run(&["run", "tug.toml", "--out", "./-"]).code, 0);
    assert!(place.exists("./-/summary.json"));
}

#[test]
fn quiet_prints_errors_and_answers_only() {
    let place = Workplace::new("quiet");
    // Its outline runs clockwise, which is a notice.
    let turned = TUG.replace(
        "[[-100, 0], [100, 0], [100, 5], [-100, 5]]",
        "[[-100, 5], [100, 5], [100, 0], [-100, 0]]",
    );
    place.write("turned.toml", turned.as_bytes());
    let commands = ["run turned.toml", "check turned.toml", "report turned.toml", "init -o x.toml"];
    for command in commands {
        for quiet in [format!("{command} --quiet"), format!("-q {command}")] {
            let run = place.run(&quiet.split(' ').collect::<Vec<_>>());
            assert_eq!(run.code, 0, "{quiet}: {}", run.stderr);
            assert_eq!((run.stdout.as_str(), run.stderr.as_str()), ("", ""), "{quiet}");
            let _ = std::fs::remove_file(place.path("x.toml"));
        }
    }
    // The notice is in the results.
    assert!(place.json("out/turned/summary.json")["notices"][0].is_string());
    let bad = place.run(&["run", "-q", "tug.toml", "--step", "-1"]);
    assert_eq!(bad.code, 2);
    contains_all(&bad.stderr, &["error: "]);
    for command in ["vessels", "fenders", "columns", "schema", "init"] {
        assert!(place.run(&[command, "-q"]).stdout.len() > 100, "{command}");
    }
}

#[test]
fn json_is_the_whole_of_standard_output() {
    let place = Workplace::new("json");
    let run = place.run(&["run", "tug.toml", "--json", "--xlsx", "x.xlsx"]);
    assert_eq!(run.code, 0, "{}", run.stderr);
    assert_eq!(json(&run.stdout), place.json("out/tug/summary.json"));
    let check = json(&place.run(&["check", "berth.toml", "--json"]).stdout);
    assert_eq!(check["good"], true);
    assert_eq!(check["bodies"], serde_json::json!(["quay", "ship"]));
    assert_eq!(check["fenders"].as_array().map(Vec::len), Some(3));
    assert_eq!(check["steps"], 600);
    place.write("odd.toml", TUG.replace("stiffness = \"500", "stifness = \"500").as_bytes());
    let refused = place.run(&["check", "odd.toml", "--json"]);
    assert_eq!(refused.code, 2);
    let error = &json(&refused.stdout)["error"];
    let line = TUG.lines().position(|line| line.starts_with("stiffness")).expect("it is there") + 1;
    assert_eq!((&error["line"], &error["file"]), (&line.into(), &"odd.toml".into()));
    assert_eq!(error["key"], "material.rubber.stifness");
    contains_all(&refused.stderr, &["error: "]);
    let none = place.run(&["check", "none.toml", "--json"]);
    assert_eq!((none.code, &json(&none.stdout)["good"]), (2, &false.into()));
    for command in [&["vessels"][..], &["columns"], &["init", "--list"], &["fenders", "cone"]] {
        json(&place.run(&[command, &["--json"]].concat()).stdout);
    }
}

/// A ship that starts inside a fender: told before the run, and with its results; refused where the user asks for that.
#[test]
fn a_ship_that_starts_inside_a_fender_is_reported_everywhere() {
    let place = Workplace::new("start_inside");
    let inside = support::BERTH.replace("position = [0, -18.5]", "position = [0, -15.2]");
    place.write("inside.toml", inside.as_bytes());
    let check = place.run(&["check", "inside.toml"]);
    let notice = check.stderr.lines().find(|line| line.contains(" starts compressed "));
    let said = notice.expect("a notice").trim_start_matches("notice: ");
    let run = place.run(&["run", "inside.toml", "--allow-failures"]);
    contains_all(&run.stderr, &[said]);
    for file in ["out/inside/summary.json", "out/inside/report.html"] {
        contains_all(&place.text(file), &[said]);
    }
    std::fs::remove_dir_all(place.path("out")).expect("the results");
    let found = json(&place.run(&["check", "inside.toml", "--json"]).stdout);
    let notices = found["notices"].as_array().expect("notices");
    assert!(notices.iter().any(|notice| notice["message"] == said), "{notices:?}");
    for command in [&["check"][..], &["run"], &["check", "--json"]] {
        let refused = place.run(&[command, &["inside.toml", "--strict"]].concat());
        assert_eq!(refused.code, 2, "{command:?}");
        contains_all(&refused.stderr, &["which --strict does not permit"]);
    }
    assert!(!place.exists("out"));
    assert_eq!(place.run(&["run", "tug.toml", "--strict"]).code, 0);
}

#[test]
fn the_fender_library_is_listed_with_its_performance() {
    let place = Workplace::new("fenders_list");
    let list = place.run(&["fenders"]);
    assert_eq!(list.code, 0, "{}", list.stderr);
    contains_all(&list.stdout, &["cone:", "pneumatic:", "3300x6500 50kPa", "3015", "bulk carrier"]);
    let all = json(&place.run(&["fenders", "--json"]).stdout);
    let families = all["families"].as_array().expect("families");
    let pneumatic = families.iter().find(|family| family["name"] == "pneumatic").expect("it");
    let sizes = pneumatic["sizes"].as_array().expect("sizes");
    let size = sizes.iter().find(|size| size["size"] == "3300x6500 50kPa").expect("the size");
    // ISO 17357-1 has 3015 kN.
    assert_eq!(size["rated_reaction_n"], 3_015_000.0);
    let family = place.run(&["fenders", "cone"]);
    contains_all(&family.stdout, &["curve", "unloading: 55 %", "temperature", "[found]"]);
    let size = place.run(&["fenders", "pneumatic", "3300x6500 50kPa"]);
    contains_all(&size.stdout, &["3015 kN", "rated energy", "deflection m, reaction kN"]);
    for (arguments, words) in [
        (&["fenders", "pneumatc"][..], "did you mean \"pneumatic\"?"),
        (&["fenders", "pneumatic", "3300x6500"], "help: "),
        (&["fenders", "--file", "none.toml"], "none.toml"),
    ] {
        let refused = place.run(arguments);
        assert_eq!(refused.code, 2, "{arguments:?}");
        contains_all(&refused.stderr, &[words]);
    }
    let own = include_str!("../../../fenders/cone.toml").replace("[family.cone", "[family.mine");
    place.write("mine.toml", own.as_bytes());
    contains_all(&place.run(&["fenders", "--file", "mine.toml"]).stdout, &["mine:"]);
}

#[test]
fn an_example_is_a_good_scenario_and_replaces_no_file() {
    let place = Workplace::new("init");
    let names = json(&place.run(&["init", "--list", "--json"]).stdout);
    let names = names.as_array().expect("a list");
    assert!(names.len() > 4);
    for name in names {
        let name = name["name"].as_str().expect("a name");
        let file = format!("{name}.toml");
        let written = place.run(&["init", name, "-o", &file]);
        assert_eq!(written.code, 0, "{}", written.stderr);
        assert_eq!(place.run(&["init", name]).stdout, place.text(&file));
        let check = place.run(&["check", &file]);
        assert_eq!(check.code, 0, "{name}: {}", check.stderr);
    }
    let again = place.run(&["init", "tugs", "-o", "berthing.toml"]);
    assert_eq!(again.code, 2);
    contains_all(&again.stderr, &["berthing.toml: the file exists already"]);
    assert_eq!(place.run(&["init"]).stdout, place.text("berthing.toml"));
    assert_eq!(place.run(&["init", "berthng"]).code, 2);
}

/// The made-up harbour as a converted chart: the berth on its quay line is a good scenario.
#[test]
fn a_harbour_on_a_chart_is_a_good_scenario() {
    let place = Workplace::new("init-harbour");
    let bare = "[chart]\nfiles = [\"bend.geojson\"]\ncoordinates = \"metres\"\n";
    place.write("chart.toml", bare.as_bytes());
    let chart = include_bytes!("../../../scenarios/harbours/bend.geojson");
    place.write("bend.geojson", chart);
    let of = |berth: &str| place.run(&["init", "harbour", "--chart", ".", "--berth", berth]);
    let out = ["init", "harbour", "--chart", ".", "--berth", "Long Quay", "-o", "call.toml"];
    let written = place.run(&out);
    assert_eq!(written.code, 0, "{}", written.stderr);
    let check = place.run(&["check", "call.toml"]);
    assert_eq!(check.code, 0, "{}", check.stderr);
    contains_all(
        &place.text("call.toml"),
        &["quay_line = { name = \"Long Quay\" }", "[body.ship]"],
    );
    for (berth, why) in [
        ("Lang Quay", "the chart has \"Long Quay\""),
        ("500,1300,500", "four numbers"),
        ("500,1300,300,1700", "no such line within 25 m"),
    ] {
        let refused = of(berth);
        assert_eq!(refused.code, 2, "{berth}");
        contains_all(&refused.stderr, &[why]);
    }
    assert_eq!(place.run(&["init", "harbour"]).code, 2);
    assert_eq!(place.run(&["init", "tugs", "--chart", ".", "--berth", "a"]).code, 2);
}

#[test]
fn serve_says_error_once_for_a_mistake_in_a_scenario() {
    let place = Workplace::new("serve-mistake");
    place.write("bad.toml", b"[time]\nstep = 1\nduration = 1\n[body.a]\nmas = 1\n");
    let refused = place.run(&["serve", "bad.toml", "--port", "0"]);
    assert_eq!(refused.code, 2, "{}", refused.stderr);
    assert!(refused.stderr.starts_with("error: `body.a.mas` is not a key"), "{}", refused.stderr);
    assert_eq!(refused.stderr.matches("error:").count(), 1, "{}", refused.stderr);
}

#[test]
fn completions_and_manual_pages_know_every_command() {
    let place = Workplace::new("man");
    let help = place.run(&["--help"]).stdout;
    let names: Vec<&str> = help
        .split_once("Commands:")
        .expect("a list of commands")
        .1
        .lines()
        .skip(1)
        .take_while(|line| !line.trim().is_empty())
        .filter_map(|line| line.split_whitespace().next())
        .collect();
    assert!(names.contains(&"run") && names.contains(&"fenders"), "{names:?}");
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let script = place.run(&["completions", shell]);
        assert_eq!((script.code, script.stderr.as_str()), (0, ""), "{shell}");
        contains_all(&script.stdout, &names);
    }
    let script = place.shell(
        "source <(\"$FENDERLINE\" completions bash) && COMP_WORDS=(fenderline ca) COMP_CWORD=1 && \
         _fenderline fenderline ca fenderline && echo \"${COMPREPLY[@]}\"",
    );
    assert_eq!(script.stdout.trim(), "campaign", "{}", script.stderr);
    assert_eq!(place.run(&["man", "--out", "man1"]).code, 0);
    for name in names.iter().filter(|name| **name != "help") {
        contains_all(&place.text(&format!("man1/fenderline-{name}.1")), &[".TH", ".SH OPTIONS"]);
    }
    assert_eq!(place.run(&["man"]).stdout, place.text("man1/fenderline.1"));
    let fit = place.run(&["man", "fender", "fit"]).stdout;
    assert_eq!(fit, place.text("man1/fenderline-fender-fit.1"));
    let unknown = place.run(&["man", "rnu"]);
    assert_eq!(unknown.code, 2);
    contains_all(&unknown.stderr, &["no command `rnu`", "run, "]);
}

#[test]
fn errors_are_coloured_only_where_colours_are_wanted() {
    let place = Workplace::new("colours");
    let error = |environment: &str| {
        place.shell(&format!("{environment} \"$FENDERLINE\" check tug.toml --step -1")).stderr
    };
    let plain = error("");
    assert!(!plain.contains('\u{1b}'), "{plain}");
    let forced = error("CLICOLOR_FORCE=1");
    contains_all(&forced, &["\u{1b}[1m\u{1b}[31merror:\u{1b}[0m", "\u{1b}[34m-->"]);
    assert_eq!(error("NO_COLOR=1 CLICOLOR_FORCE=0"), plain);
    assert_eq!(error("NO_COLOR=1"), plain);
}

/// The program on a terminal of its own, by `script` of util-linux; `None` if that is missing.
/// Without `CI`, which asks for colours whatever the terminal is.
fn on_a_terminal(place: &Workplace, line: &str) -> Option<String> {
    if place.shell("script --version").code != 0 {
        assert!(std::env::var_os("CI").is_none(), "script of util-linux is missing in CI");
        println!("skipped: script of util-linux is missing");
        return None;
    }
    let run =
        place.shell(&format!("env -u CI script --quiet --return --command '{line}' /dev/null"));
    Some(run.stdout)
}

#[cfg(target_os = "linux")]
#[test]
fn a_terminal_shows_the_rate_and_the_time_left_and_colours() {
    let place = Workplace::new("terminal");
    let long = "\"$FENDERLINE\" run tug.toml --step 1e-5 --duration 30";
    let Some(shown) = on_a_terminal(&place, &format!("TERM=xterm COLUMNS=100 {long}")) else {
        return;
    };
    contains_all(&shown, &["% of 3000000 steps, ", "steps/s, ", " left"]);
    let quiet = on_a_terminal(&place, &format!("TERM=xterm {long} --quiet")).expect("as above");
    assert_eq!(quiet, "");
    let validate = "TERM=xterm COLUMNS=100 \"$FENDERLINE\" validate";
    let shown = on_a_terminal(&place, validate).expect("as above");
    contains_all(&shown, &["% of 31 parts, ", "parts/s, ", " left"]);
    let bad = "\"$FENDERLINE\" check tug.toml --step -1";
    let coloured = on_a_terminal(&place, &format!("TERM=xterm {bad}")).expect("as above");
    contains_all(&coloured, &["\u{1b}[31merror:"]);
    for environment in ["TERM=xterm NO_COLOR=1", "TERM=dumb"] {
        let plain = on_a_terminal(&place, &format!("{environment} {bad}")).expect("as above");
        assert!(plain.contains("error:") && !plain.contains('\u{1b}'), "{environment}: {plain:?}");
    }
}
