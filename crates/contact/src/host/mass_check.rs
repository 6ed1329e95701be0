//! Does a body answer wrenches as its mass in the model says?
//!
//! Seen in a hit: M Δv over all of a contact is the impulse given, where loads did next to nothing meanwhile. A
//! contact counts where it came from a step without a wrench and ended in one, took less than a minute, gave the body a speed
//! worth the name, and had the same loads before as after, which were a small part of it. A ship at rest, or
//! one that is pushed harder all of a sudden, tells nothing of her mass.

use crate::host::cosim::Given;
use crate::host::inertia;
use crate::host::steering::Velocity;
use crate::model::{Body, Mobility};
use crate::number::greater;
use crate::report::Wrench;
use crate::state::BodyState;
use crate::vec2::Vec2;

/// Longest contact that tells something (s), and least speed that it gives (m/s).
const LONGEST_S: f64 = 60.0;
const LEAST_MPS: f64 = 0.02;

/// Largest share of the contact's impulse that loads may have, and by which the answer may be off.
const LOADS: f64 = 0.1;
const OFF: f64 = 0.2;

/// What is remembered of a body's answers.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Answers {
    /// Velocity and load at the end of the last step without a wrench, where there was one.
    pub(super) began: Option<(Velocity, Vec2)>,
    /// Σ W Δt (N·s) and Σ Δt (s) since.
    pub(super) impulse_ns: Vec2,
    pub(super) time_s: f64,
    /// That it differs was told.
    pub(super) told: bool,
}

impl Answers {
    /// Goes on with a step of the host, from one state shown to the next; true where the body is found to answer
    /// otherwise, which is so once.
    pub(super) fn note(
        &mut self,
        body: &Body,
        (before, after): (&BodyState, &BodyState),
        given: &Given,
        load: &Wrench,
    ) -> bool {
        if self.told || body.mobility == Mobility::Fixed {
            return false;
        }
        if given.wrench != Wrench::default() {
            self.impulse_ns += given.wrench.force_n * given.step_s;
            self.time_s += given.step_s;
            return false;
        }
        self.told = self.differs(body, before, load.force_n);
        let told = self.told;
        *self = Answers {
            began: Some((Velocity::of(after), load.force_n)),
            told,
            ..Answers::default()
        };
        told
    }

    /// After a contact has ended.
    fn differs(&self, body: &Body, now: &BodyState, load_n: Vec2) -> bool {
        let Some((velocity, load_before_n)) = self.began else { return false };
        let impulse_ns = self.impulse_ns.length();
        let loads_ns = greater(load_n.length(), load_before_n.length()) * self.time_s;
        if self.time_s == 0.0 || self.time_s > LONGEST_S || loads_ns > LOADS * impulse_ns {
            return false;
        }
        let change = Velocity::of(now).minus(velocity);
        let answer_ns = inertia::impulse_for(&body.mobility, now, change).force_n;
        let share = answer_ns.dot(self.impulse_ns) / (impulse_ns * impulse_ns);
        change.linear_mps.length() > LEAST_MPS && (share - 1.0).abs() > OFF
    }

    /// The host has moved the body: what came before tells nothing.
    pub(super) fn forget(&mut self) {
        *self = Answers { told: self.told, ..Answers::default() };
    }
}
