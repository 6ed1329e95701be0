//! Orders with indices instead of names: their kinds, and the conversion from and to arguments. All matches are exhaustive,
//! so that the program does not compile if an order of the table is missing.

use fenderline_contact::Vec2;

use super::arguments::{Arguments, Given, Value};
use super::check::check;
use super::error::OrderError;
use super::table::{OrderName, TargetKind};
use crate::setup::Setup;
use crate::world::{Assist, Job, PushJob};
use fenderline_ship::mooring::WinchOrder;
use fenderline_ship::tug::TugOrder;

/// An order at a time of the run.
#[derive(Clone, Debug, PartialEq)]
pub struct Order {
    /// Time at which it is given (s).
    pub at_s: f64,
    /// The action.
    pub action: Action,
}

/// An order without its time: target and content.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// To a vessel, by her index in [`crate::world::WorldSetup::vessels`].
    Vessel(usize, VesselAction),
    /// To a vector tug, by her index in [`crate::world::WorldSetup::tugs`].
    Tug(usize, TugOrder),
    /// To a line, by its index in [`crate::world::WorldSetup::lines`].
    Line(usize, LineAction),
    /// To an anchor, by its index in [`crate::world::WorldSetup::anchors`].
    Anchor(usize, AnchorAction),
}

/// An order to a vessel. A manual order to a control disengages the pilot that uses it.
#[derive(Clone, Debug, PartialEq)]
pub enum VesselAction {
    /// Rudder angle; positive turns to starboard going ahead (rad).
    Rudder(f64),
    /// Revolutions over full revolutions, −1 to 1.
    Engine(f64),
    /// A tunnel thruster by its index, −1 (to port) to 1 (to starboard).
    Thruster(usize, f64),
    /// An azimuth unit by its index. A value of `None` leaves power or direction unchanged.
    Azimuth {
        /// Index into [`crate::world::VesselSetup::azimuths`].
        unit: usize,
        /// Thrust over the thrust at rest and full power, 0 to 1.
        power: Option<f64>,
        /// Direction of the thrust from the bow, positive to starboard (rad).
        direction_rad: Option<f64>,
    },
    /// Keep a heading with the rudder; with the azimuth units where there is no rudder (rad).
    Course(f64),
    /// Keep a speed ahead through the water with the engine; with the azimuth units where there is no engine (m/s).
    Speed(f64),
    /// Go to a position and stay there with engine, thrusters and tugs.
    Station(Station),
    /// Assist a ship with the azimuth units.
    Assist(Assist),
    /// Hand steering: disengage all pilots; controls keep their orders.
    Hands,
}

/// An order to a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LineAction {
    /// An order to its winch.
    Winch(WinchOrder),
    /// Send it to a bollard.
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
    /// Let it go, and put the brake on when this much chain is out.
    LetGo {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Pay chain out under power until this much is out.
    Veer {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Heave chain in until this much is out; 0: until the anchor is home.
    Heave {
        /// Chain out (m).
        chain_m: f64,
    },
    /// Brake on.
    Hold,
    /// Slip the chain: it and the anchor are gone.
    Slip,
}

/// The position and heading that a ship shall keep, and her greatest speed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Station {
    /// Position of the centre of gravity (m).
    pub position_m: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
    /// The greatest surge and sway velocity (m/s).
    pub fastest_mps: [f64; 2],
}

/// The target of an order, by index.
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

    /// Its row in the table of orders.
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

