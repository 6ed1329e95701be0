//! The tables of a run, written step by step.

use fenderline_sim::{Energy, Setup, StepRecord};

use super::columns::{
    BodyRow, Column, ContactRow, ContactWorks, EnergyRow, FenderRow, Names, bodies_columns,
    contacts_columns, energy_columns, fenders_columns,
};
use super::part_file::{Folder, Sealed};
use super::world_tables::WorldTables;
use super::{Format, OutputError, REPORT, SUMMARY, WrittenFile, csv, parquet};
use crate::touched::touched;

/// The form of one table's file.
enum Store<R> {
    Csv(csv::CsvTable<R>),
    Parquet(parquet::ParquetTable<R>),
}

/// One table, in the format that the user asked for.
pub(super) struct Table<R> {
    name: &'static str,
    store: Store<R>,
    rows: u64,
}

/// Where and how the tables of a run are written.
pub(super) struct Place<'a> {
    folder: &'a Folder,
    format: Format,
    names: Names,
    facts: &'a [(&'a str, String)],
}

impl<R> Table<R> {
    pub(super) fn create(
        place: &Place<'_>,
        name: &'static str,
        columns: Vec<Column<R>>,
    ) -> Result<Table<R>, OutputError> {
        let Place { folder, format, names, facts } = place;
        let file = folder.create(&format!("{name}.{}", format.extension()))?;
        let store = match format {
            Format::Csv => Store::Csv(csv::CsvTable::create(file, columns, names.clone())?),
            Format::Parquet => {
                Store::Parquet(parquet::ParquetTable::create(file, name, columns, names, facts)?)
            }
        };
        Ok(Table { name, store, rows: 0 })
    }

    pub(super) fn push(&mut self, row: &R) -> Result<(), OutputError> {
        self.rows += 1;
        match &mut self.store {
            Store::Csv(table) => table.push(row),
            Store::Parquet(table) => table.push(row),
        }
    }

    pub(super) fn finish(self) -> Result<Sealed, OutputError> {
        match self.store {
            Store::Csv(table) => table.finish(),
            Store::Parquet(table) => table.finish(),
        }
    }

    pub(super) fn file(&self, format: Format) -> WrittenFile {
        let name = format!("{}.{}", self.name, format.extension());
        WrittenFile { name, rows: Some(self.rows) }
    }
}

/// All tables of a run; those of fenders, vessels, tugs and lines only where the set-up has any.
pub(crate) struct Tables {
    bodies: Table<BodyRow>,
    contacts: Table<ContactRow>,
    energy: Table<EnergyRow>,
    fenders: Option<Table<FenderRow>>,
    world: WorldTables,
    format: Format,
    step_s: f64,
    /// Width times height of each fender's face [m²].
    faces_m2: Vec<f64>,
}

impl Tables {
    /// Starts the files in `folder`, and the ledger with what there is at the `start`. `facts` are
    /// keys and values for the metadata, where the format has any.
    ///
    /// # Errors
    /// A file that cannot be created or written.
    pub(crate) fn create(
        folder: &Folder,
        format: Format,
        setup: &Setup,
        start: Energy,
        facts: &[(&str, String)],
    ) -> Result<Tables, OutputError> {
        let names = Names::of(setup);
        let place = Place { folder, format, names, facts };
        let fenders = match setup.fenders.as_slice() {
            [] => None,
            _ => Some(Table::create(&place, "fenders", fenders_columns())?),
        };
        let mut energy = Table::create(&place, "energy", energy_columns())?;
        energy.push(&EnergyRow { t_s: 0.0, energy: start })?;
        Ok(Tables {
            bodies: Table::create(&place, "bodies", bodies_columns())?,
            contacts: Table::create(&place, "contacts", contacts_columns())?,
            energy,
            fenders,
            world: WorldTables::create(&place, &setup.world)?,
            format,
            step_s: setup.step_s,
            faces_m2: setup.fenders.iter().map(|f| f.width_m * f.height_m).collect(),
        })
    }

    /// Adds the rows of one step.
    ///
    /// # Errors
    /// A file that cannot be written, or a value that is not finite.
    pub(crate) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), OutputError> {
        let t_s = step.t_s;
        for (body, (state, wrench)) in step.states.iter().zip(step.wrenches).enumerate() {
            self.bodies.push(&BodyRow::new(t_s, body, state, wrench))?;
        }
        let mut works = ContactWorks::of(step.books);
        for contact in step.contacts {
            let work_j = works.take(contact);
            self.contacts.push(&ContactRow { t_s, contact: *contact, work_j })?;
        }
        if let Some(table) = &mut self.fenders {
            for (fender, now) in touched(step.contacts) {
                table.push(&FenderRow::new(t_s, fender, self.faces_m2[fender], now))?;
            }
        }
        self.world.write(step)?;
        // The same product as the next step's start, so that the rows of both tables meet.
        let end_s = (step.index + 1) as f64 * self.step_s;
        self.energy.push(&EnergyRow { t_s: end_s, energy: step.energy })
    }

    /// The files that there will be, the report and the summary included.
    pub(crate) fn files(&self) -> Vec<WrittenFile> {
        let whole = |name: &str| WrittenFile { name: name.to_owned(), rows: None };
        let mut files = vec![self.bodies.file(self.format), self.contacts.file(self.format)];
        files.extend(self.fenders.as_ref().map(|table| table.file(self.format)));
        files.extend(self.world.files(self.format));
        files.extend([self.energy.file(self.format), whole(REPORT), whole(SUMMARY)]);
        files
    }

    /// Brings all tables to the disk, still under their `.part` names.
    pub(super) fn finish(self) -> Result<Vec<Sealed>, OutputError> {
        let mut files = vec![self.bodies.finish()?, self.contacts.finish()?, self.energy.finish()?];
        if let Some(table) = self.fenders {
            files.push(table.finish()?);
        }
        files.extend(self.world.finish()?);
        Ok(files)
    }
}
