//! What hands do to the simulation: the commands that are recorded.

use serde::{Deserialize, Serialize};

/// A command that changes the simulated world, by the names of the scenario. Its JSON is that of
/// `web/src/protocol.ts`, where every field is told; units are SI.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
#[allow(missing_docs, reason = "the fields are those of protocol.ts")]
pub enum Action {
    /// Rudder angle, positive turns to starboard going ahead.
    Rudder { vessel: String, angle_rad: f64 },
    /// Revolutions over full ones, −1 to 1.
    Engine { vessel: String, share: f64 },
    /// A tunnel thruster, −1 (to port) to 1.
    Thruster { vessel: String, thruster: String, share: f64 },
    /// An azimuth unit; what is `null` stays.
    Azimuth { vessel: String, unit: String, power: Option<f64>, direction_rad: Option<f64> },
    /// Keep a heading.
    Course { vessel: String, heading_rad: f64 },
    /// Keep a speed through the water.
    Speed { vessel: String, speed_mps: f64 },
    /// Pilots off.
    Hands { vessel: String },
    /// A vector tug; force and direction for `push` and `pull`.
    Tug {
        tug: String,
        order: TugWord,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        force_n: Option<f64>,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        direction_rad: Option<f64>,
    },
    /// A tug that is a vessel goes to a ship's side and pushes.
    PushShip { vessel: String, ship: String, at_m: [f64; 2], force_n: f64 },
    /// A tug that is a vessel pulls on a line between her and a ship; the direction is from the ship's bow.
    PullShip { vessel: String, line: String, direction_rad: f64, force_n: f64 },
    /// A tug that is a vessel keeps a place beside a ship.
    FollowShip { vessel: String, ship: String, at_m: [f64; 2], heading_rad: f64 },
    /// A line's winch; the rate counts for `heave` and `pay_out`.
    Winch {
        line: String,
        order: WinchWord,
        #[serde(default)]
        rate_mps: f64,
    },
    /// A line is cast off.
    LetGo { line: String },
    /// A steady wind at 10 m in place of what blew.
    Wind { speed_mps: f64, from_rad: f64 },
    /// A uniform current in place of what ran.
    Current { speed_mps: f64, to_rad: f64 },
    /// Something on a vessel fails, or is repaired.
    Fault { vessel: String, fault: Fault, on: bool },
}

/// What a vector tug is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum TugWord {
    /// No force.
    StandBy,
    /// At the hull.
    Push,
    /// On her line.
    Pull,
}

/// What a winch is told.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum WinchWord {
    /// Brake on.
    Hold,
    /// In.
    Heave,
    /// Out.
    PayOut,
}

/// What can fail on a vessel: see [`fenderline_sim::Faults`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// The rudder stays where it is; azimuth units do not turn.
    RudderStuck,
    /// Shaft and azimuth units give nothing.
    EngineLost,
    /// Tunnel thrusters give nothing.
    ThrustersLost,
    /// All of these.
    Blackout,
}

impl Fault {
    /// Those of a vessel that stand.
    #[must_use]
    pub fn standing(faults: &fenderline_sim::Faults) -> Vec<Fault> {
        [
            (faults.rudder_stuck, Fault::RudderStuck),
            (faults.engine_lost, Fault::EngineLost),
            (faults.thrusters_lost, Fault::ThrustersLost),
            (faults.blackout, Fault::Blackout),
        ]
        .into_iter()
        .filter_map(|(on, fault)| on.then_some(fault))
        .collect()
    }

    /// Switches it.
    pub(crate) fn switch(self, faults: &mut fenderline_sim::Faults, on: bool) {
        match self {
            Fault::RudderStuck => faults.rudder_stuck = on,
            Fault::EngineLost => faults.engine_lost = on,
            Fault::ThrustersLost => faults.thrusters_lost = on,
            Fault::Blackout => faults.blackout = on,
        }
    }
}
