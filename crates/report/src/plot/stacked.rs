//! A chart of stacked amounts, such as hours lost by reason: drawn as petals by direction, or as columns.

use core::f64::consts::TAU;
use core::fmt::Write as _;

use fenderline_contact::number::greater;
use maud::{Markup, html};

use super::axis::Axis;
use super::number::{fixed, significant};
use super::rose::ring_path;

/// Amounts of several kinds for each of several things, such as hours lost by reason for each month.
#[derive(Clone, Debug, PartialEq)]
pub struct Stacked {
    /// Title, printed above the chart.
    pub title: String,
    /// The kinds of amounts (such as reasons), in the order of the stack.
    pub kinds: Vec<String>,
    /// The groups (such as months), each with an amount for each kind.
    pub groups: Vec<(String, Vec<f64>)>,
    /// Title of the axis: what is counted, and its unit.
    pub axis: (&'static str, &'static str),
    /// Note below the chart; empty for none.
    pub note: String,
}

const WIDTH: f64 = 720.0;
/// Sizes of the chart of columns (px).
const HEIGHT: f64 = 250.0;
const LEFT: f64 = 58.0;
const RIGHT: f64 = 12.0;
const TOP: f64 = 12.0;
const BOTTOM: f64 = 40.0;
/// Width of a column, divided by the distance from column to column.
const FILLED: f64 = 0.66;
/// Longest name of a group (characters); longer names are cut.
const NAME: usize = 3;
/// Sizes of the chart of petals (px).
const SIZE: f64 = 440.0;
const CENTRE: (f64, f64) = (360.0, 220.0);
const OUTER: f64 = 184.0;
/// Width of a petal as a share of its sector.
const PETAL: f64 = 0.8;

/// Fill colours of the kinds, dark and light in turn, so that they can be told apart in grey print and by the
/// colour-blind.
const FILLS: [&str; 8] =
    ["#0b3a5b", "#E69F00", "#56B4E9", "#7a0019", "#a8dcc3", "#CC79A7", "#5b6675", "#F0E442"];

fn fill(kind: usize) -> &'static str {
    FILLS[kind % FILLS.len()]
}

impl Stacked {
    fn largest(&self) -> f64 {
        let sums = self.groups.iter().map(|(_, amounts)| amounts.iter().sum::<f64>());
        sums.fold(0.0, greater)
    }

