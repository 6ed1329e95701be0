//! The statistics of a column as text.

use core::fmt::Write as _;

use fenderline_campaign::report::{quote, words};
use fenderline_report::plot::{fixed, plain, significant};

use super::column::Column;

/// Widest column of parameters.
const PARAMETERS: usize = 64;

/// All of it.
pub(super) fn text(column: &Column<'_>) -> String {
    // Thousands are not separated: other programs may read it.
    [summary(column), design(column), quoted(column), remarks(column), fits(column)]
        .concat()
        .replace('\u{202f}', "")
}

fn summary(column: &Column<'_>) -> String {
    let (findings, moments) = (&column.findings, &column.findings.moments);
    let (sample, unit) = (&findings.sample, &column.head.unit);
    let unit = if unit.is_empty() { String::new() } else { format!(" {unit}") };
    let empty = match column.missing {
        0 => String::new(),
        1 => ", 1 cell empty".to_owned(),
        many => format!(", {many} cells empty"),
    };
    let weighted = match sample.is_weighted() {
        true => format!(", weighted as {} alike", significant(sample.effective_size(), 3)),
        false => String::new(),
    };
    let zeros = match column.zeros {
        0 => String::new(),
        zeros => format!(", {zeros} values of 0 left out"),
    };
    let mut text = format!(
        "{} of {}: {} values{zeros}{empty}{weighted}\n",
        column.head.name,
        column.file,
        sample.count()
    );
    let _ = writeln!(
        text,
        "from {} to {}{unit}; mean {} ± {}, standard deviation {} ± {}{unit} (± standard error), skewness {}",
        words::number(sample.least()),
        words::number(sample.largest()),
        words::number(moments.mean.value),
        significant(moments.mean.error, 2),
        words::number(moments.deviation.value),
        significant(moments.deviation.error, 2),
        fixed(moments.skewness, 2),
    );
    text
}

/// Text of the design values: a block for each return period or probability, with a line for each law or method.
fn design(column: &Column<'_>) -> String {
    let (findings, asked) = (&column.findings, &column.asked);
    let unit = match column.head.unit.as_str() {
        "" => String::new(),
        unit => format!(" [{unit}]"),
    };
    let per_cent = plain(100.0 * asked.confidence.level(), 4);
    let mut text = format!("\nDesign values{unit} with {per_cent} % bands");
    let _ = match asked.traffic {
        Some(traffic) => writeln!(text, ", for {} berthings a year", plain(traffic.per_year(), 6)),
        None => writeln!(text, ", for one berthing (--per-year N gives values of return periods)"),
    };
    for row in &findings.rows {
        let _ = writeln!(
            text,
            "  {}: {} berthings",
            words::rarity(row.rarity),
            words::one_in(row.exceedance)
        );
        let _ = writeln!(text, "    {:<20}{}", "the data", words::by_data(&row.by_data));
        for place in findings.ranking() {
            if let Ok(fit) = &findings.fits[place] {
                let value = row.by_fit[place].as_ref();
                let value = value.map_or("below its threshold".to_owned(), words::with_band);
                let _ = writeln!(text, "    {:<20}{value}", fit.law.title());
            }
        }
    }
    text
}

/// Text that says which law or design value may be quoted, and why.
fn quoted(column: &Column<'_>) -> String {
    let quote = quote(&column.findings, &column.head.unit);
    quote.map_or_else(String::new, |quote| format!("\n{}\n", quote.sentence))
}

fn remarks(column: &Column<'_>) -> String {
    let all = words::remarks(&column.findings);
    if all.is_empty() {
        return String::new();
    }
    let lines: String = all.iter().map(|remark| format!("  {remark}\n")).collect();
    format!("\nBefore a design value is used, note:\n{lines}")
}

fn fits(column: &Column<'_>) -> String {
    let findings = &column.findings;
    let mut text = String::from(
        "\nLaws fitted by maximum likelihood, in the order of AIC, the smallest AIC first\n",
    );
    let tail = findings.tail.map_or(String::new(), |tail| {
        format!("of {} above {}", tail.count, words::number(tail.above))
    });
    let _ = writeln!(
        text,
        "  {:<20}{:<PARAMETERS$}{:>9}{:>7}{:>7}  expects {tail}",
        "", "± standard error", "AIC", "K-S", "A²"
    );
    for place in findings.ranking() {
        match &findings.fits[place] {
            Ok(fit) => {
                let expected = findings.tail.and_then(|tail| tail.expected(fit, &findings.sample));
                let _ = writeln!(
                    text,
                    "  {:<20}{:<PARAMETERS$}{:>9}{:>7}{:>7}  {}",
                    fit.law.title(),
                    words::parameters(fit),
                    fixed(fit.aic, 1),
                    fixed(fit.kolmogorov, 3),
                    fixed(fit.anderson_darling, 2),
                    expected.map_or("-".to_owned(), |expected| significant(expected, 3)),
                );
            }
            Err(why) => {
                let _ = writeln!(text, "  no fit: {why}");
            }
        }
    }
    text
}
