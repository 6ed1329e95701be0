//! Decides whether a tag may be released: all files that name a version must name the tag's version, and the changelog
//! must have a section for this version, which becomes the text of the release.

use std::path::{Path, PathBuf};

use super::release::version;
use crate::command::{cargo, run_quietly};
use crate::virtual_environment::target_folder;

/// Files other than `Cargo.toml` that name the version, and the form of the line that names it.
const VERSIONS: [(&str, &str); 3] = [
    ("CITATION.cff", "version: VERSION"),
    ("crates/wasm/npm/package.json", "  \"version\": \"VERSION\","),
    ("crates/wasm/npm/package-lock.json", "  \"version\": \"VERSION\","),
];

/// Checks the tag `tag`, such as `v0.1.0`, writes the notes of the release, and returns the file of the notes.
///
/// # Errors
/// Fails for a file that names another version, and for a changelog without a section for the version.
pub(super) fn checked(tag: &str) -> Result<PathBuf, String> {
    let version = version()?;
    if tag != format!("v{version}") {
        return Err(format!("the tag is {tag}, but Cargo.toml has the version {version}"));
    }
    for (name, form) in VERSIONS {
        let wanted = form.replace("VERSION", &version);
        if !read(name)?.lines().any(|line| line == wanted) {
            return Err(format!("{name}: no line `{wanted}`"));
        }
    }
    run_quietly(&mut cargo(["metadata", "--format-version", "1", "--locked", "--no-deps"]))
        .map_err(|e| format!("Cargo.lock does not fit Cargo.toml: {e}"))?;
    let notes = section(&read("CHANGELOG.md")?, &version)?;
    let folder = target_folder();
    std::fs::create_dir_all(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
    let file = folder.join("release-notes.md");
    std::fs::write(&file, notes).map_err(|e| format!("{}: {e}", file.display()))?;
    Ok(file)
}

fn read(name: &str) -> Result<String, String> {
    std::fs::read_to_string(Path::new(name)).map_err(|e| format!("{name}: {e}"))
}

/// The text of a version's section in the changelog, whose heading must have a date.
fn section(changelog: &str, version: &str) -> Result<String, String> {
    let begin = format!("## [{version}] - ");
    let mut lines = changelog.lines();
    let heading = lines.by_ref().find(|line| line.starts_with(&begin));
    let date = heading.ok_or(format!("CHANGELOG.md has no section `{begin}YYYY-MM-DD`"))?;
    let date = &date[begin.len()..];
    let is_date = date.len() == 10
        && date.bytes().enumerate().all(|(index, byte)| match index {
            4 | 7 => byte == b'-',
            _ => byte.is_ascii_digit(),
        });
    if !is_date {
        return Err(format!(
            "CHANGELOG.md: the date of version {version} is `{date}`, but must have the form \
                            YYYY-MM-DD"
        ));
    }
    let text: Vec<&str> = lines.take_while(|line| !line.starts_with("## ")).collect();
    let text = text.join("\n").trim().to_owned();
    if text.is_empty() {
        return Err(format!("CHANGELOG.md: the section of version {version} is empty"));
    }
    Ok(format!("{text}\n"))
}

#[cfg(test)]
mod tests {
    use super::section;

    const CHANGELOG: &str = "# Changelog\n\n## [Unreleased]\n\n## [0.2.0] - 2027-01-31\n\nNew.\n\n### Added\n\n- a\n\n## [0.1.0] - soon\n\n";

    #[test]
    fn the_notes_are_the_section_of_the_version_alone() {
        assert_eq!(section(CHANGELOG, "0.2.0"), Ok("New.\n\n### Added\n\n- a\n".to_owned()));
    }

    #[test]
    fn a_version_without_a_date_or_a_section_is_refused() {
        assert!(section(CHANGELOG, "0.1.0").is_err_and(|why| why.contains("`soon`")));
        assert!(section(CHANGELOG, "0.3.0").is_err_and(|why| why.contains("no section")));
    }
}
