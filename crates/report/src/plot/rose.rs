//! A rose chart: rings of sectors by direction, in which the fill of each sector shows a share.

use core::f64::consts::TAU;

use maud::{Markup, html};

use super::number::fixed;

/// A rose chart to draw. Sector 0 is centred on north, and the other sectors follow clockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Rose {
    /// Title, printed above the rose.
    pub title: String,
    /// Rings of the rose from the inside, all with the same number of sectors.
    pub rings: Vec<Ring>,
    /// Words for the legend that say what the shares are.
    pub quantity: String,
    /// Note below the rose; empty for none.
    pub note: String,
}

/// A ring of sectors.
#[derive(Clone, Debug, PartialEq)]
pub struct Ring {
    /// Label of the ring, printed at its outer edge.
    pub label: String,
    /// Share of each sector of the ring, from 0 to 1; `None` for a sector without a value.
    pub shares: Vec<Option<f64>>,
}

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 460.0;
const CENTRE: (f64, f64) = (300.0, 230.0);
const INNER: f64 = 22.0;
const OUTER: f64 = 196.0;

/// Smallest share, fill colour and label of each class of shares, from the best class; a dark colour is bad, so that
/// grey print tells the classes apart.
const CLASSES: [(f64, &str, &str); 5] = [
    (0.99, "#e2f2ea", "99 % and more"),
    (0.95, "#a8dcc3", "95 to 99 %"),
    (0.80, "#f6d58b", "80 to 95 %"),
    (0.50, "#e08a3c", "50 to 80 %"),
    (0.0, "#7a0019", "below 50 %"),
];
const EMPTY: &str = "#ffffff";

fn fill(share: Option<f64>) -> &'static str {
    let class = |share: f64| CLASSES.iter().find(|(least, ..)| share >= *least);
    share.and_then(class).map_or(EMPTY, |(_, fill, _)| fill)
}

impl Rose {
    /// Draws the rose as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let width = (OUTER - INNER) / self.rings.len().max(1) as f64;
        let radius = |ring: usize| INNER + width * ring as f64;
        html! {
            figure class="rose" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {WIDTH} {HEIGHT}")) role="img" aria-label=(self.title) {
                    @for (index, ring) in self.rings.iter().enumerate() {
                        @for (sector, share) in ring.shares.iter().enumerate() {
                            path d=(sector_path(sector, ring.shares.len(), radius(index), radius(index + 1)))
                                fill=(fill(*share)) stroke="#8a94a0" stroke-width="0.8" {
                                title { (ring.label) ": "
                                    @match share { Some(share) => { (fixed(100.0 * share, 1)) " %" } None => "no runs" } }
                            }
                        }
                    }
                    @for (index, ring) in self.rings.iter().enumerate() {
                        text class="halo value" x=(CENTRE.0 + 2.0)
                            y=(format!("{:.1}", CENTRE.1 - radius(index + 1) + 11.0))
                            text-anchor="middle" { (ring.label) }
                    }
                    @for (name, x, y) in [("N", 0.0, -1.0), ("E", 1.0, 0.0), ("S", 0.0, 1.0), ("W", -1.0, 0.0)] {
                        text class="name" text-anchor="middle"
                            x=(format!("{:.1}", CENTRE.0 + x * (OUTER + 16.0)))
                            y=(format!("{:.1}", CENTRE.1 + y * (OUTER + 16.0) + 4.0)) { (name) }
                    }
                    (self.legend())
                }
                @if !self.note.is_empty() { p class="note" { (self.note) } }
            }
        }
    }

    fn legend(&self) -> Markup {
        let rows = CLASSES.iter().map(|(_, fill, text)| (*fill, *text)).chain([(EMPTY, "no runs")]);
        html! {
            text class="axis" x="548" y="130" { (self.quantity) }
            @for (index, (fill, text)) in rows.enumerate() {
                @let y = 144.0 + 20.0 * index as f64;
                rect x="548" y=(y) width="20" height="13" fill=(fill) stroke="#8a94a0" stroke-width="0.8" {}
                text x="576" y=(y + 10.5) { (text) }
            }
        }
    }
}

/// The SVG path of a sector between two radii.
fn sector_path(sector: usize, of: usize, inner: f64, outer: f64) -> String {
    let width = TAU / of.max(1) as f64;
    let at = |radius: f64, edge: f64| {
        let angle = width * (sector as f64 + edge);
        (CENTRE.0 + radius * libm::sin(angle), CENTRE.1 - radius * libm::cos(angle))
    };
    ring_path([at(inner, -0.5), at(outer, -0.5), at(outer, 0.5), at(inner, 0.5)], inner, outer)
}

/// The SVG path of a part of a ring between two radii, from its four corners: inner, outer, outer, inner.
pub(super) fn ring_path([a, b, c, d]: [(f64, f64); 4], inner: f64, outer: f64) -> String {
    format!(
        "M{:.1},{:.1}L{:.1},{:.1}A{outer:.1},{outer:.1} 0 0 1 {:.1},{:.1}L{:.1},{:.1}A{inner:.1},{inner:.1} 0 0 0 {:.1},{:.1}Z",
        a.0, a.1, b.0, b.1, c.0, c.1, d.0, d.1, a.0, a.1
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sectors_are_filled_by_their_class() {
        let ring =
            Ring { label: "<5>".to_owned(), shares: vec![Some(1.0), Some(0.2), None, Some(0.9)] };
        let svg = Rose {
            title: "rose".to_owned(),
            rings: vec![ring.clone(), ring],
            quantity: "success".to_owned(),
            note: String::new(),
        }
        .render()
        .into_string();
        assert!(!svg.contains("<5>") && !svg.contains("NaN"));
        // Twice in the rose, once in the legend.
        for fill in ["#e2f2ea", "#7a0019", "#f6d58b"] {
            assert_eq!(svg.matches(fill).count(), 3, "{fill}");
        }
    }
}
