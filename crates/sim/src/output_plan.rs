//! The result tables that a run writes, and the number of steps that one row stands for.

/// The largest number of rows that a run writes by default for each body.
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
    /// All result tables, in the order of the reference document.
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

    /// Name of the result table, which is the name of its file without the extension.
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

/// The outputs that a run writes, as the table `[output]` of a scenario says. Summary, verdict and report use every
/// step, whatever tables are written.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OutputPlan {
    /// Number of steps that one row stands for, 1 or more: the output interval divided by Δt.
    pub steps_per_row: u64,
    /// The tables to write. A table is written only if the set-up has what the table is about, for example fenders.
    pub tables: Vec<OutputTable>,
}

impl OutputPlan {
    /// Makes a plan with all result tables, and a row for every step.
    #[must_use]
    pub fn every_step() -> OutputPlan {
        OutputPlan { steps_per_row: 1, tables: OutputTable::ALL.to_vec() }
    }

    /// Makes the plan for a run with this number of steps, if the scenario has no plan. One row stands for 1, 2, 5, 10,
    /// 20, 50, … steps: for the smallest of these numbers with which each body has at most 10 000 rows. The tables of
    /// the plan are those of [`OutputPlan::default_tables`].
    #[must_use]
    pub fn of_steps(steps: f64) -> OutputPlan {
        let mut steps_per_row = 1;
        for factor in [2, 5, 2].into_iter().cycle() {
            if steps <= (steps_per_row * MOST_ROWS) as f64 {
                break;
            }
            // The series is 1, 2, 5, 10. From 2 to 4 it would be doubled; half as much again makes 5.
            steps_per_row = if factor == 5 { steps_per_row / 2 * 5 } else { steps_per_row * 2 };
        }
        OutputPlan { steps_per_row, tables: OutputPlan::default_tables(steps_per_row) }
    }

    /// The result tables that are written by default: all tables. If a row stands for several steps, the table of
    /// contact patches is left out, because it is the largest table.
    #[must_use]
    pub fn default_tables(steps_per_row: u64) -> Vec<OutputTable> {
        let all = OutputTable::ALL.into_iter();
        all.filter(|&table| steps_per_row == 1 || table != OutputTable::Contacts).collect()
    }

    /// Returns true if the plan has this table.
    #[must_use]
    pub fn has(&self, table: OutputTable) -> bool {
        self.tables.contains(&table)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// By hand: three hours at 0.1 s are 108 000 steps. With 20 steps per row there are 5400 rows; with 10 there would
    /// be 10 800.
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
