//! Energy that contacts created in a run.

use core::fmt;

/// The smallest gain that is reported, as a share of the energy that the contacts absorbed.
pub(crate) const REPORTED_GAIN: f64 = 0.01;

/// Energy that contacts returned to the bodies beyond what they absorbed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGain {
    /// The excess (J).
    pub gained_j: f64,
    /// Energy that the contacts absorbed in the run (J).
    pub taken_j: f64,
}

impl fmt::Display for EnergyGain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let percent = 100.0 * self.gained_j / self.taken_j;
        write!(
            f,
            "contacts returned {:.1} kJ more than they absorbed, {percent:.0} % of the absorbed energy: the method creates energy at \
             this time step; use a shorter `step` or `method = \"coupled\"`",
            self.gained_j / 1e3
        )
    }
}
