//! Fenders: faces on a body, each with a reaction law.

use alloc::string::String;
use alloc::vec::Vec;

use crate::error::ModelError;
use crate::geometry::convex::ConvexPolygon;
use crate::maths::number::greater;
use crate::maths::vec2::{Pose, Rotation, Vec2, vec2};
use crate::model::material::{BodyId, FenderId, Material, MaterialId};
use crate::model::reaction::{FenderLaw, Stop, check_curve, check_points, held};
use crate::model::unloading::Unloading;
use crate::panel::Panel;
use crate::panel::chains::{ChainState, chain_state};
use crate::panel::law::PanelLaw;
use crate::panel::touching::Reach;
use crate::touch::face_frame::Frame;

/// A fender on a quay, on a tug's bow or along a ship's belting.
///
/// A fender touches the outlines of all bodies that form a [`crate::Pair`] with the fender's body. The material of the
/// pair describes the solid structure behind the fender. The fender's own material gives friction, restitution and
/// damping.
///
/// The force of a fender is the gradient of the stored energy (see [`FenderLaw`]). Because the force of a fender is
/// such a gradient, a closed path of the hull without friction does no work. Where a corner of a hull presses on the
/// face, the force points along the axis of the face. Where a flat side of a hull covers the whole face, the force is
/// perpendicular to the hull. With an [`Unloading`] law the force is the gradient of the energy that the fender can
/// return, and a closed path of the hull dissipates what the law says.
#[derive(Clone, Debug, PartialEq)]
pub struct Fender {
    /// Name, used in errors.
    pub name: String,
    /// Key of the fender, unique on its body. Sums over the fenders of a body run in the order of the keys.
    pub key: u64,
    /// The body on which the fender is mounted.
    pub body: BodyId,
    /// Middle of the fender's mounting line, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction in which the fender faces, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of the fender's face (m).
    pub width_m: f64,
    /// Distance from the fender's mounting to its face, when not compressed (m).
    pub projection_m: f64,
    /// Reaction force of the fender as a function of its deflection.
    pub law: FenderLaw,
    /// How the reaction of the fender falls when the hull moves away. The coupled method uses this unloading law in
    /// place of the material's restitution. `None`: restitution alone.
    pub unloading: Option<Unloading>,
    /// Material of the fender, which gives friction, restitution, damping and, for [`FenderLaw::Area`], stiffness.
    pub material: MaterialId,
    /// Rated deflection (m). A larger deflection of the fender is reported as
    /// [`crate::EventKind::FenderRatingExceeded`]. The compression times of [`ReactionFactors`] are times to reach this
    /// rated deflection.
    pub rated_deflection_m: f64,
    /// The stop at the end of the fender's travel; `None` if the reaction curve includes the stop.
    pub stop: Option<Stop>,
    /// Factors that correct the fender's reaction.
    pub factors: ReactionFactors,
    /// A panel in front of several fenders side by side. `None` for a single fender, or for several fenders that are
    /// treated as one behind a face that does not turn.
    pub panel: Option<Panel>,
}

/// Factors that correct a fender's reaction. The factors are multiplied. The factors by speed and angle are evaluated
/// when a contact begins and kept until it ends: a berthing has one speed and one angle, and a factor that changed
/// under load would create or destroy stored energy.
#[derive(Clone, Debug, PartialEq)]
pub struct ReactionFactors {
    /// The factor for temperature, manufacturing tolerance and all other influences that are constant in a run.
    pub constant: f64,
    /// Points of the factor by speed, each with compression time (s) and factor, in order of time. The factor is linear
    /// between the points and constant beyond both ends. The compression time is δ_rated/(0.74 V) at the approach speed
    /// V. An empty list of points means a factor of 1.
    pub by_compression_time: Vec<[f64; 2]>,
    /// Points of the factor by angle, each with the angle between face and hull (rad) and the factor, in order of
    /// angle; used like the points by compression time.
    pub by_angle: Vec<[f64; 2]>,
}

impl Default for ReactionFactors {
    fn default() -> ReactionFactors {
        ReactionFactors { constant: 1.0, by_compression_time: Vec::new(), by_angle: Vec::new() }
    }
}

impl ReactionFactors {
    /// The factor of the reaction that depends on the angle (rad) alone.
    #[must_use]
    pub fn of_angle(&self, angle_rad: f64) -> f64 {
        held(&self.by_angle, angle_rad)
    }

    /// The compression time of a contact (s): the time to reach the rated deflection (m) at 0.74 of the speed at the
    /// first touch (m/s). The tables of factors by speed use this compression time instead of the speed. The number
    /// 0.74 is from a public calculator for cone fenders.
    #[must_use]
    pub fn compression_time_s(speed_mps: f64, rated_deflection_m: f64) -> f64 {
        rated_deflection_m / (0.74 * greater(speed_mps, 1e-9))
    }

