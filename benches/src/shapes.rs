//! The polygons of the benches.

use std::f64::consts::TAU;

use fenderline_contact::{ConvexPolygon, Rotation, Vec2, vec2};

const LENGTH_M: f64 = 298.0;
const BEAM_M: f64 = 46.0;
const FENDER_RADIUS_M: f64 = 3.0;

/// A hull of 298 × 46 m with `corners` corners: a box, or a superellipse with full sides.
pub(crate) fn hull(corners: usize) -> ConvexPolygon {
    full_sided(corners, LENGTH_M, BEAM_M)
}

/// A vessel of half the hull's length and 0.7 times its beam.
pub(crate) fn vessel(corners: usize) -> ConvexPolygon {
    full_sided(corners, 0.5 * LENGTH_M, 0.7 * BEAM_M)
}

/// A fender: a block of 4 × 2 m, or a round one of 6 m across.
pub(crate) fn fender(corners: usize) -> ConvexPolygon {
    if corners == 4 { rectangle(4.0, 2.0) } else { regular(corners, FENDER_RADIUS_M) }
}

/// A block of `length_m` × `width_m` about the origin.
pub(crate) fn rectangle(length_m: f64, width_m: f64) -> ConvexPolygon {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    ConvexPolygon::new(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)])
}

fn regular(corners: usize, radius_m: f64) -> ConvexPolygon {
    ConvexPolygon::new(&directions(corners).map(|d| d * radius_m).collect::<Vec<_>>())
}

fn full_sided(corners: usize, length_m: f64, beam_m: f64) -> ConvexPolygon {
    if corners == 4 {
        return rectangle(length_m, beam_m);
    }
    let rooted = |c: f64| c.signum() * c.abs().sqrt();
    let vertices: Vec<Vec2> = directions(corners)
        .map(|d| vec2(0.5 * length_m * rooted(d.x), 0.5 * beam_m * rooted(d.y)))
        .collect();
    ConvexPolygon::new(&vertices)
}

/// Unit vectors in equal steps all round, none of them along an axis.
fn directions(corners: usize) -> impl Iterator<Item = Vec2> {
    (0..corners).map(move |i| {
        Rotation::from_angle(TAU * (i as f64 + 0.37) / corners as f64).apply(vec2(1.0, 0.0))
    })
}
