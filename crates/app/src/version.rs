//! What `fenderline --version` prints: the version, the commit, and the features that this program was built with.

use std::sync::LazyLock;

use crate::carried;

/// The commit, from the build script; empty if neither git nor the packager names a commit.
const COMMIT: &str = env!("FENDERLINE_COMMIT_OF_BUILD");
/// The cargo features that the program is built with, from the build script.
const CARGO_FEATURES: &str = env!("FENDERLINE_FEATURES_OF_BUILD");

/// Version, commit and features of the program, on one line each, for `--version`; `-V` prints the version alone.
pub(crate) fn long() -> &'static str {
    static LONG: LazyLock<String> = LazyLock::new(|| {
        let commit = if COMMIT.is_empty() { "not known" } else { COMMIT };
        let features = features();
        let features = if features.is_empty() { "none".to_owned() } else { features.join("; ") };
        format!("{}\ncommit: {commit}\nfeatures: {features}", env!("CARGO_PKG_VERSION"))
    });
    &LONG
}

/// Parts that a build of the program may have or lack, such as features.
fn features() -> Vec<String> {
    let mut features = Vec::new();
    if !CARGO_FEATURES.is_empty() {
        features.push(CARGO_FEATURES.to_owned());
    }
    if fenderline_serve::has_pages() {
        features.push("pages of `serve`".to_owned());
    }
    let platforms = carried::platforms();
    if !platforms.is_empty() {
        features.push(format!("libraries of FMUs for {}", platforms.join(", ")));
    }
    features
}
