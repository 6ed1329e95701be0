//! The time series of a workbook, collected during the run.

use fenderline_results::{InMemory, KeptTable, NotFinite, Tables};
use fenderline_sim::{OutputPlan, OutputTable, Setup, StepRecord};

use crate::failure::Failure;
use crate::played::Start;

/// Largest number of rows of a sheet that Excel opens, without the two head lines.
pub(super) const MOST_ROWS: usize = 1_048_576 - 2;

/// The time series of the workbook, held in memory; `None` if the command line asks for none.
pub(crate) struct Sheets(Option<Tables<InMemory>>);

/// The result tables that `names` lists, separated by commas.
///
/// # Errors
/// Fails if no table has a given name, or if the scenario has nothing to fill the table, such as lines.
pub(super) fn chosen(names: Option<&str>, setup: &Setup) -> Result<Vec<OutputTable>, Failure> {
    let Some(names) = names else { return Ok(Vec::new()) };
    let mut all = Vec::new();
    for name in names.split(',').map(str::trim) {
        let Some(table) = OutputTable::ALL.into_iter().find(|table| table.name() == name) else {
            let known = OutputTable::ALL.map(OutputTable::name).join(", ");
            return Err(Failure::input(format_args!(
                "error: --sheets {names}: there is no table `{name}`; the tables are {known}"
            )));
        };
        if is_empty(table, setup) {
            return Err(Failure::input(format_args!(
                "error: --sheets {names}: the scenario has no {name}"
            )));
        }
        if !all.contains(&table) {
            all.push(table);
        }
    }
    Ok(all)
}

/// Whether the set-up has nothing to fill the table, such as no fenders for the table of fenders.
fn is_empty(table: OutputTable, setup: &Setup) -> bool {
    let world = &setup.world;
    match table {
        OutputTable::Bodies | OutputTable::Contacts | OutputTable::Energy => false,
        OutputTable::Fenders => setup.fenders.is_empty(),
        OutputTable::Panels => setup.fenders.iter().all(|fender| fender.panel.is_none()),
        OutputTable::Chains => setup.fenders.iter().all(|fender| fender.chains.is_empty()),
        OutputTable::Vessels => world.vessels.is_empty(),
        OutputTable::Thrusters => world.vessels.iter().all(|vessel| vessel.thrusters.is_empty()),
        OutputTable::Azimuths => world.vessels.iter().all(|vessel| vessel.azimuths.is_empty()),
        OutputTable::Tugs => world.tugs.is_empty(),
        OutputTable::Lines => world.lines.is_empty(),
        OutputTable::Anchors => world.anchors.is_empty(),
        OutputTable::Passing => world.flow.passing.is_empty(),
        OutputTable::Dolphins => setup.bodies.iter().all(|body| body.dolphin.is_none()),
    }
}

impl Sheets {
    /// Starts the time series; a row stands for as many time steps as in the scenario's result files.
    ///
    /// # Errors
    /// As [`Sheets::write`].
    pub(super) fn start(tables: &[OutputTable], start: &Start) -> Result<Sheets, Failure> {
        if tables.is_empty() {
            return Ok(Sheets(None));
        }
        let steps_per_row = start.output.steps_per_row;
        let plan = OutputPlan { steps_per_row, tables: tables.to_vec() };
        let tables = Tables::start(&InMemory, start.setup(), start.energy(), &plan);
        Ok(Sheets(Some(tables.map_err(failure)?)))
    }

    /// Adds a step.
    ///
    /// # Errors
    /// Fails if a value is not finite, or if there are more rows than a sheet holds.
    pub(crate) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), Failure> {
        let Some(tables) = &mut self.0 else { return Ok(()) };
        tables.write(step).map_err(failure)?;
        match tables.rows().into_iter().find(|(_, rows)| *rows > MOST_ROWS as u64) {
            None => Ok(()),
            Some((name, _)) => Err(Failure::input(format_args!(
                "error: --sheets: the table `{name}` has more than {MOST_ROWS} rows, the most that \
                 a sheet holds; give a longer --interval, so that a row stands for a longer time"
            ))),
        }
    }

    /// The tables.
    ///
    /// # Errors
    /// As [`Sheets::write`].
    pub(super) fn finish(self) -> Result<Vec<KeptTable>, Failure> {
        self.0.map_or(Ok(Vec::new()), |tables| tables.finish().map_err(failure))
    }
}

fn failure(error: NotFinite) -> Failure {
    Failure::case(format_args!("error: {error}"))
}
