//! Errors of an outline, and notices of what was corrected in an outline.

use alloc::vec::Vec;
use core::error::Error;
use core::fmt;

/// An edge of the outline as the user gave it, by the numbers of its end points, counted from 0. If vertices between
/// the two end points were merged, the edge stands for a run of several given edges on one line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct OutlineEdge {
    /// Number of the vertex at which the edge begins.
    pub from: usize,
    /// Number of the vertex at which the edge ends.
    pub to: usize,
}

/// The reason why a list of vertices is not an outline. Vertices are numbered from 0 in the order in which they were
/// given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum OutlineError {
    /// More than [`MAX_VERTICES`](super::MAX_VERTICES).
    TooManyVertices {
        /// How many were given.
        count: usize,
    },
    /// A coordinate of a vertex is infinite or not a number.
    NonFinite {
        /// Number of the vertex.
        vertex: usize,
    },
    /// A coordinate of a vertex is beyond [`MAX_COORDINATE_M`](super::MAX_COORDINATE_M).
    TooFar {
        /// Number of the vertex.
        vertex: usize,
        /// The coordinate of this vertex with the larger absolute value (m).
        coordinate_m: f64,
    },
    /// The outline has fewer than three vertices in different places.
    TooFewVertices {
        /// How many were given.
        count: usize,
        /// How many of the given vertices are in different places.
        distinct: usize,
    },
    /// All vertices are on one line, or the area of the outline is negligible beside its extent.
    ZeroArea,
    /// Two edges of the outline cross, touch or lie on each other.
    SelfIntersection {
        /// The two edges.
        edges: [OutlineEdge; 2],
    },
}

impl fmt::Display for OutlineEdge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}–{}", self.from, self.to)
    }
}

impl fmt::Display for OutlineError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OutlineError::TooManyVertices { count } => {
                write!(
                    f,
                    "the outline has {count} vertices; at most {} are allowed",
                    super::MAX_VERTICES
                )
            }
            OutlineError::NonFinite { vertex } => write!(
                f,
                "vertex {vertex} of the outline (counted from 0) is infinite or not a number"
            ),
            OutlineError::TooFar { vertex, coordinate_m } => write!(
                f,
                "vertex {vertex} of the outline (counted from 0) has the coordinate \
                 {coordinate_m:e} m; at most {:e} m is allowed. An outline is given in the \
                 body's own frame, from its centre of gravity",
                super::MAX_COORDINATE_M
            ),
            OutlineError::TooFewVertices { count, distinct } if count == distinct => {
                write!(f, "the outline has {count} vertices; it needs at least 3")
            }
            OutlineError::TooFewVertices { count, distinct } => write!(
                f,
                "of the {count} vertices of the outline only {distinct} are in different places; \
                 it needs at least 3"
            ),
            OutlineError::ZeroArea => {
                f.write_str("the outline encloses no area: its vertices are on one line")
            }
            OutlineError::SelfIntersection { edges: [a, b] } => match shared_vertex(*a, *b) {
                Some(vertex) => write!(
                    f,
                    "the outline doubles back on itself at vertex {vertex} (counted from 0): \
                     edges {a} and {b} lie on each other"
                ),
                None => write!(
                    f,
                    "the outline crosses or touches itself: edges {a} and {b} (vertices counted \
                     from 0) meet"
                ),
            },
        }
    }
}

fn shared_vertex(a: OutlineEdge, b: OutlineEdge) -> Option<usize> {
    if a.to == b.from {
        Some(a.to)
    } else if b.to == a.from {
        Some(b.to)
    } else {
        None
    }
}

impl Error for OutlineError {}

/// A correction that was made to an outline. Vertices are numbered from 0 in the order in which they were given.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum OutlineNotice {
    /// Vertices were dropped because they lie within [`MERGE_DISTANCE_M`](super::MERGE_DISTANCE_M) of the vertex before
    /// them, or, at the end of the list, of the first vertex.
    DuplicatesMerged {
        /// Numbers of the dropped vertices, in ascending order.
        vertices: Vec<usize>,
    },
    /// Vertices were dropped because they lie on the straight line between their neighbours.
    CollinearMerged {
        /// Numbers of the dropped vertices, ascending.
        vertices: Vec<usize>,
    },
    /// The outline was given in the negative sense (anticlockwise on a chart) and was reversed.
    Turned,
}

impl fmt::Display for OutlineNotice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            OutlineNotice::DuplicatesMerged { vertices } => {
                f.write_str("dropped because they repeat another vertex: ")?;
                list(f, vertices)
            }
            OutlineNotice::CollinearMerged { vertices } => {
                f.write_str("dropped because they lie on the line between their neighbours: ")?;
                list(f, vertices)
            }
            OutlineNotice::Turned => f.write_str(
                "the outline was given in the negative sense (from starboard to forward) and was \
                 reversed",
            ),
        }
    }
}

/// Writes the numbers of at most ten of these vertices.
fn list(f: &mut fmt::Formatter<'_>, vertices: &[usize]) -> fmt::Result {
    const SHOWN: usize = 10;
    f.write_str(if vertices.len() == 1 { "vertex " } else { "vertices " })?;
    for (i, vertex) in vertices.iter().take(SHOWN).enumerate() {
        write!(f, "{}{vertex}", if i == 0 { "" } else { ", " })?;
    }
    if vertices.len() > SHOWN {
        write!(f, " and {} more", vertices.len() - SHOWN)?;
    }
    f.write_str(" (counted from 0)")
}
