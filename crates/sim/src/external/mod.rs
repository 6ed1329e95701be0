//! Forces from other programs: a trait for whoever gives them, and what happens when they are late, dead
//! or wrong.
//!
//! A provider is asked once a step. An answer in time acts through the step; without one the last answer
//! is held for a while, then dropped, and each of these is told as an event. A wrench that is not finite
//! or beyond all reason counts as no answer.

use fenderline_contact::{BodyState, Wrench};

/// What a provider is asked: the state of its body at the start of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceRequest {
    /// Time (s).
    pub t_s: f64,
    /// Length of the step (s).
    pub step_s: f64,
    /// State of the body.
    pub state: BodyState,
}

/// What a provider says.
#[derive(Clone, Debug, PartialEq)]
pub enum ForceReply {
    /// Force and moment about the centre of gravity, earth-fixed, for this step.
    Wrench(Wrench),
    /// Nothing yet.
    Late,
    /// It will not answer any more, and why.
    Dead(String),
}

/// Somebody who gives the force on a body, step by step.
///
/// ```
/// use fenderline_contact::{Wrench, vec2};
/// use fenderline_sim::external::{ForceReply, ForceProvider, ForceRequest};
///
/// /// A current that drags with the square of the speed.
/// struct Drag;
///
/// impl ForceProvider for Drag {
///     fn ask(&mut self, question: &ForceRequest) -> ForceReply {
///         let v = question.state.velocity_mps;
///         ForceReply::Wrench(Wrench { force_n: v * (-2e5 * v.length()), moment_nm: 0.0 })
///     }
/// }
/// let mut state = fenderline_contact::BodyState::default();
/// state.velocity_mps = vec2(2.0, 0.0);
/// let answer = Drag.ask(&ForceRequest { t_s: 0.0, step_s: 0.1, state });
/// assert_eq!(answer, ForceReply::Wrench(Wrench { force_n: vec2(-8e5, 0.0), moment_nm: 0.0 }));
/// ```
pub trait ForceProvider {
    /// The wrench for the step that begins now. Must come back within the time that the host can spare.
    fn ask(&mut self, question: &ForceRequest) -> ForceReply;
}

/// What happened to a provider in a step.
#[derive(Clone, Debug, PartialEq)]
pub enum ProviderEvent {
    /// It did not answer in time: its last wrench is held.
    Held,
    /// It was silent for too long: its wrench is dropped.
    Dropped,
    /// It answers again.
    Resumed,
    /// Its wrench is not finite or beyond 1e15 N or N·m: not used.
    Refused,
    /// It has ended, and why: its wrench is held, then dropped.
    Died(String),
}

/// The largest force or moment that is taken (N, N·m): that which the contact engine takes of a load.
const LARGEST_LOAD: f64 = 1e15;

/// The wrench of one provider, from step to step.
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
    /// No wrench yet. A provider that falls silent is held for `hold_s` seconds.
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

    /// Asks, and gives the wrench that acts in this step; what happened is added to `events`.
    pub fn ask(
        &mut self,
        provider: &mut dyn ForceProvider,
        question: &ForceRequest,
        events: &mut Vec<ProviderEvent>,
    ) -> Wrench {
        let answer = if self.dead { ForceReply::Late } else { provider.ask(question) };
        match answer {
            ForceReply::Wrench(wrench) if can_act(&wrench) => {
                if self.stage != Stage::Fresh {
                    events.push(ProviderEvent::Resumed);
                }
                (self.last, self.silent_s, self.stage) = (wrench, 0.0, Stage::Fresh);
            }
            ForceReply::Wrench(_) => {
                events.push(ProviderEvent::Refused);
                self.without(question.step_s, events);
            }
            ForceReply::Late => self.without(question.step_s, events),
            ForceReply::Dead(why) => {
                self.dead = true;
                events.push(ProviderEvent::Died(why));
                self.without(question.step_s, events);
            }
        }
        self.last
    }

    /// A step without a wrench that can be used.
    fn without(&mut self, step_s: f64, events: &mut Vec<ProviderEvent>) {
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

fn can_act(wrench: &Wrench) -> bool {
    [wrench.force_n.x, wrench.force_n.y, wrench.moment_nm]
        .iter()
        .all(|value| value.abs() <= LARGEST_LOAD)
}

#[cfg(test)]
mod tests {
    use super::*;
    use fenderline_contact::vec2;

    /// Plays answers in turn.
    struct Script(Vec<ForceReply>);

    impl ForceProvider for Script {
        fn ask(&mut self, _: &ForceRequest) -> ForceReply {
            self.0.remove(0)
        }
    }

    #[test]
    fn the_last_wrench_is_held_then_dropped_and_taken_up_again() {
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
        let question = ForceRequest { t_s: 0.0, step_s: 0.5, state: BodyState::default() };
        let mut provided = HeldWrench::new(1.0);
        let mut seen = Vec::new();
        for _ in 0..9 {
            let mut events = Vec::new();
            let wrench = provided.ask(&mut script, &question, &mut events);
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
