//! The clip of two convex polygons, compared with rational arithmetic. The oracle gets the second polygon's vertices
//! after the clip's own transform. The comparison therefore shows only the clip's rounding.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::support;

use fenderline_contact::{Clip, ConvexPolygon, PairClip, Pose, Rotation, Vec2, vec2};
use proptest::prelude::*;
use support::exact::{ExactOverlap, exact_overlap};
use support::shapes::{any_convex, beside, ellipse, hull, points, rectangle, regular};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases) }
}

/// The overlap, as computed by the clip and by the oracle.
fn both(a: &[Vec2], a_pose: Pose, b: &[Vec2], b_pose: Pose) -> (Option<Clip>, ExactOverlap) {
    let (first, second) = (ConvexPolygon::new(a), ConvexPolygon::new(b));
    let b_in_a = a_pose.to(b_pose);
    let placed: Vec<Vec2> = second.vertices().iter().map(|&v| b_in_a.apply(v)).collect();
    let found = PairClip::default().clip(&first, a_pose, &second, b_pose);
    (found, exact_overlap(first.vertices(), &placed))
}

/// Checks the area to a relative 1e-11. Checks centroid and chord to 1e-11 m, times the factor by which flat crossings
/// amplify errors.
#[track_caller]
fn check(a: &[Vec2], a_pose: Pose, b: &[Vec2], b_pose: Pose) -> ExactOverlap {
    let (found, exact) = both(a, a_pose, b, b_pose);
    let Some(found) = found else {
        assert!(exact.area_m2 <= NEGLIGIBLE_M2, "nothing found where {} m² are", exact.area_m2);
        return exact;
    };
    let error = (found.area_m2() - exact.area_m2).abs();
    let allowed = 1e-11 * exact.area_m2 + NEGLIGIBLE_M2;
    assert!(error <= allowed, "area {} not {}: {error:e}", found.area_m2(), exact.area_m2);
    if let Some(centroid) = exact.centroid_m {
        // A sliver ends where edges cross at a flat angle. The error of its centroid is its length times the rounding
        // over its mean depth.
        let (off, extent) = ((found.centroid_m() - centroid).length(), extent_m(&exact));
        let allowed = extent * (1e-12 + 1e-12 * extent / exact.area_m2);
        assert!(off <= allowed, "centroid off by {off:e} of {extent} m");
    }
    exact
}

/// Area of an overlap 300 m long and as deep as the rounding of a vertex (m²).
const NEGLIGIBLE_M2: f64 = 300.0 * 1e-13;

fn extent_m(exact: &ExactOverlap) -> f64 {
    let first = exact.vertices_m[0];
    exact.vertices_m.iter().fold(0.0, |e, &v| f64::max(e, (v - first).length()))
}

/// Smallest sine between two nearly parallel edges.
fn least_sine(a: &[Vec2], b: &[Vec2], b_in_a: Pose) -> f64 {
    let edges = |ring: &[Vec2]| -> Vec<Vec2> {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(p, q)| (*q - *p) * (1.0 / (*q - *p).length())).collect()
    };
    let of_b: Vec<Vec2> = edges(b).into_iter().map(|e| b_in_a.rotation.apply(e)).collect();
    let sines = edges(a).into_iter().flat_map(|e| of_b.iter().map(move |f| e.cross(*f).abs()));
    sines.fold(1.0, f64::min)
}

proptest! {
    #![proptest_config(config(150))]

    /// Shallow and deep overlaps, corners and edges, hulls and fenders, at a kilometre from the origin.
    #[test]
    fn random_pairs_have_the_exact_area_centroid_and_chord(
        a in any_convex(),
        b in any_convex(),
        (a_heading, b_heading) in (0.0..6.3f64, 0.0..6.3f64),
        bearing in 0.0..6.3f64,
        deepness in 0.0..1.0f64,
        share in prop_oneof![Just(0.0), -0.4..0.4f64],
        (north, east) in (690.0..710.0f64, 690.0..710.0f64),
    ) {
        let a_pose = Pose::new(vec2(north, east), a_heading);
        let depth_m = 0.01 * libm::pow(3000.0, deepness);
        let b_pose = beside(&a, a_pose, &b, b_heading, (bearing, depth_m, share));
        let exact = check(&a, a_pose, &b, b_pose);
        let sine = least_sine(&a, &b, a_pose.to(b_pose));
        if let (Some(found), true) = (both(&a, a_pose, &b, b_pose).0, sine > 1e-7) {
            let off = (found.chord_m() - exact.boundary_of_a_m).length();
            prop_assert!(off <= 1e-12 / sine, "chord off by {off:e}, sine {sine:e}");
        }
    }
}

