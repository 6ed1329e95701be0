//! The report's section on the session that a run repeats: who did what and when, and the alarms, on a time axis and as
//! a list.

use fenderline_contact::number::lesser;
use fenderline_results::{LogKind, LogLine, Outcome, RecordedSession};
use maud::{Markup, html};

use super::charts::Charts;
use super::tables::number;
use crate::plot::{Fill, Lane, Span, Timeline, counted, fixed};
use crate::{Head, table_head};

/// Largest number of lanes of the chart for each kind; more lanes cannot be read.
const LANES: usize = 12;
/// Largest number of lines of the list.
const LINES: usize = 400;

/// Writes the description of the session, its chart and its log; empty for a run that nobody steered.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(session) = outcome.session else { return html! {} };
    html! {
        h2 { "Log of the session" }
        p { (sentence(session)) }
        @if let Some(missing) = &session.missing_at_end {
            p class="note" { (format!("The recording is not complete: {missing}.")) }
        }
        @if session.log.is_empty() {
            p { "Nobody gave a command in this session, and there was no alarm." }
        } @else {
            (picture(outcome, session))
            (list(&session.log))
        }
    }
}

/// The name of the recording with its branch.
pub(super) fn name(session: &RecordedSession) -> String {
    match session.branches {
        1 => session.file.clone(),
        _ => format!("{}, branch {}", session.file, session.branch),
    }
}

fn sentence(session: &RecordedSession) -> String {
    let count = |kind| session.log.iter().filter(|line| line.kind == kind).count() as u64;
    format!(
        "{}: {}, {}, {}, {}.",
        name(session),
        counted(count(LogKind::Command), "command", "commands"),
        counted(count(LogKind::Alarm), "alarm", "alarms"),
        counted(count(LogKind::Caution), "caution", "cautions"),
        counted(count(LogKind::Note), "note", "notes")
    )
}

/// The chart of the session: a lane for the notes, a lane for each person with marks for the commands, and a lane for
/// each alarm and caution with its states.
fn picture(outcome: &Outcome<'_>, session: &RecordedSession) -> Markup {
    let charts = Charts::new(outcome);
    let (_, unit_s) = charts.unit();
    let end_s = charts.end_s();
    let mut notes: Vec<Span> = Vec::new();
    let mut deductions: Vec<Span> = Vec::new();
    let mut people: Vec<Lane> = Vec::new();
    let mut alarms: Vec<(&str, Lane)> = Vec::new();
    for line in &session.log {
        let mark = Span::mark(line.t_s / unit_s);
        match line.kind {
            LogKind::Command => match people.iter_mut().find(|lane| lane.name == line.who) {
                Some(lane) => lane.spans.push(mark),
                None => people.push(lane(&line.who, false, vec![mark])),
            },
            LogKind::Alarm | LogKind::Caution => {
                let spans = states(line, end_s).into_iter().map(|span| span.over(unit_s));
                let is_grave = line.kind == LogKind::Alarm;
                let same =
                    |(key, lane): &&mut (&str, Lane)| *key == line.key && lane.is_grave == is_grave;
                match alarms.iter_mut().find(same) {
                    Some((_, lane)) => lane.spans.extend(spans),
                    None => alarms.push((&line.key, lane(&line.text, is_grave, spans.collect()))),
                }
            }
            LogKind::Note => notes.push(mark),
            LogKind::Deduction => deductions.push(mark),
            LogKind::Acknowledgement | LogKind::Event => {}
        }
    }
    if !deductions.is_empty() {
        people.insert(0, lane("exercise: deductions", false, deductions));
    }
    if !notes.is_empty() {
        people.insert(0, lane("notes", false, notes));
    }
    let mut alarms: Vec<Lane> = alarms.into_iter().map(|(_, lane)| lane).collect();
    // A stable sort: alarms before cautions, each in the order of time.
    alarms.sort_by_key(|lane| !lane.is_grave);
    let left_out = people.len().saturating_sub(LANES) + alarms.len().saturating_sub(LANES);
    people.truncate(LANES);
    alarms.truncate(LANES);
    let mut note =
        "Marks: commands, notes, and the moment when a limit of the exercise was first exceeded. \
         Dark red: alarms; amber: cautions; the text is that of the first alarm or caution. Full \
         bar: active and not acknowledged. Faint bar: active, acknowledged. Dashed outline: the cause is over, but \
         nobody has acknowledged the alarm."
            .to_owned();
    if left_out > 0 {
        note += &format!(" {left_out} more lanes are only in the list.");
    }
    let lanes: Vec<Lane> = people.into_iter().chain(alarms).collect();
    if lanes.is_empty() {
        return html! {};
    }
    let title = "Commands, alarms and cautions".to_owned();
    Timeline { title, x: charts.time_axis(), lanes, note }.render()
}

fn lane(name: &str, is_grave: bool, spans: Vec<Span>) -> Lane {
    Lane { name: name.to_owned(), is_grave, spans }
}

