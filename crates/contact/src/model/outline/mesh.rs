//! Cuts any simple ring into convex pieces by triangulation: ears are cut off, diagonals are flipped for better shapes,
//! and triangles are merged.

use alloc::collections::BinaryHeap;
use alloc::vec;
use alloc::vec::Vec;
use core::cmp::Reverse;

use super::exact::turn;
use super::tidy::is_reflex;
use crate::maths::number::{greater, lesser};
use crate::maths::vec2::Vec2;

/// Cuts a simple ring of vertices in the positive sense of turning into convex pieces. The ring and the pieces are
/// lists of indices into `vertices`. A corner within `rounding_m` of a straight line counts as straight.
pub(super) fn convex_pieces(vertices: &[Vec2], ring: &[usize], rounding_m: f64) -> Vec<Vec<usize>> {
    let corners: Vec<Vec2> = ring.iter().map(|&i| vertices[i]).collect();
    let mut mesh = Mesh::new(&corners, &ears(&corners));
    mesh.improve_shapes();
    mesh.merge_faces(rounding_m);
    mesh.faces()
        .into_iter()
        .map(|face| face.into_iter().map(|corner| ring[corner]).collect())
        .collect()
}

/// Cuts a ring into triangles, the best-shaped ear first.
///
/// All signs are computed exactly, and a point on the border of a triangle counts as inside. So, by the two-ears
/// theorem, the ring always has an ear. Cutting off an ear changes only the two neighbours of the ear's tip.
fn ears(points: &[Vec2]) -> Vec<[usize; 3]> {
    let count = points.len();
    let mut next: Vec<usize> = (0..count).map(|i| (i + 1) % count).collect();
    let mut previous: Vec<usize> = (0..count).map(|i| (i + count - 1) % count).collect();
    // Corners that are not strictly convex. Only these can block an ear, and cuts add no such corner.
    let mut blunt: Vec<usize> = (0..count)
        .filter(|&i| turn(points[previous[i]], points[i], points[next[i]]) <= 0.0)
        .collect();
    let ear_at = |tip: usize, previous: &[usize], next: &[usize], blunt: &[usize]| {
        let corners = [previous[tip], tip, next[tip]];
        is_ear(points, corners, blunt).then(|| {
            let quality = shape_quality(corners.map(|i| points[i]));
            (quality.to_bits(), Reverse(tip), corners)
        })
    };
    let mut candidates: BinaryHeap<_> =
        (0..count).filter_map(|tip| ear_at(tip, &previous, &next, &blunt)).collect();
    let mut triangles = Vec::with_capacity(count - 2);
    let mut alive = vec![true; count];
    while triangles.len() < count - 2 {
        let (_, _, corners) = candidates.pop().expect("a simple polygon has an ear");
        let [before, tip, after] = corners;
        let stale = !alive[tip] || previous[tip] != before || next[tip] != after;
        if stale {
            continue;
        }
        triangles.push(corners);
        alive[tip] = false;
        next[before] = after;
        previous[after] = before;
        for changed in [before, after] {
            if let Ok(place) = blunt.binary_search(&changed)
                && turn(points[previous[changed]], points[changed], points[next[changed]]) > 0.0
            {
                blunt.remove(place);
            }
        }
        for changed in [before, after] {
            candidates.extend(ear_at(changed, &previous, &next, &blunt));
        }
    }
    triangles
}

/// Returns true if the tip is strictly convex and no blunt corner lies in the closed triangle.
fn is_ear(points: &[Vec2], corners: [usize; 3], blunt: &[usize]) -> bool {
    let [a, b, c] = corners.map(|i| points[i]);
    if turn(a, b, c) <= 0.0 {
        return false;
    }
    let (low_x, high_x) = (lesser(lesser(a.x, b.x), c.x), greater(greater(a.x, b.x), c.x));
    let (low_y, high_y) = (lesser(lesser(a.y, b.y), c.y), greater(greater(a.y, b.y), c.y));
    !blunt.iter().any(|&i| {
        let p = points[i];
        p.x >= low_x
            && p.x <= high_x
            && p.y >= low_y
            && p.y <= high_y
            && !corners.contains(&i)
            && turn(a, b, p) >= 0.0
            && turn(b, c, p) >= 0.0
            && turn(c, a, p) >= 0.0
    })
}

/// Quality of a triangle's shape, its doubled area over the square of its longest side: 0 for a needle, 0.87 for equal
/// sides.
fn shape_quality([a, b, c]: [Vec2; 3]) -> f64 {
    let longest_squared = greater(
        greater((b - a).length_squared(), (c - b).length_squared()),
        (a - c).length_squared(),
    );
    greater((b - a).cross(c - a) / longest_squared, 0.0)
}

/// A mesh of faces, each of which is a ring of half-edges. A half-edge on the outer border has no twin.
struct Mesh<'a> {
    points: &'a [Vec2],
    /// For each half-edge, the point from which it starts.
    origin: Vec<usize>,
    next: Vec<usize>,
    previous: Vec<usize>,
    twin: Vec<Option<usize>>,
    /// False for the half-edges of a removed diagonal.
    alive: Vec<bool>,
}