/// Shapes on a grid, in all degenerate positions.
#[test]
fn polygons_on_a_grid_have_the_exact_area() {
    let shapes = [
        rectangle(4.0, 2.0),
        rectangle(2.0, 2.0),
        points(&[(-1.0, -1.0), (2.0, -1.0), (-1.0, 2.0)]),
        points(&[(0.0, -2.0), (1.0, 0.0), (0.0, 2.0), (-1.0, 0.0)]),
        points(&[(-2.0, -1.0), (0.0, -2.0), (2.0, -1.0), (2.0, 1.0), (0.0, 2.0), (-2.0, 1.0)]),
        points(&[(-3.0, 0.0), (-1.0, -1.0), (1.0, -1.0), (3.0, 0.0), (1.0, 1.0), (-1.0, 1.0)]),
    ];
    let still = Pose::new(Vec2::ZERO, 0.0);
    let mut touching = 0;
    for a in &shapes {
        for b in &shapes {
            for step in 0..17 * 17 {
                let at = vec2((step % 17) as f64 * 0.5 - 4.0, (step / 17) as f64 * 0.5 - 4.0);
                let (found, exact) = both(a, still, b, Pose::new(at, 0.0));
                let area = found.map_or(0.0, |c| c.area_m2());
                assert!(
                    (area - exact.area_m2).abs() <= 1e-14,
                    "{area} not {} with {a:?} and {b:?} at {at:?}",
                    exact.area_m2
                );
                assert_eq!(found.is_some(), exact.area_m2 > 0.0);
                let Some(found) = found else { continue };
                touching += 1;
                let centroid = exact.centroid_m.expect("there is an area");
                assert!((found.centroid_m() - centroid).length() <= 1e-14);
                if exact.shared_boundary_m == Vec2::ZERO && !edges_coincide(a, b, at) {
                    let chord = found.chord_m();
                    assert!(
                        (chord - exact.boundary_of_a_m).length() <= 1e-14,
                        "chord {chord:?} not {:?} with {a:?} and {b:?} at {at:?}",
                        exact.boundary_of_a_m
                    );
                }
            }
        }
    }
    assert!(touching > 3000);
}

/// True if edges with the same direction coincide. The chord then has two values.
fn edges_coincide(a: &[Vec2], b: &[Vec2], at: Vec2) -> bool {
    let sides = |ring: &[Vec2], by: Vec2| -> Vec<(Vec2, Vec2)> {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(p, q)| (*p + by, *q - *p)).collect()
    };
    let of_b = sides(b, at);
    sides(a, Vec2::ZERO).iter().any(|(p, along)| {
        of_b.iter().any(|(q, other)| {
            along.cross(*other) == 0.0 && along.dot(*other) > 0.0 && along.cross(*q - *p) == 0.0
        })
    })
}

/// Polygons with 4, 6, 8 … 48 crossings.
#[test]
fn stars_of_two_polygons_have_the_exact_area_and_chord() {
    for count in [3usize, 4, 5, 6, 8, 12, 24] {
        for (turn, x, y) in [(0.5, 0.0, 0.0), (0.4, 0.03, -0.02), (0.1, 0.001, 0.002)] {
            let star = regular(10.0, count);
            let angle = turn * core::f64::consts::TAU / count as f64;
            let (a_pose, b_pose) = (
                Pose::new(vec2(703.0, 698.0), 0.3),
                Pose::new(vec2(703.0 + x, 698.0 + y), angle + 0.3),
            );
            let exact = check(&star, a_pose, &star, b_pose);
            let found = both(&star, a_pose, &star, b_pose).0.expect("they cross");
            assert!((found.chord_m() - exact.boundary_of_a_m).length() < 1e-11);
        }
    }
    // A beam lies across another beam, or a mast across a hull.
    for (length, width, heading) in [(40.0, 0.5, 1.2), (400.0, 0.01, 0.9), (100.0, 30.0, 1.57)] {
        let (ship, beam) = (hull(298.0, 46.0, 24), rectangle(length, width));
        let a_pose = Pose::new(vec2(-650.0, 710.0), 0.4);
        let b_pose = Pose::new(vec2(-640.0, 716.0), heading);
        let exact = check(&ship, a_pose, &beam, b_pose);
        let found = both(&ship, a_pose, &beam, b_pose).0.expect("they cross");
        assert!((found.chord_m() - exact.boundary_of_a_m).length() < 1e-10);
    }
}

