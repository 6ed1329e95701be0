//! Writes the events of a run in words.

use fenderline_contact::EventKind;
use fenderline_results::Interrupted;
use fenderline_sim::WorldEventKind;

use maud::{Markup, html};

use crate::plot::plain;

/// Words that say where a run was interrupted.
pub fn interrupted_text(interrupted: &Interrupted) -> String {
    let Interrupted { steps, of_steps, at_s, of_s } = interrupted;
    // Without thousands separators, because the terminal prints it too.
    let [at_s, of_s] = [*at_s, *of_s].map(|s| plain(s, 9).replace('\u{202f}', ""));
    format!(
        "stopped by the user after {steps} of {of_steps} steps, at {at_s} of {of_s} s; results cover \
         the time up to the stop"
    )
}

/// Words for a kind of contact event, for readers of the report.
pub fn event_text(kind: EventKind) -> &'static str {
    match kind {
        EventKind::ContactBegan => "a contact began",
        EventKind::ContactEnded => "a contact ended",
        EventKind::PatchSplit => "one patch of contact became several",
        EventKind::PatchesMerged => "several patches of contact became one",
        EventKind::Contained => {
            "a body was entirely inside another: the overlap no longer grew with depth"
        }
        EventKind::DeepOverlap => {
            "an overlap covered more than half the area of the smaller body: the force law is not valid \
             there"
        }
        EventKind::Teleported => "a body moved farther than its velocities explain (teleported)",
        EventKind::NotConverged => {
            "the coupled contact solver did not converge within its iteration limit"
        }
        EventKind::PlacedInOverlap => {
            "a body was placed deep inside another and is pressed out slowly"
        }
        EventKind::MassMismatch => "a body moves with a mass other than the model's",
        EventKind::FenderRatingExceeded(_) => "a fender was deflected beyond its rating",
        EventKind::FenderFailed(_) => {
            "a fender FAILED: its stop, or the structure behind it, held the hull"
        }
    }
}

/// Words for a kind of event of vessels, tugs, lines and anchors, for readers of the report.
pub fn world_event_text(kind: WorldEventKind) -> &'static str {
    match kind {
        WorldEventKind::OrderClamped => "an order was beyond its limit and was set to the limit",
        WorldEventKind::Aground => "AGROUND: the water is no deeper than draught plus squat",
        WorldEventKind::ShallowHeld => {
            "water depth below 1.1 draughts, where no formula is valid: shallow-water effects keep \
             their value for 1.1"
        }
        WorldEventKind::TugLimited => {
            "the tug cannot give the ordered force at this speed and angle"
        }
        WorldEventKind::TugOrderRefused => "an order was refused: force or direction not possible",
        WorldEventKind::LineNotMadeFast => {
            "the line could not be made fast: it is too short, the pretension is not possible, or the \
             bollard is taken or out of reach"
        }
        WorldEventKind::LineMadeFast => "the line is fast at the bollard to which it was sent",
        WorldEventKind::LineParted => "PARTED",
        WorldEventKind::LineNotParted => "the line was planned to part, but was not fast",
        WorldEventKind::LineRenders => "the brake of the winch rendered",
        WorldEventKind::Anchor(event) => event.text(),
    }
}

/// Marks up a text: names of keys and commands that stand between backticks become code.
pub fn with_code(text: &str) -> Markup {
    let parts: Vec<&str> = text.split('`').collect();
    // An odd number of backticks: the last one is a backtick.
    let pairs = (parts.len() - 1) / 2;
    html! {
        @for (index, part) in parts.iter().enumerate() {
            @if index % 2 == 1 && index < 2 * pairs { code { (part) } }
            @else if index > 2 * pairs { "`" (part) }
            @else { (part) }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_between_backticks_are_code() {
        assert_eq!(with_code("a `b` <c>").into_string(), "a <code>b</code> &lt;c&gt;");
        assert_eq!(with_code("`b` and `c`").into_string(), "<code>b</code> and <code>c</code>");
        assert_eq!(with_code("one ` only").into_string(), "one ` only");
        assert_eq!(with_code("`b` and `").into_string(), "<code>b</code> and `");
        assert_eq!(with_code("none").into_string(), "none");
    }
}
