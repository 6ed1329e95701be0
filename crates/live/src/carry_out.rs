//! From a command to the simulation.

use std::collections::BTreeSet;

use fenderline_contact::vec2;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{MeanWind, Wind, WindProfile};
use fenderline_sim::order::{Target, TugWord, TugWords, Word as _};
use fenderline_sim::{Action as SimAction, Order, Setup, Simulation};

use crate::action::{Action, OtherAction};
use crate::approach::ApproachLimit;
use crate::cast::Cast;
use crate::refusal::Refusal;
use crate::session::Now;

/// The vessels, tugs and lines under manual control: the scenario's timed orders no longer reach them.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct ManualControl(BTreeSet<Target>);

/// The fastest current that may be set (m/s).
const FASTEST_CURRENT_MPS: f64 = 15.0;
/// The largest angle that is taken as a direction (rad).
const LARGEST_ANGLE_RAD: f64 = 100.0;

/// Carries a command out, from the next step on. True where it is the first manual order to a control that the scenario
/// has timed orders for, which are then dropped.
///
/// # Errors
/// The reason for the person who gave it; nothing is changed then.
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
        Action::Other(OtherAction::Wind { speed_mps, from_rad }) => {
            let mean = MeanWind {
                speed_mps: *speed_mps,
                from_rad: *from_rad,
                profile: WindProfile::Uniform,
            };
            now.simulation.set_wind(Some(Wind::steady(mean).map_err(Refusal::new)?));
            Ok(false)
        }
        Action::Other(OtherAction::Current { speed_mps, to_rad }) => {
            within("speed of the current [m/s]", *speed_mps, 0.0, FASTEST_CURRENT_MPS)?;
            within("direction of the current", *to_rad, -LARGEST_ANGLE_RAD, LARGEST_ANGLE_RAD)?;
            let velocity = vec2(libm::cos(*to_rad), libm::sin(*to_rad)) * *speed_mps;
            let current = Current::uniform(velocity).map_err(Refusal::new)?;
            now.simulation.set_current(Some(current));
            Ok(false)
        }
        Action::Other(OtherAction::Fault { vessel, fault, on }) => {
            let index = vessel_named(now.simulation.setup(), vessel)?;
            let mut faults = now.simulation.vessels()[index].faults;
            fault.switch(&mut faults, *on);
            now.simulation.set_faults(index, faults).map_err(Refusal::new)?;
            Ok(false)
        }
        Action::Other(OtherAction::ApproachLimit { speed_mps }) => {
            let [low, high] = ApproachLimit::LIMITS_MPS;
            within("speed limit at the fenders [m/s]", *speed_mps, low, high)?;
            now.approach = ApproachLimit { at_fenders_mps: *speed_mps };
            Ok(false)
        }
    }
}

/// Gives an order that counts from the next step on, and drops the scenario's own to the same target.
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

/// The order that a pilot's words are to a tug: a vector tug, or a vessel at work on the pilot's own ship.
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
    let ship = cast.own.filter(|ship| *ship != tug).ok_or_else(no_tug)?;
    words.for_vessel(tug, ship, setup, simulation.states()).map_err(Refusal::new)
}

/// The power of an order to a tug. Only an order without force goes without it.
fn power_of(word: TugWord, power: Option<f64>) -> Result<f64, Refusal> {
    match (word, power) {
        (_, Some(power)) => within("power of a tug", power, 0.0, 1.0).map(|()| power),
        (TugWord::Stop | TugWord::StandOff, None) => Ok(0.0),
        (TugWord::Push | TugWord::Pull, None) => {
            Err(Refusal::new(format_args!("`{}` needs `power`, from 0 to 1", word.word())))
        }
    }
}

fn within(what: &str, value: f64, least: f64, most: f64) -> Result<(), Refusal> {
    if value >= least && value <= most {
        return Ok(());
    }
    Err(Refusal::new(format_args!("{what}: {value} is not within {least} and {most}")))
}

fn vessel_named(setup: &Setup, name: &str) -> Result<usize, Refusal> {
    let mut vessels = setup.world.vessels.iter();
    let index = vessels.position(|vessel| setup.bodies[vessel.body].name == name);
    index.ok_or_else(|| Refusal::new(format_args!("there is no vessel `{name}`")))
}
