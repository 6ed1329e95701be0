//! Tells how a ship lies relative to her berth, and how far she is from lying alongside.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Rotation, Vec2};
use fenderline_scenario::Scenario;

/// Size of the basin of the docking environment (m): along the quay, and off the quay.
const BASIN_ALONG_M: f64 = 400.0;
const BASIN_OFF_M: f64 = 200.0;

/// The berth of a scenario: the quay runs north along its fenders' faces, the ship lies west of the quay, and the berth
/// is at north 0.
pub(super) struct Berth {
    /// Index of the ship's body.
    pub(super) ship: usize,
    /// Points of the ship's starboard side in her own axes (m).
    side_m: Vec<Vec2>,
    half_length_m: f64,
    /// East coordinate of the fenders' faces (m).
    faces_east_m: f64,
    /// Distance along the quay from the berth at which the ship is still alongside (m).
    berthed_within_m: f64,
}

/// How a ship lies relative to a berth.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lie {
    /// The ship's heading relative to the quay, from −π to π (rad).
    pub(super) heading_rad: f64,
    /// Least clearance between the ship's side and the line of the fenders' faces (m).
    pub(super) off_m: f64,
    /// Distance of the ship from the berth (m); a deviation of her heading counts with half her length.
    pub(super) far_m: f64,
}

impl Berth {
    /// The berth of a scenario with one vessel, whose fenders all stand on one quay; `None` for another scenario.
    pub(super) fn of(scenario: &Scenario, berthed_within_m: f64) -> Option<Berth> {
        let setup = &scenario.setup;
        let [vessel] = setup.world.vessels.as_slice() else { return None };
        let first = setup.fenders.first()?;
        let quay = &setup.bodies[first.body];
        let outline = setup.bodies[vessel.body].outline.vertices();
        Some(Berth {
            ship: vessel.body,
            side_m: outline.iter().copied().filter(|point| point.y >= 0.0).collect(),
            half_length_m: 0.5 * vessel.ship.particulars.length_m,
            faces_east_m: quay.position_m.y + first.position_m.y - first.projection_m,
            berthed_within_m,
        })
    }

    /// How the ship lies relative to the berth, if she is in the state `state`.
    pub(super) fn lie(&self, state: &BodyState) -> Lie {
        let turned = Rotation::from_angle(state.heading_rad);
        let east_m = |point: &Vec2| turned.apply(*point).y;
        let reach_m = self.side_m.iter().map(east_m).fold(f64::NEG_INFINITY, greater);
        let off_m = self.faces_east_m - state.position_m.y - reach_m;
        let pi = core::f64::consts::PI;
        let heading_rad = (state.heading_rad + pi).rem_euclid(2.0 * pi) - pi;
        let (along_m, turn_m) = (state.position_m.x, self.half_length_m * heading_rad);
        let clear_m = greater(off_m, 0.0);
        let far_m = (along_m * along_m + clear_m * clear_m + turn_m * turn_m).sqrt();
        Lie { heading_rad, off_m, far_m }
    }

    /// Whether the ship lies alongside the berth, parallel and at rest.
    pub(super) fn is_alongside(&self, state: &BodyState, lie: &Lie) -> bool {
        state.position_m.x.abs() < self.berthed_within_m
            && lie.off_m < 0.2
            && state.heading_rad.abs() < 1.0_f64.to_radians()
            && state.velocity_mps.length() < 0.05
            && state.yaw_rate_radps.abs() < 5e-4
    }
}

impl Lie {
    /// Whether the ship has reached the line of the quay, beside the fenders or beyond them. The fenders' faces are 1.8
    /// m in front of the quay: a ship within 0.2 m of the quay's line counts as touching the quay.
    pub(super) fn is_over_quay_line(&self) -> bool {
        self.off_m < -1.6
    }

    /// Whether the ship has left the basin of the docking environment.
    pub(super) fn is_out_of_basin(&self, state: &BodyState) -> bool {
        state.position_m.x.abs() > BASIN_ALONG_M || self.off_m > BASIN_OFF_M
    }
}
