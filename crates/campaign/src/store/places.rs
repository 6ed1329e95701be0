//! The places of the runs' records in a journal. The number of runs is known in advance; memory is used only for runs
//! that have rows.

/// The places are kept in pages of memory: number of runs for which a page has places (a page takes 128 KiB).
const PAGE: usize = 1 << 14;

/// The places of the records in a journal, by the number of the run.
pub(super) struct Places {
    runs: u64,
    /// For each run of a page the place where its record begins, plus 1; 0 for a run without a record. A page without
    /// rows is not held in memory.
    pages: Vec<Option<Box<[u64]>>>,
}

impl Places {
    /// Makes the places for a number of runs, none of which has a row yet.
    pub(super) fn of(runs: u64) -> Places {
        let pages = usize::try_from(runs.div_ceil(PAGE as u64)).unwrap_or(usize::MAX);
        Places { runs, pages: vec![None; pages] }
    }

    /// The place where the record of a run begins; `None` for a run without a record.
    ///
    /// # Panics
    /// Panics if there is no run of this number.
    pub(super) fn of_run(&self, run: u64) -> Option<u64> {
        let (page, place) = self.split(run);
        self.pages[page].as_ref()?[place].checked_sub(1)
    }

    /// Notes where the record of a run begins.
    ///
    /// # Panics
    /// Panics if there is no run of this number.
    pub(super) fn set(&mut self, run: u64, start: u64) {
        let (page, place) = self.split(run);
        let page = self.pages[page].get_or_insert_with(|| vec![0; PAGE].into_boxed_slice());
        page[place] = start + 1;
    }

    /// The first run from `run` on that has a row, and where its record begins.
    pub(super) fn next(&self, run: u64) -> Option<(u64, u64)> {
        let mut run = run;
        while run < self.runs {
            let (page, place) = self.split(run);
            let Some(held) = &self.pages[page] else {
                run += (PAGE - place) as u64;
                continue;
            };
            if let Some(start) = held[place].checked_sub(1) {
                return Some((run, start));
            }
            run += 1;
        }
        None
    }

    fn split(&self, run: u64) -> (usize, usize) {
        assert!(run < self.runs, "there are {} runs", self.runs);
        ((run / PAGE as u64) as usize, (run % PAGE as u64) as usize)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn places_of_many_runs_are_held_where_there_are_rows() {
        let runs = 100_000_000;
        let mut places = Places::of(runs);
        let known = [(0, 7), (5, 0), (PAGE as u64 - 1, 9), (PAGE as u64, 1), (runs - 1, 1 << 40)];
        for (run, start) in known {
            assert_eq!(places.of_run(run), None);
            places.set(run, start);
            assert_eq!(places.of_run(run), Some(start));
        }
        let mut found = Vec::new();
        let mut run = 0;
        while let Some((next, start)) = places.next(run) {
            found.push((next, start));
            run = next + 1;
        }
        assert_eq!(found, known);
        assert_eq!(places.pages.iter().flatten().count(), 3);
        assert_eq!(Places::of(0).next(0), None);
    }
}
