//! Dotted key paths, as messages show them.

use crate::place::first;

/// Joins a path and a key's name to `parent.name`. The name stands in quotes if TOML needs quotes, and a very long name
/// is cut.
pub fn join(parent: &str, name: &str) -> String {
    let (shown, is_cut) = first(name, 60);
    let bare = !shown.is_empty()
        && shown.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
    let shown = match (bare, is_cut) {
        (true, false) => shown,
        (true, true) => format!("{shown}…"),
        (false, _) => {
            format!("\"{}{}\"", shown.replace('"', "\\\""), if is_cut { "…" } else { "" })
        }
    };
    if parent.is_empty() { shown } else { format!("{parent}.{shown}") }
}

/// The path `parent[index]` of an item of a list, with the number `index` as the caller gives it.
pub fn item(parent: &str, index: usize) -> String {
    format!("{parent}[{index}]")
}

#[cfg(test)]
mod tests {
    use super::join;

    #[test]
    fn names_are_quoted_where_toml_needs_it() {
        assert_eq!(join("", "time"), "time");
        assert_eq!(join("body", "tug-1"), "body.tug-1");
        assert_eq!(join("body", "my \"ship\""), "body.\"my \\\"ship\\\"\"");
        assert_eq!(join("body", ""), "body.\"\"");
        assert_eq!(join("", &"k".repeat(99)), format!("{}…", "k".repeat(60)));
    }
}
