//! Replays a recording in portions of a given number of steps.

use std::fmt;
use std::io::BufRead;

use crate::limits::MOST_TICKS;
use crate::recording::{Line, Outline, RecordingError, RecordingReader, Writer};
use crate::session::{Session, SessionError};

/// Largest number of steps that a replay repeats to change between branches.
const MOST_REPEATED: u64 = MOST_TICKS;

/// Why a recording cannot be replayed.
#[derive(Clone, Debug, PartialEq)]
pub enum ReplayError {
    /// The recording cannot be read.
    Recording(RecordingError),
    /// The scenario of the recording cannot be opened as a session.
    Session(Box<SessionError>),
    /// A line of the recording cannot be replayed. Another version of the program may have made the recording.
    Line {
        /// Number of the line that cannot be replayed, counted from 1.
        line: usize,
        /// The reason.
        why: String,
    },
    /// The recording has changed since the program checked it.
    Changed,
}

impl fmt::Display for ReplayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReplayError::Recording(error) => error.fmt(f),
            ReplayError::Session(error) => error.fmt(f),
            ReplayError::Line { line, why } => write!(f, "line {line}: {why}"),
            ReplayError::Changed => f.write_str("the recording was changed while it was read"),
        }
    }
}

impl std::error::Error for ReplayError {}

/// A replayed session that is ready to continue.
#[derive(Debug)]
pub struct Replayed {
    /// The session at the end of the recording. New lines of the continued session are written after the lines that
    /// [`crate::copy_kept`] copies.
    pub session: Session,
    /// Number of replayed states whose bits equal the bits in the recording.
    pub same: u64,
}

/// A replay in progress.
#[derive(Debug)]
pub struct Replay<R> {
    reader: RecordingReader<R>,
    outline: Outline,
    session: Session,
    /// The line of the recording that is being replayed.
    line: Option<Line>,
    /// The tick to which the session returns, while it goes back to an earlier tick.
    back_to: Option<u64>,
    /// For each branch, the bits of the state at its end, if the replay has left the branch there.
    left: Vec<Option<String>>,
    /// The branch that the last line belongs to.
    last_branch: usize,
    done: u64,
    repeated: u64,
    same: u64,
    is_over: bool,
}

impl<R: BufRead> Replay<R> {
    /// Begins a replay. `input` is the recording from its start, and `outline` must come from the same recording.
    ///
    /// # Errors
    /// Fails if a session cannot be opened from the first line of the recording.
    pub fn begin(input: R, outline: Outline) -> Result<Replay<R>, ReplayError> {
        let reader = RecordingReader::open(input).map_err(ReplayError::Recording)?;
        let session = Session::open(reader.source().clone());
        let mut session = session.map_err(|e| ReplayError::Session(Box::new(e)))?;
        session.record_with(Writer::silent());
        Ok(Replay {
            left: vec![None],
            reader,
            outline,
            session,
            line: None,
            back_to: None,
            last_branch: 0,
            done: 0,
            repeated: 0,
            same: 0,
            is_over: false,
        })
    }

    /// Replays up to `count` steps and lines of the recording. Returns true when the whole recording has been replayed.
    ///
    /// # Errors
    /// Fails for a line that cannot be carried out, or for a state whose bits differ from the recorded bits: another
    /// version of the program may have made the recording.
    pub fn play(&mut self, count: u64) -> Result<bool, ReplayError> {
        let mut left = count;
        while left > 0 && !self.is_over {
            if self.line.is_none() {
                left -= 1;
                self.line = self.reader.next_line().map_err(ReplayError::Recording)?;
            }
            let Some((branch, tick)) = self.goal() else { continue };
            if self.go(branch, tick, &mut left)? {
                self.carry_out()?;
            }
        }
        Ok(self.is_over)
    }

