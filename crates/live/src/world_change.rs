//! Changes of the weather and faults, which people send to the simulation. Pages send such changes with the names of
//! the scenario; the simulation uses indices.

use fenderline_sim::{Change, Setup};

use crate::action::OtherAction;
use crate::cast::Cast;
use crate::refusal::Refusal;

/// Turns an action of a page into a change of the simulation. The result is `None` if the action is no change of the
/// weather and no fault.
///
/// # Errors
/// Fails for a name that does not exist in the scenario.
pub(crate) fn resolve(
    action: &OtherAction,
    cast: &Cast,
    setup: &Setup,
) -> Result<Option<Change>, Refusal> {
    Ok(Some(match action {
        OtherAction::Wind { speed_mps, from_rad, over_s } => {
            Change::Wind { speed_mps: *speed_mps, from_rad: *from_rad, over_s: *over_s }
        }
        OtherAction::Current { speed_mps, to_rad, over_s } => Change::Current {
            speed_mps: *speed_mps,
            to_rad: *to_rad,
            over_s: *over_s,
            at: cast.own,
        },
        OtherAction::Visibility { distance_m, over_s } => {
            Change::Visibility { distance_m: *distance_m, over_s: *over_s }
        }
        OtherAction::Fault { vessel, fault, on } => {
            Change::Fault { vessel: vessel_named(cast, vessel)?, fault: *fault, on: *on }
        }
        OtherAction::ThrusterOut { vessel, thruster, on } => {
            let index = vessel_named(cast, vessel)?;
            let mut units = setup.world.vessels[index].unit_names();
            let unit = units.position(|name| name == thruster).ok_or_else(|| {
                Refusal::new(format_args!("`{vessel}` has no thruster `{thruster}`"))
            })?;
            Change::Thruster { vessel: index, unit, on: *on }
        }
        OtherAction::PartLine { line } => {
            let lines = &setup.world.lines;
            let index = lines.iter().position(|setup| setup.line.name == *line);
            let index =
                index.ok_or_else(|| Refusal::new(format_args!("there is no line `{line}`")))?;
            Change::PartLine(index)
        }
        OtherAction::TugOut { tug, on } => {
            let index = cast.tugs.iter().position(|name| name == tug);
            let tug = index.ok_or_else(|| {
                Refusal::new(format_args!(
                    "`{tug}` is no vector tug and cannot drop out; give her a fault instead"
                ))
            })?;
            Change::TugOut { tug, on: *on }
        }
        OtherAction::Tug { .. }
        | OtherAction::Place { .. }
        | OtherAction::Plan { .. }
        | OtherAction::CancelPlanned { .. }
        | OtherAction::ApproachLimit { .. }
        | OtherAction::Acknowledge { .. }
        | OtherAction::AnchorFault { .. }
        | OtherAction::Note { .. } => return Ok(None),
    }))
}

/// The index of the vessel that has the name `name`.
pub(crate) fn vessel_named(cast: &Cast, name: &str) -> Result<usize, Refusal> {
    let index = cast.vessels.iter().position(|vessel| vessel == name);
    index.ok_or_else(|| Refusal::new(format_args!("there is no vessel `{name}`")))
}

/// Turns a change of the weather or a fault, in which vessels and their parts are indices, into the action that a page
/// shows, in which they have the names of the scenario.
pub(crate) fn named(change: &Change, cast: &Cast, setup: &Setup) -> OtherAction {
    let vessel = |index: usize| cast.vessels[index].clone();
    match *change {
        Change::Wind { speed_mps, from_rad, over_s } => {
            OtherAction::Wind { speed_mps, from_rad, over_s }
        }
        Change::Current { speed_mps, to_rad, over_s, .. } => {
            OtherAction::Current { speed_mps, to_rad, over_s }
        }
        Change::Visibility { distance_m, over_s } => OtherAction::Visibility { distance_m, over_s },
        Change::Fault { vessel: index, fault, on } => {
            OtherAction::Fault { vessel: vessel(index), fault, on }
        }
        Change::Thruster { vessel: index, unit, on } => {
            let mut names = setup.world.vessels[index].unit_names();
            let thruster = names.nth(unit).unwrap_or_default().to_owned();
            OtherAction::ThrusterOut { vessel: vessel(index), thruster, on }
        }
        Change::PartLine(line) => {
            OtherAction::PartLine { line: setup.world.lines[line].line.name.clone() }
        }
        Change::TugOut { tug, on } => OtherAction::TugOut { tug: cast.tugs[tug].clone(), on },
    }
}
