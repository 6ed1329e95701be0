//! Totals of a passing ship over a run.

use fenderline_contact::{Pose, Vec2};
use fenderline_sim::Setup;
use fenderline_sim::passing::{Nearest, PassingSetup};

/// Records how near one passing ship came to the vessels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PassingTotals {
    /// The nearest vessel: its index, the clear distance (m) and the time (s).
    pub nearest: Option<(usize, Nearest)>,
    /// Speed of the passing ship at the moment of the smallest distance (m/s).
    pub speed_mps: f64,
}

impl PassingTotals {
    pub(super) fn add(&mut self, t_s: f64, ship: &PassingSetup, hulls: &[(Vec<Vec2>, Pose)]) {
        for (vessel, (outline_m, pose)) in hulls.iter().enumerate() {
            let most_m = self.nearest.map_or(f64::INFINITY, |(_, nearest)| nearest.distance_m);
            let Some(distance_m) = ship.nearer_than_m(most_m, t_s, outline_m, *pose) else {
                continue;
            };
            self.nearest = Some((vessel, Nearest { distance_m, t_s }));
            self.speed_mps = ship.track.pace.speed_mps(t_s);
        }
    }
}

/// The outlines of the vessels, about their centres of gravity.
pub(super) fn outlines(setup: &Setup) -> Vec<Vec<Vec2>> {
    let of = |body: usize| setup.bodies[body].outline.vertices().to_vec();
    match setup.world.flow.passing.is_empty() {
        true => Vec::new(),
        false => setup.world.vessels.iter().map(|vessel| of(vessel.body)).collect(),
    }
}
