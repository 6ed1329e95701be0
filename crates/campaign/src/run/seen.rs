//! Records where the bodies of a run went, for a plan view of many runs.

use fenderline_contact::Vec2;
use fenderline_sim::Simulation;

use super::runner::Runner;

/// Largest number of points of a path.
const POINTS: u64 = 150;

/// The parts of a run that a plan view shows.
#[derive(Clone, Debug, PartialEq)]
pub struct Seen {
    /// Outlines of the fixed bodies (m).
    pub fixed_m: Vec<Vec<Vec2>>,
    /// For each floating body the path of its centre of gravity (m).
    pub paths_m: Vec<Vec<Vec2>>,
    /// Outline of each floating body at the end of the run (m).
    pub ends_m: Vec<Vec<Vec2>>,
}

impl Runner<'_> {
    /// Makes a run again to record where its bodies go; `None` for a run that cannot be made.
    pub fn see(&mut self, run: u64) -> Option<Seen> {
        let simulation = self.started(run)?;
        let every = simulation.steps_total().div_ceil(POINTS).max(1);
        let floating: Vec<usize> = (0..simulation.states().len())
            .filter(|body| !simulation.setup().bodies[*body].is_fixed())
            .collect();
        let mut paths_m: Vec<Vec<Vec2>> = vec![Vec::new(); floating.len()];
        let add = |paths_m: &mut Vec<Vec<Vec2>>, simulation: &Simulation| {
            for (path_m, body) in paths_m.iter_mut().zip(&floating) {
                path_m.push(simulation.states()[*body].position_m);
            }
        };
        add(&mut paths_m, simulation);
        while !simulation.is_done() {
            simulation.step().ok()?;
            if simulation.steps_taken().is_multiple_of(every) {
                add(&mut paths_m, simulation);
            }
        }
        add(&mut paths_m, simulation);
        let setup = simulation.setup();
        let outline_m = |body: usize| {
            let pose = simulation.states()[body].pose();
            setup.bodies[body].outline.vertices().iter().map(|vertex| pose.apply(*vertex)).collect()
        };
        let is_shore = |body: &usize| setup.bodies[*body].outline.is_of_parts();
        let fixed =
            (0..setup.bodies.len()).filter(|body| !floating.contains(body) && !is_shore(body));
        Some(Seen {
            fixed_m: fixed.map(outline_m).collect(),
            ends_m: floating.iter().map(|body| outline_m(*body)).collect(),
            paths_m,
        })
    }
}
