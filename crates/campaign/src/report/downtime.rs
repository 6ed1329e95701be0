//! The report of a downtime analysis: lost hours by reason, month and direction, and the error of the states.

use fenderline_report::plot::{Stacked, counted, fixed, page, significant};
use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use super::words;
use crate::downtime::{
    Count, DowntimePlan, DowntimeTable, Group, HOURS_OF_A_YEAR, Outcome, StatesCheck,
};
use crate::statistics::Estimate;
use crate::table::{Table, TableError};

/// Largest number of listed states.
const LISTED: usize = 25;

/// The contents of the report of a downtime analysis.
pub struct DowntimeReport<'a> {
    /// Title of the campaign.
    pub title: &'a str,
    /// Name of the scenario, as the report shows it.
    pub scenario: &'a str,
    /// Duration of each run (s).
    pub duration_s: f64,
    /// Weather, states and sample.
    pub plan: &'a DowntimePlan,
    /// The counted hours.
    pub counted: &'a DowntimeTable,
    /// The limits: name, and the limited quantity with its value, in words.
    pub limits: &'a [(String, String)],
    /// The campaign's table, with a row for each run.
    pub table: &'a Table,
    /// Notices of the scenario.
    pub notices: &'a [String],
    /// Seed of the random phases and of the sample.
    pub seed: u64,
    /// Gives the command that makes the run of a row (counted from 0) again, with its report.
    pub replay: &'a dyn Fn(usize) -> String,
}

/// Writes the report of a downtime analysis as a page.
///
/// # Errors
/// Fails if the table cannot be read.
pub fn downtime_page(of: &DowntimeReport<'_>) -> Result<String, TableError> {
    let body = html! {
        p class="kicker" { "fenderline campaign" }
        h1 { (of.title) }
        p class="subtitle" { (subtitle(of)) }
        h2 { "Hours lost" }
        (headline(of))
        (reasons(of))
        @for group in &of.counted.groups { (group_section(of, group)) }
        h2 { "Error of the states" }
        (check(of))
        h2 { "States that are lost" }
        (states(of)?)
        h2 { "How it was computed" }
        (methods(of))
        footer { "Made by fenderline " (env!("CARGO_PKG_VERSION")) ". Limits, weather, ship and \
            lines were given by the user." }
    };
    Ok(page(of.title, &body))
}

fn hours(hours: f64) -> String {
    let is_whole = hours == libm::trunc(hours);
    if hours >= 100.0 || is_whole { fixed(hours, 0) } else { significant(hours, 3) }
}

fn percent(share: Option<f64>) -> String {
    share.map_or_else(|| "–".to_owned(), |share| significant(100.0 * share, 3))
}

fn band(of: &Estimate) -> String {
    let [low, high] = [of.interval.low, of.interval.high].map(|share| percent(Some(share)));
    format!("{} % ({low} to {high} %)", percent(Some(of.value)))
}

fn subtitle(of: &DowntimeReport<'_>) -> String {
    let (plan, weather) = (of.plan, of.plan.weather());
    let rows = match weather.is_series() {
        true => format!("{} h of {}", hours(of.counted.all.hours), weather.file_name()),
        false => format!("the scatter diagram {}", weather.file_name()),
    };
    let states = counted(plan.states() as u64, "state", "states");
    format!(
        "{rows}, as {states} of {}, each run for {} min.",
        of.scenario,
        significant(of.duration_s / 60.0, 3)
    )
}

fn headline(of: &DowntimeReport<'_>) -> Markup {
    let all = &of.counted.all;
    let share = all.share();
    html! {
        p { strong { (hours(all.lost)) " h of " (hours(all.hours - all.not_run)) " h are lost: " (percent(share)) " %" }
            @if let Some(share) = share {
                (format!(", or {} h in a year of 8760 h", hours(share * HOURS_OF_A_YEAR)))
            }
            "."
        }
        @if let Some((check, own)) = of.counted.check.as_ref().and_then(|check| Some((check, check.disagree.as_ref()?))) {
            p {
                (format!(
                    "Of {} drawn at random and each run with its own weather, {} do not agree with \
                     their state ({}): with their own weather {} more hours would be lost, and {} \
                     other hours would not be lost.",
                    counted(check.compared as u64, "hour", "hours"),
                    check.as_it_is_alone + check.by_state_alone,
                    band(own),
                    check.as_it_is_alone,
                    check.by_state_alone,
                ))
            }
        }
        @if all.not_run > 0.0 {
            p {
                strong class="over" { (format!("{} h could not be run", hours(all.not_run))) }
                ". These hours are not counted in any share. The column `error` of the table has \
                 the reasons."
            }
        }
    }
}

