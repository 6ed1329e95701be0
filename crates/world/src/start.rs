//! The data that may differ between two runs if a host program starts the same simulation again: initial states of the
//! bodies, wind and current.

use fenderline_contact::Vec2;

use crate::setup::{BodySetup, BodyVelocity, Setup};
use fenderline_ship::environment::current::Current;
use fenderline_ship::environment::wind::Wind;

/// The start of a run. `Simulation::restart` of the crate `fenderline-sim` starts a simulation again with this data.
#[derive(Clone, Debug, PartialEq)]
pub struct Start {
    /// Initial states of the bodies, in the order of the set-up.
    pub bodies: Vec<BodyStart>,
    /// Wind; `None` for no wind.
    pub wind: Option<Wind>,
    /// Current; `None` for no current.
    pub current: Option<Current>,
}

/// Initial state of a body, as in [`BodySetup`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BodyStart {
    /// Position of the centre of gravity, north and east (m).
    pub position_m: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
    /// Velocity of the body, in the body's axes.
    pub velocity: BodyVelocity,
}

impl BodyStart {
    fn of(body: &BodySetup) -> BodyStart {
        let &BodySetup { position_m, heading_rad, velocity, .. } = body;
        BodyStart { position_m, heading_rad, velocity }
    }
}

impl Setup {
    /// The initial states, the wind and the current of this set-up.
    #[must_use]
    pub fn start(&self) -> Start {
        let environment = &self.world.environment;
        Start {
            bodies: self.bodies.iter().map(BodyStart::of).collect(),
            wind: environment.wind.clone(),
            current: environment.current.clone(),
        }
    }

    /// Writes the initial states, the wind and the current of this set-up into `start`, without allocation if `start`
    /// has as many bodies, the wind has no gusts, and wind and current come from no file.
    pub fn start_into(&self, start: &mut Start) {
        start.bodies.clear();
        start.bodies.extend(self.bodies.iter().map(BodyStart::of));
        start.wind.clone_from(&self.world.environment.wind);
        start.current.clone_from(&self.world.environment.current);
    }

    /// True if `Simulation::restart` of the crate `fenderline-sim` keeps most of a simulation of this set-up, and
    /// cannot fail. The result is false if more than the states depends on the start: piles, hulls with outlines at
    /// several heights, lines that must fit between their ends, planned changes, and the study of a berthing.
    /// `Simulation::restart` then builds the simulation anew.
    #[must_use]
    pub fn restarts_in_place(&self) -> bool {
        let is_plain = |body: &BodySetup| body.dolphin.is_none() && body.hull.is_none();
        self.bodies.iter().all(is_plain)
            && self.world.lines.is_empty()
            && self.world.planned.is_empty()
            && self.berthing.is_none()
    }

    /// Replaces the initial states, the wind and the current of this set-up.
    ///
    /// # Panics
    /// Panics if the number of initial states is not the number of bodies.
    pub fn set_start(&mut self, start: &Start) {
        assert_eq!(start.bodies.len(), self.bodies.len(), "one start per body");
        for (body, start) in self.bodies.iter_mut().zip(&start.bodies) {
            let &BodyStart { position_m, heading_rad, velocity } = start;
            (body.position_m, body.heading_rad, body.velocity) =
                (position_m, heading_rad, velocity);
        }
        let environment = &mut self.world.environment;
        environment.wind.clone_from(&start.wind);
        environment.current.clone_from(&start.current);
    }
}
