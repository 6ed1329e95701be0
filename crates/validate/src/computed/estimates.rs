//! Ships that are estimated from their main particulars alone, by both estimation methods: the standard manoeuvres of
//! six ships for which there are reference values.

use fenderline_sim::hydro::actuator::RateLimited;
use fenderline_sim::hydro::manoeuvres::{turning_circle, zig_zag};
use fenderline_sim::hydro::vessels::Vessel;
use fenderline_sim::hydro::{
    EstimateMethod, Known, Particulars, SternCoefficients, SternGear, estimated_by,
};

use super::Values;
use super::manoeuvres::Trial;
use super::ships::vessel;

/// The estimation methods (routes) that are compared, with their names in `validation/estimated_ships.toml`.
pub(crate) const ROUTES: [(&str, EstimateMethod); 2] =
    [("yoshimura_masumoto", EstimateMethod::YoshimuraMasumoto), ("clarke", EstimateMethod::Clarke)];

/// A ship for which there are reference numbers of her manoeuvres. The errors of the estimation methods are computed
/// over the reference ships.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ReferenceShip {
    Kcs,
    Kvlcc2,
    EssoOsaka,
    S175,
    Tanker190,
    Mariner,
}

impl ReferenceShip {
    pub(crate) const ALL: [ReferenceShip; 6] = [
        ReferenceShip::Kcs,
        ReferenceShip::Kvlcc2,
        ReferenceShip::EssoOsaka,
        ReferenceShip::S175,
        ReferenceShip::Tanker190,
        ReferenceShip::Mariner,
    ];

    /// The ship's name in `validation/estimated_ships.toml`.
    pub(crate) fn name(self) -> &'static str {
        match self {
            ReferenceShip::Kcs => "kcs",
            ReferenceShip::Kvlcc2 => "kvlcc2",
            ReferenceShip::EssoOsaka => "esso_osaka",
            ReferenceShip::S175 => "s175",
            ReferenceShip::Tanker190 => "tanker_190",
            ReferenceShip::Mariner => "mariner",
        }
    }

    /// The name of a second reference for the ship in `validation/estimated_ships.toml`. The second reference does not
    /// count in the errors of the estimates.
    fn second_reference(self) -> Option<&'static str> {
        match self {
            ReferenceShip::Kvlcc2 => Some("kvlcc2_tests"),
            ReferenceShip::Mariner => Some("mariner_momentary"),
            _ => None,
        }
    }
}

/// The measures of the manoeuvres that are compared, with their units.
pub(crate) const MEASURES: [(&str, &str); 4] =
    [("advance", "L"), ("diameter", "L"), ("overshoot_10", "°"), ("overshoot_20", "°")];

/// Time step of a manoeuvre, divided by the time in which the ship sails her own length.
const STEP: f64 = 0.005;
/// Aspect ratio of a rudder for which the source gives none: a usual value.
const USUAL_ASPECT: f64 = 1.6;

pub(super) fn compute(values: &mut Values) {
    for (name, route) in ROUTES {
        compute_route(values, name, route);
    }
}

/// Computes all measures of all ships by one estimation method.
pub(crate) fn compute_route(values: &mut Values, name: &str, route: EstimateMethod) {
    for ship in ReferenceShip::ALL {
        let measures = measured(&estimate_of(ship, route));
        for called in std::iter::once(ship.name()).chain(ship.second_reference()) {
            for ((measure, unit), value) in MEASURES.iter().zip(measures) {
                values.put(format!("estimated/{name}/{called}/{measure}"), value, unit);
            }
        }
    }
}

/// Measures an estimated ship's manoeuvres, in the order of [`MEASURES`]. An estimated ship behaves alike to both
/// sides, so that one side is enough.
fn measured(vessel: &Vessel) -> [f64; 4] {
    let trial = Trial::stepped(vessel, STEP);
    let turn = turning_circle(&trial.model, &trial.approach, 35_f64.to_radians());
    let turn = turn.expect("she turns");
    let overshoot_deg = |angle_deg: f64| {
        let angle_rad = angle_deg.to_radians();
        let run = zig_zag(&trial.model, &trial.approach, angle_rad, angle_rad);
        run.expect("she answers her rudder").first_overshoot_rad.to_degrees()
    };
    [
        turn.advance_m / trial.length_m,
        turn.tactical_diameter_m / trial.length_m,
        overshoot_deg(10.0),
        overshoot_deg(20.0),
    ]
}

