//! The instructor's script: events at given times. The script is a part of the state that is kept, rewound and
//! branched. The script runs before each step.

use fenderline_sim::{PlannedChange, Setup};

use crate::action::{Action, OtherAction};
use crate::carry_out::carry_out;
use crate::cast::Cast;
use crate::limits::{LONGEST_PLAN_S, MOST_PLANNED};
use crate::message::PlannedNow;
use crate::refusal::Refusal;
use crate::session::Now;
use crate::world_change;

/// The fate of a planned event.
#[derive(Clone, Debug, PartialEq)]
enum Fate {
    Waits,
    Fired,
    Cancelled,
    /// The event could not be carried out at its time. The text is the reason.
    Refused(String),
}

/// An event at a time.
#[derive(Clone, Debug, PartialEq)]
struct Planned {
    id: u64,
    at_s: f64,
    event: OtherAction,
    fate: Fate,
}

/// The instructor's script.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Script {
    planned: Vec<Planned>,
    /// Number of events that were planned so far.
    count: u64,
}

impl Script {
    /// The script of a scenario with planned changes.
    pub(crate) fn of_scenario(planned: &[PlannedChange], cast: &Cast, setup: &Setup) -> Script {
        let events = planned.iter().zip(1..).map(|(planned, id)| Planned {
            id,
            at_s: planned.at_s,
            event: world_change::named(&planned.change, cast, setup),
            fate: Fate::Waits,
        });
        Script { planned: events.collect(), count: planned.len() as u64 }
    }

    /// The events that wait, with their times (s).
    pub(crate) fn waiting(&self) -> impl Iterator<Item = (f64, &OtherAction)> {
        let waiting = self.planned.iter().filter(|planned| planned.fate == Fate::Waits);
        waiting.map(|planned| (planned.at_s, &planned.event))
    }

    /// The planned events in the order of their times, for the instructor's page.
    pub(crate) fn messages(&self) -> Vec<PlannedNow> {
        let mut all: Vec<PlannedNow> = self.planned.iter().map(Planned::message).collect();
        all.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
        all
    }

    /// Cancels an event that waits.
    ///
    /// # Errors
    /// No event with this number waits.
    pub(crate) fn cancel(&mut self, id: u64) -> Result<(), Refusal> {
        let waits = |planned: &&mut Planned| planned.id == id && planned.fate == Fate::Waits;
        let planned = self.planned.iter_mut().find(waits);
        planned.ok_or_else(|| Refusal::new("this event has happened, or was cancelled"))?.fate =
            Fate::Cancelled;
        Ok(())
    }
}

impl Planned {
    fn message(&self) -> PlannedNow {
        let (state, reason) = match &self.fate {
            Fate::Waits => ("waits", None),
            Fate::Fired => ("fired", None),
            Fate::Cancelled => ("cancelled", None),
            Fate::Refused(reason) => ("refused", Some(reason.clone())),
        };
        PlannedNow { id: self.id, at_s: self.at_s, event: self.event.clone(), state, reason }
    }
}

/// Plans an event. The event must be one that could be carried out now.
///
/// # Errors
/// The reason why it cannot be planned.
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
    carry_out(&Action::Other(event.clone()), cast, &mut now.clone())?;
    let Script { planned, count, .. } = &mut now.script;
    *count += 1;
    planned.push(Planned { id: *count, at_s, event: event.clone(), fate: Fate::Waits });
    // Above a number of events, those that are over are forgotten, the oldest first.
    if planned.len() > 2 * MOST_PLANNED
        && let Some(over) = planned.iter().position(|planned| planned.fate != Fate::Waits)
    {
        planned.remove(over);
    }
    Ok(())
}

/// True if an event is due in the next step.
pub(crate) fn is_due(now: &Now) -> bool {
    let Script { planned, .. } = &now.script;
    let end_s = now.simulation.time_s() + now.simulation.setup().step_s;
    let is_due = |planned: &Planned| planned.fate == Fate::Waits && planned.at_s < end_s;
    planned.iter().any(is_due)
}

/// Carries out the events that are due in the next step. Returns these events.
pub(crate) fn run(cast: &Cast, now: &mut Now) -> Vec<OtherAction> {
    let t_s = now.simulation.time_s();
    let end_s = t_s + now.simulation.setup().step_s;
    let mut fired = Vec::new();
    for index in 0..now.script.planned.len() {
        let Planned { at_s, event, fate, .. } = &now.script.planned[index];
        // An event, like an order, takes effect in the step that contains its time.
        if *fate != Fate::Waits || *at_s >= end_s {
            continue;
        }
        let event = event.clone();
        let fate = match carry_out(&Action::Other(event.clone()), cast, now) {
            Ok(_) => {
                fired.push(event);
                Fate::Fired
            }
            Err(why) => Fate::Refused(why.to_string()),
        };
        now.script.planned[index].fate = fate;
    }
    fired
}