    /// The product of all factors for a contact that begins at this speed (m/s) and angle (rad).
    pub(crate) fn at(&self, speed_mps: f64, angle_rad: f64, rated_deflection_m: f64) -> f64 {
        let time_s = ReactionFactors::compression_time_s(speed_mps, rated_deflection_m);
        self.constant * held(&self.by_compression_time, time_s) * self.of_angle(angle_rad)
    }

    fn largest(&self) -> f64 {
        let of = |points: &[[f64; 2]]| match points {
            [] => 1.0,
            points => points.iter().map(|p| p[1]).fold(0.0, greater),
        };
        self.constant * of(&self.by_compression_time) * of(&self.by_angle)
    }
}

/// The data of a fender that the stages of a step use.
#[derive(Clone, Debug)]
pub(crate) struct RankedFender {
    pub(crate) id: FenderId,
    /// Rank of the body that carries the fender.
    pub(crate) host: u32,
    pub(crate) key: u64,
    pub(crate) material: MaterialId,
    /// The region in which a hull compresses the fender: from the face inwards, to a depth of twice the projection.
    pub(crate) zone: ConvexPolygon,
    /// Middle of the fender's face, and the direction from the face to the mounting, in the frame of the body that
    /// carries the fender.
    pub(crate) face_m: Vec2,
    pub(crate) inward: Vec2,
    pub(crate) width_m: f64,
    /// Upper bound on the product of the fender's factors.
    pub(crate) largest_factor: f64,
    pub(crate) bounds: FenderBounds,
    /// True if the fender has an unloading law.
    pub(crate) unloads: bool,
    /// The springs behind the fender's panel; `None` for a fender without a panel.
    pub(crate) panel: Option<PanelLaw>,
}

/// Bounds on the forces of a fender on any hull. In most steps these bounds show that the fender needs no sub-steps.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FenderBounds {
    /// The steepest slope of the fender's reaction curve with the largest factors, without the stop (N/m).
    pub(crate) spring_npm: f64,
    /// Deflection at which the fender's stop begins; infinite for a fender without a stop (m).
    pub(crate) stop_from_m: f64,
    /// Damping coefficient of the fender's damper (N·s/m).
    pub(crate) damping_nspm: f64,
    pub(crate) projection_m: f64,
    /// Distance from the body's centre of gravity to the middle of the fender's face, and from the middle of the face
    /// to the farthest corner of the fender's zone (m).
    pub(crate) arm_m: f64,
    pub(crate) spread_m: f64,
}

impl FenderBounds {
    fn of(fender: &Fender, material: &Material, zone: &[Vec2; 4], face_m: Vec2) -> FenderBounds {
        let steepest_npm = match fender.law {
            FenderLaw::Area => material.stiffness_npm2 * fender.width_m,
            FenderLaw::Curve(_) => fender.law.steepest_npm(f64::INFINITY),
        };
        FenderBounds {
            spring_npm: steepest_npm * fender.factors.largest(),
            stop_from_m: fender.stop.map_or(f64::INFINITY, |stop| stop.from_m),
            damping_nspm: material.damping_nspm2 * fender.width_m,
            projection_m: fender.projection_m,
            arm_m: face_m.length(),
            spread_m: zone.iter().fold(0.0, |spread, &v| greater(spread, (v - face_m).length())),
        }
    }
}

impl RankedFender {
    pub(crate) fn new(
        id: FenderId,
        host: u32,
        fender: &Fender,
        material: &Material,
    ) -> RankedFender {
        let inward = inward(fender);
        let (face_m, corners) = place(fender, inward, fender.position_m);
        RankedFender {
            id,
            host,
            key: fender.key,
            material: fender.material,
            zone: ConvexPolygon::new(&corners),
            face_m,
            inward,
            width_m: fender.width_m,
            largest_factor: fender.factors.largest(),
            bounds: FenderBounds::of(fender, material, &corners, face_m),
            unloads: fender.unloading.is_some(),
            panel: fender.panel.as_ref().and_then(|p| PanelLaw::of(p, &fender.law, fender.stop)),
        }
    }

    /// Moves the fender to another place on the body that carries the fender. Allocates nothing.
    pub(crate) fn move_to(&mut self, fender: &Fender, position_m: Vec2) {
        let (face_m, corners) = place(fender, self.inward, position_m);
        self.zone.move_to(&corners);
        self.face_m = face_m;
        self.bounds.arm_m = face_m.length();
    }

    /// Transforms from the frame of a hull to the face's frame: x inwards from the face's middle, y along the face. The
    /// poses of both bodies are in one frame.
    pub(crate) fn hull_to_face(&self, host: Pose, hull: Pose) -> impl Fn(Vec2) -> Vec2 + use<> {
        let frame = Frame::of(self.inward, self.face_m, host);
        move |v: Vec2| frame.to_face(hull.apply(v))
    }

