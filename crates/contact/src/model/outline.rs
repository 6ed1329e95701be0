//! The outline of a body: a simple polygon. An outline is checked, tidied and cut into convex pieces when it is made
//! from its vertices.

use crate::geometry::convex::has_width;
use crate::geometry::extent::Extent;
use crate::maths::number::greater;

mod crossing;
mod exact;
mod fault;
mod mesh;
mod pieces;
mod tidy;

#[cfg(test)]
mod shapes;
#[cfg(test)]
mod tests;

use alloc::vec::Vec;

pub use self::fault::{OutlineEdge, OutlineError, OutlineNotice};
use self::tidy::Numbered;
use crate::maths::vec2::Vec2;

/// Largest number of vertices of an outline.
pub const MAX_VERTICES: usize = 10_000;

/// Largest absolute value of a coordinate (m).
pub const MAX_COORDINATE_M: f64 = 1.0e8;

/// Vertices closer than this are merged; parts of the boundary closer than this touch (m).
pub const MERGE_DISTANCE_M: f64 = 1.0e-9;

/// The outline of a body in the body's frame: a simple polygon in the positive sense (from x to y), without repeated
/// vertices or vertices on a straight line, cut into convex pieces.
///
/// ```
/// use fenderline_contact::outline::Outline;
/// use fenderline_contact::vec2;
/// // A quay with a step in its front.
/// let corners = [(0.0, 0.0), (20.0, 0.0), (20.0, 5.0), (12.0, 5.0), (12.0, 8.0), (0.0, 8.0)];
/// let (outline, notices) = Outline::new(&corners.map(|(x, y)| vec2(x, y)))?;
/// assert!(notices.is_empty());
/// assert_eq!(outline.area_m2(), 136.0);
/// assert_eq!(outline.pieces().len(), 2);
/// # Ok::<(), fenderline_contact::outline::OutlineError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    vertices: Vec<Vec2>,
    pieces: Vec<Vec<Vec2>>,
    area_m2: f64,
    centroid_m: Vec2,
    radius_m: f64,
    half_width_m: f64,
    bounds: (Vec2, Vec2),
    /// For an outline of parts, the index after the last vertex of each ring; empty for an outline of one ring.
    ring_ends: Vec<usize>,
}

impl Outline {
    /// Checks and tidies the vertices of a polygon. The vertices may run in either direction; the last vertex is joined
    /// to the first. The notices say what was corrected. The first vertex stays first unless it was merged.
    ///
    /// # Errors
    ///
    /// The first of these faults: more than [`MAX_VERTICES`]; a vertex that is not finite; a vertex beyond
    /// [`MAX_COORDINATE_M`]; fewer than three different vertices ([`MERGE_DISTANCE_M`] apart); no area (less than 1e-12
    /// of the square of the polygon's extent); edges that cross, touch or lie on each other.
    pub fn new(vertices: &[Vec2]) -> Result<(Outline, Vec<OutlineNotice>), OutlineError> {
        check_vertices(vertices)?;
        let mut notices = Vec::new();
        let mut ring = tidy::numbered(vertices);

        let duplicates = tidy::merge_duplicates(&mut ring);
        if ring.len() < 3 {
            let (count, distinct) = (vertices.len(), ring.len());
            return Err(OutlineError::TooFewVertices { count, distinct });
        }
        if !duplicates.is_empty() {
            notices.push(OutlineNotice::DuplicatesMerged { vertices: duplicates });
        }

        if tidy::on_one_line(&ring) {
            return Err(OutlineError::ZeroArea);
        }
        let collinear = tidy::merge_collinear(&mut ring)?;
        if ring.len() < 3 {
            return Err(OutlineError::ZeroArea);
        }
        if !collinear.is_empty() {
            notices.push(OutlineNotice::CollinearMerged { vertices: collinear });
        }

        let mut tidied: Vec<Vec2> = ring.iter().map(|vertex| vertex.point).collect();
        if let Some([a, b]) = crossing::meeting_edges(&tidied) {
            let edges = [numbered_edge(&ring, a), numbered_edge(&ring, b)];
            return Err(OutlineError::SelfIntersection { edges });
        }

        let Extent { low_m, high_m } = Extent::of(&tidied);
        let doubled_area = exact::doubled_area(&tidied);
        if 0.5 * doubled_area.abs() <= 1.0e-12 * (high_m - low_m).length_squared() {
            return Err(OutlineError::ZeroArea);
        }
        if doubled_area < 0.0 {
            tidied[1..].reverse();
            notices.push(OutlineNotice::Turned);
        }
        let outline = Outline::from_tidied(tidied, 0.5 * doubled_area.abs(), (low_m, high_m));
        Ok((outline.ok_or(OutlineError::ZeroArea)?, notices))
    }

