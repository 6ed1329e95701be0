//! Limits of an output: how often the runs exceed the limits, and how often the law that may be quoted exceeds them.

use fenderline_report::plot::{Point, Series, significant};
use fenderline_report::{Head as TableHead, table_head};
use maud::{Markup, html};

use super::quote::quote;
use super::words;
use crate::limit::Limit;
use crate::statistics::design::{Asked, Findings};
use crate::statistics::return_value::Traffic;
use crate::statistics::{Estimate, Interval, share_above};

/// The limits as vertical lines of the exceedance chart, down to the rarest probability.
pub(super) fn lines<'l>(
    limits: &'l [&Limit],
    rarest: f64,
) -> impl Iterator<Item = Series> + use<'l> {
    limits.iter().enumerate().map(move |(style, limit)| {
        let at = |y: f64| Point { x: limit.value, y };
        Series::line(&format!("limit: {}", limit.name), vec![at(1.0), at(rarest)]).styled(7 + style)
    })
}

/// The table with one row for each limit; empty if there are no limits.
pub(super) fn section(limits: &[&Limit], unit: &str, findings: &Findings, asked: &Asked) -> Markup {
    let quoted = quote(findings, unit).and_then(|quote| quote.law);
    let fit = quoted.and_then(|law| findings.fits.iter().flatten().find(|fit| fit.law == law));
    let mut columns = vec![
        TableHead::Name("limit"),
        TableHead::Number("value", unit),
        TableHead::Number("runs above", ""),
        TableHead::Number("one berthing", "by the runs"),
    ];
    let by_law = fit.map(|fit| format!("by {}", fit.law.title()));
    columns.extend(by_law.as_ref().map(|by| TableHead::Number("one berthing", by)));
    if asked.traffic.is_some() {
        columns.push(TableHead::Number("once in years", "by the runs"));
        columns.extend(by_law.as_ref().map(|by| TableHead::Number("once in years", by)));
    }
    html! {
        @if !limits.is_empty() {
            h3 { "Your limits" }
            div class="wide" { table {
                (table_head(&columns))
                tbody { @for limit in limits {
                    @let sample = &findings.sample;
                    @let above = sample.count() - sample.count_to(limit.value);
                    @let share = share_above(sample, limit.value, asked.confidence);
                    @let law = fit.map(|fit| fit.distribution.above(limit.value));
                    tr {
                        td class="name" { (limit.name) }
                        td class="number" { (words::number(limit.value)) }
                        td class="number" { (above) small { "of " (sample.count()) } }
                        td class="number" { (significant(share.value, 2)) small { (band(&share, &|p| significant(p, 2))) } }
                        @if let Some(p) = law { td class="number" { (significant(p, 2)) } }
                        @if let Some(traffic) = asked.traffic {
                            td class="number" { (years(traffic, share.value)) small { (band(&periods(traffic, &share), &round)) } }
                            @if let Some(p) = law { td class="number" { (years(traffic, p)) } }
                        }
                    }
                } }
            } }
        }
    }
}

fn band(estimate: &Estimate, shown: &dyn Fn(f64) -> String) -> String {
    format!("{} to {}", shown(estimate.interval.low), shown(estimate.interval.high))
}

/// The return periods of an estimated probability; the longest period belongs to the smallest probability.
fn periods(traffic: Traffic, share: &Estimate) -> Estimate {
    let of = |p: f64| traffic.period_of(p);
    let interval = Interval { low: of(share.interval.high), high: of(share.interval.low) };
    Estimate { value: of(share.value), interval }
}

fn years(traffic: Traffic, p: f64) -> String {
    round(traffic.period_of(p))
}

fn round(years: f64) -> String {
    if years.is_finite() { significant(years, 2) } else { "∞".to_owned() }
}
