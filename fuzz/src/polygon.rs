//! Convex polygons made from a fuzzer's bytes.

use fenderline_contact::{ConvexPolygon, Vec2};

use crate::input::Input;

/// Factors on coordinates within ±128 m, for polygons as large as fenders, tugs and ships.
const SCALES: [f64; 4] = [1.0, 1.0 / 64.0, 1.0 / 8.0, 4.0];

/// A convex polygon: the convex hull of some points; `None` if the points lie on a line.
pub fn polygon(input: &mut Input<'_>) -> Option<ConvexPolygon> {
    let count = 3 + usize::from(input.byte() % 30);
    let scale = SCALES[usize::from(input.byte() % 4)];
    let points = (0..count).map(|_| {
        let (x, y) = (input.coordinate_m(), input.coordinate_m());
        fenderline_contact::vec2(x, y) * scale
    });
    let hull = hull(points.collect());
    (hull.len() >= 3).then(|| ConvexPolygon::new(&hull))
}

/// Finds the convex hull by Andrew's monotone chain: corners in the positive sense, without corners on a straight edge.
/// The result is exact for coordinates on the grid of [`Input::coordinate_m`].
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|p, q| p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut hull = chain(points.iter().copied());
    hull.pop();
    hull.extend(chain(points.iter().rev().copied()));
    hull.pop();
    hull
}

/// One half of the convex hull, from the first point to the last.
fn chain(points: impl Iterator<Item = Vec2>) -> Vec<Vec2> {
    let mut kept: Vec<Vec2> = Vec::new();
    for point in points {
        while let [.., one, two] = kept[..]
            && (two - one).cross(point - two) <= 0.0
        {
            kept.pop();
        }
        kept.push(point);
    }
    kept
}
