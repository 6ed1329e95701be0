//! Current on a grid in space and time.

use fenderline_contact::{Vec2, vec2};

use super::check_velocity;
use crate::environment::error::EnvironmentError;
use crate::environment::table::{check_axis, is_off, place};

/// Velocities of the current at the nodes of a grid, at one or more times. The velocity between the nodes is
/// interpolated, bilinearly in space and linearly in time. Outside the grid and its times, the velocity at the edge of
/// the grid is used.
#[derive(Clone, Debug, PartialEq)]
pub struct CurrentGrid {
    times_s: Vec<f64>,
    north_m: Vec<f64>,
    east_m: Vec<f64>,
    /// Velocities at the nodes of the grid: the index of east varies fastest, then north, then time.
    velocities_mps: Vec<Vec2>,
}

impl CurrentGrid {
    /// The velocity on the grid with the largest magnitude (m/s).
    pub(super) fn fastest(&self) -> Vec2 {
        let all = self.velocities_mps.iter().copied();
        all.fold(Vec2::ZERO, |most, one| if one.length() > most.length() { one } else { most })
    }

    /// Makes a grid from its three axes and the velocities at the nodes. In the list of velocities the index of east
    /// varies fastest, then north, then time.
    ///
    /// # Errors
    /// Fails if an axis is empty or does not increase, if the number of velocities is not the product of the lengths of
    /// the three axes, or if a current is above 15 m/s.
    pub fn new(
        times_s: Vec<f64>,
        north_m: Vec<f64>,
        east_m: Vec<f64>,
        velocities_mps: Vec<Vec2>,
    ) -> Result<CurrentGrid, EnvironmentError> {
        check_axis("times of the current [s]", times_s.iter().copied(), 1)?;
        check_axis("northings of the current [m]", north_m.iter().copied(), 1)?;
        check_axis("eastings of the current [m]", east_m.iter().copied(), 1)?;
        let expected = times_s.len() * north_m.len() * east_m.len();
        if velocities_mps.len() != expected {
            let found = velocities_mps.len();
            return Err(EnvironmentError::Length { table: "the current's grid", expected, found });
        }
        velocities_mps.iter().try_for_each(|velocity| check_velocity(*velocity))?;
        Ok(CurrentGrid { times_s, north_m, east_m, velocities_mps })
    }

    /// Velocity of the current at a position and a time (m/s).
    #[must_use]
    pub fn at(&self, position_m: Vec2, t_s: f64) -> Vec2 {
        let time = place(self.times_s.len(), |i| self.times_s[i], t_s);
        let north = place(self.north_m.len(), |i| self.north_m[i], position_m.x);
        let east = place(self.east_m.len(), |i| self.east_m[i], position_m.y);
        let value = |t: usize, n: usize, e: usize| {
            self.velocities_mps[(t * self.north_m.len() + n) * self.east_m.len() + e]
        };
        let on_line = |t, n| mix(value(t, n, east.low), value(t, n, east.high), east.share);
        let on_plane = |t| mix(on_line(t, north.low), on_line(t, north.high), north.share);
        mix(on_plane(time.low), on_plane(time.high), time.share)
    }

    /// Whether a position or a time (s) is off the grid, so that [`CurrentGrid::at`] returns the velocity at the edge.
    /// If the grid has a single time, northing or easting, the velocity counts as constant along that axis.
    #[must_use]
    pub fn is_held(&self, position_m: Vec2, t_s: f64) -> bool {
        is_off(self.times_s.len(), |i| self.times_s[i], t_s)
            || is_off(self.north_m.len(), |i| self.north_m[i], position_m.x)
            || is_off(self.east_m.len(), |i| self.east_m[i], position_m.y)
    }
}

fn mix(low: Vec2, high: Vec2, share: f64) -> Vec2 {
    vec2(low.x + share * (high.x - low.x), low.y + share * (high.y - low.y))
}
