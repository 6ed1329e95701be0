//! Changes of a running simulation that nobody orders: weather, faults, lines that part, tugs that drop out. Changes
//! are planned for times in the set-up ([`crate::world::WorldSetup::planned`]), or are made by a call of a program
//! (`Simulation::change` of the crate `fenderline-sim`).

mod check;
mod error;
mod ramp;

pub use self::error::ChangeError;
pub use self::ramp::{Flow, Ramp, Ramps, fog_m};

use crate::world::Fault;

/// A change of weather, faults, lines or tugs in a running simulation. The indices in a change are indices of lists in
/// [`crate::world::WorldSetup`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Change {
    /// The mean wind 10 m above the water changes, at once or over a time: its speed (m/s), and the direction from
    /// which it comes (rad). After a change of the wind, gusts continue in proportion to the new mean wind. A wind
    /// given as a time series becomes steady.
    Wind {
        /// Speed of the wind after the change (m/s).
        speed_mps: f64,
        /// Direction from which the wind comes after the change (rad).
        from_rad: f64,
        /// Duration of the change (s); with 0 the change is sudden.
        over_s: f64,
    },
    /// The current becomes uniform, at once or over a time, with a speed (m/s) and a direction to which it sets (rad).
    Current {
        /// Speed of the current after the change (m/s).
        speed_mps: f64,
        /// Direction to which the current sets after the change (rad).
        to_rad: f64,
        /// Duration of the change (s); with 0 the change is sudden.
        over_s: f64,
        /// Index of a vessel: a change over a time begins with the present current at the place of this vessel; with
        /// `None`, at the scenario's origin.
        at: Option<usize>,
    },
    /// The visibility changes, at once or over a time. The visibility exerts no force.
    Visibility {
        /// Distance that people can see after the change (m); `None` for clear visibility.
        distance_m: Option<f64>,
        /// Duration of the change (s); with 0 the change is sudden.
        over_s: f64,
    },
    /// A fault of a vessel begins or ends.
    Fault {
        /// Index of the vessel.
        vessel: usize,
        /// The fault.
        fault: Fault,
        /// True if the fault begins, false if the fault ends.
        on: bool,
    },
    /// One thruster or azimuth unit of a vessel fails, or works again.
    Thruster {
        /// Index of the vessel.
        vessel: usize,
        /// Number of the unit among the vessel's thrusters and azimuth units: thrusters come first, then azimuth units.
        unit: usize,
        /// True if the unit fails, false if it works again.
        on: bool,
    },
    /// A line parts.
    PartLine(usize),
    /// A vector tug drops out, or is available again.
    TugOut {
        /// Index of the vector tug.
        tug: usize,
        /// True if the tug drops out, false if she is available again.
        on: bool,
    },
}

/// A change that is planned for a time of the run. The change takes effect in the step that contains its time.
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
    /// Least and greatest visibility that a change may give (m).
    pub const VISIBILITY_M: [f64; 2] = [50.0, 50e3];
}

/// The changes of a simulation that are under way, as plain data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changes {
    /// Changes of wind, current and visibility that take time.
    pub ramps: Ramps,
    /// For each planned change of the set-up, whether the time of the change has come.
    pub taken: Vec<bool>,
    /// Lines that a change has parted since the last step.
    pub parted: Vec<usize>,
    /// Lines that a change should have parted since the last step, but that were not fast.
    pub not_parted: Vec<usize>,
}
