//! A drawing of a section through a fender, at right angles to its face, at the same scale in both directions.

use core::fmt::Write as _;

use fenderline_contact::number::{greater, lesser};
use maud::{Markup, html};

use super::face::{BED, HULL, Level, LevelKind, QUAY, QUAY_EDGE, WATER, px, signed};
use super::scale::Scale;
use crate::plot::Use;
use crate::plot::number::plain;

/// A section through a fender to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Printed above the drawing.
    pub title: String,
    /// Height of the middle of the fender's face (m).
    pub height_m: f64,
    /// Width and height of the fender's face (m).
    pub face_m: [f64; 2],
    /// Distance from the mounting to the face of the uncompressed fender (m).
    pub projection_m: f64,
    /// Largest deflection of the fender in the run (m).
    pub deflection_m: f64,
    /// How the fender was used in the run.
    pub used: Use,
    /// Levels.
    pub levels: Vec<Level>,
    /// The ship's side that pressed the fender, if any did.
    pub hull: Option<Side>,
    /// Name of the level from which heights are measured.
    pub heights_above: &'static str,
    /// Chains of the fender, each with its text.
    pub chains: Vec<(Chain, String)>,
    /// Whether the fender is a round body without a panel, as a pneumatic fender; `false` for a panel before a fender
    /// body.
    pub is_round: bool,
    /// Whether the fender floats, so that its height follows the water.
    pub is_floating: bool,
}

/// The kind of a chain, which sets where the chain is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Chain {
    /// A weight chain, from the structure above to the top of the panel.
    Weight,
    /// A shear chain, from the structure at the side to the middle of the panel.
    Shear,
    /// A tension chain, from the structure to the edge of the panel.
    Tension,
}

/// The side of a ship's hull at a fender.
#[derive(Clone, Debug, PartialEq)]
pub struct Side {
    /// The hull's name.
    pub name: String,
    /// Height of the hull's keel (m), if its draught is known.
    pub keel_m: Option<f64>,
    /// Points of the hull's side from below upwards: distance outwards from the middle of the fender's face, and height
    /// (m); empty for a vertical side.
    pub side_m: Vec<[f64; 2]>,
}

pub(super) const WIDTH: f64 = 720.0;
/// Largest height of the drawing (px).
const HEIGHT: f64 = 250.0;
/// How much of the structure and of the hull is drawn, as a share of the fender's projection.
const BEHIND: f64 = 1.2;
/// Room below and above the fender's face that may always be shown (m).
const BELOW_M: f64 = 4.0;
const ABOVE_M: f64 = 2.0;
/// Thickness of the panel as a share of the fender's projection.
pub(super) const PANEL: f64 = 0.14;
/// Place where the texts beside the drawing begin, and the height of a line of text (px).
pub(super) const TEXTS: f64 = 450.0;
pub(super) const LINE: f64 = 18.0;

impl Section {
    /// Draws the section as an HTML `figure`.
    pub fn render(&self) -> Markup {
        let [low_m, high_m] = self.heights();
        let depth_m = greater(self.projection_m, 0.2);
        let wide_m = [-BEHIND * depth_m, (1.0 + 2.0 * BEHIND) * depth_m];
        let px_per_m = lesser(HEIGHT / (high_m - low_m), 420.0 / (wide_m[1] - wide_m[0]));
        let height = (high_m - low_m) * px_per_m;
        let texts = self.texts();
        let whole = greater(height + 16.0, LINE * texts.len() as f64 + 20.0);
        let width = (wide_m[1] - wide_m[0]) * px_per_m;
        let left = 0.5 * (TEXTS - 20.0 - width);
        let x = Scale::new(wide_m, left, left + width);
        let z = Scale::new([low_m, high_m], 8.0 + height, 8.0);
        html! {
            figure class="system" {
                figcaption { (self.title) }
                svg viewBox=(format!("0 0 {WIDTH} {whole:.1}")) role="img" aria-label=(self.title) {
                    svg x=(px(left)) y="8" width=(px(width)) height=(px(height)) overflow="hidden"
                        viewBox=(format!("{left:.1} 8 {width:.1} {height:.1}")) {
                        (self.drawn(&x, &z))
                    }
                    rect class="frame" x=(px(left)) y="8" width=(px(width)) height=(px(height)) {}
                    (beside(&texts))
                }
            }
        }
    }

