//! Tests of whole outlines.

use alloc::collections::BTreeMap;
use alloc::string::ToString;
use alloc::vec;
use alloc::vec::Vec;

use proptest::prelude::*;

use super::exact::turn;
use super::shapes::{any_shape, bulbous_bow, comb, points, rectangle, spiral, star, stepped_ship};
use super::{MAX_VERTICES, Outline, OutlineEdge, OutlineError, OutlineNotice};
use crate::maths::number::greater;
use crate::maths::vec2::{Rotation, Vec2, vec2};

fn accepted(vertices: &[Vec2]) -> Outline {
    Outline::new(vertices).expect("a good outline").0
}

fn edges(ring: &[Vec2]) -> impl Iterator<Item = (Vec2, Vec2)> + '_ {
    ring.iter().copied().zip(ring.iter().copied().skip(1).chain(ring.first().copied()))
}

fn fan_area(ring: &[Vec2]) -> f64 {
    ring[1..].windows(2).map(|p| 0.5 * (p[0] - ring[0]).cross(p[1] - ring[0])).sum()
}

fn bits(a: Vec2, b: Vec2) -> [u64; 4] {
    [a.x.to_bits(), a.y.to_bits(), b.x.to_bits(), b.y.to_bits()]
}

/// For each directed edge, the number of its occurrences less the number of occurrences of the opposite edge.
fn uncancelled<'a>(rings: impl Iterator<Item = &'a [Vec2]>) -> BTreeMap<[u64; 4], i32> {
    let mut count = BTreeMap::new();
    for (a, b) in rings.flat_map(edges) {
        *count.entry(bits(a, b)).or_insert(0) += 1;
        *count.entry(bits(b, a)).or_insert(0) -= 1;
    }
    count.retain(|_, n| *n != 0);
    count
}

/// Number of vertices that turn in the negative sense.
fn reflex_count(ring: &[Vec2]) -> usize {
    let count = ring.len();
    (0..count)
        .filter(|i| turn(ring[(i + count - 1) % count], ring[*i], ring[(i + 1) % count]) < 0.0)
        .count()
}

/// Does no vertex turn in the negative sense by more than 32 ε of the largest coordinate?
fn is_convex_to_rounding(ring: &[Vec2]) -> bool {
    let count = ring.len();
    let largest = ring.iter().map(|v| greater(v.x.abs(), v.y.abs())).fold(0.0, greater);
    (0..count).all(|i| {
        let [a, b, c] = [ring[(i + count - 1) % count], ring[i], ring[(i + 1) % count]];
        turn(a, b, c) >= -32.0 * f64::EPSILON * largest * (c - a).length()
    })
}

fn check_pieces(outline: &Outline) {
    let pieces = outline.pieces();
    let sum: f64 = pieces.iter().map(|piece| fan_area(piece)).sum();
    let error = (sum - outline.area_m2()).abs();
    assert!(error <= 1.0e-12 * outline.area_m2(), "{sum} m² of {} m²", outline.area_m2());
    for piece in pieces {
        assert!(piece.len() >= 3);
        assert!(fan_area(piece) > 0.0);
        assert!(is_convex_to_rounding(piece), "{piece:?}");
    }
    // Seams between pieces cancel. If only the outline is left, the pieces cover it exactly once.
    assert_eq!(
        uncancelled(pieces.iter().map(Vec::as_slice)),
        uncancelled(core::iter::once(outline.vertices()))
    );
    // By Euler's formula each seam adds one piece. Each directed edge occurs once.
    let mut directed: Vec<[u64; 4]> =
        pieces.iter().flat_map(|piece| edges(piece)).map(|(a, b)| bits(a, b)).collect();
    let total = directed.len();
    directed.sort_unstable();
    directed.dedup();
    assert_eq!(directed.len(), total);
    assert_eq!(total, outline.vertices().len() + 2 * (pieces.len() - 1));
    let reflex = reflex_count(outline.vertices());
    assert!(pieces.len() <= 2 * reflex + 1, "{} pieces, {reflex} reflex", pieces.len());
    assert_eq!(outline.is_convex(), reflex == 0);
}

#[test]
fn convex_outline_is_its_own_single_piece() {
    for ring in [rectangle(298.0, 46.0), star(&[50.0; 9], vec2(1.0, 2.0))] {
        let (outline, notices) = Outline::new(&ring).expect("convex");
        assert!(notices.is_empty());
        assert!(outline.is_convex());
        assert_eq!(outline.vertices(), ring);
        assert_eq!(outline.pieces(), [ring]);
    }
}

