//! The conditions of the manoeuvres: the water, and the user's options.

use fenderline_sim::constants::{KNOT_MPS, STANDARD_GRAVITY_MPS2};
use fenderline_sim::hydro::Water;
use fenderline_sim::hydro::vessels::Vessel;

use super::depth::Shallow;
use crate::cli::{Manoeuvre, ManoeuvreArgs};
use crate::failure::Failure;

/// Largest Froude number of a manoeuvre. No displacement ship is faster, and no coefficient of the vessels was measured
/// above this number.
const LARGEST_FROUDE: f64 = 0.5;

/// The water.
pub(super) struct Sea {
    /// The water, given by its density.
    pub(super) water: Water,
    /// Whether the vessel is a model in a towing tank.
    pub(super) is_model: bool,
}

impl Sea {
    /// Deep still water: fresh water for a model in a tank, salt water for a ship.
    pub(super) fn of(vessel: &Vessel) -> Sea {
        let is_model = vessel.is_model;
        Sea { water: if is_model { Water::FRESH } else { Water::SEA }, is_model }
    }
}

/// The checked options of the user; where the user gives none, the values of the vessel.
pub(super) struct Conditions {
    /// Speed of approach (m/s).
    pub(super) speed_mps: f64,
    /// Whether the speed of approach is the one in the vessel's data, at which IMO's limits hold.
    pub(super) is_test_speed: bool,
    /// Rudder angle that the user orders (°).
    pub(super) rudder_deg: Option<f64>,
    /// Side force for crabbing that the user orders (N).
    pub(super) push_n: Option<f64>,
    /// Shallow water, if the user asks for it.
    pub(super) shallow: Option<Shallow>,
}

impl Conditions {
    /// From the command line.
    ///
    /// # Errors
    /// Fails if no chosen manoeuvre uses an option, if the rudder angle is beyond the stop, or if the speed is higher
    /// than that of any vessel.
    pub(super) fn checked(
        args: &ManoeuvreArgs,
        vessel: &Vessel,
        chosen: &[Manoeuvre],
    ) -> Result<Conditions, Failure> {
        let taken = |option: &str, is_given: bool, takes: fn(Manoeuvre) -> bool| {
            if !is_given || chosen.iter().any(|manoeuvre| takes(*manoeuvre)) {
                return Ok(());
            }
            Err(Failure::input(format_args!("error: {option} has no effect on this manoeuvre")))
        };
        taken("--rudder", args.rudder.is_some(), Manoeuvre::has_rudder)?;
        taken("--speed", args.speed.is_some(), Manoeuvre::has_approach)?;
        taken("--push", args.push.is_some(), |m| m == Manoeuvre::Crabbing)?;
        let stop_deg = vessel.steering.stop.to_degrees();
        // The stop is stored in radians: an order of exactly the stop must not be refused for its last bit.
        if let Some(rudder_deg) = args.rudder.filter(|rudder_deg| *rudder_deg > stop_deg + 1e-9) {
            return Err(Failure::input(format_args!(
                "error: --rudder {rudder_deg}: the rudder of {} stops at {stop_deg:.0}°",
                vessel.origin.title
            )));
        }
        let shallow = args.depth.map(|depth| Shallow::checked(depth, vessel)).transpose()?;
        let ordered_mps = args.speed.map(|speed_kn| speed_kn * KNOT_MPS);
        // Without either, no chosen manoeuvre has an approach.
        let speed_mps = ordered_mps.or(vessel.approach_mps).unwrap_or(0.0);
        let froude = speed_mps / (STANDARD_GRAVITY_MPS2 * vessel.ship.particulars.length_m).sqrt();
        if froude > LARGEST_FROUDE {
            return Err(Failure::input(format_args!(
                "error: --speed: a Froude number of {froude:.2}; the data are valid up to {LARGEST_FROUDE}"
            )));
        }
        Ok(Conditions {
            speed_mps,
            is_test_speed: args.speed.is_none(),
            rudder_deg: args.rudder,
            push_n: args.push.map(|push_kn| push_kn * 1e3),
            shallow,
        })
    }
}
