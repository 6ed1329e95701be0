//! Heights above the water on fixed and floating bodies.

use fenderline_contact::Vec2;

use super::afloat::{Afloat, Lever};
use crate::fender::FenderSetup;

/// The fixed bodies, the water level and the attitude of floating bodies.
#[derive(Clone, Copy, Debug)]
pub struct Shore<'a> {
    /// For each body of the set-up, true if the body is fixed.
    pub fixed: &'a [bool],
    /// Level of the water above datum (m).
    pub level_m: f64,
    /// For each body, the attitude of the body afloat; `None` for a body whose heave, roll and pitch do not move the
    /// ends of lines. The list may be empty.
    pub afloat: &'a [Option<Afloat>],
}

impl Shore<'_> {
    /// Height above the water (m) of a point on a body. On a fixed body, `height_m` is above datum; on a floating body,
    /// `height_m` is above the water.
    pub fn above_water_m(&self, body: usize, height_m: f64) -> f64 {
        if self.fixed[body] { height_m - self.level_m } else { height_m }
    }

    /// Place of a point of a body in the body's frame (m), and height of the point above the water (m).
    pub fn place(&self, body: usize, at_m: Vec2, height_m: f64) -> (Vec2, f64) {
        match self.afloat.get(body).copied().flatten() {
            Some(afloat) => afloat.place(at_m, height_m),
            None => (at_m, self.above_water_m(body, height_m)),
        }
    }

    /// The lever of a point of a body about the centre of gravity. On a body without heave, roll and pitch, the lever
    /// is the place of the point.
    pub fn lever(&self, body: usize, at_m: Vec2, height_m: f64) -> Lever {
        match self.afloat.get(body).copied().flatten() {
            Some(afloat) => afloat.lever(at_m, height_m),
            None => Lever { at_m, above_gravity_m: 0.0 },
        }
    }

    /// Height above the water (m) at which a fender presses that heaves, rolls and pitches with its body. `at_m` is the
    /// place of the contact in the frame of the body that carries the fender (m).
    pub fn fender_at_work_m(&self, fender: &FenderSetup, at_m: Vec2) -> f64 {
        let upright_m = self.fender_above_water_m(fender);
        let afloat =
            if fender.floating { None } else { self.afloat.get(fender.body).copied().flatten() };
        upright_m - afloat.map_or(0.0, |afloat| afloat.sinkage_m(at_m))
    }

    /// Height of the middle of a fender's face above the water (m), if the body is upright.
    pub fn fender_above_water_m(&self, fender: &FenderSetup) -> f64 {
        if fender.floating {
            return fender.above_water_m;
        }
        self.above_water_m(fender.body, fender.above_water_m)
    }
}
