//! The session: a simulation, its log of commands, and rewinding.

use std::fmt;
use std::ops::Range;

use fenderline_scenario::ScenarioError;
use fenderline_sim::exercise::Assessment;
use fenderline_sim::{SetupError, SimError, Simulation, StepRecord};

use crate::action::{Action, OtherAction};
use crate::alarm_book::{AlarmBook, Level};
use crate::bits::fingerprint;
use crate::carry_out::carry_out;
use crate::cast::Cast;
use crate::checkpoints::Checkpoints;
use crate::exercise;
use crate::frame;
use crate::ghost::GhostError;
use crate::happening;
use crate::info::Info;
use crate::limits::{
    Full, LONGEST_HEADER_BYTES, MARKS, MOST_BRANCHES, MOST_COMMANDS, MOST_NOTES, MOST_TICKS,
    NOTE_TICKS,
};
use crate::message::{ExerciseInfo, ExerciseMarks, History, PlannedNow, Role, Then};
use crate::now::Now;
use crate::past::{Of, Past};
use crate::recording::{Line, Writer};
use crate::refusal::Refusal;
use crate::script::Script;
use crate::source::Source;

/// A branch of a session: the commands that were given from one tick on. At ticks before the branch begins, the
/// commands of its parent branch apply.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The branch from which this branch begins; `None` for the first branch.
    pub parent: Option<usize>,
    /// First tick of the branch.
    pub from_tick: u64,
    /// Last tick of the branch so far.
    pub ends_tick: u64,
    /// The commands of the branch, by increasing tick.
    commands: Vec<Given>,
}

/// A command that was given in a session.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Given {
    /// The tick at which the command takes effect.
    pub(crate) tick: u64,
    pub(crate) who: String,
    pub(crate) action: Action,
}

/// A simulation that people steer. The documentation of the crate describes sessions.
#[derive(Clone, Debug)]
pub struct Session {
    source: Source,
    title: String,
    cast: Cast,
    info: Info,
    branches: Vec<Branch>,
    current: usize,
    commands: usize,
    /// Number of ticks of all branches together.
    ticks: u64,
    now: Now,
    checkpoints: Checkpoints<Now>,
    writer: Writer,
    /// Time (s) and text of the events since the last call of [`Session::take_events`].
    events: Vec<(f64, String)>,
    past: Past,
    /// The planned events that happened just before the last step.
    fired: Vec<OtherAction>,
    /// Number of times that something other than a step or an order of the scenario has changed the simulation.
    interventions: u64,
}

/// Why a session cannot be opened.
#[derive(Clone, Debug, PartialEq)]
pub enum SessionError {
    /// The scenario cannot be used.
    Scenario(Box<ScenarioError>),
    /// The simulation refuses the set-up.
    Setup(SetupError),
    /// The scenario, with all files that it names, is too large for the first line of a recording.
    TooLarge,
    /// The measured ship beside the simulated ships cannot be shown.
    Ghost(GhostError),
}

/// Why a step failed.
#[derive(Clone, Debug, PartialEq)]
pub enum StepError {
    /// The simulation failed.
    Simulation(SimError),
    /// The session has reached a limit and cannot go on.
    Full(Full),
}

impl fmt::Display for SessionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SessionError::Scenario(error) => error.fmt(f),
            SessionError::Setup(error) => error.fmt(f),
            SessionError::Ghost(error) => error.fmt(f),
            SessionError::TooLarge => write!(
                f,
                "the scenario with all files that it names is larger than {} MiB: it cannot be recorded",
                LONGEST_HEADER_BYTES >> 20
            ),
        }
    }
}

impl std::error::Error for SessionError {}

impl fmt::Display for StepError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StepError::Simulation(error) => error.fmt(f),
            StepError::Full(full) => full.fmt(f),
        }
    }
}

impl std::error::Error for StepError {}

