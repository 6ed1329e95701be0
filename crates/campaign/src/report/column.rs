//! The tables and charts of one column: exceedance, fits, design values; and the page of the command `statistics`.

use fenderline_contact::number::greater;
use fenderline_report::plot::{
    Axis, Chart, Point, Reference, Series, fixed, page, plain, significant,
};
use fenderline_report::{Head as TableHead, table_head};
use maud::{Markup, html};

use super::limits;
use super::quote::quote;
use super::words;
use crate::limit::Limit;
use crate::statistics::design::{Asked, Findings, Rarity};
use crate::statistics::fit::Fit;
use crate::table::Head;

/// The chart draws fitted laws up to this multiple of the largest value.
const REACH: f64 = 2.0;

/// Number of points of the line of a fitted law.
const LINE: u32 = 120;

/// The page of one column of a table; `source` is the name of the file for the reader, `missing` the number of
/// empty cells.
#[must_use]
pub fn column_page(
    source: &str,
    head: &Head,
    missing: usize,
    findings: &Findings,
    asked: &Asked,
) -> String {
    let title = format!("{} of {source}", head.name);
    let body = html! {
        p class="kicker" { "fenderline statistics" }
        h1 { (title) }
        p class="subtitle" { (counts(head, missing, findings)) }
        (sections(head, findings, asked, &[]))
        h2 { "How it was computed" }
        (methods(asked))
        footer { "Made by fenderline " (env!("CARGO_PKG_VERSION")) ". " (USERS_OWN) }
    };
    page(&title, &body)
}

/// Sentence that says which assumptions are the user's own.
pub(super) const USERS_OWN: &str = "Return periods, percentiles and partial factors were given by \
    the user; the designer must judge whether they meet a guideline.";

/// Sentence with the number of values, their mean and their standard deviation.
pub(super) fn counts(head: &Head, missing: usize, findings: &Findings) -> String {
    let (sample, moments) = (&findings.sample, &findings.moments);
    let unit = if head.unit.is_empty() { String::new() } else { format!(" {}", head.unit) };
    let empty = if missing == 0 { String::new() } else { format!(", {missing} cells empty") };
    format!(
        "{} values{empty}; from {} to {}{unit}; mean {} ± {}, standard deviation {} ± {}{unit} (± standard error), skewness {}.",
        sample.count(),
        words::number(sample.least()),
        words::number(sample.largest()),
        words::number(moments.mean.value),
        significant(moments.mean.error, 2),
        words::number(moments.deviation.value),
        significant(moments.deviation.error, 2),
        fixed(moments.skewness, 2),
    )
}

/// The sections of a column: chart, design values and fits.
pub(super) fn sections(
    head: &Head,
    findings: &Findings,
    asked: &Asked,
    limits: &[&Limit],
) -> Markup {
    html! {
        (chart(head, findings, asked, limits).render_tall())
        (limits::section(limits, &head.unit, findings, asked))
        h3 { "Design values" @if !head.unit.is_empty() { " [" (head.unit) "]" } }
        @if let Some(quote) = quote(findings, &head.unit) {
            @match quote.sentence.split_once(": ") {
                Some((what, why)) => p { strong { (what) ": " } (why) },
                None => p { strong { (quote.sentence) } },
            }
        }
        (design(findings, asked))
        (remarks(findings))
        h3 { "Fits" }
        (fits(findings))
    }
}

