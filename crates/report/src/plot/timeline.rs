//! Lanes over time: marks for what happened at a moment, bars for what lasted.

use core::fmt::Write as _;

use maud::{Markup, html};

use super::axis::Axis;
use super::number::shortened;

/// Lanes to draw, the first on top.
#[derive(Clone, Debug, PartialEq)]
pub struct Timeline {
    /// Printed above.
    pub title: String,
    /// The horizontal axis, with its range.
    pub x: Axis,
    /// One line each.
    pub lanes: Vec<Lane>,
    /// The note below; empty for none.
    pub note: String,
}

/// A lane.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Printed left of it.
    pub name: String,
    /// Draws its bars and marks dark.
    pub is_grave: bool,
    /// Where each begins and ends on the axis; a mark begins and ends at the same place.
    pub spans: Vec<[f64; 2]>,
}

const WIDTH: f64 = 720.0;
const RIGHT: f64 = 18.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 38.0;
const PITCH: f64 = 20.0;
const BAR: f64 = 11.0;
/// Longest name (characters).
const NAME: usize = 34;
/// Mean width of a letter of a name (px).
const LETTER: f64 = 6.3;
/// A bar is at least as wide, so that a short alarm can be seen (px).
const LEAST: f64 = 2.0;
const TICKS: u32 = 8;

impl Timeline {
    /// The lanes as a `figure`.
    pub fn render(&self) -> Markup {
        let axis = self.x.fit(self.lanes.iter().flat_map(|lane| lane.spans.concat()), TICKS);
        let names = self.lanes.iter().map(|lane| lane.name.chars().count().min(NAME)).max();
        let left = 14.0 + LETTER * names.and_then(|n| u32::try_from(n).ok()).map_or(8.0, f64::from);
        let base = TOP + PITCH * self.lanes.len() as f64;
        let px = |value: f64| left + axis.share(value) * (WIDTH - RIGHT - left);
        let mut grid = String::new();
        for (value, _) in axis.ticks() {
            let _ = write!(grid, "M{:.1},{TOP}V{base:.1}", px(value));
        }
        html! {
            figure class="bars" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {WIDTH} {:.1}", base + BOTTOM)) role="img"
                    aria-label=(self.title) {
                    path class="grid" d=(grid) {}
                    @for (index, lane) in self.lanes.iter().enumerate() {
                        (drawn(lane, TOP + PITCH * (index as f64 + 0.5), left, &px))
                    }
                    path class="frame" d=(format!("M{left:.1},{base:.1}H{:.1}", WIDTH - RIGHT)) {}
                    g class="ticks" {
                        @for (value, label) in axis.ticks() {
                            text x=(format!("{:.1}", px(value))) y=(format!("{:.1}", base + 14.0))
                                text-anchor="middle" { (label) }
                        }
                    }
                    text class="axis" x=(format!("{:.1}", 0.5 * (left + WIDTH - RIGHT)))
                        y=(format!("{:.1}", base + BOTTOM - 7.0)) text-anchor="middle" { (self.x.title()) }
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }
}

fn drawn(lane: &Lane, middle: f64, left: f64, px: &dyn Fn(f64) -> f64) -> Markup {
    let fill = if lane.is_grave { "#7a0019" } else { "#e0a030" };
    let (mut marks, half) = (String::new(), 0.5 * BAR);
    for [at, _] in lane.spans.iter().filter(|[from, to]| from >= to) {
        let _ = write!(marks, "M{:.1},{:.1}v{BAR}", px(*at), middle - half);
    }
    html! {
        text class="axis" x=(format!("{:.1}", left - 6.0)) y=(format!("{:.1}", middle + 3.5))
            text-anchor="end" { (shortened(&lane.name, NAME)) }
        @for [from, to] in lane.spans.iter().filter(|[from, to]| from < to) {
            rect x=(format!("{:.1}", px(*from))) y=(format!("{:.1}", middle - half)) height=(BAR)
                width=(format!("{:.1}", fenderline_contact::number::greater(px(*to) - px(*from), LEAST)))
                fill=(fill) stroke="#1b2430" stroke-width="0.5" {}
        }
        @if !marks.is_empty() { path d=(marks) fill="none" stroke="#0b3a5b" stroke-width="2" {} }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn moments_are_marks_and_what_lasts_is_a_bar() {
        let lane = |name: &str, spans| Lane { name: name.to_owned(), is_grave: false, spans };
        let svg = Timeline {
            title: "<b>".to_owned(),
            x: Axis::new("time", "s").including(0.0).including(100.0).tight(),
            lanes: vec![
                lane("<pilot>", vec![[5.0, 5.0], [60.0, 60.0]]),
                lane("speed", vec![[10.0, 90.0]]),
            ],
            note: String::new(),
        }
        .render()
        .into_string();
        assert!(!svg.contains("<pilot>") && !svg.contains("NaN"), "{svg}");
        assert_eq!(svg.matches("<rect").count(), 1);
        assert_eq!(svg.matches("v11").count(), 2);
    }
}
