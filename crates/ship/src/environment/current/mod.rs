//! Current: uniform, by depth, or on a grid in space and time.
//!
//! Velocities are those of the water, north and east (m/s). The forces on a ship depend on her velocity relative to
//! [`Current::velocity`].

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
    /// Uniform and steady, with this velocity (m/s).
    Uniform(Vec2),
    /// Uniform in the horizontal, varying with depth.
    Layered(CurrentProfile),
    /// Varying with position and time, uniform over depth.
    Grid(CurrentGrid),
}

impl Current {
    /// The fastest current that is accepted, to the north and to the east (m/s). The strongest tidal stream is about 11 m/s
    /// (Saltstraumen; recalled).
    pub const FASTEST_MPS: f64 = 15.0;

    /// The fastest velocity of this current at the surface, over all places and times, north and east (m/s).
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

    /// Velocity of the current on a hull of a given draught, at a position and a time (m/s). A current that varies with
    /// depth is averaged over the draught.
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
