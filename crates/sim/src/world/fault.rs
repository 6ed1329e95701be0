//! What fails on a vessel during a run.

/// Faults of a vessel that stand: plain data. All off at the start of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// The rudder stays where it is; azimuth units do not turn.
    pub rudder_stuck: bool,
    /// The shaft runs down to a stop, azimuth units give no thrust.
    pub engine_lost: bool,
    /// Tunnel thrusters give no thrust.
    pub thrusters_lost: bool,
    /// All of these at once: no power for anything.
    pub blackout: bool,
}

impl Faults {
    /// Does nothing move the rudder?
    #[must_use]
    pub fn steering_stands(&self) -> bool {
        self.rudder_stuck || self.blackout
    }

    /// Does nothing drive shaft and azimuth units?
    #[must_use]
    pub fn no_engine(&self) -> bool {
        self.engine_lost || self.blackout
    }

    /// Does nothing drive the tunnel thrusters?
    #[must_use]
    pub fn no_thrusters(&self) -> bool {
        self.thrusters_lost || self.blackout
    }
}
