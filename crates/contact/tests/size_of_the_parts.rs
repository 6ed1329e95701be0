//! The parts of the engine stay readable: no struct has more than 25 fields, and no function has more than 7
//! parameters. A tuple counts as many values as it holds, so that it cannot hide a long list.

use std::fs;
use std::path::{Path, PathBuf};

const MOST_FIELDS: usize = 25;
const MOST_PARAMETERS: usize = 7;

/// All source files below a folder.
fn sources(folder: &Path, into: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder of sources") {
        let path = entry.expect("an entry").path();
        if path.is_dir() {
            sources(&path, into);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            into.push(path);
        }
    }
}

/// The text without comments.
fn code(text: &str) -> String {
    text.lines().map(|line| line.split("//").next().unwrap_or("")).collect::<Vec<_>>().join("\n")
}

/// The text up to the bracket that closes the bracket just before the start.
fn within(text: &str) -> &str {
    let mut depth = 1;
    for (at, c) in text.char_indices() {
        match c {
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return &text[..at];
        }
    }
    text
}

/// The items of a list between commas, outside brackets.
fn items(list: &str) -> Vec<&str> {
    let (mut depth, mut from, mut before, mut all) = (0, 0, ' ', Vec::new());
    for (at, c) in list.char_indices() {
        match c {
            '(' | '{' | '[' | '<' => depth += 1,
            '>' if before == '-' => {}
            ')' | '}' | ']' | '>' => depth -= 1,
            ',' if depth == 0 => {
                all.push(list[from..at].trim());
                from = at + 1;
            }
            _ => {}
        }
        before = c;
    }
    all.push(list[from..].trim());
    all.retain(|item| !item.is_empty());
    all
}

/// The number of values in a type. A tuple counts the values of its parts.
fn values(kind: &str) -> usize {
    let kind = kind.trim().trim_start_matches('&').trim_start_matches("mut ").trim();
    match kind.strip_prefix('(').and_then(|rest| rest.strip_suffix(')')) {
        Some(parts) => items(parts).into_iter().map(values).sum(),
        None => 1,
    }
}

/// The number of values in a parameter.
fn parameters(parameter: &str) -> usize {
    // In the pattern of a tuple no part contains a colon.
    parameter.rfind(": ").map_or(1, |colon| {
        let first = parameter.find(": ").unwrap_or(colon);
        let of_pattern = parameter.starts_with('(').then(|| parameter.find("): ")).flatten();
        values(&parameter[of_pattern.map_or(first, |at| at + 1) + 2..])
    })
}

fn too_large(text: &str) -> Vec<String> {
    let text = code(text);
    let mut found = Vec::new();
    for (at, _) in text.match_indices("fn ") {
        let rest = &text[at + 3..];
        let Some(open) = rest.find('(') else { continue };
        let name = &rest[..open];
        if name.contains(['{', ';', ' ']) && !name.contains('<') {
            continue;
        }
        let count: usize = items(within(&rest[open + 1..])).into_iter().map(parameters).sum();
        if count > MOST_PARAMETERS {
            found.push(format!("fn {name}: {count} parameters"));
        }
    }
    for (at, _) in text.match_indices("struct ") {
        let rest = &text[at + 7..];
        let Some(open) = rest.find(['{', ';', '(']).filter(|&open| rest[open..].starts_with('{'))
        else {
            continue;
        };
        let count = items(within(&rest[open + 1..])).len();
        if count > MOST_FIELDS {
            found.push(format!("struct {}: {count} fields", rest[..open].trim()));
        }
    }
    found
}

#[test]
fn structs_and_parameter_lists_are_short() {
    let mut files = Vec::new();
    sources(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut files);
    assert!(files.len() > 50, "the sources have moved");
    let mut found = Vec::new();
    for path in files {
        let text = fs::read_to_string(&path).expect("a source file");
        found
            .extend(too_large(&text).into_iter().map(|what| format!("{}: {what}", path.display())));
    }
    assert!(found.is_empty(), "{found:#?}");
}

#[test]
fn parameters_in_tuples_are_counted() {
    let seven = "fn f(a: (A, B), (c, d): (C, (D, E)), f: &F, g: [G; 2]) {}";
    assert!(too_large(seven).is_empty());
    let eight = "fn f(&self, a: (A, B), (c, d): (C, (D, E)), f: &F, g: [G; 2]) {}";
    assert_eq!(too_large(eight), ["fn f: 8 parameters"]);
    let fields = (0..26).map(|k| format!("    f{k}: Vec<(u32, f64)>,\n")).collect::<String>();
    assert_eq!(too_large(&format!("struct S {{\n{fields}}}\n")), ["struct S: 26 fields"]);
}
