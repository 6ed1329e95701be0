//! Reads the result rows of a campaign and collects what the program shows: verdicts, the most used fender, failed
//! runs.

use fenderline_campaign::store::Store;
use fenderline_campaign::{CampaignError, Cell, Head, Row, Runs};
use fenderline_report::plot::counted;
use fenderline_sim::Verdict;

use crate::failure::Failure;

/// Largest number of runs in a workbook: a sheet of Excel has 2²⁰ rows, of which two are head lines.
pub(super) const MOST_IN_A_WORKBOOK: u64 = (1 << 20) - 2;

/// A table with units.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct CaseTable {
    /// Heads.
    pub(crate) heads: Vec<Head>,
    /// Rows.
    pub(crate) rows: Vec<Vec<Cell>>,
}

/// The rows of a campaign's table, and what is counted from them.
pub(super) struct Gathered {
    table: CaseTable,
    /// Number of rows.
    pub(super) count: u64,
    /// Each verdict in words with the number of its runs, in the order in which the verdicts first occur.
    pub(super) verdicts: Vec<(String, u64)>,
    /// The most used fender of all runs: number of the case, name of the fender, quantity, and share of its rating in
    /// per cent.
    pub(super) governing: Option<(u64, String, String, f64)>,
    /// Number of the first run that was not made, and the reason.
    pub(super) failed: Option<(u64, String)>,
    failures: u64,
}

impl Gathered {
    /// Reads the rows of a campaign's store; only those before run `ended` if a stop rule ended the campaign. `is_held`
    /// says that the table is kept in memory.
    pub(super) fn of(
        runs: &Runs,
        store: &Store<'_>,
        ended: Option<u64>,
        is_held: bool,
    ) -> Result<Gathered, CampaignError> {
        let mut heads = vec![Head::new("case", "", "number of the run")];
        heads.extend(runs.heads().iter().cloned());
        let mut gathered = Gathered {
            table: CaseTable { heads, rows: Vec::new() },
            count: 0,
            verdicts: Vec::new(),
            governing: None,
            failed: None,
            failures: 0,
        };
        store.each(ended.unwrap_or(u64::MAX), &mut |row| {
            gathered.add(row, is_held);
            Ok(())
        })?;
        Ok(gathered)
    }

    fn add(&mut self, row: &Row, is_held: bool) {
        self.count += 1;
        let text = |name: &str| match self.cell(row, name) {
            Cell::Text(text) => text.clone(),
            _ => String::new(),
        };
        let verdict = text("verdict");
        let words = match Verdict::ALL.iter().find(|known| known.key() == verdict) {
            Some(verdict) => verdict.text(),
            None => "Did not run",
        };
        // A scenario without fenders has a row without a most used one.
        let fender = text("governing_fender");
        if let Some(share) = self.cell(row, "governing_share").number()
            && !fender.is_empty()
            && self.governing.as_ref().is_none_or(|most| share > most.3)
        {
            let named = (row.run + 1, fender, text("governing_quantity"), share);
            self.governing = Some(named);
        }
        if let Cell::Text(why) = self.cell(row, "error").clone() {
            self.failures += 1;
            self.failed.get_or_insert((row.run + 1, why));
        }
        match self.verdicts.iter_mut().find(|(known, _)| known == words) {
            Some((_, count)) => *count += 1,
            None => self.verdicts.push((words.to_owned(), 1)),
        }
        if is_held {
            let cells =
                [Cell::Number((row.run + 1) as f64)].into_iter().chain(row.cells.iter().cloned());
            self.table.rows.push(cells.collect());
        }
    }

    fn cell<'r>(&self, row: &'r Row, name: &str) -> &'r Cell {
        let place = self.table.heads.iter().position(|head| head.name == name);
        &row.cells[place.expect("every campaign has it") - 1]
    }

    /// The table of the campaign; it has no rows if it was not to be kept in memory.
    pub(super) fn table(&self) -> &CaseTable {
        &self.table
    }

    /// Fails if a run of the campaign was not made.
    pub(super) fn outcome(&self) -> Result<(), Failure> {
        match self.failures {
            0 => Ok(()),
            _ => {
                let cases = counted(self.failures, "case", "cases");
                Err(Failure::case(format_args!(
                    "error: {cases} did not run: see the column `error` of the table"
                )))
            }
        }
    }
}