    /// Number of the recording's ticks that have been replayed so far. The outline of the recording has the total
    /// number of ticks.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done
    }

    /// Returns the session when the whole recording has been replayed.
    ///
    /// # Errors
    /// Fails if the recording has changed since the program checked it.
    ///
    /// # Panics
    /// Panics if the replay is not complete.
    pub fn finish(self) -> Result<Replayed, ReplayError> {
        assert!(self.is_over, "the replay is not complete");
        let (bytes, chain) = self.reader.kept();
        if (bytes, chain) != (self.outline.kept_bytes, self.outline.chain) {
            return Err(ReplayError::Changed);
        }
        let mut session = self.session;
        session.record_with(Writer::after(chain, bytes));
        Ok(Replayed { session, same: self.same })
    }

    /// Branch and tick to which the line belongs. The result is `None` for a state that the replay compared already
    /// when it left the branch.
    fn goal(&mut self) -> Option<(usize, u64)> {
        let ends = |branch: usize| self.session.branches()[branch].ends_tick;
        match &self.line {
            Some(Line::Reached { branch, tick, bits }) => {
                self.last_branch = *branch;
                let is_left = *branch != self.session.current_branch() && *tick == ends(*branch);
                if is_left && self.left[*branch].as_ref() == Some(bits) {
                    self.same += 1;
                    self.line = None;
                    return None;
                }
                Some((*branch, *tick))
            }
            Some(Line::Command { branch, tick, .. }) => Some((*branch, *tick)),
            Some(Line::Branch { parent, from_tick, .. }) => Some((*parent, *from_tick)),
            Some(Line::End {}) => {
                unreachable!("the reader of the recording returns no line that ends the session")
            }
            None => Some((self.last_branch, ends(self.last_branch))),
        }
    }

    /// Lets the replayed session go to a tick of a branch. Returns true when the session is there.
    fn go(&mut self, branch: usize, tick: u64, left: &mut u64) -> Result<bool, ReplayError> {
        let ends_tick = self.session.branches()[branch].ends_tick;
        let session = &mut self.session;
        // The session returns to another branch or to an earlier tick. It counts as rewound until it arrives.
        if self.back_to.is_none() && (branch != session.current_branch() || tick < session.tick()) {
            if !session.is_rewound() {
                self.left[session.current_branch()] = Some(session.bits());
            }
            let to = tick.min(ends_tick);
            session.begin_to_go_to(branch, to);
            self.back_to = Some(to);
        }
        if let Some(to) = self.back_to {
            while session.tick() < to {
                if *left == 0 {
                    return Ok(false);
                }
                *left -= 1;
                self.repeated += 1;
                session.step_again();
            }
            if self.repeated > MOST_REPEATED {
                let why = format!(
                    "the replay needs more than {MOST_REPEATED} repeated steps to change between branches"
                );
                return Err(self.wrong(why));
            }
            if !session.is_rewound() {
                session.apply_recorded();
            }
            self.back_to = None;
        }
        while self.session.tick() < tick {
            if *left == 0 {
                return Ok(false);
            }
            *left -= 1;
            self.done += 1;
            self.session.step().map_err(|e| self.wrong(e))?;
        }
        Ok(true)
    }

    /// Carries out the line. The session must have reached the tick of the line.
    fn carry_out(&mut self) -> Result<(), ReplayError> {
        match self.line.take() {
            Some(Line::Command { branch, who, action, .. }) => {
                self.last_branch = branch;
                self.session.command(&who, 0, action).map_err(|e| self.wrong(e))?;
            }
            Some(Line::Reached { tick, bits, .. }) => {
                let ours = self.session.bits();
                if ours != bits {
                    let why = format!(
                        "the state at tick {tick} has the bits {ours}, but the recording has {bits}"
                    );
                    return Err(self.wrong(why));
                }
                self.same += 1;
            }
            Some(Line::Branch { .. }) => {
                self.last_branch = self.session.branch().map_err(|e| self.wrong(e))?;
                self.left.push(None);
            }
            Some(Line::End {}) => {
                unreachable!("the reader of the recording returns no line that ends the session")
            }
            None => self.is_over = true,
        }
        self.session.take_events();
        Ok(())
    }

    fn wrong(&self, why: impl fmt::Display) -> ReplayError {
        ReplayError::Line { line: self.reader.line_number(), why: why.to_string() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::Source;

    #[test]
    fn repeated_steps_to_change_between_branches_are_limited() {
        let text = include_str!("../../../scenarios/berth/alongside_with_two_tugs.toml");
        let none = |name: &str| Err(format!("{name}: none is needed"));
        let (source, _) =
            Source::collect("a.toml", text.to_owned(), vec![], none).expect("a scenario");
        let mut session = Session::open(source).expect("a set-up");
        for _ in 0..60 {
            session.step().expect("a step");
        }
        session.rewind(50).expect("it is there");
        session.branch().expect("a branch");
        session.step().expect("a step");
        session.mark();
        let text = session.take_lines() + &session.end_line();
        for (repeated, is_refused) in [(MOST_REPEATED - 50, false), (MOST_REPEATED - 49, true)] {
            let outline = Outline::read(text.as_bytes(), |_| Ok(())).expect("sound");
            let mut replay = Replay::begin(text.as_bytes(), outline).expect("a scenario");
            replay.repeated = repeated;
            match replay.play(1000) {
                Ok(is_over) => assert!(is_over && !is_refused),
                Err(e) => assert!(is_refused && e.to_string().contains("repeated steps"), "{e}"),
            }
        }
    }
}
