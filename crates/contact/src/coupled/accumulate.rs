//! Stage 6 of the coupled method: adds a solved sub-step to the step's wrenches, memory and contact reports.

use alloc::vec::Vec;

use crate::coupled::assemble::Diagnostics;
use crate::coupled::constraint::{Constraint, Forces, Side};
use crate::coupled::sub_step::SubStep;
use crate::maths::number::{greater, lesser};
use crate::model::Model;
use crate::model::material::BodyId;
use crate::overlap::patch::Patch;
use crate::state::memory::PatchMemory;
use crate::state::report::{
    Contact, ContactImpulse, ContactWork, EnergyParts, ForceParts, Friction, Wrench,
};
use crate::touch::{Scene, Touch, arms_m};

/// Largest energy that a contact's memory may hold (J); a larger energy could not be restored from a snapshot.
const MOST_TAKEN_J: f64 = 1e29;

/// The wrenches of a step, summed over its sub-steps.
pub(crate) struct Totals<'w> {
    /// Mean wrenches on the bodies over the sub-steps that were added so far, by the ids of the bodies.
    pub(crate) wrenches: &'w mut [Wrench],
    /// The sub-step that is added to the totals. Reported forces are means over the sub-steps, weighted by the lengths
    /// of the sub-steps. While the bodies are at rest, this mean equals the force, however the lengths of the sub-steps
    /// change.
    pub(crate) sub_step: SubStep,
}

impl Totals<'_> {
    /// Adds a solved contact to the wrenches of its bodies A and B, and updates the memory of the contact.
    #[inline(always)]
    pub(crate) fn add(
        &mut self,
        [id_a, id_b]: [BodyId; 2],
        constraint: &Constraint,
        memory: &mut PatchMemory,
    ) -> Slip {
        let Forces { normal_n, tangential_n, friction } = constraint.forces;
        let (mean_n, mean_t) = (normal_n * self.sub_step.share, tangential_n * self.sub_step.share);
        let (force_n, on_a_nm) = constraint.jacobian(Side::A).wrench(mean_n, mean_t);
        let (_, on_b_nm) = constraint.jacobian(Side::B).wrench(mean_n, mean_t);
        // The force on B is exactly the opposite of the force on A (eq. 1).
        let on_a = &mut self.wrenches[id_a.0 as usize];
        on_a.force_n += force_n;
        on_a.moment_nm += on_a_nm;
        let on_b = &mut self.wrenches[id_b.0 as usize];
        on_b.force_n -= force_n;
        on_b.moment_nm -= on_b_nm;

        let slip = Slip::of(constraint, memory.shear_m, self.sub_step.h);
        let after_mps = constraint.after.tangential_mps;
        // The kinematics of the next sub-step add the bodies' motion in this sub-step.
        memory.shear_m = slip.shear_m - self.sub_step.h * after_mps;
        if constraint.shear.slides_on(slip.shear_m, after_mps, friction) {
            memory.flags |= PatchMemory::SLIPPING;
        }
        memory.flags |= u32::from(normal_n < constraint.law_n) * PatchMemory::LIMITED;
        memory.normal_force_n = normal_n;
        memory.tangential_force_n = tangential_n;
        memory.taken_j =
            between_0_and(MOST_TAKEN_J, constraint.available_j + normal_n * slip.closing_m);
        memory.sheared_j = between_0_and(
            lesser(slip.shear_stored_j, MOST_TAKEN_J),
            constraint.shear.available_j - tangential_n * slip.slip_m,
        );
        slip
    }

    /// Does as [`Totals::add`]. Returns the data that the report of the contact needs.
    #[inline(always)]
    fn entry<'w>(
        &mut self,
        model: &Model,
        constraint: &'w Constraint,
        memory: &'w mut PatchMemory,
        diagnostics: &'w Diagnostics,
    ) -> Entry<'w> {
        let ids = model.ids_of([constraint.a, constraint.b]);
        let slip = self.add(ids, constraint, memory);
        Entry { constraint, diagnostics, slip, ids, memory }
    }
}

