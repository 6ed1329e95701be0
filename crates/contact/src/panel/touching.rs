//! Finds the points of a hull that a panel can meet.

use crate::maths::number::{greater, lesser};
use crate::maths::vec2::{Vec2, vec2};

/// A point of a hull in the frame of the face: x runs from the face inwards, and y along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct HullPoint {
    pub(crate) at: Vec2,
    /// Slope dx/dy of the hull's side where the side passes an end of the panel. The end of the panel that the side
    /// passes slides along the side. `None` for a corner of the hull, because a corner slides along the panel.
    pub(crate) side: Option<f64>,
}

/// The region, in the frame of the face, in which a panel can meet a hull.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Reach {
    /// Half of the panel's width (m).
    pub(crate) half_width_m: f64,
    /// How far inwards, and how far outwards (negative), the points of a hull are considered (m).
    pub(crate) far_m: f64,
    pub(crate) near_m: f64,
}

/// Passes to `add` the corners of a closed outline that lie in the strip before and behind the panel, and the points
/// where the outline's edges enter the strip. `to_face` transforms points into the frame of the face.
pub(crate) fn collect(
    edges: impl Iterator<Item = [Vec2; 2]>,
    to_face: impl Fn(Vec2) -> Vec2,
    reach: Reach,
    mut add: impl FnMut(HullPoint),
) {
    for [from, to] in edges.map(|ends| ends.map(&to_face)) {
        if !is_outside(from, to, reach) {
            add_edge(from, to, reach, &mut add);
        }
    }
}

/// Adds the start of an edge if it lies in the strip, and the points where the edge enters or leaves the strip.
fn add_edge(from: Vec2, to: Vec2, reach: Reach, add: &mut impl FnMut(HullPoint)) {
    let Reach { half_width_m, far_m, near_m } = reach;
    let by = to - from;
    if from.y.abs() <= half_width_m && from.x >= near_m && from.x <= far_m {
        add(HullPoint { at: from, side: None });
    }
    let mut add = |share: f64, side: Option<f64>| {
        let at = vec2(from.x + share * by.x, from.y + share * by.y);
        if share > 0.0 && share < 1.0 && at.x >= near_m && at.x <= far_m {
            add(HullPoint { at, side });
        }
    };
    if by.y != 0.0 {
        for end_m in [-half_width_m, half_width_m] {
            add((end_m - from.y) / by.y, Some(by.x / by.y));
        }
    }
    if by.x != 0.0 {
        let share = (far_m - from.x) / by.x;
        if (from.y + share * by.y).abs() <= half_width_m {
            add(share, None);
        }
    }
}

/// Returns true if the whole edge lies on one side of the strip.
fn is_outside(from: Vec2, to: Vec2, reach: Reach) -> bool {
    let (low, high) = (lesser(from.y, to.y), greater(from.y, to.y));
    let (near, far) = (lesser(from.x, to.x), greater(from.x, to.x));
    low > reach.half_width_m
        || high < -reach.half_width_m
        || far < reach.near_m
        || near > reach.far_m
}