/// Estimates a ship from the data that a user without tests would have.
pub(super) fn estimate_of(ship: ReferenceShip, route: EstimateMethod) -> Vessel {
    let of = |known: &Known| estimated_by(route, known).expect("a ship").model;
    let library = |key: &str| {
        let own = vessel(key);
        let propulsion = own.ship.propulsion.expect("she has a propeller");
        let (rudder, gradient) = (propulsion.rudder, propulsion.rudder.lift_gradient);
        let gear = SternGear {
            propeller_m: propulsion.propeller.diameter_m,
            rudder_m2: rudder.area_m2,
            propeller_to_span: rudder.propeller_to_span,
            // Fujii's gradient, the other way round.
            aspect_ratio: 2.25 * gradient / (6.13 - gradient),
            own: SternCoefficients::default(),
        };
        Vessel { ship: of(&of_particulars(own.ship.particulars, gear)), ..own }
    };
    match ship {
        ReferenceShip::Kcs => library("kcs"),
        ReferenceShip::Kvlcc2 => library("kvlcc2"),
        ReferenceShip::EssoOsaka => library("esso-osaka"),
        // Read in the toolbox MSS; the speed is that of 80 rpm.
        ReferenceShip::S175 => {
            let hull = particulars([175.0, 25.4, 8.5], 21_222.0);
            let gear = gear(6.533, 33.0376, 1.8219);
            other(of(&of_particulars(hull, gear)), 8.3767, 5.0)
        }
        // Length and draught read in the toolbox MSS; beam and volume recalled; propeller and rudder by her own forces,
        // as validation/independent/reference_ships.py has them.
        ReferenceShip::Tanker190 => {
            let hull = particulars([304.8, 47.17, 18.46], 220_000.0);
            let gear = gear(9.14, 88.8, USUAL_ASPECT);
            other(of(&of_particulars(hull, gear)), 8.2258, 2.33)
        }
        // Length and mass read in the toolbox MSS; beam, draught and propeller recalled; the rudder as the tanker's.
        ReferenceShip::Mariner => {
            let volume_m3 = 0.007_98 * 0.5 * 160.93 * 160.93 * 160.93;
            let hull = particulars([160.93, 23.17, 7.47], volume_m3);
            let gear = gear(6.706, 21.6, USUAL_ASPECT);
            other(of(&of_particulars(hull, gear)), 7.7175, 5.0)
        }
    }
}

fn of_particulars(particulars: Particulars, gear: SternGear) -> Known {
    Known { particulars, added_mass: None, polynomial: None, low_speed: None, gear: Some(gear) }
}

fn particulars([length_m, beam_m, draught_m]: [f64; 3], volume_m3: f64) -> Particulars {
    let block = volume_m3 / (length_m * beam_m * draught_m);
    Particulars::from_block(length_m, beam_m, draught_m, block).expect("she floats")
}

fn gear(propeller_m: f64, rudder_m2: f64, aspect_ratio: f64) -> SternGear {
    let span_m = (rudder_m2 * aspect_ratio).sqrt();
    SternGear {
        propeller_m,
        rudder_m2,
        propeller_to_span: propeller_m / span_m,
        aspect_ratio,
        own: SternCoefficients::default(),
    }
}

/// Makes a vessel that is not in the data, from her model, her speed of approach (m/s) and her rudder's rate (°/s).
fn other(ship: fenderline_sim::hydro::Mmg, approach_mps: f64, rate_degps: f64) -> Vessel {
    Vessel {
        ship,
        approach_mps: Some(approach_mps),
        steering: RateLimited {
            value: 0.0,
            rate_per_s: rate_degps.to_radians(),
            stop: 35_f64.to_radians(),
        },
        ..vessel("kcs")
    }
}
