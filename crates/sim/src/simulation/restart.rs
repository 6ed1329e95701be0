//! Starts a simulation again from its first step, in the memory that it has.

use fenderline_contact::{BodyState, Wrench};

use super::Simulation;
use fenderline_assess::statistics::Statistics;
use fenderline_assess::verdict::starts_inside;
use fenderline_world::change::Changes;
use fenderline_world::error::SetupError;
use fenderline_world::ledger::{Bodies, Ledger};
use fenderline_world::rigid_body::initial_state;
use fenderline_world::start::Start;

impl Simulation {
    /// Starts the simulation again, with another initial state of its bodies, another wind and another current. The
    /// result is the same, to the bit, as a new simulation of the set-up with this start. A restart takes a fraction of
    /// the time of a new simulation: most of the simulation stays as it is, and no memory is allocated for plain
    /// bodies.
    ///
    /// As in a new simulation, the orders, wind and current given during the last run and the wrenches that the host
    /// program set are forgotten.
    ///
    /// # Errors
    /// Returns the errors of [`Simulation::new`] if the set-up does not restart in place
    /// ([`crate::Setup::restarts_in_place`]); the simulation is then unchanged.
    ///
    /// # Panics
    /// Panics if the number of initial states is not the number of bodies.
    pub fn restart(&mut self, start: &Start) -> Result<(), SetupError> {
        if !self.setup.restarts_in_place() {
            let mut setup = self.setup.clone();
            setup.set_start(start);
            *self = Simulation::new(setup)?;
            return Ok(());
        }
        self.setup.set_start(start);
        let Simulation { setup, states, inertias, model, memory, work, world, .. } = self;
        states.clear();
        states.extend(setup.bodies.iter().map(initial_state));
        memory.forget();
        world.restart(&setup.world, states);
        self.watch.restart(setup, |is_protected| {
            starts_inside(setup, model, states, (&mut *memory, &mut *work), is_protected)
        });
        memory.forget();
        work.forget_results();
        let states: &[BodyState] = states;
        self.ledger = Ledger::new(Bodies { order: &world.order.bodies, inertias, states });
        self.changes = Changes::default();
        self.index = 0;
        self.statistics = Statistics::new(setup);
        self.contact_totals.restart();
        self.summaries.pairs.clear();
        self.fender_summaries.restart();
        self.buffers.external.fill(Wrench::default());
        Ok(())
    }
}
