//! Energy that the contacts created in a run because of errors of the numerical method.

use core::fmt;

/// The smallest energy gain that is reported, as a share of the energy that the contacts absorbed.
pub const REPORTED_GAIN: f64 = 0.01;

/// Energy that contacts returned to the bodies beyond what the contacts had absorbed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnergyGain {
    /// The excess (J).
    pub gained_j: f64,
    /// Energy that the contacts absorbed in the run (J).
    pub taken_j: f64,
}

impl EnergyGain {
    /// Writes the energy gain as one sentence that begins with a capital letter.
    pub fn sentence(&self) -> String {
        let words = self.to_string();
        let mut letters = words.chars();
        letters
            .next()
            .map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
    }
}

impl fmt::Display for EnergyGain {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "contacts returned {:.1} kJ more than they absorbed, ", self.gained_j / 1e3)?;
        // A contact that absorbs hardly anything may return any multiple of it.
        match self.gained_j < 10.0 * self.taken_j {
            true => {
                write!(f, "{:.0} % of the absorbed energy", 100.0 * self.gained_j / self.taken_j)?
            }
            false => write!(f, "over ten times the absorbed energy")?,
        }
        f.write_str(
            ": the method creates energy at this time step; use a shorter `step` or `method = \"coupled\"`",
        )
    }
}
