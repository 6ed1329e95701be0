//! How two polygons move from call to call of a clip: closed loops that a bench runs round and round, with the motion
//! of a simulation at steps of 0.1 s, 1 km from the chart's origin.

use std::f64::consts::TAU;

use fenderline_contact::{ConvexPolygon, Pose, Rotation, Vec2, vec2};

/// Calls in a loop.
pub(crate) const CALLS: usize = 1024;

/// The poses of the two polygons at each call.
pub(crate) type Path = Vec<[Pose; 2]>;

/// How the second polygon lies against the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Approach {
    /// The second polygon is 2 to 40 cm deep in the hull's side and slides 20 m fore and aft.
    Shallow,
    /// The second polygon is 5 to 50 cm off the hull's side and slides 20 m fore and aft.
    Near,
    /// A good part of the second polygon lies within the first, at an angle.
    Deep,
}

/// The loop that the second polygon makes along the first.
pub(crate) fn path(approach: Approach, first: &ConvexPolygon, second: &ConvexPolygon) -> Path {
    (0..CALLS).map(|call| at(approach, first, second, call as f64 / CALLS as f64)).collect()
}

fn at(approach: Approach, first: &ConvexPolygon, second: &ConvexPolygon, turn: f64) -> [Pose; 2] {
    let wave = |cycles: f64, phase: f64| libm::sin(TAU * (cycles * turn) + phase);
    let hull = Pose::new(
        vec2(1000.0 + 5.0 * wave(1.0, 0.3), -700.0 + wave(2.0, 1.1)),
        0.4 + 0.02 * wave(1.0, 0.0),
    );
    let (along_m, heading_rad, off_m) = match approach {
        Approach::Shallow => {
            (20.0 * wave(1.0, 0.0), 0.05 * wave(2.0, 0.7), -0.21 - 0.19 * wave(3.0, 0.2))
        }
        Approach::Near => {
            (20.0 * wave(1.0, 0.0), 0.05 * wave(2.0, 0.7), 0.275 + 0.225 * wave(3.0, 0.2))
        }
        Approach::Deep => {
            (30.0 * wave(1.0, 0.0), 0.5 + 0.05 * wave(2.0, 0.7), -30.0 - 5.0 * wave(3.0, 0.2))
        }
    };
    let rotation = Rotation::from_angle(heading_rad);
    let reach_m = second.vertices().iter().fold(0.0, |r, &v| f64::max(r, -rotation.apply(v).y));
    let in_hull = vec2(along_m, starboard_side_m(first, along_m) + reach_m + off_m);
    let pose = Pose::new(hull.apply(in_hull), 0.4 + 0.02 * wave(1.0, 0.0) + heading_rad);
    [hull, pose]
}

/// How far the polygon reaches to starboard at the length `x_m` (m).
fn starboard_side_m(polygon: &ConvexPolygon, x_m: f64) -> f64 {
    let vertices = polygon.vertices();
    let edges = (0..vertices.len()).map(|i| (vertices[i], vertices[(i + 1) % vertices.len()]));
    let across = |(from, to): (Vec2, Vec2)| {
        let share = (x_m - from.x) / (to.x - from.x);
        (0.0..=1.0).contains(&share).then_some(from.y + (to.y - from.y) * share)
    };
    edges.filter_map(across).fold(0.0, f64::max)
}