fn reasons(of: &DowntimeReport<'_>) -> Markup {
    let all = &of.counted.all;
    let known = all.hours - all.not_run;
    let what = |name: &str| of.limits.iter().find(|limit| limit.0 == name).map_or("", |own| &own.1);
    html! {
        div class="wide" { table {
            (table_head(&[
                Head::Name("Reason"),
                Head::Text("Limit", ""),
                Head::Number("Exceeded", "h"),
                Head::Number("Share", "%"),
                Head::Number("Alone", "h"),
                Head::Number("Gravest", "h"),
            ]))
            tbody { @for reason in &of.counted.reasons {
                tr {
                    td class="name" { (reason.name) }
                    td { (what(&reason.name)) }
                    td class="number" { (hours(reason.hours)) }
                    td class="number" { (percent((known > 0.0).then(|| reason.hours / known))) }
                    td class="number" { (hours(reason.alone)) }
                    td class="number" { (hours(reason.gravest)) }
                }
            } }
        } }
        p class="note" { "An hour may exceed several limits: “alone” counts hours that exceed only \
            this limit, “gravest” hours that exceed this limit by the largest factor; parted \
            lines, failures and strikes come before limits." }
    }
}

/// The charts and the table of lost hours by month or direction.
fn group_section(of: &DowntimeReport<'_>, group: &Group) -> Markup {
    let is_direction = group.name.ends_with("direction");
    let own: Vec<usize> = (0..of.counted.reasons.len())
        .filter(|kind| of.counted.reasons[*kind].gravest > 0.0)
        .collect();
    let amounts = |count: &Count| own.iter().map(|kind| count.by_reason[*kind]).collect();
    let chart = Stacked {
        title: format!("Hours lost by {}, by their gravest reason", group.name),
        kinds: own.iter().map(|kind| of.counted.reasons[*kind].name.clone()).collect(),
        groups: group.counts.iter().map(|(name, count)| (name.clone(), amounts(count))).collect(),
        axis: ("lost", "h"),
        note: String::new(),
    };
    let from = if is_direction { " (where it comes from)" } else { "" };
    html! {
        h2 { "By " (group.name) (from) }
        @if of.counted.all.lost > 0.0 {
            @if is_direction { (chart.petals()) } @else { (chart.columns()) }
        }
        div class="wide" { table class="narrow" {
            (table_head(&[
                Head::Name(if is_direction { "From" } else { "Month" }),
                Head::Number("Hours", "h"),
                Head::Number("Lost", "h"),
                Head::Number("Share", "%"),
            ]))
            tbody { @for (name, count) in &group.counts {
                @if count.hours > 0.0 { tr {
                    td class="name" { (name) }
                    td class="number" { (hours(count.hours)) }
                    td class="number" { (hours(count.lost)) }
                    td class="number" { (percent(count.share())) }
                } }
            } }
        } }
    }
}

fn check(of: &DowntimeReport<'_>) -> Markup {
    let Some(check) = &of.counted.check else {
        return match of.plan.weather().is_series() {
            true => {
                html! { p { "No single hours were run: `sample` is 0, and the error of the states \
                is not known." } }
            }
            false => {
                html! { p { "Each class of the diagram is a state: no hours were grouped here. The \
                error of the classes of the diagram is not known." } }
            }
        };
    };
    html! {
        p {
            (format!(
                "{} drawn at random by seed {} were run singly, each with its own weather and its \
                 own phases of waves and gusts, and compared with their states.",
                counted(check.compared as u64, "hour", "hours"),
                of.seed,
            ))
            @if check.compared < check.drawn {
                (format!(
                    " {} could not be compared: a run was not made.",
                    counted((check.drawn - check.compared) as u64, "further hour", "further hours"),
                ))
            }
        }
        (check_table(check))
        ul class="plain" {
            @if let Some(own) = &check.disagree {
                li {
                    (format!(
                        "{} of the hours do not agree with their state (Wilson's interval, {} %).",
                        band(own),
                        fixed(100.0 * check.confidence.level(), 0),
                    ))
                }
            }
            @if let Some(own) = &check.lost_as_they_are {
                li {
                    (format!(
                        "Share of lost hours with their own weather: {}; by their states: {} % of \
                         the same hours, and {} % of all hours.",
                        band(own),
                        percent(Some((check.both + check.by_state_alone) as f64 / check.compared as f64)),
                        percent(of.counted.all.share()),
                    ))
                    @if of.counted.all.share().is_some_and(|share| !own.interval.holds(share)) {
                        " The share of lost hours in the sample differs from the share in all \
                         hours: compare both methods for the same hours, or draw more hours."
                    }
                }
            }
            li { "The difference has two causes: the grouping of hours with different weather, and \
                chance, because an hour near a limit exceeds the limit with some waves and gusts \
                and not with others." }
        }
    }
}

