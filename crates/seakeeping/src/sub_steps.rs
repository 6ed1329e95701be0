//! Finds the time at which the loads of a step act, if contact takes several sub-steps.
//!
//! The contact engine's leapfrog leaves a velocity that belongs to the middle of the last of n sub-steps, h/2n before
//! the end of the step. The loads of the next step are held constant over that step. The loads of a step change the
//! velocities from h/2n before its start to h/2n before its end. The middle of the time for which a load acts is
//! (h/2)(1 − 1/n) after the start of the step. A load computed for the start of the step would act too late by (h/2)(1
//! − 1/n). Restoring forces that act late add energy: a line of stiffness k would have a negative damping of k times
//! the delay. Lines therefore pull at the place that the ship has at the middle of the time for which they act, and
//! waves act with their force at that time. Heave, roll and pitch take no sub-steps: their velocities and places belong
//! to the middles of whole steps, and nothing changes for them.
//!
//! Under a held load the second difference of places is h²((1 − r) a + r a₋), where a and a₋ are the accelerations of
//! this step and the last, and r = ½(1 − 1/n). At a frequency ω the second difference of places is √(1 − (1 − 1/n²)
//! sin²(ωh/2)) times the acceleration (and h²). The force of the waves is divided by the factor √(1 − (1 − 1/n²)
//! sin²(ωh/2)) of held loads. A free ship therefore moves as the equation of motion says, whatever the number of
//! sub-steps.

/// The sub-steps of contact in the last step. The sub-steps of contact in the last step are the best guess for those of
/// the next step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SubSteps {
    /// How long after the start of the step the middle of the time lies for which its loads act (s).
    pub ahead_s: f64,
    /// The number 1 − 1/n², where n is the number of sub-steps.
    pub held: f64,
}

impl SubSteps {
    /// Finds the sub-steps of a step from the time (s) by which a body's velocity lags behind its position. The lag is
    /// negative if the velocity is not the contact engine's.
    pub fn of(step_s: f64, lag_s: f64) -> SubSteps {
        let lag_share = 2.0 * lag_s / step_s;
        if lag_share > 0.0 && lag_share < 1.0 {
            SubSteps { ahead_s: 0.5 * step_s - lag_s, held: 1.0 - lag_share * lag_share }
        } else {
            SubSteps::default()
        }
    }

    /// The factor by which the force of waves of a frequency is multiplied; `squared_sine` is sin²(ωh/2).
    pub fn gain(self, squared_sine: f64) -> f64 {
        if self.held > 0.0 { 1.0 / (1.0 - self.held * squared_sine).sqrt() } else { 1.0 }
    }
}
