//! The table that `validate` prints, and the texts of its cells.

use fenderline_contact::number::greater;

use core::fmt::Write as _;

use super::published::{Tolerance, Uncertainty};
use super::row::{Compared, Row, count};
use fenderline_report::plot::{plain, significant};

/// Writes all that `validate` prints: tables of numbers by subject, the statements, the rows that do not match, and how
/// many rows are within tolerance.
pub(super) fn tables(rows: &[Row]) -> String {
    let mut text = numbers(rows);
    text.push('\n');
    text.push_str(&statements(rows));
    text.push('\n');
    for row in rows.iter().filter(|row| !row.is_ok) {
        let known = if row.is_known_mismatch() { ", known" } else { "" };
        let what = format!("NOT MATCHING{known}: {} ({}). {}", row.case, row.cited(), row.note);
        let _ = writeln!(text, "{}\n", wrapped(what.trim_end(), LINE).join("\n"));
    }
    let (hold, said) = count(rows, false);
    let _ = writeln!(text, "{hold} of {said} statements of the sources hold");
    let known = rows.iter().filter(|row| is_number(row) && !row.is_ok && row.is_known_mismatch());
    let known = match known.count() {
        0 => String::new(),
        known => format!("; {known} known not to match"),
    };
    let (within, compared) = count(rows, true);
    let widest = rows.iter().filter_map(width_in_uncertainties).fold(0.0, greater);
    let _ = writeln!(
        text,
        "every tolerance is below twice the uncertainty of its reference: at most {} times",
        plain(widest, 3)
    );
    let _ = writeln!(text, "{within} of {compared} rows within tolerance{known}");
    text
}

/// The tolerance of a row divided by its uncertainty.
fn width_in_uncertainties(row: &Row) -> Option<f64> {
    match &row.compared {
        Compared::Number { tolerance, uncertainty, .. } => match tolerance {
            Tolerance::Relative(width) | Tolerance::Absolute(width) => {
                Some(width / uncertainty.size)
            }
        },
        Compared::Statement { .. } => None,
    }
}

fn is_number(row: &Row) -> bool {
    matches!(row.compared, Compared::Number { .. })
}

/// The name of the column of published values.
const THEIRS: &str = "theirs";

/// Longest lines in the columns of cases and of places (characters); longer texts are wrapped.
const CASE: usize = 31;
const PLACE: usize = 16;

/// Writes a table of numbers for each subject.
fn numbers(rows: &[Row]) -> String {
    let numbers: Vec<&Row> = rows.iter().filter(|row| is_number(row)).collect();
    let of_one = numbers.chunk_by(|a, b| a.subject == b.subject);
    of_one.map(table_of_subject).collect::<Vec<_>>().join("\n")
}

/// Writes the heading of a subject's table, a line of column names for each source, and the rows.
fn table_of_subject(rows: &[&Row]) -> String {
    let mut cells = Vec::new();
    let mut before: Option<&Row> = None;
    for &row in rows {
        let Compared::Number { published, ours, error, tolerance, uncertainty, .. } = &row.compared
        else {
            continue;
        };
        if before.is_none_or(|before| before.source != row.source) {
            let source = format!("{} [{}]", row.source, row.standing.text());
            let names = ["place", THEIRS, "ours", "error", "tolerance", "uncertain", "ok"]
                .map(str::to_owned);
            add_row(&mut cells, &source, names);
        }
        before = Some(row);
        let values = [
            row.place.clone(),
            with_unit(&plain(*published, 5), &row.unit),
            with_unit(&four_digits(*ours), &row.unit),
            error_text(*error, *tolerance),
            tolerance_text(*tolerance, &row.unit),
            uncertainty_text(uncertainty, *tolerance, &row.unit),
            ok_text(row.is_ok).to_owned(),
        ];
        add_row(&mut cells, &row.case, values);
    }
    let mut text = format!("{}\n\n", rows[0].subject.to_uppercase());
    for (index, (line, cells)) in aligned(&cells, &[2, 3, 4, 5, 6]).lines().zip(&cells).enumerate()
    {
        if cells[2] == THEIRS && index > 0 {
            text.push('\n');
        }
        let _ = writeln!(text, "{line}");
    }
    text
}