fn check_table(check: &StatesCheck) -> Markup {
    html! {
        div class="wide" { table class="narrow" {
            (table_head(&[
                Head::Name("Hour as it is"),
                Head::Number("State lost", "hours"),
                Head::Number("State within limits", "hours"),
            ]))
            tbody {
                tr { td class="name" { "lost" } td class="number" { (check.both) } td class="number" { (check.as_it_is_alone) } }
                tr { td class="name" { "within limits" } td class="number" { (check.by_state_alone) } td class="number" { (check.neither) } }
            }
        } }
    }
}

/// The table of the lost states, the states with most hours first.
fn states(of: &DowntimeReport<'_>) -> Result<Markup, TableError> {
    let mut lost: Vec<usize> = (0..of.plan.states())
        .filter(|state| of.counted.outcomes[*state] != Outcome::Works)
        .collect();
    lost.sort_by(|one, other| {
        of.plan.hours_of(*other).total_cmp(&of.plan.hours_of(*one)).then(one.cmp(other))
    });
    let all = lost.len();
    lost.truncate(LISTED);
    let mut columns = Vec::new();
    for (name, unit) in of.plan.shown() {
        columns.push((name, unit, of.table.numbers(name)?.values));
    }
    let mut heads = vec![Head::Number("State", ""), Head::Number("Hours", "h")];
    let names: Vec<String> = columns.iter().map(|(name, ..)| name.replace('_', " ")).collect();
    heads.extend(names.iter().zip(&columns).map(|(name, (_, unit, _))| Head::Number(name, unit)));
    heads.extend([Head::Text("Lost by", ""), Head::Text("Run it again", "")]);
    Ok(html! {
        p { (counted(all as u64, "state is", "states are")) " lost of " (of.plan.states())
            @if all > LISTED { (format!("; the {LISTED} states with the most hours are listed")) }
            "."
        }
        @if all > 0 {
            div class="wide" { table {
                (table_head(&heads))
                tbody { @for state in lost {
                    tr {
                        td class="number" { (state + 1) }
                        td class="number" { (hours(of.plan.hours_of(state))) }
                        @for (_, _, values) in &columns { td class="number" { (words::number(values[state])) } }
                        td { @match &of.counted.outcomes[state] {
                            Outcome::Lost(reasons) => { (reasons.join("; ")) }
                            _ => { "not run" }
                        } }
                        td { code { ((of.replay)(state)) } }
                    }
                } }
            } }
        }
    })
}

fn methods(of: &DowntimeReport<'_>) -> Markup {
    let is_series = of.plan.weather().is_series();
    html! {
        ul class="plain" {
            @if is_series {
                li { (format!("The hours are grouped into at most {} states. ", of.plan.most_states()))
                    "At first all hours are in one state; then the state with the largest spread in \
                    one quantity is split at its mean, again and again. The spread is measured in \
                    wave height and in the square of the speeds of wind and current, each over the \
                    spread of the whole series; a change of direction (rad), or a change of period \
                    over the mean period, counts as a relative change of wave height or squared \
                    speed. This choice is ours." }
                li { "A state has the root mean square of heights and speeds, the mean of periods \
                    and levels, and the direction of the vector sum of its hours. An hour is lost \
                    if its state is lost; month and direction are taken from the hour." }
            }
            li { "A run is lost if a limit of the scenario is exceeded, a fender is over its \
                rating, a line over its working load, something parts, fails, strikes or grounds, \
                or the result is in doubt. The ship lies at the berth in every hour; she does not \
                leave before a storm, but the hours of the storm are lost in either case." }
            li { "The hours are independent runs: the length of each period of lost hours is in the file " code { "hours.csv" } "." }
            li {
                (format!(
                    "Each run has other phases of waves and gusts, by seed {} and the number of the \
                     run. The same files give the same bits.",
                    of.seed,
                ))
            }
            @for notice in of.notices { li { "Notice of the scenario: " (notice) } }
        }
    }
}
