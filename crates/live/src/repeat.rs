//! Steps again through a branch of a session from its start, and keeps the log of commands, alarms, acknowledgements,
//! notes and events. The report of a session is made from this log.

use fenderline_sim::exercise::Assessment;
use fenderline_sim::{Simulation, StepRecord};

use crate::action::{Action, OtherAction};
use crate::alarm_book::{Alarm, Level};
use crate::refusal::Refusal;
use crate::session::{Given, Session, StepError};

/// If the cause of an alarm comes back within this time (s), the log counts it as the same alarm. A speed that varies
/// about its limit then makes one line in the log and not a hundred.
const SAME_ALARM_S: f64 = 10.0;

/// A command in the log of a session.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedCommand {
    /// Time at which the command took effect (s).
    pub t_s: f64,
    /// The person who gave the command.
    pub who: String,
    /// The command.
    pub action: Action,
}

/// An alarm or caution in the log of a session.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedAlarm {
    /// Time at which the cause of the alarm began (s).
    pub t_s: f64,
    /// Time at which the cause of the alarm ended (s); `None` while the cause is active.
    pub until_s: Option<f64>,
    /// Kind and subject of the alarm, see [`Alarm::key`].
    pub key: String,
    /// The greatest level of the alarm.
    pub level: Level,
    /// The text of the alarm when it reached its greatest level.
    pub text: String,
    /// Time at which the alarm was acknowledged at its greatest level (s), and the person who acknowledged it. `None`
    /// if nobody did.
    pub acknowledged: Option<(f64, String)>,
}

/// An acknowledgement of an alarm in the log.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedAcknowledgement {
    /// Time of the acknowledgement (s).
    pub t_s: f64,
    /// The person who acknowledged the alarm.
    pub who: String,
    /// The text of the alarm.
    pub text: String,
}

/// A note in the log.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedNote {
    /// Time of the note (s).
    pub t_s: f64,
    /// The person who wrote the note.
    pub who: String,
    /// The text of the note. The text is empty for a note that is only a mark.
    pub text: String,
}

/// The log of what people did and what happened in a session. Each list of the log is in the order of time.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SessionLog {
    /// The commands that changed the simulated world.
    pub commands: Vec<LoggedCommand>,
    /// The alarms and cautions.
    pub alarms: Vec<LoggedAlarm>,
    /// The acknowledgements of alarms.
    pub acknowledgements: Vec<LoggedAcknowledgement>,
    /// The notes that people wrote for the debriefing.
    pub notes: Vec<LoggedNote>,
    /// Time (s) and text of the other events, such as a line that parted.
    pub events: Vec<(f64, String)>,
}

/// Steps through a branch of a session from its start.
#[derive(Clone, Debug)]
pub struct Repeat {
    session: Session,
    log: SessionLog,
    /// The keys of all alarms so far, and for each key the index of its last alarm in the log.
    known: Vec<(String, usize)>,
}

/// The name that the log gives to planned changes, in place of a person.
const PLAN: &str = "plan";

impl Repeat {
    /// Opens a branch of `session` at its start. Stepping through the branch adds nothing to the recording.
    ///
    /// # Errors
    /// Fails if there is no branch with this number, or if the branch has no steps.
    pub fn of(mut session: Session, branch: usize) -> Result<Repeat, Refusal> {
        session.go_to_branch(branch)?;
        session.rewind(0)?;
        if !session.is_rewound() {
            return Err(Refusal::new("the session has no steps"));
        }
        let mut repeat = Repeat { session, log: SessionLog::default(), known: Vec::new() };
        repeat.note_alarms(repeat.session.causes_for_alarm());
        Ok(repeat)
    }

    /// The simulation in the state that the repeat has reached.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        self.session.simulation()
    }

    /// The exercise, if the scenario has one.
    #[must_use]
    pub fn exercise(&self) -> Option<&Assessment> {
        self.session.exercise()
    }

    /// True at the end of the branch.
    #[must_use]
    pub fn is_done(&self) -> bool {
        !self.session.is_rewound()
    }

    /// Number of steps of the branch from the start of the session.
    #[must_use]
    pub fn steps_total(&self) -> u64 {
        self.session.branches()[self.session.current_branch()].ends_tick
    }

    /// Takes one step and hands the record of the step to `each`.
    ///
    /// # Errors
    /// The errors of [`Session::step`].
    ///
    /// # Panics
    /// Panics if the branch is at its end.
    pub fn step(&mut self, each: impl FnOnce(&StepRecord<'_>)) -> Result<(), StepError> {
        assert!(!self.is_done(), "the branch is at its end");
        self.note_given();
        let t_s = self.simulation().time_s();
        self.session.step_with(each)?;
        for event in self.session.fired() {
            let (who, action) = (PLAN.to_owned(), Action::Other(event.clone()));
            self.log.commands.push(LoggedCommand { t_s, who, action });
        }
        self.log.events.extend(self.session.take_events());
        self.note_alarms(self.session.causes_for_alarm());
        if self.is_done() {
            // The commands given at the end, before anybody went on.
            self.note_given();
        }
        Ok(())
    }

    /// Adds the commands that were given at the present tick to the log.
    fn note_given(&mut self) {
        let t_s = self.simulation().time_s();
        for Given { who, action, .. } in self.session.given_now() {
            let who = who.clone();
            match action {
                Action::Other(OtherAction::Acknowledge { key }) => {
                    let known = self.known.iter().find(|(other, _)| other == key);
                    // A recording by a version with other alarms may lack the alarm.
                    let Some((_, at)) = known else { continue };
                    let text = self.log.alarms[*at].text.clone();
                    // This acknowledges earlier alarms of the key too, if they have ended and still wait. A caution
                    // does not wait.
                    for (index, alarm) in self.log.alarms.iter_mut().enumerate() {
                        let waits = index == *at || alarm.level == Level::Alarm;
                        if alarm.key == *key && waits {
                            alarm.acknowledged.get_or_insert_with(|| (t_s, who.clone()));
                        }
                    }
                    self.log.acknowledgements.push(LoggedAcknowledgement { t_s, who, text });
                }
                Action::Other(OtherAction::Note { text }) => {
                    self.log.notes.push(LoggedNote { t_s, who, text: text.clone() });
                }
                Action::Order(_) | Action::Other(_) => {
                    self.log.commands.push(LoggedCommand { t_s, who, action: action.clone() });
                }
            }
        }
    }

    /// The log up to the state that the repeat has reached.
    #[must_use]
    pub fn log(&self) -> &SessionLog {
        &self.log
    }

    fn note_alarms(&mut self, causes: Vec<Alarm>) {
        let t_s = self.simulation().time_s();
        let alarms = &mut self.log.alarms;
        for (key, at) in &self.known {
            let alarm = &mut alarms[*at];
            if alarm.until_s.is_none() && causes.iter().all(|cause| cause.key != *key) {
                alarm.until_s = Some(t_s);
            }
        }
        for Alarm { level, key, text, .. } in causes {
            match self.known.iter_mut().find(|(other, _)| *other == key) {
                Some((_, at)) if alarms[*at].is_within(t_s) => {
                    let alarm = &mut alarms[*at];
                    alarm.until_s = None;
                    if level > alarm.level {
                        // If the level rises, the alarm has to be acknowledged again.
                        (alarm.level, alarm.text, alarm.acknowledged) = (level, text, None);
                    }
                }
                Some((_, at)) => *at = begin(alarms, t_s, key, level, text),
                None => self.known.push((key.clone(), begin(alarms, t_s, key, level, text))),
            }
        }
    }
}

