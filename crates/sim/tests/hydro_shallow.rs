//! Shallow water: the factors, and their effect on turns and zig-zags.
//!
//! Manoeuvres are compared with trials of tankers and container ships. The trials agree on this: turns are a little
//! wider at h/T 1.5, and wider by half or more at 1.2. In the turns ships drift less and lose less speed. Overshoots
//! are smaller at 1.2; at 1.5 those of Esso Osaka were about as in deep water.
//! `validation/shallow_water.toml` has the numbers.

use crate::ships;

use fenderline_scenario::VesselLibrary;
use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::manoeuvres::{Approach, TurningCircle, turning_circle, zig_zag};
use fenderline_sim::hydro::shallow::{CorrectionSet, Corrections, HullFactors, MassFactors};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{
    Controls, EstimateMethod, Known, Mmg, Model3, Particulars, Parts, SternCoefficients, SternGear,
    Velocity, Water, estimated_by, polynomial_weight,
};
use ships::{esso_osaka_model, kcs, kvlcc2};

/// A step, over the time in which she sails her own length. Half of this step changes no ratio by a thousandth.
const STEP: f64 = 0.01;

/// Every vessel with a propeller and a rudder, and her speed of approach. For a vessel without a speed of approach it
/// is a Froude number of 0.15.
fn steered() -> Vec<(String, Vessel, f64)> {
    let library = VesselLibrary::built_in();
    let mut all = Vec::new();
    for data in library.vessels() {
        let vessel = data.trial();
        if vessel.ship.propulsion.is_none() {
            continue;
        }
        let usual_mps = 0.15 * (9.81 * vessel.ship.particulars.length_m).sqrt();
        let speed_mps = vessel.approach_mps.unwrap_or(usual_mps);
        all.push((data.name.clone(), vessel, speed_mps));
    }
    assert!(all.len() >= 6, "the library has ships");
    all
}

/// A ship that is a reference in deep water, with data from her particulars alone.
struct ByParticulars {
    name: &'static str,
    /// Length, beam, draught (m).
    hull_m: [f64; 3],
    block: f64,
    propeller_m: f64,
    rudder_m2: f64,
    speed_mps: f64,
    rate_degps: f64,
}

/// The particulars are those of `validation/estimated_ships.toml`, which names their source. Esso Osaka's are those of
/// the ship, from the toolbox MSS (cybergalactic/MSS, EssoOsaka.m), with the 7 knots of her trials.
const BY_PARTICULARS: [ByParticulars; 6] = [
    of("KCS", [230.0, 32.2, 10.8], 0.651, [7.9, 45.28], [12.35, 2.32]),
    of("KVLCC2", [320.0, 58.0, 20.8], 0.81, [9.86, 112.5], [7.97, 2.34]),
    of("Esso Osaka", [325.0, 53.0, 21.73], 0.831, [9.1, 119.817], [3.6, 2.34]),
    of("S175", [175.0, 25.4, 8.5], 0.5617, [6.533, 33.0376], [8.3767, 5.0]),
    of("tanker of 190 000 dwt", [304.8, 47.17, 18.46], 0.829, [9.14, 88.8], [8.2258, 2.33]),
    of("Mariner", [160.93, 23.17, 7.47], 0.597, [6.706, 21.6], [7.7175, 5.0]),
];

const fn of(
    name: &'static str,
    hull_m: [f64; 3],
    block: f64,
    [propeller_m, rudder_m2]: [f64; 2],
    [speed_mps, rate_degps]: [f64; 2],
) -> ByParticulars {
    ByParticulars { name, hull_m, block, propeller_m, rudder_m2, speed_mps, rate_degps }
}

impl ByParticulars {
    fn estimated(&self) -> (String, Vessel, f64) {
        let [length_m, beam_m, draught_m] = self.hull_m;
        let hull = Particulars::from_block(length_m, beam_m, draught_m, self.block);
        // The usual value.
        let aspect_ratio = 1.6;
        let gear = SternGear {
            propeller_m: self.propeller_m,
            rudder_m2: self.rudder_m2,
            propeller_to_span: self.propeller_m / (self.rudder_m2 * aspect_ratio).sqrt(),
            aspect_ratio,
            own: SternCoefficients::default(),
        };
        let known = Known {
            particulars: hull.expect("a ship"),
            added_mass: None,
            polynomial: None,
            low_speed: None,
            gear: Some(gear),
        };
        let steering = RateLimited {
            value: 0.0,
            rate_per_s: self.rate_degps.to_radians(),
            stop: 35_f64.to_radians(),
        };
        let ship = estimated_by(EstimateMethod::YoshimuraMasumoto, &known).expect("a ship").model;
        let vessel = Vessel { ship, approach_mps: Some(self.speed_mps), steering, ..kcs() };
        (format!("{}, estimated", self.name), vessel, self.speed_mps)
    }
}

