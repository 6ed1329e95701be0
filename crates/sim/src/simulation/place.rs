//! Placing bodies before the first step.

use super::Simulation;
use fenderline_world::error::SetupError;
use fenderline_world::start::BodyStart;

impl Simulation {
    /// Places floating bodies before the first step, each by its index. Orders, weather and faults that were given
    /// before stay.
    ///
    /// # Errors
    /// [`SetupError`], as for a new simulation, for example if a line is then too short; or a body that does not exist
    /// or is fixed. The simulation is then unchanged.
    ///
    /// # Panics
    /// If a step has been taken.
    pub fn place(&mut self, places: &[(usize, BodyStart)]) -> Result<(), SetupError> {
        assert_eq!(self.index, 0, "before the first step");
        let mut setup = self.setup.clone();
        for &(body, start) in places {
            let own = setup.bodies.get_mut(body).filter(|own| own.mass.is_some());
            let own = own.ok_or(SetupError::BadBody { owner: "place", body })?;
            let BodyStart { position_m, heading_rad, velocity } = start;
            (own.position_m, own.heading_rad, own.velocity) = (position_m, heading_rad, velocity);
        }
        let mut placed = Simulation::new(setup)?;
        placed.world.take_orders_of(&self.world);
        for (own, before) in placed.world.vessels.iter_mut().zip(&self.world.vessels) {
            own.faults = before.faults;
        }
        for (own, before) in placed.world.tugs.iter_mut().zip(&self.world.tugs) {
            own.out = before.out;
        }
        placed.changes = self.changes.clone();
        placed.buffers.external.copy_from_slice(&self.buffers.external);
        *self = placed;
        Ok(())
    }
}
