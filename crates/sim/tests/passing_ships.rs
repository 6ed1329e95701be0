//! Forces of a passing ship, compared with published peaks, with the paper's integrals, and with symmetries.

use fenderline_contact::number::greater;
use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::passing::{Berth, PassingShip, Sections, factors, force, force_under_way};

const DENSITY_KGPM3: f64 = 1025.0;

/// X, Y and N on a ship at rest that heads north. A ship passes to the north, ξ ahead and η to starboard of her.
fn on_parallel(ships: [&Sections; 2], [xi_m, eta_m]: [f64; 2], speed_mps: f64) -> [f64; 3] {
    let passing = PassingShip {
        sections: ships[1],
        pose: Pose::new(vec2(xi_m, eta_m), 0.0),
        velocity_mps: vec2(speed_mps, 0.0),
    };
    force(ships[0], Pose::new(Vec2::ZERO, 0.0), &passing, DENSITY_KGPM3, 1.0)
}

/// The largest values of X, Y and N during a passage. Forces are over ρU²S₁S₂/L₂², moments over that times L₁.
fn peaks(lengths_m: [f64; 2], eta_m: f64) -> [f64; 3] {
    let areas_m2 = [300.0, 200.0];
    let ships = [0, 1].map(|i| Sections::parabola(lengths_m[i], areas_m2[i]).unwrap());
    let unit_n = DENSITY_KGPM3 * areas_m2[0] * areas_m2[1] / (lengths_m[1] * lengths_m[1]);
    let units = [unit_n, unit_n, unit_n * lengths_m[0]];
    let mut most = [0.0_f64; 3];
    for step in -200..=200 {
        let xi_m = f64::from(step) / 200.0 * 0.8 * (lengths_m[0] + lengths_m[1]);
        let found = on_parallel([&ships[0], &ships[1]], [xi_m, eta_m], 1.0);
        for (most, (found, unit)) in most.iter_mut().zip(found.iter().zip(units)) {
            *most = greater(*most, found.abs() / unit);
        }
    }
    most
}

/// Peaks for two ships of one length: from tables, and from the paper's integrals by Gauss's rule
/// (validation/independent/passing_ships.py). The tables were recalled from design notes and differ from the integrals
/// by 2 to 4 %. The tolerance is 6 %.
#[test]
fn published_peaks_of_ships_of_one_length() {
    for (eta, tables, integrals) in [
        (0.10, [4.73, 24.9, 5.33], [4.7645, 25.1656, 5.4674]),
        (0.26, [1.62, 5.9, 1.23], [1.6696, 6.0376, 1.2488]),
        // The yaw in the table, 0.25, is 9 % below its integral.
        (0.50, [0.48, 1.55, f64::NAN], [0.5055, 1.6030, 0.2750]),
    ] {
        let found = peaks([200.0, 200.0], eta * 200.0);
        for ((found, table), integral) in found.iter().zip(tables).zip(integrals) {
            let off_table = (found / table - 1.0).abs();
            assert!(table.is_nan() || off_table < 0.06, "η/L {eta}: {found} of {table}");
            assert!((found / integral - 1.0).abs() < 0.01, "η/L {eta}: {found} of {integral}");
        }
    }
}

/// The paper's integrals with parabolas by Gauss's rule, with 96 × 96 points, give 0.343, 1.073 and 0.222.
#[test]
fn coefficients_of_the_worked_case() {
    let found = peaks([243.5, 185.4], 110.0);
    for (found, wanted) in found.iter().zip([0.34337, 1.07253, 0.22222]) {
        assert!((found / wanted - 1.0).abs() < 0.01, "{found} of {wanted}");
    }
}

/// A ship of 243.5 × 39 × 15.3 m is moored in 20 m of water. A ship of 185.4 × 25.8 × 6.8 m passes at 10 kn, with 110 m
/// between the centre lines. The coefficients 0.299, 1.064 and 0.204 of a table for deep water give 389.3 kN, 1274.4 kN
/// and 40010 kN·m.
#[test]
fn depth_factors_of_the_worked_case() {
    let areas_m2 = [0.98 * 39.0 * 15.3, 0.98 * 25.8 * 6.8];
    let speed_mps = 10.0 * 1852.0 / 3600.0;
    let unit_n =
        DENSITY_KGPM3 * speed_mps * speed_mps * areas_m2[0] * areas_m2[1] / (185.4 * 185.4);
    let gap_over_beam = (110.0 - 0.5 * (39.0 + 25.8)) / (0.5 * (39.0 + 25.8));
    let by = factors(15.3 / 20.0, gap_over_beam, Berth::Open).unwrap();
    let found = [0.299 * by[0], 1.064 * by[1], 0.204 * by[2] * 243.5].map(|f| f * unit_n);
    for (found, published) in found.iter().zip([389.3e3, 1274.4e3, 40_010e3]) {
        // The coefficients have three digits.
        assert!((found / published - 1.0).abs() < 0.005, "{found} of {published}");
    }
}

