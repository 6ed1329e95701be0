//! Describes one of the sub-steps of a step.

/// Length of a sub-step, and its place in the step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SubStep {
    /// Number of the sub-step in the step, counted from 0.
    number: u32,
    /// Number of sub-steps into which the step is divided.
    count: u32,
    /// Length of the sub-step (s).
    pub(crate) h: f64,
    /// Length of the sub-step, divided by the length of the step.
    pub(crate) share: f64,
}

impl SubStep {
    /// The sub-step of a step that has only one sub-step.
    pub(crate) fn whole(step_s: f64) -> SubStep {
        SubStep { number: 0, count: 1, h: step_s, share: 1.0 }
    }

    /// All `count` sub-steps of a step, in their order.
    pub(crate) fn all(count: u32, step_s: f64) -> impl Iterator<Item = SubStep> {
        let (h, share) = (step_s / f64::from(count), 1.0 / f64::from(count));
        (0..count).map(move |number| SubStep { number, count, h, share })
    }

    pub(crate) fn is_first(&self) -> bool {
        self.number == 0
    }

    pub(crate) fn is_last(&self) -> bool {
        self.number + 1 == self.count
    }

    /// Returns true if this sub-step is the whole step.
    pub(crate) fn is_only(&self) -> bool {
        self.count == 1
    }
}
