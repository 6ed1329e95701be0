//! The tables of a run, filled step by step.

use fenderline_sim::{Energy, FenderSetup, Setup, StepRecord};

use crate::columns::{
    BodyRow, ContactRow, ContactWorks, EnergyRow, FenderRow, Names, bodies_table, contacts_table,
    energy_table, fenders_table,
};
use crate::medium::{Counted, Medium};
use crate::touched::touched;
use crate::world_tables::WorldTables;

/// All tables of a run; those of fenders, vessels, tugs and lines only if the set-up has any.
pub struct Tables<M: Medium> {
    bodies: Counted<M, BodyRow>,
    contacts: Counted<M, ContactRow>,
    energy: Counted<M, EnergyRow>,
    fenders: Option<Counted<M, FenderRow>>,
    world: WorldTables<M>,
    step_s: f64,
    fender_setups: Vec<FenderSetup>,
}

impl<M: Medium> Tables<M> {
    /// Starts the tables; the ledger's first row is the energy at the `start`.
    ///
    /// # Errors
    /// The medium's own.
    pub fn start(medium: &M, setup: &Setup, start: Energy) -> Result<Tables<M>, M::Error> {
        let names = &Names::of(setup);
        let fenders = match setup.fenders.as_slice() {
            [] => None,
            _ => Some(Counted::start(medium, names, fenders_table())?),
        };
        let mut energy = Counted::start(medium, names, energy_table())?;
        energy.push(&EnergyRow { t_s: 0.0, energy: start })?;
        Ok(Tables {
            bodies: Counted::start(medium, names, bodies_table())?,
            contacts: Counted::start(medium, names, contacts_table())?,
            energy,
            fenders,
            world: WorldTables::start(medium, names, &setup.world)?,
            step_s: setup.step_s,
            fender_setups: setup.fenders.clone(),
        })
    }

    /// Adds the rows of one step.
    ///
    /// # Errors
    /// The medium's own, or a value that is not finite.
    pub fn write(&mut self, step: &StepRecord<'_>) -> Result<(), M::Error> {
        let t_s = step.t_s;
        for (body, (state, wrench)) in step.states.iter().zip(step.wrenches).enumerate() {
            self.bodies.push(&BodyRow::new(t_s, body, state, wrench))?;
        }
        let mut works = ContactWorks::of(step.contact_energies);
        for contact in step.contacts {
            let work_j = works.take(contact);
            self.contacts.push(&ContactRow { t_s, contact: *contact, work_j })?;
        }
        if let Some(table) = &mut self.fenders {
            for (fender, now) in touched(step.contacts) {
                table.push(&FenderRow::new(t_s, fender, &self.fender_setups[fender], now))?;
            }
        }
        self.world.write(step)?;
        // The same product as the next step's start, so that the rows of both tables meet.
        let end_s = (step.index + 1) as f64 * self.step_s;
        self.energy.push(&EnergyRow { t_s: end_s, energy: step.energy })
    }

    /// Names of the tables, with their numbers of rows.
    #[must_use]
    pub fn rows(&self) -> Vec<(&'static str, u64)> {
        let mut rows = vec![self.bodies.rows(), self.contacts.rows()];
        rows.extend(self.fenders.as_ref().map(Counted::rows));
        rows.extend(self.world.rows());
        rows.push(self.energy.rows());
        rows
    }

    /// Ends the tables and returns them, in the order of [`Tables::rows`].
    ///
    /// # Errors
    /// The medium's own.
    pub fn finish(self) -> Result<Vec<M::Done>, M::Error> {
        let mut done = vec![self.bodies.finish()?, self.contacts.finish()?];
        if let Some(table) = self.fenders {
            done.push(table.finish()?);
        }
        done.extend(self.world.finish()?);
        done.push(self.energy.finish()?);
        Ok(done)
    }
}