/// Adds a row to a table, with further lines if the text of its case or its place is long.
fn add_row(cells: &mut Vec<[String; 8]>, case: &str, [place, values @ ..]: [String; 7]) {
    let (mut case, mut place) =
        (wrapped(case, CASE).into_iter(), wrapped(&place, PLACE).into_iter());
    let mut values = Some(values);
    loop {
        let (of_case, of_place, of_values) = (case.next(), place.next(), values.take());
        if of_case.is_none() && of_place.is_none() && of_values.is_none() {
            return;
        }
        let [theirs, ours, error, tolerance, uncertainty, ok] = of_values.unwrap_or_default();
        let [case, place] = [of_case, of_place].map(Option::unwrap_or_default);
        cells.push([case, place, theirs, ours, error, tolerance, uncertainty, ok]);
    }
}

fn statements(rows: &[Row]) -> String {
    let mut cells = vec![["what the text says", "source", "ours", "ok"].map(str::to_owned)];
    for row in rows {
        if let Compared::Statement { ours, .. } = &row.compared {
            let ours = list(ours, &row.unit);
            cells.push([row.case.clone(), row.cited(), ours, ok_text(row.is_ok).to_owned()]);
        }
    }
    aligned(&cells, &[2])
}

/// Aligns the columns of a table to common widths, two blanks between them; the columns in `right` are aligned to the
/// right.
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

/// Longest line of running text (characters).
const LINE: usize = 100;

/// Wraps text into lines of a width, between its words.
fn wrapped(text: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let line = lines.last_mut().expect("there is a line");
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= most {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(format!("  {word}"));
        }
    }
    lines
}

pub(super) fn ok_text(is_ok: bool) -> &'static str {
    if is_ok { "yes" } else { "NO" }
}

pub(super) fn with_unit(number: &str, unit: &str) -> String {
    match unit {
        "" => number.to_owned(),
        "°" => format!("{number}°"),
        _ => format!("{number} {unit}"),
    }
}

/// Writes a value with four digits; the value is rounded first, so that 0.99999999 has as many digits as 1.
pub(super) fn four_digits(value: f64) -> String {
    significant(format!("{value:.3e}").parse().unwrap_or(value), 4)
}

/// Writes a list of values with their unit at the end.
pub(super) fn list(values: &[f64], unit: &str) -> String {
    let values: Vec<String> = values.iter().map(|v| plain(*v, 3)).collect();
    with_unit(&values.join(", "), unit)
}

pub(super) fn error_text(error: f64, tolerance: Tolerance) -> String {
    match tolerance {
        Tolerance::Relative(share) => {
            let decimals = if share >= 0.01 { 1 } else { 3 };
            format!("{} %", signed(error * 100.0, decimals))
        }
        Tolerance::Absolute(bound) if bound >= LEAST_FIXED => signed(error, decimals_below(bound)),
        Tolerance::Absolute(_) if error == 0.0 => "0".to_owned(),
        Tolerance::Absolute(_) => format!("{error:.1e}").replace('-', "\u{2212}"),
    }
}

/// The smallest tolerance that is shown without a power of ten.
const LEAST_FIXED: f64 = 1e-4;

/// Number of decimals that show a tenth of `bound`.
fn decimals_below(bound: f64) -> usize {
    (0..6).find(|decimals| bound * 10_f64.powi(*decimals) >= 10.0 - 1e-9).map_or(6, |d| d as usize)
}

/// Writes a value with its sign, unless it rounds to zero.
fn signed(value: f64, decimals: usize) -> String {
    let text = format!("{value:+.decimals$}");
    let is_zero = text.bytes().all(|b| b"+-0.".contains(&b));
    let text = if is_zero { text[1..].to_owned() } else { text };
    text.replace('-', "\u{2212}")
}

pub(super) fn tolerance_text(tolerance: Tolerance, unit: &str) -> String {
    match tolerance {
        Tolerance::Relative(share) => format!("±{} %", plain(share * 100.0, 3)),
        Tolerance::Absolute(bound) if bound >= LEAST_FIXED => {
            with_unit(&format!("±{}", plain(bound, 3)), unit)
        }
        Tolerance::Absolute(bound) => format!("±{bound:e}").replace('-', "\u{2212}"),
    }
}

/// Writes an uncertainty in the terms of the row's tolerance: a share, or a number with the unit.
pub(super) fn uncertainty_text(
    uncertainty: &Uncertainty,
    tolerance: Tolerance,
    unit: &str,
) -> String {
    tolerance_text(
        match tolerance {
            Tolerance::Relative(_) => Tolerance::Relative(uncertainty.size),
            Tolerance::Absolute(_) => Tolerance::Absolute(uncertainty.size),
        },
        unit,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_and_values_have_the_right_digits_and_units() {
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
