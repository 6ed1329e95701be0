//! A patch of contact between two bodies, and the place of the patch.

use crate::broad::candidates::Candidate;
use crate::geometry::extent::Extent;
use crate::maths::vec2::{Pose, Vec2};

/// A connected part of the overlap of two bodies, in the frame of body A, the body of lower rank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(crate) candidate: Candidate,
    /// Index of the patch's candidate in `Candidates::pairings`.
    pub(crate) of: u32,
    /// Number within the pair.
    pub(crate) number: u32,
    /// Pose of body B in the frame of body A.
    pub(crate) b_in_a: Pose,
    /// Area S (m²).
    pub(crate) area_m2: f64,
    /// Centroid C (m).
    pub(crate) centroid_m: Vec2,
    /// Chord vector d = Σ (P_out − P_in) of the patch (m).
    pub(crate) chord_m: Vec2,
    /// Inverse length 1/|d| of the chord vector (1/m), as in [`crate::geometry::lens::Lens`].
    pub(crate) per_chord_m: f64,
    /// True if one convex piece lies within the other and the bodies have no other pieces.
    pub(crate) contained: bool,
    /// Extent of the patch along the normal of the chord, times the length of the chord (m²), if the patch is a single
    /// lens.
    pub(crate) spread_m2: f64,
    /// Index of the first of the patch's [`Parts`], and the index after the last.
    pub(crate) parts: [u32; 2],
    /// Index of the patch's place in `Overlap::places`; [`NOWHERE`] if both bodies are convex.
    pub(crate) place: u32,
}

pub(crate) const NOWHERE: u32 = u32::MAX;

impl Patch {
    /// Index of the patch's place in `Overlap::places`; `None` if both bodies are convex.
    #[inline]
    pub(crate) fn place(&self) -> Option<u32> {
        (self.place != NOWHERE).then_some(self.place)
    }

    /// The parts of which the patch consists.
    #[inline]
    pub(crate) fn parts(&self) -> Parts {
        let [from, to] = self.parts;
        match self.place() {
            None => Parts::One { from, to },
            Some(_) => Parts::Lenses { from, to },
        }
    }
}

/// The parts of which a patch of contact consists.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Parts {
    /// The patch is the one lens of two convex pieces, given by the range of its vertices in `Overlap::outline_m`.
    One { from: u32, to: u32 },
    /// Lenses in `Overlap::lenses`.
    Lenses { from: u32, to: u32 },
}

/// Place of a patch: the bounding boxes around it in the frames of the bodies A and B (m). The next step recognises the
/// patch by these boxes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Place {
    pub(crate) in_a: Extent,
    pub(crate) in_b: Extent,
}

impl Place {
    /// Returns true if the boxes of the two places meet in the frame of one of the two bodies.
    #[inline]
    pub(crate) fn meets(&self, other: &Place) -> bool {
        self.in_a.overlaps(&other.in_a) || self.in_b.overlaps(&other.in_b)
    }
}
