//! Faults of a vessel's machinery and instruments: the vessel accepts orders but does not carry them out, or displays
//! stay frozen.

use crate::order::Word;

/// The faults that a vessel has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Faults {
    /// The rudder stays at its present angle, and azimuth units do not turn.
    pub rudder_stuck: bool,
    /// The rudder does not follow the helm: the rudder runs to its stop on the side of the order. With the order
    /// amidships, the rudder stays at its present angle.
    pub follow_up_lost: bool,
    /// The shaft slows down until it stops, and azimuth units give no thrust.
    pub engine_lost: bool,
    /// Tunnel thrusters give no thrust.
    pub thrusters_lost: bool,
    /// The vessel has no power, with the effect of all the faults above together.
    pub blackout: bool,
    /// Single thrusters and azimuth units that have tripped: they give no thrust.
    pub tripped: Tripped,
    /// The heading on the displays on board stays frozen. The simulation goes on with the true heading.
    pub heading_frozen: bool,
    /// The speeds on the displays on board stay frozen.
    pub speed_frozen: bool,
    /// The position on the displays on board stays frozen.
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
    /// True for a fault of an instrument. The displays on board do not report such a fault.
    #[must_use]
    pub fn is_of_instrument(self) -> bool {
        matches!(self, Fault::HeadingFrozen | Fault::SpeedFrozen | Fault::PositionFrozen)
    }
}

/// The thrusters and azimuth units of a vessel that have tripped. The units are numbered: first the thrusters, then the
/// azimuth units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Tripped(u64);

impl Tripped {
    /// Number of units that this type can hold.
    pub const MOST: usize = 64;

    /// True if the unit of this number has tripped.
    #[must_use]
    pub fn has(self, unit: usize) -> bool {
        unit < Tripped::MOST && self.0 >> unit & 1 == 1
    }

    /// The same set of units, but with the unit of this number tripped or in order again. A number of [`Tripped::MOST`]
    /// or more changes nothing.
    #[must_use]
    pub fn with(self, unit: usize, tripped: bool) -> Tripped {
        let bit = if unit < Tripped::MOST { 1 << unit } else { 0 };
        Tripped(if tripped { self.0 | bit } else { self.0 & !bit })
    }
}

impl Faults {
    /// True if the vessel has this fault.
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

    /// The faults that are on, except those of single units.
    pub fn active(&self) -> impl Iterator<Item = Fault> + use<> {
        let own = *self;
        Fault::ALL.iter().copied().filter(move |fault| own.has(*fault))
    }

    /// True if the rudder does not move and the azimuth units do not turn.
    #[must_use]
    pub fn steering_failed(&self) -> bool {
        self.rudder_stuck || self.blackout
    }

    /// True if the shaft and the azimuth units have no power.
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
