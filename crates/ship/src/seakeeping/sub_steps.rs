//! The time at which the loads of a step act, if contact takes several sub-steps.
//!
//! The engine's leapfrog leaves a velocity that belongs to the middle of the last of n sub-steps, h/2n before the end
//! of the step. The loads of the next step are held constant over it. The loads take the velocities from h/2n before
//! its start to h/2n before its end. The middle of this time is (h/2)(1 − 1/n) after the start of the step. A load
//! computed for the start of the step would act too late by this time. Late restoring forces add energy: a line of
//! stiffness k would have a negative damping of k times the delay. So lines pull at the place that the ship has at the
//! middle of this time, and waves act with their force at that time. Heave, roll and pitch take no sub-steps: their
//! velocities and places belong to the same middles, and nothing changes.
//!
//! Under a held load the second difference of places is h²((1 − r) a + r a₋), with a and a₋ the accelerations of this
//! step and the last, and r = ½(1 − 1/n). At a frequency ω this is √(1 − (1 − 1/n²) sin²(ωh/2)) times the acceleration.
//! The force of the waves is divided by this factor. So a free ship moves as the equation says, whatever the number of
//! sub-steps.

/// The sub-steps of contact in the last step. These sub-steps are the best guess for the next step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SubSteps {
    /// How long after the start of the step the middle of the time lies for which loads act (s).
    pub ahead_s: f64,
    /// The number 1 − 1/n².
    pub held: f64,
}

impl SubSteps {
    /// The sub-steps of a step, for a body whose velocity lags behind its position by a time (s). The time is negative
    /// if the velocity is not the engine's.
    pub fn of(step_s: f64, lag_s: f64) -> SubSteps {
        let lag_share = 2.0 * lag_s / step_s;
        if lag_share > 0.0 && lag_share < 1.0 {
            SubSteps { ahead_s: 0.5 * step_s - lag_s, held: 1.0 - lag_share * lag_share }
        } else {
            SubSteps::default()
        }
    }

    /// The factor on the force of waves of a frequency; `squared_sine` is sin²(ωh/2).
    pub fn gain(self, squared_sine: f64) -> f64 {
        if self.held > 0.0 { 1.0 / (1.0 - self.held * squared_sine).sqrt() } else { 1.0 }
    }
}
