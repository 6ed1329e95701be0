//! The session: a simulation, the commands that made it what it is, and the way back.

use std::fmt;

use fenderline_scenario::ScenarioError;
use fenderline_sim::{SetupError, SimError, Simulation};

use crate::action::Action;
use crate::bits::fingerprint;
use crate::carry_out::{InHand, carry_out};
use crate::cast::Cast;
use crate::checkpoints::Checkpoints;
use crate::frame::Seen;
use crate::recording::{Line, Recording};
use crate::refusal::Refusal;
use crate::source::Source;

/// The most commands that a session takes: ten a second for a day.
const MOST_COMMANDS: usize = 864_000;
/// The most branches.
const MOST_BRANCHES: usize = 1000;
/// Ticks from one `reached` line of the recording to the next.
const MARKS: u64 = 10;

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
    pub(crate) in_hand: InHand,
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
    now: Now,
    checkpoints: Checkpoints<Now>,
    /// Lines of the recording that the owner has not taken yet.
    lines: String,
    /// Texts of events since the owner last took them, with their time [s].
    events: Vec<(f64, String)>,
}

/// Why there is no session.
#[derive(Clone, Debug, PartialEq)]
pub enum SessionError {
    /// The scenario cannot be used.
    Scenario(Box<ScenarioError>),
    /// The simulation refuses it.
    Setup(SetupError),
    /// A step could not be made.
    Step(SimError),
    /// A line of a recording that cannot be: its number and why.
    Line {
        /// From 1.
        line: usize,
        /// What is wrong.
        why: String,
    },
}

impl fmt::Display for SessionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SessionError::Scenario(error) => error.fmt(f),
            SessionError::Setup(error) => error.fmt(f),
            SessionError::Step(error) => error.fmt(f),
            SessionError::Line { line, why } => write!(f, "line {line} of the recording: {why}"),
        }
    }
}

impl std::error::Error for SessionError {}

impl From<SimError> for SessionError {
    fn from(error: SimError) -> SessionError {
        SessionError::Step(error)
    }
}

impl Session {
    /// Ready for its first step.
    ///
    /// # Errors
    /// A scenario that is none, or that cannot be simulated.
    pub fn open(source: Source) -> Result<Session, SessionError> {
        let scenario = source.scenario().map_err(|e| SessionError::Scenario(Box::new(e)))?;
        let simulation = Simulation::new(scenario.setup).map_err(SessionError::Setup)?;
        let cast = Cast::of(simulation.setup());
        let seen = Seen::before_the_first_step(&simulation);
        let now = Now { simulation, in_hand: InHand::default(), seen, tick: 0 };
        let first = Branch { parent: None, from_tick: 0, ends_tick: 0, commands: Vec::new() };
        Ok(Session {
            source,
            title: scenario.title,
            cast,
            branches: vec![first],
            shown: 0,
            commands: 0,
            checkpoints: Checkpoints::new(now.clone()),
            now,
            lines: String::new(),
            events: Vec::new(),
        })
    }

    /// Plays a recording from its start, all branches, and stands at the end of the last one. The number is of the
    /// states that were found to have the recorded bits.
    ///
    /// # Errors
    /// A command that cannot be carried out, a branch from nowhere, or a state with other bits than recorded: another
    /// version of the program may have made it, or another hand.
    pub fn replay(recording: &Recording) -> Result<(Session, u64), SessionError> {
        let mut session = Session::open(recording.source.clone())?;
        let mut same = 0;
        for (number, line) in &recording.lines {
            let wrong =
                |why: &dyn fmt::Display| SessionError::Line { line: *number, why: why.to_string() };
            match line {
                Line::Branch { id, parent, from_tick } => {
                    if *id != session.branches.len() || *parent >= *id {
                        return Err(wrong(&"branches are numbered as they come"));
                    }
                    session.show(*parent).map_err(|e| wrong(&e))?;
                    if *from_tick > session.branches[*parent].ends_tick {
                        session.go_on(*parent, *from_tick).map_err(|e| wrong(&e))?;
                    }
                    session.rewind(*from_tick).map_err(|e| wrong(&e))?;
                    session.branch_off();
                }
                Line::Command { branch, tick, action, .. } => {
                    session.go_on(*branch, *tick).map_err(|e| wrong(&e))?;
                    session.command("", 0, action.clone()).map_err(|e| wrong(&e))?;
                }
                Line::Reached { branch, tick, bits } => {
                    session.go_on(*branch, *tick).map_err(|e| wrong(&e))?;
                    let ours = session.bits();
                    if ours != *bits {
                        let message = format!("{ours} here, {bits} recorded at tick {tick}");
                        return Err(wrong(&message));
                    }
                    same += 1;
                }
            }
            session.lines.clear();
            session.events.clear();
        }
        Ok((session, same))
    }

