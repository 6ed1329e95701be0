//! The energy ledger: where every joule of a step came from.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Contact, ContactWork, Displacement, Vec2, Wrench};

use crate::record::{ContactEnergy, Energy, LoadWork};
use crate::rigid_body::Inertia;

/// Mean of the velocities before and after a step. A constant force times it is exactly the change
/// of kinetic energy: ½m(v₁² − v₀²) = m(v₁ − v₀)·½(v₀ + v₁).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct MeanVelocity {
    velocity_mps: Vec2,
    yaw_rate_radps: f64,
}

impl MeanVelocity {
    pub(crate) fn of(before: &BodyState, after: &BodyState) -> MeanVelocity {
        MeanVelocity {
            velocity_mps: (before.velocity_mps + after.velocity_mps) * 0.5,
            yaw_rate_radps: 0.5 * (before.yaw_rate_radps + after.yaw_rate_radps),
        }
    }

    /// As the integrator moved the body.
    pub(crate) fn moved((velocity_mps, yaw_rate_radps): (Vec2, f64)) -> MeanVelocity {
        MeanVelocity { velocity_mps, yaw_rate_radps }
    }

    /// That of the engine's motion, sub-steps included.
    pub(crate) fn over(motion: &Displacement, step_s: f64) -> MeanVelocity {
        MeanVelocity {
            velocity_mps: motion.translation_m * (1.0 / step_s),
            yaw_rate_radps: motion.rotation_rad / step_s,
        }
    }

    pub(crate) fn at(&self, arm_m: Vec2) -> Vec2 {
        self.velocity_mps + arm_m.spun_by(self.yaw_rate_radps)
    }

    pub(crate) fn power_w(&self, wrench: &Wrench) -> f64 {
        wrench.force_n.dot(self.velocity_mps) + wrench.moment_nm * self.yaw_rate_radps
    }
}

/// What the works of a contact come from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum WorkBy {
    /// The engine moved the bodies, and knows impulse and work of each of its sub-steps.
    Engine,
    /// The mean forces act along the host's motion for a time (s).
    Motion(f64),
}

/// One book a contact, from step to step.
#[derive(Clone, Debug, Default)]
pub(crate) struct ContactTotals {
    /// By bodies and fender, as contacts come; those that let go stay for one step.
    pub(crate) all: Vec<ContactEnergy>,
    /// For each book: is the contact there in this step, and its fender's stored energy at the start.
    seen: Vec<Seen>,
    /// What contacts that are over gave more than they took (J).
    gained_j: f64,
    is_under_way: bool,
}

#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Seen {
    now: bool,
    stored_j: f64,
    shear_stored_j: f64,
    /// Heat by unloading laws that belongs to the step before.
    hysteresis_at_start_j: f64,
}

impl ContactTotals {
    /// Opens a step: nothing has happened yet, and contacts that had let go are forgotten.
    pub(crate) fn open(&mut self, contacts: &[Contact]) {
        let mut index = 0;
        let gained_j = &mut self.gained_j;
        self.all.retain(|book| {
            index += 1;
            let goes_on = self.seen[index - 1].now;
            if !goes_on {
                *gained_j += greater(book.since_began_j, 0.0);
            }
            goes_on
        });
        self.seen.clear();
        self.seen.resize(self.all.len(), Seen::default());
        for book in &mut self.all {
            *book = ContactEnergy {
                bodies: book.bodies,
                fender: book.fender,
                since_began_j: book.since_began_j,
                stored_j: book.stored_j,
                shear_stored_j: book.shear_stored_j,
                ..ContactEnergy::default()
            };
        }
        for contact in contacts {
            let index = self.index_of(contact);
            let seen = &mut self.seen[index];
            seen.now = true;
            seen.stored_j += contact.energy.stored_j;
            seen.hysteresis_at_start_j += contact.energy.hysteresis_at_start_j;
            seen.shear_stored_j += contact.energy.shear_stored_j;
        }
        // The books of contacts that go on against the fenders' potentials; those of contacts that are
        // no more are closed.
        for (book, seen) in self.all.iter_mut().zip(&self.seen) {
            let is_j = match (seen.now, book.fender) {
                (true, Some(_)) => seen.stored_j,
                (true, None) => book.stored_j,
                (false, _) => 0.0,
            };
            // Heat is found where a sub-step begins: that of the last step's end is in its book now.
            book.hysteresis_j = seen.hysteresis_at_start_j;
            book.residual_j = book.stored_j - seen.hysteresis_at_start_j - is_j;
            book.stored_j = is_j;
        }
    }

