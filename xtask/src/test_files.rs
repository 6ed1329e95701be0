//! Checks that cargo compiles every test file: a crate with a `tests/all.rs` names its test files there, and a file
//! that is not named would never run.

use std::collections::BTreeSet;
use std::path::Path;

use crate::command::workspace_root;

#[test]
fn every_test_file_is_named_in_the_test_program_of_its_crate() {
    let crates = workspace_root().join("crates");
    let mut checked = 0;
    for entry in std::fs::read_dir(&crates).expect("the crates").flatten() {
        let tests = entry.path().join("tests");
        let Ok(all) = std::fs::read_to_string(tests.join("all.rs")) else { continue };
        let manifest = std::fs::read_to_string(entry.path().join("Cargo.toml")).expect("a crate");
        let named: BTreeSet<&str> = all
            .lines()
            .filter_map(|line| line.strip_prefix("mod ")?.strip_suffix(';'))
            .chain(
                manifest
                    .lines()
                    .filter_map(|line| line.strip_prefix("name = \"")?.strip_suffix('"')),
            )
            .collect();
        for file in
            std::fs::read_dir(&tests).expect("the tests").flatten().map(|entry| entry.path())
        {
            let name = file.file_stem().and_then(|name| name.to_str()).unwrap_or_default();
            if file.extension().is_some_and(|extension| extension == "rs") && name != "all" {
                let place = file.strip_prefix(&crates).map_or(file.as_path(), Path::new);
                assert!(
                    named.contains(name),
                    "add `mod {name};` to all.rs beside {}",
                    place.display()
                );
                checked += 1;
            }
        }
    }
    assert!(checked > 100, "{checked}");
}