    /// The range of heights that the drawing shows (m): the fender's face, and levels and keel as far as the face does
    /// not become too small.
    fn heights(&self) -> [f64; 2] {
        let half_m = 0.5 * self.face_m[1];
        let (bottom, top) = (self.height_m - half_m, self.height_m + half_m);
        let (below_m, above_m) =
            (greater(BELOW_M, 2.0 * self.projection_m), greater(ABOVE_M, self.projection_m));
        let (mut low, mut high) = (bottom, top);
        let keel = self.hull.iter().filter_map(|hull| hull.keel_m);
        for height_m in self.levels.iter().map(|level| level.height_m).chain(keel) {
            (low, high) = (lesser(low, height_m), greater(high, height_m));
        }
        let room_m = greater(0.1 * (high - low), 0.5);
        [greater(low - room_m, bottom - below_m), lesser(high + room_m, top + above_m)]
    }

    fn drawn(&self, x: &Scale, z: &Scale) -> Markup {
        let [low_m, high_m] = self.heights();
        let (top, whole) = (z.px(high_m), z.length(high_m - low_m));
        let face_m = self.projection_m - self.deflection_m;
        let end = x.px((1.0 + 2.0 * BEHIND) * self.projection_m);
        html! {
            rect x=(px(x.px(-BEHIND * self.projection_m) - 2.0)) y=(px(top - 2.0))
                width=(px(x.length(BEHIND * self.projection_m) + 2.0)) height=(px(whole + 4.0)) fill=(QUAY) fill-opacity="0.55"
                stroke=(QUAY_EDGE) stroke-width="1.1" {}
            @for level in &self.levels {
                @let y = z.px(level.height_m);
                @let colour = match level.kind { LevelKind::Water => WATER, LevelKind::Bed => BED };
                path d=(format!("M{:.1},{y:.1}H{end:.1}", x.px(0.0))) stroke=(colour) stroke-width="1.2" fill="none"
                    stroke-dasharray=(if level.kind == LevelKind::Water { "9 4" } else { "" }) {}
            }
            @if let Some(hull) = &self.hull {
                path d=(hull.path(x, z, face_m, [end + 2.0, top - 2.0, top + whole + 2.0])) fill=(HULL)
                    fill-opacity="0.12" stroke=(HULL) stroke-width="1.4" {}
            }
            @if self.is_round { (self.round(x, z)) } @else { (self.with_panel(x, z)) }
        }
    }

    /// Draws a round fender body, as it was mounted, and as far pressed as in the run.
    fn round(&self, x: &Scale, z: &Scale) -> Markup {
        let ellipse = |out_m: f64| {
            [
                x.px(0.5 * out_m),
                z.px(self.height_m),
                x.length(0.5 * out_m),
                z.length(0.5 * self.face_m[1]),
            ]
            .map(px)
        };
        let [cx, cy, rx, ry] = ellipse(self.projection_m);
        let [pressed_cx, pressed_cy, pressed_rx, pressed_ry] =
            ellipse(self.projection_m - self.deflection_m);
        html! {
            ellipse cx=(cx) cy=(cy) rx=(rx) ry=(ry) fill="none" stroke="#5b6675" stroke-width="0.9" stroke-dasharray="4 3" {}
            ellipse cx=(pressed_cx) cy=(pressed_cy) rx=(pressed_rx) ry=(pressed_ry) fill=(self.used.fill()) stroke="#222"
                stroke-width="1.1" {}
        }
    }

