//! Heave, roll and pitch: what a ship does out of the plane.
//!
//! The horizontal motion is the contact engine's; heave, roll and pitch are three oscillators beside it,
//! with mass and inertia (added mass included), damping and hydrostatic restoring, driven by the moments
//! of all horizontal forces about the centre of gravity at the height where they act. First-order wave
//! motion is superposed on them, not driven through them. That is a low-frequency model with constant
//! added mass and linear damping, not Cummins' equation with memory, and it leaves out the coupling of
//! heave and pitch.

mod oscillator;
mod particulars;

pub use oscillator::{Motion, Oscillator};
pub use particulars::{AttitudeError, HydrostaticParticulars, Hydrostatics, oscillator_estimates};

/// Heave, roll and pitch of one ship.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Attitude {
    /// Heave, positive down, from the level of rest (m, m/s).
    pub heave: Motion,
    /// Roll, positive to starboard (rad, rad/s).
    pub roll: Motion,
    /// Pitch, positive bow up (rad, rad/s).
    pub pitch: Motion,
}

/// What drives the three in one step: mean over the step, in the body's axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct AttitudeLoad {
    /// Vertical force beyond weight and buoyancy, positive down (N).
    pub heave_n: f64,
    /// Moment about the longitudinal axis, positive to starboard (N·m).
    pub roll_nm: f64,
    /// Moment about the transverse axis, positive bow up (N·m).
    pub pitch_nm: f64,
}

impl AttitudeLoad {
    /// Adds a horizontal force in the body's axes (forward, to starboard) that acts `above_m` above the
    /// centre of gravity: a push to starboard up there heels her to starboard, one forward trims her by
    /// the bow down.
    pub fn add(&mut self, forward_n: f64, starboard_n: f64, above_m: f64) {
        self.roll_nm += starboard_n * above_m;
        self.pitch_nm -= forward_n * above_m;
    }
}

impl Attitude {
    /// The attitude after `step_s` seconds of a constant drive: exact for any step.
    #[must_use]
    pub fn after(
        &self,
        hydrostatics: &Hydrostatics,
        drive: &AttitudeLoad,
        step_s: f64,
    ) -> Attitude {
        Attitude {
            heave: hydrostatics.heave.after(self.heave, drive.heave_n, step_s),
            roll: hydrostatics.roll.after(self.roll, drive.roll_nm, step_s),
            pitch: hydrostatics.pitch.after(self.pitch, drive.pitch_nm, step_s),
        }
    }

    /// How far below its place at rest a point of the hull is (m): `forward_m` ahead and `starboard_m` to
    /// starboard of the centre of gravity. For small angles.
    #[must_use]
    pub fn sinkage_m(&self, forward_m: f64, starboard_m: f64) -> f64 {
        self.heave.value - forward_m * self.pitch.value + starboard_m * self.roll.value
    }
}
