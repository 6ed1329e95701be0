//! Panels on several cones: what they did in a run.

use fenderline_contact::number::greater;
use fenderline_contact::{Panel, PanelMotion};

use crate::fender::{FenderSetup, FenderSummary, Rated};

/// What a panel on several cones did in a run. Peaks are those within the steps, sub-steps included.
#[derive(Clone, Debug, PartialEq)]
pub struct PanelSummary {
    /// The turn about the vertical axis of the largest size (rad), positive where the right end, seen by one who looks at
    /// the face, was deflected more.
    pub peak_tilt_rad: f64,
    /// Start of the step of that turn (s).
    pub peak_tilt_at_s: f64,
    /// Deflection of the panel's middle then (m).
    pub deflection_at_peak_tilt_m: f64,
    /// The moment of the cones' reactions about the panel's middle of the largest size (N·m), positive where the right ones
    /// bore more.
    pub peak_moment_nm: f64,
    /// Start of the step of that moment (s).
    pub peak_moment_at_s: f64,
    /// The cones, in the order of the set-up.
    pub cones: Vec<ConeSummary>,
}

/// What one cone behind a panel did in a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeSummary {
    /// Its place along the panel from the middle (m).
    pub at_m: f64,
    /// Largest deflection (m).
    pub peak_deflection_m: f64,
    /// Largest stretch (m): how far the panel pulled it out.
    pub peak_stretch_m: f64,
}

impl PanelSummary {
    /// The summary of a panel that is pressed first at a time (s).
    pub fn new(panel: &Panel, t_s: f64) -> PanelSummary {
        let cone = |&at_m: &f64| ConeSummary { at_m, peak_deflection_m: 0.0, peak_stretch_m: 0.0 };
        PanelSummary {
            peak_tilt_rad: 0.0,
            peak_tilt_at_s: t_s,
            deflection_at_peak_tilt_m: 0.0,
            peak_moment_nm: 0.0,
            peak_moment_at_s: t_s,
            cones: panel.cones_m.iter().map(cone).collect(),
        }
    }

    /// Adds the panel's motion under one hull in a step.
    pub fn add(&mut self, motion: &PanelMotion, t_s: f64) {
        if motion.peak_tilt_rad.abs() > self.peak_tilt_rad.abs() {
            (self.peak_tilt_rad, self.peak_tilt_at_s) = (motion.peak_tilt_rad, t_s);
            self.deflection_at_peak_tilt_m = motion.deflection_m;
        }
        if motion.peak_moment_nm.abs() > self.peak_moment_nm.abs() {
            (self.peak_moment_nm, self.peak_moment_at_s) = (motion.peak_moment_nm, t_s);
        }
        let ends = motion.peak_deflections_m.iter().zip(&motion.least_deflections_m);
        for (cone, (&most_m, &least_m)) in self.cones.iter_mut().zip(ends) {
            cone.peak_deflection_m = greater(cone.peak_deflection_m, most_m);
            cone.peak_stretch_m = greater(cone.peak_stretch_m, -least_m);
        }
    }
}

/// What a cone took by its curve with the factor of the run, without the panel's stop, and that over the cone's own part of
/// the panel's rating.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConeUse {
    /// Largest reaction (N).
    pub peak_reaction_n: f64,
    /// Energy up to its largest deflection (J).
    pub peak_energy_j: f64,
    /// Its largest deflection over the rated one; `None` without a rating, as the others.
    pub share_of_rated_deflection: Option<f64>,
    /// The reaction over the rated one with the run's factor.
    pub share_of_rated_reaction: Option<f64>,
    /// The energy over the capacity with the run's factors.
    pub share_of_rated_energy: Option<f64>,
}

impl ConeUse {
    /// Of a cone with this largest deflection (m). `None` for a fender with an area law.
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
