//! From a command to an order of the simulation: names looked up, numbers bounded, what is not there refused.

use std::collections::BTreeSet;

use fenderline_contact::{Vec2, vec2};
use fenderline_sim::constants::KNOT_MPS;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{MeanWind, Wind, WindProfile};
use fenderline_sim::mooring::WinchOrder;
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{
    Action as Do, Assist, Job, LineEnd, Order, PushJob, Setup, Simulation, VesselSetup,
};

use crate::action::{Action, TugWord, WinchWord};
use crate::refusal::Refusal;

/// A tug's fastest beside a ship that she pushes or pulls, and beside one that she follows (m/s): 2 and 4 knots, the
/// defaults of the scenario's keys.
const PUSH_MPS: f64 = 2.0 * KNOT_MPS;
const FOLLOW_MPS: f64 = 4.0 * KNOT_MPS;

/// The controls that a hand was on: the scenario's timed orders move them no more.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct InHand(BTreeSet<(Kind, usize)>);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Kind {
    Vessel,
    Tug,
    Line,
}

/// What an order moves.
fn moved_by(order: &Order) -> (Kind, usize) {
    match order.action {
        Do::Tug(tug, _) => (Kind::Tug, tug),
        Do::Winch(line, _) | Do::LetGo(line) => (Kind::Line, line),
        _ => (Kind::Vessel, order.vessel),
    }
}

/// Carries a command out, from the next step on; true where this was the first hand on a control that the
/// scenario had timed orders for.
///
/// # Errors
/// A reason to be told; nothing is changed then.
pub(crate) fn carry_out(
    action: &Action,
    simulation: &mut Simulation,
    in_hand: &mut InHand,
) -> Result<bool, Refusal> {
    let order = match action {
        Action::Wind { speed_mps, from_rad } => {
            let mean = MeanWind {
                speed_mps: *speed_mps,
                from_rad: *from_rad,
                profile: WindProfile::Uniform,
            };
            let wind = Wind::steady(mean).map_err(Refusal::new)?;
            simulation.set_wind(Some(wind));
            return Ok(false);
        }
        Action::Current { speed_mps, to_rad } => {
            within("speed of the current [m/s]", *speed_mps, 0.0, 15.0)?;
            angle("direction of the current", *to_rad)?;
            let velocity = vec2(libm::cos(*to_rad), libm::sin(*to_rad)) * *speed_mps;
            let current = Current::uniform(velocity).map_err(Refusal::new)?;
            simulation.set_current(Some(current));
            return Ok(false);
        }
        Action::Fault { vessel, fault, on } => {
            let (index, _) = find_vessel(simulation.setup(), vessel)?;
            let mut faults = simulation.vessels()[index].faults;
            fault.switch(&mut faults, *on);
            simulation.set_faults(index, faults).map_err(Refusal::new)?;
            return Ok(false);
        }
        Action::Tug { tug, order, force_n, direction_rad } => {
            to_tug(simulation, tug, *order, *force_n, *direction_rad)?
        }
        Action::Winch { .. } | Action::LetGo { .. } => to_line(simulation, action)?,
        _ => to_vessel(simulation, action)?,
    };
    let (vessel, action) = order;
    let order = Order { at_s: simulation.time_s(), vessel, action };
    let moved = moved_by(&order);
    simulation.order(order.clone()).map_err(Refusal::new)?;
    if !in_hand.0.insert(moved) {
        return Ok(false);
    }
    // Kept is what is for other controls, and the one just given.
    let mut forgotten = false;
    simulation.retain_orders(|other| {
        let keep = moved_by(other) != moved || *other == order;
        forgotten |= !keep;
        keep
    });
    Ok(forgotten)
}

fn within(what: &str, value: f64, least: f64, most: f64) -> Result<f64, Refusal> {
    if value >= least && value <= most {
        return Ok(value);
    }
    Err(Refusal::new(format_args!("{what}: {value} is not within {least} and {most}")))
}

fn angle(what: &str, value_rad: f64) -> Result<f64, Refusal> {
    within(what, value_rad, -100.0, 100.0)
}

fn find_vessel<'s>(setup: &'s Setup, name: &str) -> Result<(usize, &'s VesselSetup), Refusal> {
    let mut vessels = setup.world.vessels.iter().enumerate();
    vessels
        .find(|(_, vessel)| setup.bodies[vessel.body].name == name)
        .ok_or_else(|| Refusal::new(format_args!("there is no vessel `{name}`")))
}