#[test]
fn measures_of_a_rectangle_off_its_origin() {
    let ring: Vec<Vec2> = rectangle(40.0, 12.0).iter().map(|v| *v + vec2(5.0, 1.0)).collect();
    let outline = accepted(&ring);
    assert_eq!(outline.area_m2(), 480.0);
    assert_eq!(outline.bounds(), (vec2(-15.0, -5.0), vec2(25.0, 7.0)));
    assert!((outline.centroid_m() - vec2(5.0, 1.0)).length() < 1e-14);
    assert_eq!(outline.radius_m(), vec2(25.0, 7.0).length());
}

#[test]
fn area_and_centroid_hold_far_from_the_origin() {
    let far = vec2(-9.0e7, 4.0e7);
    let ring: Vec<Vec2> = stepped_ship().iter().map(|v| *v + far).collect();
    let (near, far_off) = (accepted(&stepped_ship()), accepted(&ring));
    assert!((near.area_m2() - far_off.area_m2()).abs() <= 1e-9 * near.area_m2());
    assert!((near.centroid_m() + far - far_off.centroid_m()).length() < 1e-7);
    check_pieces(&far_off);
}

#[test]
fn common_shapes_have_the_fewest_pieces_at_any_angle() {
    let l_shape = points(&[(0., 0.), (20., 0.), (20., 5.), (12., 5.), (12., 8.), (0., 8.)]);
    let t_shape = points(&[
        (0., 0.),
        (30., 0.),
        (30., 4.),
        (17., 4.),
        (17., 20.),
        (13., 20.),
        (13., 4.),
        (0., 4.),
    ]);
    let cross = points(&[
        (2., 0.),
        (4., 0.),
        (4., 2.),
        (6., 2.),
        (6., 4.),
        (4., 4.),
        (4., 6.),
        (2., 6.),
        (2., 4.),
        (0., 4.),
        (0., 2.),
        (2., 2.),
    ]);
    for (name, ring, expected) in [
        ("L", l_shape, 2),
        ("T", t_shape, 2),
        ("cross", cross, 3),
        ("bulbous bow", bulbous_bow(), 2),
        ("stepped ship", stepped_ship(), 3),
        ("comb", comb(6, 4.0), 7),
    ] {
        let outline = accepted(&ring);
        check_pieces(&outline);
        assert_eq!(outline.pieces().len(), expected, "{name}: {:?}", outline.pieces());
        for tenth in 1..63 {
            let rotation = Rotation::from_angle(0.1 * f64::from(tenth));
            let turned: Vec<Vec2> = ring.iter().map(|v| rotation.apply(*v)).collect();
            let outline = accepted(&turned);
            check_pieces(&outline);
            assert_eq!(outline.pieces().len(), expected, "{name} turned {tenth}");
        }
    }
}

#[test]
fn ten_thousand_vertices_of_any_shape_are_cut() {
    let jagged: Vec<f64> = (0..MAX_VERTICES).map(|i| 100.0 + (i * i % 97) as f64).collect();
    let turned = |ring: Vec<Vec2>| -> Vec<Vec2> {
        ring.into_iter().map(|v| Rotation::from_angle(0.7).apply(v)).collect()
    };
    for ring in [
        star(&jagged, Vec2::ZERO),
        star(&vec![100.0; MAX_VERTICES], Vec2::ZERO),
        comb(2_500, 1000.0),
        turned(comb(2_500, 5000.0)),
        spiral(5_000, 20.0),
    ] {
        check_pieces(&accepted(&ring));
    }
}

#[test]
fn notices_use_the_users_vertex_numbers() {
    let given = points(&[
        (0., 0.),
        (0., 5.),
        (0., 8.),
        (0., 8.),
        (20., 8.),
        (20., 0.),
        (20., 5e-10),
        (7., 0.),
        (0., 0.),
    ]);
    let (outline, notices) = Outline::new(&given).expect("good after merging");
    assert_eq!(outline.vertices(), points(&[(0., 0.), (20., 0.), (20., 8.), (0., 8.)]));
    assert_eq!(
        notices,
        [
            OutlineNotice::DuplicatesMerged { vertices: vec![3, 6, 8] },
            OutlineNotice::CollinearMerged { vertices: vec![1, 7] },
            OutlineNotice::Turned,
        ]
    );
    assert_eq!(
        notices[0].to_string(),
        "dropped because they repeat another vertex: vertices 3, 6, 8 (counted from 0)"
    );
}

#[test]
fn points_computed_on_a_line_are_merged_and_a_flat_arc_is_kept() {
    let (a, b) = (vec2(-149.3, 22.7), vec2(104.9, 23.3));
    let on_line = (1..100).map(|i| a + (b - a) * (0.01 * f64::from(i)));
    let mut ring = vec![b, vec2(10.0, -40.0), a];
    ring.extend(on_line);
    assert_eq!(accepted(&ring).vertices().len(), 3);
    let arc: Vec<Vec2> =
        (0..1000).map(|i| vec2(0.1 * f64::from(i), 1e-9 * f64::from(i * (999 - i)))).collect();
    let mut ring = arc.clone();
    ring.push(vec2(50.0, -20.0));
    assert_eq!(accepted(&ring).vertices().len(), arc.len() + 1);
}

