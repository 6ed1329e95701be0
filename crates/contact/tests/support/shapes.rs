//! Convex polygons and their positions: hulls, fenders, random shapes.

use core::f64::consts::TAU;

use fenderline_contact::{Pose, Vec2, vec2};
use proptest::prelude::*;

/// Points from pairs of coordinates.
pub fn points(coordinates: &[(f64, f64)]) -> Vec<Vec2> {
    coordinates.iter().map(|&(x, y)| vec2(x, y)).collect()
}

/// A ship with a step in its side.
pub fn stepped_ship() -> Vec<Vec2> {
    points(&[
        (-80.0, -14.0),
        (60.0, -14.0),
        (85.0, 0.0),
        (60.0, 14.0),
        (20.0, 14.0),
        (20.0, 12.0),
        (-30.0, 11.5),
        (-80.0, 12.5),
    ])
}

/// A rectangle about the origin.
pub fn rectangle(length_m: f64, width_m: f64) -> Vec<Vec2> {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    points(&[(-x, -y), (x, -y), (x, y), (-x, y)])
}

/// `count` vertices on an ellipse about the origin. Vertex i is late by `jitter[i]` spacings (0 to 0.7).
pub fn ellipse(length_m: f64, width_m: f64, count: usize, jitter: &[f64]) -> Vec<Vec2> {
    let late = |i: usize| jitter.get(i).copied().unwrap_or(0.0);
    (0..count)
        .map(|i| {
            let angle = (i as f64 + late(i)) * TAU / count as f64;
            let (sin, cos) = libm::sincos(angle);
            vec2(0.5 * length_m * cos, 0.5 * width_m * sin)
        })
        .collect()
}

/// The waterline of a ship with a parallel middle body, with `count` vertices (at least 6). The paper's ship is 298 m
/// by 46 m.
pub fn hull(length_m: f64, width_m: f64, count: usize) -> Vec<Vec2> {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    let round = count - 4; // on the bow, from one shoulder to the other
    let mut ring = points(&[(-x, -y), (0.7 * x, -y)]);
    for i in 1..=round {
        let (sin, cos) = libm::sincos(TAU * (i as f64 / (2.0 * (round + 1) as f64) - 0.25));
        ring.push(vec2(0.7 * x + 0.3 * x * cos, y * sin));
    }
    ring.extend([vec2(0.7 * x, y), vec2(-x, y)]);
    ring
}

/// A regular polygon about the origin.
pub fn regular(radius_m: f64, count: usize) -> Vec<Vec2> {
    ellipse(2.0 * radius_m, 2.0 * radius_m, count, &[])
}

/// Hulls, fenders, slender and round polygons of 3 to 64 vertices, up to 300 m long.
pub fn any_convex() -> impl Strategy<Value = Vec<Vec2>> {
    let jittered = (3usize..=64, prop::collection::vec(0.0..0.7, 64), 0.5..300.0f64, 0.05..1.0f64)
        .prop_map(|(count, jitter, length_m, aspect)| {
            ellipse(length_m, length_m * aspect, count, &jitter)
        });
    prop_oneof![
        4 => jittered,
        2 => (6usize..=64).prop_map(|count| hull(298.0, 46.0, count)),
        2 => (0.2..30.0f64, 0.2..5.0f64).prop_map(|(l, w)| rectangle(l, w)),
        1 => (0.3..3.0f64, 3usize..=32).prop_map(|(r, count)| regular(r, count)),
    ]
}

/// The largest extent of a ring in a direction, and its vertex.
pub fn support(ring: &[Vec2], pose: Pose, direction: Vec2) -> (f64, Vec2) {
    ring.iter().map(|&v| pose.rotation.apply(v)).fold((f64::NEG_INFINITY, Vec2::ZERO), |best, v| {
        if v.dot(direction) > best.0 { (v.dot(direction), v) } else { best }
    })
}

/// Places `b` beside `a` in the direction `bearing_rad`, with penetration `depth_m`. It is shifted sideways by `share`
/// of the way from corner to corner.
pub fn beside(
    a: &[Vec2],
    a_pose: Pose,
    b: &[Vec2],
    b_heading_rad: f64,
    (bearing_rad, depth_m, share): (f64, f64, f64),
) -> Pose {
    let (sin, cos) = libm::sincos(bearing_rad);
    let out = vec2(cos, sin);
    let turned = Pose::new(Vec2::ZERO, b_heading_rad);
    let (reach_a, corner_a) = support(a, a_pose, out);
    let (reach_b, corner_b) = support(b, turned, -out);
    let along = out.quarter_turn();
    // With share 0, a corner touches a corner. Otherwise b's corner moves along the tangent, up to a's far end.
    let extent = support(a, a_pose, along).0 + support(a, a_pose, -along).0;
    let aside = (corner_a - corner_b).dot(along) + share * extent;
    let position = a_pose.position_m + out * (reach_a + reach_b - depth_m) + along * aside;
    Pose::new(position, b_heading_rad)
}