    /// Adds what `contacts` did.
    pub(crate) fn add(&mut self, contacts: &[Contact], mean: &[MeanVelocity], by: WorkBy) {
        for contact in contacts {
            let (work, impulse_ns) = match by {
                WorkBy::Engine => (contact.work, contact.impulse.normal_ns),
                WorkBy::Motion(seconds) => {
                    (work_along(contact, mean, seconds), contact.normal_force_n * seconds)
                }
            };
            let index = self.index_of(contact);
            let book = &mut self.all[index];
            book.normal_impulse_ns += impulse_ns;
            book.normal_j += work.normal_j;
            book.tangential_j += work.tangential_j;
            let hysteresis_j = contact.energy.hysteresis_j - contact.energy.hysteresis_at_start_j;
            book.hysteresis_j += hysteresis_j;
            book.damping_j -= work.damper_j;
            book.restitution_j += work.limiter_j;
            book.stored_j -= work.normal_j - work.damper_j + work.limiter_j + hysteresis_j;
        }
    }

    /// Closes a step: what friction took is what the bodies lost and the shear springs do not hold.
    pub(crate) fn close(&mut self) {
        for (book, seen) in self.all.iter_mut().zip(&self.seen) {
            book.since_began_j += book.normal_j + book.tangential_j;
            book.friction_j = -book.tangential_j - (seen.shear_stored_j - book.shear_stored_j);
            book.shear_stored_j = seen.shear_stored_j;
        }
        self.is_under_way = true;
    }

    /// What contacts have given more than they took, those that go on included (J).
    fn gained_j(&self) -> f64 {
        self.all.iter().fold(self.gained_j, |sum_j, book| sum_j + greater(book.since_began_j, 0.0))
    }

    fn index_of(&mut self, contact: &Contact) -> usize {
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let fender = contact.fender.map(|id| id.0 as usize);
        let same = |b: &ContactEnergy| b.bodies == bodies && b.fender == fender;
        self.all.iter().position(same).unwrap_or_else(|| {
            // Who is in contact at the start may have been put there with energy stored.
            let since_began_j = if self.is_under_way { 0.0 } else { f64::NEG_INFINITY };
            self.all.push(ContactEnergy {
                bodies,
                fender,
                since_began_j,
                ..ContactEnergy::default()
            });
            self.seen.push(Seen { now: true, ..Seen::default() });
            self.all.len() - 1
        })
    }
}

/// Work of a contact's mean forces along the bodies' motion.
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

/// Places of the bodies in the order in which they are added up, and their inertias and states.
type Moved<'a> = (&'a [usize], &'a [Inertia], &'a [BodyState]);

/// The ledger, step by step.
#[derive(Clone, Debug)]
pub(crate) struct Ledger {
    start_j: f64,
    pub(crate) energy: Energy,
}

impl Ledger {
    pub(crate) fn new(moved: Moved<'_>) -> Ledger {
        let kinetic_j = kinetic_j(moved);
        Ledger { start_j: kinetic_j, energy: Energy { kinetic_j, ..Energy::default() } }
    }

    /// ContactTotals one step.
    pub(crate) fn book(&mut self, moved: Moved<'_>, loads: &LoadWork, books: &ContactTotals) {
        let energy = &mut self.energy;
        energy.kinetic_j = kinetic_j(moved);
        energy.loads.add(loads);
        energy.load_work_j = energy.loads.total_j();
        (energy.stored_j, energy.shear_stored_j) = (0.0, 0.0);
        energy.contact_gained_j = books.gained_j();
        for book in &books.all {
            energy.contact_taken_j += greater(-(book.normal_j + book.tangential_j), 0.0);
            energy.normal_work_j += book.normal_j;
            energy.tangential_work_j += book.tangential_j;
            energy.stored_j += book.stored_j;
            energy.shear_stored_j += book.shear_stored_j;
            energy.hysteresis_j += book.hysteresis_j;
            energy.damping_j += book.damping_j;
            energy.restitution_j += book.restitution_j;
            energy.friction_j += book.friction_j;
            energy.contact_residual_j += book.residual_j;
        }
        let work_j = energy.load_work_j + energy.normal_work_j + energy.tangential_work_j;
        energy.residual_j = energy.kinetic_j - self.start_j - work_j;
    }
}

fn kinetic_j((order, inertias, states): Moved<'_>) -> f64 {
    order.iter().map(|&body| inertias[body].kinetic_j(&states[body])).sum()
}
