//! Faults of a vessel's machinery and instruments: orders are accepted but not carried out, or displays stay frozen.

use crate::order::Word;

/// The faults of a vessel.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// The rudder stays where it is; azimuth units do not turn.
    pub rudder_stuck: bool,
    /// The rudder does not follow the helm: it runs to its stop on the side of the order. With the order amidships it
    /// stays where it is.
    pub follow_up_lost: bool,
    /// The shaft runs down to a stop; azimuth units give no thrust.
    pub engine_lost: bool,
    /// Tunnel thrusters give no thrust.
    pub thrusters_lost: bool,
    /// All the faults above at once: the vessel has no power.
    pub blackout: bool,
    /// Single thrusters and azimuth units that have tripped: they give no thrust.
    pub tripped: Tripped,
    /// The heading that is shown on board stays frozen. The simulation goes on with the true heading.
    pub heading_frozen: bool,
    /// The speeds that are shown on board stay frozen.
    pub speed_frozen: bool,
    /// The position that is shown on board stays frozen.
    pub position_frozen: bool,
}

/// A fault by name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fault {
    /// See [`Faults::rudder_stuck`].
    RudderStuck,
    /// See [`Faults::follow_up_lost`].
    FollowUpLost,
    /// See [`Faults::engine_lost`].
    EngineLost,
    /// See [`Faults::thrusters_lost`].
    ThrustersLost,
    /// See [`Faults::blackout`].
    Blackout,
    /// See [`Faults::heading_frozen`].
    HeadingFrozen,
    /// See [`Faults::speed_frozen`].
    SpeedFrozen,
    /// See [`Faults::position_frozen`].
    PositionFrozen,
}

impl Word for Fault {
    const ALL: &'static [Fault] = &[
        Fault::RudderStuck,
        Fault::FollowUpLost,
        Fault::EngineLost,
        Fault::ThrustersLost,
        Fault::Blackout,
        Fault::HeadingFrozen,
        Fault::SpeedFrozen,
        Fault::PositionFrozen,
    ];

    fn word(self) -> &'static str {
        match self {
            Fault::RudderStuck => "rudder_stuck",
            Fault::FollowUpLost => "follow_up_lost",
            Fault::EngineLost => "engine_lost",
            Fault::ThrustersLost => "thrusters_lost",
            Fault::Blackout => "blackout",
            Fault::HeadingFrozen => "heading_frozen",
            Fault::SpeedFrozen => "speed_frozen",
            Fault::PositionFrozen => "position_frozen",
        }
    }
}

impl Fault {
    /// True for a fault of an instrument. Nobody on board is told of such a fault.
    #[must_use]
    pub fn is_of_instrument(self) -> bool {
        matches!(self, Fault::HeadingFrozen | Fault::SpeedFrozen | Fault::PositionFrozen)
    }
}

/// Thrusters and azimuth units of a vessel by number: thrusters first, then azimuth units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tripped(u64);

impl Tripped {
    /// How many units can be told apart.
    pub const MOST: usize = 64;

    /// Whether a unit has tripped.
    #[must_use]
    pub fn has(self, unit: usize) -> bool {
        unit < Tripped::MOST && self.0 >> unit & 1 == 1
    }

    /// These units, with one unit changed to tripped or to in order. A unit beyond [`Tripped::MOST`] changes nothing.
    #[must_use]
    pub fn with(self, unit: usize, tripped: bool) -> Tripped {
        let bit = if unit < Tripped::MOST { 1 << unit } else { 0 };
        Tripped(if tripped { self.0 | bit } else { self.0 & !bit })
    }
}

impl Faults {
    /// Whether a fault is present.
    #[must_use]
    pub fn has(&self, fault: Fault) -> bool {
        let mut copy = *self;
        *copy.flag(fault)
    }

    /// Switches a fault on or off.
    pub fn switch(&mut self, fault: Fault, on: bool) {
        *self.flag(fault) = on;
    }

    fn flag(&mut self, fault: Fault) -> &mut bool {
        match fault {
            Fault::RudderStuck => &mut self.rudder_stuck,
            Fault::FollowUpLost => &mut self.follow_up_lost,
            Fault::EngineLost => &mut self.engine_lost,
            Fault::ThrustersLost => &mut self.thrusters_lost,
            Fault::Blackout => &mut self.blackout,
            Fault::HeadingFrozen => &mut self.heading_frozen,
            Fault::SpeedFrozen => &mut self.speed_frozen,
            Fault::PositionFrozen => &mut self.position_frozen,
        }
    }

    /// The faults that are on, without single units.
    pub fn active(&self) -> impl Iterator<Item = Fault> + use<> {
        let own = *self;
        Fault::ALL.iter().copied().filter(move |fault| own.has(*fault))
    }

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