#[test]
fn bad_outlines_are_refused_with_their_reason() {
    use OutlineError::{
        NonFinite, SelfIntersection, TooFar, TooFewVertices, TooManyVertices, ZeroArea,
    };
    let meet = |a: (usize, usize), b: (usize, usize)| SelfIntersection {
        edges: [OutlineEdge { from: a.0, to: a.1 }, OutlineEdge { from: b.0, to: b.1 }],
    };
    let nan = f64::NAN;
    let table = [
        ("empty", points(&[]), TooFewVertices { count: 0, distinct: 0 }),
        ("two", points(&[(0., 0.), (1., 0.)]), TooFewVertices { count: 2, distinct: 2 }),
        (
            "three, two alike",
            points(&[(0., 0.), (1., 0.), (1., 1e-10)]),
            TooFewVertices { count: 3, distinct: 2 },
        ),
        ("one place", points(&[(3., 3.); 5]), TooFewVertices { count: 5, distinct: 1 }),
        ("too many", vec![vec2(nan, 0.0); 10_001], TooManyVertices { count: 10_001 }),
        ("NaN", points(&[(0., 0.), (1., 0.), (1., nan)]), NonFinite { vertex: 2 }),
        (
            "infinity before far",
            points(&[(2e8, 0.), (1., 0.), (f64::NEG_INFINITY, 1.)]),
            NonFinite { vertex: 2 },
        ),
        (
            "far",
            points(&[(0., 0.), (1., -1.01e8), (1., 1.)]),
            TooFar { vertex: 1, coordinate_m: -1.01e8 },
        ),
        ("line", points(&[(0., 0.), (1., 1.), (2., 2.)]), ZeroArea),
        ("line there and back", points(&[(0., 0.), (3., 1.), (6., 2.), (3., 1.)]), ZeroArea),
        ("needle", points(&[(0., 0.), (1e4, 0.), (1e4, 1e-9), (0., 2e-9)]), ZeroArea),
        ("bow tie", points(&[(0., 0.), (1., 1.), (1., 0.), (0., 1.)]), meet((0, 1), (2, 3))),
        (
            "star of five points",
            points(&[(0., 10.), (6., -8.), (-9., 3.), (9., 3.), (-6., -8.)]),
            meet((0, 1), (2, 3)),
        ),
        (
            "spike outwards",
            points(&[(0., 0.), (4., 0.), (4., 2.), (9., 2.), (4., 2.), (4., 4.), (0., 4.)]),
            meet((2, 3), (3, 4)),
        ),
        (
            "spike inwards, past merged vertices",
            points(&[
                (0., 0.),
                (4., 0.),
                (4., 0.),
                (4., 4.),
                (2., 4.),
                (2., 2.),
                (2., 1.),
                (2., 4.),
                (0., 4.),
            ]),
            meet((4, 6), (6, 7)),
        ),
        (
            "spike by rounding",
            points(&[(0., 0.), (4., 0.), (0.1, 0.3), (0.7, 2.1), (0.4, 1.2), (-3., 1.)]),
            meet((2, 3), (3, 4)),
        ),
        (
            "vertex on edge",
            points(&[(0., 0.), (10., 0.), (10., 5.), (5., 0.), (0., 5.)]),
            meet((0, 1), (2, 3)),
        ),
        (
            "vertex on vertex",
            points(&[(0., 0.), (4., 0.), (2., 2.), (4., 4.), (0., 4.), (2., 2.)]),
            meet((1, 2), (4, 5)),
        ),
        (
            "vertex within a nanometre of an edge",
            points(&[(0., 0.), (10., 0.), (10., 5.), (5., 5e-10), (0., 5.)]),
            meet((0, 1), (2, 3)),
        ),
        (
            "slit of no width",
            points(&[
                (0., 0.),
                (9., 0.),
                (9., 4.),
                (6., 4.),
                (6., 2.),
                (7., 1.),
                (6., 2.0),
                (6., 4.),
                (0., 4.),
            ]),
            meet((4, 5), (5, 6)),
        ),
        (
            "hole on a keyhole of no width",
            points(&[
                (0., 0.),
                (9., 0.),
                (9., 9.),
                (5., 9.),
                (5., 7.),
                (7., 7.),
                (7., 3.),
                (3., 3.),
                (3., 7.),
                (5., 7.),
                (5., 9.),
                (0., 9.),
            ]),
            meet((2, 3), (9, 10)),
        ),
    ];
    for (name, ring, expected) in table {
        let error = Outline::new(&ring).expect_err(name);
        assert_eq!(error, expected, "{name}: {error}");
    }
}