impl Session {
    /// Opens a session before its first step. The first line of the recording is ready to be taken.
    ///
    /// # Errors
    /// Fails for a scenario that is invalid, cannot be simulated, or is too large to be recorded.
    pub fn open(source: Source) -> Result<Session, SessionError> {
        if let Some(ghost) = &source.ghost {
            ghost.check().map_err(SessionError::Ghost)?;
        }
        let writer = Writer::begin(&source).ok_or(SessionError::TooLarge)?;
        let mut scenario = source.scenario().map_err(|e| SessionError::Scenario(Box::new(e)))?;
        // The instructor's script takes over the scenario's planned changes, so that the instructor can see and cancel
        // them.
        let planned = std::mem::take(&mut scenario.setup.world.planned);
        let simulation = Simulation::new(scenario.setup).map_err(SessionError::Setup)?;
        let cast = Cast::of(simulation.setup());
        let info = Info::of(simulation.setup(), &cast);
        let mut now = Now::before_the_first_step(simulation, scenario.exercise);
        now.script = Script::of_scenario(&planned, &cast, now.simulation.setup());
        frame::note_alarms(&mut now, &cast, &info);
        let first = Branch { parent: None, from_tick: 0, ends_tick: 0, commands: Vec::new() };
        Ok(Session {
            source,
            title: scenario.title,
            cast,
            info,
            branches: vec![first],
            current: 0,
            commands: 0,
            ticks: 0,
            checkpoints: Checkpoints::new(now.clone()),
            past: Past::new(now.simulation.setup().step_s),
            now,
            writer,
            events: Vec::new(),
            fired: Vec::new(),
            interventions: 0,
        })
    }

    /// The scenario of the session, with the files that the scenario names.
    #[must_use]
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The scenario's title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// The roles of the scenario's vessels.
    #[must_use]
    pub fn cast(&self) -> &Cast {
        &self.cast
    }

    /// The data of the scenario that do not change, for pages.
    #[must_use]
    pub fn info(&self) -> &Info {
        &self.info
    }

    /// The list of alarms as it is after the present tick.
    #[must_use]
    pub fn alarms(&self) -> &AlarmBook {
        &self.now.alarms
    }

    /// The events that the instructor has planned, in the order of their times, and what became of each.
    #[must_use]
    pub fn planned(&self) -> Vec<PlannedNow> {
        self.now.script.messages()
    }

    /// The planned events that happened just before the last step.
    pub(crate) fn fired(&self) -> &[OtherAction] {
        &self.fired
    }

    /// The exercise of the session, if the scenario has one.
    #[must_use]
    pub fn exercise(&self) -> Option<&Assessment> {
        self.now().exercise.as_ref()
    }

    /// The data of the exercise that do not change, for pages.
    #[must_use]
    pub fn exercise_info(&self) -> Option<ExerciseInfo> {
        self.exercise().map(|exercise| exercise::info(exercise, self.simulation().setup()))
    }

    /// The score and the deductions of the exercise so far, for the instructor's page.
    #[must_use]
    pub fn exercise_marks(&self) -> Option<ExerciseMarks> {
        self.exercise().map(|exercise| exercise::marks(exercise, self.simulation().setup()))
    }

