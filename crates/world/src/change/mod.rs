//! Changes of a running simulation that nobody orders: weather, faults, lines that part, tugs that drop out. Changes
//! are planned for times in the set-up ([`crate::world::WorldSetup::planned`]), or come from outside
//! (`Simulation::change` of the crate `fenderline-sim`).

mod check;
mod error;
mod ramp;

pub use self::error::ChangeError;
pub use self::ramp::{Flow, Ramp, Ramps, fog_m};

use crate::world::Fault;

/// A change of a simulation. Indices are those of [`crate::world::WorldSetup`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The mean wind 10 m above the water: speed (m/s) and direction from which it comes (rad), at once or over a time
    /// (s). Gusts continue, in proportion to the new mean wind. A wind given as a time series becomes steady.
    Wind {
        /// Speed (m/s).
        speed_mps: f64,
        /// Direction from which it comes (rad).
        from_rad: f64,
        /// Duration of the change (s); 0: at once.
        over_s: f64,
    },
    /// A uniform current in place of the present one: speed (m/s) and direction to which it sets (rad), at once or over a time (s).
    Current {
        /// Speed (m/s).
        speed_mps: f64,
        /// Direction to which it sets (rad).
        to_rad: f64,
        /// Duration of the change (s); 0: at once.
        over_s: f64,
        /// A change over a time begins with the present current at this vessel; `None`: at the origin.
        at: Option<usize>,
    },
    /// The visibility (m), at once or over a time (s); `None`: clear. It exerts no force.
    Visibility {
        /// The distance (m).
        distance_m: Option<f64>,
        /// Duration of the change (s); 0: at once.
        over_s: f64,
    },
    /// A fault of a vessel begins or ends.
    Fault {
        /// The vessel.
        vessel: usize,
        /// The fault.
        fault: Fault,
        /// Whether the fault begins; false: it ends.
        on: bool,
    },
    /// One thruster or azimuth unit of a vessel trips, or comes back.
    Thruster {
        /// The vessel.
        vessel: usize,
        /// Number of the unit: thrusters first, then azimuth units.
        unit: usize,
        /// Whether the unit trips; false: it comes back.
        on: bool,
    },
    /// A line parts.
    PartLine(usize),
    /// A vector tug drops out, or comes back.
    TugOut {
        /// The tug.
        tug: usize,
        /// Whether the tug drops out; false: she comes back.
        on: bool,
    },
}

/// A change at a time of the run. The change takes effect in the step that contains its time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlannedChange {
    /// The time (s).
    pub at_s: f64,
    /// The change.
    pub change: Change,
}

impl Change {
    /// Longest duration of a change (s).
    pub const LONGEST_S: f64 = 7200.0;
    /// Least and greatest visibility (m).
    pub const VISIBILITY_M: [f64; 2] = [50.0, 50e3];
}

/// The changes of a simulation that are under way: plain data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Changes of wind, current and visibility that take time.
    pub ramps: Ramps,
    /// For each planned change of the set-up, whether its time has come.
    pub taken: Vec<bool>,
    /// Lines that a change has parted since the last step.
    pub parted: Vec<usize>,
    /// Lines that a change should have parted, but that were not fast.
    pub not_parted: Vec<usize>,
}
