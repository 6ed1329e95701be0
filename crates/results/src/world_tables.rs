//! The tables of vessels, thrusters, azimuth units, tugs and lines: each only where the set-up has any.

use fenderline_sim::{StepRecord, WorldSetup};

use super::columns::{
    AzimuthRow, Column, LineRow, ThrusterRow, TugRow, VesselRow, azimuths_columns, lines_columns,
    thrusters_columns, tugs_columns, vessels_columns,
};
use super::part_file::Sealed;
use super::tables::{Place, Table};
use super::{Format, OutputError, WrittenFile};

/// These tables of a run.
pub(super) struct WorldTables {
    setup: WorldSetup,
    vessels: Option<Table<VesselRow>>,
    thrusters: Option<Table<ThrusterRow>>,
    azimuths: Option<Table<AzimuthRow>>,
    tugs: Option<Table<TugRow>>,
    lines: Option<Table<LineRow>>,
}

fn table<R>(
    is_wanted: bool,
    place: &Place<'_>,
    name: &'static str,
    columns: fn() -> Vec<Column<R>>,
) -> Result<Option<Table<R>>, OutputError> {
    is_wanted.then(|| Table::create(place, name, columns())).transpose()
}

impl WorldTables {
    pub(super) fn create(
        place: &Place<'_>,
        setup: &WorldSetup,
    ) -> Result<WorldTables, OutputError> {
        let has_thrusters = setup.vessels.iter().any(|vessel| !vessel.thrusters.is_empty());
        let has_azimuths = setup.vessels.iter().any(|vessel| !vessel.azimuths.is_empty());
        Ok(WorldTables {
            vessels: table(!setup.vessels.is_empty(), place, "vessels", vessels_columns)?,
            thrusters: table(has_thrusters, place, "thrusters", thrusters_columns)?,
            azimuths: table(has_azimuths, place, "azimuths", azimuths_columns)?,
            tugs: table(!setup.tugs.is_empty(), place, "tugs", tugs_columns)?,
            lines: table(!setup.lines.is_empty(), place, "lines", lines_columns)?,
            setup: setup.clone(),
        })
    }

    /// Adds the rows of one step.
    pub(super) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), OutputError> {
        let t_s = step.t_s;
        let environment = &self.setup.environment;
        if let Some(table) = &mut self.vessels {
            for (index, vessel) in self.setup.vessels.iter().enumerate() {
                let state = &step.states[vessel.body];
                let (now, forces) = (&step.vessels[index], &step.vessel_forces[index]);
                let of = (vessel, environment);
                table.push(&VesselRow::new(t_s, index, of, state, now, forces))?;
            }
        }
        if let Some(table) = &mut self.thrusters {
            let mut numbers = 0..;
            for (vessel, now) in step.vessels.iter().enumerate() {
                let each = now.orders.thrusters.iter().zip(&now.thrusters);
                for ((&order, lag), thruster) in each.zip(numbers.by_ref()) {
                    table.push(&ThrusterRow { t_s, vessel, thruster, order, power: lag.value })?;
                }
            }
        }
        if let Some(table) = &mut self.azimuths {
            let mut numbers = 0..;
            for (vessel, now) in step.vessels.iter().enumerate() {
                let each = now.orders.azimuths.iter().zip(&now.azimuths);
                for ((&order, &now), azimuth) in each.zip(numbers.by_ref()) {
                    table.push(&AzimuthRow { t_s, vessel, azimuth, order, now })?;
                }
            }
        }
        if let Some(table) = &mut self.tugs {
            for (index, now) in step.tugs.iter().enumerate() {
                table.push(&TugRow::new(t_s, index, now))?;
            }
        }
        if let Some(table) = &mut self.lines {
            for (index, now) in step.lines.iter().enumerate() {
                if let Some(row) = LineRow::new(t_s, index, now) {
                    table.push(&row)?;
                }
            }
        }
        Ok(())
    }

    /// The files that there will be.
    pub(super) fn files(&self, format: Format) -> Vec<WrittenFile> {
        let files = [
            self.vessels.as_ref().map(|table| table.file(format)),
            self.thrusters.as_ref().map(|table| table.file(format)),
            self.azimuths.as_ref().map(|table| table.file(format)),
            self.tugs.as_ref().map(|table| table.file(format)),
            self.lines.as_ref().map(|table| table.file(format)),
        ];
        files.into_iter().flatten().collect()
    }

    /// Brings these tables to the disk, still under their `.part` names.
    pub(super) fn finish(self) -> Result<Vec<Sealed>, OutputError> {
        let sealed = [
            self.vessels.map(Table::finish),
            self.thrusters.map(Table::finish),
            self.azimuths.map(Table::finish),
            self.tugs.map(Table::finish),
            self.lines.map(Table::finish),
        ];
        sealed.into_iter().flatten().collect()
    }
}
