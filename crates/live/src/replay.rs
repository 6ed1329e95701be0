//! Plays a recording again, some steps at a time.

use std::fmt;
use std::io::BufRead;

use crate::limits::MOST_TICKS;
use crate::recording::{Line, Outline, RecordingError, RecordingReader, Writer};
use crate::session::{Session, SessionError};

/// The most steps that are made a second time, to go to and fro between branches.
const MOST_AGAIN: u64 = MOST_TICKS;

/// Why a recording cannot be played.
#[derive(Clone, Debug, PartialEq)]
pub enum ReplayError {
    /// It cannot be read.
    Recording(RecordingError),
    /// What it begins with is no scenario for a session.
    Session(Box<SessionError>),
    /// A line cannot be played: its number and why. Another version of the program may have made the recording.
    Line {
        /// From 1.
        line: usize,
        /// What is wrong.
        why: String,
    },
    /// It is not what it was when it was checked.
    Changed,
}

impl fmt::Display for ReplayError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ReplayError::Recording(error) => error.fmt(f),
            ReplayError::Session(error) => error.fmt(f),
            ReplayError::Line { line, why } => write!(f, "line {line}: {why}"),
            ReplayError::Changed => f.write_str("it was changed while it was read"),
        }
    }
}

impl std::error::Error for ReplayError {}

/// A session that was played again, ready to go on.
#[derive(Debug)]
pub struct Replayed {
    /// It stands where its recording ended; the lines that it records follow those that [`crate::copy_kept`] copies.
    pub session: Session,
    /// States that were found to have the recorded bits.
    pub same: u64,
}

/// A recording that is being played.
#[derive(Debug)]
pub struct Replay<R> {
    reader: RecordingReader<R>,
    outline: Outline,
    session: Session,
    /// The line that is being played.
    line: Option<Line>,
    /// While the session goes to a tick that it has been at: that tick.
    back_to: Option<u64>,
    /// The bits at the end of each branch that was left there.
    left: Vec<Option<String>>,
    /// Where the recording stood last.
    last_branch: usize,
    done: u64,
    again: u64,
    same: u64,
    is_over: bool,
}

impl<R: BufRead> Replay<R> {
    /// Ready to play; `input` stands at its start, and `outline` was read of it.
    ///
    /// # Errors
    /// A first line without a scenario for a session.
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
            again: 0,
            same: 0,
            is_over: false,
        })
    }

    /// Plays on for so many steps or lines; true when all of it has been played.
    ///
    /// # Errors
    /// A line that cannot be carried out, or a state with other bits than recorded: another version of the program may
    /// have made it.
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

    /// Ticks that were played, of those in the outline.
    #[must_use]
    pub fn done(&self) -> u64 {
        self.done
    }

    /// The session, when all of it has been played.
    ///
    /// # Errors
    /// The recording was changed since it was checked.
    ///
    /// # Panics
    /// Before all of it has been played.
    pub fn finish(self) -> Result<Replayed, ReplayError> {
        assert!(self.is_over, "it is to be played to its end first");
        let (bytes, chain) = self.reader.kept();
        if (bytes, chain) != (self.outline.kept_bytes, self.outline.chain) {
            return Err(ReplayError::Changed);
        }
        let mut session = self.session;
        session.record_with(Writer::after(chain, bytes));
        Ok(Replayed { session, same: self.same })
    }

    /// The branch and the tick that the line is about; `None` for a state that was held against the recording when its
    /// branch was left.
    fn goal(&mut self) -> Option<(usize, u64)> {
        let ends = |branch: usize| self.session.branches()[branch].ends_tick;
        match &self.line {
            Some(Line::Reached { branch, tick, bits }) => {
                self.last_branch = *branch;
                let is_left = *branch != self.session.shown() && *tick == ends(*branch);
                if is_left && self.left[*branch].as_ref() == Some(bits) {
                    self.same += 1;
                    self.line = None;
                    return None;
                }
                Some((*branch, *tick))
            }
            Some(Line::Command { branch, tick, .. }) => Some((*branch, *tick)),
            Some(Line::Branch { parent, from_tick, .. }) => Some((*parent, *from_tick)),
            Some(Line::End {}) => unreachable!("the reader keeps it"),
            None => Some((self.last_branch, ends(self.last_branch))),
        }
    }

    /// Goes to a tick of a branch; true when it is there.
    fn go(&mut self, branch: usize, tick: u64, left: &mut u64) -> Result<bool, ReplayError> {
        let ends_tick = self.session.branches()[branch].ends_tick;
        let session = &mut self.session;
        // Under way it is rewound, and so it is where a branch is to begin.
        if self.back_to.is_none() && (branch != session.shown() || tick < session.tick()) {
            if !session.is_rewound() {
                self.left[session.shown()] = Some(session.bits());
            }
            let to = tick.min(ends_tick);
            session.turn_to(branch, to);
            self.back_to = Some(to);
        }
        if let Some(to) = self.back_to {
            while session.tick() < to {
                if *left == 0 {
                    return Ok(false);
                }
                *left -= 1;
                self.again += 1;
                session.step_again();
            }
            if self.again > MOST_AGAIN {
                let why = format!("more than {MOST_AGAIN} steps to and fro between branches");
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

    /// Carries the line out, where the session is.
    fn carry_out(&mut self) -> Result<(), ReplayError> {
        match self.line.take() {
            Some(Line::Command { branch, action, .. }) => {
                self.last_branch = branch;
                self.session.command("", 0, action).map_err(|e| self.wrong(e))?;
            }
            Some(Line::Reached { tick, bits, .. }) => {
                let ours = self.session.bits();
                if ours != bits {
                    let why = format!("{ours} here, {bits} recorded at tick {tick}");
                    return Err(self.wrong(why));
                }
                self.same += 1;
            }
            Some(Line::Branch { .. }) => {
                self.last_branch = self.session.branch().map_err(|e| self.wrong(e))?;
                self.left.push(None);
            }
            Some(Line::End {}) => unreachable!("the reader keeps it"),
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
    fn going_to_and_fro_between_branches_has_a_limit() {
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
        for (again, is_refused) in [(MOST_AGAIN - 50, false), (MOST_AGAIN - 49, true)] {
            let outline = Outline::read(text.as_bytes(), |_| Ok(())).expect("sound");
            let mut replay = Replay::begin(text.as_bytes(), outline).expect("a scenario");
            replay.again = again;
            match replay.play(1000) {
                Ok(is_over) => assert!(is_over && !is_refused),
                Err(e) => assert!(is_refused && e.to_string().contains("to and fro"), "{e}"),
            }
        }
    }
}
