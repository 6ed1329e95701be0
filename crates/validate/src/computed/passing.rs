//! Computes the peaks of the forces of a passing ship on a ship at rest.

use fenderline_contact::number::greater;
use fenderline_contact::{Pose, Vec2, vec2};
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::passing::{Berth, PassingShip, Sections, factors, force};

use super::Values;

const DENSITY_KGPM3: f64 = 1025.0;
const NAMES: [&str; 3] = ["surge", "sway", "yaw"];

/// Number of places of the passing ship at which the peak is looked for, on one side only, because the forces are
/// symmetric.
const PLACES: u32 = 200;

/// # Panics
/// Panics if a ship's length or area, or a depth, is out of range, which would be a bug.
pub(super) fn compute(values: &mut Values) {
    for (share, name) in [(0.10, "0.10"), (0.26, "0.26"), (0.50, "0.50")] {
        let found = peaks([200.0, 200.0], share * 200.0);
        for (force, found) in NAMES.iter().zip(found) {
            values.put(format!("passing/one_length/{name}/{force}"), found, "");
        }
    }
    for (force, found) in NAMES.iter().zip(peaks([243.5, 185.4], 110.0)) {
        values.put(format!("passing/worked/{force}"), found, "");
    }
    by_table(values);
    in_a_worksheet(values);
}

/// Computes the forces of parallel passing that another program's worksheets printed, in feet, slugs and pounds-force.
fn in_a_worksheet(values: &mut Values) {
    let at = |lengths: [f64; 2], areas: [f64; 2], place: [f64; 2], density: f64, speed: f64| {
        let [at_rest, passing] =
            [0, 1].map(|k| Sections::parabola(lengths[k], areas[k]).expect("a good ship"));
        let pose = Pose::new(vec2(place[0], place[1]), 0.0);
        let velocity_mps = vec2(speed, 0.0);
        let passing = PassingShip { sections: &passing, pose, velocity_mps };
        force(&at_rest, Pose::new(Vec2::ZERO, 0.0), &passing, density, 1.0)
    };
    let abreast = at([658.0, 902.2], [1.0, 1.0], [0.0, 0.25 * 658.0], 1.0, 1.0);
    values.put("passing/worksheet/sway", abreast[1] * 658.0 * 658.0, "");
    for (name, along_ft) in [("abreast", 0.0), ("length", -941.109), ("two_lengths", -1882.218)] {
        let place = [along_ft, 364.042];
        let found = at([941.109; 2], [8103.879; 2], place, 1.9905, 6.0);
        for (force, found) in NAMES.iter().zip(found) {
            let unit = if *force == "yaw" { "lbf ft" } else { "lbf" };
            values.put(format!("passing/workbook/{name}/{force}"), found, unit);
        }
    }
}

/// Computes the worked case of a passing ship with the coefficients of its source.
fn by_table(values: &mut Values) {
    let areas_m2 = [0.98 * 39.0 * 15.3, 0.98 * 25.8 * 6.8];
    let speed_mps = 10.0 * KNOT_MPS;
    let unit_n =
        DENSITY_KGPM3 * speed_mps * speed_mps * areas_m2[0] * areas_m2[1] / (185.4 * 185.4);
    let mean_beam_m = 0.5 * (39.0 + 25.8);
    let by = factors(15.3 / 20.0, (110.0 - mean_beam_m) / mean_beam_m, Berth::Open);
    let [surge, sway, yaw] = by.expect("depth and gap are within their ranges");
    values.put("passing/worked_by_table/surge", 1e-3 * unit_n * 0.299 * surge, "kN");
    values.put("passing/worked_by_table/sway", 1e-3 * unit_n * 1.064 * sway, "kN");
    values.put("passing/worked_by_table/yaw", 1e-6 * unit_n * 243.5 * 0.204 * yaw, "MN·m");
}

/// The largest surge and sway force, divided by ρU²S₁S₂/L₂², and the largest yaw moment, divided by ρU²S₁S₂/L₂² times
/// L₁, of the force that a passing ship (2) exerts on a ship at rest (1).
fn peaks(lengths_m: [f64; 2], across_m: f64) -> [f64; 3] {
    let [at_rest, passing] =
        lengths_m.map(|length_m| Sections::parabola(length_m, 1.0).expect("a good ship"));
    let unit_n = DENSITY_KGPM3 / (lengths_m[1] * lengths_m[1]);
    let units = [unit_n, unit_n, unit_n * lengths_m[0]];
    let mut most = [0.0_f64; 3];
    for place in 0..=PLACES {
        let along_m = f64::from(place) / f64::from(PLACES) * 0.8 * (lengths_m[0] + lengths_m[1]);
        let passing = PassingShip {
            sections: &passing,
            pose: Pose::new(vec2(along_m, across_m), 0.0),
            velocity_mps: vec2(1.0, 0.0),
        };
        let found = force(&at_rest, Pose::new(Vec2::ZERO, 0.0), &passing, DENSITY_KGPM3, 1.0);
        for (most, (found, unit)) in most.iter_mut().zip(found.iter().zip(units)) {
            *most = greater(*most, found.abs() / unit);
        }
    }
    most
}
