//! Fills the tables of a run step by step.

use fenderline_sim::{Energy, FenderSetup, OutputPlan, OutputTable, Setup, StepRecord};

use crate::columns::{
    BodyRow, ChainRow, ContactRow, ContactWorks, DolphinRow, EnergyRow, FenderRow, Names, PanelRow,
    bodies_table, chains_table, contacts_table, dolphins_table, energy_table, fenders_table,
    panels_table,
};
use crate::interval::{Interval, Rows};
use crate::medium::{Counted, Medium};
use crate::touched::touched;
use crate::world_tables::WorldTables;

/// The tables of a run that its plan asks for; the tables of fenders, panels, chains, vessels,
/// tugs, lines and dolphins only if the set-up has any.
pub struct Tables<M: Medium> {
    bodies: Option<Rows<M, BodyRow>>,
    contacts: Option<Rows<M, ContactRow>>,
    energy: Option<Counted<M, EnergyRow>>,
    fenders: Option<Rows<M, FenderRow>>,
    dolphins: Option<Rows<M, DolphinRow>>,
    panels: Option<Rows<M, PanelRow>>,
    chains: Option<Rows<M, ChainRow>>,
    world: WorldTables<M>,
    interval: Interval,
    /// The energy ledger at the end of the last time step.
    last: EnergyRow,
    step_s: f64,
    fender_setups: Vec<FenderSetup>,
}

impl<M: Medium> Tables<M> {
    /// Starts the tables of `plan`; the first row of the energy ledger is the energy at the `start`.
    ///
    /// # Errors
    /// Fails with an error of the medium.
    pub fn start(
        medium: &M,
        setup: &Setup,
        start: Energy,
        plan: &OutputPlan,
    ) -> Result<Tables<M>, M::Error> {
        let names = &Names::of(setup);
        let is_wanted = |table| plan.has(table).then_some(());
        let first = EnergyRow { t_s: 0.0, energy: start };
        let energy = match is_wanted(OutputTable::Energy) {
            None => None,
            Some(()) => {
                let mut energy = Counted::start(medium, names, energy_table())?;
                energy.push(&first)?;
                Some(energy)
            }
        };
        let fenders = is_wanted(OutputTable::Fenders).filter(|()| !setup.fenders.is_empty());
        let has_dolphins = setup.bodies.iter().any(|body| body.dolphin.is_some());
        let dolphins = is_wanted(OutputTable::Dolphins).filter(|()| has_dolphins);
        let any = |has: fn(&FenderSetup) -> bool| setup.fenders.iter().any(has).then_some(());
        let panels =
            is_wanted(OutputTable::Panels).and_then(|()| any(|fender| fender.panel.is_some()));
        let chains =
            is_wanted(OutputTable::Chains).and_then(|()| any(|fender| !fender.chains.is_empty()));
        Ok(Tables {
            bodies: is_wanted(OutputTable::Bodies)
                .map(|()| Rows::start(medium, names, bodies_table()))
                .transpose()?,
            contacts: is_wanted(OutputTable::Contacts)
                .map(|()| Rows::start(medium, names, contacts_table()))
                .transpose()?,
            energy,
            fenders: fenders.map(|()| Rows::start(medium, names, fenders_table())).transpose()?,
            dolphins: dolphins
                .map(|()| Rows::start(medium, names, dolphins_table()))
                .transpose()?,
            panels: panels.map(|()| Rows::start(medium, names, panels_table())).transpose()?,
            chains: chains.map(|()| Rows::start(medium, names, chains_table())).transpose()?,
            world: WorldTables::start(medium, names, &setup.world, plan)?,
            interval: Interval::new(plan.steps_per_row),
            last: first,
            step_s: setup.step_s,
            fender_setups: setup.fenders.clone(),
        })
    }

