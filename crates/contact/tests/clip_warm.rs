//! The warm clip, compared with the cold clip. The last step's result may speed up the clip, but must not change its
//! result.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

use crate::support;

use fenderline_contact::{Clip, ConvexPolygon, PairClip, Pose, Vec2, vec2};
use proptest::prelude::*;
use support::plain::{perimeter_m, plain_area_m2, plain_overlap};
use support::shapes::{any_convex, beside, hull, points, rectangle, regular};

fn config(cases: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(cases) }
}

/// A pair of polygons that is clipped both warm and cold.
struct Twice {
    a: ConvexPolygon,
    b: ConvexPolygon,
    warm: PairClip,
    cold: PairClip,
    touching: usize,
    placed: Vec<Vec2>,
}

impl Twice {
    fn new(a: &[Vec2], b: &[Vec2]) -> Twice {
        let (a, b) = (ConvexPolygon::new(a), ConvexPolygon::new(b));
        let (warm, cold) = (PairClip::default(), PairClip::default());
        Twice { a, b, warm, cold, touching: 0, placed: Vec::new() }
    }

    /// Checks that both clips give the same bits, and the same area as a plain clip.
    ///
    /// If a vertex lies on an edge to rounding, the two clips may attribute it to different edges. Area and chord may
    /// then differ by `SLACK_M`.
    #[track_caller]
    fn clip(&mut self, a_pose: Pose, b_pose: Pose) -> Option<Clip> {
        self.cold.forget();
        let warm = self.warm.clip(&self.a, a_pose, &self.b, b_pose);
        let cold = self.cold.clip(&self.a, a_pose, &self.b, b_pose);
        let b_in_a = a_pose.to(b_pose);
        self.placed.clear();
        self.placed.extend(self.b.vertices().iter().map(|&v| b_in_a.apply(v)));
        let plain = plain_overlap(self.a.vertices(), &self.placed);
        let right = plain_area_m2(&plain);
        let slack_m2 = perimeter_m(&plain).max(1.0) * SLACK_M + 1e-11 * right;
        let area = |c: Option<Clip>| c.map_or(0.0, |c| c.area_m2());
        for (which, found) in [("warm", area(warm)), ("cold", area(cold))] {
            assert!(
                (found - right).abs() <= slack_m2,
                "{which} area {found:e} not {right:e} at {b_in_a:?}"
            );
        }
        if same_bits(warm, cold) {
            self.touching += usize::from(warm.is_some());
            return warm;
        }
        assert!(
            (area(warm) - area(cold)).abs() <= slack_m2,
            "warm {warm:?} not cold {cold:?} at {b_in_a:?}"
        );
        self.check_difference(warm, cold, b_in_a);
        warm
    }

    /// Checks a difference in bits. It is allowed only if a corner lies on an edge.
    fn check_difference(&self, warm: Option<Clip>, cold: Option<Clip>, b_in_a: Pose) {
        let (Some(w), Some(c)) = (warm, cold) else { return }; // no more area than rounding
        let on_an_edge = least_distance(self.a.vertices(), &self.placed) <= SLACK_M;
        assert!(on_an_edge, "warm {w:?} not cold {c:?} at {b_in_a:?}");
    }
}

/// Rounding of a vertex at 300 m after some operations (m).
const SLACK_M: f64 = 4e-13;

fn same_bits(one: Option<Clip>, two: Option<Clip>) -> bool {
    let bits = |c: Clip| {
        let (p, d) = (c.centroid_m(), c.chord_m());
        [c.area_m2(), p.x, p.y, d.x, d.y].map(f64::to_bits)
    };
    one.map(bits) == two.map(bits)
}

/// Smallest distance of a vertex of either ring from the other ring's boundary (m).
fn least_distance(a: &[Vec2], b: &[Vec2]) -> f64 {
    let one_way = |from: &[Vec2], to: &[Vec2]| {
        let ends = to.iter().zip(to.iter().cycle().skip(1));
        let all = ends.flat_map(|(p, q)| from.iter().map(move |v| distance(*v, *p, *q)));
        all.fold(f64::INFINITY, f64::min)
    };
    one_way(a, b).min(one_way(b, a))
}

