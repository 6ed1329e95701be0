//! A tornado chart: horizontal bars from −1 to 1 with whiskers for rank correlations, the strongest on top.

use core::fmt::Write as _;

use maud::{Markup, html};

use super::axis::Fitted;
use super::number::{fixed, shortened};

/// Correlations to draw.
#[derive(Clone, Debug, PartialEq)]
pub struct Tornado {
    /// Title, printed above the chart.
    pub title: String,
    /// The bars of the chart, from the top.
    pub bars: Vec<Whisker>,
    /// Title of the horizontal axis.
    pub axis: &'static str,
    /// Note below the chart; empty for none.
    pub note: String,
}

/// A bar with its confidence interval; all values are from −1 to 1.
#[derive(Clone, Debug, PartialEq)]
pub struct Whisker {
    /// Name of the bar, printed left of it.
    pub name: String,
    /// End of the bar.
    pub value: f64,
    /// Lower end of the confidence interval.
    pub low: f64,
    /// Upper end of the confidence interval.
    pub high: f64,
}

const WIDTH: f64 = 720.0;
const RIGHT: f64 = 60.0;
const TOP: f64 = 8.0;
const BOTTOM: f64 = 38.0;
const PITCH: f64 = 24.0;
const BAR: f64 = 14.0;
/// Longest name (characters).
const NAME: usize = 26;
/// Mean width of a letter of a name (px).
const LETTER: f64 = 6.6;

impl Tornado {
    /// Draws the tornado chart as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let axis = Fitted::new(-1.0, 1.0, 0.2);
        let names = self.bars.iter().map(|bar| bar.name.chars().count().min(NAME)).max();
        let left = 14.0 + LETTER * names.and_then(|n| u32::try_from(n).ok()).map_or(8.0, f64::from);
        let base = TOP + PITCH * self.bars.len() as f64;
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
                    @for (index, bar) in self.bars.iter().enumerate() {
                        (drawn(bar, TOP + PITCH * (index as f64 + 0.5), left, &px))
                    }
                    path class="zero" d=(format!("M{:.1},{TOP}V{base:.1}", px(0.0))) {}
                    path class="frame" d=(format!("M{left:.1},{base:.1}H{:.1}", WIDTH - RIGHT)) {}
                    g class="ticks" {
                        @for (value, label) in axis.ticks() {
                            text x=(format!("{:.1}", px(value))) y=(format!("{:.1}", base + 14.0))
                                text-anchor="middle" { (label) }
                        }
                    }
                    text class="axis" x=(format!("{:.1}", px(0.0)))
                        y=(format!("{:.1}", base + BOTTOM - 7.0)) text-anchor="middle" { (self.axis) }
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }
}

fn drawn(bar: &Whisker, middle: f64, left: f64, px: &dyn Fn(f64) -> f64) -> Markup {
    let (zero, end) = (px(0.0), px(bar.value));
    let (x, width) = if bar.value < 0.0 { (end, zero - end) } else { (zero, end - zero) };
    // What raises the output is dark, what lowers it light: grey print tells them apart.
    let fill = if bar.value < 0.0 { "#b5daf0" } else { "#3f8fc4" };
    html! {
        text class="axis" x=(format!("{:.1}", left - 6.0)) y=(format!("{:.1}", middle + 3.5))
            text-anchor="end" { (shortened(&bar.name, NAME)) }
        rect x=(format!("{x:.1}")) y=(format!("{:.1}", middle - 0.5 * BAR)) height=(BAR)
            width=(format!("{width:.1}")) fill=(fill) stroke="#0b3a5b" stroke-width="0.8" {}
        path d=(format!("M{:.1},{middle:.1}H{:.1}", px(bar.low), px(bar.high)))
            fill="none" stroke="#1b2430" stroke-width="1.4" {}
        text class="value" x=(format!("{:.1}", WIDTH - RIGHT + 8.0)) y=(format!("{:.1}", middle + 3.5)) {
            (fixed(bar.value, 2))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bars_go_to_both_sides_of_zero() {
        let bar = |name: &str, value| Whisker {
            name: name.to_owned(),
            value,
            low: value - 0.1,
            high: value + 0.1,
        };
        let svg = Tornado {
            title: "<b>".to_owned(),
            bars: vec![bar("<speed>", 0.8), bar("angle", -0.3)],
            axis: "rank correlation",
            note: String::new(),
        }
        .render()
        .into_string();
        assert!(!svg.contains("<speed>") && !svg.contains("NaN"), "{svg}");
        assert!(svg.contains("0.80") && svg.contains("\u{2212}0.30"));
    }
}
