//! Finds the speeds of a vessel: over ground, through the water, of bow and stern.

use fenderline_contact::Rotation;
use fenderline_sim::Simulation;

use crate::pair::Pair;

/// The speeds of a vessel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speeds {
    /// Velocity of the vessel's centre of gravity over ground, north and east (m/s).
    pub velocity_mps: Pair,
    /// Velocity of midship over ground, ahead and to starboard (m/s).
    pub ground_mps: Pair,
    /// Course of midship over ground, from north (rad); the vessel's heading while she is at rest.
    pub course_rad: f64,
    /// Velocity of midship through the water, ahead and to starboard (m/s).
    pub water_mps: Pair,
    /// Speed of the vessel's foremost point over ground, to starboard (m/s).
    pub bow_mps: f64,
    /// Speed of the vessel's aftmost point over ground, to starboard (m/s).
    pub stern_mps: f64,
}

/// The present speeds of a vessel.
pub(crate) fn speeds(simulation: &Simulation, index: usize) -> Speeds {
    let setup = simulation.setup();
    let of = &setup.world.vessels[index];
    let (body, state) = (&setup.bodies[of.body], &simulation.states()[of.body]);
    let own = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
    let lateral_mps = |along_m: f64| own.y + along_m * state.yaw_rate_radps;
    let (aftmost, foremost) = body.outline.bounds();
    let water = of.velocity(state, &setup.world.environment, simulation.time_s());
    let ground_mps = [own.x, lateral_mps(-of.ship.particulars.centre_of_gravity_m)];
    Speeds {
        velocity_mps: [state.velocity_mps.x, state.velocity_mps.y],
        ground_mps,
        course_rad: state.heading_rad + libm::atan2(ground_mps[1], ground_mps[0]),
        water_mps: [water.surge_mps, water.sway_mps],
        bow_mps: lateral_mps(foremost.x),
        stern_mps: lateral_mps(aftmost.x),
    }
}
