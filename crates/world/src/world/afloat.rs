//! Heave, roll and pitch of vessels with hydrodynamic data, and the points at which forces act on these vessels.

use fenderline_contact::{Vec2, vec2};
use fenderline_ship::attitude::Attitude;

use super::vessel::{HullMotion, VesselSetup, VesselState};

/// How a body with hydrodynamic data is afloat: the motion of the body, and the height of the centre of gravity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Afloat {
    pub(super) motion: HullMotion,
    pub(super) gravity_above_water_m: f64,
}

impl Afloat {
    /// Heave, roll and pitch of a vessel with hydrodynamic data; `None` for other vessels, because their heave, roll
    /// and pitch do not move the ends of lines.
    pub(super) fn of(vessel: &VesselSetup, state: &VesselState) -> Option<Afloat> {
        vessel.seakeeping.as_ref()?;
        let Attitude { heave, roll, pitch } = state.attitude;
        Some(Afloat {
            motion: HullMotion {
                heave_m: heave.value,
                roll_rad: roll.value,
                pitch_rad: pitch.value,
            },
            gravity_above_water_m: vessel.float?.gravity_above_water_m,
        })
    }

    /// Where a point of the ship is: its position in the ship's axes (m), and its height above the water (m).
    pub fn place(&self, at_m: Vec2, above_water_m: f64) -> (Vec2, f64) {
        (self.lever(at_m, above_water_m).at_m, above_water_m - self.motion.sinkage_m(at_m))
    }

    /// The lever of a point of the ship about the ship's centre of gravity. Heel and trim turn the point with the ship.
    pub fn lever(&self, at_m: Vec2, above_water_m: f64) -> Lever {
        let HullMotion { roll_rad, pitch_rad, .. } = self.motion;
        let upright_m = above_water_m - self.gravity_above_water_m;
        Lever {
            at_m: at_m + self.lean() * upright_m,
            above_gravity_m: upright_m + at_m.x * pitch_rad - at_m.y * roll_rad,
        }
    }

    /// How far heel and trim move a point of the ship for each metre above the centre of gravity (m/m).
    pub(super) fn lean(&self) -> Vec2 {
        vec2(-self.motion.pitch_rad, self.motion.roll_rad)
    }

    /// How far a point of the ship is below its place at rest (m).
    pub(super) fn sinkage_m(&self, at_m: Vec2) -> f64 {
        self.motion.sinkage_m(at_m)
    }

    /// How far the centre of gravity is below its place at rest (m).
    pub(super) fn heave_m(&self) -> f64 {
        self.motion.heave_m
    }
}

/// Where a force acts on a ship with her present heel and trim.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Lever {
    /// Distances of the point forward and to starboard of the centre of gravity (m).
    pub at_m: Vec2,
    /// Height of the point above the centre of gravity (m).
    pub above_gravity_m: f64,
}