/// The states of an alarm as bars (s). A caution is removed when its cause ends; an alarm waits until it is
/// acknowledged.
fn states(line: &LogLine, end_s: f64) -> Vec<Span> {
    let over_s = line.until_s.unwrap_or(end_s);
    let seen_s = line.acknowledged.as_ref().map_or(f64::INFINITY, |(at_s, _)| *at_s);
    let mut spans = vec![Span { from: line.t_s, to: lesser(seen_s, over_s), fill: Fill::Full }];
    if seen_s < over_s {
        spans.push(Span { from: seen_s, to: over_s, fill: Fill::Faint });
    } else if line.kind == LogKind::Alarm && over_s < end_s {
        spans.push(Span { from: over_s, to: lesser(seen_s, end_s), fill: Fill::Hollow });
    }
    // An alarm that was acknowledged in the tick in which it began has no full bar.
    spans.retain(|span| span.from < span.to);
    spans
}

fn list(log: &[LogLine]) -> Markup {
    html! {
        div class="wide" {
            table {
                (table_head(&[
                    Head::Number("Time", "min:s"),
                    Head::Name("Kind"),
                    Head::Name("Who"),
                    Head::Name("What"),
                    Head::Number("Lasted", "s"),
                    Head::Name("Acknowledged"),
                ]))
                tbody {
                    @for line in log.iter().take(LINES) {
                        tr class=[(line.kind == LogKind::Alarm).then_some("strong")] {
                            (number(&clock(line.t_s)))
                            td { (line.kind.word()) }
                            td class="name" { (line.who) }
                            td class="name" { (line.text) }
                            (number(&lasted(line)))
                            td class="name" { (acknowledged(line)) }
                        }
                    }
                }
            }
        }
        @if log.len() > LINES {
            p class="note" { "and " (log.len() - LINES) " more lines, in summary.json" }
        }
        p class="note" {
            "A command takes effect at the time that is shown. An alarm whose cause comes back \
             within ten seconds, before anybody acknowledged it, is one line."
        }
    }
}

fn lasted(line: &LogLine) -> String {
    match (line.kind, line.until_s) {
        (
            LogKind::Command
            | LogKind::Acknowledgement
            | LogKind::Note
            | LogKind::Deduction
            | LogKind::Event,
            _,
        ) => String::new(),
        (_, Some(until_s)) => fixed(until_s - line.t_s, 1),
        (_, None) => "to the end".to_owned(),
    }
}

/// Words that say when and by whom an alarm was acknowledged.
fn acknowledged(line: &LogLine) -> String {
    match (&line.acknowledged, line.kind) {
        (Some((at_s, who)), _) => format!("{}, {who}", clock(*at_s)),
        (None, LogKind::Alarm) => "by nobody".to_owned(),
        (None, _) => String::new(),
    }
}

/// The text of a time as minutes and seconds since the start.
pub(super) fn clock(t_s: f64) -> String {
    let tenths = libm::round(t_s * 10.0);
    let minutes = libm::floor(tenths / 600.0);
    let seconds = (tenths - minutes * 600.0) / 10.0;
    format!("{minutes:.0}:{seconds:04.1}")
}

#[cfg(test)]
mod tests {
    use fenderline_results::{LogKind, LogLine};

    use super::{clock, states};
    use crate::plot::Fill;

    #[test]
    fn a_time_that_rounds_up_to_a_minute_is_a_minute() {
        assert_eq!(clock(0.0), "0:00.0");
        assert_eq!(clock(59.96), "1:00.0");
        assert_eq!(clock(754.3), "12:34.3");
        assert_eq!(clock(7325.0), "122:05.0");
    }

    #[test]
    fn an_alarm_has_three_states_on_the_axis() {
        let alarm = |kind, until_s, seen_s: Option<f64>| LogLine {
            t_s: 10.0,
            until_s,
            kind,
            who: String::new(),
            text: "touches".to_owned(),
            acknowledged: seen_s.map(|at_s| (at_s, "pilot 1".to_owned())),
            key: "touch".to_owned(),
        };
        let bars = |line: &LogLine| -> Vec<(f64, f64, Fill)> {
            states(line, 100.0).iter().map(|span| (span.from, span.to, span.fill)).collect()
        };
        let (grave, light) = (LogKind::Alarm, LogKind::Caution);
        for (line, expected) in [
            (alarm(grave, None, None), vec![(10.0, 100.0, Fill::Full)]),
            (
                alarm(grave, Some(30.0), Some(20.0)),
                vec![(10.0, 20.0, Fill::Full), (20.0, 30.0, Fill::Faint)],
            ),
            (
                alarm(grave, Some(30.0), Some(50.0)),
                vec![(10.0, 30.0, Fill::Full), (30.0, 50.0, Fill::Hollow)],
            ),
            (
                alarm(grave, Some(30.0), None),
                vec![(10.0, 30.0, Fill::Full), (30.0, 100.0, Fill::Hollow)],
            ),
            (alarm(light, Some(30.0), None), vec![(10.0, 30.0, Fill::Full)]),
            (alarm(grave, Some(30.0), Some(10.0)), vec![(10.0, 30.0, Fill::Faint)]),
        ] {
            assert_eq!(bars(&line), expected, "{line:?}");
        }
    }
}
