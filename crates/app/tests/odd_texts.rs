//! Names and numbers of users on the terminal: nothing that it would obey, no digits without end, places that are
//! those of the mistake.

use crate::support;

use support::{TUG, Workplace, contains_all};

/// A right-to-left override, an escape sequence, and one control character of eight bits.
const ODD: &str = "a\u{202e}b\u{2066}c\u{1b}[31md\u{9b}e";

#[test]
fn a_right_to_left_override_is_not_printed_raw() {
    let place = Workplace::new("override");
    let name = "t\u{202e}gu\u{2066}";
    place.write("bidi.toml", TUG.replace("tug", name).replace("A tug", "A \u{202e}tug").as_bytes());
    place.write(
        "wrong.toml",
        TUG.replace("[body.tug]", &format!("[body.tug]\n\"{name}\" = 1")).as_bytes(),
    );
    let file = format!("{name}.toml");
    place.write(&file, b"[time\n");
    let vessel = format!("[vessel.\"{name}\"]\nfrom = \"kcs\"\n");
    place.write("vessels.toml", vessel.as_bytes());
    let odd_set = format!("body.tug.mass={ODD}");
    let odd_key = format!("body.{name}.mass=1 t");
    for args in [
        &["run", "bidi.toml"][..],
        &["check", "bidi.toml"],
        &["check", "wrong.toml"],
        &["check", &file],
        &["check", "none\u{202e}.toml"],
        &["check", "tug.toml", "--set", &odd_set],
        &["check", "tug.toml", "--set", &odd_key],
        &["check", "tug.toml", name],
        &["run", "tug.toml", "--out", "bidi.toml/\u{202e}"],
        &["vessels", name],
        &["vessels", "--file", "vessels.toml"],
        &["vessels", "--file", "vessels.toml", "--json"],
        &["manoeuvre", name],
        &["replay", &file],
    ] {
        let run = place.run(args);
        let said = format!("{}{}", run.stdout, run.stderr);
        assert!(!said.is_empty(), "{args:?}");
        let is_bad = |c: char| {
            c != '\n'
                && (c.is_control() || ('\u{202a}'..='\u{2069}').contains(&c) && c != '\u{202f}')
        };
        let bad: Vec<char> = said.chars().filter(|c| is_bad(*c)).collect();
        assert!(bad.is_empty(), "{args:?}: {bad:?} in {said:?}");
    }
    // JSON keeps the value.
    let run = place.run(&["vessels", "--file", "vessels.toml", "--json"]);
    if run.code == 0 {
        contains_all(&run.stdout, &["t\\u202egu\\u2066"]);
    }
}

#[test]
fn a_number_of_1e308_is_not_printed_with_three_hundred_digits() {
    let place = Workplace::new("digits");
    place.write("curve.csv", b"deflection_mm,reaction_kn\n100,1e308\n200,80\n300,100\n400,150\n");
    place.write("good.csv", b"deflection_mm,reaction_kn\n100,40\n200,80\n300,100\n400,150\n");
    let far =
        TUG.replace("930 t", "1 kg") + "[[load]]\nbody = \"tug\"\nforce = [\"1e14 N\", \"0 N\"]\n";
    place.write("far.toml", far.as_bytes());
    let run = place.run(&["run", "far.toml", "--step", "100", "--duration", "1000"]);
    assert_eq!(run.code, 1, "{}", run.stderr);
    contains_all(&run.stderr, &["north position of body `tug` is 9.25", "e17"]);
    for args in [
        &["fender", "fit", "curve.csv", "--out", "f.toml", "--height", "1"][..],
        &["fender", "fit", "good.csv", "--out", "f.toml", "--height", "1e308"],
        &["fender", "fit", "good.csv", "--out", "f.toml", "--height", "1", "--tolerance", "1e308"],
        &[
            "fender",
            "fit",
            "good.csv",
            "--out",
            "f.toml",
            "--height",
            "1",
            "--rated-deflection",
            "1e308",
        ],
        &[
            "fender",
            "fit",
            "good.csv",
            "--out",
            "f.toml",
            "--height",
            "1",
            "--returned-energy",
            "1e308",
        ],
        &["check", "tug.toml", "--step", "1e308"],
        &["check", "tug.toml", "--duration", "1e308"],
        &["check", "tug.toml", "--set", "body.tug.mass=1e308"],
        &["check", "tug.toml", "--set", "material.rubber.friction_dynamic=1e308"],
        &["manoeuvre", "kcs", "--depth", "1e308"],
        &["manoeuvre", "kcs", "--speed", "1e308"],
        &["manoeuvre", "kcs", "--push", "1e308"],
        &["serve", "tug.toml", "--origin", "1e308,0"],
    ] {
        let run = place.run(args);
        // Water may be as deep as that: it is deep water.
        assert!(run.code == 2 || args.contains(&"--depth"), "{args:?}: {}", run.stderr);
        let said = format!("{}{}", run.stdout, run.stderr);
        assert!(!said.contains("00000000000000000000"), "{args:?}: {said}");
    }
}

#[test]
fn nesting_that_is_too_deep_is_reported_with_its_line() {
    let place = Workplace::new("nested");
    let deep = format!("{TUG}\n[body.other]\noutline = {}\n", "[".repeat(500));
    place.write("deep.toml", deep.as_bytes());
    let run = place.run(&["check", "deep.toml"]);
    assert_eq!(run.code, 2);
    let line =
        deep.lines().position(|line| line.starts_with("outline = [[[[")).expect("it is there") + 1;
    contains_all(&run.stderr, &["nested too deeply", &format!("deep.toml:{line}:91")]);
    let deep = format!("{TUG}\n{}x = 1\n", "a.".repeat(500));
    place.write("deep.toml", deep.as_bytes());
    let run = place.run(&["check", "deep.toml"]);
    assert_eq!(run.code, 2);
    let line = deep.lines().count();
    contains_all(&run.stderr, &["nested too deeply", &format!("deep.toml:{line}:160")]);
}

#[test]
fn a_csv_with_carriage_returns_alone_is_read() {
    let place = Workplace::new("carriage_returns");
    let curve = "deflection_mm,reaction_kn\n100,40\n200,80\n300,100\n400,150\n";
    let mut fitted = Vec::new();
    for end in ["\n", "\r\n", "\r"] {
        place.write("curve.csv", curve.replace('\n', end).as_bytes());
        let run =
            place.run(&["fender", "fit", "curve.csv", "--out", "fitted.toml", "--height", "1"]);
        assert_eq!(run.code, 0, "{end:?}: {}", run.stderr);
        fitted.push(place.text("fitted.toml"));
    }
    assert!(fitted[0] == fitted[1] && fitted[0] == fitted[2]);
}
