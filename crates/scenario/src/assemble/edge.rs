//! Edges of a body's outline, and the direction in which a fender on an edge faces.

use fenderline_contact::number::bounded;
use fenderline_contact::{Outline, Vec2};
use fenderline_sim::BodySetup;

/// A point that is this near to an edge counts as lying on the edge (m).
const ON_EDGE_M: f64 = 0.01;

/// An edge of an outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    pub(super) from_m: Vec2,
    /// Unit vector along the edge of the outline.
    pub(super) along: Vec2,
    pub(super) length_m: f64,
    /// Unit vector that points out of the body, at right angles to the edge.
    pub(super) outward: Vec2,
}

impl Edge {
    /// Distance of a point from the start of the edge, measured along the edge (m).
    pub(super) fn reach_m(&self, point_m: Vec2) -> f64 {
        (point_m - self.from_m).dot(self.along)
    }

    pub(super) fn end_m(&self) -> Vec2 {
        self.from_m + self.along * self.length_m
    }

    pub(super) fn holds(&self, point_m: Vec2) -> bool {
        let off_m = (point_m - self.from_m).dot(self.outward).abs();
        let reach_m = self.reach_m(point_m);
        off_m <= ON_EDGE_M && reach_m >= -ON_EDGE_M && reach_m <= self.length_m + ON_EDGE_M
    }
}

/// The edges of an outline.
pub(super) fn edges(outline: &Outline) -> impl Iterator<Item = Edge> {
    outline.edges().map(|[from_m, to_m]| {
        let length_m = (to_m - from_m).length();
        let along = (to_m - from_m) * (1.0 / length_m);
        // Vertices run in the positive sense.
        Edge { from_m, along, length_m, outward: along.quarter_turn_back() }
    })
}

/// The edges of an outline on which all the points `points_m` lie.
pub(super) fn edges_with(outline: &Outline, points_m: &[Vec2]) -> Vec<Edge> {
    let holds_all = |edge: &Edge| points_m.iter().all(|point| edge.holds(*point));
    edges(outline).filter(holds_all).collect()
}

/// The direction in which a fender at a point of the outline faces (rad). The fender faces out from the edge, and at a
/// corner midway between the two edges; `None` if the point is not on the outline.
pub(super) fn facing_rad(outline: &Outline, point_m: Vec2) -> Option<f64> {
    match edges_with(outline, &[point_m]).as_slice() {
        [edge] => Some(direction_rad(edge.outward)),
        [one, other] => Some(direction_rad(one.outward + other.outward)),
        _ => None,
    }
}

/// The angle of a direction, clockwise from forward (rad).
pub(super) fn direction_rad(direction: Vec2) -> f64 {
    // Adding zero turns -0 into 0, of which the angle would be -π for π.
    libm::atan2(direction.y + 0.0, direction.x + 0.0)
}

/// Whether a point lies inside a body's outline and not on its edges.
pub(super) fn is_inside(body: &BodySetup, point_m: Vec2) -> bool {
    let mut inside = false;
    for edge in edges(&body.outline) {
        let (a, b) = (edge.from_m, edge.end_m());
        let nearest_m = a + edge.along * bounded(edge.reach_m(point_m), 0.0, edge.length_m);
        if (point_m - nearest_m).length() <= ON_EDGE_M {
            return false;
        }
        let crosses = (a.y > point_m.y) != (b.y > point_m.y);
        if crosses && point_m.x < a.x + (b.x - a.x) * (point_m.y - a.y) / (b.y - a.y) {
            inside = !inside;
        }
    }
    inside
}

#[cfg(test)]
mod tests {
    use super::facing_rad;
    use core::f64::consts::{FRAC_PI_2, FRAC_PI_4, PI};
    use fenderline_contact::{Outline, vec2};

    #[test]
    fn a_fender_faces_out_of_its_edge_or_corner() {
        let square = [vec2(0.0, 0.0), vec2(4.0, 0.0), vec2(4.0, 4.0), vec2(0.0, 4.0)];
        for turned in [false, true] {
            let mut points = square;
            if turned {
                points.reverse();
            }
            let (outline, _) = Outline::new(&points).unwrap();
            let facing = |x, y| facing_rad(&outline, vec2(x, y));
            assert_eq!(facing(1.0, 0.0), Some(-FRAC_PI_2));
            assert_eq!(facing(1.0, 4.0), Some(FRAC_PI_2));
            assert_eq!(facing(4.0, 1.0), Some(0.0));
            assert_eq!(facing(0.0, 1.0), Some(PI));
            assert_eq!(facing(4.0, 4.0), Some(FRAC_PI_4));
            assert_eq!(facing(2.0, 2.0), None);
        }
    }
}
