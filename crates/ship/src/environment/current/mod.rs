//! Current of the water: uniform, varying with depth, or on a grid in space and time.
//!
//! Velocities of the current are the velocities of the water, north and east (m/s). The forces on a ship depend on her
//! velocity relative to [`Current::velocity`].

mod grid;
mod profile;

use fenderline_contact::Vec2;

use super::error::EnvironmentError;
use crate::range::{OutOfRange, within};
pub use grid::CurrentGrid;
pub use profile::CurrentProfile;

/// A current.
#[derive(Clone, Debug, PartialEq)]
pub enum Current {
    /// The current is uniform and steady, with the given velocity (m/s).
    Uniform(Vec2),
    /// The current is uniform in the horizontal and varies with depth.
    Layered(CurrentProfile),
    /// The current varies with position and time, and is uniform over depth.
    Grid(CurrentGrid),
}

impl Current {
    /// The fastest current that is accepted, to the north and to the east (m/s). The strongest tidal stream has about
    /// 11 m/s (Saltstraumen; from memory).
    pub const FASTEST_MPS: f64 = 15.0;

    /// The largest components of this current's velocity at the surface, over all places and times, north and east
    /// (m/s).
    #[must_use]
    pub fn fastest(&self) -> Vec2 {
        match self {
            Current::Grid(grid) => grid.fastest(),
            Current::Uniform(_) | Current::Layered(_) => self.velocity(Vec2::ZERO, 0.0, 0.0),
        }
    }

    /// A uniform current.
    ///
    /// # Errors
    /// A current above [`Current::FASTEST_MPS`].
    pub fn uniform(velocity_mps: Vec2) -> Result<Current, EnvironmentError> {
        check_velocity(velocity_mps)?;
        Ok(Current::Uniform(velocity_mps))
    }

    /// Velocity of the current on a hull of a given draught, at a position and a time (m/s). If the current varies with
    /// depth, its velocity on the hull is the mean over the draught.
    #[must_use]
    pub fn velocity(&self, position_m: Vec2, t_s: f64, draught_m: f64) -> Vec2 {
        match self {
            Current::Uniform(velocity_mps) => *velocity_mps,
            Current::Layered(profile) => profile.mean_over(draught_m),
            Current::Grid(grid) => grid.at(position_m, t_s),
        }
    }
}

pub(super) fn check_velocity(velocity_mps: Vec2) -> Result<(), OutOfRange> {
    const MOST: f64 = Current::FASTEST_MPS;
    within("current to the north [m/s]", velocity_mps.x, -MOST, MOST)?;
    within("current to the east [m/s]", velocity_mps.y, -MOST, MOST)?;
    Ok(())
}