/// The contacts of a solved sub-step; each list has one entry per patch.
pub(crate) struct Solved<'w> {
    pub(crate) patches: &'w [Patch],
    pub(crate) constraints: &'w [Constraint],
    pub(crate) memories: &'w mut [PatchMemory],
    pub(crate) diagnostics: &'w [Diagnostics],
}

/// The contact reports of a step.
pub(crate) struct Reports<'w> {
    pub(crate) contacts: &'w mut Vec<Contact>,
    /// Index of the first contact of the present group of islands in `contacts`.
    pub(crate) first: usize,
    /// Set to false when a later sub-step appends a contact at the end of the list of reports.
    pub(crate) in_order: &'w mut bool,
}

impl Reports<'_> {
    /// Adds the solved contacts of a sub-step to the totals, and reports the contacts.
    #[inline(never)]
    pub(crate) fn add_all(
        &mut self,
        scene: &Scene<'_>,
        totals: &mut Totals<'_>,
        Solved { patches, constraints, memories, diagnostics }: Solved<'_>,
    ) {
        let share = totals.sub_step.share;
        let solved = patches.iter().zip(constraints.iter().zip(memories).zip(diagnostics));
        if self.contacts.len() == self.first {
            // The first sub-step.
            self.contacts.extend(solved.map(|(patch, ((constraint, memory), diagnostics))| {
                let entry = totals.entry(scene.model, constraint, memory, diagnostics);
                entry.contact(scene, patch, share)
            }));
            return;
        }
        for (index, (patch, ((constraint, memory), diagnostics))) in solved.enumerate() {
            let entry = totals.entry(scene.model, constraint, memory, diagnostics);
            if !self.has_added(scene.model, index, share, patch, &entry) {
                *self.in_order = false;
                self.contacts.push(entry.contact(scene, patch, share));
            }
        }
    }

    /// Adds an entry of a sub-step to the step's report of the patch. Returns false if the patch has no report yet. The
    /// report is at index `guess` as long as the patches are the patches of the first sub-step.
    #[inline(never)]
    fn has_added(
        &mut self,
        model: &Model,
        guess: usize,
        share: f64,
        patch: &Patch,
        entry: &Entry<'_>,
    ) -> bool {
        let [one, two] = entry.ids;
        let fender = patch.candidate.fender(model).map(|face| face.id);
        let wanted = (one.min(two), one.max(two), fender, patch.number);
        let same = |c: &Contact| (c.body_1, c.body_2, c.fender, c.patch) == wanted;
        let own = &mut self.contacts[self.first..];
        let place = match own.get(guess) {
            Some(contact) if same(contact) => Some(guess),
            _ => own.iter().position(same),
        };
        place.inspect(|&place| entry.add_to(&mut own[place], share)).is_some()
    }
}

/// The motion of a contact's bodies at the contact while the forces acted, and the state of the shear spring
/// afterwards.
pub(crate) struct Slip {
    /// Way that the bodies moved along the normal in the time κ, by the mean of the speeds before and after (m).
    closing_m: f64,
    slip_m: f64,
    /// Δs (m).
    shear_m: f64,
    shear_stored_j: f64,
}

impl Slip {
    /// Computes the slip of a contact in a sub-step. `shear_m` is the deflection Δs of the shear spring at the start of
    /// the sub-step.
    #[inline(always)]
    fn of(constraint: &Constraint, shear_m: f64, h: f64) -> Slip {
        let Constraint { shear, after, forces, kick_s, .. } = constraint;
        let after_mps = after.tangential_mps;
        let shear_m = shear.shear_after_m(shear_m, after_mps, forces.normal_n, forces.friction, h);
        Slip {
            closing_m: 0.5 * (constraint.normal_before_mps + after.normal_mps) * kick_s,
            slip_m: 0.5 * (shear.before_mps + after_mps) * kick_s,
            shear_m,
            shear_stored_j: shear.stored_j(shear_m),
        }
    }
}

#[inline]
fn between_0_and(most_j: f64, value_j: f64) -> f64 {
    lesser(greater(value_j, 0.0), most_j)
}

/// The values that a sub-step adds to the report of a contact.
struct Entry<'w> {
    constraint: &'w Constraint,
    diagnostics: &'w Diagnostics,
    slip: Slip,
    /// Bodies A and B.
    ids: [BodyId; 2],
    memory: &'w PatchMemory,
}

