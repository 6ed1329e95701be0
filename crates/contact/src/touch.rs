//! The kinematics of one patch: normal, arms, velocities and shear, in earth-fixed axes.

use alloc::vec::Vec;

use crate::fender::RankedFender;
use crate::memory::PatchMemory;
use crate::model::Model;
use crate::overlap::{self, Patch, Place};
use crate::report::{Contact, ContactWork, ForceParts, Friction};
use crate::vec2::Vec2;
use crate::workspace::Workspace;

/// One patch as the laws see it; body A is the one with the lower rank.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Touch {
    /// n in A's frame.
    pub(crate) normal_in_a: Vec2,
    /// n, A's outward normal, earth-fixed.
    pub(crate) normal: Vec2,
    /// Where the force acts, in A's frame [m]: C, or a point of the line of a fender's force.
    pub(crate) point_in_a_m: Vec2,
    /// r of each body: from its centre of gravity to that point, earth-fixed [m].
    pub(crate) arm_a_m: Vec2,
    pub(crate) arm_b_m: Vec2,
    /// δ [m].
    pub(crate) depth_m: f64,
    /// Spring and stop, before factors [N].
    pub(crate) spring_n: f64,
    pub(crate) stop_n: f64,
    /// What a fender stores, before factors [J]; an area spring between two hulls stores no energy that
    /// its depth alone would tell.
    pub(crate) stored_j: f64,
    /// Angle between a fender's face and the hull [rad].
    pub(crate) tilt_rad: f64,
    /// V_n, V_t [m/s] (eq. 10).
    pub(crate) v_normal_mps: f64,
    pub(crate) v_tangential_mps: f64,
    /// Δs before this step's friction law [m].
    pub(crate) shear_m: f64,
}

/// Kinematics of a patch from the states and poses in `work`; `face` is the fender of it, where there is one.
// Always inlined: what it returns stays in registers.
#[inline(always)]
pub(crate) fn touch(
    model: &Model,
    work: &mut Workspace,
    patch: &Patch,
    face: Option<&RankedFender>,
    old: Option<&PatchMemory>,
) -> Touch {
    let (a, b) = (patch.candidate.a as usize, patch.candidate.b as usize);
    let pressed = match face {
        None => by_area(model, work, patch, old),
        Some(face) => by_face(model, work, patch, face),
    };
    let Touch { normal_in_a, point_in_a_m, .. } = pressed;
    let rotation = work.poses[a].rotation;
    let normal = rotation.apply(normal_in_a);
    let arm_a_m = rotation.apply(point_in_a_m);
    let arm_b_m = rotation.apply(point_in_a_m - patch.b_in_a.position_m);
    let (state_a, state_b) = (&work.states[a], &work.states[b]);
    let slip_mps = (state_a.velocity_mps - state_b.velocity_mps)
        + (arm_a_m.spun_by(state_a.yaw_rate_radps) - arm_b_m.spun_by(state_b.yaw_rate_radps));
    let shear_m = old.map_or(0.0, |m| {
        // How far the material points that were at C have moved apart, in A's frame, where nothing
        // is lost far from the origin.
        let apart = m.point_in_a_m - patch.b_in_a.apply(m.point_in_b_m);
        m.shear_m + apart.dot(normal_in_a.quarter_turn())
    });
    Touch {
        normal,
        arm_a_m,
        arm_b_m,
        v_normal_mps: slip_mps.dot(normal),
        v_tangential_mps: slip_mps.dot(normal.quarter_turn()),
        shear_m,
        ..pressed
    }
}

/// Outline against outline: kS along the chord's normal, at the centroid (§1, §2 of the sheet).
#[inline(always)]
fn by_area(model: &Model, work: &mut Workspace, patch: &Patch, old: Option<&PatchMemory>) -> Touch {
    let (normal_in_a, depth_m) = overlap::normal_in_a(model, work, patch, old);
    let material = &model.materials()[patch.candidate.material.0 as usize];
    Touch {
        normal_in_a,
        point_in_a_m: patch.centroid_m,
        depth_m,
        spring_n: material.stiffness_npm2 * patch.area_m2,
        ..Touch::default()
    }
}

