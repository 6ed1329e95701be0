//! The tables of vessels, thrusters, azimuth units, tugs and lines, if the set-up has any.

use fenderline_sim::{StepRecord, WorldSetup};

use crate::columns::{
    AzimuthRow, Layout, LineRow, Names, ThrusterRow, TugRow, VesselRow, azimuths_table,
    lines_table, thrusters_table, tugs_table, vessels_table,
};
use crate::medium::{Counted, Medium};

/// These tables of a run.
pub(crate) struct WorldTables<M: Medium> {
    setup: WorldSetup,
    vessels: Option<Counted<M, VesselRow>>,
    thrusters: Option<Counted<M, ThrusterRow>>,
    azimuths: Option<Counted<M, AzimuthRow>>,
    tugs: Option<Counted<M, TugRow>>,
    lines: Option<Counted<M, LineRow>>,
}

impl<M: Medium> WorldTables<M> {
    pub(crate) fn start(
        medium: &M,
        names: &Names,
        setup: &WorldSetup,
    ) -> Result<WorldTables<M>, M::Error> {
        let has_thrusters = setup.vessels.iter().any(|vessel| !vessel.thrusters.is_empty());
        let has_azimuths = setup.vessels.iter().any(|vessel| !vessel.azimuths.is_empty());
        let has_vessels = !setup.vessels.is_empty();
        let of = (medium, names);
        Ok(WorldTables {
            vessels: table(has_vessels, of, vessels_table)?,
            thrusters: table(has_thrusters, of, thrusters_table)?,
            azimuths: table(has_azimuths, of, azimuths_table)?,
            tugs: table(!setup.tugs.is_empty(), of, tugs_table)?,
            lines: table(!setup.lines.is_empty(), of, lines_table)?,
            setup: setup.clone(),
        })
    }

    /// Adds the rows of one step.
    pub(crate) fn write(&mut self, step: &StepRecord<'_>) -> Result<(), M::Error> {
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

    /// Names of the tables, with their numbers of rows.
    pub(crate) fn rows(&self) -> Vec<(&'static str, u64)> {
        let rows = [
            self.vessels.as_ref().map(Counted::rows),
            self.thrusters.as_ref().map(Counted::rows),
            self.azimuths.as_ref().map(Counted::rows),
            self.tugs.as_ref().map(Counted::rows),
            self.lines.as_ref().map(Counted::rows),
        ];
        rows.into_iter().flatten().collect()
    }

    /// Ends the tables.
    pub(crate) fn finish(self) -> Result<Vec<M::Done>, M::Error> {
        let done = [
            self.vessels.map(Counted::finish),
            self.thrusters.map(Counted::finish),
            self.azimuths.map(Counted::finish),
            self.tugs.map(Counted::finish),
            self.lines.map(Counted::finish),
        ];
        done.into_iter().flatten().collect()
    }
}

fn table<M: Medium, R>(
    is_wanted: bool,
    (medium, names): (&M, &Names),
    layout: fn() -> Layout<R>,
) -> Result<Option<Counted<M, R>>, M::Error> {
    is_wanted.then(|| Counted::start(medium, names, layout())).transpose()
}
