//! Checks whether an order can be carried out in a set-up. Scenarios, live sessions, Python and FMUs use the same
//! check.

use super::action::{Action, AnchorAction, LineAction, Order, Target, VesselAction};
use super::arguments::Value;
use super::error::OrderError;
use super::table::{Argument, ArgumentKind, Named};
use crate::error::SetupError;
use crate::setup::Setup;
use crate::world::{AnchorSetup, Assist, Environment, Job, LineEnd};

/// Checks an order: its target, the limits and names of its arguments, and the gear of the target.
///
/// # Errors
/// Returns the first fault of the order.
pub fn check(action: &Action, setup: &Setup) -> Result<(), OrderError> {
    let world = &setup.world;
    let (index, count) = match action.target() {
        Target::Vessel(index) => (index, world.vessels.len()),
        Target::Tug(index) => (index, world.tugs.len()),
        Target::Line(index) => (index, world.lines.len()),
        Target::Anchor(index) => (index, world.anchors.len()),
    };
    let spec = action.name().spec();
    if index >= count {
        return Err(OrderError::NoTarget { kind: spec.target, index });
    }
    for (name, value) in action.arguments().iter() {
        let argument = spec.argument(name);
        let argument = argument.ok_or_else(|| OrderError::Unknown {
            order: action.name(),
            argument: name.to_owned(),
        })?;
        check_value(argument, value, index, setup)?;
    }
    if !spec.gear.is_on(index, setup) {
        return Err(OrderError::NoGear { who: name_of(action.target(), setup), gear: spec.gear });
    }
    match action {
        Action::Vessel(_, VesselAction::Azimuth { power: None, direction_rad: None, .. }) => {
            Err(OrderError::Nothing)
        }
        Action::Anchor(anchor, action) => {
            check_anchor(&world.anchors[*anchor], *action, &world.environment)
        }
        Action::Vessel(tug, VesselAction::Assist(assist)) => check_assist(assist, *tug, setup),
        Action::Line(line, LineAction::Send { bollard }) => {
            let (line, bollard) = (&world.lines[*line], &world.bollards[*bollard]);
            match line.ship == bollard.body {
                true => Err(OrderError::OwnBollard {
                    line: line.line.name.clone(),
                    bollard: bollard.name.clone(),
                }),
                false => Ok(()),
            }
        }
        _ => Ok(()),
    }
}

/// Checks an order as [`check()`] does, and also checks the order's time.
pub fn check_order(order: &Order, setup: &Setup) -> Result<(), SetupError> {
    if !order.at_s.is_finite() {
        return Err(SetupError::OutOfRange { field: "the time of an order", value: order.at_s });
    }
    check(&order.action, setup).map_err(SetupError::Order)
}

/// The name that the user gave the target of an order.
fn name_of(target: Target, setup: &Setup) -> String {
    let world = &setup.world;
    match target {
        Target::Vessel(index) => setup.bodies[world.vessels[index].body].name.clone(),
        Target::Tug(index) => world.tugs[index].tug.name.clone(),
        Target::Line(index) => world.lines[index].line.name.clone(),
        Target::Anchor(index) => world.anchors[index].gear.name.clone(),
    }
}

fn check_value(
    argument: &'static Argument,
    value: Value,
    target: usize,
    setup: &Setup,
) -> Result<(), OrderError> {
    let within = |value: f64, low: f64, high: f64| match value >= low && value <= high {
        true => Ok(()),
        false => Err(OrderError::OutOfRange { argument, value, low, high }),
    };
    match (argument.kind, value) {
        (ArgumentKind::Number { low, high, .. }, Value::Number(value)) => within(value, low, high),
        (ArgumentKind::Place { most_m, .. }, Value::Place(at_m)) => {
            within(at_m.x, -most_m, most_m)?;
            within(at_m.y, -most_m, most_m)
        }
        (ArgumentKind::Name(named), Value::Index(index)) => {
            let vessel = setup.world.vessels.get(target);
            let count = match named {
                Named::Thruster => vessel.map_or(0, |vessel| vessel.thrusters.len()),
                Named::AzimuthUnit => vessel.map_or(0, |vessel| vessel.azimuths.len()),
                Named::Body => setup.bodies.len(),
                Named::Line => setup.world.lines.len(),
                Named::Bollard => setup.world.bollards.len(),
            };
            match index < count {
                true => Ok(()),
                false => Err(OrderError::NoIndex { argument, index }),
            }
        }
        _ => Err(OrderError::WrongKind { argument }),
    }
}

/// Checks an order to an anchor. The chain must be as long as the order asks for. An anchor that is let go needs a
/// bottom that its chain reaches.
fn check_anchor(
    of: &AnchorSetup,
    action: AnchorAction,
    environment: &Environment,
) -> Result<(), OrderError> {
    let anchor = || of.gear.name.clone();
    let length_m = of.gear.chain_length_m;
    match action {
        AnchorAction::LetGo { chain_m }
        | AnchorAction::Veer { chain_m }
        | AnchorAction::Heave { chain_m }
            if chain_m > length_m =>
        {
            return Err(OrderError::ChainTooShort { anchor: anchor(), chain_m, length_m });
        }
        AnchorAction::LetGo { .. } => {}
        _ => return Ok(()),
    }
    let Some(reach_m) = of.most_above_bottom_m(environment) else {
        return Err(OrderError::NoBottom { anchor: anchor() });
    };
    if reach_m > length_m {
        return Err(OrderError::TooDeep { anchor: anchor(), reach_m, length_m });
    }
    Ok(())
}

/// Checks an order to assist. A tug may assist only another body: one that the tug may touch, or to which the tug has a
/// line. The force is at most the tug's bollard pull.
fn check_assist(assist: &Assist, vessel: usize, setup: &Setup) -> Result<(), OrderError> {
    let tug = &setup.world.vessels[vessel];
    let name = |body: usize| setup.bodies[body].name.clone();
    let (ship, force_n) = match assist.job {
        Job::Follow { ship, .. } => (ship, 0.0),
        Job::Push(push) => (push.ship, push.force_n),
        Job::Pull { line, force_n, .. } => {
            let elsewhere =
                || OrderError::LineElsewhere { line: setup.world.lines[line].line.name.clone() };
            let towline = &setup.world.lines[line];
            let Some(LineEnd::OnBody { body: far, .. }) = towline.end else {
                return Err(elsewhere());
            };
            match (towline.ship == tug.body, far == tug.body) {
                (true, false) => (far, force_n),
                (false, true) => (towline.ship, force_n),
                _ => return Err(elsewhere()),
            }
        }
    };
    if ship == tug.body {
        return Err(OrderError::TugHerself { tug: name(ship) });
    }
    if let Job::Push(push) = assist.job
        && !setup.may_touch([push.ship, tug.body])
    {
        return Err(OrderError::NoPair { ship: name(push.ship) });
    }
    let pull_n = tug.bollard_pull_n();
    if force_n > pull_n {
        return Err(OrderError::BeyondBollardPull { force_n, pull_n });
    }
    Ok(())
}