    /// For a replay: steps the end of a branch up to a tick.
    fn go_on(&mut self, branch: usize, tick: u64) -> Result<(), Refusal> {
        if branch != self.shown || self.is_rewound() {
            self.show(branch)?;
        }
        if tick < self.now.tick {
            return Err(Refusal::new(format_args!("tick {tick} has gone by")));
        }
        while self.now.tick < tick {
            self.step().map_err(Refusal::new)?;
        }
        Ok(())
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
        format!("{:016x}", fingerprint(&self.now.simulation))
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
        let Now { simulation, in_hand, tick, .. } = &mut self.now;
        let forgotten = carry_out(&action, simulation, in_hand)?;
        let tick = *tick;
        if forgotten {
            let text = "in hand: the scenario's own orders to this control are off".to_owned();
            self.events.push((self.now.simulation.time_s(), text));
        }
        self.commands += 1;
        let branch = self.shown;
        self.lines +=
            &Line::Command { branch, tick, who: who.to_owned(), at_ms, action: action.clone() }
                .text();
        self.branches[branch].commands.push((tick, action));
        Ok(tick)
    }

    /// Takes one step: at the end of a branch with what hands have just ordered, before it with what is recorded.
    ///
    /// # Errors
    /// A run that blew up; it stays where it is.
    pub fn step(&mut self) -> Result<(), SimError> {
        let rewound = self.is_rewound();
        if rewound {
            self.apply_recorded();
        }
        self.advance()?;
        let tick = self.now.tick;
        if rewound {
            if !self.is_rewound() {
                self.apply_recorded();
            }
            return Ok(());
        }
        let branch = self.shown;
        self.branches[branch].ends_tick = tick;
        if tick.is_multiple_of(MARKS) {
            self.mark();
        }
        Ok(())
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
    fn apply_recorded(&mut self) {
        let at = self.now.tick;
        let (segment, _) = self.segment(self.shown, at);
        let commands = &self.branches[segment].commands;
        let from = commands.partition_point(|(tick, _)| *tick < at);
        let own = commands[from..].iter().take_while(|(tick, _)| *tick == at);
        let Now { simulation, in_hand, .. } = &mut self.now;
        for (_, action) in own {
            let again = carry_out(action, simulation, in_hand);
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
        let events = std::mem::take(&mut self.events);
        while self.now.tick < tick {
            self.apply_recorded();
            let again = self.advance();
            assert!(again.is_ok(), "it was stepped before from this state: {again:?}");
        }
        self.events = events;
        if !self.is_rewound() {
            self.apply_recorded();
        }
    }

    /// Notes in the recording how far the branch that is shown has come, where it is at its end.
    pub fn mark(&mut self) {
        if !self.is_rewound() {
            let (branch, tick) = (self.shown, self.now.tick);
            self.lines += &Line::Reached { branch, tick, bits: self.bits() }.text();
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
    /// There is nothing to leave: it is at the end of its branch; or there are too many branches.
    pub fn branch(&mut self) -> Result<usize, Refusal> {
        if !self.is_rewound() {
            return Err(Refusal::new("the run is at its end: rewind it first"));
        }
        if self.branches.len() >= MOST_BRANCHES {
            return Err(Refusal::new(format_args!("{MOST_BRANCHES} branches are enough")));
        }
        Ok(self.branch_off())
    }

    fn branch_off(&mut self) -> usize {
        let (id, from_tick) = (self.branches.len(), self.now.tick);
        // Commands of this very tick may have been given already at the branch's end: they are the parent's.
        if !self.is_rewound() {
            self.restore_before_commands();
        }
        let parent = self.shown;
        self.lines += &Line::Branch { id, parent, from_tick }.text();
        self.branches.push(Branch {
            parent: Some(parent),
            from_tick,
            ends_tick: from_tick,
            commands: Vec::new(),
        });
        self.shown = id;
        id
    }

    /// For a replay that branches off where its recording ends: the state without the commands of this tick.
    fn restore_before_commands(&mut self) {
        let tick = self.now.tick;
        self.restore(tick);
        while self.now.tick < tick {
            self.apply_recorded();
            let again = self.advance();
            assert!(again.is_ok(), "it was stepped before from this state: {again:?}");
        }
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

    /// Lines for the recording since this was asked last, to be added to its file.
    pub fn take_lines(&mut self) -> String {
        std::mem::take(&mut self.lines)
    }

    /// What happened since this was asked last: time [s] and text.
    pub fn take_events(&mut self) -> Vec<(f64, String)> {
        std::mem::take(&mut self.events)
    }
}