impl LoggedAlarm {
    /// True if the alarm is active, or if its cause ended so recently that the alarm continues when the cause comes
    /// back. An alarm that was acknowledged and whose cause has ended is over.
    fn is_within(&self, t_s: f64) -> bool {
        self.until_s
            .is_none_or(|until_s| self.acknowledged.is_none() && t_s - until_s < SAME_ALARM_S)
    }
}

/// Adds an alarm to the log and returns its index.
fn begin(
    alarms: &mut Vec<LoggedAlarm>,
    t_s: f64,
    key: String,
    level: Level,
    text: String,
) -> usize {
    alarms.push(LoggedAlarm { t_s, until_s: None, key, level, text, acknowledged: None });
    alarms.len() - 1
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::action::OtherAction;
    use crate::source::Source;

    fn session() -> Session {
        let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) =
            Source::collect("a.toml", text.to_owned(), vec![], none).expect("a scenario");
        Session::open(source).expect("a set-up")
    }

    fn wind(speed_mps: f64) -> Action {
        OtherAction::Wind { speed_mps, from_rad: 1.0, over_s: 0.0 }.into()
    }

    #[test]
    fn a_repeated_branch_has_the_bits_and_the_commands_of_the_session() {
        let mut session = session();
        session.command("pilot 1", 0, wind(5.0)).expect("it may blow");
        for _ in 0..40 {
            session.step().expect("a step");
        }
        session.rewind(20).expect("it is there");
        session.branch().expect("a branch");
        session.command("instructor 2", 0, wind(9.0)).expect("it may blow");
        for _ in 0..30 {
            session.step().expect("a step");
        }
        let bits = session.bits();
        let mut repeat = Repeat::of(session.clone(), 1).expect("a branch");
        let mut steps = 0;
        while !repeat.is_done() {
            repeat.step(|record| assert_eq!(record.index, steps)).expect("a step");
            steps += 1;
        }
        assert_eq!((steps, repeat.steps_total()), (50, 50));
        assert_eq!(repeat.session.bits(), bits);
        let who = |log: &SessionLog| -> Vec<String> {
            log.commands.iter().map(|command| command.who.clone()).collect()
        };
        assert_eq!(who(repeat.log()), ["pilot 1", "instructor 2"]);
        assert!(Repeat::of(session.clone(), 2).is_err());
        let mut first = Repeat::of(session, 0).expect("a branch");
        while !first.is_done() {
            first.step(|_| ()).expect("a step");
        }
        assert_eq!(who(first.log()), ["pilot 1"]);
    }

    #[test]
    fn a_session_without_steps_cannot_be_repeated() {
        let refusal = Repeat::of(session(), 0).expect_err("it has no steps");
        assert!(refusal.to_string().contains("no steps"));
    }

    #[test]
    fn an_alarm_that_comes_back_at_once_is_one_line_of_the_log() {
        let mut session = session();
        session.step().expect("a step");
        let mut repeat = Repeat::of(session, 0).expect("a branch");
        let alarm = |level, text: &str| Alarm {
            level,
            key: "approach bow ship".into(),
            text: text.into(),
            about: vec![],
        };
        repeat.note_alarms(vec![alarm(Level::Caution, "0.21 m/s")]);
        repeat.note_alarms(vec![]);
        repeat.note_alarms(vec![alarm(Level::Alarm, "0.25 m/s")]);
        repeat.note_alarms(vec![alarm(Level::Caution, "0.20 m/s")]);
        let log = &repeat.log().alarms;
        assert_eq!(log.len(), 1);
        assert_eq!((log[0].level, &*log[0].text, log[0].until_s), (Level::Alarm, "0.25 m/s", None));
        repeat.log.alarms[0].until_s = Some(repeat.simulation().time_s() - SAME_ALARM_S);
        repeat.note_alarms(vec![alarm(Level::Caution, "0.20 m/s")]);
        assert_eq!(repeat.log().alarms.len(), 2);
    }
}
