//! The session that a run repeats: who did what and when, and the alarms, on one time axis and as a list.

use fenderline_results::{LogKind, LogLine, Outcome, RecordedSession};
use maud::{Markup, html};

use super::charts::Charts;
use super::tables::number;
use crate::plot::{Lane, Timeline, counted, fixed};
use crate::{Head, table_head};

/// Most lanes of the picture for each kind: more cannot be read.
const LANES: usize = 12;
/// Most lines of the list.
const LINES: usize = 400;

/// What the session was, its picture and its log; nothing for a run that nobody steered.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let Some(session) = outcome.session else { return html! {} };
    html! {
        h2 { "Log of the session" }
        p { (sentence(session)) }
        @if let Some(missing) = &session.missing_at_end {
            p class="note" { "The recording is not complete: " (missing) "." }
        }
        @if session.log.is_empty() {
            p { "Nobody gave a command, and there was no alarm." }
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
        "{}: {}, {}, {}.",
        name(session),
        counted(count(LogKind::Command), "command", "commands"),
        counted(count(LogKind::Alarm), "alarm", "alarms"),
        counted(count(LogKind::Caution), "caution", "cautions")
    )
}

/// A lane for each person with marks for the commands, then one for each alarm and caution.
fn picture(outcome: &Outcome<'_>, session: &RecordedSession) -> Markup {
    let charts = Charts::new(outcome);
    let (_, unit_s) = charts.unit();
    let end_s = charts.end_s();
    let mut people: Vec<Lane> = Vec::new();
    let mut alarms: Vec<(&str, Lane)> = Vec::new();
    for line in &session.log {
        let span = |until_s: f64| [line.t_s / unit_s, until_s / unit_s];
        match line.kind {
            LogKind::Command => match people.iter_mut().find(|lane| lane.name == line.who) {
                Some(lane) => lane.spans.push(span(line.t_s)),
                None => people.push(lane(&line.who, false, span(line.t_s))),
            },
            LogKind::Alarm | LogKind::Caution => {
                let span = span(line.until_s.unwrap_or(end_s));
                let is_grave = line.kind == LogKind::Alarm;
                let same =
                    |(key, lane): &&mut (&str, Lane)| *key == line.key && lane.is_grave == is_grave;
                match alarms.iter_mut().find(same) {
                    Some((_, lane)) => lane.spans.push(span),
                    None => alarms.push((&line.key, lane(&line.text, is_grave, span))),
                }
            }
            LogKind::Event => {}
        }
    }
    let mut alarms: Vec<Lane> = alarms.into_iter().map(|(_, lane)| lane).collect();
    // A stable sort: alarms before cautions, each in the order of time.
    alarms.sort_by_key(|lane| !lane.is_grave);
    let left_out = people.len().saturating_sub(LANES) + alarms.len().saturating_sub(LANES);
    people.truncate(LANES);
    alarms.truncate(LANES);
    let mut note =
        "Marks: commands. Dark bars: alarms. Light bars: cautions, from begin to end. The text is that of the first."
            .to_owned();
    if left_out > 0 {
        note += &format!(" {left_out} more are in the list only.");
    }
    let lanes: Vec<Lane> = people.into_iter().chain(alarms).collect();
    if lanes.is_empty() {
        return html! {};
    }
    let title = "Commands, alarms and cautions".to_owned();
    Timeline { title, x: charts.time_axis(), lanes, note }.render()
}

fn lane(name: &str, is_grave: bool, span: [f64; 2]) -> Lane {
    Lane { name: name.to_owned(), is_grave, spans: vec![span] }
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
                ]))
                tbody {
                    @for line in log.iter().take(LINES) {
                        tr class=[(line.kind == LogKind::Alarm).then_some("strong")] {
                            (number(&clock(line.t_s)))
                            td { (line.kind.word()) }
                            td class="name" { (line.who) }
                            td class="name" { (line.text) }
                            (number(&lasted(line)))
                        }
                    }
                }
            }
        }
        @if log.len() > LINES {
            p class="note" { "and " (log.len() - LINES) " more lines, in summary.json" }
        }
        p class="note" {
            "A command takes effect at its time. An alarm whose cause comes back within ten seconds is one line."
        }
    }
}

fn lasted(line: &LogLine) -> String {
    match (line.kind, line.until_s) {
        (LogKind::Command | LogKind::Event, _) => String::new(),
        (_, Some(until_s)) => fixed(until_s - line.t_s, 1),
        (_, None) => "to the end".to_owned(),
    }
}

/// Minutes and seconds since the start.
fn clock(t_s: f64) -> String {
    let tenths = libm::round(t_s * 10.0);
    let minutes = libm::floor(tenths / 600.0);
    let seconds = (tenths - minutes * 600.0) / 10.0;
    format!("{minutes:.0}:{seconds:04.1}")
}

#[cfg(test)]
mod tests {
    use super::clock;

    #[test]
    fn a_time_that_rounds_up_to_a_minute_is_a_minute() {
        assert_eq!(clock(0.0), "0:00.0");
        assert_eq!(clock(59.96), "1:00.0");
        assert_eq!(clock(754.3), "12:34.3");
        assert_eq!(clock(7325.0), "122:05.0");
    }
}