    /// The simulation in the session's present state.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        &self.now.simulation
    }

    /// Number of times that something other than a step or an order of the scenario has changed the simulation:
    /// commands, events, or going to another tick.
    pub(crate) fn interventions(&self) -> u64 {
        self.interventions
    }

    pub(crate) fn now(&self) -> &Now {
        &self.now
    }

    /// Number of steps from the start to the present state.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.now.tick
    }

    /// All branches, by number.
    #[must_use]
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// Number of the current branch.
    #[must_use]
    pub fn current_branch(&self) -> usize {
        self.current
    }

    /// True if the present tick is before the end of the current branch.
    #[must_use]
    pub fn is_rewound(&self) -> bool {
        self.now.tick < self.branches[self.current].ends_tick
    }

    /// The fingerprint of the present state, in hexadecimal.
    #[must_use]
    pub fn bits(&self) -> String {
        bits(&self.now.simulation)
    }

    /// Carries out and records a command, which takes effect at the next step. Returns the tick at which the command
    /// takes effect. The time `at_ms` is used for the recording only.
    ///
    /// # Errors
    /// Returns why the command was refused. A refused command changes nothing.
    pub fn command(&mut self, who: &str, at_ms: u64, action: Action) -> Result<u64, Refusal> {
        if self.is_rewound() {
            return Err(Refusal::new(
                "the run is rewound, and nothing can be ordered in the past: begin a branch here, or go to the \
                 end of the run",
            ));
        }
        self.has_room_for(1)?;
        if matches!(action, Action::Other(OtherAction::Note { .. })) {
            self.has_room_for_note()?;
        }
        let (branch, tick) = (self.current, self.now.tick);
        let line =
            Line::Command { branch, tick, who: who.to_owned(), at_ms, action: action.clone() };
        let line = self.writer.prepare(&line).map_err(Refusal::new)?;
        let said = self.said_of(who, &action);
        let dropped = carry_out(&action, &self.cast, &mut self.now)?;
        self.interventions += 1;
        if let Some(text) = said {
            self.tell(text);
        }
        if dropped {
            let text = "now under manual control: the scenario's later orders to the same vessel, tug, line or anchor are cancelled";
            self.tell(text.to_owned());
        }
        self.commands += 1;
        self.writer.put(&line);
        self.branches[branch].commands.push(Given { tick, who: who.to_owned(), action });
        Ok(tick)
    }

    /// Checks that the limits allow `commands` further commands.
    pub(crate) fn has_room_for(&self, commands: usize) -> Result<(), Refusal> {
        if self.commands + commands <= MOST_COMMANDS {
            return Ok(());
        }
        Err(Refusal::new(format_args!("a session has at most {MOST_COMMANDS} commands")))
    }

    /// The text of the event that a command makes if it acknowledges an alarm or writes a note.
    fn said_of(&self, who: &str, action: &Action) -> Option<String> {
        match action {
            Action::Other(OtherAction::Acknowledge { key }) => {
                self.now.alarms.text(key).map(|text| format!("{who} acknowledges: {text}"))
            }
            Action::Other(OtherAction::Note { text }) if text.is_empty() => {
                Some(format!("{who} marks this moment"))
            }
            Action::Other(OtherAction::Note { text }) => Some(format!("{who} notes: {text}")),
            Action::Order(_) | Action::Other(_) => None,
        }
    }

    /// Adds a text to the events of the session, at the present tick.
    fn tell(&mut self, text: String) {
        let t_s = self.now.simulation.time_s();
        let then = Then { t_s, text: text.clone(), level: None };
        self.past.keep_event(self.current, self.now.tick, then);
        self.events.push((t_s, text));
    }

    /// The past that strip charts and the log show: the last half hour before the present tick. `vessel` is the index
    /// of the ship whose past is wanted: the own ship, or another ship that can be conned. A pilot gets the values that
    /// the ship's instruments showed, frozen instruments included. Everybody else gets the true values of the ship.
    ///
    /// # Errors
    /// Fails if the vessel is a tug or does not exist. The session keeps no past of a tug.
    pub fn history(&self, vessel: Option<usize>, role: &Role) -> Result<History, Refusal> {
        let (tick, t_s) = (self.now.tick, self.now.simulation.time_s());
        let vessel = vessel.or(self.cast.own);
        let place = match vessel {
            Some(vessel) => self.cast.ships().into_iter().position(|ship| ship == vessel),
            None => Some(0),
        };
        let place = place.ok_or_else(|| Refusal::new("the past of this vessel is not kept"))?;
        let of = Of { place, vessel, as_shown: matches!(role, Role::Pilot { .. }) };
        Ok(self.past.before(tick, t_s, of, |tick| self.segment(self.current, tick).0))
    }

    /// Three numbers, of which at least one changes whenever the result of [`Session::history`] changes.
    #[must_use]
    pub fn history_version(&self) -> (usize, u64, u64) {
        (self.current, self.now.tick, self.past.version())
    }

    /// Checks that the limits allow one more note for the debriefing.
    fn has_room_for_note(&self) -> Result<(), Refusal> {
        let commands = self.branches[self.current].commands.iter().rev();
        let lately = commands.take_while(|given| given.tick + NOTE_TICKS > self.now.tick);
        let is_note =
            |given: &&Given| matches!(given.action, Action::Other(OtherAction::Note { .. }));
        if lately.filter(is_note).count() >= MOST_NOTES {
            return Err(Refusal::new(format_args!(
                "there are {MOST_NOTES} notes within {NOTE_TICKS} ticks already: wait before you write the next"
            )));
        }
        Ok(())
    }

    /// Takes one step. While the session is rewound, the step repeats the recorded commands.
    ///
    /// # Errors
    /// Fails if the simulation failed, or if the session has reached a limit. A step that fails leaves the session
    /// unchanged.
    pub fn step(&mut self) -> Result<(), StepError> {
        self.step_with(|_| ())
    }

    /// Takes one step as [`Session::step`] does. The function `each` gets the record of the step.
    ///
    /// # Errors
    /// The errors of [`Session::step`].
    pub fn step_with(&mut self, each: impl FnOnce(&StepRecord<'_>)) -> Result<(), StepError> {
        let rewound = self.is_rewound();
        if rewound {
            self.apply_recorded();
        } else {
            self.has_room().map_err(StepError::Full)?;
        }
        self.advance(each).map_err(StepError::Simulation)?;
        let tick = self.now.tick;
        if rewound {
            if !self.is_rewound() {
                self.apply_recorded();
            }
            return Ok(());
        }
        let branch = self.current;
        self.branches[branch].ends_tick = tick;
        self.ticks += 1;
        if tick.is_multiple_of(MARKS) {
            self.mark();
        }
        Ok(())
    }

    /// Checks that the limits allow one more tick of the session.
    fn has_room(&self) -> Result<(), Full> {
        if self.ticks >= MOST_TICKS {
            return Err(Full::Ticks);
        }
        if self.writer.has_room() { Ok(()) } else { Err(Full::Bytes) }
    }

    /// Takes one step of the simulation and keeps its contacts and events.
    fn advance(&mut self, each: impl FnOnce(&StepRecord<'_>)) -> Result<(), SimError> {
        let before = happening::is_due(&self.now).then(|| self.now.clone());
        self.fired = happening::run(&self.cast, &mut self.now);
        let Now { simulation, seen, tick, .. } = &mut self.now;
        let t_s = simulation.time_s();
        let record = match simulation.step() {
            Ok(record) => record,
            Err(error) => {
                // After a step that failed, the events that were due in it count as not carried out.
                if let Some(before) = before {
                    self.now = before;
                }
                self.fired.clear();
                return Err(error);
            }
        };
        seen.keep(&record);
        each(&record);
        *tick += 1;
        self.interventions += u64::from(!self.fired.is_empty());
        let ending = self.now.mark_exercise();
        let sample = frame::note_alarms(&mut self.now, &self.cast, &self.info);
        let Now { simulation, seen, alarms, tick, .. } = &self.now;
        let ending = ending.map(|text| (simulation.time_s(), text.to_owned()));
        let seen = seen.events(simulation.setup()).map(|text| (t_s, text));
        let events: Vec<_> = seen.chain(ending).collect();
        let begun = alarms.begun_at(simulation.time_s()).map(|(level, text)| {
            let what = if level == Level::Alarm { "ALARM" } else { "Caution" };
            let text = format!("{what}: {text}");
            Then { t_s: simulation.time_s(), text, level: Some(level.word()) }
        });
        let told =
            events.iter().map(|(t_s, text)| Then { t_s: *t_s, text: text.clone(), level: None });
        let (by, _) = self.segment(self.current, tick - 1);
        self.past.keep_step(by, *tick, sample, told.chain(begun));
        self.events.extend(events);
        let (segment, _) = self.segment(self.current, self.now.tick);
        self.checkpoints.offer(segment, self.now.tick, &self.now);
        Ok(())
    }

    /// Carries out the recorded commands of the present tick.
    pub(crate) fn apply_recorded(&mut self) {
        let (segment, of_tick) = self.given_at(self.now.tick);
        for Given { action, .. } in &self.branches[segment].commands[of_tick] {
            let again = carry_out(action, &self.cast, &mut self.now);
            assert!(again.is_ok(), "it was carried out before in this state: {action:?}");
            self.interventions += 1;
        }
    }

    /// The commands of the present tick, in the order in which they were given.
    pub(crate) fn given_now(&self) -> &[Given] {
        let (segment, of_tick) = self.given_at(self.now.tick);
        &self.branches[segment].commands[of_tick]
    }

    /// The branch that contains the commands of a tick of the current branch, and the range of these commands in that
    /// branch's list.
    fn given_at(&self, tick: u64) -> (usize, Range<usize>) {
        let (segment, _) = self.segment(self.current, tick);
        let commands = &self.branches[segment].commands;
        let before = commands.partition_point(|given| given.tick < tick);
        let up_to = commands.partition_point(|given| given.tick <= tick);
        (segment, before..up_to)
    }

    /// The branch whose commands apply at a tick of `branch`, and the first tick of that branch. The result is `branch`
    /// itself or one of its ancestors. At the first tick of a branch, the branch's own commands apply.
    fn segment(&self, branch: usize, tick: u64) -> (usize, u64) {
        let mut at = branch;
        loop {
            let Branch { parent, from_tick, .. } = &self.branches[at];
            match parent {
                Some(parent) if tick < *from_tick => at = *parent,
                _ => return (at, *from_tick),
            }
        }
    }

    /// Goes to a tick of the current branch.
    ///
    /// # Errors
    /// Fails if the tick is beyond the end of the branch.
    pub fn rewind(&mut self, tick: u64) -> Result<(), Refusal> {
        let ends_tick = self.branches[self.current].ends_tick;
        if tick > ends_tick {
            return Err(Refusal::new(format_args!(
                "there is no tick {tick} yet: this branch ends at {ends_tick}"
            )));
        }
        self.mark();
        self.go_to(tick);
        Ok(())
    }

    /// Brings the session to a tick of the current branch, whatever tick and branch its present state belongs to.
    fn go_to(&mut self, tick: u64) {
        self.restore(tick);
        while self.now.tick < tick {
            self.step_again();
        }
        if !self.is_rewound() {
            self.apply_recorded();
        }
    }

    /// For a replay: begins to bring the session to a tick of a branch. The caller takes the steps up to that tick with
    /// [`Session::step_again`], and at the end of the branch calls [`Session::apply_recorded`].
    pub(crate) fn begin_to_go_to(&mut self, branch: usize, tick: u64) {
        self.current = branch;
        self.restore(tick);
    }

    /// Repeats a step. The events of a repeated step are not reported again.
    pub(crate) fn step_again(&mut self) {
        let events = self.events.len();
        self.apply_recorded();
        let again = self.advance(|_| ());
        assert!(again.is_ok(), "it was stepped before from this state: {again:?}");
        self.events.truncate(events);
    }

    /// Records the present tick of the current branch and its fingerprint, if the session is at the end of the branch.
    pub fn mark(&mut self) {
        if !self.is_rewound() {
            let now = &self.now;
            self.writer.mark(self.current, now.tick, || bits(&now.simulation));
        }
    }

    /// Restores the latest checkpoint at or before a tick of the current branch.
    fn restore(&mut self, tick: u64) {
        let (mut to, mut at) = (tick, self.current);
        loop {
            let (segment, from) = self.segment(at, to);
            if let Some((_, state)) = self.checkpoints.latest(segment, from, to) {
                self.now = state.clone();
                self.interventions += 1;
                return;
            }
            // The branch has no checkpoint. Its first state is the parent's state at that tick, before the commands of
            // the tick.
            let Some(parent) = self.branches[segment].parent else {
                unreachable!("the checkpoint at the start of the first branch is never dropped")
            };
            (to, at) = (from, parent);
        }
    }

    /// Begins a new branch at the present tick and returns its number.
    ///
    /// # Errors
    /// Fails if the session is at the end of its branch, has too many branches, or has a full recording.
    pub fn branch(&mut self) -> Result<usize, Refusal> {
        if !self.is_rewound() {
            return Err(Refusal::new("the run is at its end: rewind it before you begin a branch"));
        }
        if self.branches.len() >= MOST_BRANCHES {
            return Err(Refusal::new(format_args!(
                "a session has at most {MOST_BRANCHES} branches"
            )));
        }
        let (id, parent, from_tick) = (self.branches.len(), self.current, self.now.tick);
        let line = Line::Branch { id, parent, from_tick };
        let line = self.writer.prepare(&line).map_err(Refusal::new)?;
        self.writer.put(&line);
        self.branches.push(Branch {
            parent: Some(parent),
            from_tick,
            ends_tick: from_tick,
            commands: Vec::new(),
        });
        self.current = id;
        Ok(id)
    }

    /// Goes to the end of another branch.
    ///
    /// # Errors
    /// Fails if there is no branch with the number `branch`.
    pub fn go_to_branch(&mut self, branch: usize) -> Result<(), Refusal> {
        if branch >= self.branches.len() {
            return Err(Refusal::new(format_args!("there is no branch {branch}")));
        }
        self.mark();
        self.current = branch;
        self.go_to(self.branches[branch].ends_tick);
        Ok(())
    }

    /// Takes the lines of the recording since the last call. The caller appends the lines to the recording's file.
    pub fn take_lines(&mut self) -> String {
        self.writer.take()
    }

    /// The line that would end the recording after all lines so far. The line ends the recording's file when the
    /// session is over; a copy that is saved earlier ends with it too.
    #[must_use]
    pub fn end_line(&self) -> String {
        self.writer.end_line()
    }

    /// Length of the recording so far, without the line that ends it (bytes).
    #[must_use]
    pub fn recorded_bytes(&self) -> u64 {
        self.writer.bytes()
    }

    /// For a replay: replaces the writer of the recording.
    pub(crate) fn record_with(&mut self, writer: Writer) {
        self.writer = writer;
    }

    /// Takes the events of the session since the last call: time (s) and text.
    pub fn take_events(&mut self) -> Vec<(f64, String)> {
        std::mem::take(&mut self.events)
    }
}

pub(crate) fn bits(simulation: &Simulation) -> String {
    format!("{:016x}", fingerprint(simulation))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_at_its_limit_of_ticks_cannot_continue_but_can_be_rewound() {
        let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) =
            Source::collect("a.toml", text.to_owned(), vec![], none).expect("a scenario");
        let mut session = Session::open(source).expect("a set-up");
        session.ticks = MOST_TICKS - 20;
        for _ in 0..20 {
            session.step().expect("a step");
        }
        assert_eq!(session.step(), Err(StepError::Full(Full::Ticks)));
        let bits = session.bits();
        session.rewind(10).expect("it is there");
        while session.is_rewound() {
            session.step().expect("a step that is recorded");
        }
        assert_eq!(session.bits(), bits);
        assert_eq!(session.step(), Err(StepError::Full(Full::Ticks)));
    }
}
