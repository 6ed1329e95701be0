//! The quantities of a weather: their columns, and the keys of the scenario that they set.

/// What acts on the ship.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agent {
    /// Waves.
    Waves,
    /// Wind.
    Wind,
    /// Current.
    Current,
    /// Level of the water.
    Level,
}

/// What a quantity of an agent is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Strength of the agent: height or speed.
    Strength,
    /// Period of waves.
    Period,
    /// Direction (deg).
    Direction,
    /// A height above datum.
    Level,
}

/// A quantity.
#[derive(Debug, PartialEq)]
pub struct Quantity {
    /// Column of the weather's file.
    pub(super) column: &'static str,
    /// Name of the variable in the campaign's table.
    pub name: &'static str,
    /// Unit of both.
    pub unit: &'static str,
    /// Key of the scenario.
    pub(super) key: &'static str,
    pub(super) agent: Agent,
    pub(super) role: Role,
    /// Least and greatest value.
    pub(super) range: [f64; 2],
}

/// All quantities. The quantities of an agent stand together, and a file must have all of them or none. The ranges are
/// the ranges of the scenario's keys.
pub(super) static QUANTITIES: [Quantity; 8] = [
    Quantity {
        column: "hs_m",
        name: "wave_height",
        unit: "m",
        key: "environment.waves.height",
        agent: Agent::Waves,
        role: Role::Strength,
        range: [0.0, 30.0],
    },
    Quantity {
        column: "tp_s",
        name: "wave_period",
        unit: "s",
        key: "environment.waves.period",
        agent: Agent::Waves,
        role: Role::Period,
        range: [0.5, 40.0],
    },
    Quantity {
        column: "wave_from_deg",
        name: "wave_from",
        unit: "deg",
        key: "environment.waves.from",
        agent: Agent::Waves,
        role: Role::Direction,
        range: [-360.0, 360.0],
    },
    Quantity {
        column: "wind_speed_mps",
        name: "wind_speed",
        unit: "m/s",
        key: "environment.wind.speed",
        agent: Agent::Wind,
        role: Role::Strength,
        range: [0.0, 120.0],
    },
    Quantity {
        column: "wind_from_deg",
        name: "wind_from",
        unit: "deg",
        key: "environment.wind.from",
        agent: Agent::Wind,
        role: Role::Direction,
        range: [-360.0, 360.0],
    },
    Quantity {
        column: "current_speed_mps",
        name: "current_speed",
        unit: "m/s",
        key: "environment.current.speed",
        agent: Agent::Current,
        role: Role::Strength,
        range: [0.0, 15.0],
    },
    Quantity {
        column: "current_towards_deg",
        name: "current_towards",
        unit: "deg",
        key: "environment.current.towards",
        agent: Agent::Current,
        role: Role::Direction,
        range: [-360.0, 360.0],
    },
    Quantity {
        column: "level_m",
        name: "water_level",
        unit: "m",
        key: "environment.tide.level",
        agent: Agent::Level,
        role: Role::Level,
        range: [-30.0, 30.0],
    },
];

/// Columns with the time of a row, or the number of hours for which the row stands.
pub(super) const TIME: &str = "time";
pub(super) const SECONDS: &str = "t_s";
pub(super) const HOURS: &str = "hours";
pub(super) const SHARE: &str = "share";

impl Agent {
    /// Effect of the strength on the ship: waves by their height, wind and current by the square of their speed.
    pub(super) fn load(self, strength: f64) -> f64 {
        match self {
            Agent::Waves | Agent::Level => strength,
            Agent::Wind | Agent::Current => strength * strength,
        }
    }

    /// Key of the seed of the agent's random phases, if it has random phases, and the name of the variable.
    pub(super) fn seed(self) -> Option<(&'static str, &'static str)> {
        match self {
            Agent::Waves => Some(("wave_seed", "environment.waves.seed")),
            Agent::Wind => Some(("gust_seed", "environment.wind.seed")),
            Agent::Current | Agent::Level => None,
        }
    }

    /// In words.
    #[must_use]
    pub fn word(self) -> &'static str {
        match self {
            Agent::Waves => "waves",
            Agent::Wind => "wind",
            Agent::Current => "current",
            Agent::Level => "water level",
        }
    }
}