    /// `None` if no piece has a width.
    fn from_tidied(vertices: Vec<Vec2>, area_m2: f64, bounds: (Vec2, Vec2)) -> Option<Outline> {
        let mut pieces: Vec<Vec<Vec2>> = pieces::convex_pieces(&vertices)
            .into_iter()
            .map(|piece| piece.into_iter().map(|i| vertices[i]).collect())
            .collect();
        // A cut from a spike can leave a needle that nothing can touch. Without the needle the other pieces still form
        // a closed outline.
        pieces.retain(|piece| has_width(piece));
        if pieces.is_empty() {
            return None;
        }
        let centroid_m = centroid(&pieces, vertices[0]);
        let radius_m = vertices.iter().map(|v| v.length()).fold(0.0, greater);
        let half_width_m = 0.25 * area_m2 / radius_m;
        let ring_ends = Vec::new();
        Some(Outline {
            vertices,
            pieces,
            area_m2,
            centroid_m,
            radius_m,
            half_width_m,
            bounds,
            ring_ends,
        })
    }

    /// Makes one outline of several parts, such as the land of a chart: all parts belong to one body. `borders` are the
    /// rings that are the border of the whole, also around holes; `parts` are simple polygons that together fill the
    /// whole. The parts need not be the polygons within the borders: a land of many corners has far more parts than
    /// borders, so that each part has few corners. Parts may touch. Where parts overlap, contacts count both.
    ///
    /// ```
    /// use fenderline_contact::outline::Outline;
    /// use fenderline_contact::vec2;
    /// let square = |x: f64| [(x, 0.0), (x + 5.0, 0.0), (x + 5.0, 5.0), (x, 5.0)].map(|(x, y)| vec2(x, y));
    /// let parts = [Outline::new(&square(0.0))?.0, Outline::new(&square(20.0))?.0];
    /// let islands = Outline::of_parts(&[square(0.0).to_vec(), square(20.0).to_vec()], &parts)?;
    /// assert_eq!(islands.area_m2(), 50.0);
    /// assert_eq!(islands.rings().count(), 2);
    /// # Ok::<(), fenderline_contact::outline::OutlineError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`OutlineError::TooFewVertices`] if there are no parts or a border has fewer than three corners;
    /// [`OutlineError::NonFinite`] and [`OutlineError::TooFar`] for a corner of a border, counted over all borders.
    pub fn of_parts(borders: &[Vec<Vec2>], parts: &[Outline]) -> Result<Outline, OutlineError> {
        let vertices = borders.concat();
        check_places(&vertices)?;
        if let Some(short) = borders.iter().map(Vec::len).find(|count| *count < 3) {
            return Err(OutlineError::TooFewVertices { count: short, distinct: short });
        }
        if parts.is_empty() || vertices.is_empty() {
            return Err(OutlineError::TooFewVertices { count: 0, distinct: 0 });
        }
        let pieces: Vec<Vec<Vec2>> = parts.iter().flat_map(|part| part.pieces.clone()).collect();
        let area_m2: f64 = parts.iter().map(|part| part.area_m2).sum();
        let centroid_m = centroid(&pieces, vertices[0]);
        let corners = || vertices.iter().chain(parts.iter().flat_map(|part| &part.vertices));
        let radius_m = corners().map(|v| v.length()).fold(0.0, greater);
        let bounds = parts.iter().fold(Extent::of(&vertices), |all, part| {
            all.and(Extent { low_m: part.bounds.0, high_m: part.bounds.1 })
        });
        // About the mean of the parts, each of which is far from the origin.
        let reach = |part: &Outline| {
            part.vertices.iter().map(|v| (*v - part.centroid_m).length()).fold(0.0, greater)
        };
        let half_width_m = 0.25 * area_m2 / parts.iter().map(reach).sum::<f64>();
        let ring_ends = borders
            .iter()
            .scan(0, |end, ring| {
                *end += ring.len();
                Some(*end)
            })
            .collect();
        Ok(Outline {
            vertices,
            pieces,
            area_m2,
            centroid_m,
            radius_m,
            half_width_m,
            bounds: (bounds.low_m, bounds.high_m),
            ring_ends,
        })
    }

    /// True for an outline that [`Outline::of_parts`] has made. Its vertices are those of several rings, one after the
    /// other.
    #[must_use]
    #[inline]
    pub fn is_of_parts(&self) -> bool {
        !self.ring_ends.is_empty()
    }

    /// The rings of the border, each without its first corner at the end (m). An outline that is not of parts has one
    /// ring, its vertices.
    pub fn rings(&self) -> impl Iterator<Item = &[Vec2]> + Clone {
        let whole = (!self.is_of_parts()).then_some(self.vertices.as_slice());
        let starts = core::iter::once(0).chain(self.ring_ends.iter().copied());
        let rings = starts.zip(&self.ring_ends).map(|(from, to)| &self.vertices[from..*to]);
        whole.into_iter().chain(rings)
    }