    /// Draws a panel before a fender body, with its chains.
    fn with_panel(&self, x: &Scale, z: &Scale) -> Markup {
        let face_m = self.projection_m - self.deflection_m;
        let panel_m = PANEL * self.projection_m;
        let [_, height] = self.face_m;
        let body = 0.45 * height;
        html! {
            // As it was mounted, and pressed as far as it was in the run.
            rect x=(px(x.px(0.0))) y=(px(z.px(self.height_m + 0.5 * body))) width=(px(x.length(self.projection_m - panel_m)))
                height=(px(z.length(body))) fill="none" stroke="#5b6675" stroke-width="0.9" stroke-dasharray="4 3" {}
            rect x=(px(x.px(self.projection_m - panel_m))) y=(px(z.px(self.height_m + 0.5 * height))) width=(px(x.length(panel_m)))
                height=(px(z.length(height))) fill="none" stroke="#5b6675" stroke-width="0.9" stroke-dasharray="4 3" {}
            @if face_m > panel_m {
                rect x=(px(x.px(0.0))) y=(px(z.px(self.height_m + 0.5 * body))) width=(px(x.length(face_m - panel_m)))
                    height=(px(z.length(body))) fill="#555" fill-opacity="0.35" stroke="#222" stroke-width="0.9" {}
            }
            rect x=(px(x.px(greater(face_m - panel_m, 0.0)))) y=(px(z.px(self.height_m + 0.5 * height))) width=(px(x.length(panel_m)))
                height=(px(z.length(height))) fill=(self.used.fill()) stroke="#222" stroke-width="1.1" {}
            @for (chain, _) in &self.chains {
                // From the structure, above the panel's middle, to the panel (shares of the face's height).
                @let [from, to] = match chain {
                    Chain::Weight => [0.75, 0.45],
                    Chain::Shear => [0.0, 0.0],
                    Chain::Tension => [0.3, 0.4],
                };
                path d=(format!(
                    "M{:.1},{:.1}L{:.1},{:.1}",
                    x.px(0.0), z.px(self.height_m + from * height),
                    x.px(greater(face_m - panel_m, 0.0)), z.px(self.height_m + to * height)
                )) stroke="#222" stroke-width="1.6" stroke-dasharray="2.5 1.5" fill="none" {}
            }
        }
    }

    /// The lines of text that stand beside the drawing.
    fn texts(&self) -> Vec<String> {
        let [width, height] = self.face_m;
        let half = 0.5 * height;
        let mut all = vec![
            format!("Face {} × {} m (width × height)", plain(width, 3), plain(height, 3)),
            format!(
                "from {} to {} m above {}",
                signed(self.height_m - half),
                signed(self.height_m + half),
                self.heights_above
            ),
            format!("Projection {} m", plain(self.projection_m, 3)),
        ];
        if self.is_floating {
            all.push("The fender floats: its height follows the water".to_owned());
        }
        if self.deflection_m > 0.0 {
            all.push(format!("Largest deflection {} m, as drawn", plain(self.deflection_m, 3)));
            all.push("Dashed: unloaded".to_owned());
        }
        if let Some(hull) = &self.hull {
            let name = &hull.name;
            all.push(match hull.keel_m {
                Some(keel_m) => format!("{name}: keel at {} m", signed(keel_m)),
                None => format!("{name}: draught not given"),
            });
            if hull.side_m.is_empty() {
                all.push("Her side is vertical".to_owned());
            }
        }
        all.extend(self.chains.iter().map(|(_, text)| text.clone()));
        all.extend(self.levels.iter().rev().map(|level| level.text.clone()));
        all
    }
}

/// Draws lines of text beside a drawing.
pub(super) fn beside(texts: &[String]) -> Markup {
    html! {
        @for (index, text) in texts.iter().enumerate() {
            text class="axis" x=(px(TEXTS)) y=(px(26.0 + LINE * index as f64)) { (text) }
        }
    }
}

impl Side {
    /// The SVG path of the hull, whose side meets the fender at `face_m`; `right`, `top` and `bottom` are the edges of
    /// the drawing (px).
    fn path(&self, x: &Scale, z: &Scale, face_m: f64, [right, top, bottom]: [f64; 3]) -> String {
        let keel = self.keel_m.map_or(bottom, |keel_m| z.px(keel_m));
        let face = x.px(face_m);
        let mut path = format!("M{right:.1},{top:.1}V{keel:.1}");
        if self.side_m.is_empty() {
            let _ = write!(path, "H{face:.1}V{top:.1}");
        }
        for [out_m, height_m] in &self.side_m {
            let _ = write!(path, "L{:.1},{:.1}", x.px(face_m + out_m), z.px(*height_m));
        }
        if let Some([out_m, _]) = self.side_m.last() {
            let _ = write!(path, "L{:.1},{top:.1}", x.px(face_m + out_m));
        }
        path.push('Z');
        path
    }
}
