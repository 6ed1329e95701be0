//! The overlap of two convex polygons in rational arithmetic. Only the final result is rounded.
//!
//! An oracle for the clip. Coordinates are exact numbers. The polygons are clipped against each other half-plane by
//! half-plane (Sutherland & Hodgman 1974). Only results are rounded, once, to the nearest number.

#![allow(dead_code, reason = "each test binary that includes this file uses its own part of it")]

use fenderline_contact::{Vec2, vec2};
use num_rational::BigRational;

/// The overlap of two polygons.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ExactOverlap {
    /// S (m²), correctly rounded; 0 if the polygons at most touch.
    pub(crate) area_m2: f64,
    /// ∫x dS and ∫y dS about the frame's origin (m³), correctly rounded.
    pub(crate) first_moments_m3: Vec2,
    /// C (m), correctly rounded; `None` if the area is 0.
    pub(crate) centroid_m: Option<Vec2>,
    /// The sum of the overlap's edges on a's boundary inside b, in the positive sense (m). It is d = Σ (P_out − P_in)
    /// if no edges coincide. Turned by −90° it is ∂S/∂x of a.
    pub(crate) boundary_of_a_m: Vec2,
    /// The sum of the overlap's edges on b's boundary inside a (m). The three sums of edges add up to zero.
    pub(crate) boundary_of_b_m: Vec2,
    /// The sum of the edges where the two boundaries coincide in the same sense (m). There ∂S/∂x has two one-sided
    /// values: d with this sum and d without it.
    pub(crate) shared_boundary_m: Vec2,
    /// Corners of the overlap in the positive sense, each coordinate correctly rounded (m). Empty
    /// where the area is 0.
    pub(crate) vertices_m: Vec<Vec2>,
}

/// The overlap of two convex polygons, both in the positive sense and in one frame.
///
/// # Panics
///
/// A coordinate is not finite.
pub(crate) fn exact_overlap(a: &[Vec2], b: &[Vec2]) -> ExactOverlap {
    let (a, b): (Vec<Point>, Vec<Point>) =
        (a.iter().map(Point::exactly).collect(), b.iter().map(Point::exactly).collect());
    let mut overlap = a.clone();
    for (from, to) in sides(&b) {
        overlap = inside_of(&overlap, from, to);
    }
    overlap.dedup();
    while overlap.len() > 1 && overlap.first() == overlap.last() {
        overlap.pop();
    }
    measured(&overlap, &a, &b)
}

/// A point or vector without rounding.
#[derive(Clone, Debug, PartialEq)]
struct Point {
    x: BigRational,
    y: BigRational,
}

impl Point {
    fn exactly(v: &Vec2) -> Point {
        let exact = |value| BigRational::from_float(value).expect("a finite coordinate");
        Point { x: exact(v.x), y: exact(v.y) }
    }

    fn origin() -> Point {
        Point { x: whole(0), y: whole(0) }
    }

    fn plus(&self, other: &Point) -> Point {
        Point { x: &self.x + &other.x, y: &self.y + &other.y }
    }

    fn minus(&self, other: &Point) -> Point {
        Point { x: &self.x - &other.x, y: &self.y - &other.y }
    }

    fn times(&self, factor: &BigRational) -> Point {
        Point { x: &self.x * factor, y: &self.y * factor }
    }

    fn cross(&self, other: &Point) -> BigRational {
        &self.x * &other.y - &self.y * &other.x
    }

    fn rounded(&self) -> Vec2 {
        vec2(nearest(&self.x), nearest(&self.y))
    }
}

fn whole(value: i32) -> BigRational {
    BigRational::from_integer(value.into())
}

fn sides(ring: &[Point]) -> impl Iterator<Item = (&Point, &Point)> {
    ring.iter().zip(ring.iter().cycle().skip(1))
}

/// The part of a convex ring on the positive side of a line, the line itself included.
fn inside_of(ring: &[Point], from: &Point, to: &Point) -> Vec<Point> {
    let direction = to.minus(from);
    let side = |p: &Point| direction.cross(&p.minus(from));
    let zero = whole(0);
    let mut kept = Vec::new();
    for (p, q) in sides(ring) {
        let (p_side, q_side) = (side(p), side(q));
        if p_side >= zero {
            kept.push(p.clone());
        }
        if (p_side > zero && q_side < zero) || (p_side < zero && q_side > zero) {
            let share = &p_side / (&p_side - &q_side);
            kept.push(p.plus(&q.minus(p).times(&share)));
        }
    }
    kept
}

