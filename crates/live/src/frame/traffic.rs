//! Traffic: ships that pass on tracks of their own. They touch nothing. A vessel that runs into a passing ship raises
//! an alarm.

use fenderline_sim::Simulation;

use crate::alarm_book::{Alarm, Level};
use crate::info::Info;

/// Position, heading, velocity and rate of turn of each passing ship, in the format of the bodies.
pub(super) fn now(simulation: &Simulation) -> Vec<[f64; 6]> {
    let passing = &simulation.setup().world.flow.passing;
    let at = passing.iter().map(|ship| ship.track.at(simulation.time_s()));
    at.map(|now| {
        let (position, velocity) = (now.pose.position_m, now.velocity_mps);
        [position.x, position.y, now.heading_rad, velocity.x, velocity.y, now.yaw_rate_radps]
    })
    .collect()
}

/// An alarm for each vessel whose outline overlaps that of a passing ship.
pub(super) fn collisions(simulation: &Simulation, info: &Info) -> Vec<Alarm> {
    let setup = simulation.setup();
    let mut all = Vec::new();
    for ship in &setup.world.flow.passing {
        for vessel in &info.vessels {
            let (body, state) = (&setup.bodies[vessel.body], &simulation.states()[vessel.body]);
            let outline_m = body.outline.vertices();
            if ship.meets(outline_m, state.pose(), simulation.time_s()) {
                all.push(Alarm {
                    level: Level::Alarm,
                    key: format!("collision {} {}", vessel.name, ship.name),
                    text: format!("{} collides with {}", vessel.name, ship.name),
                    about: vec![vessel.name.clone(), ship.name.clone()],
                });
            }
        }
    }
    all
}
