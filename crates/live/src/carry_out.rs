//! Carries out commands on the simulation.

use fenderline_sim::order::{TugWord, TugWords, Word as _};
use fenderline_sim::{Action as SimAction, Order, Setup, Simulation};

use crate::action::{Action, COMMAND_LIMITS, OtherAction};
use crate::approach::ApproachLimit;
use crate::cast::Cast;
use crate::limits::LONGEST_NOTE;
use crate::now::Now;
use crate::refusal::Refusal;
use crate::{happening, place, world_change};

/// Carries out a command, which takes effect at the next step. The first manual order to a vessel, tug, line or anchor
/// drops the scenario's later timed orders to that target. Returns true if the command has dropped timed orders of the
/// scenario.
///
/// # Errors
/// Returns why the command is refused, in words for the person who gave the command. A refused command changes nothing.
pub(crate) fn carry_out(action: &Action, cast: &Cast, now: &mut Now) -> Result<bool, Refusal> {
    match action {
        Action::Order(named) => {
            let action = named.resolve(now.simulation.setup())?;
            order(action, now)
        }
        Action::Other(OtherAction::Tug { tug, order: word, power, lead, place }) => {
            let power = power_of(*word, *power)?;
            let words = TugWords { word: *word, power, lead: *lead, place: *place };
            let action = tug_order(tug, &words, cast, &now.simulation)?;
            order(action, now)
        }
        Action::Other(OtherAction::Place { vessel, at_m, heading_rad, ahead_mps }) => {
            let index = world_change::vessel_named(cast, vessel)?;
            place::place(index, (*at_m, *heading_rad), *ahead_mps, cast, now).map(|()| false)
        }
        Action::Other(OtherAction::Plan { at_s, event }) => {
            happening::plan(event, *at_s, cast, now).map(|()| false)
        }
        Action::Other(OtherAction::CancelPlanned { id }) => now.script.cancel(*id).map(|()| false),
        Action::Other(OtherAction::ApproachLimit { speed_mps }) => {
            let limits = COMMAND_LIMITS.approach_limit_mps;
            within("limit of the closing speed at the fenders [m/s]", *speed_mps, limits)?;
            now.approach = ApproachLimit { at_fenders_mps: *speed_mps };
            Ok(false)
        }
        Action::Other(OtherAction::Acknowledge { key }) => {
            now.alarms.acknowledge(key);
            Ok(false)
        }
        Action::Other(OtherAction::Note { text }) => check_note(text).map(|()| false),
        Action::Other(
            event @ (OtherAction::Wind { .. }
            | OtherAction::Current { .. }
            | OtherAction::Visibility { .. }
            | OtherAction::Fault { .. }
            | OtherAction::ThrusterOut { .. }
            | OtherAction::PartLine { .. }
            | OtherAction::AnchorFault { .. }
            | OtherAction::TugOut { .. }),
        ) => happening::happen(event, cast, now).map(|()| false),
    }
}

/// Gives an order that takes effect at the next step, and drops the scenario's timed orders to the same target.
fn order(action: SimAction, now: &mut Now) -> Result<bool, Refusal> {
    let simulation = &mut now.simulation;
    simulation.check_now(&action).map_err(Refusal::new)?;
    let target = action.target();
    let order = Order { at_s: simulation.time_s(), action };
    simulation.order(order.clone()).map_err(Refusal::new)?;
    if !now.manual.0.insert(target) {
        return Ok(false);
    }
    let mut dropped = false;
    simulation.retain_orders(|other| {
        let keep = other.action.target() != target || *other == order;
        dropped |= !keep;
        keep
    });
    Ok(dropped)
}

/// Turns an order in words to a tug into an order with numbers. The tug is a vector tug, or a vessel that assists a
/// ship.
fn tug_order(
    name: &str,
    words: &TugWords,
    cast: &Cast,
    simulation: &Simulation,
) -> Result<SimAction, Refusal> {
    let setup = simulation.setup();
    if let Some(tug) = setup.world.tugs.iter().position(|tug| tug.tug.name == name) {
        return words.for_vector_tug(tug, setup).map_err(Refusal::new);
    }
    let no_tug = || Refusal::new(format_args!("there is no tug `{name}`"));
    let tug = vessel_named(setup, name).map_err(|_| no_tug())?;
    let ship = cast.serves[tug].or(cast.own).filter(|ship| *ship != tug).ok_or_else(no_tug)?;
    words.for_vessel(tug, ship, setup, simulation.states()).map_err(Refusal::new)
}

/// The power that an order to a tug asks for. Only an order that asks for no force may leave the power out.
fn power_of(word: TugWord, power: Option<f64>) -> Result<f64, Refusal> {
    match (word, power) {
        (_, Some(power)) => {
            within("power of a tug", power, COMMAND_LIMITS.tug_power).map(|()| power)
        }
        (TugWord::Stop | TugWord::StandOff, None) => Ok(0.0),
        (TugWord::Push | TugWord::Pull, None) => {
            let [least, most] = COMMAND_LIMITS.tug_power;
            Err(Refusal::new(format_args!(
                "`{}` needs `power`, from {least} to {most}",
                word.word()
            )))
        }
    }
}

/// Refuses a note that is longer than one line or than the limit.
fn check_note(text: &str) -> Result<(), Refusal> {
    if text.chars().count() > LONGEST_NOTE {
        return Err(Refusal::new(format_args!("a note has at most {LONGEST_NOTE} characters")));
    }
    if text.chars().any(char::is_control) {
        return Err(Refusal::new("a note is one line, without control characters"));
    }
    Ok(())
}

fn within(what: &str, value: f64, [least, most]: [f64; 2]) -> Result<(), Refusal> {
    if value >= least && value <= most {
        return Ok(());
    }
    Err(Refusal::new(format_args!("{what}: {value} is not between {least} and {most}")))
}

fn vessel_named(setup: &Setup, name: &str) -> Result<usize, Refusal> {
    let mut vessels = setup.world.vessels.iter();
    let index = vessels.position(|vessel| setup.bodies[vessel.body].name == name);
    index.ok_or_else(|| Refusal::new(format_args!("there is no vessel `{name}`")))
}
