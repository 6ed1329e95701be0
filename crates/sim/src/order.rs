//! What can be wrong with an order, of the set-up or of a hand at a control.

use crate::error::SetupError;
use crate::mooring::WinchOrder;
use crate::setup::Setup;
use crate::tug::TugOrder;
use crate::world::{Action, Assist, Job, LineEnd, MooringSetup, Order};

/// Is what the order is for there, and is every number of it one?
///
/// # Errors
/// [`SetupError`], naming what is wrong.
pub(crate) fn check_order(order: &Order, setup: &Setup) -> Result<(), SetupError> {
    for (field, value) in numbers(order) {
        if !value.is_finite() {
            return Err(SetupError::OutOfRange { field, value });
        }
    }
    let world = &setup.world;
    let there = |owner, index, count| match index < count {
        true => Ok(()),
        false => Err(SetupError::BadBody { owner, body: index }),
    };
    match order.action {
        Action::Tug(tug, _) => return there("tug's order", tug, world.tugs.len()),
        Action::Winch(line, _) | Action::LetGo(line) => {
            return there("line's order", line, world.lines.len());
        }
        _ => there("order", order.vessel, world.vessels.len())?,
    }
    let vessel = &world.vessels[order.vessel];
    match &order.action {
        Action::Thruster(index, _) if *index >= vessel.thrusters.len() => {
            Err(SetupError::NoThruster { vessel: order.vessel, thruster: *index })
        }
        Action::Azimuth { unit, .. } if *unit >= vessel.azimuths.len() => {
            Err(SetupError::NoAzimuth { vessel: order.vessel, azimuth: *unit })
        }
        Action::Assist(assist) => check_assist(assist, order.vessel, setup),
        _ => Ok(()),
    }
}

/// Every number of an order with its name.
fn numbers(order: &Order) -> Vec<(&'static str, f64)> {
    let mut all = vec![("the time of an order", order.at_s)];
    match &order.action {
        Action::Rudder(angle_rad) => all.push(("an order to the rudder", *angle_rad)),
        Action::Engine(share) => all.push(("an order to the engine", *share)),
        Action::Thruster(_, share) => all.push(("an order to a thruster", *share)),
        Action::Azimuth { power, direction_rad, .. } => {
            all.extend(power.map(|share| ("the power of an azimuth unit", share)));
            all.extend(direction_rad.map(|angle| ("the direction of an azimuth unit", angle)));
        }
        Action::Course(heading_rad) => all.push(("a course", *heading_rad)),
        Action::Speed(speed_mps) => all.push(("a speed", *speed_mps)),
        Action::Station(station) => {
            let [surge_mps, sway_mps] = station.fastest_mps;
            all.extend([
                ("the place of a station, north", station.position_m.x),
                ("the place of a station, east", station.position_m.y),
                ("the heading of a station", station.heading_rad),
                ("the fastest surge to a station", surge_mps),
                ("the fastest sway to a station", sway_mps),
            ]);
        }
        Action::Assist(assist) => numbers_of_assist(assist, &mut all),
        Action::Tug(_, TugOrder::Push { force_n, direction_rad })
        | Action::Tug(_, TugOrder::Pull { force_n, direction_rad }) => {
            all.extend([("a tug's force", *force_n), ("a tug's direction", *direction_rad)]);
        }
        Action::Winch(_, WinchOrder::Heave(rate_mps) | WinchOrder::PayOut(rate_mps)) => {
            all.push(("a winch's rate", *rate_mps));
        }
        Action::Tug(_, TugOrder::StandBy)
        | Action::Winch(_, WinchOrder::Hold)
        | Action::LetGo(_)
        | Action::Hands => {}
    }
    all
}

fn numbers_of_assist(assist: &Assist, all: &mut Vec<(&'static str, f64)>) {
    all.push(("a tug's fastest speed", assist.fastest_mps));
    match assist.job {
        Job::Follow { at_m, heading_rad, .. } => all.extend([
            ("a tug's place along the ship", at_m.x),
            ("a tug's place across the ship", at_m.y),
            ("a tug's heading", heading_rad),
        ]),
        Job::Push(push) => all.extend([
            ("where a tug pushes along the ship", push.at_m.x),
            ("where a tug pushes across the ship", push.at_m.y),
            ("where a tug's bow is", push.bow_m),
            ("a tug's force", push.force_n),
        ]),
        Job::Pull { direction_rad, force_n, .. } => {
            all.extend([("a tug's direction", direction_rad), ("a tug's force", force_n)]);
        }
    }
}

/// A tug's work at another body, by thrust that she has.
fn check_assist(assist: &Assist, vessel: usize, setup: &Setup) -> Result<(), SetupError> {
    let tug = &setup.world.vessels[vessel];
    if tug.azimuths.is_empty() {
        return Err(SetupError::NoAzimuth { vessel, azimuth: 0 });
    }
    let ship = match assist.job {
        Job::Follow { ship, .. } => ship,
        Job::Push(push) => push.ship,
        Job::Pull { line, .. } => match setup.world.lines.get(line) {
            Some(MooringSetup { ship, end: LineEnd::OnBody { body, .. }, .. })
                if tug.body == *ship =>
            {
                *body
            }
            Some(MooringSetup { ship, end: LineEnd::OnBody { body, .. }, .. })
                if tug.body == *body =>
            {
                *ship
            }
            _ => return Err(SetupError::BadBody { owner: "tug's line", body: line }),
        },
    };
    if ship >= setup.bodies.len() || ship == tug.body {
        return Err(SetupError::BadBody { owner: "tug's work", body: ship });
    }
    Ok(())
}