impl OrderName {
    /// Builds the action from a target's index and arguments, and checks it with [`super::check()`].
    ///
    /// # Errors
    /// [`OrderError`]: an argument that is missing, unknown or out of its limits; a target or gear that does not exist.
    pub fn build(
        self,
        target: usize,
        arguments: &Arguments,
        setup: &Setup,
    ) -> Result<Action, OrderError> {
        let given = Given::new(self, arguments)?;
        let vessel = |action| Action::Vessel(target, action);
        let assist = |job| -> Result<Action, OrderError> {
            let fastest_mps = given.number("speed")?;
            Ok(vessel(VesselAction::Assist(Assist { job, fastest_mps })))
        };
        let winch = |order| Action::Line(target, LineAction::Winch(order));
        let action = match self {
            OrderName::Rudder => vessel(VesselAction::Rudder(given.number("angle")?)),
            OrderName::Engine => vessel(VesselAction::Engine(given.number("share")?)),
            OrderName::Thruster => {
                vessel(VesselAction::Thruster(given.index("name")?, given.number("power")?))
            }
            OrderName::Azimuth => vessel(VesselAction::Azimuth {
                unit: given.index("name")?,
                power: given.optional_number("power"),
                direction_rad: given.optional_number("direction"),
            }),
            OrderName::Course => vessel(VesselAction::Course(given.number("heading")?)),
            OrderName::Speed => vessel(VesselAction::Speed(given.number("speed")?)),
            OrderName::Station => vessel(VesselAction::Station(Station {
                position_m: given.place("position")?,
                heading_rad: given.number("heading")?,
                fastest_mps: [given.number("surge")?, given.number("sway")?],
            })),
            OrderName::PushShip => {
                let (ship, at_m) = (given.index("ship")?, given.place("at")?);
                let force_n = given.number("force")?;
                let tug = setup.world.vessels.get(target);
                let tug =
                    tug.ok_or(OrderError::NoTarget { kind: self.spec().target, index: target })?;
                if ship >= setup.bodies.len() {
                    return Err(OrderError::NoBody(ship));
                }
                if ship == tug.body {
                    return Err(OrderError::TugHerself { tug: setup.bodies[ship].name.clone() });
                }
                let at = (ship, at_m);
                let push = PushJob::new(&setup.bodies, &setup.fenders, tug.body, at, force_n);
                assist(Job::Push(push.map_err(OrderError::NotAtTheSide)?))?
            }
            OrderName::PullShip => assist(Job::Pull {
                line: given.index("line")?,
                direction_rad: given.number("direction")?,
                force_n: given.number("force")?,
            })?,
            OrderName::FollowShip => assist(Job::Follow {
                ship: given.index("ship")?,
                at_m: given.place("at")?,
                heading_rad: given.number("heading")?,
            })?,
            OrderName::Hands => vessel(VesselAction::Hands),
            OrderName::Push => {
                let (force_n, direction_rad) = given.tug_force(target, setup)?;
                Action::Tug(target, TugOrder::Push { force_n, direction_rad })
            }
            OrderName::Pull => {
                let (force_n, direction_rad) = given.tug_force(target, setup)?;
                Action::Tug(target, TugOrder::Pull { force_n, direction_rad })
            }
            OrderName::StandBy => Action::Tug(target, TugOrder::StandBy),
            OrderName::Heave => winch(WinchOrder::Heave(given.number("rate")?)),
            OrderName::PayOut => winch(WinchOrder::PayOut(given.number("rate")?)),
            OrderName::Hold => winch(WinchOrder::Hold),
            OrderName::Send => {
                Action::Line(target, LineAction::Send { bollard: given.index("bollard")? })
            }
            OrderName::LetGo => Action::Line(target, LineAction::LetGo),
            OrderName::LetGoAnchor => {
                Action::Anchor(target, AnchorAction::LetGo { chain_m: given.number("chain")? })
            }
            OrderName::Veer => {
                Action::Anchor(target, AnchorAction::Veer { chain_m: given.number("chain")? })
            }
            OrderName::HeaveIn => {
                Action::Anchor(target, AnchorAction::Heave { chain_m: given.number("chain")? })
            }
            OrderName::HoldChain => Action::Anchor(target, AnchorAction::Hold),
            OrderName::Slip => Action::Anchor(target, AnchorAction::Slip),
        };
        check(&action, setup)?;
        Ok(action)
    }
}

impl Action {
    /// Its arguments, by their names in the table of orders. [`OrderName::build`] builds the same action from them.
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