    /// The state of the chains of the fender's panel: the chains that have parted, taken from the list `parted` of all
    /// parted chains, and the contact's factor on the reaction.
    pub(crate) fn chain_state(
        &self,
        number: u32,
        parted: &[u32],
        factor: Option<f64>,
    ) -> ChainState {
        match &self.panel {
            Some(law) if !law.chains.is_empty() => {
                chain_state(number, parted, factor.unwrap_or(1.0))
            }
            _ => ChainState::default(),
        }
    }

    /// The region, in the frame of the face, in which the fender's panel can meet a hull.
    pub(crate) fn panel_reach(&self) -> Reach {
        let far_m = 2.0 * self.bounds.projection_m;
        // A panel that is turned by 45 degrees reaches as far out as it is wide.
        let near_m = -(far_m + self.width_m);
        Reach { half_width_m: 0.5 * self.width_m, far_m, near_m }
    }

    /// Largest distance of a corner of the fender's zone from the body's centre of gravity (m).
    pub(crate) fn reach_m(&self) -> f64 {
        self.zone.vertices().iter().fold(0.0, |reach, v| greater(reach, v.length()))
    }
}

/// The direction from the face of a fender to the mounting, in the frame of the body that carries the fender.
fn inward(fender: &Fender) -> Vec2 {
    let Rotation { cos, sin } = Rotation::from_angle(fender.facing_rad);
    -vec2(cos, sin)
}

/// The middle of the face of a fender mounted at `position_m`, and the corners of the fender's zone (m).
fn place(fender: &Fender, inward: Vec2, position_m: Vec2) -> (Vec2, [Vec2; 4]) {
    let along = inward.quarter_turn();
    let face_m = position_m - inward * fender.projection_m;
    let half_m = along * (0.5 * fender.width_m);
    let behind_m = face_m + inward * (2.0 * fender.projection_m);
    (face_m, [face_m - half_m, behind_m - half_m, behind_m + half_m, face_m + half_m])
}

/// Checks the values that do not depend on the rest of the model.
pub(crate) fn check(fender: &Fender) -> Result<(), ModelError> {
    let bad = |field, value, must| {
        Err(ModelError::OutOfRange { owner: fender.name.clone(), field, value, must })
    };
    let size = |value: f64| (1e-6..=1e6).contains(&value);
    let place = |value: f64| value.abs() <= 1e8;
    for (field, value) in [
        ("width", fender.width_m),
        ("projection", fender.projection_m),
        ("rated deflection", fender.rated_deflection_m),
    ] {
        if !size(value) {
            return bad(field, value, "between 1e-6 and 1e6 m");
        }
    }
    for (field, value) in [
        ("position", fender.position_m.x),
        ("position", fender.position_m.y),
        ("facing", fender.facing_rad),
    ] {
        if !place(value) {
            return bad(field, value, "between -1e8 and 1e8");
        }
    }
    if let Some(stop) = fender.stop {
        if !size(stop.from_m) {
            return bad("stop", stop.from_m, "between 1e-6 and 1e6 m");
        }
        if !(0.0..=1e15).contains(&stop.stiffness_npm) {
            return bad("stiffness of the stop", stop.stiffness_npm, "between 0 and 1e15");
        }
    }
    if let FenderLaw::Curve(points) = &fender.law {
        check_curve(&fender.name, ["curve", "deflection of the curve"], points)?;
    }
    if let Some(panel) = &fender.panel {
        let Fender { name, width_m, law, unloading, .. } = fender;
        panel.check(name, *width_m, law, unloading.as_ref())?;
    }
    let factors = &fender.factors;
    if !(1e-3..=1e3).contains(&factors.constant) {
        return bad("factor", factors.constant, "between 1e-3 and 1e3");
    }
    fender.unloading.as_ref().map_or(Ok(()), |law| law.check(&fender.name, &fender.law))?;
    check_points(&fender.name, "compression time", &factors.by_compression_time, 1e-3..=1e3)?;
    check_points(&fender.name, "angle of a factor", &factors.by_angle, 1e-3..=1e3)
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn factors_are_read_at_the_compression_time_and_constant_beyond_their_ends() {
        let factors = ReactionFactors {
            constant: 1.1,
            by_compression_time: vec![[1.0, 1.2], [3.0, 1.0]],
            by_angle: vec![[0.0, 1.0], [0.2, 0.8]],
        };
        // The compression time is t = 0.74/(0.74·0.5) = 2 s.
        assert!((factors.at(0.5, 0.1, 0.74) - 1.1 * 1.1 * 0.9).abs() < 1e-12);
        assert!((factors.at(0.0, 9.0, 0.74) - 1.1 * 0.8).abs() < 1e-12);
    }
}
