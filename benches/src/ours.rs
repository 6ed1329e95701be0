//! Our clip of two convex polygons, called for all poses of a path.

use std::hint::black_box;

use fenderline_contact::{ConvexPolygon, PairClip};

use crate::paths::Path;

/// One round. If `cold`, each call forgets what the last call found.
pub(crate) fn round(
    pair: &mut PairClip,
    first: &ConvexPolygon,
    second: &ConvexPolygon,
    path: &Path,
    cold: bool,
) {
    for poses in path {
        let [one, two] = *black_box(poses);
        if cold {
            pair.forget();
        }
        black_box(pair.clip(first, one, second, two));
    }
}

/// Area of the overlap at each call (m²).
pub(crate) fn areas_m2(first: &ConvexPolygon, second: &ConvexPolygon, path: &Path) -> Vec<f64> {
    let mut pair = PairClip::default();
    path.iter()
        .map(|&[one, two]| pair.clip(first, one, second, two).map_or(0.0, |clip| clip.area_m2()))
        .collect()
}