fn measured(overlap: &[Point], a: &[Point], b: &[Point]) -> ExactOverlap {
    let mut doubled_area = whole(0);
    let mut moments = Point::origin();
    let [mut of_a, mut of_b, mut shared] = [(); 3].map(|()| Point::origin());
    for (p, q) in sides(overlap) {
        let cross = p.cross(q);
        moments = moments.plus(&p.plus(q).times(&cross));
        doubled_area += cross;
        let sum = match (runs_along(p, q, a), runs_along(p, q, b)) {
            (true, true) => &mut shared,
            (true, false) => &mut of_a,
            (false, true) => &mut of_b,
            (false, false) => unreachable!("an edge of the overlap is on one of the boundaries"),
        };
        *sum = sum.plus(&q.minus(p));
    }
    let has_area = doubled_area > whole(0);
    let moments = moments.times(&(whole(1) / whole(6)));
    let area = doubled_area / whole(2);
    if !has_area {
        let zero = Vec2::ZERO;
        return ExactOverlap {
            area_m2: 0.0,
            first_moments_m3: zero,
            centroid_m: None,
            boundary_of_a_m: zero,
            boundary_of_b_m: zero,
            shared_boundary_m: zero,
            vertices_m: Vec::new(),
        };
    }
    ExactOverlap {
        area_m2: nearest(&area),
        first_moments_m3: moments.rounded(),
        centroid_m: Some(moments.times(&(whole(1) / area)).rounded()),
        boundary_of_a_m: of_a.rounded(),
        boundary_of_b_m: of_b.rounded(),
        shared_boundary_m: shared.rounded(),
        vertices_m: overlap.iter().map(Point::rounded).collect(),
    }
}

/// True if the edge p, q of the overlap lies on a side of the ring. Both polygons are convex and on the same side of
/// that side's line. An edge on the line is therefore on the side.
fn runs_along(p: &Point, q: &Point, ring: &[Point]) -> bool {
    let zero = whole(0);
    sides(ring).any(|(from, to)| {
        let direction = to.minus(from);
        from != to
            && direction.cross(&p.minus(from)) == zero
            && direction.cross(&q.minus(from)) == zero
    })
}

/// The nearest f64, with ties to even, for a number whose size is between 1e-290 and 1e290, or 0.
pub(crate) fn nearest(value: &BigRational) -> f64 {
    let zero = whole(0);
    if *value == zero {
        return 0.0;
    }
    if *value < zero {
        return -nearest(&-value);
    }
    // The quotient has 66 or 67 bits. A remainder counts as one more bit.
    let (numerator, denominator) = (value.numer(), value.denom());
    let shift = 66 + denominator.bits() as i64 - numerator.bits() as i64;
    let (numerator, denominator) = if shift >= 0 {
        (numerator << shift as u64, denominator.clone())
    } else {
        (numerator.clone(), denominator << shift.unsigned_abs())
    };
    let quotient = &numerator / &denominator;
    let is_exact = &quotient * &denominator == numerator;
    let (_, digits) = quotient.to_u64_digits();
    let bits = digits.iter().rev().fold(0u128, |sum, digit| (sum << 64) | u128::from(*digit));
    let bits = bits | u128::from(!is_exact);
    let exponent = i32::try_from(-shift).expect("a size that f64 has");
    libm::ldexp(bits as f64, exponent)
}

mod tests {
    use super::{BigRational, ExactOverlap, exact_overlap, nearest, whole};
    use fenderline_contact::{Vec2, vec2};

    fn square(x: f64, y: f64, side: f64) -> [Vec2; 4] {
        [vec2(x, y), vec2(x + side, y), vec2(x + side, y + side), vec2(x, y + side)]
    }

    #[test]
    fn corner_in_corner() {
        let overlap = exact_overlap(&square(0.0, 0.0, 2.0), &square(1.0, 1.5, 2.0));
        assert_eq!(
            overlap,
            ExactOverlap {
                area_m2: 0.5,
                first_moments_m3: vec2(0.75, 0.875),
                centroid_m: Some(vec2(1.5, 1.75)),
                boundary_of_a_m: vec2(-1.0, 0.5),
                boundary_of_b_m: vec2(1.0, -0.5),
                shared_boundary_m: Vec2::ZERO,
                vertices_m: overlap.vertices_m.clone(),
            }
        );
        assert_eq!(overlap.vertices_m.len(), 4);
    }

