//! Fenders in a plan view.

use core::fmt::Write as _;

use fenderline_contact::Vec2;
use fenderline_contact::number::greater;
use maud::{Markup, html};

use super::map::Map;

/// A fender seen from above, earth-fixed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FenderBox {
    /// Middle of the line where the fender is mounted (m).
    pub mount_m: Vec2,
    /// Vector from the mounting to the middle of the deflected fender's face (m).
    pub out_m: Vec2,
    /// Vector from the middle of the fender's face to one end of the face (m).
    pub half_width_m: Vec2,
    /// How the fender was used in the run.
    pub used: Use,
}

/// How a fender was used in a run, which sets its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Use {
    /// Not touched.
    Untouched,
    /// Touched; no rating given.
    NotRated,
    /// Used up to this share of the fender's rating.
    Share(f64),
    /// Failed.
    Failed,
}

/// Smallest drawn size of a fender (px), because a fender is small beside a ship.
const LEAST: (f64, f64) = (5.0, 7.0);

/// Fill colour of a fender, and whether the fender is crossed out.
fn look(of: Use) -> (&'static str, bool) {
    match of {
        Use::Untouched => ("#ffffff", false),
        Use::NotRated => ("#b9c0c8", false),
        Use::Share(share) if share > 1.0 => ("#a02c00", false),
        Use::Share(share) if share > 0.75 => ("#e07b1f", false),
        Use::Share(share) if share > 0.5 => ("#f3b562", false),
        Use::Share(_) => ("#fbe3bd", false),
        Use::Failed => ("#3a0010", true),
    }
}

impl Use {
    /// Colour of the fender.
    #[must_use]
    pub fn fill(self) -> &'static str {
        look(self).0
    }
}

impl FenderBox {
    /// Corners of the fender as drawn (px): two at the mounting, then two at the face.
    pub(super) fn corners(&self, map: &Map) -> [(f64, f64); 4] {
        let (x, y) = map.px(self.mount_m);
        let direction = |v: Vec2, least: f64| {
            let (dx, dy) = (v.y * map.px_per_m, -v.x * map.px_per_m);
            let length = libm::hypot(dx, dy);
            let grown = if length > 0.0 { (greater(length, least)) / length } else { 0.0 };
            (dx * grown, dy * grown)
        };
        let (ox, oy) = direction(self.out_m, LEAST.0);
        let (wx, wy) = direction(self.half_width_m, 0.5 * LEAST.1);
        [(x - wx, y - wy), (x + wx, y + wy), (x + wx + ox, y + wy + oy), (x - wx + ox, y - wy + oy)]
    }
}

pub(super) fn fender(fender: &FenderBox, map: &Map) -> Markup {
    let (fill, is_crossed) = look(fender.used);
    let corners = fender.corners(map);
    let [one, _, opposite, _] = corners;
    let (cx, cy) = (0.5 * (one.0 + opposite.0), 0.5 * (one.1 + opposite.1));
    let mut path = String::new();
    for (index, (x, y)) in corners.iter().enumerate() {
        let _ = write!(path, "{}{x:.2},{y:.2}", if index == 0 { 'M' } else { 'L' });
    }
    html! {
        path d={ (path) "Z" } fill=(fill) stroke="#222" stroke-width="0.9" {}
        @if is_crossed {
            path d=(format!("M{:.1},{:.1}l12,12m0,-12l-12,12", cx - 6.0, cy - 6.0))
                stroke="#c00020" stroke-width="2" fill="none" {}
        }
    }
}

/// The legend for the colours of fenders.
pub fn fenders_legend() -> Markup {
    let entries = [
        (Use::Untouched, "not touched"),
        (Use::NotRated, "not rated"),
        (Use::Share(0.3), "to 50 % of rated"),
        (Use::Share(0.6), "to 75 %"),
        (Use::Share(0.9), "to 100 %"),
        (Use::Share(1.5), "over rated"),
        (Use::Failed, "FAILED"),
    ];
    html! {
        ul class="legend" {
            li { "Fenders:" }
            @for (of, text) in entries {
                @let (fill, is_crossed) = look(of);
                li {
                    svg class="box" width="14" height="12" viewBox="0 0 14 12" aria-hidden="true" {
                        rect x="1" y="1.5" width="12" height="9" fill=(fill) stroke="#222" {}
                        @if is_crossed {
                            path d="M1,0l12,12m0,-12l-12,12" stroke="#c00020" stroke-width="2"
                                fill="none" {}
                        }
                    }
                    (text)
                }
            }
        }
    }
}
