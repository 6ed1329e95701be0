//! What is found on a fender.

use super::finding::Finding;
use crate::fender::{FenderSetup, FenderSummary};

impl FenderSummary {
    /// The worst that there is to say of this fender after a run; `None` if it stayed within its rating and within the
    /// permissible hull pressure.
    #[must_use]
    pub fn finding(&self, setup: &FenderSetup) -> Option<Finding> {
        let fender = self.fender;
        Some(if self.failed {
            let (at_s, deflection_m) = (self.peak_deflection_at_s, self.peak_deflection_m);
            Finding::FenderFailed { fender, at_s, deflection_m }
        } else if let Some((quantity, share)) = self.governing().filter(|(_, share)| *share > 1.0) {
            Finding::FenderOverRated { fender, quantity, share }
        } else if let Some(share) = self.share_of_hull_pressure.filter(|share| *share > 1.0) {
            Finding::HullPressure { fender, share }
        } else if setup.rated.is_none() {
            Finding::FenderNotRated { fender }
        } else {
            return None;
        })
    }
}