    #[test]
    fn coincident_edges_are_shared() {
        let overlap = exact_overlap(&square(0.0, 0.0, 2.0), &square(1.0, 0.0, 2.0));
        assert_eq!(overlap.area_m2, 2.0);
        assert_eq!(overlap.boundary_of_a_m, vec2(0.0, 2.0));
        assert_eq!(overlap.boundary_of_b_m, vec2(0.0, -2.0));
        assert_eq!(overlap.shared_boundary_m, Vec2::ZERO); // one forward below, one back above
        let itself = exact_overlap(&square(0.0, 0.0, 2.0), &square(0.0, 0.0, 2.0));
        assert_eq!((itself.area_m2, itself.boundary_of_a_m), (4.0, Vec2::ZERO));
    }

    #[test]
    fn touching_apart_and_within() {
        let big = square(0.0, 0.0, 8.0);
        for (x, y) in [(8.0, 0.0), (8.0, 8.0), (9.0, 0.0), (-1.0, 3.0)] {
            let overlap = exact_overlap(&big, &square(x, y, 1.0));
            assert_eq!((overlap.area_m2, overlap.centroid_m), (0.0, None));
        }
        let overlap = exact_overlap(&big, &square(2.0, 3.0, 2.0));
        assert_eq!((overlap.area_m2, overlap.centroid_m), (4.0, Some(vec2(3.0, 4.0))));
        assert_eq!(overlap.boundary_of_b_m, Vec2::ZERO);
    }

    #[test]
    fn boundary_vector_is_the_gradient_of_the_area() {
        let kite = [vec2(-3.0, 0.0), vec2(0.0, -1.0), vec2(2.5, 0.0), vec2(0.0, 1.5)];
        let moved = |by: Vec2| kite.map(|v| v + by);
        let wall = [vec2(1.0, -4.0), vec2(6.0, -4.0), vec2(6.0, 0.3), vec2(0.75, 0.6)];
        let area = |by: Vec2| exact_overlap(&moved(by), &wall).area_m2;
        let gradient = exact_overlap(&kite, &wall).boundary_of_a_m.quarter_turn_back();
        let h = 1.0 / 1024.0;
        for step in [vec2(h, 0.0), vec2(0.0, h)] {
            // The area is piecewise quadratic, so the central difference is the derivative.
            let difference = (area(step) - area(-step)) / (2.0 * h);
            assert!((difference - gradient.dot(step) / h).abs() < 1e-12);
        }
    }

    #[test]
    fn a_nanometre_of_depth_is_exact_far_from_the_origin() {
        let (far, depth) = (1.0e7, 2.0_f64.powi(-28));
        let overlap = exact_overlap(&square(far, far, 2.0), &square(far + 2.0 - depth, far, 4.0));
        assert_eq!(overlap.area_m2, 2.0 * depth);
        assert_eq!(overlap.boundary_of_a_m, vec2(-depth, 2.0));
        assert_eq!(overlap.shared_boundary_m, vec2(depth, 0.0));
    }

    #[test]
    fn nearest_rounds_to_the_nearest_and_ties_to_even() {
        let third = whole(1) / whole(3);
        assert_eq!(nearest(&third), 1.0 / 3.0);
        assert_eq!(nearest(&-third), -1.0 / 3.0);
        assert_eq!(nearest(&(whole(22) / whole(7))), 22.0 / 7.0);
        let exact = |v| BigRational::from_float(v).expect("finite");
        for value in [1.5, 1e-200, -3.7e250, 0.1, 9_007_199_254_740_991.0] {
            assert_eq!(nearest(&exact(value)), value);
        }
        let half_way = exact(1.0) + exact(0.5 * f64::EPSILON);
        assert_eq!(nearest(&half_way), 1.0);
        assert_eq!(nearest(&(half_way.clone() + exact(1e-80))), 1.0 + f64::EPSILON);
        assert_eq!(nearest(&(half_way + exact(f64::EPSILON))), 1.0 + 2.0 * f64::EPSILON);
    }
}
