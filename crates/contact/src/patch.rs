//! A patch of contact, and where it lies.

use crate::candidates::Candidate;
use crate::geometry::extent::Extent;
use crate::vec2::{Pose, Vec2};

/// A connected part of the overlap of two bodies, in the frame of body A, the body of lower rank.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Patch {
    pub(crate) candidate: Candidate,
    /// Index of the patch's candidate in `Candidates::pairings`.
    pub(crate) of: u32,
    /// Number within the pair.
    pub(crate) number: u32,
    /// Pose of B in A's frame.
    pub(crate) b_in_a: Pose,
    /// Area S (m²).
    pub(crate) area_m2: f64,
    /// Centroid C (m).
    pub(crate) centroid_m: Vec2,
    /// Chord d = Σ (P_out − P_in) (m).
    pub(crate) chord_m: Vec2,
    /// 1/|d| (1/m), as in [`crate::geometry::lens::Lens`].
    pub(crate) per_chord_m: f64,
    /// Whether one piece lies within the other and there are no other pieces.
    pub(crate) contained: bool,
    /// Extent along the normal of the chord, times the length of the chord (m²), if the patch is one lens.
    pub(crate) spread_m2: f64,
    /// The first of the patch's [`Parts`], and the one after the last.
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

    /// The parts of the patch.
    #[inline]
    pub(crate) fn parts(&self) -> Parts {
        let [from, to] = self.parts;
        match self.place() {
            None => Parts::One { from, to },
            Some(_) => Parts::Lenses { from, to },
        }
    }
}

/// The parts of a patch.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Parts {
    /// The one lens of two convex pieces: its vertices in `Overlap::outline_m`.
    One { from: u32, to: u32 },
    /// Lenses in `Overlap::lenses`.
    Lenses { from: u32, to: u32 },
}

/// Boxes around a patch in A's and in B's frame (m). The patch is recognised by them in the next step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Place {
    pub(crate) in_a: Extent,
    pub(crate) in_b: Extent,
}

impl Place {
    /// Do the boxes meet in the frame of one of the two bodies?
    #[inline]
    pub(crate) fn meets(&self, other: &Place) -> bool {
        self.in_a.overlaps(&other.in_a) || self.in_b.overlaps(&other.in_b)
    }
}