#[test]
fn a_contained_polygon_has_its_own_area_and_no_chord() {
    let (ship, pile) = (hull(298.0, 46.0, 24), ellipse(2.0, 1.0, 16, &[]));
    let (at, pile_at) = (Pose::new(vec2(700.0, 700.0), 0.2), Pose::new(vec2(690.0, 702.0), 0.9));
    for (a, a_pose, b, b_pose) in [(&ship, at, &pile, pile_at), (&pile, pile_at, &ship, at)] {
        check(a, a_pose, b, b_pose);
        let found = both(a, a_pose, b, b_pose).0.expect("it is inside");
        assert_eq!(found.chord_m(), Vec2::ZERO);
    }
}

#[test]
fn identical_polygons_overlap_wholly() {
    let still = Pose::new(vec2(700.0, 700.0), 0.7);
    for shape in [hull(298.0, 46.0, 64), regular(1.0, 3), rectangle(30.0, 0.2)] {
        check(&shape, still, &shape, still);
    }
}

/// Depths of a contact that has just begun. A vertex of a hull of 298 m is rounded by 3e-14 m, and the depth δ has the
/// same error. The relative error of the area is a few times 3e-14 m / δ. At positions that need no rounding the error
/// must be far smaller.
#[test]
fn corner_area_is_quadratic_and_flat_area_linear_in_the_depth() {
    let corner = points(&[(0.0, 0.0), (8.0, 8.0), (0.0, 16.0), (-8.0, 8.0)]);
    let (wall, fender) = (rectangle(64.0, 32.0), rectangle(4.0, 2.0));
    let still = Pose::new(vec2(700.0, 700.0), 0.0);
    for power in 0..31 {
        let depth_m = libm::ldexp(1.0, -power);
        // In the wall's frame, the wall's face is at y = 16.
        let (first, second) = (ConvexPolygon::new(&wall), ConvexPolygon::new(&corner));
        let mut pair = PairClip::default();
        let at = |y: f64| Pose::new(vec2(700.25, 700.0 + y), 0.0);
        let found = pair.clip(&first, still, &second, at(16.0 - depth_m)).expect("touching");
        let right = depth_m * depth_m;
        let allowed = 1e-13 / depth_m;
        assert!(
            (found.area_m2() - right).abs() <= allowed.min(1e-6) * right,
            "corner at {depth_m:e} m: {:e} not {right:e}",
            found.area_m2()
        );
        let block = ConvexPolygon::new(&fender);
        let found =
            PairClip::default().clip(&first, still, &block, at(17.0 - depth_m)).expect("touching");
        assert_eq!(found.area_m2(), 4.0 * depth_m, "flat at {depth_m:e} m");
        assert_eq!(found.chord_m(), vec2(-4.0, 0.0));
    }
    // The same at arbitrary angles, where every vertex is rounded.
    let heading = 0.7;
    let tilted = Pose::new(vec2(700.0, 700.0), heading);
    let out = tilted.rotation.apply(vec2(0.0, 1.0));
    for power in 1..10 {
        let depth_m = libm::pow(10.0, f64::from(-power));
        let place = |reach: f64| Pose::new(tilted.position_m + out * (reach - depth_m), heading);
        let area = |shape: &[Vec2], reach: f64| {
            let (first, second) = (ConvexPolygon::new(&wall), ConvexPolygon::new(shape));
            let found = PairClip::default().clip(&first, tilted, &second, place(reach));
            found.expect("touching").area_m2()
        };
        // Positions of 1 km are rounded to 1.1e-13 m, which affects the depth.
        let allowed = 1e-15 + 4e-13 / depth_m;
        let (of_corner, of_flat) = (area(&corner, 16.0), area(&fender, 17.0));
        assert!((of_corner / (depth_m * depth_m) - 1.0).abs() <= 2.0 * allowed, "{depth_m:e}");
        assert!((of_flat / (4.0 * depth_m) - 1.0).abs() <= allowed, "{depth_m:e}");
    }
}

proptest! {
    #![proptest_config(config(150))]

    /// Nearly parallel sides with equal or opposite directions, like those of a ship alongside. At every angle, the
    /// area must show the effect of the angle.
    #[test]
    fn nearly_parallel_sides_keep_their_area(
        a_count in 6usize..30,
        b_length in prop_oneof![Just(298.0), 5.0..400.0f64],
        angle_power in -16.0..-3.0f64,
        sign in prop_oneof![Just(1.0), Just(-1.0)],
        depth_power in -16.0..1.6f64,
        shift in prop_oneof![Just(0.0), -150.0..150.0f64],
        opposite in any::<bool>(),
    ) {
        let (a, b) = (hull(298.0, 46.0, a_count), rectangle(b_length, 46.0));
        let angle = sign * libm::pow(10.0, angle_power);
        let depth_m = libm::pow(10.0, depth_power);
        let a_pose = Pose::new(Vec2::ZERO, 0.0);
        let y = if opposite { 46.0 - depth_m } else { depth_m };
        let b_pose = Pose::new(vec2(shift, y), angle);
        check(&a, a_pose, &b, b_pose);
        check(&b, b_pose, &a, a_pose);
    }
}

