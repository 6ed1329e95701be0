//! Writes the heads of tables.

use maud::{Markup, html};

/// The head of one column of a table. The unit stands small below the label; an empty unit is left out. In a label the
/// part after an underscore becomes a subscript, as in `k_s`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Head<'a> {
    /// A column of names, which is wide and aligned to the left.
    Name(&'a str),
    /// A column of texts, with its label and unit.
    Text(&'a str, &'a str),
    /// A column of numbers, with its label and unit.
    Number(&'a str, &'a str),
}

/// Writes the head row of a table.
pub fn table_head(columns: &[Head<'_>]) -> Markup {
    html! {
        thead { tr {
            @for column in columns {
                @match *column {
                    Head::Name(name) => th class="name" scope="col" { (name) },
                    Head::Text(text, unit) => th scope="col" { (label(text, unit)) },
                    Head::Number(text, unit) => th class="number" scope="col" { (label(text, unit)) },
                }
            }
        } }
    }
}

/// Writes a name so that a line may break after the name's underscores.
pub(crate) fn breakable(name: &str) -> Markup {
    html! {
        @for (index, part) in name.split_inclusive('_').enumerate() {
            @if index > 0 { wbr; }
            (part)
        }
    }
}

fn label(text: &str, unit: &str) -> Markup {
    let (base, subscript) = text.split_once('_').unwrap_or((text, ""));
    html! {
        (base)
        @if !subscript.is_empty() { sub { (subscript) } }
        @if !unit.is_empty() { small { (unit) } }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_head_has_subscripts_and_units_where_there_are_any() {
        let head = table_head(&[
            Head::Name("Material"),
            Head::Number("Shear stiffness k_s", "kN/m"),
            Head::Text("Verdict", ""),
        ]);
        assert_eq!(
            head.into_string(),
            "<thead><tr><th class=\"name\" scope=\"col\">Material</th><th class=\"number\" scope=\"col\">Shear \
             stiffness k<sub>s</sub><small>kN/m</small></th><th scope=\"col\">Verdict</th></tr></thead>"
        );
    }
}
