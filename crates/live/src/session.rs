//! The session: a simulation, the commands that made it what it is, and the way back.

use std::fmt;

use fenderline_scenario::ScenarioError;
use fenderline_sim::{SetupError, SimError, Simulation};

use crate::action::Action;
use crate::approach::ApproachLimit;
use crate::bits::fingerprint;
use crate::carry_out::{ManualControl, carry_out};
use crate::cast::Cast;
use crate::checkpoints::Checkpoints;
use crate::frame::Seen;
use crate::limits::{Full, LONGEST_HEADER_BYTES, MARKS, MOST_BRANCHES, MOST_COMMANDS, MOST_TICKS};
use crate::recording::{Line, Writer};
use crate::refusal::Refusal;
use crate::source::Source;

/// Commands from a tick on, and where they leave what was before.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// The branch that it left; `None` for the first.
    pub parent: Option<usize>,
    /// Where it left it.
    pub from_tick: u64,
    /// How far it has come.
    pub ends_tick: u64,
    /// By rising tick.
    commands: Vec<(u64, Action)>,
}

/// Everything that changes from tick to tick.
#[derive(Clone, Debug)]
pub(crate) struct Now {
    pub(crate) simulation: Simulation,
    pub(crate) manual: ManualControl,
    pub(crate) approach: ApproachLimit,
    pub(crate) seen: Seen,
    /// Steps taken.
    pub(crate) tick: u64,
}

/// A run under people's hands: see the crate's documentation.
#[derive(Clone, Debug)]
pub struct Session {
    source: Source,
    title: String,
    cast: Cast,
    branches: Vec<Branch>,
    shown: usize,
    commands: usize,
    /// Of all branches together.
    ticks: u64,
    now: Now,
    checkpoints: Checkpoints<Now>,
    writer: Writer,
    /// Texts of events since the owner last took them, with their time (s).
    events: Vec<(f64, String)>,
}

/// Why there is no session.
#[derive(Clone, Debug, PartialEq)]
pub enum SessionError {
    /// The scenario cannot be used.
    Scenario(Box<ScenarioError>),
    /// The simulation refuses it.
    Setup(SetupError),
    /// With all the files that it names it is more than a recording's first line holds.
    TooLarge,
}

/// Why there is no next step.
#[derive(Clone, Debug, PartialEq)]
pub enum StepError {
    /// The simulation could not make it.
    Simulation(SimError),
    /// The session has come to a limit.
    Full(Full),
}