    /// The edges of the border, ring by ring (m).
    pub fn edges(&self) -> impl Iterator<Item = [Vec2; 2]> + Clone + '_ {
        self.rings().flat_map(|ring| {
            let ends = ring.iter().skip(1).chain(ring.first());
            ring.iter().zip(ends).map(|(from, to)| [*from, *to])
        })
    }

    /// Simple polygons that together are the outline (m): the outline itself, or the convex pieces of an outline of
    /// parts.
    pub fn polygons(&self) -> impl Iterator<Item = &[Vec2]> + Clone {
        let whole = (!self.is_of_parts()).then_some(self.vertices.as_slice());
        let pieces = if self.is_of_parts() { self.pieces.as_slice() } else { &[] };
        whole.into_iter().chain(pieces.iter().map(Vec::as_slice))
    }

    /// About half the width (m), computed from the area: the area of a convex body is about its length times its width.
    #[must_use]
    #[inline]
    pub(crate) fn half_width_m(&self) -> f64 {
        self.half_width_m
    }

    /// The vertices in the positive sense, tidied (m). An outline of parts has the vertices of its rings, one ring after
    /// the other.
    #[must_use]
    #[inline]
    pub fn vertices(&self) -> &[Vec2] {
        &self.vertices
    }

    /// Convex pieces that together are the outline, each in the positive sense (m).
    ///
    /// All vertices of the pieces are vertices of the outline, or of its parts, bit for bit. An edge of a piece is either an edge of the
    /// outline or a seam; another piece has the same seam in the opposite direction. An angle of a piece may be
    /// straight. A convex outline has one piece, the outline itself. A needle narrower than 1e-12 of its length is left
    /// out.
    #[must_use]
    #[inline]
    pub fn pieces(&self) -> &[Vec<Vec2>] {
        &self.pieces
    }

    /// True if there is one piece. Then no angle of the outline is reflex, apart from needles that were left out.
    #[must_use]
    #[inline]
    pub fn is_convex(&self) -> bool {
        self.pieces.len() == 1
    }

    /// Area (m²).
    #[must_use]
    #[inline]
    pub fn area_m2(&self) -> f64 {
        self.area_m2
    }

    /// Centroid of the area (m).
    #[must_use]
    #[inline]
    pub fn centroid_m(&self) -> Vec2 {
        self.centroid_m
    }

    /// Largest distance of a vertex from the frame's origin (m).
    #[must_use]
    #[inline]
    pub fn radius_m(&self) -> f64 {
        self.radius_m
    }

    /// Smallest and largest coordinates: two opposite corners of the upright box (m).
    #[must_use]
    #[inline]
    pub fn bounds(&self) -> (Vec2, Vec2) {
        self.bounds
    }
}

fn check_vertices(vertices: &[Vec2]) -> Result<(), OutlineError> {
    if vertices.len() > MAX_VERTICES {
        return Err(OutlineError::TooManyVertices { count: vertices.len() });
    }
    check_places(vertices)
}

fn check_places(vertices: &[Vec2]) -> Result<(), OutlineError> {
    if let Some(vertex) = vertices.iter().position(|v| !v.is_finite()) {
        return Err(OutlineError::NonFinite { vertex });
    }
    for (vertex, v) in vertices.iter().enumerate() {
        let coordinate_m = if v.x.abs() >= v.y.abs() { v.x } else { v.y };
        if coordinate_m.abs() > MAX_COORDINATE_M {
            return Err(OutlineError::TooFar { vertex, coordinate_m });
        }
    }
    Ok(())
}

/// Edge `index` of the ring, with the user's numbers of its vertices.
fn numbered_edge(ring: &[Numbered], index: usize) -> OutlineEdge {
    OutlineEdge { from: ring[index].number, to: ring[(index + 1) % ring.len()].number }
}

/// Centroid of all the pieces. It is summed piece by piece, because the areas are positive and nothing cancels. It is
/// computed relative to a point of the outline, so that no digits are lost far from the origin.
fn centroid(pieces: &[Vec<Vec2>], base: Vec2) -> Vec2 {
    let (mut doubled_area, mut moment) = (0.0, Vec2::ZERO);
    for piece in pieces {
        let first = piece[0];
        for pair in piece[1..].windows(2) {
            let (a, b) = (pair[0] - first, pair[1] - first);
            let cross = a.cross(b);
            doubled_area += cross;
            moment += ((first - base) + (a + b) * (1.0 / 3.0)) * cross;
        }
    }
    base + moment * (1.0 / doubled_area)
}
