//! What a solved sub-step leaves: wrenches, the report of its contacts and their memory.

use alloc::vec::Vec;

use crate::coupled::rows::Row;
use crate::coupled::tie::{Forces, Tie};
use crate::memory::PatchMemory;
use crate::model::Model;
use crate::number::{greater, lesser};
use crate::overlap::Patch;
use crate::report::{Contact, ContactWork, ForceParts, Friction, Wrench};
use crate::touch::{Scene, Touch};

/// Beyond this a memory would not be restored [J].
const MOST_TAKEN_J: f64 = 1e29;

/// What contacts are booked in.
pub(crate) struct Books<'w> {
    /// Mean wrenches of the step as far as they are known, by id.
    pub(crate) wrenches: &'w mut [Wrench],
    /// Contacts are reported one by one.
    pub(crate) told: bool,
    pub(crate) contacts: &'w mut Vec<Contact>,
    /// First of the group's contacts.
    pub(crate) first_contact: usize,
    pub(crate) next_patches: &'w mut Vec<PatchMemory>,
    pub(crate) in_order: &'w mut bool,
    pub(crate) first_sub_step: bool,
    /// Length of the sub-step [s], and its share of the step.
    pub(crate) h: f64,
    pub(crate) share: f64,
}

impl Books<'_> {
    /// Books forces, work and peaks of a solved contact, number `index` of its group, and its memory.
    #[inline(always)]
    pub(crate) fn book(
        &mut self,
        scene: &Scene<'_>,
        index: usize,
        patch: &Patch,
        (tie, row): (&Tie, &Row),
    ) {
        let (h, share) = (self.h, self.share);
        let normal = tie.along_n;
        let Forces { normal_n, tangential_n, friction } = tie.forces;
        let force_n = (normal * -normal_n + normal.quarter_turn() * tangential_n) * share;
        let [id_a, id_b] = [tie.a, tie.b].map(|rank| scene.model.id_of[rank as usize]);
        let on_a = &mut self.wrenches[id_a.0 as usize];
        on_a.force_n += force_n;
        on_a.moment_nm += row.arm_a_m.cross(force_n);
        let on_b = &mut self.wrenches[id_b.0 as usize];
        on_b.force_n -= force_n;
        on_b.moment_nm -= row.arm_b_m.cross(force_n);

        // By the mean velocity within the sub-step.
        let (v_normal_mps, v_tangential_mps) = tie.after_mps;
        let closing_m = 0.5 * (tie.normal_before_mps + v_normal_mps) * h;
        let slip_m = 0.5 * (tie.tangential_before_mps + v_tangential_mps) * h;

        let shear_m = tie.shear_after_m(row.shear_m, v_tangential_mps, h);
        let shear_stored_j = tie.shear_stored_j(shear_m);
        let memory = PatchMemory {
            flags: row.flags,
            // What the bodies move in this sub-step is found again in the next one's kinematics.
            shear_m: shear_m - h * v_tangential_mps,
            v_normal_0_mps: row.v_ref_mps,
            normal_force_n: normal_n,
            tangential_force_n: tangential_n,
            factor: row.factor,
            taken_j: within(tie.may_give_j + normal_n * closing_m, MOST_TAKEN_J),
            sheared_j: within(
                tie.may_shear_j - tangential_n * slip_m,
                lesser(shear_stored_j, MOST_TAKEN_J),
            ),
            ..PatchMemory::of(patch, row.point_in_a_m, row.normal_in_a)
        };
        memory.add_to(patch, &scene.found.places, self.next_patches);
        if !self.told {
            return;
        }
        let limiter_n = tie.law_n - normal_n;
        let booked = Booked {
            normal_n,
            tangential_n,
            friction,
            depth_m: row.depth_m,
            stored_j: row.stored_j,
            work: ContactWork {
                normal_j: -normal_n * closing_m,
                tangential_j: tangential_n * slip_m,
                damper_j: -row.parts.damper_n * closing_m,
                limiter_j: -limiter_n * closing_m,
            },
            parts: ForceParts { limiter_n, ..row.parts },
            shear_m,
            shear_stored_j,
        };
        if !self.first_sub_step && self.has_added(scene.model, index, patch, &booked) {
            return;
        }
        *self.in_order &= self.first_sub_step;
        self.contacts.push(booked.contact(scene, patch, (tie, row), share));
    }

    /// Adds to the step's report of this patch, if there is one among the group's: at `guess` as long as the
    /// patches are those of the first sub-step.
    #[inline(never)]
    fn has_added(&mut self, model: &Model, guess: usize, patch: &Patch, booked: &Booked) -> bool {
        let candidate = &patch.candidate;
        let [one, two] = [candidate.a, candidate.b].map(|rank| model.id_of[rank as usize]);
        let fender = candidate.fender(model).map(|face| face.id);
        let wanted = (one.min(two), one.max(two), fender, patch.number);
        let same = |c: &Contact| (c.body_1, c.body_2, c.fender, c.patch) == wanted;
        let own = &mut self.contacts[self.first_contact..];
        let place = match own.get(guess) {
            Some(contact) if same(contact) => Some(guess),
            _ => own.iter().position(same),
        };
        place.inspect(|&place| booked.add_to(&mut own[place], self.share)).is_some()
    }
}

