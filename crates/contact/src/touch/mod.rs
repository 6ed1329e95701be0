//! The kinematics of one patch of contact (§3.1 of the paper): normal, levers, velocities and shear, in earth-fixed
//! axes.

pub(crate) mod face;
pub(crate) mod face_frame;
pub(crate) mod levers;

use crate::geometry::clip::ClipBuffers;
use crate::maths::vec2::{Pose, Vec2};
use crate::model::Model;
use crate::model::fender::RankedFender;
use crate::model::material::BodyId;
use crate::overlap;
use crate::overlap::lenses::Overlap;
use crate::overlap::patch::Patch;
use crate::state::body_state::{BodyState, Velocity};
use crate::state::memory::PatchMemory;
use crate::state::report::{
    Contact, ContactImpulse, ContactWork, EnergyParts, ForceParts, Friction,
};
use crate::touch::levers::Levers;

/// One patch of contact in the form that the force laws use; body A is the body with the lower rank.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Touch {
    /// n in A's frame.
    pub(crate) normal_in_a: Vec2,
    /// Unit normal n of the contact: the outward normal of body A, earth-fixed.
    pub(crate) normal: Vec2,
    /// The point at which the contact force acts, in the frame of body A (m): the centroid C or, at a fender, a point
    /// on the line of the fender's force.
    pub(crate) point_in_a_m: Vec2,
    /// Levers of the contact force about each body's centre of gravity.
    pub(crate) levers_a: Levers,
    pub(crate) levers_b: Levers,
    /// δ (m).
    pub(crate) depth_m: f64,
    /// Force of the spring and force of the stop, not yet multiplied by the fender's factors (N).
    pub(crate) spring_n: f64,
    pub(crate) stop_n: f64,
    /// Energy stored in a fender, not yet multiplied by the fender's factors (J); 0 between two outlines, because their
    /// law has no potential.
    pub(crate) stored_j: f64,
    /// Growth of the overlap area S for each metre by which the bodies approach along the normal (m).
    pub(crate) chord_m: f64,
    /// Angle between a fender's face and the hull (rad).
    pub(crate) tilt_rad: f64,
    /// Normal speed V_n and tangential speed V_t (m/s) (eq. 10).
    pub(crate) v_normal_mps: f64,
    pub(crate) v_tangential_mps: f64,
    /// Deflection Δs of the shear spring before the friction law of this step (m).
    pub(crate) shear_m: f64,
}

/// The bodies of a contact that move: floating bodies, and fixed bodies with a velocity, such as lock gates.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Movers {
    /// Only body A moves: body B is fixed and at rest.
    A,
    /// Only body B moves: body A is fixed and at rest.
    B,
    /// Both bodies move, or it is not known which of the two bodies moves.
    #[default]
    Both,
}

impl Movers {
    /// Makes the value from whether body A moves and whether body B moves. At least one of the two bodies must move.
    #[inline(always)]
    pub(crate) fn of([a_moves, b_moves]: [bool; 2]) -> Movers {
        match (a_moves, b_moves) {
            (true, false) => Movers::A,
            (false, true) => Movers::B,
            _ => Movers::Both,
        }
    }

    /// Normal and tangential speed of two bodies (eq. 10) (m/s), computed from the normal n and from the levers of n
    /// and t about each centre of gravity. The function does not read the velocity of a body that is at rest.
    #[inline(always)]
    pub(crate) fn speeds(
        self,
        velocity_of_a: impl Fn() -> Velocity,
        velocity_of_b: impl Fn() -> Velocity,
        (n, levers_a, levers_b): (Vec2, Levers, Levers),
    ) -> (f64, f64) {
        let alone = |(velocity_mps, turn_radps): Velocity, levers: Levers| {
            (
                velocity_mps.dot(n) + turn_radps * levers.n_m,
                velocity_mps.dot(n.quarter_turn()) + turn_radps * levers.t_m,
            )
        };
        match self {
            Movers::A => alone(velocity_of_a(), levers_a),
            Movers::B => {
                let (normal_mps, tangential_mps) = alone(velocity_of_b(), levers_b);
                (-normal_mps, -tangential_mps)
            }
            Movers::Both => {
                let ((a_mps, turn_a), (b_mps, turn_b)) = (velocity_of_a(), velocity_of_b());
                let apart_mps = a_mps - b_mps;
                (
                    apart_mps.dot(n) + (turn_a * levers_a.n_m - turn_b * levers_b.n_m),
                    apart_mps.dot(n.quarter_turn())
                        + (turn_a * levers_a.t_m - turn_b * levers_b.t_m),
                )
            }
        }
    }
}

/// The data from which the contacts of a step or sub-step are computed. Lists are by rank.
#[derive(Clone, Copy)]
pub(crate) struct Scene<'w> {
    pub(crate) model: &'w Model,
    pub(crate) overlap: &'w Overlap,
    pub(crate) poses: &'w [Pose],
    /// States of the bodies at the start of the step or sub-step.
    pub(crate) states: &'w [BodyState],
}

