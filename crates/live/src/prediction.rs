//! Prediction of the own ship's path without further orders, by a copy of the simulation.

use fenderline_sim::Simulation;

use crate::message::Reply;
use crate::session::Session;

/// A copy of the simulation that can be run ahead, also on another thread.
#[derive(Clone, Debug)]
pub struct Prediction {
    simulation: Simulation,
    tick: u64,
    vessel: usize,
    body: usize,
}

impl Session {
    /// A prediction from the present state; `None` without an own ship.
    #[must_use]
    pub fn prediction(&self) -> Option<Prediction> {
        let vessel = self.cast().own?;
        let mut simulation = self.simulation().clone();
        // Without later orders of the scenario. Those that are due in the next step were given already.
        let end_s = simulation.time_s() + simulation.setup().step_s;
        simulation.retain_orders(|order| order.at_s < end_s);
        let body = simulation.setup().world.vessels[vessel].body;
        Some(Prediction { simulation, tick: self.tick(), vessel, body })
    }
}

impl Prediction {
    /// Runs for a number of seconds and returns a position every `every_s`, the present one first. Ends early if `go_on`
    /// returns false or a step fails.
    #[must_use]
    pub fn run(mut self, seconds: f64, every_s: f64, mut go_on: impl FnMut() -> bool) -> Reply {
        let step_s = self.simulation.setup().step_s;
        let steps = libm::round(seconds / step_s) as u64;
        let every = (libm::round(every_s / step_s) as u64).max(1);
        let mut path = Vec::new();
        for step in 0..=steps {
            if step.is_multiple_of(every) {
                let state = &self.simulation.states()[self.body];
                let t_s = self.simulation.time_s();
                path.push([t_s, state.position_m.x, state.position_m.y, state.heading_rad]);
                if !go_on() {
                    break;
                }
            }
            if step < steps && self.simulation.step().is_err() {
                break;
            }
        }
        Reply::Prediction { tick: self.tick, vessel: self.vessel, path }
    }
}
