//! Fenders that a ship carries lean with her: roll and pitch move their places in the plane.

use fenderline_contact::number::{bounded, greater};
use fenderline_contact::{BodyState, FenderId, Memory, Model, RenewalBuffers, Vec2, vec2};

use super::cut::ANGLE_RAD;
use super::heights::{HeightWork, Heights};
use crate::setup::{Method, Setup};
use crate::world::VesselSetup;

/// The largest roll or pitch by which fenders lean (rad): about 40 degrees. Beyond this angle, formulas for small
/// angles are far off.
const MAX_ANGLE_RAD: f64 = 0.7;

/// A fender that a vessel with hydrodynamic data carries. Roll and pitch of other vessels do not act on contacts.
#[derive(Clone, Debug)]
pub(super) struct Leaning {
    fender: usize,
    /// The vessel, as an index into the set-up's vessels.
    vessel: usize,
    /// Height of the fender above the vessel's centre of gravity (m).
    above_gravity_m: f64,
    /// How far the fender has leaned, in the vessel's frame (m).
    lean_m: Vec2,
}

impl Leaning {
    /// The leaning fenders of a run. In the method of Moreno et al. (2023), [`Method::Paper`], fenders stay upright.
    pub(super) fn all(setup: &Setup) -> Vec<Leaning> {
        if setup.method == Method::Paper {
            return Vec::new();
        }
        let mut all = Vec::new();
        for (fender, carried) in setup.fenders.iter().enumerate() {
            let carries = |vessel: &VesselSetup| vessel.body == carried.body;
            let Some(vessel) = setup.world.vessels.iter().position(carries) else { continue };
            let VesselSetup { float: Some(float), seakeeping: Some(_), .. } =
                &setup.world.vessels[vessel]
            else {
                continue;
            };
            let above_gravity_m = carried.above_water_m - float.gravity_above_water_m;
            if above_gravity_m != 0.0 {
                all.push(Leaning { fender, vessel, above_gravity_m, lean_m: Vec2::ZERO });
            }
        }
        all
    }

    /// Moves the fender to its place for the step that begins at `states`. If the fender moves, returns how far it
    /// leaned before (m).
    pub(super) fn renew(
        &mut self,
        setup: &Setup,
        (model, memory, buffers): (&mut Model, &mut Memory, &mut RenewalBuffers),
        states: &[BodyState],
        heights: &Heights<'_>,
        works: &mut Vec<HeightWork>,
    ) -> Option<Vec2> {
        let motion = heights.motion(Some(self.vessel));
        let whole = |angle_rad: f64| {
            let rounded_rad = libm::rint(angle_rad / ANGLE_RAD) * ANGLE_RAD;
            bounded(rounded_rad, -MAX_ANGLE_RAD, MAX_ANGLE_RAD)
        };
        let lean = vec2(-whole(motion.pitch_rad), whole(motion.roll_rad));
        let lean_m = lean * self.above_gravity_m;
        if lean_m == self.lean_m {
            return None;
        }
        let body = setup.fenders[self.fender].body;
        let moved = (self.id(), lean_m);
        for (other, work_j) in model.lean_fender(memory, states, moved, buffers) {
            if work_j != 0.0 {
                let other = other.0 as usize;
                let bodies = [body.min(other), body.max(other)];
                works.push(HeightWork { bodies, fender: self.fender, work_j });
            }
        }
        Some(core::mem::replace(&mut self.lean_m, lean_m))
    }

    /// Moves the fender back to where it was before a step that failed.
    pub(super) fn restore(&mut self, model: &mut Model, lean_m: Vec2) {
        model.set_lean(self.id(), lean_m);
        self.lean_m = lean_m;
    }

    fn id(&self) -> FenderId {
        FenderId(self.fender as u32)
    }
}

/// The bodies whose fenders lean, and by how much at most (m).
pub fn leaning_bodies(setup: &Setup) -> Vec<(usize, f64)> {
    let mut bodies: Vec<(usize, f64)> = Vec::new();
    for leaning in Leaning::all(setup) {
        let body = setup.fenders[leaning.fender].body;
        // Roll and pitch together.
        let lean_m = core::f64::consts::SQRT_2 * MAX_ANGLE_RAD * leaning.above_gravity_m.abs();
        match bodies.iter_mut().find(|(known, _)| *known == body) {
            Some((_, most_m)) => *most_m = greater(*most_m, lean_m),
            None => bodies.push((body, lean_m)),
        }
    }
    bodies
}
