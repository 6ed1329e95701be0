//! A chart of horizontal bars in groups that show shares of a limit, with one group for each fender, line or the like.

use fenderline_contact::number::{greater, lesser};

use core::fmt::Write as _;

use maud::{Markup, html};

use super::axis::{Fitted, nice_step};
use super::number::{fixed, shortened};

/// A bar chart to draw, in per cent of a limit that is 100 %.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    /// Title, printed above the chart.
    pub title: String,
    /// Names of the bars in a group, such as reaction and energy; at most four.
    pub kinds: Vec<&'static str>,
    /// The groups of bars, from the top, one for each fender, line or the like.
    pub groups: Vec<Group>,
    /// Title of the horizontal axis.
    pub axis: &'static str,
    /// Note below the chart; empty for none.
    pub note: String,
}

/// The group of bars of one fender, line or the like.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// Label of the group, printed left of its bars.
    pub name: String,
    /// Value of each bar of the group (%); `None` for no bar.
    pub values: Vec<Option<f64>>,
}

const WIDTH: f64 = 720.0;
const RIGHT: f64 = 48.0;
const TOP: f64 = 16.0;
const BOTTOM: f64 = 38.0;
const BAR: f64 = 9.0;
const PITCH: f64 = 11.0;
const BETWEEN: f64 = 9.0;
/// Longest name (characters).
const NAME: usize = 22;
/// Mean width of a letter of a name (px).
const LETTER: f64 = 6.6;
/// Longest drawn bar (%): a longer bar is cut here, so that one failure does not flatten the other bars.
const LONGEST: f64 = 250.0;

/// Fill colours of the bars from dark to light, so that the bars can be distinguished in grey print.
const FILLS: [&str; 4] = ["#0b3a5b", "#3f8fc4", "#b5daf0", "#ffffff"];

impl Bars {
    /// Draws the bar chart as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let values = self.groups.iter().flat_map(|g| g.values.iter().flatten());
        let largest = lesser(values.copied().fold(110.0, greater), LONGEST);
        let step = nice_step(largest, 8);
        let axis = Fitted::new(0.0, libm::ceil(largest / step) * step, step);
        let names = self.groups.iter().map(|g| g.name.chars().count().min(NAME)).max();
        let left = 14.0 + LETTER * names.and_then(|n| u32::try_from(n).ok()).map_or(8.0, f64::from);
        let each = PITCH * self.kinds.len() as f64 + BETWEEN;
        let base = TOP + each * self.groups.len() as f64;
        let px = |value: f64| left + axis.share(value) * (WIDTH - RIGHT - left);
        let mut grid = String::new();
        for (value, _) in axis.ticks() {
            let _ = write!(grid, "M{:.1},{TOP}V{base:.1}", px(value));
        }
        html! {
            figure class="bars" {
                figcaption { (self.title) }
                (self.legend())
                svg viewBox=(format!("0 0 {WIDTH} {:.1}", base + BOTTOM)) role="img"
                    aria-label=(self.title) {
                    path class="grid" d=(grid) {}
                    @for (index, group) in self.groups.iter().enumerate() {
                        @let top = TOP + each * index as f64 + 0.5 * BETWEEN;
                        text class="axis" x=(format!("{:.1}", left - 6.0)) text-anchor="end"
                            y=(format!("{:.1}", top + 0.5 * (each - BETWEEN) + 3.5)) {
                            (shortened(&group.name, NAME))
                        }
                        @for (kind, value) in group.values.iter().enumerate() {
                            @if let Some(value) = value {
                                (bar(kind, left, px(lesser(*value, LONGEST)), top + PITCH * kind as f64))
                            }
                        }
                    }
                    path class="reference" d=(format!("M{:.1},{TOP}V{base:.1}", px(100.0))) {}
                    @for (index, group) in self.groups.iter().enumerate() {
                        @let top = TOP + each * index as f64 + 0.5 * BETWEEN;
                        @for (kind, value) in group.values.iter().enumerate() {
                            @if let Some(value) = value {
                                (label(*value, px(lesser(*value, LONGEST)), top + PITCH * kind as f64))
                            }
                        }
                    }
                    text class="reference" x=(format!("{:.1}", px(100.0))) y=(TOP - 4.0)
                        text-anchor="middle" { "100 %" }
                    path class="frame" d=(format!("M{left:.1},{TOP}V{base:.1}H{:.1}", WIDTH - RIGHT)) {}
                    g class="ticks" {
                        @for (value, label) in axis.ticks() {
                            text x=(format!("{:.1}", px(value))) y=(format!("{:.1}", base + 14.0))
                                text-anchor="middle" { (label) }
                        }
                    }
                    text class="axis" x=(format!("{:.1}", px(0.5 * axis.hi)))
                        y=(format!("{:.1}", base + BOTTOM - 7.0)) text-anchor="middle" { (self.axis) }
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }

    fn legend(&self) -> Markup {
        html! {
            ul class="legend" {
                @for (kind, name) in self.kinds.iter().enumerate() {
                    li {
                        svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                            rect x="2" y="2" width="26" height="8" fill=(FILLS[kind % 4])
                                stroke="#0b3a5b" {}
                        }
                        (name)
                    }
                }
            }
        }
    }
}

fn bar(kind: usize, left: f64, right: f64, top: f64) -> Markup {
    html! {
        rect x=(format!("{left:.1}")) y=(format!("{top:.1}")) height=(BAR)
            width=(format!("{:.1}", greater(right - left, 0.5))) fill=(FILLS[kind % 4])
            stroke="#0b3a5b" stroke-width="0.8" {}
    }
}

/// Draws the value at the end of its bar. A bar that is cut gets a mark.
fn label(value: f64, right: f64, top: f64) -> Markup {
    let weight = if value > 100.0 { "700" } else { "400" };
    html! {
        text class="value halo" x=(format!("{:.1}", right + 4.0)) font-weight=(weight)
            y=(format!("{:.1}", top + BAR - 1.0)) {
            @if value > LONGEST { "» " } (fixed(value, 0))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_of_a_huge_share_is_cut_and_shows_its_value() {
        let group = |name: &str, value| Group { name: name.to_owned(), values: vec![value] };
        let svg = Bars {
            title: "<b>".to_owned(),
            kinds: vec!["energy"],
            groups: vec![group("<i>", Some(1234.0)), group("b", None), group("c", Some(0.0))],
            axis: "per cent",
            note: String::new(),
        }
        .render()
        .into_string();
        assert!(svg.contains("» 1234") && !svg.contains("<i>") && !svg.contains("NaN"), "{svg}");
        let widths = svg.split("width=\"").skip(1).filter_map(|s| s.split('"').next());
        assert!(widths.filter_map(|w| w.parse::<f64>().ok()).all(|w| w <= WIDTH), "{svg}");
    }
}
