//! Bounding boxes whose sides are parallel to the axes of a frame.

use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Pose, Vec2, vec2};

/// A box whose sides are parallel to the axes of a frame.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Extent {
    pub(crate) low_m: Vec2,
    pub(crate) high_m: Vec2,
}

impl Extent {
    /// The empty box.
    pub(crate) const EMPTY: Extent = Extent {
        low_m: vec2(f64::INFINITY, f64::INFINITY),
        high_m: vec2(f64::NEG_INFINITY, f64::NEG_INFINITY),
    };

    /// The smallest box around some points.
    pub(crate) fn of(points_m: &[Vec2]) -> Extent {
        points_m.iter().fold(Extent::EMPTY, |extent, v| extent.and_point(*v))
    }

    /// The smallest box around a circle.
    pub(crate) fn of_circle(center_m: Vec2, radius_m: f64) -> Extent {
        let half_m = vec2(radius_m, radius_m);
        Extent { low_m: center_m - half_m, high_m: center_m + half_m }
    }

    /// The smallest box around this box and a point.
    #[inline]
    fn and_point(self, v: Vec2) -> Extent {
        Extent {
            low_m: vec2(lesser(self.low_m.x, v.x), lesser(self.low_m.y, v.y)),
            high_m: vec2(greater(self.high_m.x, v.x), greater(self.high_m.y, v.y)),
        }
    }

    /// The smallest box around this box and another box.
    #[inline]
    pub(crate) fn and(self, other: Extent) -> Extent {
        self.and_point(other.low_m).and_point(other.high_m)
    }

    /// This box with each side moved outwards by `by_m` (m).
    #[inline]
    pub(crate) fn widened(self, by_m: f64) -> Extent {
        let by_m = vec2(by_m, by_m);
        Extent { low_m: self.low_m - by_m, high_m: self.high_m + by_m }
    }

    /// Do the boxes meet?
    #[inline]
    pub(crate) fn overlaps(&self, other: &Extent) -> bool {
        self.low_m.x <= other.high_m.x
            && other.low_m.x <= self.high_m.x
            && self.low_m.y <= other.high_m.y
            && other.low_m.y <= self.high_m.y
    }

    #[inline]
    pub(crate) fn center_m(&self) -> Vec2 {
        (self.low_m + self.high_m) * 0.5
    }

    #[inline]
    fn half_m(&self) -> Vec2 {
        (self.high_m - self.low_m) * 0.5
    }

    /// The box in the frame of body A around this box, which is given in the frame of body B.
    #[inline]
    pub(crate) fn placed(&self, b_in_a: Pose) -> Extent {
        self.turned(b_in_a.apply(self.center_m()), b_in_a)
    }

    /// The box in the frame of body B around this box, which is given in the frame of body A.
    #[inline]
    pub(crate) fn seen_from(&self, b_in_a: Pose) -> Extent {
        self.turned(b_in_a.apply_inverse(self.center_m()), b_in_a)
    }

    /// The smallest box around this box when it is turned and its centre placed at `center_m`. The turned box is the
    /// same for a turn to either side.
    #[inline]
    fn turned(&self, center_m: Vec2, b_in_a: Pose) -> Extent {
        let half = self.half_m();
        let (cos, sin) = (b_in_a.rotation.cos.abs(), b_in_a.rotation.sin.abs());
        let half = vec2(cos * half.x + sin * half.y, sin * half.x + cos * half.y);
        Extent { low_m: center_m - half, high_m: center_m + half }
    }

    /// Largest absolute value of a coordinate of the box's corners (m).
    #[inline]
    pub(crate) fn farthest_m(&self) -> f64 {
        [self.low_m, self.high_m]
            .iter()
            .fold(0.0, |far_m, v| greater(far_m, greater(v.x.abs(), v.y.abs())))
    }
}
