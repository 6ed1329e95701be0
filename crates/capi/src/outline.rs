//! Functions that make outlines of bodies from the points of a mesh.

use fenderline_contact::{Vec2, vec2};
use fenderline_embed::{EngineError, hull_of_points, mirrored_outline, simplified_outline};

use crate::builder::pairs;
use crate::drawing::give_pairs;
use crate::failure::{FlStatus, Outcome};
use crate::table::no_panic;

/// Largest number of points from which an outline is made.
const MOST_MESH_POINTS: usize = 10_000_000;

/// Copies the convex hull of points, such as all vertices of a ship's mesh seen from above: pairs of x (forward) and y
/// (to starboard) (m). `capacity` counts vertices; `*vertices` gets their number, at most `points`. NULL `vertices`
/// with a capacity of 0 only ask for the number of vertices.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_outline_hull(
    points_m: *const f64,
    points: usize,
    outline_m: *mut f64,
    capacity: usize,
    vertices: *mut usize,
) -> FlStatus {
    // SAFETY: as the caller promises.
    unsafe { make(points_m, points, outline_m, capacity, vertices, hull_of_points) }
}

/// Copies the outline of a ship that is made from the points of her starboard side, from bow to stern or from stern to
/// bow: these points and their mirror images. Points within `tolerance_m` of the centreline (y = 0) count as points on
/// the centreline, and are not repeated. The outline has at most twice as many vertices as there are `points`. The
/// other arguments are as in fl_outline_hull().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_outline_mirror(
    side_m: *const f64,
    points: usize,
    tolerance_m: f64,
    outline_m: *mut f64,
    capacity: usize,
    vertices: *mut usize,
) -> FlStatus {
    let mirror = |side_m: &[Vec2]| mirrored_outline(side_m, tolerance_m);
    // SAFETY: as the caller promises.
    unsafe { make(side_m, points, outline_m, capacity, vertices, mirror) }
}

/// Copies a given outline, thinned to fewer vertices. No vertex of the given outline is farther than `tolerance_m` from
/// the new outline. The other arguments are as in fl_outline_hull().
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fl_outline_simplify(
    points_m: *const f64,
    points: usize,
    tolerance_m: f64,
    outline_m: *mut f64,
    capacity: usize,
    vertices: *mut usize,
) -> FlStatus {
    let simplify = |points_m: &[Vec2]| simplified_outline(points_m, tolerance_m);
    // SAFETY: as the caller promises.
    unsafe { make(points_m, points, outline_m, capacity, vertices, simplify) }
}

/// # Safety
/// The caller promises that `points` pairs are readable, and that there is room for `capacity` pairs.
unsafe fn make(
    points_m: *const f64,
    points: usize,
    outline_m: *mut f64,
    capacity: usize,
    vertices: *mut usize,
    of: impl FnOnce(&[Vec2]) -> Result<Vec<Vec2>, EngineError>,
) -> FlStatus {
    no_panic(|| -> Outcome {
        // SAFETY: as the caller promises.
        let points_m = unsafe { pairs(points_m, points, MOST_MESH_POINTS, "points_m") }?;
        let points_m: Vec<Vec2> = points_m.into_iter().map(|[x, y]| vec2(x, y)).collect();
        let made: Vec<[f64; 2]> = of(&points_m)?.iter().map(|v| [v.x, v.y]).collect();
        // SAFETY: as the caller promises.
        unsafe { give_pairs(&made, outline_m, capacity, vertices) }
    })
}
