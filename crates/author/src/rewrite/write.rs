//! Writes TOML from its tree of keys: tables stand under headers, in the order of the file, and small values stay in
//! one line.

use core::fmt::Write as _;

use toml::Spanned;
use toml::de::{DeInteger, DeTable, DeValue};

type Pair<'t, 'a> = (&'t str, &'t DeValue<'a>);

/// The text of a whole file.
pub(super) fn document(document: &DeTable<'_>) -> String {
    let mut text = String::new();
    let (plain, deeper): (Vec<Pair<'_, '_>>, Vec<Pair<'_, '_>>) =
        in_order(document).into_iter().partition(|(_, value)| !is_deep(value));
    for (name, value) in plain {
        let _ = writeln!(text, "{} = {}", key(name), inline(value));
    }
    for (name, value) in deeper {
        match value {
            DeValue::Table(table) => section(&mut text, &key(name), table),
            DeValue::Array(items) => {
                for item in items.iter() {
                    if let DeValue::Table(table) = item.get_ref() {
                        let _ = write!(text, "\n[[{}]]\n", key(name));
                        lines(&mut text, table);
                    }
                }
            }
            _ => {}
        }
    }
    text
}

/// True for values that are written under headers: a table, or a list of tables.
fn is_deep(value: &DeValue<'_>) -> bool {
    match value {
        DeValue::Table(_) => true,
        DeValue::Array(items) => {
            !items.is_empty()
                && items.iter().all(|item| matches!(item.get_ref(), DeValue::Table(_)))
        }
        _ => false,
    }
}

/// Writes a table under its header. A table that holds only tables, such as the table of all bodies, has no header.
fn section(text: &mut String, path: &str, table: &DeTable<'_>) {
    let pairs = in_order(table);
    let holds_tables = |value: &DeValue<'_>| match value {
        DeValue::Table(inner) => {
            in_order(inner).iter().any(|(_, value)| matches!(value, DeValue::Table(_)))
        }
        _ => false,
    };
    let is_container =
        !pairs.is_empty() && pairs.iter().all(|(_, value)| matches!(value, DeValue::Table(_)));
    let below = |value: &DeValue<'_>| is_container || holds_tables(value);
    if !is_container {
        let _ = write!(text, "\n[{path}]\n");
        for (name, value) in pairs.iter().filter(|(_, value)| !below(value)) {
            let _ = writeln!(text, "{} = {}", key(name), inline(value));
        }
    }
    for (name, value) in pairs.iter().filter(|(_, value)| below(value)) {
        if let DeValue::Table(inner) = value {
            section(text, &format!("{path}.{}", key(name)), inner);
        }
    }
}

/// Writes the keys of a table, each in a line.
fn lines(text: &mut String, table: &DeTable<'_>) {
    for (name, value) in in_order(table) {
        let _ = writeln!(text, "{} = {}", key(name), inline(value));
    }
}

/// The keys of a table in the order of their places in the file.
fn in_order<'t, 'a>(table: &'t DeTable<'a>) -> Vec<Pair<'t, 'a>> {
    let mut pairs: Vec<_> = table.iter().collect();
    pairs.sort_by_key(|(name, _)| name.span().start);
    pairs.into_iter().map(|(name, value)| (name.get_ref().as_ref(), value.get_ref())).collect()
}

fn inline(value: &DeValue<'_>) -> String {
    match value {
        DeValue::String(text) => quoted(text),
        DeValue::Integer(integer) => whole(integer),
        DeValue::Float(float) => float.as_str().to_owned(),
        DeValue::Boolean(flag) => flag.to_string(),
        DeValue::Datetime(time) => time.to_string(),
        DeValue::Array(items) => {
            let item = |item: &Spanned<DeValue<'_>>| inline(item.get_ref());
            let items: Vec<String> = items.iter().map(item).collect();
            format!("[{}]", items.join(", "))
        }
        DeValue::Table(table) => {
            let pair = |(name, value): Pair<'_, '_>| format!("{} = {}", key(name), inline(value));
            let pairs: Vec<String> = in_order(table).into_iter().map(pair).collect();
            match pairs.is_empty() {
                true => "{}".to_owned(),
                false => format!("{{ {} }}", pairs.join(", ")),
            }
        }
    }
}

/// A whole number as text, with the prefix of its base.
fn whole(integer: &DeInteger<'_>) -> String {
    let prefix = match integer.radix() {
        2 => "0b",
        8 => "0o",
        16 => "0x",
        _ => "",
    };
    format!("{prefix}{}", integer.as_str())
}

/// A key as text, in quotes where its letters need them.
fn key(name: &str) -> String {
    let is_bare =
        !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '-' || c == '_');
    if is_bare { name.to_owned() } else { quoted(name) }
}

/// A text in quotes.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            c if c.is_control() => {
                let _ = write!(quoted, "\\u{:04X}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}
