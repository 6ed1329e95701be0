//! Checks that the files and functions that documents name exist.
//!
//! - A code span of a Markdown file that looks like a path of the repository must be a path that exists. A code span
//!   with `…`, `*`, `<`, `{` or a word in capitals is a pattern, which is not checked.
//! - In `ARCHITECTURE.md` a code span `name()` must be a function, and a code span `Name` in a table's column must be a
//!   type, of a file that the same line names.
//! - A code span that is a name, such as `advance_in_place`, must occur in a source file.
//! - Code that cites a Markdown file must cite a file that exists.

use std::collections::BTreeSet;
use std::path::Path;

use crate::command::run_quietly;

/// Folders of the repository: a code span that begins with one of these names counts as a path.
const FOLDERS: [&str; 14] = [
    "benches",
    "crates",
    "docs",
    "examples",
    "fenders",
    "fuzz",
    "hydrodynamics",
    "include",
    "scenarios",
    "validation",
    "vessels",
    "web",
    "xtask",
    ".ci",
];
const MAP: &str = "ARCHITECTURE.md";
/// Names in documents that belong to other projects, and are not checked.
const OF_OTHERS: [&str; 3] = ["mjModel", "mjData", "fmi2Error"];
/// Documents that name files and functions of the past, and are not checked.
const OF_THE_PAST: [&str; 2] = ["CHANGELOG.md", "docs/before_0.1.0.md"];
/// The most words that `ARCHITECTURE.md` may have.
const MAP_WORDS: usize = 2000;

/// Checks all tracked files.
///
/// # Errors
/// Fails with all names of files and functions that do not exist, one on each line.
pub(crate) fn check() -> Result<(), String> {
    let listed = run_quietly(std::process::Command::new("git").args([
        "ls-files",
        "--cached",
        "--others",
        "--exclude-standard",
    ]))?;
    let texts: Vec<(&str, String)> = listed
        .lines()
        .filter_map(|name| Some((name, std::fs::read_to_string(name).ok()?)))
        .collect();
    let mut words = BTreeSet::new();
    for (_, text) in texts.iter().filter(|(name, _)| !name.ends_with(".md")) {
        words.extend(text.split(|c: char| !(c.is_alphanumeric() || c == '_')));
    }
    let mut dead = Vec::new();
    for (name, text) in &texts {
        match Path::new(name).extension().and_then(|extension| extension.to_str()) {
            Some("md") => {
                dead.extend(dead_in_document(name, text));
                dead.extend(unknown_names(name, text, &words));
            }
            Some("rs" | "py" | "toml" | "ts" | "h" | "c") => {
                dead.extend(dead_in_code(name, text));
            }
            _ => {}
        }
    }
    let map = read(MAP)?;
    let count = map.split_whitespace().count();
    if count > MAP_WORDS {
        dead.push(format!("{MAP} has {count} words, which are more than {MAP_WORDS}"));
    }
    dead.extend(map.lines().enumerate().flat_map(|(index, line)| {
        dead_functions(line, &|path| std::fs::read_to_string(path).ok()).into_iter().map(
            move |name| {
                format!("{MAP}:{}: none of the files that this line names has `{name}`", index + 1)
            },
        )
    }));
    if dead.is_empty() { Ok(()) } else { Err(dead.join("\n")) }
}

fn read(name: &str) -> Result<String, String> {
    std::fs::read_to_string(name).map_err(|e| format!("{name}: {e}"))
}

/// Paths in code spans of a Markdown text that are not in the repository. Documents of the past are left out.
fn dead_in_document(name: &str, text: &str) -> Vec<String> {
    if OF_THE_PAST.contains(&name) {
        return Vec::new();
    }
    let mut dead = Vec::new();
    let mut fenced = false;
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        }
        if fenced {
            continue;
        }
        for span in code_spans(line).filter(|span| is_path(span)) {
            let beside = Path::new(name).parent().unwrap_or(Path::new("")).join(span);
            if !Path::new(span).exists() && !beside.exists() && !is_ignored(span) {
                dead.push(format!("{name}:{}: no `{span}`", index + 1));
            }
        }
    }
    dead
}