    /// Draws a petal for each group, the first towards the top and the others clockwise; the lengths of the petals are
    /// the amounts.
    pub fn petals(&self) -> Markup {
        let axis = Axis::new(self.axis.0, self.axis.1).including(0.0);
        let axis = axis.fit([self.largest()].into_iter(), 4);
        let radius = |amount: f64| axis.share(amount) * OUTER;
        let width = TAU / self.groups.len().max(1) as f64;
        let middle = |index: usize| width * index as f64;
        let at = |radius: f64, angle: f64| {
            (CENTRE.0 + radius * libm::sin(angle), CENTRE.1 - radius * libm::cos(angle))
        };
        html! {
            figure class="rose" {
                figcaption { (self.title) }
                (self.legend())
                svg viewBox=(format!("0 0 {WIDTH} {SIZE}")) role="img" aria-label=(self.title) {
                    @for (value, _) in axis.ticks() {
                        @if value > 0.0 {
                            circle class="grid" cx=(CENTRE.0) cy=(CENTRE.1) r=(format!("{:.1}", radius(value))) {}
                        }
                    }
                    @for (index, (name, amounts)) in self.groups.iter().enumerate() {
                        @for (kind, from, to) in stack(amounts) {
                            path fill=(fill(kind)) stroke="#fff" stroke-width="0.8"
                                d=(petal(&at, (radius(from), radius(to)), middle(index), 0.5 * PETAL * width)) {
                                title { (self.told(name, kind, to - from)) }
                            }
                        }
                    }
                    @for (index, (name, _)) in self.groups.iter().enumerate() {
                        @let (x, y) = at(OUTER + 17.0, middle(index));
                        text class=(if name.len() == 1 { "name" } else { "axis" }) text-anchor="middle" x=(format!("{x:.1}"))
                            y=(format!("{:.1}", y + 4.0)) { (name) }
                    }
                    @let between = 0.5 * width;
                    @for (value, label) in axis.ticks() {
                        @if value > 0.0 {
                            @let (x, y) = at(radius(value), between);
                            text class="halo value" text-anchor="middle" x=(format!("{x:.1}")) y=(format!("{:.1}", y + 3.0)) {
                                (label) " " (self.axis.1)
                            }
                        }
                    }
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }

    /// Draws a column for each group.
    pub fn columns(&self) -> Markup {
        let axis = Axis::new(self.axis.0, self.axis.1).including(0.0);
        let title = axis.title();
        let axis = axis.fit([self.largest()].into_iter(), 5);
        let base = HEIGHT - BOTTOM;
        let py = |amount: f64| base - axis.share(amount) * (base - TOP);
        let pitch = (WIDTH - LEFT - RIGHT) / self.groups.len().max(1) as f64;
        let mut grid = String::new();
        for (value, _) in axis.ticks() {
            let _ = write!(grid, "M{LEFT},{:.1}H{:.1}", py(value), WIDTH - RIGHT);
        }
        html! {
            figure class="bars" {
                figcaption { (self.title) }
                (self.legend())
                svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(self.title) {
                    path class="grid" d=(grid) {}
                    @for (index, (name, amounts)) in self.groups.iter().enumerate() {
                        @let middle = LEFT + pitch * (index as f64 + 0.5);
                        @for (kind, from, to) in stack(amounts) {
                            rect x=(format!("{:.1}", middle - 0.5 * FILLED * pitch)) width=(format!("{:.1}", FILLED * pitch))
                                y=(format!("{:.1}", py(to))) height=(format!("{:.1}", py(from) - py(to)))
                                fill=(fill(kind)) stroke="#fff" stroke-width="0.8" {
                                title { (self.told(name, kind, to - from)) }
                            }
                        }
                        @let sum = amounts.iter().sum::<f64>();
                        text class="halo value" text-anchor="middle" x=(format!("{middle:.1}")) y=(format!("{:.1}", py(sum) - 4.0)) {
                            (if sum > 0.0 { fixed(sum, 0) } else { "0".to_owned() })
                        }
                        text class="axis" text-anchor="middle" x=(format!("{middle:.1}")) y=(format!("{:.1}", base + 16.0)) {
                            (name.chars().take(NAME).collect::<String>())
                        }
                    }
                    path class="frame" d=(format!("M{LEFT},{TOP}V{base:.1}H{:.1}", WIDTH - RIGHT)) {}
                    g class="ticks" {
                        @for (value, label) in axis.ticks() {
                            text text-anchor="end" x=(LEFT - 6.0) y=(format!("{:.1}", py(value) + 4.0)) { (label) }
                        }
                    }
                    text class="axis" text-anchor="middle" x="14" y=(format!("{:.1}", 0.5 * (TOP + base)))
                        transform=(format!("rotate(-90 14 {:.1})", 0.5 * (TOP + base))) { (title) }
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }

    fn told(&self, name: &str, kind: usize, amount: f64) -> String {
        format!("{name}, {}: {} {}", self.kinds[kind], significant(amount, 3), self.axis.1)
    }

    fn legend(&self) -> Markup {
        html! {
            ul class="legend" {
                @for (kind, name) in self.kinds.iter().enumerate() {
                    li {
                        svg width="30" height="12" viewBox="0 0 30 12" aria-hidden="true" {
                            rect x="2" y="2" width="26" height="8" fill=(fill(kind)) stroke="#5b6675" {}
                        }
                        (name)
                    }
                }
            }
        }
    }
}

/// Kind, start and end of each part of a stack, without empty parts.
fn stack(amounts: &[f64]) -> Vec<(usize, f64, f64)> {
    let mut sum = 0.0;
    let mut parts = Vec::new();
    for (kind, amount) in amounts.iter().enumerate().filter(|(_, amount)| **amount > 0.0) {
        parts.push((kind, sum, sum + amount));
        sum += amount;
    }
    parts
}

/// The SVG path of a part of a petal.
fn petal(
    at: &dyn Fn(f64, f64) -> (f64, f64),
    (inner, outer): (f64, f64),
    middle: f64,
    half: f64,
) -> String {
    let corners = [
        at(inner, middle - half),
        at(outer, middle - half),
        at(outer, middle + half),
        at(inner, middle + half),
    ];
    ring_path(corners, inner, outer)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_amount_is_a_part_with_its_words() {
        let of = Stacked {
            title: "<b>".to_owned(),
            kinds: vec!["<surge>".to_owned(), "sway".to_owned()],
            groups: vec![
                ("N".to_owned(), vec![10.0, 0.0]),
                ("E".to_owned(), vec![0.0, 0.0]),
                ("S".to_owned(), vec![3.0, 4.0]),
            ],
            axis: ("lost", "h"),
            note: String::new(),
        };
        for svg in [of.petals().into_string(), of.columns().into_string()] {
            assert_eq!(svg.matches("<title>").count(), 3, "{svg}");
            assert!(svg.contains("S, sway: 4.00 h") && !svg.contains("<surge>"), "{svg}");
            assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
        }
        let nothing = Stacked { groups: vec![("N".to_owned(), vec![0.0, 0.0])], ..of };
        assert!(!nothing.petals().into_string().contains("NaN"));
    }
}
