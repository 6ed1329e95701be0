//! Faults of a vessel during a run.

/// The active faults of a vessel: plain data. None at the start of a run.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// The rudder stays where it is; azimuth units do not turn.
    pub rudder_stuck: bool,
    /// The rudder does not follow: it runs to its stop on the side of the order, and stays where it is with the order amidships.
    pub follow_up_lost: bool,
    /// The shaft runs down to a stop; azimuth units give no thrust.
    pub engine_lost: bool,
    /// Tunnel thrusters give no thrust.
    pub thrusters_lost: bool,
    /// All of these at once: no power.
    pub blackout: bool,
}

impl Faults {
    /// True if the rudder and the direction of azimuth units do not move.
    #[must_use]
    pub fn steering_failed(&self) -> bool {
        self.rudder_stuck || self.blackout
    }

    /// True if shaft and azimuth units have no power.
    #[must_use]
    pub fn engine_failed(&self) -> bool {
        self.engine_lost || self.blackout
    }

    /// True if the tunnel thrusters have no power.
    #[must_use]
    pub fn thrusters_failed(&self) -> bool {
        self.thrusters_lost || self.blackout
    }
}
