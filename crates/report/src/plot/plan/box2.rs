//! Rectangles that texts and signs cover in a plan view.

use fenderline_contact::number::{greater, lesser};

/// Half the height of a text (px).
pub(super) const HALF_LINE: f64 = 8.0;

/// A rectangle in a plan view's drawing, given by its middle and half its size (px).
#[derive(Clone, Copy, Debug)]
pub(super) struct Box2 {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) half_width: f64,
    pub(super) half_height: f64,
}

impl Box2 {
    /// The rectangle of a text whose middle is at a point.
    pub(super) fn of_text(text: &str, x: f64, y: f64) -> Box2 {
        let count = u32::try_from(text.chars().count()).map_or(0.0, f64::from);
        Box2 { x, y, half_width: count * 3.6 + 3.0, half_height: HALF_LINE }
    }

    /// The rectangle of a text that begins at a point, or ends at the point if `is_left`.
    pub(super) fn of_text_from(text: &str, (x, y): (f64, f64), is_left: bool) -> Box2 {
        let mut of = Box2::of_text(text, x, y);
        of.x += if is_left { -of.half_width } else { of.half_width };
        of
    }

    /// The rectangle from its upper left corner to its lower right corner.
    pub(super) fn between((left, top): (f64, f64), (right, bottom): (f64, f64)) -> Box2 {
        Box2 {
            x: 0.5 * (left + right),
            y: 0.5 * (top + bottom),
            half_width: 0.5 * (right - left),
            half_height: 0.5 * (bottom - top),
        }
    }

    /// The smallest rectangle around the points, enlarged by a margin.
    pub(super) fn around(points: &[(f64, f64)], margin: f64) -> Box2 {
        let low = |of: fn(&(f64, f64)) -> f64| points.iter().map(of).fold(f64::INFINITY, lesser);
        let high =
            |of: fn(&(f64, f64)) -> f64| points.iter().map(of).fold(f64::NEG_INFINITY, greater);
        Box2::between(
            (low(|p| p.0) - margin, low(|p| p.1) - margin),
            (high(|p| p.0) + margin, high(|p| p.1) + margin),
        )
    }

    pub(super) fn overlaps(&self, other: &Box2) -> bool {
        (self.x - other.x).abs() < self.half_width + other.half_width
            && (self.y - other.y).abs() < self.half_height + other.half_height
    }

    /// Distance of a point from the rectangle (px); 0 for a point inside.
    pub(super) fn distance(&self, (x, y): (f64, f64)) -> f64 {
        let off = |distance: f64, half: f64| greater(distance.abs() - half, 0.0);
        libm::hypot(off(x - self.x, self.half_width), off(y - self.y, self.half_height))
    }

    pub(super) fn lies_within(&self, width: f64, height: f64) -> bool {
        self.x > self.half_width
            && self.x < width - self.half_width
            && self.y > self.half_height
            && self.y < height - self.half_height
    }
}