/// What a contact may give back: neither less than nothing nor more than this [J].
#[inline]
fn within(taken_j: f64, most_j: f64) -> f64 {
    lesser(greater(taken_j, 0.0), most_j)
}

/// What a sub-step adds to the report of a contact.
struct Booked {
    normal_n: f64,
    tangential_n: f64,
    friction: Friction,
    depth_m: f64,
    stored_j: f64,
    work: ContactWork,
    parts: ForceParts,
    shear_m: f64,
    shear_stored_j: f64,
}

impl Booked {
    /// The report of a contact that begins with this sub-step.
    #[inline(always)]
    fn contact(
        &self,
        scene: &Scene<'_>,
        patch: &Patch,
        (tie, row): (&Tie, &Row),
        share: f64,
    ) -> Contact {
        let face = patch.candidate.fender(scene.model);
        let a_position_m = scene.poses[tie.a as usize].position_m;
        let parts = &self.parts;
        Contact {
            shear_m: self.shear_m,
            normal_force_n: self.normal_n * share,
            tangential_force_n: self.tangential_n * share,
            friction: self.friction,
            limited: parts.limiter_n > 0.0,
            peak_normal_force_n: self.normal_n,
            parts: ForceParts {
                spring_n: parts.spring_n * share,
                stop_n: parts.stop_n * share,
                damper_n: parts.damper_n * share,
                limiter_n: parts.limiter_n * share,
            },
            work: self.work,
            factor: row.factor,
            stored_j: self.stored_j,
            peak_stored_j: self.stored_j,
            shear_stored_j: self.shear_stored_j,
            ..touch_of(tie, row).contact(scene.model, a_position_m, patch, face)
        }
    }

    /// As a sub-step of this `share` of the step.
    fn add_to(&self, contact: &mut Contact, share: f64) {
        contact.normal_force_n += self.normal_n * share;
        contact.tangential_force_n += self.tangential_n * share;
        contact.peak_normal_force_n = greater(contact.peak_normal_force_n, self.normal_n);
        contact.peak_depth_m = greater(contact.peak_depth_m, self.depth_m);
        contact.peak_stored_j = greater(contact.peak_stored_j, self.stored_j);
        contact.work.normal_j += self.work.normal_j;
        contact.work.tangential_j += self.work.tangential_j;
        contact.work.damper_j += self.work.damper_j;
        contact.work.limiter_j += self.work.limiter_j;
        contact.parts.add(&self.parts, share);
        contact.shear_stored_j = self.shear_stored_j;
        contact.shear_m = self.shear_m;
        contact.limited |= self.parts.limiter_n > 0.0;
        if self.friction == Friction::Slip {
            contact.friction = Friction::Slip;
        }
    }
}

/// What the report of a contact tells of its kinematics.
#[inline(always)]
fn touch_of(tie: &Tie, row: &Row) -> Touch {
    Touch {
        normal: tie.along_n,
        arm_a_m: row.arm_a_m,
        arm_b_m: row.arm_b_m,
        depth_m: row.depth_m,
        tilt_rad: row.tilt_rad,
        v_normal_mps: tie.normal_before_mps,
        v_tangential_mps: tie.tangential_before_mps,
        ..Touch::default()
    }
}
