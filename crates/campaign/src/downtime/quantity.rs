//! The quantities of the weather, such as the wind speed: their columns in a weather file, and the scenario's keys that
//! they set.

/// An agent of the weather that acts on the ship, such as the wind.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Agent {
    /// Waves.
    Waves,
    /// Wind.
    Wind,
    /// Current.
    Current,
    /// The water level.
    Level,
}

/// The role of a quantity: what it says about its agent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// Strength of the agent: wave height, wind speed or current speed.
    Strength,
    /// Period of waves.
    Period,
    /// Direction of the agent (deg).
    Direction,
    /// Water level above datum.
    Level,
}

/// A quantity of the weather, such as the wind speed.
#[derive(Debug, PartialEq)]
pub struct Quantity {
    /// Column of the weather's file.
    pub(super) column: &'static str,
    /// Name of the variable in the campaign's table.
    pub name: &'static str,
    /// Unit of the column and of the variable.
    pub unit: &'static str,
    /// Key of the scenario that the quantity sets.
    pub(super) key: &'static str,
    pub(super) agent: Agent,
    pub(super) role: Role,
    /// Smallest and largest value of the quantity.
    pub(super) range: [f64; 2],
}

/// All quantities that a weather file can have. The quantities of one agent stand together; a weather file must have
/// all of them or none. The ranges of the quantities are those of the scenario's keys.
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

/// Name of the column with the time of a row, or with the number of hours for which the row stands.
pub(super) const TIME: &str = "time";
pub(super) const SECONDS: &str = "t_s";
pub(super) const HOURS: &str = "hours";
pub(super) const SHARE: &str = "share";

impl Agent {
    /// Effect of an agent's strength on the ship: the height of waves, the square of the speed of wind and current.
    pub(super) fn load(self, strength: f64) -> f64 {
        match self {
            Agent::Waves | Agent::Level => strength,
            Agent::Wind | Agent::Current => strength * strength,
        }
    }

    /// Name of the variable and key of the scenario for the seed of the agent's random phases; `None` for an agent
    /// without random phases.
    pub(super) fn seed(self) -> Option<(&'static str, &'static str)> {
        match self {
            Agent::Waves => Some(("wave_seed", "environment.waves.seed")),
            Agent::Wind => Some(("gust_seed", "environment.wind.seed")),
            Agent::Current | Agent::Level => None,
        }
    }

    /// The agent in words.
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