fn find_body(setup: &Setup, name: &str) -> Result<usize, Refusal> {
    let found = setup.bodies.iter().position(|body| body.name == name);
    found.ok_or_else(|| Refusal::new(format_args!("there is no ship `{name}`")))
}

fn place(at_m: [f64; 2]) -> Result<Vec2, Refusal> {
    for part in at_m {
        within("a place beside a ship [m]", part, -1e4, 1e4)?;
    }
    Ok(vec2(at_m[0], at_m[1]))
}

/// For a vessel's controls.
fn to_vessel(simulation: &Simulation, action: &Action) -> Result<(usize, Do), Refusal> {
    let setup = simulation.setup();
    let (name, order): (&str, Do) = match action {
        Action::Rudder { vessel, angle_rad } => {
            (vessel, Do::Rudder(angle("rudder angle [rad]", *angle_rad)?))
        }
        Action::Engine { vessel, share } => {
            (vessel, Do::Engine(within("share of full revolutions", *share, -1.0, 1.0)?))
        }
        Action::Thruster { vessel, thruster, share } => {
            let (_, of) = find_vessel(setup, vessel)?;
            let index = of.thrusters.iter().position(|own| own.name == *thruster);
            let index = index.ok_or_else(|| {
                Refusal::new(format_args!("`{vessel}` has no thruster `{thruster}`"))
            })?;
            (vessel, Do::Thruster(index, within("a thruster's share", *share, -1.0, 1.0)?))
        }
        Action::Azimuth { vessel, unit, power, direction_rad } => {
            let (_, of) = find_vessel(setup, vessel)?;
            let index = of.azimuths.iter().position(|own| own.name == *unit);
            let unit = index.ok_or_else(|| {
                Refusal::new(format_args!("`{vessel}` has no azimuth unit `{unit}`"))
            })?;
            if let Some(share) = *power {
                within("a unit's power", share, 0.0, 1.0)?;
            }
            if let Some(direction_rad) = *direction_rad {
                angle("a unit's direction [rad]", direction_rad)?;
            }
            (vessel, Do::Azimuth { unit, power: *power, direction_rad: *direction_rad })
        }
        Action::Course { vessel, heading_rad } => {
            (vessel, Do::Course(angle("a course [rad]", *heading_rad)?))
        }
        Action::Speed { vessel, speed_mps } => {
            (vessel, Do::Speed(within("a speed [m/s]", *speed_mps, -30.0, 30.0)?))
        }
        Action::Hands { vessel } => (vessel, Do::Hands),
        Action::PushShip { vessel, ship, at_m, force_n } => {
            let (_, tug) = find_vessel(setup, vessel)?;
            let ship = (find_body(setup, ship)?, place(*at_m)?);
            if ship.0 == tug.body {
                return Err(Refusal::new("a tug cannot push herself"));
            }
            let force_n = within("a tug's force [N]", *force_n, 0.0, 1e8)?;
            let push = PushJob::new(&setup.bodies, &setup.fenders, tug.body, ship, force_n);
            let job = Job::Push(push.map_err(Refusal::new)?);
            (vessel, Do::Assist(Assist { job, fastest_mps: PUSH_MPS }))
        }
        Action::PullShip { vessel, line, direction_rad, force_n } => {
            let (_, tug) = find_vessel(setup, vessel)?;
            let index = standing_line(simulation, line)?;
            let towed = &setup.world.lines[index];
            let ends = match towed.end {
                LineEnd::OnBody { body, .. } => [towed.ship, body],
                LineEnd::Fixed(_) => [towed.ship; 2],
            };
            let afloat = ends.iter().all(|&body| setup.bodies[body].mass.is_some());
            if !afloat || ends[0] == ends[1] || !ends.contains(&tug.body) {
                let what = format_args!("line `{line}` is not between `{vessel}` and a ship");
                return Err(Refusal::new(what));
            }
            let direction_rad = angle("a pull's direction [rad]", *direction_rad)?;
            let force_n = within("a tug's force [N]", *force_n, 0.0, 1e8)?;
            let job = Job::Pull { line: index, direction_rad, force_n };
            (vessel, Do::Assist(Assist { job, fastest_mps: PUSH_MPS }))
        }
        Action::FollowShip { vessel, ship, at_m, heading_rad } => {
            let (ship, at_m) = (find_body(setup, ship)?, place(*at_m)?);
            let heading_rad = angle("a tug's heading [rad]", *heading_rad)?;
            let job = Job::Follow { ship, at_m, heading_rad };
            (vessel, Do::Assist(Assist { job, fastest_mps: FOLLOW_MPS }))
        }
        other => unreachable!("{other:?} is not for a vessel's controls"),
    };
    let (index, vessel) = find_vessel(setup, name)?;
    has_gear(name, vessel, &order)?;
    Ok((index, order))
}

