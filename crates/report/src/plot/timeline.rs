//! A chart of lanes over time: marks show what happened at a moment, bars show what lasted.

use core::fmt::Write as _;

use maud::{Markup, html};

use super::axis::Axis;
use super::number::shortened;

/// A timeline of lanes to draw, the first lane on top.
#[derive(Clone, Debug, PartialEq)]
pub struct Timeline {
    /// Title, printed above the chart.
    pub title: String,
    /// The horizontal axis of the chart, with its range.
    pub x: Axis,
    /// The lanes of the chart, each on its own line.
    pub lanes: Vec<Lane>,
    /// Note below the chart; empty for none.
    pub note: String,
}

/// A lane.
#[derive(Clone, Debug, PartialEq)]
pub struct Lane {
    /// Name of the lane, printed left of it.
    pub name: String,
    /// Whether the bars and marks of the lane are drawn dark.
    pub is_grave: bool,
    /// Bars and marks of the lane.
    pub spans: Vec<Span>,
}

/// A bar or a mark of a lane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Where the bar begins on the axis.
    pub from: f64,
    /// Where the bar ends; a mark ends where it begins.
    pub to: f64,
    /// How a bar is filled.
    pub fill: Fill,
}

/// The fill of a bar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fill {
    /// The bar has the lane's colour.
    Full,
    /// The bar has the lane's colour, but faint.
    Faint,
    /// The bar is not filled; only its dashed outline is drawn.
    Hollow,
}

impl Span {
    /// A mark.
    #[must_use]
    pub fn mark(at: f64) -> Span {
        Span { from: at, to: at, fill: Fill::Full }
    }

    /// The bar or mark with its ends converted to another unit, by division.
    #[must_use]
    pub fn over(self, unit: f64) -> Span {
        Span { from: self.from / unit, to: self.to / unit, ..self }
    }

    fn is_mark(&self) -> bool {
        self.from >= self.to
    }
}

impl Lane {
    fn ends(&self) -> impl Iterator<Item = f64> {
        self.spans.iter().flat_map(|span| [span.from, span.to])
    }
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
/// Smallest width of a bar (px), so that a short alarm can be seen.
const LEAST: f64 = 2.0;
const TICKS: u32 = 8;

impl Timeline {
    /// Draws the timeline as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let axis = self.x.fit(self.lanes.iter().flat_map(Lane::ends), TICKS);
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
    for span in lane.spans.iter().filter(|span| span.is_mark()) {
        let _ = write!(marks, "M{:.1},{:.1}v{BAR}", px(span.from), middle - half);
    }
    html! {
        text class="axis" x=(format!("{:.1}", left - 6.0)) y=(format!("{:.1}", middle + 3.5))
            text-anchor="end" { (shortened(&lane.name, NAME)) }
        @for span in lane.spans.iter().filter(|span| !span.is_mark()) {
            (bar(span, fill, px(span.from), px(span.to), middle - half))
        }
        @if !marks.is_empty() { path d=(marks) fill="none" stroke="#0b3a5b" stroke-width="2" {} }
    }
}

fn bar(span: &Span, colour: &str, from_px: f64, to_px: f64, top: f64) -> Markup {
    let opacity = match span.fill {
        Fill::Full => "1",
        Fill::Faint => "0.35",
        Fill::Hollow => "0",
    };
    let (stroke, dashes) =
        if span.fill == Fill::Hollow { (colour, "3 2") } else { ("#1b2430", "none") };
    let wide = fenderline_contact::number::greater(to_px - from_px, LEAST);
    html! {
        rect x=(format!("{from_px:.1}")) y=(format!("{top:.1}")) height=(BAR) width=(format!("{wide:.1}"))
            fill=(colour) fill-opacity=(opacity) stroke=(stroke) stroke-dasharray=(dashes)
            stroke-width="0.7" {}
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
                lane("<pilot>", vec![Span::mark(5.0), Span::mark(60.0)]),
                lane(
                    "speed",
                    vec![
                        Span { from: 10.0, to: 50.0, fill: Fill::Full },
                        Span { from: 50.0, to: 90.0, fill: Fill::Hollow },
                    ],
                ),
            ],
            note: String::new(),
        }
        .render()
        .into_string();
        assert!(!svg.contains("<pilot>") && !svg.contains("NaN"), "{svg}");
        assert_eq!(svg.matches("<rect").count(), 2);
        assert_eq!(svg.matches("v11").count(), 2);
        assert_eq!(svg.matches("fill-opacity=\"0\"").count(), 1);
    }
}
