//! A column of texts, in which each different text is stored once.

use std::collections::BTreeMap;

/// A column of texts. A text that many rows have is stored once.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Texts {
    distinct: Vec<String>,
    of_row: Vec<u32>,
    known: BTreeMap<String, u32>,
}

impl Texts {
    /// Adds the text of the next row.
    pub(super) fn push(&mut self, text: &str) {
        let number = match self.known.get(text) {
            Some(number) => *number,
            None => {
                // A table of 2³² different texts has more than the largest file's bytes.
                let number = u32::try_from(self.distinct.len()).unwrap_or(u32::MAX);
                self.distinct.push(text.to_owned());
                self.known.insert(text.to_owned(), number);
                number
            }
        };
        self.of_row.push(number);
    }

    /// Number of rows.
    #[must_use]
    pub fn len(&self) -> usize {
        self.of_row.len()
    }

    /// Whether the column has no rows.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.of_row.is_empty()
    }

    /// The text of a row.
    #[must_use]
    pub fn get(&self, row: usize) -> Option<&str> {
        self.of_row.get(row).map(|number| self.distinct[*number as usize].as_str())
    }

    /// The texts of all rows in their order.
    pub fn iter(&self) -> impl Iterator<Item = &str> {
        self.of_row.iter().map(|number| self.distinct[*number as usize].as_str())
    }

    /// Each different text with the number of rows that have it: the most frequent text first, equally frequent texts
    /// by the alphabet.
    #[must_use]
    pub fn counts(&self) -> Vec<(&str, usize)> {
        let mut counts = vec![0; self.distinct.len()];
        for number in &self.of_row {
            counts[*number as usize] += 1;
        }
        let mut all: Vec<(&str, usize)> =
            self.distinct.iter().map(String::as_str).zip(counts).collect();
        all.sort_by(|a, b| b.1.cmp(&a.1).then(a.0.cmp(b.0)));
        all
    }
}
