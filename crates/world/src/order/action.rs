//! Orders with indices instead of names: the kinds of orders, and the conversion from and to arguments. All matches of
//! this module are exhaustive, so the program does not compile if an order of the table is missing.

use fenderline_contact::Vec2;

use super::arguments::{Arguments, Value};
use super::table::{OrderName, TargetKind};
use crate::world::{Assist, Job};
use fenderline_ship::mooring::WinchOrder;
use fenderline_ship::tug::TugOrder;

/// An order at a time of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Time at which the order is given (s).
    pub at_s: f64,
    /// The action.
    pub action: Action,
}

/// An order without the time at which it is given: the target and the content.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// An order to a vessel, by the vessel's index in [`crate::world::WorldSetup::vessels`].
    Vessel(usize, VesselAction),
    /// An order to a vector tug, by the tug's index in [`crate::world::WorldSetup::tugs`].
    Tug(usize, TugOrder),
    /// An order to a line, by the line's index in [`crate::world::WorldSetup::lines`].
    Line(usize, LineAction),
    /// An order to an anchor, by the anchor's index in [`crate::world::WorldSetup::anchors`].
    Anchor(usize, AnchorAction),
}

/// An order to a vessel. A manual order to a control switches off the pilot that uses this control.
#[derive(Clone, Debug, PartialEq)]
pub enum VesselAction {
    /// Rudder angle (rad). A positive angle turns a ship that goes ahead to starboard.
    Rudder(f64),
    /// The engine's revolutions divided by its full revolutions, −1 to 1.
    Engine(f64),
    /// Sets the tunnel thruster of this index to a share of its greatest thrust, −1 (to port) to 1 (to starboard).
    Thruster(usize, f64),
    /// Sets the power and the direction of the azimuth unit of this index. A power or direction of `None` stays
    /// unchanged.
    Azimuth {
        /// Index into [`crate::world::VesselSetup::azimuths`].
        unit: usize,
        /// Thrust divided by the thrust at rest and full power, 0 to 1.
        power: Option<f64>,
        /// Direction of the thrust from the bow, positive to starboard (rad).
        direction_rad: Option<f64>,
    },
    /// Keep a heading (rad) with the rudder, or with the azimuth units if the vessel has no rudder.
    Course(f64),
    /// Keep a speed ahead through the water (m/s) with the engine, or with the azimuth units if the vessel has no
    /// engine.
    Speed(f64),
    /// Go to a position and stay at this position with engine, thrusters and tugs.
    Station(Station),
    /// Assist a ship with the azimuth units.
    Assist(Assist),
    /// Hand steering: all pilots are switched off, and the controls keep their orders.
    Hands,
}

/// An order to a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAction {
    /// An order to the winch of the line.
    Winch(WinchOrder),
    /// Send the line to a bollard.
    Send {
        /// Index into [`crate::world::WorldSetup::bollards`].
        bollard: usize,
    },
    /// Let the line go.
    LetGo,
}

/// An order to an anchor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AnchorAction {
    /// Let the anchor go, and put the windlass's brake on when this length of chain is out (m).
    LetGo {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Pay chain out under power until this length of chain is out (m).
    Veer {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Heave chain in until this length of chain is out (m); with 0, until the anchor is home.
    Heave {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Brake on.
    Hold,
    /// Slip the chain: the ship loses chain and anchor.
    Slip,
}

/// The position and heading that a ship must keep, and the greatest speed of the ship on the way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Position of the ship's centre of gravity (m).
    pub position_m: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
    /// The greatest surge and sway velocity of the ship (m/s).
    pub fastest_mps: [f64; 2],
}

/// The target of an order, given by its index.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Target {
    /// A vessel.
    Vessel(usize),
    /// A vector tug.
    Tug(usize),
    /// A line.
    Line(usize),
    /// An anchor.
    Anchor(usize),
}

impl Target {
    /// The kind of target.
    #[must_use]
    pub fn kind(self) -> TargetKind {
        match self {
            Target::Vessel(_) => TargetKind::Vessel,
            Target::Tug(_) => TargetKind::Tug,
            Target::Line(_) => TargetKind::Line,
            Target::Anchor(_) => TargetKind::Anchor,
        }
    }
}

impl Action {
    /// The target.
    #[must_use]
    pub fn target(&self) -> Target {
        match *self {
            Action::Vessel(index, _) => Target::Vessel(index),
            Action::Tug(index, _) => Target::Tug(index),
            Action::Line(index, _) => Target::Line(index),
            Action::Anchor(index, _) => Target::Anchor(index),
        }
    }

