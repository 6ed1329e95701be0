//! The tables of vessels, thrusters, azimuth units, tugs, lines and anchors, if the set-up has any.

use fenderline_sim::{OutputPlan, OutputTable, StepRecord, WorldSetup};

use crate::columns::{
    AnchorRow, AzimuthRow, Layout, LineRow, Names, PassingRow, ThrusterRow, TugRow, VesselRow,
    anchors_table, azimuths_table, lines_table, passing_table, thrusters_table, tugs_table,
    vessels_table,
};
use crate::interval::{Interval, Rows};
use crate::medium::Medium;
use crate::row::Row;

/// The tables of vessels, thrusters, azimuth units, tugs, lines and anchors of a run.
pub(crate) struct WorldTables<M: Medium> {
    setup: WorldSetup,
    vessels: Option<Rows<M, VesselRow>>,
    thrusters: Option<Rows<M, ThrusterRow>>,
    azimuths: Option<Rows<M, AzimuthRow>>,
    tugs: Option<Rows<M, TugRow>>,
    lines: Option<Rows<M, LineRow>>,
    anchors: Option<Rows<M, AnchorRow>>,
    passing: Option<Rows<M, PassingRow>>,
}

impl<M: Medium> WorldTables<M> {
    pub(crate) fn start(
        medium: &M,
        names: &Names,
        setup: &WorldSetup,
        plan: &OutputPlan,
    ) -> Result<WorldTables<M>, M::Error> {
        let has_thrusters = plan.has(OutputTable::Thrusters)
            && setup.vessels.iter().any(|vessel| !vessel.thrusters.is_empty());
        let has_azimuths = plan.has(OutputTable::Azimuths)
            && setup.vessels.iter().any(|vessel| !vessel.azimuths.is_empty());
        let has_vessels = plan.has(OutputTable::Vessels) && !setup.vessels.is_empty();
        let has_tugs = plan.has(OutputTable::Tugs) && !setup.tugs.is_empty();
        let has_lines = plan.has(OutputTable::Lines) && !setup.lines.is_empty();
        let has_anchors = plan.has(OutputTable::Anchors) && !setup.anchors.is_empty();
        let has_passing = plan.has(OutputTable::Passing) && !setup.flow.passing.is_empty();
        let of = (medium, names);
        Ok(WorldTables {
            vessels: table(has_vessels, of, vessels_table)?,
            thrusters: table(has_thrusters, of, thrusters_table)?,
            azimuths: table(has_azimuths, of, azimuths_table)?,
            tugs: table(has_tugs, of, tugs_table)?,
            lines: table(has_lines, of, lines_table)?,
            anchors: table(has_anchors, of, anchors_table)?,
            passing: table(has_passing, of, passing_table)?,
            setup: setup.clone(),
        })
    }

    /// Adds one time step of an output interval.
    pub(crate) fn write(
        &mut self,
        step: &StepRecord<'_>,
        interval: &Interval,
    ) -> Result<(), M::Error> {
        let t_s = interval.start_s;
        let environment = &self.setup.environment;
        if let Some(table) = &mut self.vessels {
            for (index, vessel) in self.setup.vessels.iter().enumerate() {
                let state = &step.states[vessel.body];
                let forces = &step.vessel_forces[index];
                let now = (&step.vessels[index], &step.soundings[index]);
                let of = (vessel, environment);
                table.push(
                    interval,
                    VesselRow::new(step.t_s, index, of, state, now, forces).at(t_s),
                )?;
            }
        }
        if let Some(table) = &mut self.thrusters {
            let mut numbers = 0..;
            for (vessel, now) in step.vessels.iter().enumerate() {
                let each = now.orders.thrusters.iter().zip(&now.thrusters);
                for ((&order, lag), thruster) in each.zip(numbers.by_ref()) {
                    let power = lag.value;
                    table.push(interval, ThrusterRow { t_s, vessel, thruster, order, power })?;
                }
            }
        }
        if let Some(table) = &mut self.azimuths {
            let mut numbers = 0..;
            for (vessel, now) in step.vessels.iter().enumerate() {
                let each = now.orders.azimuths.iter().zip(&now.azimuths);
                for ((&order, &now), azimuth) in each.zip(numbers.by_ref()) {
                    table.push(interval, AzimuthRow { t_s, vessel, azimuth, order, now })?;
                }
            }
        }
        if let Some(table) = &mut self.tugs {
            for (index, now) in step.tugs.iter().enumerate() {
                table.push(interval, TugRow::new(t_s, index, now))?;
            }
        }
        if let Some(table) = &mut self.lines {
            for (index, now) in step.lines.iter().enumerate() {
                if let Some(row) = LineRow::new(t_s, index, now) {
                    table.push(interval, row)?;
                }
            }
        }
        if let Some(table) = &mut self.anchors {
            for (index, (of, now)) in self.setup.anchors.iter().zip(step.anchors).enumerate() {
                let body = self.setup.vessels[of.vessel].body;
                let heading_rad = step.states[body].heading_rad;
                table.push(interval, AnchorRow::new(t_s, index, heading_rad, now))?;
            }
        }
        if let Some(table) = &mut self.passing {
            for (index, ship) in self.setup.flow.passing.iter().enumerate() {
                table.push(interval, PassingRow::new(t_s, index, ship))?;
            }
        }
        Ok(())
    }

    /// Writes the rows of an output interval that is over.
    pub(crate) fn close(&mut self, interval: &Interval) -> Result<(), M::Error> {
        self.vessels.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.thrusters.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.azimuths.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.tugs.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.lines.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.anchors.as_mut().map_or(Ok(()), |table| table.close(interval))?;
        self.passing.as_mut().map_or(Ok(()), |table| table.close(interval))
    }

    /// Names of the tables, with their numbers of rows.
    pub(crate) fn rows(&self) -> Vec<(&'static str, u64)> {
        let rows = [
            self.vessels.as_ref().map(Rows::rows),
            self.thrusters.as_ref().map(Rows::rows),
            self.azimuths.as_ref().map(Rows::rows),
            self.tugs.as_ref().map(Rows::rows),
            self.lines.as_ref().map(Rows::rows),
            self.anchors.as_ref().map(Rows::rows),
            self.passing.as_ref().map(Rows::rows),
        ];
        rows.into_iter().flatten().collect()
    }

    /// Ends the tables.
    pub(crate) fn finish(self) -> Result<Vec<M::Done>, M::Error> {
        let done = [
            self.vessels.map(Rows::finish),
            self.thrusters.map(Rows::finish),
            self.azimuths.map(Rows::finish),
            self.tugs.map(Rows::finish),
            self.lines.map(Rows::finish),
            self.anchors.map(Rows::finish),
            self.passing.map(Rows::finish),
        ];
        done.into_iter().flatten().collect()
    }
}

fn table<M: Medium, R: Row>(
    is_wanted: bool,
    (medium, names): (&M, &Names),
    layout: fn() -> Layout<R>,
) -> Result<Option<Rows<M, R>>, M::Error> {
    is_wanted.then(|| Rows::start(medium, names, layout())).transpose()
}
