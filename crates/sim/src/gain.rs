//! Energy that a run by the paper's method has made.

use core::fmt;

/// The least share of the energy that came into contacts that is told when contacts gave it on top.
pub(crate) const REPORTED_GAIN: f64 = 0.01;

/// What contacts gave the bodies more than they took from them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGain {
    /// Given on top (J).
    pub gained_j: f64,
    /// What came into contacts in the run (J).
    pub taken_j: f64,
}

impl fmt::Display for EnergyGain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.gained_j / self.taken_j;
        write!(
            f,
            "contacts gave the bodies {:.1} kJ more than they took, {percent:.0} % of what came into them: the paper's \
             method makes energy at this time step; take a shorter `step` or `method = \"coupled\"`",
            self.gained_j / 1e3
        )
    }
}
