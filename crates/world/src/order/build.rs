//! Builds orders from words and arguments.

use super::action::{Action, AnchorAction, LineAction, Station, VesselAction};
use super::arguments::{Arguments, Given};
use super::check::check;
use super::error::OrderError;
use super::table::OrderName;
use crate::setup::Setup;
use crate::world::{Assist, Job, PushJob};
use fenderline_ship::mooring::WinchOrder;
use fenderline_ship::tug::TugOrder;

impl OrderName {
    /// Builds the action from a target's index and arguments, and checks it with [`super::check()`].
    ///
    /// # Errors
    /// Fails with an [`OrderError`] if an argument is missing, unknown or outside its limits, or if the target or its
    /// gear does not exist.
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