/// An outline against a fender: by the fender's law.
#[inline(never)]
fn by_face(model: &Model, work: &Workspace, patch: &Patch, face: &RankedFender) -> Touch {
    let press = overlap::press(model, work, patch, face);
    // The hull pushes towards the fender: that is A's outward normal where the hull is A's.
    let hull_is_a = face.host != patch.candidate.a;
    Touch {
        normal_in_a: if hull_is_a { press.push } else { -press.push },
        point_in_a_m: press.point_m,
        depth_m: press.deflection_m,
        spring_n: press.spring_n,
        stop_n: press.stop_n,
        stored_j: press.stored_j,
        tilt_rad: press.tilt_rad,
        ..Touch::default()
    }
}

impl Touch {
    /// The report of this patch without its forces, with the body that was added first as body 1:
    /// a change of order turns n and t round and nothing else. `a_position_m`: where body A is.
    #[inline]
    pub(crate) fn contact(
        &self,
        model: &Model,
        a_position_m: Vec2,
        patch: &Patch,
        face: Option<&RankedFender>,
    ) -> Contact {
        let (a, b) = (patch.candidate.a as usize, patch.candidate.b as usize);
        let (id_a, id_b) = (model.id_of[a], model.id_of[b]);
        let swapped = id_a > id_b;
        Contact {
            body_1: id_a.min(id_b),
            body_2: id_a.max(id_b),
            fender: face.map(|face| face.id),
            patch: patch.number,
            area_m2: patch.area_m2,
            depth_m: self.depth_m,
            point_m: a_position_m + self.arm_a_m,
            arm_1_m: if swapped { self.arm_b_m } else { self.arm_a_m },
            arm_2_m: if swapped { self.arm_a_m } else { self.arm_b_m },
            normal: if swapped { -self.normal } else { self.normal },
            v_normal_mps: self.v_normal_mps,
            v_tangential_mps: self.v_tangential_mps,
            shear_m: self.shear_m,
            normal_force_n: 0.0,
            tangential_force_n: 0.0,
            friction: Friction::Stick,
            limited: false,
            peak_normal_force_n: 0.0,
            peak_depth_m: self.depth_m,
            parts: ForceParts::default(),
            work: ContactWork::default(),
            factor: 1.0,
            tilt_rad: self.tilt_rad,
            stored_j: 0.0,
            peak_stored_j: 0.0,
            shear_stored_j: 0.0,
        }
    }

    /// Adds to `into` what the next step needs to know of this patch.
    // Written where it is to stay, the rare part by itself: copied as a whole, it would be waited for.
    #[inline(always)]
    pub(crate) fn remember(
        &self,
        patch: &Patch,
        places: &[Place],
        laws: Lasting,
        into: &mut Vec<PatchMemory>,
    ) {
        into.push(PatchMemory {
            a: patch.candidate.a,
            b: patch.candidate.b,
            face: patch.candidate.face,
            patch: patch.number,
            flags: laws.flags,
            area_m2: patch.area_m2,
            point_in_a_m: self.point_in_a_m,
            point_in_b_m: patch.b_in_a.apply_inverse(self.point_in_a_m),
            normal_in_a: self.normal_in_a,
            normal_in_b: patch.b_in_a.rotation.apply_inverse(self.normal_in_a),
            shear_m: laws.shear_m,
            v_normal_0_mps: laws.v_normal_0_mps,
            v_tangential_0_mps: laws.v_tangential_0_mps,
            factor: laws.factor,
            ..PatchMemory::default()
        });
        if let (Some(place), Some(last)) = (patch.place(), into.last_mut()) {
            let Place { in_a, in_b } = places[place as usize];
            (last.extent_in_a, last.extent_in_b) = (in_a, in_b);
        }
    }
}

/// What the laws leave in a patch's memory: its fields of the same names.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Lasting {
    pub(crate) flags: u32,
    pub(crate) shear_m: f64,
    pub(crate) v_normal_0_mps: f64,
    pub(crate) v_tangential_0_mps: f64,
    pub(crate) factor: f64,
}