#[test]
fn a_pass_is_symmetric_and_quadratic_in_the_speed() {
    let ships = [(243.5, 585.0), (185.4, 172.0)].map(|(l, s)| Sections::parabola(l, s).unwrap());
    let at = |xi_m: f64, eta_m: f64, speed_mps: f64| {
        on_parallel([&ships[0], &ships[1]], [xi_m, eta_m], speed_mps)
    };
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-9 * (a.abs() + b.abs() + 1.0);
    for xi_m in [0.0, 30.0, 95.0, 180.0] {
        let [x, y, n] = at(xi_m, 60.0, 4.0);
        let [bx, by, bn] = at(-xi_m, 60.0, 4.0);
        assert!(close(x, -bx) && close(y, by) && close(n, -bn), "{xi_m}");
        // On the other side the surge is the same, and sway and yaw are mirrored.
        let [px, py, pn] = at(xi_m, -60.0, 4.0);
        assert!(close(x, px) && close(y, -py) && close(n, -pn), "{xi_m}");
        // Twice the speed gives four times the force. The direction in which she goes does not matter.
        let fast = at(xi_m, 60.0, -8.0);
        assert!(fast.iter().zip([x, y, n]).all(|(fast, slow)| close(*fast, 4.0 * slow)));
    }
    // When she is abreast, she draws the other ship towards her.
    assert!(at(0.0, 60.0, 4.0)[1] > 0.0);
    // When her bow comes near from astern, the other ship is first drawn towards her, then pushed along.
    assert!(at(-150.0, 60.0, 4.0)[0] < 0.0 && at(150.0, 60.0, 4.0)[0] > 0.0);
}

#[test]
fn a_turned_berth_has_the_same_forces() {
    let ships = [(200.0, 500.0), (150.0, 200.0)].map(|(l, s)| Sections::parabola(l, s).unwrap());
    let pass = |turned_rad: f64| {
        let whole = Pose::new(vec2(1234.0, -567.0), turned_rad);
        let relative = Pose::new(vec2(40.0, 70.0), 0.3);
        let passing = PassingShip {
            sections: &ships[1],
            pose: Pose::new(whole.apply(relative.position_m), turned_rad + 0.3),
            velocity_mps: whole.rotation.apply(vec2(3.0, 0.9)),
        };
        force(&ships[0], whole, &passing, DENSITY_KGPM3, 20.0)
    };
    let north = pass(0.0);
    for turned_rad in [0.7, 2.0, -2.9] {
        for (a, b) in pass(turned_rad).iter().zip(north) {
            assert!((a - b).abs() < 1e-6 * b.abs(), "{a} {b}");
        }
    }
}

/// The force is that of a decreasing potential. Far away nothing is left. Through the berth the force stays finite.
#[test]
fn the_force_is_bounded_and_ends_with_the_distance() {
    let ships = [(200.0, 500.0), (150.0, 200.0)].map(|(l, s)| Sections::parabola(l, s).unwrap());
    let abreast = on_parallel([&ships[0], &ships[1]], [0.0, 60.0], 5.0);
    let far = on_parallel([&ships[0], &ships[1]], [3000.0, 60.0], 5.0);
    assert!(far[1].abs() < 1e-4 * abreast[1], "{far:?}");
    let through = PassingShip {
        sections: &ships[1],
        pose: Pose::new(vec2(10.0, 0.0), 1.0),
        velocity_mps: vec2(5.0, 5.0),
    };
    let found = force(&ships[0], Pose::new(Vec2::ZERO, 0.0), &through, DENSITY_KGPM3, 30.0);
    assert!(found.iter().all(|f| f.is_finite() && f.abs() < 1e9), "{found:?}");
}

#[test]
fn depths_and_gaps_that_cannot_be_are_refused() {
    for (draught, gap) in [(1.2, 1.0), (-0.1, 1.0), (0.5, -0.1), (f64::NAN, 1.0), (0.5, f64::NAN)] {
        assert!(factors(draught, gap, Berth::Open).is_err(), "{draught} {gap}");
    }
    let [open, quay] = [Berth::Open, Berth::Quay].map(|berth| factors(0.7, 2.0, berth).unwrap());
    assert!(quay[0] > open[0] && quay[1] < open[1] && quay[2] < open[2]);
}

