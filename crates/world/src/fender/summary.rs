//! What one fender did in a run.

use super::FenderSetup;
use crate::chain::ChainSummary;
use crate::panel::PanelSummary;

/// Summary of one fender after a run. The peaks in a summary are the largest values within the steps, sub-steps
/// included.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSummary {
    /// Index of the fender in [`crate::setup::Setup::fenders`].
    pub fender: usize,
    /// Start of the first step in which the fender was touched (s).
    pub first_touch_s: f64,
    /// Normal speed V_n of the hull in the step of the first touch (m/s), positive when approaching.
    pub approach_speed_mps: f64,
    /// Angle between the fender's face and the hull in the step of the first touch (rad).
    pub approach_angle_rad: f64,
    /// How the fender meets a hull with outlines at several heights; `None` for hulls with one outline.
    pub hull: Option<HullMet>,
    /// Factor on the fender's reaction for temperature, tolerance, speed and angle, which is fixed at the first touch.
    pub factor: f64,
    /// Largest deflection of the fender (m).
    pub peak_deflection_m: f64,
    /// Start of the step with the largest deflection (s).
    pub peak_deflection_at_s: f64,
    /// Largest reaction of the fender along its axis (N).
    pub peak_reaction_n: f64,
    /// Start of the step with the largest reaction (s). A fender that buckles has its largest reaction before its
    /// largest deflection.
    pub peak_reaction_at_s: f64,
    /// Largest energy that the fender absorbed along its loading curve (J), which is the energy that catalogues rate.
    pub peak_energy_j: f64,
    /// Start of the step with the largest absorbed energy (s).
    pub peak_energy_at_s: f64,
    /// Largest pressure of the fender on the hull (N/m²), by [`FenderSetup::hull_pressure_npm2`].
    pub peak_hull_pressure_npm2: Option<f64>,
    /// Energy capacity of the fender with the correction factors (J).
    pub capacity_j: Option<f64>,
    /// Largest absorbed energy divided by the energy capacity.
    pub share_of_rated_energy: Option<f64>,
    /// Largest reaction divided by the rated reaction with the correction factors.
    pub share_of_rated_reaction: Option<f64>,
    /// Largest reaction divided by the largest reaction of the curve up to the rated deflection, with the correction
    /// factors; above 1 the reaction exceeds the rating.
    pub share_of_largest_reaction: Option<f64>,
    /// Largest deflection divided by the rated deflection.
    pub share_of_rated_deflection: Option<f64>,
    /// Largest hull pressure divided by the permissible hull pressure.
    pub share_of_hull_pressure: Option<f64>,
    /// True if the fender was deflected beyond the start of its stop, or, if it has no stop, beyond its projection.
    pub failed: bool,
    /// Deflection in the last step (m); 0 if the fender is not touched.
    pub last_deflection_m: f64,
    /// Reaction in the last step (N); 0 if the fender is not touched.
    pub last_reaction_n: f64,
    /// Summary of the fender's panel, if the fender has a panel on several cones. For a panel on several cones, the
    /// shares of the rated energy, reaction and deflection and the largest deflection are those of the most compressed
    /// cone.
    pub panel: Option<PanelSummary>,
    /// Summaries of the fender's chains, in the order of the set-up.
    pub chains: Vec<ChainSummary>,
}

/// How a fender meets a hull with outlines at several heights.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullMet {
    /// Height of the first touch (m): above the keel of a floating body, above datum for a fixed body.
    pub height_m: f64,
    /// Angle by which the hull's side leans out over the fender at the first touch (rad), positive for flare.
    pub vertical_angle_rad: f64,
    /// Vertical force on the hull, averaged over the step in which it was largest (N), positive up.
    pub peak_vertical_force_n: f64,
}

impl FenderSummary {
    /// Largest absorbed energy divided by the rated energy of the catalogue, without the factors of this run for
    /// temperature, tolerance, speed and angle. `None` without a rating.
    #[must_use]
    pub fn share_of_catalogue_energy(&self, setup: &FenderSetup) -> Option<f64> {
        let (capacity_j, rated) = self.capacity_j.zip(setup.rated)?;
        self.share_of_rated_energy.map(|share| share * capacity_j / rated.energy_j)
    }

    /// Largest reaction divided by the rated reaction of the catalogue, without the factors of this run. `None` without
    /// a rating.
    #[must_use]
    pub fn share_of_catalogue_reaction(&self) -> Option<f64> {
        self.share_of_rated_reaction.map(|share| share * self.factor)
    }

    /// The quantity of the fender that is nearest to its rated value or farthest above it (`energy`, `deflection` or
    /// `reaction`), and its largest value divided by the rated value; `None` if the fender has no rating.
    ///
    /// A fender that buckles reaches its rated reaction at about a third of its travel and stays near this reaction.
    /// Its reaction therefore governs only above the largest reaction that the curve has up to the rated deflection.
    #[must_use]
    pub fn governing(&self) -> Option<(&'static str, f64)> {
        let energy = self.share_of_rated_energy?;
        let deflection = self.share_of_rated_deflection?;
        let reaction = self.share_of_largest_reaction?;
        let mut governing = ("energy", energy);
        if deflection > governing.1 {
            governing = ("deflection", deflection);
        }
        if reaction > 1.0 && reaction > governing.1 {
            governing = ("reaction", self.share_of_rated_reaction?);
        }
        Some(governing)
    }
}