    /// Adds one time step; if the step ends an output interval, writes the rows of the interval.
    ///
    /// # Errors
    /// Fails with an error of the medium, or if a value is not finite.
    pub fn write(&mut self, step: &StepRecord<'_>) -> Result<(), M::Error> {
        self.interval.advance(step.t_s);
        let (interval, t_s) = (&self.interval, self.interval.start_s);
        if let Some(table) = &mut self.bodies {
            for (body, (state, wrench)) in step.states.iter().zip(step.wrenches).enumerate() {
                table.push(interval, BodyRow::new(t_s, body, state, wrench))?;
            }
        }
        if let Some(table) = &mut self.contacts {
            let mut works = ContactWorks::of(step.contact_energies);
            for contact in step.contacts {
                let work_j = works.take(contact);
                table.push(interval, ContactRow { t_s, contact: *contact, work_j })?;
            }
        }
        if let Some(table) = &mut self.fenders {
            for (fender, now) in touched(step.contacts) {
                let row = FenderRow::new(t_s, fender, &self.fender_setups[fender], now);
                table.push(interval, row)?;
            }
        }
        if let Some(table) = &mut self.panels {
            for motion in step.panels {
                let cones = self.fender_setups[motion.fender.0 as usize].cones() as usize;
                table.push(interval, PanelRow::new(t_s, motion, cones))?;
            }
        }
        if let Some(table) = &mut self.chains {
            for chain in step.chains {
                table.push(interval, ChainRow { t_s, chain: *chain })?;
            }
        }
        self.world.write(step, interval)?;
        if let Some(table) = &mut self.dolphins {
            for now in step.dolphins {
                table.push(interval, DolphinRow::new(t_s, now))?;
            }
        }
        // The same product as the next step's start, so that the rows of both tables meet.
        let end_s = (step.index + 1) as f64 * self.step_s;
        self.last = EnergyRow { t_s: end_s, energy: step.energy() };
        if self.interval.is_over() { self.end_interval() } else { Ok(()) }
    }

    /// Writes the rows of an interval that the run's end cut short. [`Tables::finish`] calls it.
    ///
    /// # Errors
    /// Fails with an error of the medium.
    pub fn end_interval(&mut self) -> Result<(), M::Error> {
        if !self.interval.is_begun() {
            return Ok(());
        }
        let interval = self.interval;
        self.interval.end();
        self.bodies.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.contacts.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.fenders.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.panels.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.chains.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.world.close(&interval)?;
        self.dolphins.as_mut().map_or(Ok(()), |table| table.close(&interval))?;
        self.energy.as_mut().map_or(Ok(()), |table| table.push(&self.last))
    }

    /// Names of the tables, each with the number of rows written so far.
    #[must_use]
    pub fn rows(&self) -> Vec<(&'static str, u64)> {
        let mut rows = Vec::new();
        rows.extend(self.bodies.as_ref().map(Rows::rows));
        rows.extend(self.contacts.as_ref().map(Rows::rows));
        rows.extend(self.fenders.as_ref().map(Rows::rows));
        rows.extend(self.panels.as_ref().map(Rows::rows));
        rows.extend(self.chains.as_ref().map(Rows::rows));
        rows.extend(self.world.rows());
        rows.extend(self.dolphins.as_ref().map(Rows::rows));
        rows.extend(self.energy.as_ref().map(Counted::rows));
        rows
    }

    /// Ends the tables and returns them, in the order of [`Tables::rows`].
    ///
    /// # Errors
    /// Fails with an error of the medium.
    pub fn finish(mut self) -> Result<Vec<M::Done>, M::Error> {
        self.end_interval()?;
        let mut done = Vec::new();
        done.extend(self.bodies.map(Rows::finish).transpose()?);
        done.extend(self.contacts.map(Rows::finish).transpose()?);
        done.extend(self.fenders.map(Rows::finish).transpose()?);
        done.extend(self.panels.map(Rows::finish).transpose()?);
        done.extend(self.chains.map(Rows::finish).transpose()?);
        done.extend(self.world.finish()?);
        done.extend(self.dolphins.map(Rows::finish).transpose()?);
        done.extend(self.energy.map(Counted::finish).transpose()?);
        Ok(done)
    }
}
