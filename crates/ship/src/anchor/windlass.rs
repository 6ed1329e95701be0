//! The windlass: motor, brake, and the speed of chain that runs out.

use crate::chain::{ChainGrade, ChainSize};
use crate::range::{OutOfRange, within};

/// A windlass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Windlass {
    /// Tension at which the brake renders, so that chain slips out (N).
    pub brake_n: f64,
    /// Pull up to which the windlass heaves at full speed (N). At 1.5 times this pull the windlass stalls.
    pub pull_n: f64,
    /// Speed of heaving and of veering under power (m/s).
    pub heave_mps: f64,
    /// Speed of chain that runs out when the anchor is let go (m/s).
    pub let_go_mps: f64,
}

/// Tension at which the windlass stalls, over the pull in continuous duty (IACS UR A3).
const OVERLOAD: f64 = 1.5;

impl Windlass {
    /// Load of the brake over break load of the chain, if a chain stopper is fitted (IACS UR A3).
    pub const BRAKE_SHARE: f64 = 0.45;

    /// The windlass that the rules require for a chain (IACS UR A3): pull by diameter and grade, 0.15 m/s, and a brake
    /// for 45 % of the break load. Chain runs out at 5 m/s, which is our assumption.
    #[must_use]
    pub fn of_rules(chain: &ChainSize) -> Windlass {
        let per_square_n = match chain.grade {
            ChainGrade::U1 => 37.5,
            ChainGrade::U2 => 42.5,
            _ => 47.5,
        };
        let d_mm = 1e3 * chain.diameter_m;
        Windlass {
            brake_n: Windlass::BRAKE_SHARE * chain.break_load_n(),
            pull_n: per_square_n * d_mm * d_mm,
            heave_mps: 0.15,
            let_go_mps: 5.0,
        }
    }

    /// Tension at which the windlass stalls (N).
    #[must_use]
    pub fn stall_n(&self) -> f64 {
        OVERLOAD * self.pull_n
    }

    /// Speed of heaving at a tension (m/s). The speed is the full speed up to the pull, and then falls to zero at the
    /// stall. We assume a straight line between the pull and the stall.
    #[must_use]
    pub fn heaving_mps(&self, tension_n: f64) -> f64 {
        if tension_n <= self.pull_n {
            return self.heave_mps;
        }
        if tension_n >= self.stall_n() {
            return 0.0;
        }
        self.heave_mps * (self.stall_n() - tension_n) / (self.stall_n() - self.pull_n)
    }

    pub(super) fn check(&self) -> Result<(), OutOfRange> {
        within("brake of the windlass [N]", self.brake_n, 1.0, 1e9)?;
        within("pull of the windlass [N]", self.pull_n, 1.0, 1e9)?;
        within("speed of the windlass [m/s]", self.heave_mps, 0.001, 5.0)?;
        within("speed of chain that runs out [m/s]", self.let_go_mps, 0.01, 20.0)?;
        Ok(())
    }
}