fn distance(v: Vec2, p: Vec2, q: Vec2) -> f64 {
    let along = q - p;
    let share = ((v - p).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    (v - (p + along * share)).length()
}

proptest! {
    #![proptest_config(config(400))]

    /// Ships that slide and turn along each other, with corners that enter and leave the overlap.
    #[test]
    fn a_sliding_and_turning_contact_is_the_same_warm_and_cold(
        a in any_convex(),
        b in any_convex(),
        (bearing, heading) in (0.0..6.3f64, 0.0..6.3f64),
        (depth_m, share) in (0.0..3.0f64, -0.5..0.5f64),
        (along, out, yaw) in (-1.0..1.0f64, -0.2..0.2f64, -0.05..0.05f64),
        pace in -3.0..0.5f64,
    ) {
        let mut both = Twice::new(&a, &b);
        let a_pose = Pose::new(vec2(700.0, -700.0), 0.3);
        let start = beside(&a, a_pose, &b, heading, (bearing, depth_m, share));
        let (sin, cos) = libm::sincos(bearing);
        let (off, pace) = (vec2(cos, sin), libm::pow(10.0, pace));
        let drift = (off * out + off.quarter_turn() * along) * pace;
        for step in 0..200 {
            let t = f64::from(step) - 100.0;
            let b_pose = Pose::new(start.position_m + drift * t, heading + yaw * pace * t);
            both.clip(a_pose, b_pose);
        }
    }

    /// One body passes through the other: apart, at a corner, across, contained, and apart again.
    #[test]
    fn a_pass_right_through_is_the_same_warm_and_cold(
        a in any_convex(),
        b in any_convex(),
        (bearing, heading, offset) in (0.0..6.3f64, 0.0..6.3f64, -0.5..0.5f64),
        turn in -3.0..3.0f64,
    ) {
        let mut both = Twice::new(&a, &b);
        let a_pose = Pose::new(vec2(0.0, 0.0), 0.0);
        let (sin, cos) = libm::sincos(bearing);
        let way = vec2(cos, sin) * (both.a.radius_m() + both.b.radius_m());
        let aside = way.quarter_turn() * offset;
        for step in 0..200 {
            let t = f64::from(step) / 100.0 - 1.0;
            both.clip(a_pose, Pose::new(way * t + aside, heading + turn * t));
        }
    }

    /// The bodies turn inside and across each other. A second lens appears and disappears while the warm clip follows
    /// the first.
    #[test]
    fn four_crossings_that_appear_beside_a_lens_are_the_same_warm_and_cold(
        (length_a, width_a) in (5.0..60.0f64, 0.001..20.0f64),
        (length_b, width_b) in (5.0..60.0f64, 0.001..20.0f64),
        (x, y, heading) in (-15.0..15.0f64, -15.0..15.0f64, 0.0..6.3f64),
        (dx, dy, yaw) in (-1.0..1.0f64, -1.0..1.0f64, -0.3..0.3f64),
        (count_a, count_b) in (4usize..40, 4usize..40),
    ) {
        let round = |l: f64, w: f64, count: usize| support::shapes::ellipse(l, w, count, &[]);
        let mut both = Twice::new(&round(length_a, width_a, count_a), &round(length_b, width_b, count_b));
        let mut boxes = Twice::new(&rectangle(length_a, width_a), &rectangle(length_b, width_b));
        for step in 0..200 {
            let t = 0.1 * (f64::from(step) - 100.0);
            let b_pose = Pose::new(vec2(x + dx * t, y + dy * t), heading + yaw * t);
            both.clip(Pose::new(Vec2::ZERO, 0.0), b_pose);
            boxes.clip(Pose::new(Vec2::ZERO, 0.0), b_pose);
        }
    }

    /// The bodies jump at random. The warm clip then starts from unrelated edges.
    #[test]
    fn a_jump_to_any_place_is_the_same_warm_and_cold(
        a in any_convex(),
        b in any_convex(),
        places in prop::collection::vec((0.0..6.3f64, 0.0..6.3f64, -3.0..1.5f64, -0.5..0.5f64), 60),
    ) {
        let mut both = Twice::new(&a, &b);
        let a_pose = Pose::new(Vec2::ZERO, 0.0);
        for (bearing, heading, power, share) in places {
            let depth_m = libm::pow(10.0, power);
            both.clip(a_pose, beside(&a, a_pose, &b, heading, (bearing, depth_m, share)));
        }
    }
}

/// Polygons that turn nearly all their angle at one place. A few of their vertices approximate them badly.
#[test]
fn lopsided_polygons_are_the_same_warm_and_cold() {
    let mut drop = points(&[(40.0, 0.0)]);
    for i in 0..30 {
        let (sin, cos) = libm::sincos(1.6 + 0.1 * f64::from(i));
        drop.push(vec2(0.5 * cos, 0.5 * sin));
    }
    let needle = points(&[(30.0, 0.0), (-30.0, 0.02), (-30.0, -0.02)]);
    let shapes = [drop, needle, hull(298.0, 46.0, 64), regular(1.0, 64), rectangle(80.0, 0.005)];
    for a in &shapes {
        for b in &shapes {
            let mut both = Twice::new(a, b);
            for step in 0..3000 {
                let t = f64::from(step);
                let reach = 0.5 * (both.a.radius_m() + both.b.radius_m());
                let (sin, cos) = libm::sincos(0.013 * t);
                let way = vec2(cos, sin) * (reach * (1.0 + libm::sin(0.0071 * t)) * 0.7);
                both.clip(Pose::new(Vec2::ZERO, 0.0), Pose::new(way, 0.0173 * t));
            }
        }
    }
}

/// A corner moves slowly along a face and past its end, in 50,000 steps. The clip is cold only where the warm clip
/// requires it.
#[test]
fn fifty_thousand_small_steps_round_a_hull_are_the_same_warm_and_cold() {
    let (ship, tug) = (hull(298.0, 46.0, 64), hull(32.0, 13.0, 24));
    let mut both = Twice::new(&ship, &tug);
    for step in 0..50_000 {
        let t = f64::from(step) / 50_000.0;
        let (sin, cos) = libm::sincos(core::f64::consts::TAU * t);
        // The corner moves round the ship along her own shape, sometimes deep and sometimes free.
        let sunk = 1.0 - 0.02 * libm::sin(300.0 * t).max(-0.5);
        let at = vec2((149.0 + 8.0) * cos, (23.0 + 6.5) * sin) * sunk;
        both.clip(Pose::new(vec2(2.0, 3.0), 0.1), Pose::new(at, 40.0 * t));
    }
    assert!(both.touching > 5_000, "{}", both.touching);
}
