//! Outlines for the tests of this module: the shapes of ships and quays, and random simple polygons.

use alloc::vec;
use alloc::vec::Vec;
use core::f64::consts::PI;

use proptest::prelude::*;

use super::exact::turn;
use crate::maths::vec2::{Rotation, Vec2, vec2};

pub(super) fn points(coordinates: &[(f64, f64)]) -> Vec<Vec2> {
    coordinates.iter().map(|&(x, y)| vec2(x, y)).collect()
}

pub(super) fn rectangle(length_m: f64, width_m: f64) -> Vec<Vec2> {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    points(&[(-x, -y), (x, -y), (x, y), (-x, y)])
}

/// A ship's waterline with a bulb ahead of the stem. There are two reflex corners where the bulb joins the stem.
pub(super) fn bulbous_bow() -> Vec<Vec2> {
    points(&[
        (-149.0, -23.0),
        (104.0, -23.0),
        (135.0, -8.0),
        (142.0, -2.5),
        (147.0, -3.5),
        (150.0, -2.0),
        (151.0, 0.0),
        (150.0, 2.0),
        (147.0, 3.5),
        (142.0, 2.5),
        (135.0, 8.0),
        (104.0, 23.0),
        (-149.0, 23.0),
    ])
}

/// A ship whose side has a step (a sponson) and a knuckle.
pub(super) fn stepped_ship() -> Vec<Vec2> {
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

/// An outline like a comb: a back with `teeth` teeth.
pub(super) fn comb(teeth: usize, depth_m: f64) -> Vec<Vec2> {
    let mut ring = vec![vec2(0.0, 0.0), vec2(2.0 * teeth as f64 - 1.0, 0.0)];
    for tooth in (0..teeth).rev() {
        let x = 2.0 * tooth as f64;
        ring.extend(points(&[(x + 1.0, depth_m), (x, depth_m)]));
        if tooth > 0 {
            ring.extend(points(&[(x, 1.0), (x - 1.0, 1.0)]));
        }
    }
    ring
}

/// An outline like a band wound into a spiral, with `per_side` vertices on either side.
pub(super) fn spiral(per_side: usize, turns: f64) -> Vec<Vec2> {
    let at = |i: usize, inset: f64| {
        let angle = 2.0 * PI * turns * i as f64 / (per_side - 1) as f64;
        Rotation::from_angle(angle).apply(vec2(3.0 + angle / PI - inset, 0.0))
    };
    let outer = (0..per_side).map(|i| at(i, 0.0));
    outer.chain((0..per_side).rev().map(|i| at(i, 0.8))).collect()
}

/// An outline like a star around `centre`: one vertex in each direction, at the given distances.
pub(super) fn star(distances_m: &[f64], centre: Vec2) -> Vec<Vec2> {
    let step = 2.0 * PI / distances_m.len() as f64;
    let spoke =
        |(i, r): (usize, &f64)| centre + Rotation::from_angle(step * i as f64).apply(vec2(*r, 0.0));
    distances_m.iter().enumerate().map(spoke).collect()
}

/// Removes crossings of edges: reverses the part of the ring between two crossing edges, which shortens the ring.
fn uncrossed(mut ring: Vec<Vec2>) -> Vec<Vec2> {
    let count = ring.len();
    for _ in 0..10_000 {
        let crossing =
            (0..count).flat_map(|i| (i + 2..count).map(move |j| (i, j))).find(|&(i, j)| {
                let (a, b, c, d) = (ring[i], ring[i + 1], ring[j], ring[(j + 1) % count]);
                let over = |p, q, r, s| turn(p, q, r) * turn(p, q, s) < 0.0;
                (j + 1) % count != i && over(a, b, c, d) && over(c, d, a, b)
            });
        let Some((i, j)) = crossing else { break };
        ring[i + 1..=j].reverse();
    }
    ring
}

fn random_star() -> impl Strategy<Value = Vec<Vec2>> {
    (prop::collection::vec(0.2..1.0f64, 3..60), -3.0..3.0f64, -2.0..2.0f64)
        .prop_map(|(distances, x, y)| star(&distances, vec2(x, y)))
}

fn random_simple() -> impl Strategy<Value = Vec<Vec2>> {
    prop::collection::vec((-50.0..50.0f64, -50.0..50.0f64), 3..40)
        .prop_map(|coordinates| uncrossed(points(&coordinates)))
}

/// Random polygons on a coarse grid, which have many straight lines, right angles and touching points.
fn random_on_grid() -> impl Strategy<Value = Vec<Vec2>> {
    prop::collection::vec((0..6i32, 0..6i32), 3..16).prop_map(|cells| {
        let corners = cells.into_iter().map(|(x, y)| vec2(f64::from(x), f64::from(y)));
        uncrossed(corners.collect())
    })
}

fn regular() -> impl Strategy<Value = Vec<Vec2>> {
    prop_oneof![
        Just(bulbous_bow()),
        Just(stepped_ship()),
        Just(rectangle(298.0, 46.0)),
        (2..30usize, 1.5..40.0f64).prop_map(|(teeth, depth_m)| comb(teeth, depth_m)),
        (8..150usize, 0.2..3.0f64).prop_map(|(per_side, turns)| spiral(per_side, turns)),
    ]
}

fn turned_about(ring: Vec<Vec2>, angle_rad: f64) -> Vec<Vec2> {
    let rotation = Rotation::from_angle(angle_rad);
    ring.into_iter().map(|v| rotation.apply(v)).collect()
}

/// Any of the shapes of this module, in either sense, at any angle; a few of them are not simple.
pub(super) fn any_shape() -> impl Strategy<Value = Vec<Vec2>> {
    let shape = prop_oneof![random_star(), random_simple(), random_on_grid(), regular()];
    let angle = prop_oneof![Just(0.0), -PI..PI];
    (shape, angle, any::<bool>()).prop_map(|(ring, angle_rad, reversed)| {
        let mut ring = turned_about(ring, angle_rad);
        if reversed {
            ring.reverse();
        }
        ring
    })
}