#[test]
fn touching_or_apart_is_no_contact() {
    let wall = rectangle(64.0, 32.0);
    let still = Pose::new(vec2(700.0, 700.0), 0.0);
    for (x, y) in
        [(34.0, 0.0), (34.0, 17.0), (0.0, 17.0), (35.0, 0.0), (-34.5, -18.0), (33.0, 17.0)]
    {
        let at = Pose::new(vec2(700.0 + x, 700.0 + y), 0.0);
        let (found, _) = both(&wall, still, &rectangle(4.0, 2.0), at);
        assert!(found.is_none(), "at {x}, {y}");
    }
}

/// A position at which the clip was once wrong: offset, cosine and sine of the second polygon in the frame of the
/// first. A comparison of millions of touching pairs found these positions.
struct Place(f64, f64, f64, f64);

#[track_caller]
fn check_at(a: &[Vec2], b: &[Vec2], places: &[Place]) {
    for &Place(x, y, cos, sin) in places {
        let pose = Pose { position_m: vec2(x, y), rotation: Rotation { cos, sin } };
        check(a, Pose::new(Vec2::ZERO, 0.0), b, pose);
    }
}

/// The clip gave 6854 m² instead of 0.33 m². Rounding had put a corner behind the corner before it.
#[test]
fn nearly_parallel_sides_gave_half_a_ship() {
    let ship = rectangle(298.0, 46.0);
    let places = [
        Place(
            -0.00017292138053903727,
            -45.99887974225476,
            0.999999999971736,
            -7.518503994626937e-6,
        ),
        Place(-6.847670633773064e-10, -46.00000000443608, 1.0, -2.977235633447563e-11),
    ];
    check_at(&ship, &ship, &places);
}

/// The clip gave 13,709 m² across a gap of 4 mm.
#[test]
fn a_gap_gave_a_whole_ship() {
    let ship = rectangle(298.0, 46.0);
    let places = [Place(6.878172198582397e-12, 46.004026732655795, 1.0, -2.9846851925757016e-13)];
    check_at(&ship, &ship, &places);
    let bent = points(&[(0.0, 0.0), (10.0, 0.0), (20.0, 1e-7), (20.0, 5.0), (0.0, 5.0)]);
    let places = [Place(-8.382402892599418e-10, -5.000000124382066, 1.0, -1.6764805785198837e-10)];
    check_at(&bent, &bent, &places);
}

/// Edges coincided while the polygons lay outside each other. The clip gave a whole polygon instead of no area.
#[test]
fn touching_edges_gave_a_whole_polygon() {
    let needle = points(&[(0.0, 0.0), (30.0, 0.0), (30.0, 1e-3)]);
    let places = [
        Place(3.946255641466365e-13, 0.0, -3.3343455858814586e-5, -0.999999999444107),
        Place(30.0, 1.4050014943980637e-15, -0.0003373929245775061, -0.9999999430830055),
    ];
    check_at(&needle, &needle, &places);
    let places =
        [Place(-6.9259475351392155, -30.9831801020593, 0.5141313348612594, 0.8577114727656262)];
    check_at(&regular(10.0, 64), &needle, &places);
    let places =
        [Place(13.078140649557374, -6.4625823481138305, 0.33674981683375343, -0.9415941593183518)];
    check_at(&regular(10.0, 64), &rectangle(20.0, 0.3), &places);
}

/// The overlap is a wedge 300 m long at 1e-10 rad. At the paper's stiffness a force of 22 N was missing.
#[test]
fn sides_within_1e_9_of_parallel_had_no_contact() {
    let ship = rectangle(298.0, 46.0);
    for angle in [1e-9, -1e-9, 3e-10, 1e-11, -1e-12] {
        let (a_pose, b_pose) = (Pose::new(Vec2::ZERO, 0.0), Pose::new(vec2(0.0, 46.0), angle));
        let exact = check(&ship, a_pose, &ship, b_pose);
        assert!(exact.area_m2 > 1e-9);
        check(&ship, a_pose, &ship, Pose::new(vec2(0.0, 0.0), angle));
    }
}