impl fmt::Display for SessionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SessionError::Scenario(error) => error.fmt(f),
            SessionError::Setup(error) => error.fmt(f),
            SessionError::TooLarge => write!(
                f,
                "with all the files that it names it is larger than {} MiB: it cannot be recorded",
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
    /// Ready for its first step; the recording's first line can be taken.
    ///
    /// # Errors
    /// A scenario that is none, that cannot be simulated, or that is too large to be recorded.
    pub fn open(source: Source) -> Result<Session, SessionError> {
        let writer = Writer::begin(&source).ok_or(SessionError::TooLarge)?;
        let scenario = source.scenario().map_err(|e| SessionError::Scenario(Box::new(e)))?;
        let simulation = Simulation::new(scenario.setup).map_err(SessionError::Setup)?;
        let cast = Cast::of(simulation.setup());
        let seen = Seen::before_the_first_step(&simulation);
        let (manual, approach) = (ManualControl::default(), ApproachLimit::default());
        let now = Now { simulation, manual, approach, seen, tick: 0 };
        let first = Branch { parent: None, from_tick: 0, ends_tick: 0, commands: Vec::new() };
        Ok(Session {
            source,
            title: scenario.title,
            cast,
            branches: vec![first],
            shown: 0,
            commands: 0,
            ticks: 0,
            checkpoints: Checkpoints::new(now.clone()),
            now,
            writer,
            events: Vec::new(),
        })
    }

    /// Where it began.
    #[must_use]
    pub fn source(&self) -> &Source {
        &self.source
    }

    /// The scenario's title.
    #[must_use]
    pub fn title(&self) -> &str {
        &self.title
    }

    /// Who is who.
    #[must_use]
    pub fn cast(&self) -> &Cast {
        &self.cast
    }

    /// The simulation as it is now.
    #[must_use]
    pub fn simulation(&self) -> &Simulation {
        &self.now.simulation
    }

    pub(crate) fn now(&self) -> &Now {
        &self.now
    }

    /// Steps taken from the start to now.
    #[must_use]
    pub fn tick(&self) -> u64 {
        self.now.tick
    }

    /// All branches, by their numbers.
    #[must_use]
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// The branch that is shown.
    #[must_use]
    pub fn shown(&self) -> usize {
        self.shown
    }

    /// Is what is shown before the end of its branch?
    #[must_use]
    pub fn is_rewound(&self) -> bool {
        self.now.tick < self.branches[self.shown].ends_tick
    }

    /// The state's fingerprint, in hexadecimal.
    #[must_use]
    pub fn bits(&self) -> String {
        bits(&self.now.simulation)
    }

    /// Carries a command out, from the next step on; the tick in which it counts. `at_ms` is for the recording
    /// alone.
    ///
    /// # Errors
    /// Why it was refused; nothing is changed then.
    pub fn command(&mut self, who: &str, at_ms: u64, action: Action) -> Result<u64, Refusal> {
        if self.is_rewound() {
            return Err(Refusal::new(
                "the run is rewound: nothing can be ordered in the past; branch off, or go to its end",
            ));
        }
        if self.commands >= MOST_COMMANDS {
            return Err(Refusal::new(format_args!("{MOST_COMMANDS} commands are enough")));
        }
        let (branch, tick) = (self.shown, self.now.tick);
        let line =
            Line::Command { branch, tick, who: who.to_owned(), at_ms, action: action.clone() };
        let line = self.writer.prepare(&line).map_err(Refusal::new)?;
        let dropped = carry_out(&action, &self.cast, &mut self.now)?;
        if dropped {
            let text = "manual control: the scenario's own orders to it are dropped".to_owned();
            self.events.push((self.now.simulation.time_s(), text));
        }
        self.commands += 1;
        self.writer.put(&line);
        self.branches[branch].commands.push((tick, action));
        Ok(tick)
    }

    /// Takes one step: at the end of a branch with what hands have just ordered, before it with what is recorded.
    ///
    /// # Errors
    /// A run that blew up, or a session at its limits; it stays where it is.
    pub fn step(&mut self) -> Result<(), StepError> {
        let rewound = self.is_rewound();
        if rewound {
            self.apply_recorded();
        } else {
            self.has_room().map_err(StepError::Full)?;
        }
        self.advance().map_err(StepError::Simulation)?;
        let tick = self.now.tick;
        if rewound {
            if !self.is_rewound() {
                self.apply_recorded();
            }
            return Ok(());
        }
        let branch = self.shown;
        self.branches[branch].ends_tick = tick;
        self.ticks += 1;
        if tick.is_multiple_of(MARKS) {
            self.mark();
        }
        Ok(())
    }

    /// For one more tick.
    fn has_room(&self) -> Result<(), Full> {
        if self.ticks >= MOST_TICKS {
            return Err(Full::Ticks);
        }
        if self.writer.has_room() { Ok(()) } else { Err(Full::Bytes) }
    }

    /// One step of the simulation, and what there was to see.
    fn advance(&mut self) -> Result<(), SimError> {
        let Now { simulation, seen, tick, .. } = &mut self.now;
        let t_s = simulation.time_s();
        seen.step(simulation)?;
        *tick += 1;
        self.events.extend(seen.events(simulation.setup()).map(|text| (t_s, text)));
        let (segment, _) = self.segment(self.shown, self.now.tick);
        self.checkpoints.offer(segment, self.now.tick, &self.now);
        Ok(())
    }

    /// Gives the recorded commands of this tick again.
    pub(crate) fn apply_recorded(&mut self) {
        let at = self.now.tick;
        let (segment, _) = self.segment(self.shown, at);
        let commands = &self.branches[segment].commands;
        let from = commands.partition_point(|(tick, _)| *tick < at);
        let own = commands[from..].iter().take_while(|(tick, _)| *tick == at);
        for (_, action) in own {
            let again = carry_out(action, &self.cast, &mut self.now);
            assert!(again.is_ok(), "it was carried out before in this state: {action:?}");
        }
    }

    /// The branch whose commands count at a tick of a branch: itself, or one that it comes from; and where that one
    /// begins. What begins a branch counts in the branch.
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

    /// Goes to a tick of the branch that is shown.
    ///
    /// # Errors
    /// A tick beyond its end.
    pub fn rewind(&mut self, tick: u64) -> Result<(), Refusal> {
        let ends_tick = self.branches[self.shown].ends_tick;
        if tick > ends_tick {
            return Err(Refusal::new(format_args!(
                "there is no tick {tick} yet: this branch ends at {ends_tick}"
            )));
        }
        self.mark();
        self.go_to(tick);
        Ok(())
    }

    /// Goes to a tick that the branch that is shown has; what is shown now may be of another.
    fn go_to(&mut self, tick: u64) {
        self.restore(tick);
        while self.now.tick < tick {
            self.step_again();
        }
        if !self.is_rewound() {
            self.apply_recorded();
        }
    }

    /// For a replay: begins to go to a tick that a branch has. What is missing is as many [`Session::step_again`] as
    /// the session is before that tick, and at the end of the branch its commands there.
    pub(crate) fn turn_to(&mut self, branch: usize, tick: u64) {
        self.shown = branch;
        self.restore(tick);
    }

    /// Makes a step that was made before, without telling again what there was to see.
    pub(crate) fn step_again(&mut self) {
        let events = self.events.len();
        self.apply_recorded();
        let again = self.advance();
        assert!(again.is_ok(), "it was stepped before from this state: {again:?}");
        self.events.truncate(events);
    }

    /// Notes in the recording how far the branch that is shown has come, where it is at its end.
    pub fn mark(&mut self) {
        if !self.is_rewound() {
            let now = &self.now;
            self.writer.mark(self.shown, now.tick, || bits(&now.simulation));
        }
    }

    /// Puts back the latest state that is kept on the way to a tick.
    fn restore(&mut self, tick: u64) {
        let (mut to, mut at) = (tick, self.shown);
        loop {
            let (segment, from) = self.segment(at, to);
            if let Some((_, state)) = self.checkpoints.latest(segment, from, to) {
                self.now = state.clone();
                return;
            }
            // None of this branch's own: its beginning is its parent's state before that tick's commands.
            let Some(parent) = self.branches[segment].parent else {
                unreachable!("the start of the first branch is kept for good")
            };
            (to, at) = (from, parent);
        }
    }

    /// Goes on from here as a new branch, whose number is returned.
    ///
    /// # Errors
    /// There is nothing to leave: it is at the end of its branch; or there are too many branches, or the recording is
    /// full.
    pub fn branch(&mut self) -> Result<usize, Refusal> {
        if !self.is_rewound() {
            return Err(Refusal::new("the run is at its end: rewind it first"));
        }
        if self.branches.len() >= MOST_BRANCHES {
            return Err(Refusal::new(format_args!("{MOST_BRANCHES} branches are enough")));
        }
        let (id, parent, from_tick) = (self.branches.len(), self.shown, self.now.tick);
        let line = Line::Branch { id, parent, from_tick };
        let line = self.writer.prepare(&line).map_err(Refusal::new)?;
        self.writer.put(&line);
        self.branches.push(Branch {
            parent: Some(parent),
            from_tick,
            ends_tick: from_tick,
            commands: Vec::new(),
        });
        self.shown = id;
        Ok(id)
    }

    /// Shows another branch, at its end.
    ///
    /// # Errors
    /// There is none of that number.
    pub fn show(&mut self, branch: usize) -> Result<(), Refusal> {
        if branch >= self.branches.len() {
            return Err(Refusal::new(format_args!("there is no branch {branch}")));
        }
        self.mark();
        self.shown = branch;
        self.go_to(self.branches[branch].ends_tick);
        Ok(())
    }

    /// Lines for the recording since this was asked last, to be added to its file; the first ones begin it.
    pub fn take_lines(&mut self) -> String {
        self.writer.take()
    }

    /// The line that ends the recording after all that was taken and is to be taken: for its file when the session is
    /// over, and for a copy at any time.
    #[must_use]
    pub fn end_line(&self) -> String {
        self.writer.end_line()
    }

    /// Length of the recording so far, without its end (bytes).
    #[must_use]
    pub fn recorded_bytes(&self) -> u64 {
        self.writer.bytes()
    }

    /// For a replay: what is recorded from here on goes on after lines that stand already.
    pub(crate) fn record_with(&mut self, writer: Writer) {
        self.writer = writer;
    }

    /// What happened since this was asked last: time (s) and text.
    pub fn take_events(&mut self) -> Vec<(f64, String)> {
        std::mem::take(&mut self.events)
    }
}

fn bits(simulation: &Simulation) -> String {
    format!("{:016x}", fingerprint(simulation))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_session_at_its_limit_of_ticks_goes_on_no_more_and_can_be_rewound() {
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