    /// Name of the action's row in the table of orders.
    #[must_use]
    pub fn name(&self) -> OrderName {
        match self {
            Action::Vessel(_, action) => match action {
                VesselAction::Rudder(_) => OrderName::Rudder,
                VesselAction::Engine(_) => OrderName::Engine,
                VesselAction::Thruster(..) => OrderName::Thruster,
                VesselAction::Azimuth { .. } => OrderName::Azimuth,
                VesselAction::Course(_) => OrderName::Course,
                VesselAction::Speed(_) => OrderName::Speed,
                VesselAction::Station(_) => OrderName::Station,
                VesselAction::Assist(assist) => match assist.job {
                    Job::Follow { .. } => OrderName::FollowShip,
                    Job::Push(_) => OrderName::PushShip,
                    Job::Pull { .. } => OrderName::PullShip,
                },
                VesselAction::Hands => OrderName::Hands,
            },
            Action::Tug(_, TugOrder::StandBy) => OrderName::StandBy,
            Action::Tug(_, TugOrder::Push { .. }) => OrderName::Push,
            Action::Tug(_, TugOrder::Pull { .. }) => OrderName::Pull,
            Action::Line(_, LineAction::Winch(WinchOrder::Hold)) => OrderName::Hold,
            Action::Line(_, LineAction::Winch(WinchOrder::Heave(_))) => OrderName::Heave,
            Action::Line(_, LineAction::Winch(WinchOrder::PayOut(_))) => OrderName::PayOut,
            Action::Line(_, LineAction::Send { .. }) => OrderName::Send,
            Action::Line(_, LineAction::LetGo) => OrderName::LetGo,
            Action::Anchor(_, AnchorAction::LetGo { .. }) => OrderName::LetGoAnchor,
            Action::Anchor(_, AnchorAction::Veer { .. }) => OrderName::Veer,
            Action::Anchor(_, AnchorAction::Heave { .. }) => OrderName::HeaveIn,
            Action::Anchor(_, AnchorAction::Hold) => OrderName::HoldChain,
            Action::Anchor(_, AnchorAction::Slip) => OrderName::Slip,
        }
    }
}

impl Action {
    /// Arguments of the action, with their names in the table of orders. [`OrderName::build`] builds the same action
    /// from these arguments.
    #[must_use]
    pub fn arguments(&self) -> Arguments {
        let all = Arguments::new();
        match self {
            Action::Vessel(_, action) => action.arguments(),
            Action::Tug(_, TugOrder::StandBy) => all,
            Action::Tug(_, TugOrder::Push { force_n, direction_rad })
            | Action::Tug(_, TugOrder::Pull { force_n, direction_rad }) => {
                all.number("force", *force_n).number("direction", *direction_rad)
            }
            Action::Line(_, LineAction::Winch(WinchOrder::Heave(rate_mps)))
            | Action::Line(_, LineAction::Winch(WinchOrder::PayOut(rate_mps))) => {
                all.number("rate", *rate_mps)
            }
            Action::Line(_, LineAction::Send { bollard }) => {
                all.with("bollard", Value::Index(*bollard))
            }
            Action::Line(_, LineAction::Winch(WinchOrder::Hold) | LineAction::LetGo) => all,
            Action::Anchor(
                _,
                AnchorAction::LetGo { chain_m }
                | AnchorAction::Veer { chain_m }
                | AnchorAction::Heave { chain_m },
            ) => all.number("chain", *chain_m),
            Action::Anchor(_, AnchorAction::Hold | AnchorAction::Slip) => all,
        }
    }
}

impl VesselAction {
    fn arguments(&self) -> Arguments {
        let all = Arguments::new();
        match self {
            VesselAction::Rudder(angle_rad) => all.number("angle", *angle_rad),
            VesselAction::Engine(share) => all.number("share", *share),
            VesselAction::Thruster(index, power) => {
                all.with("name", Value::Index(*index)).number("power", *power)
            }
            VesselAction::Azimuth { unit, power, direction_rad } => {
                let mut all = all.with("name", Value::Index(*unit));
                for (name, value) in [("power", power), ("direction", direction_rad)] {
                    if let Some(value) = value {
                        all = all.number(name, *value);
                    }
                }
                all
            }
            VesselAction::Course(heading_rad) => all.number("heading", *heading_rad),
            VesselAction::Speed(speed_mps) => all.number("speed", *speed_mps),
            VesselAction::Station(station) => all
                .with("position", Value::Place(station.position_m))
                .number("heading", station.heading_rad)
                .number("surge", station.fastest_mps[0])
                .number("sway", station.fastest_mps[1]),
            VesselAction::Assist(assist) => {
                let all = match assist.job {
                    Job::Follow { ship, at_m, heading_rad } => all
                        .with("ship", Value::Index(ship))
                        .with("at", Value::Place(at_m))
                        .number("heading", heading_rad),
                    Job::Push(push) => all
                        .with("ship", Value::Index(push.ship))
                        .with("at", Value::Place(push.at_m))
                        .number("force", push.force_n),
                    Job::Pull { line, direction_rad, force_n } => all
                        .with("line", Value::Index(line))
                        .number("direction", direction_rad)
                        .number("force", force_n),
                };
                all.number("speed", assist.fastest_mps)
            }
            VesselAction::Hands => all,
        }
    }
}