#[test]
fn messages_name_the_vertices() {
    let spike = points(&[(0., 0.), (4., 0.), (4., 2.), (9., 2.), (4., 2.), (4., 4.), (0., 4.)]);
    let message = Outline::new(&spike).expect_err("spike").to_string();
    assert!(message.contains("doubles back on itself at vertex 3"), "{message}");
    let tie = points(&[(0., 0.), (1., 1.), (1., 0.), (0., 1.)]);
    let message = Outline::new(&tie).expect_err("bow tie").to_string();
    assert!(message.contains("edges 0–1 and 2–3"), "{message}");
}

/// Do any two edges that are not neighbours have a point in common? Tests every pair exactly.
fn meets_itself(ring: &[Vec2]) -> bool {
    let count = ring.len();
    let edge = |i: usize| [ring[i], ring[(i + 1) % count]];
    (0..count).any(|i| {
        (i + 2..count)
            .any(|j| (j + 1) % count != i && super::crossing::segments_meet(edge(i), edge(j)))
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1500))]

    #[test]
    fn pieces_are_convex_fill_the_outline_and_share_their_seams(ring in any_shape()) {
        if let Ok((outline, _)) = Outline::new(&ring) {
            check_pieces(&outline);
        }
    }

    #[test]
    fn triangulation_alone_gives_valid_pieces(ring in any_shape()) {
        if let Ok((mut outline, _)) = Outline::new(&ring) {
            let all: Vec<usize> = (0..outline.vertices.len()).collect();
            outline.pieces = super::mesh::convex_pieces(&outline.vertices, &all, 0.0)
                .into_iter()
                .map(|piece| piece.into_iter().map(|i| outline.vertices[i]).collect())
                .collect();
            check_pieces(&outline);
        }
    }

    #[test]
    fn tidying_twice_changes_nothing(ring in any_shape()) {
        if let Ok((outline, _)) = Outline::new(&ring) {
            let (again, notices) = Outline::new(outline.vertices()).expect("tidy");
            prop_assert!(notices.is_empty(), "{:?}", notices);
            prop_assert_eq!(again, outline);
        }
    }

    #[test]
    fn start_and_sense_do_not_change_the_outline(ring in any_shape(), start in 0..1000usize) {
        let mut other = ring.clone();
        other.reverse();
        other.rotate_left(start % ring.len());
        match (Outline::new(&ring), Outline::new(&other)) {
            (Ok((a, _)), Ok((b, _))) => {
                prop_assert!((a.area_m2() - b.area_m2()).abs() <= 1e-12 * a.area_m2());
                prop_assert!((a.centroid_m() - b.centroid_m()).length() < 1e-10 * a.radius_m());
                prop_assert_eq!(a.bounds(), b.bounds());
                prop_assert_eq!(a.vertices().len(), b.vertices().len());
                check_pieces(&b);
            }
            (a, b) => prop_assert_eq!(a.is_ok(), b.is_ok()),
        }
    }

    #[test]
    fn sweep_refuses_exactly_what_comparing_every_pair_refuses(
        coordinates in prop::collection::vec((0..5i32, 0..5i32), 3..12),
    ) {
        let ring: Vec<Vec2> =
            coordinates.iter().map(|&(x, y)| vec2(f64::from(x), f64::from(y))).collect();
        if let Ok((outline, _)) = Outline::new(&ring) {
            prop_assert!(!meets_itself(outline.vertices()));
        }
        prop_assert_eq!(super::crossing::meeting_edges(&ring).is_some(), meets_itself(&ring));
    }
}

/// Fuzzing the reader of dumps found this case: a ship's corner was moved to 2 µm from another corner, with a third
/// corner far away.
#[test]
fn a_spike_cut_into_a_needle_without_width_is_no_piece() {
    let ring =
        [(60.0, -10.0), (60.0, -10.000_001_817_941_666), (60.890_625, 1280.0), (-60.0, 10.0)]
            .map(|(x, y)| vec2(x, y));
    let (outline, _) = Outline::new(&ring).expect("a simple polygon");
    assert!(!outline.pieces().is_empty());
    let sum: f64 = outline.pieces().iter().map(|piece| fan_area(piece)).sum();
    assert!((sum - outline.area_m2()).abs() <= 1e-10 * outline.area_m2(), "{sum}");
    for piece in outline.pieces() {
        let _ = crate::geometry::convex::ConvexPolygon::new(piece);
    }
}
