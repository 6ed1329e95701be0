//! The extent of a plan view, and the mapping from metres to the page.

use core::fmt::Write as _;

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{Vec2, vec2};

use crate::plot::axis::{Axis, Fitted, nice_step};

/// An arrow from a point, with a text at its head.
#[derive(Clone, Debug, PartialEq)]
pub struct Arrow {
    /// Point where the arrow starts and a dot is drawn (m).
    pub from_m: Vec2,
    /// Direction of the arrow, of length 1; zero for a dot without an arrow.
    pub direction: Vec2,
    /// Text at the head of the arrow.
    pub label: String,
}

/// A name in a plan view.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// The text.
    pub text: String,
    /// Possible places of the name in the view.
    pub place: Place,
}

/// The possible places of a name in a plan view. The name takes the first place that is free; a name without a free
/// place is left out.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// The name stands at one of these points (m).
    At(Vec<Vec2>),
    /// The name stands beside a small thing, such as a fender.
    Beside {
        /// Position of the thing (m).
        point_m: Vec2,
        /// Direction from the thing to the preferred side of the name, of length 1.
        side: Vec2,
    },
    /// The name stands on a body, or beside a body that is too small for the text.
    On {
        /// Middle of the body (m).
        middle_m: Vec2,
        /// Vector from the middle of the body to one end of its long axis (m).
        half_length_m: Vec2,
    },
}

/// A rectangle of the horizontal plane that a view shows (m).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// South-west corner of the frame (m).
    pub low: Vec2,
    /// North-east corner of the frame (m).
    pub high: Vec2,
}

impl Frame {
    /// The smallest frame around `points`; `None` if there are no points.
    pub fn around(points: impl IntoIterator<Item = Vec2>) -> Option<Frame> {
        points.into_iter().filter(|p| p.is_finite()).fold(None, |frame, p| {
            let point = Frame { low: p, high: p };
            Some(frame.map_or(point, |f: Frame| f.with(point)))
        })
    }

    /// The smallest frame round two points.
    pub fn between(one: Vec2, other: Vec2) -> Frame {
        Frame { low: one, high: one }.with(Frame { low: other, high: other })
    }

    /// A frame about `centre`, 1.65 times as wide as high: two views of this shape fit on a page of A4.
    pub fn about(centre: Vec2, half_height_m: f64) -> Frame {
        let half = vec2(half_height_m, half_height_m * 1.65);
        Frame { low: centre - half, high: centre + half }
    }

    /// The smallest frame around this frame and another frame.
    pub fn with(self, other: Frame) -> Frame {
        Frame {
            low: vec2(lesser(self.low.x, other.low.x), lesser(self.low.y, other.low.y)),
            high: vec2(greater(self.high.x, other.high.x), greater(self.high.y, other.high.y)),
        }
    }

    /// Extent of the frame to the north and to the east (m).
    pub fn size(self) -> Vec2 {
        self.high - self.low
    }

    fn centre(self) -> Vec2 {
        self.low + self.size() * 0.5
    }
}

pub(super) const WIDTH: f64 = 720.0;
/// Margins of the drawing (px): on the left for the title of the northern axis (its labels need extra room), and on the
/// other sides.
pub(super) const LEFT: f64 = 32.0;
pub(super) const RIGHT: f64 = 12.0;
pub(super) const TOP: f64 = 8.0;
pub(super) const BOTTOM: f64 = 40.0;
pub(super) const DIGIT: f64 = 6.4;
/// Smallest and largest height of the drawn area (px).
pub(super) const HEIGHTS: (f64, f64) = (230.0, 540.0);
/// Margin around the frame, as a share of the frame's size.
pub(super) const MARGIN: f64 = 0.06;
/// A vertex closer than this to the previous vertex is not drawn (px).
pub(super) const FINEST: f64 = 0.15;
pub(super) const ARROW: f64 = 64.0;

/// The mapping from the horizontal plane to the drawn area, whose origin is its upper left corner.
pub(super) struct Map {
    pub(super) centre: Vec2,
    pub(super) px_per_m: f64,
    pub(super) width: f64,
    pub(super) height: f64,
    pub(super) left: f64,
    pub(super) north: Fitted,
    pub(super) east: Fitted,
}

impl Map {
    pub(super) fn of(frame: Frame) -> Map {
        let size = frame.size();
        // No frame is so small that doubles at its place could not tell its ends apart.
        let far = greater(frame.centre().x.abs(), frame.centre().y.abs());
        let least = greater(far * 1e-12, 1e-6);
        let (tall, wide) = (greater(size.x, least), greater(size.y, least));
        let room = 1.0 + 2.0 * MARGIN;
        // The labels of the northern axis set the left margin, and so the scale; their length
        // hardly depends on it.
        let longest = Axis::new("", "")
            .tight()
            .fit([frame.low.x, frame.low.x + tall].into_iter(), 6)
            .ticks()
            .iter()
            .map(|(_, label)| label.chars().count())
            .max();
        let left =
            LEFT + DIGIT * longest.and_then(|n| u32::try_from(n).ok()).map_or(8.0, f64::from);
        let width = WIDTH - left - RIGHT;
        let height = bounded(width * tall / wide, HEIGHTS.0, HEIGHTS.1);
        let px_per_m = lesser(width / (wide * room), height / (tall * room));
        let centre = frame.centre();
        let step = nice_step(width / px_per_m, 8);
        let half = vec2(height / px_per_m / 2.0, width / px_per_m / 2.0);
        let north = Fitted::new(centre.x - half.x, centre.x + half.x, step);
        let east = Fitted::new(centre.y - half.y, centre.y + half.y, step);
        Map { centre, px_per_m, width, height, left, north, east }
    }

    /// Maps a point to the drawing: distances to the right and down from the upper left corner of the drawn area (px).
    pub(super) fn px(&self, point_m: Vec2) -> (f64, f64) {
        let from_centre = point_m - self.centre;
        (
            self.width / 2.0 + from_centre.y * self.px_per_m,
            self.height / 2.0 - from_centre.x * self.px_per_m,
        )
    }

    pub(super) fn path(&self, points_m: &[Vec2]) -> String {
        let mut path = String::with_capacity(points_m.len() * 12);
        let mut last = None;
        for (index, point) in points_m.iter().enumerate() {
            let (x, y) = self.px(*point);
            let is_end = index + 1 == points_m.len();
            let is_near = |(x0, y0): (f64, f64)| (x - x0).abs() < FINEST && (y - y0).abs() < FINEST;
            if last.is_some_and(is_near) && !is_end {
                continue;
            }
            let _ = write!(path, "{}{x:.2},{y:.2}", if last.is_none() { 'M' } else { 'L' });
            last = Some((x, y));
        }
        path
    }
}

/// Point where the text of an arrow starts, or ends if it stands to the left of the arrow (px).
pub(super) fn arrow_text(arrow: &Arrow, map: &Map) -> (f64, f64, bool) {
    let (x, y) = map.px(arrow.from_m);
    if arrow.direction == Vec2::ZERO {
        return (x + 8.0, y - 8.0, false);
    }
    let (dx, dy) = (arrow.direction.y, -arrow.direction.x);
    let is_left = dx < -0.3;
    let shift = if is_left { -8.0 } else { 8.0 };
    (x + dx * ARROW + shift, y + dy * ARROW, is_left)
}
