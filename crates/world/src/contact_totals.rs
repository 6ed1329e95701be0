//! Work and energy of each contact in a step.

use fenderline_contact::number::greater;
use fenderline_contact::{Contact, ContactWork};

use crate::energy::ContactEnergy;
use crate::hull::HeightWork;
use crate::mean_velocity::MeanVelocity;

/// How the work of a contact is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WorkSource {
    /// The contact engine moved the bodies, and reports impulse and work summed over its sub-steps.
    Engine,
    /// The work is the product of the contact's mean force, the bodies' mean velocities and this time (s).
    MeanVelocity(f64),
}

/// Work and energy of each contact in the current step.
#[derive(Clone, Debug, Default)]
pub struct ContactTotals {
    /// One entry for each contact, in the order in which the contacts began. A contact that has ended stays in the list
    /// for one more step.
    pub all: Vec<ContactEnergy>,
    /// For each entry of `all`, data of the contact at the start of the step.
    at_start: Vec<AtStart>,
    /// Sum of the energy that ended contacts created (J).
    gained_j: f64,
    has_begun: bool,
    /// Index of the entry of `all` that the last search for a contact found.
    last: usize,
    /// For each entry of `all`, the index of the entry that was searched for after this entry the last time.
    following: Vec<usize>,
}

/// Data of a contact at the start of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct AtStart {
    exists: bool,
    stored_j: f64,
    shear_stored_j: f64,
    /// Hysteresis loss that belongs to the previous step.
    hysteresis_j: f64,
}

impl ContactTotals {
    /// Forgets all contacts of the run so far.
    pub fn restart(&mut self) {
        let ContactTotals { all, at_start, gained_j, has_begun, last, following } = self;
        all.clear();
        at_start.clear();
        following.clear();
        (*gained_j, *has_begun, *last) = (0.0, false, 0);
    }

    /// Begins a step. The function removes contacts that ended in the step before the last, and clears the work of all
    /// contacts. It also compares the stored energy that was accumulated so far with the potential of the springs.
    pub fn open(&mut self, contacts: &[Contact], works: &[HeightWork]) {
        let mut index = 0;
        let (gained_j, count) = (&mut self.gained_j, self.all.len());
        self.all.retain(|energy| {
            index += 1;
            let exists = self.at_start[index - 1].exists;
            if !exists {
                *gained_j += greater(energy.since_began_j, 0.0);
            }
            exists
        });
        if self.all.len() < count {
            // The indices of the other entries have changed.
            self.following.clear();
            self.following.extend(1..=self.all.len());
        }
        self.at_start.clear();
        self.at_start.resize(self.all.len(), AtStart::default());
        for energy in &mut self.all {
            *energy = ContactEnergy {
                bodies: energy.bodies,
                fender: energy.fender,
                since_began_j: energy.since_began_j,
                stored_j: energy.stored_j,
                shear_stored_j: energy.shear_stored_j,
                ..ContactEnergy::default()
            };
        }
        for work in works {
            let index = self.index_of_pair(work.bodies, Some(work.fender));
            let energy = &mut self.all[index];
            energy.height_j += work.work_j;
            energy.stored_j += work.work_j;
        }
        for contact in contacts {
            let index = self.index_of(contact);
            let at_start = &mut self.at_start[index];
            at_start.exists = true;
            at_start.stored_j += contact.energy.stored_j;
            at_start.hysteresis_j += contact.energy.hysteresis_at_start_j;
            at_start.shear_stored_j += contact.energy.shear_stored_j;
        }
        // Contacts between outlines have no potential: their accumulated energy stays until the contact ends.
        for (energy, at_start) in self.all.iter_mut().zip(&self.at_start) {
            let stored_j = match (at_start.exists, energy.fender) {
                (true, Some(_)) => at_start.stored_j,
                (true, None) => energy.stored_j,
                (false, _) => 0.0,
            };
            // The engine finds hysteresis losses at the start of a sub-step, so the loss at the end of the last step is
            // counted in this step.
            energy.hysteresis_j = at_start.hysteresis_j;
            energy.residual_j = energy.stored_j - at_start.hysteresis_j - stored_j;
            energy.stored_j = stored_j;
        }
    }

