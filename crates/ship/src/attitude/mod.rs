//! Heave, roll and pitch of a ship.
//!
//! Each of heave, roll and pitch is a damped oscillator with mass or inertia (added mass included), linear damping and
//! hydrostatic restoring. Roll and pitch are driven by the moments of all horizontal forces about the centre of
//! gravity, each with the height at which the force acts. The horizontal motion depends on heave, roll and pitch only
//! at fenders that meet a hull with outlines by height (`HullByHeight` of the crate `fenderline-world`). First-order
//! wave motion is added to heave, roll and pitch, and does not pass through the oscillators. The oscillators are a
//! low-frequency model with constant added mass: they have no memory terms as in Cummins' equation, and no coupling of
//! heave and pitch.

use fenderline_contact::Vec2;

mod oscillator;
mod particulars;

pub use oscillator::{Motion, Oscillator};
pub use particulars::{AttitudeError, HydrostaticParticulars, Hydrostatics, oscillator_estimates};

/// Heave, roll and pitch of one ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attitude {
    /// Heave from the ship's level at rest, positive down (m, m/s).
    pub heave: Motion,
    /// Roll of the ship and its rate, positive to starboard (rad, rad/s).
    pub roll: Motion,
    /// Pitch of the ship and its rate, positive bow up (rad, rad/s).
    pub pitch: Motion,
}

/// Force and moments that drive heave, roll and pitch: means over a step, in the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AttitudeLoad {
    /// Vertical force on the ship beyond weight and buoyancy, positive down (N).
    pub heave_n: f64,
    /// Moment on the ship about her longitudinal axis, positive to starboard (N·m).
    pub roll_nm: f64,
    /// Moment on the ship about her transverse axis, positive bow up (N·m).
    pub pitch_nm: f64,
}

impl AttitudeLoad {
    /// Adds a horizontal force in the body's axes that acts `above_m` above the centre of gravity. Above the centre of
    /// gravity, a force to starboard heels the ship to starboard, and a force forward trims her by the bow.
    pub fn add(&mut self, forward_n: f64, starboard_n: f64, above_m: f64) {
        self.roll_nm += starboard_n * above_m;
        self.pitch_nm -= forward_n * above_m;
    }

    /// Adds a vertical force, positive up (N), at a place forward and to starboard of the centre of gravity (m).
    pub fn add_upward(&mut self, up_n: f64, at_m: Vec2) {
        self.heave_n -= up_n;
        self.roll_nm -= up_n * at_m.y;
        self.pitch_nm += up_n * at_m.x;
    }
}

impl Attitude {
    /// The ship's heave, roll and pitch after `step_s` seconds under a constant load. The solution of the oscillators
    /// is exact for any length of step.
    #[must_use]
    pub fn after(&self, hydrostatics: &Hydrostatics, load: &AttitudeLoad, step_s: f64) -> Attitude {
        Attitude {
            heave: hydrostatics.heave.after(self.heave, load.heave_n, step_s),
            roll: hydrostatics.roll.after(self.roll, load.roll_nm, step_s),
            pitch: hydrostatics.pitch.after(self.pitch, load.pitch_nm, step_s),
        }
    }

    /// Sinkage of a point of the hull from its position at rest (m), for small angles. The point of the hull is
    /// `forward_m` forward and `starboard_m` to starboard of the centre of gravity.
    #[must_use]
    pub fn sinkage_m(&self, forward_m: f64, starboard_m: f64) -> f64 {
        self.heave.value - forward_m * self.pitch.value + starboard_m * self.roll.value
    }
}
