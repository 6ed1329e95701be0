//! `cargo xtask circles`: checks that no files of a crate `use` each other in a circle.
//!
//! The check is a text scan, not a compiler: it reads the `use` declarations and the paths that are written out in code
//! (`super::item()`), outside `mod tests` and comments. From each path the scan takes the longest part that names a
//! file. A re-export of a child module (`pub use child::Item;`) does not count as a use.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::step::{Done, Step};

/// This step belongs to `cargo xtask test all`.
pub(crate) const STEP: Step = Step { name: "no circles of files", run: circles };

/// A file by its module path; the path of the crate's root is empty.
type Module = Vec<String>;

fn circles() -> Result<Done, String> {
    let mut faults = String::new();
    for folder in crates()? {
        let name = folder.display();
        let sources = sources(&folder.join("src"))?;
        let uses = uses(&sources);
        for circle in components(&uses) {
            faults += &format!("{name}: a circle of {} files:\n", circle.len());
            for file in &circle {
                for used in uses[file].intersection(&circle) {
                    faults += &format!("  {} uses {}\n", text(file), text(used));
                }
            }
        }
    }
    if faults.is_empty() { Ok(Done::Good) } else { Err(faults) }
}

/// Folders of the crates that are scanned: all in `crates`, and `xtask`.
fn crates() -> Result<Vec<PathBuf>, String> {
    const CRATES: &str = "crates";
    let failed = |e| format!("{CRATES}: {e}");
    let entries = fs::read_dir(CRATES).map_err(failed)?;
    let mut folders = vec![PathBuf::from("xtask")];
    for entry in entries {
        let folder = entry.map_err(failed)?.path();
        if folder.join("Cargo.toml").is_file() {
            folders.push(folder);
        }
    }
    folders.sort();
    Ok(folders)
}

fn text(module: &[String]) -> String {
    if module.is_empty() { "lib".to_owned() } else { module.join("::") }
}

/// The source text of each file of a crate, without `mod tests`.
fn sources(root: &Path) -> Result<BTreeMap<Module, String>, String> {
    let mut found = BTreeMap::new();
    let mut folders = vec![(root.to_owned(), Module::new())];
    while let Some((folder, module)) = folders.pop() {
        let entries = fs::read_dir(&folder).map_err(|e| format!("{}: {e}", folder.display()))?;
        for entry in entries {
            let path = entry.map_err(|e| format!("{}: {e}", folder.display()))?.path();
            let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            let mut of = module.clone();
            if path.is_dir() {
                of.push(stem);
                folders.push((path, of));
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                if !matches!(stem.as_str(), "lib" | "main" | "mod") {
                    of.push(stem);
                }
                let source =
                    fs::read_to_string(&path).map_err(|e| format!("{}: {e}", path.display()))?;
                let source = source.split("#[cfg(test)]\nmod ").next().unwrap_or_default();
                found.insert(of, source.to_owned());
            }
        }
    }
    Ok(found)
}

/// For each file of a crate, the files that it uses.
fn uses(sources: &BTreeMap<Module, String>) -> BTreeMap<Module, BTreeSet<Module>> {
    let of_file = |(module, source): (&Module, &String)| {
        let mut used = BTreeSet::new();
        for (is_public, tree) in declarations(source) {
            for path in paths(&tree) {
                used.extend(target(module, &path, is_public, sources));
            }
        }
        for path in written_out(source) {
            used.extend(target(module, &path, false, sources));
        }
        used.remove(module);
        (module.clone(), used)
    };
    sources.iter().map(of_file).collect()
}

/// The `use` declarations of a source text: whether each re-exports, and its tree of names without white space.
fn declarations(source: &str) -> Vec<(bool, String)> {
    let mut found = Vec::new();
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        let line = line.trim_start();
        let (is_public, rest) = match line.split_once("use ") {
            Some(("", rest)) => (false, rest),
            Some((before, rest)) if before.starts_with("pub") && !before.contains("fn") => {
                (true, rest)
            }
            _ => continue,
        };
        let mut tree = rest.to_owned();
        while !tree.contains(';') {
            let Some(next) = lines.next() else { break };
            tree += next;
        }
        let tree = tree.split(';').next().unwrap_or_default();
        found.push((is_public, tree.chars().filter(|c| !c.is_whitespace()).collect()));
    }
    found
}

