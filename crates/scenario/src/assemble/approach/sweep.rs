//! Finds what a hull meets that moves in a straight line, and after which distance.

use fenderline_contact::{Pose, Vec2};

/// The face of a fender and the line where the fender is mounted.
pub(super) struct Face {
    pub(super) ends_m: [Vec2; 2],
    pub(super) mounting_m: [Vec2; 2],
}

impl Face {
    pub(super) fn middle_m(&self) -> Vec2 {
        (self.ends_m[0] + self.ends_m[1]) * 0.5
    }

    /// The corners of the rectangle between the mounting of the fender and its face.
    pub(super) fn box_m(&self) -> [Vec2; 4] {
        [self.ends_m[0], self.ends_m[1], self.mounting_m[0], self.mounting_m[1]]
    }
}

/// The vertices of an outline in the earth's horizontal plane, for a body at the place `pose`.
pub(super) fn moved(outline: &[Vec2], pose: Pose) -> Vec<Vec2> {
    outline.iter().map(|point| pose.apply(*point)).collect()
}

fn edges(points: &[Vec2], is_closed: bool) -> impl Iterator<Item = [Vec2; 2]> {
    let count = if is_closed { points.len() } else { points.len() - 1 };
    (0..count).map(move |index| [points[index], points[(index + 1) % points.len()]])
}

/// Whether two polygons do not overlap: their edges do not cross, and neither polygon lies inside the other.
pub(super) fn are_apart(one: &[Vec2], other: &[Vec2]) -> bool {
    let crossing = edges(one, true).any(|a| edges(other, true).any(|b| cross(a, b)));
    !crossing && !holds(one, other[0]) && !holds(other, one[0])
}

fn cross([a, b]: [Vec2; 2], [c, d]: [Vec2; 2]) -> bool {
    let side = |p: Vec2| (b - a).cross(p - a);
    let other_side = |p: Vec2| (d - c).cross(p - c);
    side(c) * side(d) < 0.0 && other_side(a) * other_side(b) < 0.0
}

fn holds(polygon: &[Vec2], point: Vec2) -> bool {
    let crosses = |[a, b]: &[Vec2; 2]| {
        (a.y > point.y) != (b.y > point.y)
            && point.x < a.x + (b.x - a.x) * (point.y - a.y) / (b.y - a.y)
    };
    edges(polygon, true).filter(crosses).count() % 2 == 1
}

/// How far a hull moves in the direction `way`, a unit vector, until the hull meets a line of points (m); `None` if the
/// hull never meets the line.
pub(super) fn travel_m(hull: &[Vec2], line: &[Vec2], is_closed: bool, way: Vec2) -> Option<f64> {
    let of_hull = hull.iter().flat_map(|vertex| {
        edges(line, is_closed).filter_map(move |edge| ray_m(*vertex, way, edge))
    });
    let of_line = line
        .iter()
        .flat_map(|point| edges(hull, true).filter_map(move |edge| ray_m(*point, -way, edge)));
    of_hull.chain(of_line).min_by(f64::total_cmp)
}

/// Distance along a ray at which the ray meets an edge; `None` if the ray misses the edge.
fn ray_m(from: Vec2, way: Vec2, [a, b]: [Vec2; 2]) -> Option<f64> {
    let along = b - a;
    let slope = way.cross(along);
    if slope == 0.0 {
        return None;
    }
    let distance_m = (a - from).cross(along) / slope;
    let share = (a - from).cross(way) / slope;
    // A ship that touches already has rounding errors to both sides.
    (distance_m > -1e-6 && (0.0..=1.0).contains(&share)).then_some(distance_m)
}

#[cfg(test)]
mod tests {
    use super::{are_apart, travel_m};
    use fenderline_contact::vec2;

    #[test]
    fn a_square_meets_what_lies_on_its_way() {
        let square = [vec2(0.0, 0.0), vec2(2.0, 0.0), vec2(2.0, 2.0), vec2(0.0, 2.0)];
        let wall = |x| [vec2(x, -5.0), vec2(x, 5.0)];
        assert_eq!(travel_m(&square, &wall(7.0), false, vec2(1.0, 0.0)), Some(5.0));
        assert_eq!(travel_m(&square, &wall(7.0), false, vec2(-1.0, 0.0)), None);
        // A post between its corners.
        let post = [vec2(4.0, 0.5), vec2(4.5, 0.5)];
        assert_eq!(travel_m(&square, &post, false, vec2(1.0, 0.0)), Some(2.0));
        let shifted = |x: f64| square.map(|point| point + vec2(x, 0.5));
        assert!(are_apart(&square, &shifted(2.5)));
        assert!(!are_apart(&square, &shifted(1.5)));
        let small = square.map(|point| point * 0.1 + vec2(1.0, 1.0));
        assert!(!are_apart(&square, &small) && !are_apart(&small, &square));
    }
}
