//! Checks each line of a recording against the lines before it, without replaying them. A recording that passes the
//! check is within the limits of a session.

use super::Line;
use crate::limits::{MARKS, MOST_BRANCHES, MOST_COMMANDS, MOST_TICKS};

/// The last tick that a branch of the recording has reached, according to the lines so far.
#[derive(Clone, Copy, Debug)]
struct Reach {
    ends_tick: u64,
}

/// The branches of the recording, according to the lines so far.
#[derive(Clone, Debug)]
pub(super) struct Shape {
    branches: Vec<Reach>,
    pub(super) commands: usize,
    /// Number of ticks of all branches together.
    pub(super) ticks: u64,
}

impl Shape {
    pub(super) fn new() -> Shape {
        Shape { branches: vec![Reach { ends_tick: 0 }], commands: 0, ticks: 0 }
    }

    pub(super) fn branches(&self) -> usize {
        self.branches.len()
    }

    /// Checks the next line.
    ///
    /// # Errors
    /// Fails with the reason why the line cannot follow the lines before it.
    pub(super) fn take(&mut self, line: &Line) -> Result<(), String> {
        match line {
            Line::Command { branch, tick, .. } => {
                self.commands += 1;
                if self.commands > MOST_COMMANDS {
                    return Err(format!("more than {MOST_COMMANDS} commands"));
                }
                self.reach(*branch, *tick)
            }
            Line::Reached { branch, tick, bits } => {
                let digit = |c: char| matches!(c, '0'..='9' | 'a'..='f');
                if bits.len() != 16 || !bits.chars().all(digit) {
                    return Err("the bits of a state are sixteen hexadecimal digits".to_owned());
                }
                self.reach(*branch, *tick)
            }
            Line::Branch { id, parent, from_tick } => self.branch(*id, *parent, *from_tick),
            Line::End {} => Ok(()),
        }
    }

    fn reach(&mut self, branch: usize, tick: u64) -> Result<(), String> {
        let Some(Reach { ends_tick }) = self.branches.get_mut(branch) else {
            return Err(format!("there is no branch {branch}"));
        };
        let Some(ticks) = tick.checked_sub(*ends_tick) else {
            return Err(format!("branch {branch} has reached tick {ends_tick} already"));
        };
        if ticks > MARKS {
            return Err(format!(
                "branch {branch} goes from tick {ends_tick} to {tick}, but needs a line every {MARKS} ticks"
            ));
        }
        *ends_tick = tick;
        self.ticks += ticks;
        if self.ticks > MOST_TICKS {
            return Err(format!("more than {MOST_TICKS} ticks"));
        }
        Ok(())
    }

    fn branch(&mut self, id: usize, parent: usize, from_tick: u64) -> Result<(), String> {
        if self.branches.len() >= MOST_BRANCHES {
            return Err(format!("more than {MOST_BRANCHES} branches"));
        }
        if id != self.branches.len() {
            return Err("branches must be numbered in order".to_owned());
        }
        let Some(Reach { ends_tick }) = self.branches.get(parent) else {
            return Err(format!("there is no branch {parent} from which a branch could begin"));
        };
        // A branch cannot begin at the end of its parent.
        if from_tick >= *ends_tick {
            return Err(format!(
                "branch {parent} ends at tick {ends_tick}: a branch cannot begin at {from_tick}"
            ));
        }
        self.branches.push(Reach { ends_tick: from_tick });
        Ok(())
    }
}