/// The paths that begin with `crate::` or `super::` in the code of a source, without its comments and
/// `use` declarations.
fn written_out(source: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut in_use = false;
    for line in source.lines() {
        let code = line.split("//").next().unwrap_or_default();
        let begins = code.trim_start();
        in_use |=
            begins.starts_with("use ") || begins.starts_with("pub") && begins.contains(" use ");
        if in_use {
            in_use = !code.contains(';');
            continue;
        }
        // Who may see an item is no use of it.
        let code = code.replace("pub(in crate::", "pub(in ");
        let is_of_path = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == ':';
        let words = code.split(|c: char| !is_of_path(c));
        let paths = words.filter(|word| word.starts_with("crate::") || word.starts_with("super::"));
        found.extend(paths.map(str::to_owned));
    }
    found
}

/// The single paths in a `use` tree such as `a::{b, c::{d, e}}`.
fn paths(tree: &str) -> Vec<String> {
    let Some((head, body)) = tree.split_once('{') else { return vec![tree.to_owned()] };
    let body = body.strip_suffix('}').unwrap_or(body);
    let mut items = vec![String::new()];
    let mut depth = 0;
    for c in body.chars() {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        match (c, depth) {
            (',', 0) => items.push(String::new()),
            _ => items.last_mut().expect("it begins with one").push(c),
        }
    }
    let items = items.iter().filter(|item| !item.is_empty());
    items.flat_map(|item| paths(item)).map(|path| format!("{head}{path}")).collect()
}

/// The file that a path in the file `module` leads to; `None` outside the crate and for a re-export of a child.
fn target(
    module: &Module,
    path: &str,
    is_public: bool,
    sources: &BTreeMap<Module, String>,
) -> Option<Module> {
    let mut segments = path.split("::").peekable();
    let mut at = match segments.peek() {
        Some(&"crate") => Module::new(),
        Some(&("self" | "super")) => module.clone(),
        Some(first) if sources.contains_key(&child(module, first)) => module.clone(),
        _ => return None,
    };
    while let Some(step @ ("crate" | "self" | "super")) = segments.peek().copied() {
        if step == "super" {
            at.pop();
        }
        segments.next();
    }
    if is_public && at == *module {
        return None;
    }
    for segment in segments {
        let below = child(&at, segment);
        if !sources.contains_key(&below) {
            break;
        }
        at = below;
    }
    Some(at)
}

fn child(module: &[String], name: &str) -> Module {
    module.iter().cloned().chain([name.to_owned()]).collect()
}

/// Sets of two or more files in which each file uses every other, directly or by way of further files.
fn components(uses: &BTreeMap<Module, BTreeSet<Module>>) -> Vec<BTreeSet<Module>> {
    let reached: BTreeMap<&Module, BTreeSet<Module>> = uses
        .keys()
        .map(|from| {
            let mut reached = BTreeSet::new();
            let mut open: Vec<&Module> = vec![from];
            while let Some(next) = open.pop() {
                for used in uses.get(next).into_iter().flatten() {
                    if reached.insert(used.clone()) {
                        open.push(used);
                    }
                }
            }
            (from, reached)
        })
        .collect();
    let mut found = BTreeSet::new();
    for (from, of) in &reached {
        let circle = |other: &&Module| of.contains(*other) && reached[*other].contains(*from);
        let all: BTreeSet<Module> = uses.keys().filter(circle).cloned().collect();
        if all.len() > 1 {
            found.insert(all);
        }
    }
    found.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(files: &[(&str, &str)]) -> Vec<BTreeSet<Module>> {
        let module = |path: &str| -> Module {
            path.split("::").filter(|part| !part.is_empty()).map(str::to_owned).collect()
        };
        let sources =
            files.iter().map(|(path, source)| (module(path), (*source).to_owned())).collect();
        components(&uses(&sources))
    }

    #[test]
    fn a_circle_through_a_nested_use_is_found() {
        let found = of(&[
            ("", "mod a;\nmod b;\nuse a::run;"),
            ("a", "use crate::{\n    b::c::{Deep, Deeper},\n};"),
            ("b", ""),
            ("b::c", "use super::super::a::Item;"),
        ]);
        let files: Vec<Vec<String>> =
            found.iter().map(|circle| circle.iter().map(|file| text(file)).collect()).collect();
        assert_eq!(files, [["a", "b::c"]]);
    }

    #[test]
    fn who_may_see_an_item_does_not_count() {
        let of_child = |child: &str| of(&[("a", "use b::Item;\nmod b;"), ("a::b", child)]);
        assert!(of_child("pub(in crate::a) struct Item;").is_empty());
        assert_eq!(of_child("pub(in crate::a) struct Item(crate::a::Other);").len(), 1);
    }

    #[test]
    fn a_re_export_does_not_count() {
        assert!(of(&[("", "pub use a::Item;\nmod a;"), ("a", "use super::Shared;")]).is_empty());
        assert_eq!(of(&[("", "use a::Item;\nmod a;"), ("a", "use super::Shared;")]).len(), 1);
    }
}
