//! A path in the plane, in bounded memory.

use fenderline_contact::number::greater;

use crate::plot::Point;

/// Largest number of points that are kept of a path.
const POINTS: usize = 2000;
/// A point closer to the last kept point than this share of the path's extent is left out; the share is doubled each
/// time that the memory is full.
const FINEST: f64 = 1e-3;

/// A path with a bounded number of points. A point is kept if its distance from the last kept point is at least a share
/// of the path's extent, so that a body at rest takes no memory and a loop keeps its shape.
#[derive(Clone, Debug, Default)]
pub(in crate::run_page) struct Path {
    points: Vec<Point>,
    /// The last given point, whether it is kept or not.
    last: Option<Point>,
    extent: (f64, f64),
    doublings: u32,
}

impl Path {
    /// Continues the path to a point with finite coordinates.
    pub(super) fn push(&mut self, x: f64, y: f64) {
        let point = Point { x, y };
        self.extent = (greater(self.extent.0, x.abs()), greater(self.extent.1, y.abs()));
        let is_far = self.points.last().is_none_or(|kept| self.is_apart(*kept, point));
        if is_far {
            self.points.push(point);
            if self.points.len() > POINTS {
                self.coarsen();
            }
        }
        self.last = Some(point);
    }

    fn is_apart(&self, a: Point, b: Point) -> bool {
        let finest = FINEST * f64::from(1_u32 << self.doublings.min(31));
        (a.x - b.x).abs() > finest * self.extent.0 || (a.y - b.y).abs() > finest * self.extent.1
    }

    /// Doubles the smallest distance between points, and drops the points that are now too close.
    fn coarsen(&mut self) {
        self.doublings += 1;
        let mut kept: Vec<Point> = Vec::with_capacity(POINTS);
        for &point in &self.points {
            if kept.last().is_none_or(|last| self.is_apart(*last, point)) {
                kept.push(point);
            }
        }
        self.points = kept;
    }

    /// The kept points of the path, and its last point.
    pub(in crate::run_page) fn points(&self) -> Vec<Point> {
        let mut points = self.points.clone();
        points.extend(self.last.filter(|last| points.last() != Some(last)));
        points
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_loop_keeps_its_shape_and_a_body_at_rest_adds_no_points() {
        let mut path = Path::default();
        for k in 0..1_000_000 {
            // The path goes up the diagonal and back below the diagonal, then rests.
            let (x, y) = match f64::from(k) * 1e-3 {
                up if up <= 100.0 => (up, up),
                down if down <= 200.0 => (200.0 - down, 0.5 * (200.0 - down)),
                _ => (0.0, 0.0),
            };
            path.push(x, y);
        }
        let points = path.points();
        assert!(points.len() <= POINTS + 1);
        let top = points.iter().map(|p| p.x).fold(0.0, greater);
        assert!(top > 99.5, "{top}");
        assert_eq!(points.last(), Some(&Point { x: 0.0, y: 0.0 }));
        assert!(points.iter().any(|p| (p.y - 0.5 * p.x).abs() < 1e-9 && p.x > 20.0));
    }

    #[test]
    fn a_path_that_never_ends_stays_bounded() {
        let mut path = Path::default();
        for k in 0..200_000_u32 {
            path.push(f64::from(k % 1013), f64::from(k % 997));
        }
        assert!(path.points().len() <= POINTS + 1);
    }
}
