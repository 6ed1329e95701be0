//! Places bodies before the first step of a run.

use super::Simulation;
use fenderline_world::error::SetupError;
use fenderline_world::start::BodyStart;

impl Simulation {
    /// Places floating bodies before the first step; each body is given by its index. Orders, weather and faults that
    /// were given before the call stay.
    ///
    /// # Errors
    /// Returns the [`SetupError`] that a new simulation would give, for example if a line is then too short; or an
    /// error for a body that does not exist or is fixed. After an error the simulation is unchanged.
    ///
    /// # Panics
    /// Panics if a step has been taken.
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