struct Done {
    turn: TurningCircle,
    /// First overshoots of the zig-zags 10°/10° and 20°/20° (°).
    overshoots_deg: [f64; 2],
}

fn carried_out(vessel: &Vessel, ship: Mmg, speed_mps: f64) -> Done {
    let model = Model3::new(ship, Water::SEA);
    let step_s = STEP * ship.particulars.length_m / speed_mps;
    let approach = Approach::at(&model, speed_mps, vessel.steering, step_s).expect("she holds it");
    let turn = turning_circle(&model, &approach, 35_f64.to_radians()).expect("she turns");
    let overshoots_deg = [10.0_f64, 20.0].map(|deg| {
        let angle_rad = deg.to_radians();
        let run = zig_zag(&model, &approach, angle_rad, angle_rad).expect("she answers");
        run.first_overshoot_rad.to_degrees()
    });
    Done { turn, overshoots_deg }
}

/// Tactical diameter over that in deep water, with the rudder at 35°. It is 1.0 to 1.45 at h/T 1.5, and 1.3 to 1.95 at
/// 1.2. This holds for every ship of the library, and for every reference ship from her particulars. Drift, speed, rate
/// of turn and overshoots change as in trials.
#[test]
fn every_ship_manoeuvres_in_shallow_water_as_in_trials() {
    for (name, vessel, speed_mps) in
        steered().into_iter().chain(BY_PARTICULARS.iter().map(ByParticulars::estimated))
    {
        let draught_m = vessel.ship.particulars.draught_m;
        let at =
            |ratio: f64| carried_out(&vessel, vessel.ship.at_depth(ratio * draught_m), speed_mps);
        let (deep, half, fifth) = (carried_out(&vessel, vessel.ship, speed_mps), at(1.5), at(1.2));
        let wider = |done: &Done| done.turn.tactical_diameter_m / deep.turn.tactical_diameter_m;
        let steady = [&deep, &half, &fifth].map(|done| done.turn.steady);
        let drifts_deg = steady.map(|turn| turn.drift_rad.to_degrees());
        let speeds = steady.map(|turn| turn.speed_ratio);
        let overshoots_deg = [&deep, &half, &fifth].map(|done| done.overshoots_deg);
        println!(
            "{name}: TD/TD deep {:.2} {:.2}, drift {drifts_deg:.1?}°, U/U0 {speeds:.2?}, overshoots {overshoots_deg:.1?}°",
            wider(&half),
            wider(&fifth)
        );
        assert!((1.0..=1.45).contains(&wider(&half)), "{name}");
        assert!((1.3..=1.95).contains(&wider(&fifth)), "{name}");
        assert!(fifth.turn.advance_m > half.turn.advance_m, "{name}: advance");
        assert!(drifts_deg[1] < drifts_deg[0] && drifts_deg[2] < 0.6 * drifts_deg[1], "{name}");
        assert!(speeds[1] > speeds[0] && speeds[2] > speeds[1], "{name}");
        for angle in 0..2 {
            let [deep, half, fifth] = overshoots_deg.map(|overshoots_deg| overshoots_deg[angle]);
            assert!(half < deep && fifth < half, "{name}: overshoots {deep} {half} {fifth}");
        }
        let steps = [3.0, 2.5, 2.0, 1.7, 1.5, 1.4, 1.3, 1.25, 1.2, 1.15, 1.1].map(|ratio| {
            let ship = vessel.ship.at_depth(ratio * draught_m);
            let model = Model3::new(ship, Water::SEA);
            let step_s = STEP * ship.particulars.length_m / speed_mps;
            let approach = Approach::at(&model, speed_mps, vessel.steering, step_s).expect("held");
            turning_circle(&model, &approach, 35_f64.to_radians())
                .expect("she turns")
                .tactical_diameter_m
        });
        // The values change steadily between these depths.
        let grows = steps.windows(2).all(|pair| pair[1] > 0.97 * pair[0]);
        assert!(grows && steps[10] < 3.5 * steps[0], "{name}: {steps:.0?}");
    }
}

