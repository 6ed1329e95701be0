//! The instructor's script of a session: events that are planned for given times. The script is a part of a session's
//! state, which is kept, rewound and branched. The script runs before each step of the simulation.

use fenderline_sim::{PlannedChange, Setup};

use crate::action::OtherAction;
use crate::cast::Cast;
use crate::message::PlannedNow;
use crate::refusal::Refusal;
use crate::world_change;

/// The fate of a planned event.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Fate {
    Waits,
    Fired,
    Cancelled,
    /// The event could not be carried out at its time. The text says why the event was refused.
    Refused(String),
}

/// An event that the instructor or the scenario has planned for a time of the run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Planned {
    pub(crate) id: u64,
    pub(crate) at_s: f64,
    pub(crate) event: OtherAction,
    pub(crate) fate: Fate,
}

/// The instructor's script.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Script {
    pub(crate) planned: Vec<Planned>,
    /// Number of events that were planned in the session so far.
    pub(crate) count: u64,
}

impl Script {
    /// The script of a scenario, with the changes that the scenario plans.
    pub(crate) fn of_scenario(planned: &[PlannedChange], cast: &Cast, setup: &Setup) -> Script {
        let events = planned.iter().zip(1..).map(|(planned, id)| Planned {
            id,
            at_s: planned.at_s,
            event: world_change::named(&planned.change, cast, setup),
            fate: Fate::Waits,
        });
        Script { planned: events.collect(), count: planned.len() as u64 }
    }

    /// The planned events that wait, with their times (s).
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

    /// Cancels a planned event that waits for its time.
    ///
    /// # Errors
    /// Fails if no event with the number `id` waits.
    pub(crate) fn cancel(&mut self, id: u64) -> Result<(), Refusal> {
        let waits = |planned: &&mut Planned| planned.id == id && planned.fate == Fate::Waits;
        let planned = self.planned.iter_mut().find(waits);
        planned
            .ok_or_else(|| Refusal::new("the planned event has happened, or was cancelled"))?
            .fate = Fate::Cancelled;
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
