//! Where the pilot's ship goes if nothing is ordered: a copy of the simulation, run on.

use fenderline_sim::Simulation;

use crate::message::Told;
use crate::session::Session;

/// A simulation to be run on beside the session, on another thread if need be.
#[derive(Clone, Debug)]
pub struct Prediction {
    simulation: Simulation,
    tick: u64,
    vessel: usize,
    body: usize,
}

impl Session {
    /// A copy to look ahead with; `None` without a ship of the pilot's own.
    #[must_use]
    pub fn prediction(&self) -> Option<Prediction> {
        let vessel = self.cast().own?;
        let mut simulation = self.simulation().clone();
        // Nothing is ordered: neither by a hand nor by the scenario.
        simulation.retain_orders(|order| order.at_s < simulation_time(self));
        let body = simulation.setup().world.vessels[vessel].body;
        Some(Prediction { simulation, tick: self.tick(), vessel, body })
    }
}

/// What is due in the next step was ordered already.
fn simulation_time(session: &Session) -> f64 {
    let simulation = session.simulation();
    simulation.time_s() + simulation.setup().step_s
}

impl Prediction {
    /// Runs on for some seconds and tells a place each `every_s`, the present one first. Ends early where
    /// `go_on` says no, or the simulation cannot step.
    #[must_use]
    pub fn run(mut self, seconds: f64, every_s: f64, mut go_on: impl FnMut() -> bool) -> Told {
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
        Told::Prediction { tick: self.tick, vessel: self.vessel, path }
    }
}