/// Code spans that are names, such as `advance_in_place` or `PatchMemory`, and occur in no source.
fn unknown_names(name: &str, text: &str, words: &BTreeSet<&str>) -> Vec<String> {
    if OF_THE_PAST.contains(&name) {
        return Vec::new();
    }
    let is_name = |span: &&str| {
        let inner_capital =
            span.chars().skip(1).any(char::is_uppercase) && span.chars().any(char::is_lowercase);
        span.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
            && !span.starts_with('_')
            && (span.contains('_') || inner_capital)
    };
    let lines = text.lines().enumerate();
    lines
        .flat_map(|(index, line)| code_spans(line).map(move |span| (index + 1, span)))
        .map(|(line, span)| (line, span.strip_suffix("()").unwrap_or(span)))
        .filter(|(_, span)| is_name(span) && !words.contains(span) && !OF_OTHERS.contains(span))
        .map(|(line, span)| format!("{name}:{line}: no source has `{span}`"))
        .collect()
}

/// Whether git ignores a path, as it ignores build outputs.
fn is_ignored(path: &str) -> bool {
    let mut git = std::process::Command::new("git");
    run_quietly(git.args(["check-ignore", "--quiet", path])).is_ok()
}

/// Markdown files that a source file cites and that do not exist.
fn dead_in_code(name: &str, text: &str) -> Vec<String> {
    let mut dead = Vec::new();
    for (index, line) in text.lines().enumerate() {
        let words = line.split(|c: char| !(c.is_alphanumeric() || "/_-.".contains(c)));
        for word in words.filter(|word| word.starts_with("docs/") && word.ends_with(".md")) {
            if !Path::new(word).exists() && !word.contains("_generated") {
                dead.push(format!("{name}:{}: no {word}", index + 1));
            }
        }
    }
    dead
}

/// Functions and types that a line of `ARCHITECTURE.md` names and that none of the files on the line defines.
fn dead_functions(line: &str, source: &dyn Fn(&str) -> Option<String>) -> Vec<String> {
    let sources: Vec<String> =
        code_spans(line).filter(|span| is_path(span)).filter_map(source).collect();
    let defined = |keywords: &[&str], name: &str| {
        sources.iter().any(|text| {
            keywords.iter().any(|keyword| {
                text.match_indices(&format!("{keyword} {name}")).any(|(at, found)| {
                    !text[at + found.len()..].starts_with(|c: char| c.is_alphanumeric() || c == '_')
                })
            })
        })
    };
    code_spans(line)
        .filter(|span| match span.strip_suffix("()") {
            Some(function) => !defined(&["fn", "function", "def"], function),
            None => {
                let is_type = span.starts_with(|c: char| c.is_ascii_uppercase())
                    && span.chars().all(char::is_alphanumeric)
                    && span.contains(|c: char| c.is_ascii_lowercase());
                is_type
                    && !sources.is_empty()
                    && !defined(&["struct", "enum", "trait", "type", "static", "const"], span)
            }
        })
        .map(str::to_owned)
        .collect()
}

/// The texts between single backticks in a Markdown line.
fn code_spans(line: &str) -> impl Iterator<Item = &str> {
    line.split('`').skip(1).step_by(2)
}

/// Whether a code span names a file or folder of the repository and is not a pattern.
fn is_path(span: &str) -> bool {
    let is_pattern = span.contains(|c: char| c.is_whitespace() || "*…<{[()$:=".contains(c))
        || span.split(['/', '.']).any(|part| {
            part.len() > 1 && part.chars().all(|c| c.is_ascii_uppercase()) && part != "README"
        });
    !is_pattern
        && FOLDERS.iter().any(|folder| {
            span.strip_prefix(folder).is_some_and(|rest| rest.starts_with('/') && rest.len() > 1)
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_and_functions_that_documents_name_exist() {
        std::env::set_current_dir(crate::command::workspace_root()).expect("the workspace");
        assert_eq!(check(), Ok(()));
    }

    #[test]
    fn a_function_that_no_file_of_its_line_has_is_found() {
        let line = "| `crates/x.rs` | `step()`, `steps()`, `Model` |";
        let source = |_: &str| Some("pub fn steps() {}\nstruct Modelled;".to_owned());
        assert_eq!(
            dead_functions(line, &source),
            ["step", "Model"].map(|name| if name == "step" { "step()" } else { name })
        );
    }

    #[test]
    fn patterns_and_words_are_not_paths() {
        assert!(is_path("crates/contact/src/step.rs"));
        assert!(is_path("fenders/README.md"));
        assert!(!is_path("scenarios/<topic>/x.toml"));
        assert!(!is_path("docs/design/*.md"));
        assert!(!is_path("out/validation"));
        assert!(!is_path("validation/NAME.toml"));
    }
}