    /// Adds impulse, work and losses of the contacts `contacts`.
    pub fn add(&mut self, contacts: &[Contact], mean: &[MeanVelocity], source: WorkSource) {
        for contact in contacts {
            let (work, impulse_ns) = match source {
                WorkSource::Engine => (contact.work, contact.impulse.normal_ns),
                WorkSource::MeanVelocity(seconds) => {
                    (work_along(contact, mean, seconds), contact.normal_force_n * seconds)
                }
            };
            let index = self.index_of(contact);
            let energy = &mut self.all[index];
            energy.normal_impulse_ns += impulse_ns;
            energy.normal_j += work.normal_j;
            energy.tangential_j += work.tangential_j;
            let hysteresis_j = contact.energy.hysteresis_j - contact.energy.hysteresis_at_start_j;
            energy.hysteresis_j += hysteresis_j;
            energy.damping_j -= work.damper_j;
            energy.restitution_j += work.limiter_j;
            energy.stored_j -= work.normal_j - work.damper_j + work.limiter_j + hysteresis_j;
        }
    }

    /// Ends a step. The friction loss of a step is the work of the tangential force, less the energy that the shear
    /// spring stored.
    pub fn close(&mut self) {
        for (energy, at_start) in self.all.iter_mut().zip(&self.at_start) {
            energy.since_began_j += energy.normal_j + energy.tangential_j - energy.height_j;
            energy.friction_j =
                -energy.tangential_j - (at_start.shear_stored_j - energy.shear_stored_j);
            energy.shear_stored_j = at_start.shear_stored_j;
        }
        self.has_begun = true;
    }

    /// Energy that all contacts of the run have created so far, present contacts included (J).
    pub fn gained_j(&self) -> f64 {
        self.all
            .iter()
            .fold(self.gained_j, |sum_j, energy| sum_j + greater(energy.since_began_j, 0.0))
    }

    fn index_of(&mut self, contact: &Contact) -> usize {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        self.index_of_pair(bodies, contact.fender.map(|id| id.0 as usize))
    }

    fn index_of_pair(&mut self, bodies: [usize; 2], fender: Option<usize>) -> usize {
        let same = |b: &ContactEnergy| b.bodies == bodies && b.fender == fender;
        // Contacts come in the same order in every step. This is not the order of the entries if contacts began in
        // different steps. So the search first tries the entry that came next in the last step, and then the last entry
        // again, for another patch of it. With 1,000 fenders, searching all entries would take longer than solving the
        // contacts.
        let is_at = |index: usize| self.all.get(index).is_some_and(same);
        let next = self.following.get(self.last).copied().unwrap_or(0);
        let near = [next, self.last, self.last + 1].into_iter().find(|&index| is_at(index));
        let found = near.or_else(|| self.all.iter().position(same));
        let index = found.unwrap_or(self.all.len());
        if index != self.last
            && let Some(next) = self.following.get_mut(self.last)
        {
            *next = index;
        }
        self.last = index;
        found.unwrap_or_else(|| {
            // A contact that exists at the start of the run may have energy stored already.
            let since_began_j = if self.has_begun { 0.0 } else { f64::NEG_INFINITY };
            self.all.push(ContactEnergy {
                bodies,
                fender,
                since_began_j,
                ..ContactEnergy::default()
            });
            self.at_start.push(AtStart { exists: true, ..AtStart::default() });
            self.following.push(self.all.len());
            index
        })
    }
}

/// Work of a contact's mean forces over the mean motion of the two bodies.
fn work_along(contact: &Contact, mean: &[MeanVelocity], seconds: f64) -> ContactWork {
    let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
    let [one, two] = bodies.map(|body| mean[body]);
    let slip_m = (one.at(contact.arm_1_m) - two.at(contact.arm_2_m)) * seconds;
    let closing_m = contact.normal.dot(slip_m);
    ContactWork {
        normal_j: -contact.normal_force_n * closing_m,
        tangential_j: contact.tangential_force_n * contact.tangent().dot(slip_m),
        damper_j: -contact.parts.damper_n * closing_m,
        limiter_j: -contact.parts.limiter_n * closing_m,
    }
}