/// The chart of the exceedance curve with its band and the fitted laws, down to the probability of the rarest design
/// value.
fn chart(head: &Head, findings: &Findings, asked: &Asked, limits: &[&Limit]) -> Chart {
    let curve = &findings.curve;
    let per_cent = plain(100.0 * asked.confidence.level(), 4);
    // The last point, above which nothing was found, has no place on a logarithmic axis.
    let points = curve.iter().filter(|point| point.probability.value > 0.0);
    let at = |value: f64, p: f64| Point { x: value, y: p };
    let data = curve.iter().map(|point| at(point.value, point.reached)).collect();
    let lower =
        points.clone().map(|point| at(point.value, point.probability.interval.low)).collect();
    let upper = points.map(|point| at(point.value, point.probability.interval.high)).collect();
    let rarest = findings.rows.iter().map(|row| row.exceedance);
    let rarest =
        rarest.fold(1.0 / findings.sample.count() as f64, fenderline_contact::number::lesser);
    let mut series =
        vec![Series::band(&format!("{per_cent} % band of the data"), lower, upper).styled(6)];
    for (style, fit) in findings.fits.iter().enumerate() {
        if let Ok(fit) = fit {
            series.push(Series::line(fit.law.title(), line(fit, findings, rarest)).styled(style));
        }
    }
    series.extend(limits::lines(limits, rarest));
    // On top of the lines.
    series.push(Series::dots("data", data).styled(6));
    // Levels of a lifetime lie too close to levels of periods.
    let drawn = findings.rows.iter().filter(|row| !matches!(row.rarity, Rarity::Life { .. }));
    let references =
        drawn.map(|row| Reference { label: words::rarity(row.rarity), value: row.exceedance });
    let axis = Axis::new(&words_of(head), &head.unit);
    Chart {
        title: format!("Probability that one berthing exceeds a value of {}", words_of(head)),
        x: if findings.sample.least() >= 0.0 { axis.including(0.0) } else { axis },
        y: Axis::new("probability", "").logarithmic().including(1.0).including(rarest),
        series,
        references: references.collect(),
        linked: None,
        note: format!(
            "The band holds the true probability at each point with {per_cent} % confidence \
             (Clopper and Pearson), not the whole curve at once. A dot is the share of the values \
             that reach the dot's value. Beyond the last point only the fitted laws give values, \
             and the laws differ there."
        ),
    }
}

/// The name of a column for readers.
pub(super) fn words_of(head: &Head) -> String {
    head.name.replace('_', " ")
}

/// The line of a fitted law, down to the rarest probability; the line of a fit over a threshold begins at the
/// threshold.
fn line(fit: &Fit, findings: &Findings, rarest: f64) -> Vec<Point> {
    let most = fit.distribution.threshold().map_or(0.999, |(_, share)| 0.9999 * share);
    let ratio = rarest / most;
    // A law with a tail that is far too heavy would flatten the others; values below all data have no meaning.
    let (least, largest) = (findings.sample.least(), findings.sample.largest());
    let end = greater(REACH * largest, least);
    (0..=LINE)
        .filter_map(|step| {
            let p = most * libm::pow(ratio, f64::from(step) / f64::from(LINE));
            let x = fit.distribution.value_exceeded(p)?;
            (x >= least && x <= end).then_some(Point { x, y: p })
        })
        .collect()
}

/// The table of design values: a row for the data and for each law, a column for each return period or probability.
fn design(findings: &Findings, asked: &Asked) -> Markup {
    let rows = &findings.rows;
    let heads: Vec<(String, String)> =
        rows.iter().map(|row| (words::rarity(row.rarity), words::one_in(row.exceedance))).collect();
    let mut columns = vec![TableHead::Name("by")];
    columns.extend(heads.iter().map(|(rarity, p)| TableHead::Number(rarity, p)));
    let per_cent = plain(100.0 * asked.confidence.level(), 4);
    html! {
        div class="wide" { table {
            (table_head(&columns))
            tbody {
                tr {
                    td class="name" { "the data" }
                    @for row in rows { (cell(&words::by_data(&row.by_data))) }
                }
                @for place in findings.ranking() {
                    @if let Ok(fit) = &findings.fits[place] {
                        tr {
                            td class="name" { (fit.law.title()) @if fit.is_rejected() { small class="over" { "does not fit" } } }
                            @for row in rows {
                                @match &row.by_fit[place] {
                                    Some(value) => (cell(&words::with_band(value))),
                                    None => td class="number" { small { "below its threshold" } },
                                }
                            }
                        }
                    }
                }
            }
        } }
        p class="note" {
            @match asked.traffic {
                Some(traffic) => {
                    (format!(
                        "For {} berthings a year, which are independent and have the same \
                         distribution. ",
                        plain(traffic.per_year(), 6),
                    ))
                    @if rows.iter().any(|row| matches!(row.rarity, Rarity::Period(_))) {
                        "A value of T years is exceeded in a year with a chance of 1/T. "
                    }
                    @if rows.iter().any(|row| matches!(row.rarity, Rarity::Life { .. })) {
                        "“10 % in 50 years”: the largest berthing of 50 years exceeds it with a chance of 10 %. "
                    }
                    "Below each level stands the probability of one berthing. "
                }
                None => "The number of berthings a year is not given, so the levels refer to one \
                    berthing. ",
            }
            (format!(
                "Below each value stands its {per_cent} % band: that of the data by order \
                 statistics, that of a fit by the delta method. The band of a fit holds if the \
                 values follow the law of the fit."
            ))
            @if rows.iter().any(|row| words::by_data(&row.by_data).contains('?')) { " A question mark says that the data do not reach this level." }
        }
    }
}

