//! Computes a lower bound on the gap between two polygons.

use super::clip::Hint;
use super::convex::{ConvexPolygon, Placed};
use crate::maths::number::greater;
use crate::maths::vec2::Pose;

/// A lower bound on the gap between two polygons, from the hint of the last clip (m). The lower bound on the gap is 0
/// unless the hint shows that the two polygons are apart.
pub(crate) fn gap_m(a: &ConvexPolygon, b: &ConvexPolygon, b_in_a: Pose, hint: Hint) -> f64 {
    let placed = Placed { polygon: b, pose: b_in_a };
    match hint {
        Hint::Lens(_) => 0.0,
        Hint::None => {
            let apart = b_in_a.apply(b.center_m()) - a.center_m();
            greater(apart.length() - a.radius_m() - b.radius_m(), 0.0)
        }
        Hint::Apart { on_a, edge, support } => {
            let (edge, support) = (edge as usize, support as usize);
            let (start, end, nearest) = if on_a {
                (a.corner(edge), a.corner(edge + 1), placed.vertex(support))
            } else {
                (placed.vertex(edge), placed.vertex(edge + 1), a.corner(support))
            };
            let along = end - start;
            greater(-along.cross(nearest - start) / along.length(), 0.0)
        }
    }
}
