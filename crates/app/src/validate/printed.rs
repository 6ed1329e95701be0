//! The table that `validate` prints, and the texts of its cells.

use core::fmt::Write as _;

use super::published::Tolerance;
use super::row::{Compared, Row, count};
use crate::plot::{plain, significant};

/// Both tables and the count.
pub(super) fn tables(rows: &[Row]) -> String {
    let mut numbers = vec![
        ["case", "source", "published", "ours", "error", "tolerance", "ok"].map(str::to_owned),
    ];
    let mut statements = vec![["what the text says", "source", "ours", "ok"].map(str::to_owned)];
    for row in rows {
        match &row.compared {
            Compared::Number { published, ours, error, tolerance, .. } => numbers.push([
                row.case.clone(),
                row.cited(),
                with_unit(&plain(*published, 4), row.unit),
                with_unit(&four_digits(*ours), row.unit),
                error_text(*error, *tolerance),
                tolerance_text(*tolerance),
                ok_text(row.is_ok).to_owned(),
            ]),
            Compared::Statement { ours, .. } => statements.push([
                row.case.clone(),
                row.cited(),
                list(ours, row.unit),
                ok_text(row.is_ok).to_owned(),
            ]),
        }
    }
    let mut text = aligned(&numbers, &[2, 3, 4, 5]);
    text.push('\n');
    text.push_str(&aligned(&statements, &[2]));
    text.push('\n');
    for row in rows.iter().filter(|row| !row.is_ok && !row.note.is_empty()) {
        let _ = writeln!(text, "{}\n", wrapped(&format!("{}: {}", row.case, row.note)));
    }
    let (hold, said) = count(rows, false);
    let _ = writeln!(text, "{hold} of {said} statements hold");
    let (within, compared) = count(rows, true);
    let _ = writeln!(text, "{within} of {compared} rows within tolerance");
    text
}

/// Columns of a common width, two blanks between; those in `right` end together.
fn aligned<const N: usize>(rows: &[[String; N]], right: &[usize]) -> String {
    let width_of = |column: usize| rows.iter().map(|row| row[column].chars().count()).max();
    let widths: [usize; N] = std::array::from_fn(|column| width_of(column).unwrap_or(0));
    let mut text = String::new();
    for row in rows {
        let cells = row.iter().zip(widths).enumerate().map(|(column, (cell, width))| {
            if right.contains(&column) {
                format!("{cell:>width$}")
            } else {
                format!("{cell:<width$}")
            }
        });
        let line = cells.collect::<Vec<_>>().join("  ");
        text.push_str(line.trim_end());
        text.push('\n');
    }
    text
}

/// Longest line of running text [characters].
const LINE: usize = 100;

fn wrapped(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= LINE {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(format!("  {word}"));
        }
    }
    lines.join("\n")
}

pub(super) fn ok_text(is_ok: bool) -> &'static str {
    if is_ok { "yes" } else { "NO" }
}

pub(super) fn with_unit(number: &str, unit: &str) -> String {
    if unit.is_empty() { number.to_owned() } else { format!("{number} {unit}") }
}

/// Our value, rounded first, so that 0.99999999 has no digit more than 1.
pub(super) fn four_digits(value: f64) -> String {
    significant(format!("{value:.3e}").parse().unwrap_or(value), 4)
}

/// Values with their unit at the end.
pub(super) fn list(values: &[f64], unit: &str) -> String {
    let values: Vec<String> = values.iter().map(|v| plain(*v, 3)).collect();
    with_unit(&values.join(", "), unit)
}

pub(super) fn error_text(error: f64, tolerance: Tolerance) -> String {
    match tolerance {
        Tolerance::Relative(share) => {
            let decimals = if share >= 0.01 { 1 } else { 3 };
            let percent = format!("{:+.decimals$}", error * 100.0);
            // What rounds to zero has no sign.
            let is_zero = percent.bytes().all(|b| b"+-0.".contains(&b));
            let percent = if is_zero { percent[1..].to_owned() } else { percent };
            format!("{} %", percent.replace('-', "\u{2212}"))
        }
        Tolerance::Absolute(_) => format!("{error:.1e}").replace('-', "\u{2212}"),
    }
}

pub(super) fn tolerance_text(tolerance: Tolerance) -> String {
    match tolerance {
        Tolerance::Relative(share) => format!("±{} %", plain(share * 100.0, 3)),
        Tolerance::Absolute(bound) => format!("±{bound:e}").replace('-', "\u{2212}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_and_values_read_as_meant() {
        let relative = Tolerance::Relative;
        assert_eq!(error_text(0.0731, relative(0.1)), "+7.3 %");
        assert_eq!(error_text(-0.0731, relative(0.1)), "\u{2212}7.3 %");
        assert_eq!(error_text(-1e-9, relative(0.001)), "0.000 %");
        assert_eq!(error_text(f64::NAN, relative(0.001)), "NaN %");
        assert_eq!(error_text(3.4e-16, Tolerance::Absolute(1e-12)), "3.4e\u{2212}16");
        assert_eq!(four_digits(0.999_999_99), "1.000");
        assert_eq!(four_digits(0.135_486), "0.1355");
    }
}