fn hull_factors(factors: &HullFactors) -> [f64; 17] {
    let HullFactors { resistance, x_vv, x_vr, x_rr, x_vvvv, y_v, y_r, y_vvv, .. } = *factors;
    let HullFactors { y_vvr, y_vrr, y_rrr, n_v, n_r, n_vvv, n_vvr, n_vrr, n_rrr, .. } = *factors;
    [
        resistance, x_vv, x_vr, x_rr, x_vvvv, y_v, y_r, y_vvv, y_vvr, y_vrr, y_rrr, n_v, n_r,
        n_vvv, n_vvr, n_vrr, n_rrr,
    ]
}

#[test]
fn factors_are_one_in_deep_water_and_grow_as_the_water_gets_shallower() {
    for vessel in [kvlcc2(), kcs(), esso_osaka_model()] {
        let ship = vessel.ship.particulars;
        let at =
            |ratio: f64| Corrections::of(CorrectionSet::Combined, &ship, ratio * ship.draught_m);
        let deep = at(f64::INFINITY);
        assert!(hull_factors(&deep.hull).iter().all(|factor| (factor - 1.0).abs() < 1e-12));
        assert_eq!(deep.mass, MassFactors { surge: 1.0, sway: 1.0, yaw: 1.0 });
        let stern = deep.stern;
        assert_eq!([stern.driving, stern.wake, stern.inflow, stern.straightening], [1.0; 4]);
        for set in
            [CorrectionSet::EffectiveAspectRatio, CorrectionSet::Ankudinov, CorrectionSet::Taimuri]
        {
            let hull = Corrections::of(set, &ship, f64::INFINITY).hull;
            assert!(hull_factors(&hull).iter().all(|factor| (factor - 1.0).abs() < 1e-12));
        }
        // From three draughts on, each factor grows, but by no more than the clearance decreases.
        let mut before = hull_factors(&at(3.0).hull);
        for hundredths in (110..300).rev() {
            let ratio = f64::from(hundredths) / 100.0;
            let now = hull_factors(&at(ratio).hull);
            for (before, now) in before.iter().zip(&now) {
                let most = (ratio + 0.01 - 1.0) / (ratio - 1.0);
                assert!(*now >= 0.999 * before && now / before < most, "{before} {now} at {ratio}");
            }
            before = now;
        }
        // Below 1.1 draughts the factors are constant, also for a ship aground.
        assert_eq!(at(1.0999), at(1.1));
        assert_eq!(at(-3.0), at(1.1));
    }
}

/// UFC's drag abeam applies to a ship that crabs, but not in a turn.
#[test]
fn the_drag_of_a_berthed_ship_stays_out_of_the_turn() {
    for vessel in [kvlcc2(), kcs(), esso_osaka_model()] {
        let deep = vessel.ship;
        let ship = deep.particulars;
        let there = deep.at_depth(1.2 * ship.draught_m);
        let hull = |ship: &Mmg, velocity: &Velocity| {
            let Parts { hull, .. } = ship.parts(velocity, &Controls::default(), Water::SEA);
            hull
        };
        let across = Velocity { sway_mps: 0.5, ..Velocity::default() };
        let drag = deep.hull.low_speed.cross_flow.drag_coefficient;
        let by_hand = (drag + (3.2 - drag) / 1.44) / drag;
        let grown = hull(&there, &across).sway_n / hull(&deep, &across).sway_n;
        assert!((grown / by_hand - 1.0).abs() < 1e-9, "{grown} {by_hand}");
        // β is 11° and r' is 0.8, more than in a hard turn in this depth. The drag coefficient at her berth has no part
        // in the force.
        let turning =
            Velocity { surge_mps: 3.0, sway_mps: -0.6, yaw_radps: 0.8 * 3.1 / ship.length_m };
        assert_eq!(polynomial_weight(&turning, ship.length_m, 1.0 / 1.2), 1.0);
        let mut other = there;
        other.hull.low_speed.cross_flow.drag_coefficient *= 2.0;
        assert_eq!(hull(&other, &turning), hull(&there, &turning));
    }
}
