//! The largest loads of a cone behind a panel, and these loads divided by the cone's part of the panel's rating.

use crate::fender::{FenderSetup, FenderSummary, Rated};

/// The largest loads of a cone by its curve with the correction factors of the run, without the panel's stop, and these
/// loads divided by the cone's part of the panel's rating.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeUse {
    /// Largest reaction of the cone (N).
    pub peak_reaction_n: f64,
    /// Energy that the cone takes up to its largest deflection (J).
    pub peak_energy_j: f64,
    /// Largest deflection of the cone divided by the rated deflection; `None` if the fender has no rating. The two
    /// shares that follow are then `None` too.
    pub share_of_rated_deflection: Option<f64>,
    /// Largest reaction of the cone divided by its rated reaction with the correction factor of the run.
    pub share_of_rated_reaction: Option<f64>,
    /// Energy of the cone divided by its capacity with the correction factors of the run.
    pub share_of_rated_energy: Option<f64>,
}

impl ConeUse {
    /// The loads of a cone with this largest deflection (m); `None` for a fender with an area law.
    #[must_use]
    pub fn of(
        setup: &FenderSetup,
        summary: &FenderSummary,
        peak_deflection_m: f64,
    ) -> Option<ConeUse> {
        let (cones, factor) = (setup.cones(), summary.factor);
        let peak = Rated::of(&setup.law, peak_deflection_m)?;
        let (peak_reaction_n, peak_energy_j) = (peak.reaction_n * factor, peak.energy_j * factor);
        let rated = setup.rated;
        let energy = |capacity_j: f64| cones * peak_energy_j / capacity_j;
        Some(ConeUse {
            peak_reaction_n,
            peak_energy_j,
            share_of_rated_deflection: rated.map(|rated| peak_deflection_m / rated.deflection_m),
            // The factor is on both.
            share_of_rated_reaction: rated.map(|rated| cones * peak.reaction_n / rated.reaction_n),
            share_of_rated_energy: summary.capacity_j.filter(|_| rated.is_some()).map(energy),
        })
    }
}
