//! Checks whether a body in the host accelerates under the wrenches as its mass in the model says.
//!
//! Over a whole contact, the momentum change M Δv of a body equals the impulse of the wrenches, if the impulse of the
//! other loads is small. A contact is evaluated under four conditions: a step without a wrench comes before and after
//! the contact, the contact takes less than a minute, the contact changes the body's speed noticeably, and the loads
//! are a small share of the contact's impulse. A ship at rest, or a ship whose load changes suddenly, gives no
//! information about her mass.

use crate::host::inertia;
use crate::host::past_step::PastStep;
use crate::host::velocity::Velocity;
use crate::maths::number::greater;
use crate::maths::vec2::Vec2;
use crate::model::body::{Body, Mobility};
use crate::state::body_state::BodyState;
use crate::state::report::Wrench;

/// Longest contact that is evaluated (s), and smallest change of the body's speed in it (m/s).
const LONGEST_S: f64 = 60.0;
const LEAST_MPS: f64 = 0.02;

/// Largest share of the loads in the impulse of a contact, and largest relative error of the body's response.
const LOADS: f64 = 0.1;
const OFF: f64 = 0.2;

/// The response of a body to the wrenches since the body was last free of contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Answers {
    /// Velocity of the body and load on it at the end of the last step without a wrench; `None` if there was no such
    /// step.
    pub(super) began: Option<(Velocity, Vec2)>,
    /// Impulse Σ W Δt (N·s) and time Σ Δt (s) of the wrenches since the last step without a wrench.
    pub(super) impulse_ns: Vec2,
    pub(super) time_s: f64,
    /// True if a mismatch of the mass was reported.
    pub(super) reported: bool,
}

impl Answers {
    /// Adds a step of the host, given by the input states before and after the step. Returns true if the step shows a
    /// wrong mass, at most once for a body.
    pub(super) fn note(
        &mut self,
        body: &Body,
        (before, after): (&BodyState, &BodyState),
        given: &PastStep,
        load: &Wrench,
    ) -> bool {
        if self.reported || body.mobility == Mobility::Fixed {
            return false;
        }
        if given.wrench != Wrench::default() {
            self.impulse_ns += given.wrench.force_n * given.step_s;
            self.time_s += given.step_s;
            return false;
        }
        self.reported = self.differs(body, before, load.force_n);
        let reported = self.reported;
        *self = Answers {
            began: Some((Velocity::of(after), load.force_n)),
            reported,
            ..Answers::default()
        };
        reported
    }

    /// Evaluates a contact that has ended: returns true if the body's response does not match its mass.
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

    /// Starts the check anew, after the host has teleported the body.
    pub(super) fn forget(&mut self) {
        *self = Answers { reported: self.reported, ..Answers::default() };
    }
}