impl Entry<'_> {
    fn work(&self) -> ContactWork {
        let Forces { normal_n, tangential_n, .. } = self.constraint.forces;
        let (slip, parts) = (&self.slip, self.parts());
        ContactWork {
            normal_j: -normal_n * slip.closing_m,
            tangential_j: tangential_n * slip.slip_m,
            damper_j: -parts.damper_n * slip.closing_m,
            limiter_j: -parts.limiter_n * slip.closing_m,
        }
    }

    /// The parts of the normal force N: the parts of the law's force f, less the force that the solve took off.
    fn parts(&self) -> ForceParts {
        let limiter_n = self.constraint.law_n - self.constraint.forces.normal_n;
        ForceParts { limiter_n, ..self.diagnostics.parts }
    }

    /// The report of a contact that is new in this sub-step.
    #[inline(always)]
    fn contact(&self, scene: &Scene<'_>, patch: &Patch, share: f64) -> Contact {
        let Entry { constraint, diagnostics, slip, ids, memory } = self;
        let Forces { normal_n, tangential_n, friction } = constraint.forces;
        let parts = self.parts();
        let touch = Touch {
            normal: constraint.normal,
            depth_m: diagnostics.depth_m,
            tilt_rad: diagnostics.tilt_rad,
            v_normal_mps: constraint.normal_before_mps,
            v_tangential_mps: constraint.shear.before_mps,
            ..Touch::default()
        };
        Contact {
            shear_m: slip.shear_m,
            normal_force_n: normal_n * share,
            tangential_force_n: tangential_n * share,
            impulse: ContactImpulse {
                normal_ns: normal_n * constraint.kick_s,
                tangential_ns: tangential_n * constraint.kick_s,
            },
            friction,
            limited: parts.limiter_n > 0.0,
            peak_normal_force_n: normal_n,
            parts: ForceParts {
                spring_n: parts.spring_n * share,
                stop_n: parts.stop_n * share,
                damper_n: parts.damper_n * share,
                limiter_n: parts.limiter_n * share,
            },
            work: self.work(),
            factor: memory.factor,
            energy: EnergyParts {
                stored_j: diagnostics.stored_j,
                peak_absorbed_j: diagnostics.absorbed_j,
                hysteresis_j: diagnostics.hysteresis_j,
                hysteresis_at_start_j: diagnostics.hysteresis_j,
                shear_stored_j: slip.shear_stored_j,
            },
            ..touch.contact(scene, patch, *ids, arms_m(scene, patch, memory.point_in_a_m))
        }
    }

    /// Adds a later sub-step. `share` is the length of the sub-step as a share of the step.
    fn add_to(&self, contact: &mut Contact, share: f64) {
        let Entry { constraint, diagnostics, slip, .. } = self;
        let Forces { normal_n, tangential_n, friction } = constraint.forces;
        let (parts, work) = (self.parts(), self.work());
        contact.normal_force_n += normal_n * share;
        contact.tangential_force_n += tangential_n * share;
        contact.impulse.normal_ns += normal_n * constraint.kick_s;
        contact.impulse.tangential_ns += tangential_n * constraint.kick_s;
        contact.peak_normal_force_n = greater(contact.peak_normal_force_n, normal_n);
        contact.peak_depth_m = greater(contact.peak_depth_m, diagnostics.depth_m);
        contact.energy.peak_absorbed_j =
            greater(contact.energy.peak_absorbed_j, diagnostics.absorbed_j);
        contact.energy.hysteresis_j += diagnostics.hysteresis_j;
        contact.work.normal_j += work.normal_j;
        contact.work.tangential_j += work.tangential_j;
        contact.work.damper_j += work.damper_j;
        contact.work.limiter_j += work.limiter_j;
        contact.parts.add(&parts, share);
        contact.energy.shear_stored_j = slip.shear_stored_j;
        contact.shear_m = slip.shear_m;
        contact.limited |= parts.limiter_n > 0.0;
        if friction == Friction::Slip {
            contact.friction = Friction::Slip;
        }
    }
}
