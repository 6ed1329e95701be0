//! Current and depth of the water. Interpolation is compared with sums by hand.

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::Environment;
use fenderline_sim::environment::current::{Current, CurrentGrid, CurrentProfile};
use fenderline_sim::environment::{EnvironmentError, Tide, TideConstituent};
use proptest::prelude::*;

fn profile() -> CurrentProfile {
    let points = vec![(0.0, vec2(1.0, 0.0)), (10.0, vec2(0.5, 0.2)), (20.0, vec2(0.1, 0.2))];
    CurrentProfile::new(points).unwrap()
}

/// Trapezoids by hand. To 5 m the mean is (1 + 0.75)/2. To 15 m it is (0.75·10 + 0.4·5)/15, with 0.3 at 15 m. To 30 m
/// it is (0.75·10 + 0.3·10 + 0.1·10)/30.
#[test]
fn the_current_on_a_hull_is_the_mean_over_its_draught() {
    let close = |draught_m: f64, north: f64| {
        let mean = profile().mean_over(draught_m);
        assert!((mean.x - north).abs() < 1e-12, "{draught_m}: {}", mean.x);
    };
    close(0.0, 1.0);
    close(5.0, 0.875);
    close(15.0, (7.5 + 2.0) / 15.0);
    close(30.0, 11.5 / 30.0);
    assert_eq!(profile().at(1e6), vec2(0.1, 0.2));
}

/// Interpolation is exact for a field that is linear in north, in east and in time: f = 0.1 + n/1000 + 2e/1000 + 3 n
/// e/1e6 + t/1e4.
#[test]
fn a_grid_is_exact_for_a_linear_field() {
    let field =
        |t: f64, n: f64, e: f64| 0.1 + n / 1e3 + 2.0 * e / 1e3 + 3.0 * n * e / 1e6 + t / 1e4;
    let (times, north, east) = (vec![0.0, 600.0], vec![0.0, 100.0, 300.0], vec![-50.0, 50.0]);
    let mut velocities = vec![];
    for &t in &times {
        for &n in &north {
            velocities.extend(east.iter().map(|&e| vec2(field(t, n, e), -field(t, n, e))));
        }
    }
    let grid = CurrentGrid::new(times, north, east, velocities).unwrap();
    for (t, n, e) in [(0.0, 0.0, -50.0), (150.0, 77.0, 13.0), (599.0, 299.0, 49.0)] {
        let at = grid.at(vec2(n, e), t);
        assert!((at.x - field(t, n, e)).abs() < 1e-12 && (at.y + at.x).abs() < 1e-12);
    }
    // Beyond the edges of the grid, the value at the edge is used.
    assert_eq!(grid.at(vec2(1e5, 1e5), 1e9), grid.at(vec2(300.0, 50.0), 600.0));
    assert_eq!(grid.at(vec2(-1e5, -1e5), -1.0), grid.at(vec2(0.0, -50.0), 0.0));
}

#[test]
fn all_kinds_of_current_give_a_velocity() {
    let uniform = Current::uniform(vec2(0.3, -0.4)).unwrap();
    assert_eq!(uniform.velocity(vec2(1e7, 0.0), 1e9, 10.0), vec2(0.3, -0.4));
    let layered = Current::Layered(profile());
    assert_eq!(layered.velocity(Vec2::ZERO, 0.0, 5.0), profile().mean_over(5.0));
}

#[test]
fn absurd_currents_and_broken_grids_are_refused_by_name() {
    let text = |error: EnvironmentError| error.to_string();
    let error = text(Current::uniform(vec2(1e6, 0.0)).unwrap_err());
    assert_eq!(error, "current to the north [m/s] must be between -15 and 15, but is 1000000");
    assert!(Current::uniform(vec2(0.0, f64::NAN)).is_err());
    let still = vec![Vec2::ZERO; 3];
    let error = text(
        CurrentGrid::new(vec![0.0], vec![0.0, 1.0], vec![0.0, 1.0], still.clone()).unwrap_err(),
    );
    assert_eq!(error, "the current's grid needs 4 entries, but has 3");
    let error =
        text(CurrentGrid::new(vec![0.0], vec![0.0, 1.0, 1.0], vec![0.0], still).unwrap_err());
    assert_eq!(error, "northings of the current [m] must increase, but entry 2 does not");
    assert!(CurrentProfile::new(vec![]).is_err());
    assert!(CurrentProfile::new(vec![(5.0, Vec2::ZERO), (2.0, Vec2::ZERO)]).is_err());
}

fn water(tide: Tide) -> Environment {
    Environment { depth_m: Some(12.0), tide, ..Environment::default() }
}

#[test]
fn the_tide_moves_the_depth() {
    assert_eq!(water(Tide::Level(1.5)).depth_at_m(Vec2::ZERO, 99.0), Ok(Some(13.5)));
    let curve = water(Tide::Curve(vec![[0.0, 0.0], [3600.0, 2.0]]));
    assert_eq!(curve.depth_at_m(Vec2::ZERO, -5.0), Ok(Some(12.0)));
    assert_eq!(curve.depth_at_m(Vec2::ZERO, 1800.0), Ok(Some(13.0)));
    assert_eq!(curve.depth_at_m(Vec2::ZERO, 7200.0), Ok(Some(14.0)));
    assert_eq!(curve.depth_range_m(), Some([12.0, 14.0]));
    let m2 = TideConstituent { amplitude_m: 2.0, period_s: 44_714.0, lag_rad: 0.0 };
    let tide = water(Tide::Harmonic { mean_m: 3.0, constituents: vec![m2] });
    assert!((tide.depth_at_m(Vec2::ZERO, 0.0).unwrap().unwrap() - 17.0).abs() < 1e-12);
    assert!((tide.depth_at_m(Vec2::ZERO, 22_357.0).unwrap().unwrap() - 13.0).abs() < 1e-12);
    assert_eq!(tide.depth_range_m(), Some([13.0, 17.0]));
    // The ground falls dry. The depth is not negative.
    let dry = Environment { depth_m: Some(-3.0), ..water(Tide::Level(1.0)) };
    assert_eq!(dry.depth_at_m(Vec2::ZERO, 0.0), Ok(Some(0.0)));
    assert_eq!(Environment::default().depth_at_m(Vec2::ZERO, 0.0), Ok(None), "deep");
}

#[test]
fn impossible_waters_are_refused_by_name() {
    let bottomless = Environment { depth_m: Some(1e6), ..Environment::default() };
    assert!(bottomless.check().unwrap_err().to_string().starts_with("depth of the water"));
    assert!(water(Tide::Level(f64::NAN)).check().is_err());
    assert!(water(Tide::Curve(vec![])).check().is_err());
    assert!(water(Tide::Level(2.0)).check().is_ok());
}

proptest! {
    /// The mean over a draught lies between the least and the greatest velocity. It is continuous in the draught.
    #[test]
    fn the_mean_over_the_draught_is_bounded_and_continuous(draught_m in 0.0..50.0_f64) {
        let (mean, near) = (profile().mean_over(draught_m), profile().mean_over(draught_m + 1e-6));
        prop_assert!((0.1..=1.0).contains(&mean.x));
        prop_assert!((mean.x - near.x).abs() < 1e-6);
    }
}
