//! Moves islands through their sub-steps, stage by stage.

use alloc::vec::Vec;

use crate::broad::bodies::{Bodies, NONE_DISPLACED};
use crate::broad::candidates::Candidates;
use crate::coupled::accumulate::{Reports, Solved, Totals};
use crate::coupled::assemble::{Aside, Start};
use crate::coupled::contact_stage::{Assembly, Constraints, Contacts, solve_islands};
use crate::coupled::dynamics::Dynamics;
use crate::coupled::island::{self, Group, Island};
use crate::coupled::peaks;
use crate::coupled::sub_step::SubStep;
use crate::coupled::sub_step_count::{Bounded, Sums};
use crate::geometry::clip::ClipBuffers;
use crate::inherit::Inheritance;
use crate::maths::room::room_for;
use crate::model::Model;
use crate::overlap::hints::Hints;
use crate::overlap::lenses::Overlap;
use crate::overlap::overlap;
use crate::state::memory::{ContactMemory, HintMemory, Past, PlaceMemory};
use crate::state::report::Wrench;
use crate::state::results::Results;
use crate::touch::Scene;

/// The parts of the workspace that sub-steps read and write.
pub(crate) struct SubSteps<'w> {
    pub(crate) model: &'w Model,
    /// Loads by id.
    pub(crate) loads: &'w [Wrench],
    pub(crate) candidates: &'w Candidates,
    /// True if some islands have more than one floating body.
    pub(crate) joined: bool,
    pub(crate) bodies: &'w mut Bodies,
    pub(crate) dynamics: &'w mut Dynamics,
    pub(crate) group: &'w mut Group,
    pub(crate) clip: &'w mut ClipBuffers,
    pub(crate) inheritance: &'w mut Inheritance,
    pub(crate) constraints: &'w mut Constraints,
    pub(crate) next_memory: &'w mut ContactMemory,
    pub(crate) results: &'w mut Results,
    /// Set to false when contacts or memories are added out of the order of their keys.
    pub(crate) in_order: &'w mut bool,
}

/// Buffers that are kept while islands go through their sub-steps.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kept {
    /// The hints for the clip of polygons, as the overlap at the start of the step leaves them.
    first_hints: Vec<HintMemory>,
    rate_sums: Sums,
    later: Later,
}

impl Kept {
    /// Makes buffers with room for the hints of this number of contacts.
    pub(crate) fn with_room(contacts: usize) -> Kept {
        Kept { first_hints: room_for(contacts), ..Kept::default() }
    }
}

/// Buffers that are kept between the sub-steps of a group.
#[derive(Clone, Debug, Default)]
struct Later {
    /// The memory of contacts that the group's last sub-step left.
    last: ContactMemory,
    /// The overlap that is computed in a later sub-step.
    overlap: Overlap,
}

