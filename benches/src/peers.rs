//! The peers of our clip, each by its best interface with its buffers reused: the second polygon is placed in the frame
//! of the first, as our clip does, and area and centroid come from the vertices that the peer gives.

use std::hint::black_box;

use fenderline_contact::{self as ours, Vec2};
use i_overlay::core::fill_rule::FillRule;
use i_overlay::core::overlay_rule::OverlayRule;
use i_overlay::core::solver::Solver;
use i_overlay::float::overlay::{FloatOverlay, OverlayOptions};
use i_overlay::i_shape::flat::float::FloatFlatContoursBuffer;
use parry2d_f64::math::{Pose, Rotation, Vector};
use parry2d_f64::query::gjk::{self, CsoPoint, GJKResult, VoronoiSimplex};
use parry2d_f64::shape::ConvexPolygon;
use parry2d_f64::transformation::convex_polygons_intersection_points;

/// The two polygons and their path in parry's types.
pub(crate) type ParryPath = Vec<[Pose; 2]>;

/// The poses of a path in parry's types.
pub(crate) fn parry_path(path: &[[ours::Pose; 2]]) -> ParryPath {
    let pose = |p: ours::Pose| Pose {
        rotation: Rotation { re: p.rotation.cos, im: p.rotation.sin },
        translation: Vector::new(p.position_m.x, p.position_m.y),
    };
    path.iter().map(|poses| poses.map(pose)).collect()
}

fn points(polygon: &ours::ConvexPolygon) -> Vec<Vector> {
    polygon.vertices().iter().map(|v| Vector::new(v.x, v.y)).collect()
}

/// parry2d's overlap of convex polygons.
pub(crate) struct Parry {
    first: Vec<Vector>,
    second: Vec<Vector>,
    placed: Vec<Vector>,
    overlap: Vec<Vector>,
}

impl Parry {
    pub(crate) fn new(first: &ours::ConvexPolygon, second: &ours::ConvexPolygon) -> Parry {
        Parry {
            first: points(first),
            second: points(second),
            placed: Vec::with_capacity(256),
            overlap: Vec::with_capacity(256),
        }
    }

    pub(crate) fn round(&mut self, path: &ParryPath) {
        for poses in path {
            let [one, two] = *black_box(poses);
            black_box(self.overlap(one, two));
        }
    }

    /// Area (m²) and centroid (m) of the overlap.
    #[inline]
    pub(crate) fn overlap(&mut self, one: Pose, two: Pose) -> (f64, Vec2) {
        let second_in_first = one.inv_mul(&two);
        self.placed.clear();
        self.placed.extend(self.second.iter().map(|&v| second_in_first.transform_point(v)));
        self.overlap.clear();
        convex_polygons_intersection_points(&self.first, &self.placed, &mut self.overlap);
        area_and_centroid(self.overlap.iter().map(|v| ours::vec2(v.x, v.y)))
    }
}

/// parry2d's Gilbert–Johnson–Keerthi search, which begins with the direction that its last call found.
pub(crate) struct Gjk {
    first: ConvexPolygon,
    second: ConvexPolygon,
    simplex: VoronoiSimplex,
    direction: Vector,
}

impl Gjk {
    pub(crate) fn new(first: &ours::ConvexPolygon, second: &ours::ConvexPolygon) -> Gjk {
        let shape = |polygon| {
            ConvexPolygon::from_convex_polyline_unmodified(points(polygon))
                .expect("our polygons are convex")
        };
        Gjk {
            first: shape(first),
            second: shape(second),
            simplex: VoronoiSimplex::new(),
            direction: Vector::X,
        }
    }

    /// The closest points.
    pub(crate) fn distance_round(&mut self, path: &ParryPath) {
        for poses in path {
            let [one, two] = *black_box(poses);
            black_box(self.search(one, two, f64::MAX, true));
        }
    }

    /// Finds no more than that the two polygons are apart, as our clip does.
    pub(crate) fn apart_round(&mut self, path: &ParryPath) {
        for poses in path {
            let [one, two] = *black_box(poses);
            black_box(self.search(one, two, 0.0, false));
        }
    }

    #[inline]
    fn search(&mut self, one: Pose, two: Pose, farthest_m: f64, exact: bool) -> GJKResult {
        let Gjk { first, second, simplex, direction } = self;
        let second_in_first = one.inv_mul(&two);
        simplex.reset(CsoPoint::from_shapes(&second_in_first, first, second, *direction));
        let found =
            gjk::closest_points(&second_in_first, first, second, farthest_m, exact, simplex);
        if let GJKResult::ClosestPoints(_, _, along)
        | GJKResult::NoIntersection(along)
        | GJKResult::Proximity(along) = found
        {
            *direction = along;
        }
        found
    }
}

/// The peer i_overlay, which works on an integer grid.
pub(crate) struct Overlay {
    first: Vec<[f64; 2]>,
    second: Vec<Vec2>,
    placed: Vec<[f64; 2]>,
    overlay: FloatOverlay<[f64; 2]>,
    overlap: FloatFlatContoursBuffer<[f64; 2]>,
}

impl Overlay {
    pub(crate) fn new(first_m: &[Vec2], second_m: &[Vec2]) -> Overlay {
        Overlay {
            first: first_m.iter().map(|v| [v.x, v.y]).collect(),
            second: second_m.to_vec(),
            placed: Vec::with_capacity(256),
            overlay: FloatOverlay::new_empty(OverlayOptions::default(), Solver::default(), 256),
            overlap: FloatFlatContoursBuffer::default(),
        }
    }

    pub(crate) fn round(&mut self, path: &[[ours::Pose; 2]]) {
        for poses in path {
            let [one, two] = *black_box(poses);
            black_box(self.overlap(one, two));
        }
    }

    /// Area (m²) and centroid (m) of the overlap.
    fn overlap(&mut self, one: ours::Pose, two: ours::Pose) -> (f64, Vec2) {
        let second_in_first = one.to(two);
        let place = |&v: &Vec2| {
            let placed = second_in_first.apply(v);
            [placed.x, placed.y]
        };
        self.placed.clear();
        self.placed.extend(self.second.iter().map(place));
        self.overlay.reinit_with_subj_and_clip(&self.first, &self.placed);
        self.overlay.overlay_into(OverlayRule::Intersect, FillRule::NonZero, &mut self.overlap);
        area_and_centroid(self.overlap.points.iter().map(|p| ours::vec2(p[0], p[1])))
    }
}

/// Area and centroid of a polygon, summed up about its first vertex as in our clip.
#[inline]
fn area_and_centroid(mut vertices: impl Iterator<Item = Vec2>) -> (f64, Vec2) {
    let (Some(origin), Some(second)) = (vertices.next(), vertices.next()) else {
        return (0.0, Vec2::ZERO);
    };
    let (mut twice_area, mut moment, mut from) = (0.0, Vec2::ZERO, second - origin);
    for vertex in vertices {
        let to = vertex - origin;
        let cross = from.cross(to);
        twice_area += cross;
        moment += (from + to) * cross;
        from = to;
    }
    (0.5 * twice_area, origin + moment * (1.0 / (3.0 * twice_area)))
}
