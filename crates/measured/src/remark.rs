//! What is told to the user about a log: guesses, rows and berthings that were left out.

use core::fmt;

use fenderline_scenario::printable_line;

/// How grave a remark is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Weight {
    /// Something was guessed or assumed.
    Guess,
    /// Rows were left out or repaired.
    Rows,
    /// A berthing, or a whole log, was left out.
    Refused,
}

/// A remark about a log, with the place in the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Remark {
    /// Name of the file.
    pub file: String,
    /// Line of the file, from 1; `None` for the whole file.
    pub line: Option<usize>,
    /// How grave it is.
    pub weight: Weight,
    /// What is the matter, in one sentence without a full stop.
    pub text: String,
}

impl fmt::Display for Remark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:", printable_line(&self.file))?;
        if let Some(line) = self.line {
            write!(f, "{line}:")?;
        }
        write!(f, " {}", printable_line(&self.text))
    }
}

/// The remarks about one file, in the order in which they were found.
#[derive(Clone, Debug, Default)]
pub(crate) struct Remarks {
    file: String,
    pub(crate) all: Vec<Remark>,
}

impl Remarks {
    pub(crate) fn of(file: &str) -> Remarks {
        Remarks { file: file.to_owned(), all: Vec::new() }
    }

    pub(crate) fn add(&mut self, weight: Weight, line: Option<usize>, text: impl Into<String>) {
        self.all.push(Remark { file: self.file.clone(), line, weight, text: text.into() });
    }
}

/// Counts events of one kind, and keeps the line of the first.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Tally {
    pub(crate) count: usize,
    pub(crate) first_line: usize,
}

impl Tally {
    pub(crate) fn add(&mut self, line: usize) {
        if self.count == 0 {
            self.first_line = line;
        }
        self.count += 1;
    }

    /// Adds a remark, if there were any events.
    pub(crate) fn tell(self, remarks: &mut Remarks, weight: Weight, one: &str, many: &str) {
        let text = match self.count {
            0 => return,
            1 => format!("1 {one}"),
            count => format!("{count} {many}; here is the first"),
        };
        remarks.add(weight, Some(self.first_line), text);
    }
}
