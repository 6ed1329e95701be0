//! When the loads of a step act, where contact takes several sub-steps.
//!
//! The engine's leapfrog leaves a velocity in the middle of the last of n sub-steps, h/2n before the end of the step. The loads of the
//! next step, which are held over it, so take the velocities from h/2n before its start to h/2n before its end: their middle is
//! (h/2)(1 − 1/n) after its start. A load of the start of the step would act by that much too late. Late restoring forces feed energy:
//! a line of stiffness k would have a negative damping of k times the delay. So lines pull at the place that the ship has in
//! the middle, and waves act with their force at that time. For heave, roll and pitch, which take no sub-steps, velocities and
//! places are those of the same middles, and nothing changes.
//!
//! Under a held load the second difference of places is h²((1 − r) a + r a₋), with a and a₋ the accelerations of this step and the
//! last and r = ½(1 − 1/n). At a frequency ω this is √(1 − (1 − 1/n²) sin²(ωh/2)) times the acceleration, by which the waves' force is
//! divided. So a free ship moves as the equation says, whatever the sub-steps.

/// The sub-steps of contact in the last step, which is the best guess for the next.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SubSteps {
    /// How long after the start of the step the middle of the time is for which loads act (s).
    pub ahead_s: f64,
    /// 1 − 1/n².
    pub held: f64,
}

impl SubSteps {
    /// Of a step, for a body whose velocity lags behind its place by a time (s); negative where it is not the engine's.
    pub fn of(step_s: f64, lag_s: f64) -> SubSteps {
        let lag_share = 2.0 * lag_s / step_s;
        if lag_share > 0.0 && lag_share < 1.0 {
            SubSteps { ahead_s: 0.5 * step_s - lag_s, held: 1.0 - lag_share * lag_share }
        } else {
            SubSteps::default()
        }
    }

    /// What the waves' force of a frequency is multiplied by; `squared_sine` is sin²(ωh/2).
    pub fn gain(self, squared_sine: f64) -> f64 {
        if self.held > 0.0 { 1.0 / (1.0 - self.held * squared_sine).sqrt() } else { 1.0 }
    }
}