/// Two ships are under way at an angle. The force is compared with the change of the water's momentum. The velocity of
/// the sources' water is summed at points of the own ship, at rest and moving with her, a moment before and a moment
/// after. The differences leave an error of 1e-5.
#[test]
fn the_force_under_way_is_the_change_of_the_waters_momentum() {
    let (half_m, other_half_m, area_m2, other_area_m2) = (100.0, 80.0, 300.0, 200.0);
    let ships = [(2.0 * half_m, area_m2), (2.0 * other_half_m, other_area_m2)];
    let [own, other] = ships.map(|(l, s)| Sections::parabola(l, s).unwrap());
    let (own_mps, other_mps) = (3.0, 5.0);
    let heading = Pose::new(Vec2::ZERO, 0.3).rotation;
    let start_m = vec2(20.0, 70.0);
    // The panels are those of the sections: 48 of them, with the changes of area at their middles.
    let places =
        |half_m: f64| (0..48).map(move |i| half_m * (2.0 * (f64::from(i) + 0.5) / 48.0 - 1.0));
    let edge_area = |x_m: f64, half_m: f64, s: f64| s * (1.0 - (x_m / half_m) * (x_m / half_m));
    let flow = |at_m: Vec2, t_s: f64| {
        let mut sum = Vec2::ZERO;
        for x_m in places(other_half_m) {
            let d_m = other_half_m / 48.0;
            let area = |x_m| edge_area(x_m, other_half_m, other_area_m2);
            let change = area(x_m + d_m) - area(x_m - d_m);
            let from = start_m + heading.apply(vec2(other_mps * t_s + x_m, 0.0));
            let d = at_m - from;
            sum += d * (change / (d.length() * d.length_squared()));
        }
        sum * (-other_mps / std::f64::consts::TAU)
    };
    let dt_s = 1e-3;
    let mut wanted = [0.0; 3];
    for x_m in places(half_m) {
        let d_m = half_m / 48.0;
        let volume = |x: f64| area_m2 * (x - x * x * x / (3.0 * half_m * half_m));
        let mass_kg = DENSITY_KGPM3 * (volume(x_m + d_m) - volume(x_m - d_m));
        let change = |speed_mps: f64| {
            let at = |t_s: f64| flow(vec2(x_m + speed_mps * t_s, 0.0), t_s);
            (at(dt_s) - at(-dt_s)) * (0.5 / dt_s)
        };
        let (at_rest, with_her) = (change(0.0), change(own_mps));
        let across_n = mass_kg * (at_rest.y + with_her.y);
        wanted[0] += mass_kg * at_rest.x;
        wanted[1] += across_n;
        wanted[2] += x_m * across_n + own_mps * mass_kg * flow(vec2(x_m, 0.0), 0.0).y;
    }
    let under_way = |sections, pose, velocity_mps| PassingShip { sections, pose, velocity_mps };
    let own = under_way(&own, Pose::new(Vec2::ZERO, 0.0), vec2(own_mps, 0.0));
    let pose = Pose { position_m: start_m, rotation: heading };
    let other = under_way(&other, pose, heading.apply(vec2(other_mps, 0.0)));
    let found = force_under_way(&own, &other, DENSITY_KGPM3, 1.0);
    for (found, wanted) in found.iter().zip(wanted) {
        assert!((found / wanted - 1.0).abs() < 1e-5, "{found} of {wanted}");
    }
}

/// Momentum: two ships on parallel courses at one speed push each other equally, because the flow about them is steady.
/// When abreast, they attract each other.
#[test]
fn ships_abreast_at_one_speed_push_each_other_equally() {
    let ships = [(243.5, 585.0), (185.4, 172.0)].map(|(l, s)| Sections::parabola(l, s).unwrap());
    for along_m in [0.0, 40.0, 150.0] {
        let at = |index: usize| PassingShip {
            sections: &ships[index],
            pose: Pose::new(vec2([0.0, along_m][index], [0.0, 60.0][index]), 0.0),
            velocity_mps: vec2(4.0, 0.0),
        };
        let (one, other) = (at(0), at(1));
        let [x1, y1, _] = force_under_way(&one, &other, DENSITY_KGPM3, 1.0);
        let [x2, y2, _] = force_under_way(&other, &one, DENSITY_KGPM3, 1.0);
        // The sections and the sources of a ship are at slightly different places. The tolerance is 1 %.
        assert!((y1 + y2).abs() < 0.01 * y1.abs(), "{along_m}: {y1} {y2}");
        assert!((x1 + x2).abs() < 0.01 * greater(y1.abs(), x1.abs()), "{along_m}: {x1} {x2}");
        assert!(along_m > 0.0 || y1 > 0.0, "{y1}");
    }
}
