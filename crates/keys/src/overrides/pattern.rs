//! Patterns: names with a `*` that stand for several tables.

use std::borrow::Cow;

/// Whether a name is a pattern, that is, whether it has a `*`.
pub fn is_pattern(name: &str) -> bool {
    name.contains('*')
}

/// Whether a name fits a pattern; each `*` in the pattern stands for any text.
pub fn fits(pattern: &str, name: &str) -> bool {
    let mut parts = pattern.split('*');
    let first = parts.next().expect("a split text has a first part");
    let Some(mut rest) = name.strip_prefix(first) else { return false };
    let Some(last) = parts.next_back() else { return rest.is_empty() };
    for part in parts {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}

/// Puts quotes around the names with a `*` in a dotted path, because TOML needs these quotes.
pub(super) fn with_quotes(path: &str) -> Cow<'_, str> {
    if !is_pattern(path) || path.contains(['"', '\'']) {
        return Cow::Borrowed(path);
    }
    let quoted = |name: &str| {
        if is_pattern(name) { format!("\"{}\"", name.trim()) } else { name.to_owned() }
    };
    Cow::Owned(path.split('.').map(quoted).collect::<Vec<_>>().join("."))
}

#[cfg(test)]
mod tests {
    use super::{fits, with_quotes};

    #[test]
    fn a_star_stands_for_any_text() {
        for name in ["", "a", "a_12"] {
            assert!(fits("*", name), "{name}");
        }
        assert!(fits("a_*", "a_1") && fits("*_1", "a_1") && fits("a*1", "a_11") && fits("a", "a"));
        assert!(fits("a*b*c", "a1b2bc") && fits("*_*", "_"));
        assert!(!fits("a_*", "b_1") && !fits("a", "ab") && !fits("a*a", "a") && !fits("*b", "ba"));
    }

    #[test]
    fn only_names_with_a_star_are_quoted() {
        assert_eq!(with_quotes("fender.*.tolerance"), "fender.\"*\".tolerance");
        assert_eq!(with_quotes("fender.a_1.tolerance"), "fender.a_1.tolerance");
        assert_eq!(with_quotes("fender.\"a *\".tolerance"), "fender.\"a *\".tolerance");
    }
}
