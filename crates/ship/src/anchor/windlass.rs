//! The windlass of an anchor: motor, brake, and the speed at which chain runs out.

use crate::chain::{ChainGrade, ChainSize};
use crate::range::{OutOfRange, within};

/// A windlass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Windlass {
    /// Tension at which the brake renders, so that chain slips out (N).
    pub brake_n: f64,
    /// Pull up to which the windlass heaves at full speed (N). At 1.5 times the pull in continuous duty the windlass
    /// stalls.
    pub pull_n: f64,
    /// Speed at which the windlass heaves and veers chain under power (m/s).
    pub heave_mps: f64,
    /// Speed of chain that runs out when the anchor is let go (m/s).
    pub let_go_mps: f64,
}

/// Tension at which the windlass stalls, divided by its pull in continuous duty (IACS UR A3).
const OVERLOAD: f64 = 1.5;

impl Windlass {
    /// Load that the brake holds, divided by the chain's break load, if a chain stopper is fitted (IACS UR A3).
    pub const BRAKE_SHARE: f64 = 0.45;

    /// The windlass that the rules of IACS UR A3 require for a chain: a pull by diameter and grade, a speed of 0.15
    /// m/s, and a brake for 45 % of the break load. The speed of 5 m/s at which chain runs out is our assumption.
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

    /// Tension of the chain at which the windlass stalls (N).
    #[must_use]
    pub fn stall_n(&self) -> f64 {
        OVERLOAD * self.pull_n
    }

    /// Speed at which the windlass heaves against a tension (m/s). The windlass heaves at full speed up to its rated
    /// pull; beyond the pull the speed falls to zero at the stall. Between the rated pull and the stall we assume that
    /// the speed falls along a straight line.
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
        within("tension that the brake of the windlass holds [N]", self.brake_n, 1.0, 1e9)?;
        within("pull of the windlass [N]", self.pull_n, 1.0, 1e9)?;
        within("speed of the windlass [m/s]", self.heave_mps, 0.001, 5.0)?;
        within("speed of chain that runs out [m/s]", self.let_go_mps, 0.01, 20.0)?;
        Ok(())
    }
}
