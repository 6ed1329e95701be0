//! The pull of a wall by the image of the ship: its symmetries, its integrals by another rule, and walls at an angle.

use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::passing::{PassingShip, Sections, force_of_wall};

const DENSITY_KGPM3: f64 = 1025.0;
const LENGTH_M: f64 = 200.0;
const AREA_M2: f64 = 300.0;
const SPEED_MPS: f64 = 4.0;

fn parabola() -> Sections {
    Sections::parabola(LENGTH_M, AREA_M2).unwrap()
}

/// A ship at the origin on a heading. A wall lies to starboard of her at a distance.
fn pull(ship: &Sections, speed_mps: f64, wall_m: f64, depth_m: Option<f64>) -> [f64; 3] {
    let own = PassingShip {
        sections: ship,
        pose: Pose::new(Vec2::ZERO, 0.0),
        velocity_mps: vec2(speed_mps, 0.0),
    };
    let wall = [vec2(-500.0, wall_m), vec2(500.0, wall_m)];
    force_of_wall(&own, wall, DENSITY_KGPM3, depth_m, 1.0)
}

/// A wall draws a ship that is symmetric fore and aft straight to it. There is no force along the wall and no moment.
/// The direction of the wall's line does not matter.
#[test]
fn a_wall_draws_a_symmetric_ship_straight_to_it() {
    let ship = parabola();
    for depth_m in [None, Some(15.0)] {
        let [x_n, y_n, n_nm] = pull(&ship, SPEED_MPS, 40.0, depth_m);
        assert!(y_n > 0.0, "{y_n}");
        assert!(x_n.abs() < 1e-9 * y_n && n_nm.abs() < 1e-9 * y_n * LENGTH_M, "{x_n} {n_nm}");
        let [_, port_n, _] = pull(&ship, SPEED_MPS, -40.0, depth_m);
        let [_, astern_n, _] = pull(&ship, -SPEED_MPS, 40.0, depth_m);
        let [_, fast_n, _] = pull(&ship, 2.0 * SPEED_MPS, 40.0, depth_m);
        let [_, at_rest_n, _] = pull(&ship, 0.0, 40.0, depth_m);
        assert!((port_n + y_n).abs() < 1e-9 * y_n && (astern_n - y_n).abs() < 1e-9 * y_n);
        assert!((fast_n - 4.0 * y_n).abs() < 1e-9 * y_n && at_rest_n == 0.0);
    }
}

/// Y over ρu²S²/L², by Gauss's rule and four thousand images: `slender` of validation/independent/bank_panels.py. The
/// tolerance of 1 % is for the midpoint rule with 48 panels, whose error grows towards the wall.
#[test]
fn the_pull_is_that_of_the_integrals() {
    let ship = parabola();
    let unit_n = DENSITY_KGPM3 * SPEED_MPS * SPEED_MPS * AREA_M2 * AREA_M2 / (LENGTH_M * LENGTH_M);
    let walls_m = [20.0, 30.0, 45.0, 60.0, 90.0];
    for (depth_m, wanted) in [
        (None, [4.6768, 2.3308, 1.0198, 0.5136, 0.1666]),
        (Some(20.0), [9.7563, 6.6181, 3.9582, 2.4966, 1.1267]),
        (Some(13.0), [14.8891, 10.1766, 6.0894, 3.8409, 1.7333]),
    ] {
        for (wall_m, wanted) in walls_m.into_iter().zip(wanted) {
            let found = pull(&ship, SPEED_MPS, wall_m, depth_m)[1] / unit_n;
            assert!((found / wanted - 1.0).abs() < 0.01, "{depth_m:?}, {wall_m}: {found} {wanted}");
        }
    }
}

/// The pull is ½u² times the change of the energy of ship and image with their distance. The energy is (ρ/2π) ∬ S'S'/r,
/// by differences of sums over the changes of the areas. The tolerance of 1 % is for sections and sources, which are at
/// slightly different places.
#[test]
fn the_pull_is_the_change_of_the_waters_energy() {
    let half_m = 0.5 * LENGTH_M;
    let area = |x_m: f64| AREA_M2 * (1.0 - (x_m / half_m) * (x_m / half_m));
    let places = || (0..96).map(|i| half_m * (2.0 * (f64::from(i) + 0.5) / 96.0 - 1.0));
    let d_m = half_m / 96.0;
    let change = |x_m: f64| area(x_m + d_m) - area(x_m - d_m);
    let energy_j = |wall_m: f64| {
        let pairs = places().flat_map(|one| places().map(move |other| (one, other)));
        let sum: f64 = pairs
            .map(|(one, other)| {
                let along_m = one - other;
                let apart_m2 = along_m * along_m + 4.0 * wall_m * wall_m;
                change(one) * change(other) / apart_m2.sqrt()
            })
            .sum();
        0.5 * SPEED_MPS * SPEED_MPS * DENSITY_KGPM3 / std::f64::consts::TAU * sum
    };
    for wall_m in [30.0, 60.0] {
        let wanted_n = (energy_j(wall_m - 0.01) - energy_j(wall_m + 0.01)) / 0.02;
        let found_n = pull(&parabola(), SPEED_MPS, wall_m, None)[1];
        assert!((found_n / wanted_n - 1.0).abs() < 0.01, "{wall_m}: {found_n} {wanted_n}");
    }
}

/// Ship and wall are turned and moved together. The force in her axes stays the same. A wall also turns a ship that is
/// full forward.
#[test]
fn a_turned_canal_has_the_same_forces() {
    let full = Sections::new(&[(-100.0, 0.0), (40.0, 300.0), (80.0, 250.0), (100.0, 0.0)]).unwrap();
    let pull = |turned_rad: f64| {
        let whole = Pose::new(vec2(900.0, -4000.0), turned_rad);
        let at = Pose::new(whole.apply(vec2(20.0, 5.0)), turned_rad + 0.1);
        let own = PassingShip {
            sections: &full,
            pose: at,
            velocity_mps: at.rotation.apply(vec2(3.0, 0.4)),
        };
        let wall = [vec2(600.0, -60.0), vec2(-600.0, -60.0)].map(|end| whole.apply(end));
        force_of_wall(&own, wall, DENSITY_KGPM3, Some(18.0), 30.0)
    };
    let north = pull(0.0);
    assert!(north[1] < 0.0 && north[2].abs() > 1e-3 * north[1].abs() * LENGTH_M, "{north:?}");
    for turned_rad in [0.8, 2.3, -1.1] {
        for (found, wanted) in pull(turned_rad).iter().zip(north) {
            assert!((found - wanted).abs() < 1e-6 * wanted.abs(), "{found} {wanted}");
        }
    }
}

/// In water as deep as she is long, the bottom changes the pull by less than 2 %. In shallower water it makes the pull
/// stronger.
#[test]
fn the_bottom_makes_the_pull_stronger() {
    let ship = parabola();
    let at = |depth_m: Option<f64>| pull(&ship, SPEED_MPS, 45.0, depth_m)[1];
    let depths = [None, Some(200.0), Some(50.0), Some(25.0), Some(12.0)];
    let pulls: Vec<f64> = depths.into_iter().map(at).collect();
    assert!(pulls.windows(2).all(|two| two[0] < two[1]), "{pulls:?}");
    assert!(pulls[1] < 1.02 * pulls[0], "{pulls:?}");
}