impl<'a> Mesh<'a> {
    fn new(points: &'a [Vec2], triangles: &[[usize; 3]]) -> Mesh<'a> {
        let count = 3 * triangles.len();
        let origin: Vec<usize> = triangles.iter().flatten().copied().collect();
        let next: Vec<usize> = (0..count).map(|h| h - h % 3 + (h + 1) % 3).collect();
        let previous: Vec<usize> = (0..count).map(|h| h - h % 3 + (h + 2) % 3).collect();
        let mut by_ends: Vec<(usize, usize, usize)> = (0..count)
            .map(|h| {
                let (a, b) = (origin[h], origin[next[h]]);
                (a.min(b), a.max(b), h)
            })
            .collect();
        by_ends.sort_unstable();
        let mut twin = vec![None; count];
        for pair in by_ends.windows(2) {
            let [(a, b, h), (c, d, g)] = [pair[0], pair[1]];
            if (a, b) == (c, d) {
                twin[h] = Some(g);
                twin[g] = Some(h);
            }
        }
        Mesh { points, origin, next, previous, twin, alive: vec![true; count] }
    }

    fn point(&self, half_edge: usize) -> Vec2 {
        self.points[self.origin[half_edge]]
    }

    /// Flips diagonals until the triangulation is the constrained Delaunay triangulation (Lawson 1977), which makes the
    /// smallest angles as large as possible. Only the shapes of pieces depend on the flips, so angles need not be
    /// exact, and the number of flips may be limited.
    fn improve_shapes(&mut self) {
        let mut queue: Vec<usize> = (0..self.origin.len()).rev().collect();
        let mut flips_left = 50 * self.origin.len();
        while let Some(h) = queue.pop() {
            let Some(g) = self.twin[h] else { continue };
            if flips_left > 0 && self.flip_helps(h, g) {
                flips_left -= 1;
                self.flip(h, g);
                queue.extend([self.next[h], self.previous[h], self.next[g], self.previous[g]]);
            }
        }
    }

    /// Returns true if a flip of the diagonal makes better triangles. A flip makes better triangles if the angles
    /// opposite the diagonal sum to more than π and the other diagonal is inside the two triangles.
    fn flip_helps(&self, h: usize, g: usize) -> bool {
        let (a, b) = (self.point(h), self.point(g));
        let (c, d) = (self.point(self.previous[h]), self.point(self.previous[g]));
        let (ca, cb, da, db) = (a - c, b - c, a - d, b - d);
        let sine_of_sum = ca.cross(cb) * da.dot(db) + ca.dot(cb) * db.cross(da);
        let scale = libm::sqrt(
            ca.length_squared() * cb.length_squared() * da.length_squared() * db.length_squared(),
        );
        sine_of_sum < -1.0e-12 * scale && turn(d, b, c) > 0.0 && turn(c, a, d) > 0.0
    }

    /// Replaces the diagonal between two triangles by the other diagonal of their four corners.
    fn flip(&mut self, h: usize, g: usize) {
        let (h1, h2) = (self.next[h], self.previous[h]);
        let (g1, g2) = (self.next[g], self.previous[g]);
        let (c, d) = (self.origin[h2], self.origin[g2]);
        self.origin[h] = d;
        self.origin[g] = c;
        for ring in [[h, h2, g1], [g, g2, h1]] {
            for i in 0..3 {
                self.next[ring[i]] = ring[(i + 1) % 3];
                self.previous[ring[(i + 1) % 3]] = ring[i];
            }
        }
    }

    /// Removes every diagonal that no convex piece needs, the longest first.
    fn merge_faces(&mut self, rounding_m: f64) {
        let mut diagonals: Vec<(f64, usize, usize)> = (0..self.origin.len())
            .filter_map(|h| {
                let g = self.twin[h].filter(|g| h < *g)?;
                Some(((self.point(g) - self.point(h)).length_squared(), h, g))
            })
            .collect();
        diagonals.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        for (_, h, g) in diagonals {
            let needed = |h, g| is_reflex(self.corner_without(h, g), rounding_m);
            if !needed(h, g) && !needed(g, h) {
                for (x, y) in [(h, g), (g, h)] {
                    let (before, after) = (self.previous[x], self.next[y]);
                    self.next[before] = after;
                    self.previous[after] = before;
                    self.alive[x] = false;
                }
            }
        }
    }

    /// The corner at the start of half-edge `h`, with the neighbours that it would have without the diagonal of the
    /// half-edges `h` and `g`.
    fn corner_without(&self, h: usize, g: usize) -> [Vec2; 3] {
        [self.point(self.previous[h]), self.point(h), self.point(self.next[self.next[g]])]
    }

    fn faces(&self) -> Vec<Vec<usize>> {
        let mut seen = vec![false; self.origin.len()];
        let mut faces = Vec::new();
        for start in 0..self.origin.len() {
            if seen[start] || !self.alive[start] {
                continue;
            }
            let mut face = Vec::new();
            let mut h = start;
            while !seen[h] {
                seen[h] = true;
                face.push(self.origin[h]);
                h = self.next[h];
            }
            faces.push(face);
        }
        faces
    }
}
