//! The present state of a session: everything that changes from tick to tick.

use fenderline_sim::Simulation;
use fenderline_sim::exercise::{Assessment, ExerciseSetup};

use crate::alarm_book::AlarmBook;
use crate::approach::ApproachLimit;
use crate::exercise::ending;
use crate::frame::seen::Seen;
use crate::frozen::Frozen;
use crate::manual_control::ManualControl;
use crate::script::Script;

/// Everything in a session that changes from tick to tick.
#[derive(Clone, Debug)]
pub(crate) struct Now {
    pub(crate) simulation: Simulation,
    pub(crate) manual: ManualControl,
    pub(crate) approach: ApproachLimit,
    /// For each vessel, what her frozen instruments show.
    pub(crate) frozen: Vec<Frozen>,
    pub(crate) seen: Seen,
    pub(crate) alarms: AlarmBook,
    /// The exercise, if the scenario has one.
    pub(crate) exercise: Option<Assessment>,
    pub(crate) script: Script,
    /// Number of steps taken.
    pub(crate) tick: u64,
}

impl Now {
    pub(crate) fn before_the_first_step(
        simulation: Simulation,
        exercise: Option<ExerciseSetup>,
    ) -> Now {
        let exercise = exercise.map(|setup| Assessment::new(setup, &simulation));
        let seen = Seen::before_the_first_step(&simulation);
        let (manual, approach) = (ManualControl::default(), ApproachLimit::default());
        let frozen = Frozen::none(&simulation);
        let (alarms, script) = (AlarmBook::default(), Script::default());
        Now { simulation, manual, approach, frozen, seen, alarms, exercise, script, tick: 0 }
    }

    /// Updates the exercise after a step. Returns the text of the exercise's end, if the exercise ends with this step.
    pub(crate) fn mark_exercise(&mut self) -> Option<&'static str> {
        let exercise = self.exercise.as_mut()?;
        if exercise.state().ended_s().is_some() {
            return None;
        }
        exercise.update(&self.simulation);
        ending(exercise)
    }
}