/// An order to what she has nothing to carry out with would do nothing.
fn has_gear(name: &str, vessel: &VesselSetup, order: &Do) -> Result<(), Refusal> {
    let propelled = vessel.ship.propulsion.is_some();
    let (has_it, needed) = match order {
        Do::Rudder(_) | Do::Engine(_) => (propelled, "propeller and rudder"),
        Do::Course(_) | Do::Speed(_) => {
            (propelled || vessel.steers_with_azimuths(), "propeller and rudder, nor azimuth units")
        }
        _ => (true, ""),
    };
    if has_it {
        return Ok(());
    }
    Err(Refusal::new(format_args!("`{name}` has no {needed}")))
}

/// For a vector tug.
fn to_tug(
    simulation: &Simulation,
    name: &str,
    order: TugWord,
    force_n: Option<f64>,
    direction_rad: Option<f64>,
) -> Result<(usize, Do), Refusal> {
    let world = &simulation.setup().world;
    let index = world.tugs.iter().position(|tug| tug.tug.name == name);
    let index = index.ok_or_else(|| Refusal::new(format_args!("there is no tug `{name}`")))?;
    let ship = world.tugs[index].vessel;
    if simulation.vessels()[ship].pilots.station.is_some() {
        let ship = &simulation.setup().bodies[world.vessels[ship].body].name;
        return Err(Refusal::new(format_args!(
            "the pilot that keeps `{ship}` on her station uses her tugs: take her in hand first"
        )));
    }
    let numbers = || {
        let (Some(force_n), Some(direction_rad)) = (force_n, direction_rad) else {
            return Err(Refusal::new("a push or a pull needs `force_n` and `direction_rad`"));
        };
        let force_n = within("a tug's force [N]", force_n, 0.0, 1e8)?;
        Ok((force_n, angle("a tug's direction [rad]", direction_rad)?))
    };
    let order = match order {
        TugWord::StandBy => TugOrder::StandBy,
        TugWord::Push => {
            let (force_n, direction_rad) = numbers()?;
            TugOrder::Push { force_n, direction_rad }
        }
        TugWord::Pull => {
            let (force_n, direction_rad) = numbers()?;
            TugOrder::Pull { force_n, direction_rad }
        }
    };
    Ok((ship, Do::Tug(index, order)))
}

/// The index of a line that has not been cast off.
fn standing_line(simulation: &Simulation, name: &str) -> Result<usize, Refusal> {
    let lines = &simulation.setup().world.lines;
    let index = lines.iter().position(|line| line.line.name == name);
    let index = index.ok_or_else(|| Refusal::new(format_args!("there is no line `{name}`")))?;
    if simulation.lines()[index].gone {
        return Err(Refusal::new(format_args!("line `{name}` is gone")));
    }
    Ok(index)
}

/// For a line.
fn to_line(simulation: &Simulation, action: &Action) -> Result<(usize, Do), Refusal> {
    let (Action::Winch { line: name, .. } | Action::LetGo { line: name }) = action else {
        unreachable!("{action:?} is not for a line");
    };
    let index = standing_line(simulation, name)?;
    let lines = &simulation.setup().world.lines;
    let order = match action {
        Action::Winch { order, rate_mps, .. } => {
            let rate_mps = within("a winch's rate [m/s]", *rate_mps, 0.0, 20.0)?;
            if matches!(lines[index].line.inboard_end, fenderline_sim::mooring::InboardEnd::Bitts) {
                return Err(Refusal::new(format_args!("line `{name}` is on bitts: no winch")));
            }
            let order = match order {
                WinchWord::Hold => WinchOrder::Hold,
                WinchWord::Heave => WinchOrder::Heave(rate_mps),
                WinchWord::PayOut => WinchOrder::PayOut(rate_mps),
            };
            Do::Winch(index, order)
        }
        _ => Do::LetGo(index),
    };
    Ok((0, order))
}