/// Computes the kinematics of a patch of contact. `face` is the fender of the patch, if there is one, and `old` the old
/// memory of the patch.
#[inline(always)]
pub(crate) fn touch(
    scene: &Scene<'_>,
    clip: &mut ClipBuffers,
    patch: &Patch,
    face: Option<&RankedFender>,
    old: Option<&PatchMemory>,
    movers: Movers,
) -> Touch {
    let pressed = match face {
        None => press_outline(scene, clip, patch, old),
        Some(face) => press_fender(scene, clip, patch, face),
    };
    let Touch { normal_in_a, point_in_a_m, .. } = pressed;
    let normal = scene.poses[patch.candidate.a as usize].rotation.apply(normal_in_a);
    // Computed in A's frame, in which the arms are given.
    let levers_a = Levers::new(point_in_a_m, normal_in_a);
    let levers_b = Levers::new(point_in_a_m - patch.b_in_a.position_m, normal_in_a);
    let velocity_of = |rank: u32| scene.states[rank as usize].velocity();
    let (v_normal_mps, v_tangential_mps) = movers.speeds(
        || velocity_of(patch.candidate.a),
        || velocity_of(patch.candidate.b),
        (normal, levers_a, levers_b),
    );
    let shear_m = old.map_or(0.0, |m| {
        // How far the material points that were at C have moved apart (eq. 4). Computed in A's frame, so that no digits
        // are lost far from the origin.
        let apart = m.point_in_a_m - patch.b_in_a.apply(m.point_in_b_m);
        m.shear_m + apart.dot(normal_in_a.quarter_turn())
    });
    Touch { normal, levers_a, levers_b, v_normal_mps, v_tangential_mps, shear_m, ..pressed }
}

/// Computes [`touch`] again for the same patch, after a chain of its panel has parted. A second computation is rare;
/// this separate function keeps a second copy of `touch` out of its caller.
#[cold]
#[inline(never)]
pub(crate) fn touch_again(
    scene: &Scene<'_>,
    clip: &mut ClipBuffers,
    patch: &Patch,
    face: Option<&RankedFender>,
    old: Option<&PatchMemory>,
    movers: Movers,
) -> Touch {
    touch(scene, clip, patch, face, old, movers)
}

/// The force of outline against outline: kS along the normal of the chord, at the centroid (docs/contact_model.md,
/// sections 1 and 2).
#[inline(always)]
fn press_outline(
    scene: &Scene<'_>,
    clip: &mut ClipBuffers,
    patch: &Patch,
    old: Option<&PatchMemory>,
) -> Touch {
    let Scene { model, overlap, .. } = *scene;
    let material = &model.materials()[patch.candidate.material.0 as usize];
    let (normal_in_a, depth_m) = overlap::normal_in_a(model, overlap, clip, patch, old);
    Touch {
        normal_in_a,
        point_in_a_m: patch.centroid_m,
        depth_m,
        spring_n: material.stiffness_npm2 * patch.area_m2,
        ..Touch::default()
    }
}

/// The force of an outline against a fender, by the law of the fender.
#[inline(never)]
fn press_fender(
    scene: &Scene<'_>,
    clip: &mut ClipBuffers,
    patch: &Patch,
    face: &RankedFender,
) -> Touch {
    let press = overlap::press(scene.model, scene.overlap, clip, patch, face);
    // The hull pushes towards the fender. If the hull is A's, this is A's outward normal.
    let hull_is_a = face.host != patch.candidate.a;
    Touch {
        normal_in_a: if hull_is_a { press.push } else { -press.push },
        point_in_a_m: press.point_m,
        depth_m: press.deflection_m,
        spring_n: press.spring_n,
        stop_n: press.stop_n,
        stored_j: press.stored_j,
        chord_m: press.chord_m,
        tilt_rad: press.tilt_rad,
        ..Touch::default()
    }
}

/// The arm r of each of the two bodies of a patch: from its centre of gravity to the point where the force acts,
/// earth-fixed (m).
#[inline]
pub(crate) fn arms_m(scene: &Scene<'_>, patch: &Patch, point_in_a_m: Vec2) -> [Vec2; 2] {
    let rotation = scene.poses[patch.candidate.a as usize].rotation;
    [point_in_a_m, point_in_a_m - patch.b_in_a.position_m].map(|arm_m| rotation.apply(arm_m))
}

impl Touch {
    /// Makes a touch with this normal and these arms of the bodies A and B.
    #[cfg(test)]
    pub(crate) fn at(normal: Vec2, [arm_a_m, arm_b_m]: [Vec2; 2]) -> Touch {
        Touch {
            normal,
            levers_a: Levers::new(arm_a_m, normal),
            levers_b: Levers::new(arm_b_m, normal),
            ..Touch::default()
        }
    }

    /// Makes the report of a patch between the bodies A and B, without forces. Body 1 of the report is the body that
    /// was added first. If body 1 is B, the normal n and the tangent t are reversed.
    #[inline]
    pub(crate) fn contact(
        &self,
        scene: &Scene<'_>,
        patch: &Patch,
        [id_a, id_b]: [BodyId; 2],
        [arm_a_m, arm_b_m]: [Vec2; 2],
    ) -> Contact {
        let a = patch.candidate.a as usize;
        let swapped = id_a > id_b;
        Contact {
            body_1: id_a.min(id_b),
            body_2: id_a.max(id_b),
            fender: patch.candidate.fender(scene.model).map(|face| face.id),
            patch: patch.number,
            area_m2: patch.area_m2,
            depth_m: self.depth_m,
            point_m: scene.poses[a].position_m + arm_a_m,
            arm_1_m: if swapped { arm_b_m } else { arm_a_m },
            arm_2_m: if swapped { arm_a_m } else { arm_b_m },
            normal: if swapped { -self.normal } else { self.normal },
            v_normal_mps: self.v_normal_mps,
            v_tangential_mps: self.v_tangential_mps,
            shear_m: self.shear_m,
            normal_force_n: 0.0,
            tangential_force_n: 0.0,
            impulse: ContactImpulse::default(),
            friction: Friction::Stick,
            limited: false,
            peak_normal_force_n: 0.0,
            peak_depth_m: self.depth_m,
            parts: ForceParts::default(),
            work: ContactWork::default(),
            factor: 1.0,
            tilt_rad: self.tilt_rad,
            energy: EnergyParts::default(),
        }
    }
}
