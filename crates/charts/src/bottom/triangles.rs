//! Interpolates depths between points of known depth, by triangulation.

use delaunator::{Point, triangulate};
use fenderline_contact::Vec2;

use super::lattice::{Extent, Lattice};

/// A point on the bottom whose depth is known, such as a sounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sounded {
    pub(super) at_m: Vec2,
    /// Depth below datum (m).
    pub(super) depth_m: f64,
}

/// A triangulation: triangles whose corners are points of known depth.
pub(super) struct Triangles {
    points: Vec<Sounded>,
    corners: Vec<[usize; 3]>,
}

impl Triangles {
    /// Makes the Delaunay triangulation of points. If two points lie at one place, the shallower point counts. If all
    /// points lie on one line, there are no triangles.
    pub(super) fn of(mut points: Vec<Sounded>) -> Triangles {
        points.sort_by(|a, b| {
            let by_place = a.at_m.x.total_cmp(&b.at_m.x).then(a.at_m.y.total_cmp(&b.at_m.y));
            by_place.then(a.depth_m.total_cmp(&b.depth_m))
        });
        points.dedup_by(|b, a| a.at_m == b.at_m);
        let corners: Vec<Point> =
            points.iter().map(|point| Point { x: point.at_m.x, y: point.at_m.y }).collect();
        let triangles = triangulate(&corners).triangles;
        let corners = triangles.chunks_exact(3).map(|of| [of[0], of[1], of[2]]).collect();
        Triangles { points, corners }
    }

    /// The longest side of each triangle (m), in the order of the triangles.
    pub(super) fn longest_sides_m(&self) -> Vec<f64> {
        let longest = |corners: &[usize; 3]| {
            let [a, b, c] = corners.map(|corner| self.points[corner].at_m);
            let sides = [(b - a).length(), (c - b).length(), (a - c).length()];
            sides.into_iter().fold(0.0, libm::fmax)
        };
        self.corners.iter().map(longest).collect()
    }

    /// The depth at each node of a grid, interpolated linearly in each triangle; NaN outside the triangles, and in
    /// triangles with a side longer than `longest_m`.
    pub(super) fn depths_m(&self, lattice: &Lattice, longest_m: f64) -> Vec<f64> {
        let mut depths_m = vec![f64::NAN; lattice.nodes()];
        for (corners, longest) in self.corners.iter().zip(self.longest_sides_m()) {
            if longest <= longest_m {
                let corners = corners.map(|corner| self.points[corner]);
                fill(lattice, &corners, &mut depths_m);
            }
        }
        depths_m
    }
}

/// A node that is this far outside a triangle, as a share of the triangle's size, still counts as inside.
const ON_EDGE: f64 = 1e-9;

fn fill(lattice: &Lattice, [a, b, c]: &[Sounded; 3], depths_m: &mut [f64]) {
    let (ab, ac) = (b.at_m - a.at_m, c.at_m - a.at_m);
    let doubled_area = ab.cross(ac);
    if doubled_area == 0.0 {
        return;
    }
    let extent = Extent::around([a, b, c].into_iter().map(|point| point.at_m));
    let slack_m = 1e-6;
    for row in lattice.rows_within(extent.low.y - slack_m, extent.high.y + slack_m) {
        for column in lattice.columns_within(extent.low.x - slack_m, extent.high.x + slack_m) {
            let node = lattice.index(column, row);
            // For a node on the common edge of two triangles, the first triangle counts.
            if !depths_m[node].is_nan() {
                continue;
            }
            let off = lattice.place_m(column, row) - a.at_m;
            let (of_b, of_c) = (off.cross(ac) / doubled_area, ab.cross(off) / doubled_area);
            let of_a = 1.0 - of_b - of_c;
            if [of_a, of_b, of_c].iter().all(|share| *share >= -ON_EDGE) {
                depths_m[node] =
                    a.depth_m + of_b * (b.depth_m - a.depth_m) + of_c * (c.depth_m - a.depth_m);
            }
        }
    }
}

/// The corners of a line with further points between them, so that neighbouring points are at most `spacing_m` apart.
pub(super) fn spaced(line: &[Vec2], spacing_m: f64) -> impl Iterator<Item = Vec2> {
    let between = move |pair: &[Vec2]| {
        let (from_m, along) = (pair[0], pair[1] - pair[0]);
        let parts = libm::fmax(libm::ceil(along.length() / spacing_m), 1.0) as usize;
        (0..parts).map(move |part| from_m + along * (part as f64 / parts as f64))
    };
    let last = line.last().copied();
    line.windows(2).flat_map(between).collect::<Vec<_>>().into_iter().chain(last)
}

#[cfg(test)]
mod tests {
    use fenderline_contact::vec2;

    use super::*;

    #[test]
    fn a_plane_is_a_plane() {
        let plane = |at: Vec2| 5.0 + 0.1 * at.x - 0.02 * at.y;
        let places =
            [(0.0, 0.0), (100.0, 3.0), (97.0, 90.0), (2.0, 100.0), (40.0, 45.0), (40.0, 45.0)];
        let points = places.map(|(x, y)| Sounded { at_m: vec2(x, y), depth_m: plane(vec2(x, y)) });
        let lattice = Lattice { origin_m: vec2(-5.0, -5.0), cell_m: 5.0, columns: 23, rows: 23 };
        let triangles = Triangles::of(points.to_vec());
        let depths_m = triangles.depths_m(&lattice, f64::INFINITY);
        let mut known = 0;
        for row in 0..lattice.rows {
            for column in 0..lattice.columns {
                let depth_m = depths_m[lattice.index(column, row)];
                if !depth_m.is_nan() {
                    known += 1;
                    assert!((depth_m - plane(lattice.place_m(column, row))).abs() < 1e-12);
                }
            }
        }
        assert!(known > 300, "{known}");
        assert!(triangles.depths_m(&lattice, 1.0).iter().all(|depth_m| depth_m.is_nan()));
    }

    #[test]
    fn points_on_a_line_make_no_triangle() {
        let points = (0..5).map(|i| Sounded { at_m: vec2(f64::from(i), 0.0), depth_m: 1.0 });
        assert!(Triangles::of(points.collect()).corners.is_empty());
        assert!(Triangles::of(Vec::new()).corners.is_empty());
    }
}