/// The list of warnings to read before a design value is used.
fn remarks(findings: &Findings) -> Markup {
    let all = words::remarks(findings);
    html! {
        @if !all.is_empty() {
            p { strong class="over" { "Before a design value is used:" } }
            ul class="plain" { @for remark in all { li { (remark) "." } } }
        }
    }
}

/// A table cell with a value, and with its band in small letters below the value.
fn cell(text: &str) -> Markup {
    let (value, band) = text.split_once(" (").unwrap_or((text, ""));
    html! {
        td class="number" { (value) @if !band.is_empty() { small { (band.trim_end_matches(')')) } } }
    }
}

/// The table of the fitted laws, the best law first.
fn fits(findings: &Findings) -> Markup {
    let tail_head =
        findings.tail.map(|tail| format!("of {} above {}", tail.count, words::number(tail.above)));
    let mut columns = vec![
        TableHead::Name("law"),
        TableHead::Text("parameters ± standard error", ""),
        TableHead::Number("AIC", ""),
        TableHead::Number("K–S", "distance"),
        TableHead::Number("A²", "Anderson–Darling"),
    ];
    columns.extend(tail_head.as_ref().map(|head| TableHead::Number("expects", head)));
    html! {
        div class="wide" { table {
            (table_head(&columns))
            tbody {
                @for place in findings.ranking() {
                    tr {
                        @match &findings.fits[place] {
                            Ok(fit) => {
                                td class="name" { (fit.law.title()) @if fit.is_rejected() { small class="over" { "does not fit" } } }
                                td { (words::parameters(fit)) }
                                td class="number" { (fixed(fit.aic, 1))
                                    @if fit.distribution.threshold().is_some() { small { "of " (fit.count) " values" } } }
                                td class="number" { (fixed(fit.kolmogorov, 3)) }
                                td class="number" { (fixed(fit.anderson_darling, 2)) }
                                @if let Some(tail) = findings.tail {
                                    td class="number" { (tail.expected(fit, &findings.sample).map_or("–".to_owned(), |n| significant(n, 3))) }
                                }
                            }
                            Err(why) => {
                                td class="name" { (why.law.title()) }
                                td colspan=(columns.len() - 1) { "No fit. " (reason(&why.to_string())) }
                            }
                        }
                    }
                }
            }
        } }
        p class="note" {
            "Laws are fitted by maximum likelihood, and the smallest AIC comes first. AIC, distance \
             and A² judge the fit to all data. The last column judges the tail, which decides a design value: it is \
             the number of values that the law expects in the tail, beside the number in the data."
        }
    }
}

/// The reason why a law was not fitted: what follows the law's name in an error, with a capital letter.
fn reason(text: &str) -> String {
    let why = text.split_once(": ").map_or(text, |(_, why)| why);
    let mut letters = why.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).chain(['.']).collect()
    })
}

/// The list at the end of a page that says how the numbers were computed.
pub(super) fn methods(asked: &Asked) -> Markup {
    let per_cent = plain(100.0 * asked.confidence.level(), 4);
    html! {
        ul class="plain" {
            li { "Counted probabilities have intervals of Clopper and Pearson; quantiles of the \
                data have intervals of order statistics. Both kinds of interval hold for any \
                distribution, at " (per_cent) " % or more." }
            li { "Laws are fitted by maximum likelihood; their standard errors come from the \
                observed information, their bands from the delta method on the logarithm of the \
                value." }
            li { "The law to quote is chosen among the laws that fit all values (Kolmogorov and \
                Smirnov, 1 %), that expect as many values in the tail as the data have (within 2.6 \
                standard deviations of a count), and whose design value the data do not contradict \
                and whose band spans less than a factor of ten. Of these laws the law with the smallest AIC is \
                quoted. Without such a law, the law over the threshold is quoted; else no law." }
            @if asked.traffic.is_some() {
                li { "With n berthings a year the value of T years is exceeded by one berthing with probability p, where \
                      1 − (1 − p)ⁿ = 1/T. The largest of the N berthings of a lifetime is at most x with probability F(x)ᴺ." }
            }
        }
    }
}