impl SubSteps<'_> {
    /// Moves all islands through the step. The islands must be in the order of their memories in `past`. `first`
    /// receives the overlap of each island at the start of the step.
    ///
    /// The islands of a group go through their sub-steps together: each stage handles all contacts of the group.
    /// Returns true if all hints in `past` stay unchanged; unchanged hints are not added to the next memory.
    pub(crate) fn advance(
        &mut self,
        past: Past<'_>,
        islands: &mut [Island],
        first: &mut Overlap,
        kept: &mut Kept,
        step_s: f64,
    ) -> bool {
        let ([head, ..], [.., last]) = (&*islands, &*islands) else { return false };
        let (model, pairings) = (self.model, self.candidates.pairings.as_slice());
        let range = head.candidates().start..last.candidates().end;
        let Kept { first_hints, rate_sums, later } = kept;
        first_hints.clear();
        let hints = Hints::new(past.hints, first_hints);
        let own = &pairings[range.clone()];
        let keeps_hints = overlap(model, self.bodies, own, range.start, hints, self.clip, first);
        let hints = if keeps_hints { past.hints } else { first_hints };
        let bounded = Bounded {
            model,
            bodies: self.bodies,
            dynamics: self.dynamics,
            candidates: self.candidates,
            hints,
            step_s,
        };
        rate_sums.resize(if self.joined { model.ranked.len() } else { 0 }, 0.0);
        bounded.set_sub_steps(&first.patches, islands, self.joined.then_some(rate_sums));

        let all_stay = keeps_hints && islands.iter().all(|island| island.sub_steps == 1);
        // With this room, a later step that copies the hints does not allocate.
        self.next_memory.hints.reserve(hints.len());
        let mut rest = Past { hints: if all_stay { &[] } else { hints }, ..past };
        for group in island::groups(islands) {
            self.enter(group);
            let end = self.group.candidates.end;
            let next = (end < range.end).then(|| pairings[end].candidate.key());
            let past = rest.before(next, self.group.patches.len());
            if group[0].sub_steps > 1 {
                self.several(past, group, first, later, step_s);
            } else {
                self.sub_step(past, first, group, SubStep::whole(step_s));
                self.next_memory.hints.extend_from_slice(past.hints);
            }
            self.dynamics.mark_moved_fixed();
        }
        all_stay
    }

    /// Begins the step for a group of islands.
    fn enter(&mut self, islands: &[Island]) {
        let pairings = self.candidates.pairings.as_slice();
        let Dynamics { roles, moving_fixed, .. } = &mut *self.dynamics;
        if self.joined || !moving_fixed.is_empty() {
            self.group.enter(islands, pairings, roles);
        } else {
            self.group.enter_alone(islands, pairings, roles);
        }
        self.group.first = self.next_memory.lengths();
        self.group.first_contact = self.results.contacts.len();
        let own = &pairings[self.group.candidates.clone()];
        self.dynamics.reset_moving_fixed(self.bodies, own);
    }

    /// Moves a group that takes several sub-steps through the step. `first` is the overlap of the first sub-step.
    fn several(
        &mut self,
        past: Past<'_>,
        islands: &mut [Island],
        first: &Overlap,
        Later { last, overlap: later_overlap }: &mut Later,
        step_s: f64,
    ) {
        let pairings = &self.candidates.pairings[self.group.candidates.clone()];
        let first_peak = self.results.peaks.len();
        let Results { wrenches, peaks, .. } = &mut *self.results;
        peaks::begin(self.model, &self.group.bodies, pairings, wrenches, peaks);
        for sub_step in SubStep::all(islands[0].sub_steps, step_s) {
            if sub_step.is_first() {
                self.sub_step(past, first, islands, sub_step);
                last.take(self.next_memory, self.group.first);
                last.hints.extend_from_slice(past.hints);
            } else {
                let hints = Hints::new(&last.hints, &mut self.next_memory.hints);
                let start = self.group.candidates.start;
                let bodies = &*self.bodies;
                let (model, clip) = (self.model, &mut *self.clip);
                if overlap(model, bodies, pairings, start, hints, clip, later_overlap) {
                    self.next_memory.hints.extend_from_slice(&last.hints);
                }
                self.group.patches = 0..later_overlap.patches.len();
                island::set_patches(islands, &later_overlap.patches);
                let past = last.past(sub_step.h, &NONE_DISPLACED);
                self.sub_step(past, later_overlap, islands, sub_step);
                if !sub_step.is_last() {
                    last.take(self.next_memory, self.group.first);
                }
            }
            let Results { wrenches, peaks, .. } = &mut *self.results;
            peaks::update(&mut peaks[first_peak..], wrenches, sub_step.share);
        }
    }

    /// Computes one sub-step of a group, after its overlap (stage 3).
    fn sub_step(
        &mut self,
        past: Past<'_>,
        overlap: &Overlap,
        islands: &[Island],
        sub_step: SubStep,
    ) {
        let patches = &overlap.patches[self.group.patches.clone()];

        // v_free = v + κ M⁻¹ W: velocities by the loads alone.
        let (model, joined) = (self.model, self.joined.then_some(islands));
        self.dynamics.begin_sub_step(model, self.loads, self.group, joined, patches, sub_step);

        if !patches.is_empty() || !past.patches.is_empty() {
            self.solve_contacts(past, overlap, islands, sub_step);
        }

        // x⁺ = x + h v⁺.
        self.dynamics.advance_positions(model, self.group, self.bodies, self.results, sub_step);
    }

    /// Stages 4 to 6 of a sub-step: the contact laws, the solve for the forces, and the sums over the sub-steps. The
    /// function is called if contacts exist in this sub-step, or existed in the last one.
    #[inline(always)]
    fn solve_contacts(
        &mut self,
        past: Past<'_>,
        overlap: &Overlap,
        islands: &[Island],
        sub_step: SubStep,
    ) {
        let SubSteps { model, bodies, dynamics, group, next_memory, results, .. } = self;
        let (model, count) = (*model, self.model.ranked.len());
        let patches = &overlap.patches[group.patches.clone()];
        let poses = &bodies.poses[..count];

        // 4. The laws of the contacts (eq. 2–10) as constraints, from what each inherits.
        let first_patch = next_memory.patches.len();
        let (constraints, diagnostics, solver) =
            self.constraints.of(patches.len(), results.reports_contacts);
        let scene = Scene { model, overlap, poses, states: &dynamics.states[..count] };
        let mut assembly = Assembly {
            start: Start {
                scene,
                inverses: &dynamics.inverses[..count],
                roles: &dynamics.roles[..count],
                velocity_lags_s: &dynamics.velocity_lags_s[..count],
                h: sub_step.h,
            },
            aside: Aside {
                events: &mut results.events,
                clip: self.clip,
                panels: &mut results.panels,
                parted: &mut results.parted,
            },
            patches,
            islands: (islands, group.patches.start),
            constraints,
            diagnostics,
            next_patches: &mut next_memory.patches,
        };
        let matched = assembly.add_matched(past);
        if matched < past.patches.len().max(patches.len()) {
            let (inheritance, events) = (&mut *self.inheritance, &mut *assembly.aside.events);
            inheritance.find(model, past, patches, &overlap.places, matched, events);
            assembly.add_others(past, inheritance, matched);
        }
        PlaceMemory::add_all(patches, &overlap.places, &mut next_memory.places);

        // 5. N and T of all contacts of each island (in place of eq. 26), and v⁺.
        let memories = &mut next_memory.patches[first_patch..];
        let contacts = Contacts { patches, constraints, memories };
        let events = &mut results.events;
        solve_islands(model, group, islands, contacts, dynamics, solver, events);

        // 6. Sums of the forces (eq. 1), memory and reports.
        let mut totals = Totals { wrenches: &mut results.wrenches, sub_step };
        if results.reports_contacts {
            let scene = Scene { model, overlap, poses, states: &dynamics.states[..count] };
            let solved = Solved { patches, constraints, memories, diagnostics };
            let (contacts, first) = (&mut results.contacts, group.first_contact);
            let mut reports = Reports { contacts, first, in_order: self.in_order };
            reports.add_all(&scene, &mut totals, solved);
        } else {
            for (constraint, memory) in constraints.iter().zip(memories) {
                totals.add(model.ids_of([constraint.a, constraint.b]), constraint, memory);
            }
        }
    }
}
