//! The overlaps of a step or sub-step: the lens-shaped overlaps of convex pieces, and the patches that consist of them.

use alloc::vec::Vec;

use crate::geometry::extent::Extent;
use crate::geometry::lens::Lens;
use crate::maths::room::room_for;
use crate::maths::vec2::Vec2;
use crate::overlap::patch::{Parts, Patch, Place};

/// The overlap of one convex piece of body A with one convex piece of body B.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PieceLens {
    pub(crate) lens: Lens,
    pub(crate) contained: bool,
    pub(crate) piece_a: u32,
    pub(crate) piece_b: u32,
    /// The range of this lens's vertices in [`Overlap::outline_m`].
    pub(crate) vertices: (u32, u32),
    /// The bounding box of the vertices, in the frame of body A.
    pub(crate) extent: Extent,
    /// Number of the connected patch of contact within the pair of bodies.
    pub(crate) patch: u32,
}

impl PieceLens {
    /// The corners of this lens, taken from the corners of all lenses (m).
    pub(crate) fn corners_m<'a>(&self, outline_m: &'a [Vec2]) -> &'a [Vec2] {
        &outline_m[self.vertices.0 as usize..self.vertices.1 as usize]
    }
}

/// The overlaps that a step or sub-step has found. Computed by `overlap::overlap`.
#[derive(Clone, Debug, Default)]
pub(crate) struct Overlap {
    pub(crate) patches: Vec<Patch>,
    /// The places of the patches of bodies that are not convex.
    pub(crate) places: Vec<Place>,
    pub(crate) lenses: Vec<PieceLens>,
    pub(crate) outline_m: Vec<Vec2>,
    /// The lenses of one pair of bodies, sorted by the low ends of their boxes. The sorted list is used in the search
    /// for lenses that share a seam, the common edge of two convex pieces.
    pub(crate) by_low_end: Vec<(f64, u32)>,
}

impl Overlap {
    /// Makes buffers with room for this number of patches of four corners each.
    pub(crate) fn with_room(patches: usize) -> Overlap {
        Overlap {
            patches: room_for(patches),
            outline_m: room_for(4 * patches),
            ..Overlap::default()
        }
    }

    pub(crate) fn clear(&mut self) {
        self.patches.clear();
        self.places.clear();
        self.lenses.clear();
        self.outline_m.clear();
    }
}

/// The outlines of all lenses that make up a patch.
#[inline]
pub(crate) fn outlines<'a>(
    found: &'a Overlap,
    patch: &Patch,
) -> impl Iterator<Item = &'a [Vec2]> + Clone {
    let (one, lenses) = match patch.parts() {
        Parts::One { from, to } => {
            (Some(&found.outline_m[from as usize..to as usize]), [].as_slice())
        }
        Parts::Lenses { from, to } => (None, &found.lenses[from as usize..to as usize]),
    };
    one.into_iter().chain(lenses.iter().map(|lens| lens.corners_m(&found.outline_m)))
}
