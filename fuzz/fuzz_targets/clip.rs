//! Fuzzes the clip with two convex polygons that move past one another: at every step the overlap is valid, and is the
//! same warm, cold and with the polygons swapped.
#![no_main]

use fenderline_contact::{Clip, ConvexPolygon, PairClip, Pose, vec2};
use fenderline_fuzz::input::Input;
use fenderline_fuzz::polygon::polygon;
use libfuzzer_sys::fuzz_target;

const STEPS: usize = 24;

fuzz_target!(|bytes: &[u8]| {
    let mut input = Input::new(bytes);
    let (Some(a), Some(b)) = (polygon(&mut input), polygon(&mut input)) else { return };
    let mut pair = PairClip::default();
    let still = Pose::new(vec2(0.0, 0.0), 0.0);
    let a_pose =
        if input.byte() < 128 { still } else { Pose::new(still.position_m, input.heading_rad()) };
    let mut position_m = vec2(input.coordinate_m(), input.coordinate_m());
    let mut heading_rad = input.heading_rad();
    let step_m = vec2(input.coordinate_m(), input.coordinate_m()) * (1.0 / 16.0);
    let turn_rad = f64::from(input.byte() as i8) * 1e-3;
    for _ in 0..STEPS {
        let b_pose = Pose::new(position_m, heading_rad);
        compare(&mut pair, &a, a_pose, &b, b_pose);
        position_m += step_m;
        heading_rad += turn_rad;
    }
});

fn compare(warm: &mut PairClip, a: &ConvexPolygon, a_pose: Pose, b: &ConvexPolygon, b_pose: Pose) {
    // Rounding of vertices, 1e-16 of their size, along a boundary of that size, with a wide margin.
    let size_m = a.radius_m()
        + b.radius_m()
        + a.center_m().length()
        + b.center_m().length()
        + (b_pose.position_m - a_pose.position_m).length();
    let rounding_m2 = 1e-12 * size_m * size_m;

    let warm = warm.clip(a, a_pose, b, b_pose);
    let cold = PairClip::default().clip(a, a_pose, b, b_pose);
    let swapped = PairClip::default().clip(b, b_pose, a, a_pose);
    let area = |clip: &Option<Clip>| clip.as_ref().map_or(0.0, Clip::area_m2);

    for clip in [&warm, &cold, &swapped].into_iter().flatten() {
        assert!(clip.area_m2().is_finite() && clip.area_m2() > 0.0, "area {}", clip.area_m2());
        assert!(clip.centroid_m().is_finite() && clip.chord_m().is_finite());
    }
    let inputs = || {
        let (a, b) = (a.vertices(), b.vertices());
        format!("tolerance {rounding_m2}\n{a:?}\n{a_pose:?}\n{b:?}\n{b_pose:?}")
    };
    let largest_m2 = a.area_m2().min(b.area_m2()) * (1.0 + 1e-9) + rounding_m2;
    let (warm_m2, cold_m2, swapped_m2) = (area(&warm), area(&cold), area(&swapped));
    assert!(cold_m2 <= largest_m2, "{cold_m2}, but at most {largest_m2}; {}", inputs());
    let apart_m2 = (warm_m2 - cold_m2).abs();
    assert!(apart_m2 <= rounding_m2, "warm {warm_m2}, cold {cold_m2}; {}", inputs());
    let apart_m2 = (swapped_m2 - cold_m2).abs();
    assert!(apart_m2 <= rounding_m2, "{cold_m2}, swapped {swapped_m2}; {}", inputs());
    if let (Some(warm), Some(cold)) = (warm, cold)
        && cold.area_m2() > 1e-3 * size_m * size_m
    {
        let apart_m = (warm.centroid_m() - cold.centroid_m()).length();
        assert!(apart_m <= 1e-8 * size_m, "centroids {apart_m} m apart");
        let outside_m = (cold.centroid_m() - a.center_m()).length() - a.radius_m();
        assert!(outside_m <= 1e-9 * size_m, "centroid {outside_m} m outside");
    }
}
