//! Which result tables a run writes, and how many steps one of their rows stands for.

/// Most rows of a body's series that a run writes by default.
const MOST_ROWS: u64 = 10_000;

/// A result table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum OutputTable {
    /// Bodies.
    Bodies,
    /// Patches of contact.
    Contacts,
    /// Fenders.
    Fenders,
    /// Panels on several cones.
    Panels,
    /// Chains of fenders.
    Chains,
    /// Vessels.
    Vessels,
    /// Tunnel thrusters.
    Thrusters,
    /// Azimuth units.
    Azimuths,
    /// Tugs.
    Tugs,
    /// Mooring lines.
    Lines,
    /// Anchors.
    Anchors,
    /// Passing ships.
    Passing,
    /// Flexible dolphins.
    Dolphins,
    /// The energy ledger.
    Energy,
}

impl OutputTable {
    /// All tables, in the order of the reference.
    pub const ALL: [OutputTable; 14] = [
        OutputTable::Bodies,
        OutputTable::Contacts,
        OutputTable::Fenders,
        OutputTable::Panels,
        OutputTable::Chains,
        OutputTable::Vessels,
        OutputTable::Thrusters,
        OutputTable::Azimuths,
        OutputTable::Tugs,
        OutputTable::Lines,
        OutputTable::Anchors,
        OutputTable::Passing,
        OutputTable::Dolphins,
        OutputTable::Energy,
    ];

    /// Its name: that of its file, without the extension.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            OutputTable::Bodies => "bodies",
            OutputTable::Contacts => "contacts",
            OutputTable::Fenders => "fenders",
            OutputTable::Panels => "panels",
            OutputTable::Chains => "chains",
            OutputTable::Vessels => "vessels",
            OutputTable::Thrusters => "thrusters",
            OutputTable::Azimuths => "azimuths",
            OutputTable::Tugs => "tugs",
            OutputTable::Lines => "lines",
            OutputTable::Anchors => "anchors",
            OutputTable::Passing => "passing",
            OutputTable::Dolphins => "dolphins",
            OutputTable::Energy => "energy",
        }
    }
}

/// What a run writes: the table `[output]` of a scenario. Summary, verdict and report use every step, whatever is written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputPlan {
    /// Steps that one row stands for, 1 or more: the output interval over Δt.
    pub steps_per_row: u64,
    /// The tables that are written, where the set-up has what they are about.
    pub tables: Vec<OutputTable>,
}

impl OutputPlan {
    /// All tables, a row for every step.
    #[must_use]
    pub fn every_step() -> OutputPlan {
        OutputPlan { steps_per_row: 1, tables: OutputTable::ALL.to_vec() }
    }

    /// What a run of so many steps writes if nothing is said: 1, 2, 5, 10, 20, 50, … steps a row, the fewest with which
    /// there are at most 10 000 rows of each body; and the tables of [`OutputPlan::default_tables`].
    #[must_use]
    pub fn of_steps(steps: f64) -> OutputPlan {
        let mut steps_per_row = 1;
        for factor in [2, 5, 2].into_iter().cycle() {
            if steps <= (steps_per_row * MOST_ROWS) as f64 {
                break;
            }
            // 1, 2, 5, 10: from 2 to 5 is half as much again.
            steps_per_row = if factor == 5 { steps_per_row / 2 * 5 } else { steps_per_row * 2 };
        }
        OutputPlan { steps_per_row, tables: OutputPlan::default_tables(steps_per_row) }
    }

    /// All tables; where a row stands for several steps, without that of contact patches, which is the largest.
    #[must_use]
    pub fn default_tables(steps_per_row: u64) -> Vec<OutputTable> {
        let all = OutputTable::ALL.into_iter();
        all.filter(|&table| steps_per_row == 1 || table != OutputTable::Contacts).collect()
    }

    /// Whether a table is written.
    #[must_use]
    pub fn has(&self, table: OutputTable) -> bool {
        self.tables.contains(&table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: three hours at 0.1 s are 108 000 steps, of which 20 make a row (5400 rows; with 10 it would be 10 800).
    #[test]
    fn long_runs_write_at_most_ten_thousand_rows_a_body() {
        let steps_per_row = |steps| OutputPlan::of_steps(steps).steps_per_row;
        assert_eq!([1.0, 1e4].map(steps_per_row), [1, 1]);
        assert_eq!([10_001.0, 2e4, 27_000.0, 5e4].map(steps_per_row), [2, 2, 5, 5]);
        assert_eq!([108_000.0, 1e9].map(steps_per_row), [20, 100_000]);
    }

    #[test]
    fn contact_patches_are_written_by_default_where_every_step_is() {
        assert!(OutputPlan::of_steps(100.0).has(OutputTable::Contacts));
        assert!(!OutputPlan::of_steps(1e6).has(OutputTable::Contacts));
        assert!(OutputPlan::of_steps(1e6).has(OutputTable::Fenders));
    }
}
