//! Events in the simulated world that nobody orders at that moment: changes of the weather and faults, at once or when
//! their planned time has come.

use crate::action::OtherAction;
use crate::cast::Cast;
use crate::frozen;
use crate::limits::{LONGEST_PLAN_S, MOST_PLANNED};
use crate::now::Now;
use crate::refusal::Refusal;
use crate::script::{Fate, Planned, Script};
use crate::world_change;

/// Makes an event happen for which [`OtherAction::can_be_planned`] is true; the event takes effect at the next step.
///
/// # Errors
/// Returns why the event cannot happen. Nothing is changed then.
pub(crate) fn happen(event: &OtherAction, cast: &Cast, now: &mut Now) -> Result<(), Refusal> {
    if let OtherAction::AnchorFault { anchor, fault, on } = event {
        let mut anchors = now.simulation.setup().world.anchors.iter();
        let index = anchors.position(|setup| setup.gear.name == *anchor);
        let index =
            index.ok_or_else(|| Refusal::new(format_args!("there is no anchor `{anchor}`")))?;
        let mut faults = now.simulation.anchors()[index].state.faults;
        fault.switch(&mut faults, *on);
        return now.simulation.set_anchor_faults(index, faults).map_err(Refusal::new);
    }
    let change = world_change::resolve(event, cast, now.simulation.setup())?;
    let Some(change) = change else { unreachable!("it cannot be planned: {event:?}") };
    now.simulation.change(&change).map_err(Refusal::new)?;
    frozen::renew(&mut now.frozen, &now.simulation);
    Ok(())
}

/// Plans an event. The event must be one that could also be carried out at once.
///
/// # Errors
/// Returns why the event cannot be planned.
pub(crate) fn plan(
    event: &OtherAction,
    at_s: f64,
    cast: &Cast,
    now: &mut Now,
) -> Result<(), Refusal> {
    if !event.can_be_planned() {
        return Err(Refusal::new("only changes of the weather and faults can be planned"));
    }
    let t_s = now.simulation.time_s();
    if !(at_s > t_s && at_s <= t_s + LONGEST_PLAN_S) {
        return Err(Refusal::new(format_args!(
            "an event is planned for a time from now to {} h from now",
            LONGEST_PLAN_S / 3600.0
        )));
    }
    let waiting = now.script.planned.iter().filter(|planned| planned.fate == Fate::Waits).count();
    if waiting >= MOST_PLANNED {
        return Err(Refusal::new(format_args!("at most {MOST_PLANNED} events can wait")));
    }
    happen(event, cast, &mut now.clone())?;
    let Script { planned, count, .. } = &mut now.script;
    *count += 1;
    planned.push(Planned { id: *count, at_s, event: event.clone(), fate: Fate::Waits });
    // What is over is forgotten beyond some number, the oldest first.
    if planned.len() > 2 * MOST_PLANNED
        && let Some(over) = planned.iter().position(|planned| planned.fate != Fate::Waits)
    {
        planned.remove(over);
    }
    Ok(())
}

/// True if a planned event is due in the next step.
pub(crate) fn is_due(now: &Now) -> bool {
    let Script { planned, .. } = &now.script;
    let end_s = now.simulation.time_s() + now.simulation.setup().step_s;
    let is_due = |planned: &Planned| planned.fate == Fate::Waits && planned.at_s < end_s;
    planned.iter().any(is_due)
}

/// Carries out the planned events that are due in the next step. Returns the planned events that happened.
pub(crate) fn run(cast: &Cast, now: &mut Now) -> Vec<OtherAction> {
    let t_s = now.simulation.time_s();
    let end_s = t_s + now.simulation.setup().step_s;
    let mut fired = Vec::new();
    for index in 0..now.script.planned.len() {
        let Planned { at_s, event, fate, .. } = &now.script.planned[index];
        // As an order, an event takes effect in the step that contains its time.
        if *fate != Fate::Waits || *at_s >= end_s {
            continue;
        }
        let event = event.clone();
        let fate = match happen(&event, cast, now) {
            Ok(()) => {
                fired.push(event);
                Fate::Fired
            }
            Err(why) => Fate::Refused(why.to_string()),
        };
        now.script.planned[index].fate = fate;
    }
    fired
}
