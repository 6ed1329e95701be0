//! Forces from other programs: the trait [`ForceProvider`], and how a late, terminated or faulty provider is handled.
//!
//! The simulation queries each provider of forces once per step. The force and moment of a reply that comes in time act
//! during the step. If a provider does not reply, its last force and moment are held for a set time and then dropped.
//! Each change in how a provider replies is reported as an event. A force or moment that is not finite or too large is
//! treated as a missing reply.

use fenderline_contact::{BodyState, Wrench};

/// A query to a provider: the state of its body at the start of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceRequest {
    /// Time at the start of the step (s).
    pub t_s: f64,
    /// Length of the step (s).
    pub step_s: f64,
    /// Position and velocity of the body.
    pub state: BodyState,
}

/// The reply of a provider.
#[derive(Clone, Debug, PartialEq)]
pub enum ForceReply {
    /// Force, and moment about the centre of gravity, for this step, in earth-fixed axes.
    Wrench(Wrench),
    /// The provider has not replied in time.
    Late,
    /// The provider has terminated; the text gives the reason.
    Dead(String),
}

/// A provider of the force on a body, which the simulation queries in each step.
///
/// ```
/// use fenderline_contact::{Wrench, vec2};
/// use fenderline_world::external::{ForceReply, ForceProvider, ForceRequest};
///
/// /// A drag proportional to the square of the speed.
/// struct Drag;
///
/// impl ForceProvider for Drag {
///     fn reply(&mut self, request: &ForceRequest) -> ForceReply {
///         let v = request.state.velocity_mps;
///         ForceReply::Wrench(Wrench { force_n: v * (-2e5 * v.length()), moment_nm: 0.0 })
///     }
/// }
/// let mut state = fenderline_contact::BodyState::default();
/// state.velocity_mps = vec2(2.0, 0.0);
/// let reply = Drag.reply(&ForceRequest { t_s: 0.0, step_s: 0.1, state });
/// assert_eq!(reply, ForceReply::Wrench(Wrench { force_n: vec2(-8e5, 0.0), moment_nm: 0.0 }));
/// ```
pub trait ForceProvider {
    /// Returns the force and moment for the coming step. The call must return within the time for which the simulation
    /// can wait.
    fn reply(&mut self, request: &ForceRequest) -> ForceReply;
}

/// An event of a provider in a step.
#[derive(Clone, Debug, PartialEq)]
pub enum ProviderEvent {
    /// The provider did not reply in time, so its last force and moment are held.
    Held,
    /// The provider has not replied for too long, so its force and moment are dropped.
    Dropped,
    /// The provider replies again.
    Resumed,
    /// The force or moment of the provider was not finite, or above 1e15 N or N·m, and was not used.
    Refused,
    /// The provider has terminated; the text gives the reason. Its last force and moment are held, then dropped.
    Died(String),
}

/// The largest force (N) or moment (N·m) that is accepted from a provider. The limit is the same as the contact
/// engine's limit for loads.
const LARGEST_LOAD: f64 = 1e15;

/// The force and moment of one provider, which are held between the provider's replies.
#[derive(Clone, Debug, PartialEq)]
pub struct HeldWrench {
    hold_s: f64,
    last: Wrench,
    silent_s: f64,
    stage: Stage,
    dead: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Stage {
    Fresh,
    Held,
    Dropped,
}

impl HeldWrench {
    /// Starts with zero force and moment. If the provider does not reply, its last force and moment are held for
    /// `hold_s` seconds.
    #[must_use]
    pub fn new(hold_s: f64) -> HeldWrench {
        HeldWrench {
            hold_s,
            last: Wrench::default(),
            silent_s: 0.0,
            stage: Stage::Fresh,
            dead: false,
        }
    }

    /// Queries the provider and returns the force and moment for this step. Events of the provider are appended to
    /// `events`.
    pub fn wrench(
        &mut self,
        provider: &mut dyn ForceProvider,
        request: &ForceRequest,
        events: &mut Vec<ProviderEvent>,
    ) -> Wrench {
        let reply = if self.dead { ForceReply::Late } else { provider.reply(request) };
        match reply {
            ForceReply::Wrench(wrench) if is_usable(&wrench) => {
                if self.stage != Stage::Fresh {
                    events.push(ProviderEvent::Resumed);
                }
                (self.last, self.silent_s, self.stage) = (wrench, 0.0, Stage::Fresh);
            }
            ForceReply::Wrench(_) => {
                events.push(ProviderEvent::Refused);
                self.no_reply(request.step_s, events);
            }
            ForceReply::Late => self.no_reply(request.step_s, events),
            ForceReply::Dead(why) => {
                self.dead = true;
                events.push(ProviderEvent::Died(why));
                self.no_reply(request.step_s, events);
            }
        }
        self.last
    }

    /// Whether the last query got no usable reply.
    #[must_use]
    pub fn is_silent(&self) -> bool {
        self.stage != Stage::Fresh
    }

    /// Handles a step in which the provider gave no usable reply.
    fn no_reply(&mut self, step_s: f64, events: &mut Vec<ProviderEvent>) {
        self.silent_s += step_s;
        if self.stage == Stage::Fresh {
            self.stage = Stage::Held;
            events.push(ProviderEvent::Held);
        }
        if self.stage == Stage::Held && self.silent_s > self.hold_s {
            self.stage = Stage::Dropped;
            self.last = Wrench::default();
            events.push(ProviderEvent::Dropped);
        }
    }
}

/// True if force and moment are finite and within [`LARGEST_LOAD`].
fn is_usable(wrench: &Wrench) -> bool {
    [wrench.force_n.x, wrench.force_n.y, wrench.moment_nm]
        .iter()
        .all(|value| value.abs() <= LARGEST_LOAD)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::vec2;

    /// A provider that gives prepared replies one after the other.
    struct Script(Vec<ForceReply>);

    impl ForceProvider for Script {
        fn reply(&mut self, _: &ForceRequest) -> ForceReply {
            self.0.remove(0)
        }
    }

    #[test]
    fn the_last_wrench_is_held_then_dropped_and_resumed() {
        let push = |n: f64| ForceReply::Wrench(Wrench { force_n: vec2(n, 0.0), moment_nm: 0.0 });
        let nan = ForceReply::Wrench(Wrench { force_n: vec2(f64::NAN, 0.0), moment_nm: 0.0 });
        let mut script = Script(vec![
            push(1.0),
            ForceReply::Late,
            nan,
            ForceReply::Late,
            push(2.0),
            ForceReply::Dead("it ended".to_owned()),
        ]);
        let request = ForceRequest { t_s: 0.0, step_s: 0.5, state: BodyState::default() };
        let mut held = HeldWrench::new(1.0);
        let mut seen = Vec::new();
        for _ in 0..9 {
            let mut events = Vec::new();
            let wrench = held.wrench(&mut script, &request, &mut events);
            seen.push((wrench.force_n.x, events));
        }
        use ProviderEvent::{Died, Dropped, Held, Refused, Resumed};
        assert_eq!(
            seen,
            [
                (1.0, vec![]),
                (1.0, vec![Held]),
                (1.0, vec![Refused]),
                (0.0, vec![Dropped]),
                (2.0, vec![Resumed]),
                (2.0, vec![Died("it ended".to_owned()), Held]),
                (2.0, vec![]),
                (0.0, vec![Dropped]),
                (0.0, vec![]),
            ]
        );
    }
}
