//! `fenderline fmu`: what it writes and what it refuses. What masters make of it: `crates/fmu/hosts`.

use crate::support;

use support::{Workplace, contains_all};

/// With the library that cargo puts beside the program.
fn fmu(place: &Workplace, more: &[&str]) -> support::Run {
    let mut arguments = vec!["fmu", "tug.toml"];
    arguments.extend_from_slice(more);
    place.run(&arguments)
}

#[test]
fn the_same_scenario_gives_the_same_bytes() {
    let place = Workplace::new("fmu_bytes");
    for kind in ["engine", "simulation"] {
        let first = fmu(&place, &["--kind", kind, "-o", "a/x.fmu"]);
        assert_eq!(first.code, 2, "there is no folder `a`");
        contains_all(&first.stderr, &["error: cannot write", "x.fmu"]);
        place.write("a/here", b"");
        place.write("b/here", b"");
        for folder in ["a", "b"] {
            let done = fmu(&place, &["--kind", kind, "-o", &format!("{folder}/x.fmu")]);
            assert_eq!(done.code, 0, "{}", done.stderr);
            contains_all(&done.stdout, &[kind, "A tug at a quay", "FMI 2.0", "platforms: "]);
        }
        assert_eq!(place.files("a"), ["here", "x.fmu", "x_OspModelDescription.xml"]);
        assert_eq!(place.read("a/x.fmu"), place.read("b/x.fmu"));
        contains_all(&place.text("a/x_OspModelDescription.xml"), &["name=\"tug.position\""]);
        std::fs::remove_dir_all(place.path("a")).expect("the folder");
    }
    let three = fmu(&place, &["--kind", "engine", "--fmi", "3", "-o", "three.fmu"]);
    contains_all(&three.stdout, &["FMI 3.0"]);
}

#[test]
fn changes_of_the_command_line_go_into_the_fmu() {
    let place = Workplace::new("fmu_changes");
    let plain = fmu(&place, &["--kind", "engine", "-o", "x.fmu"]);
    assert_eq!(plain.code, 0, "{}", plain.stderr);
    let before = place.read("x.fmu");
    let changed = fmu(&place, &["--kind", "engine", "--method", "coupled", "-o", "x.fmu"]);
    assert_eq!(changed.code, 0, "{}", changed.stderr);
    assert_ne!(place.read("x.fmu"), before);
    let refused = fmu(&place, &["--kind", "engine", "--set", "body.tug.mas=3", "-o", "y.fmu"]);
    assert_eq!(refused.code, 2);
    assert!(!place.exists("y.fmu"));
}

#[test]
fn inputs_that_are_refused_for_an_fmu() {
    let place = Workplace::new("fmu_refused");
    let text = format!(
        "{}\n[[provider]]\nbody = \"tug\"\ncommand = [\"python3\", \"drag.py\"]\n",
        support::TUG.replace("method = \"paper\"", "method = \"coupled\"")
    );
    place.write("tug.toml", text.as_bytes());
    let refused = fmu(&place, &["--kind", "simulation", "-o", "x.fmu"]);
    assert_eq!(refused.code, 2);
    contains_all(&refused.stderr, &["providers", "body.NAME.external_x_n"]);
    // The engine leaves loads to the host anyway.
    assert_eq!(fmu(&place, &["--kind", "engine", "-o", "x.fmu"]).code, 0);
    let no_library =
        place.run(&["fmu", "tug.toml", "--kind", "engine", "--library", "no.so", "-o", "y.fmu"]);
    assert_eq!(no_library.code, 1);
    contains_all(&no_library.stderr, &["error: cannot read no.so"]);
    assert_eq!(place.run(&["fmu", "tug.toml", "-o", "y.fmu"]).code, 2, "of which kind?");
    assert!(!place.exists("y.fmu"));
}

#[test]
fn a_program_without_its_library_says_what_builds_it() {
    let place = Workplace::new("fmu_alone");
    let copied =
        place.shell("cp \"$FENDERLINE\" . && ./fenderline fmu tug.toml --kind engine -o x.fmu");
    assert_eq!(copied.code, 1);
    let words = ["fenderline_fmu", "not beside it", "cargo xtask program", "--library PATH"];
    contains_all(&copied.stderr, &words);
    assert!(!place.exists("x.fmu"));
}

#[test]
fn a_library_that_makes_no_instance_is_not_packed() {
    let place = Workplace::new("fmu_libraries");
    let refused = |library: &str, words: &[&str]| {
        let options = ["--kind", "engine", "-o", "x.fmu", "--library", library];
        let refused = fmu(&place, &options);
        assert_eq!(refused.code, 1, "{}", refused.stderr);
        contains_all(&refused.stderr, &[library]);
        contains_all(&refused.stderr, words);
        assert!(!place.exists("x.fmu") && !place.exists("x_OspModelDescription.xml"));
    };
    place.write("text.so", b"some library");
    refused("text.so", &["not a shared library"]);
    // A library of another machine, and not of this version.
    let mut windows = b"MZ".to_vec();
    windows.resize(0x3c, 0);
    windows.extend(b"\x40\0\0\0PE\0\0\x64\x86");
    place.write("other.dll", &windows);
    refused("other.dll", &["not the FMU's library of this version"]);
    // The beginning of a file of this machine, without the library.
    let own = std::fs::read(support::PROGRAM).expect("the program");
    place.write("header.so", &own[..4096]);
    refused("header.so", &["not the FMU's library of this version"]);
    // A program is a file of the same form, and has the version in it.
    if cfg!(target_os = "linux") {
        place.write("program.so", &own);
        refused("program.so", &["cannot be loaded"]);
    }
}

#[test]
fn platforms_that_a_program_has_no_library_for_are_refused() {
    let place = Workplace::new("fmu_platforms");
    let missing =
        fmu(&place, &["--kind", "engine", "-o", "x.fmu", "--platforms", "aarch64-darwin"]);
    assert_eq!(missing.code, 2);
    contains_all(&missing.stderr, &["no library for aarch64-darwin", "it has ", "--library PATH"]);
    let unknown = fmu(&place, &["--kind", "engine", "-o", "x.fmu", "--platforms", "win64"]);
    assert_eq!(unknown.code, 2);
    contains_all(&unknown.stderr, &["x86_64-windows"]);
    assert!(!place.exists("x.fmu"));
}
