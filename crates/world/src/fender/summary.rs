//! What one fender did in a run.

use super::FenderSetup;
use crate::chain::ChainSummary;
use crate::panel::PanelSummary;

/// Summary of one fender after a run. Peaks are those within the steps, sub-steps included.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSummary {
    /// Index into [`crate::setup::Setup::fenders`].
    pub fender: usize,
    /// Start of the first step in which it was touched (s).
    pub first_touch_s: f64,
    /// Normal speed V_n in that step (m/s), positive when approaching.
    pub approach_speed_mps: f64,
    /// Angle between face and hull in that step (rad).
    pub approach_angle_rad: f64,
    /// How it meets a hull by height; `None` for hulls with one outline.
    pub hull: Option<HullMet>,
    /// Factor on its reaction, fixed at first touch: temperature, tolerance, speed and angle.
    pub factor: f64,
    /// Largest deflection (m).
    pub peak_deflection_m: f64,
    /// Start of the step of the largest deflection (s).
    pub peak_deflection_at_s: f64,
    /// Largest reaction along its axis (N).
    pub peak_reaction_n: f64,
    /// Start of the step of the largest reaction (s). For a fender that buckles it comes before the largest
    /// deflection.
    pub peak_reaction_at_s: f64,
    /// Largest energy absorbed along the loading curve (J), the quantity that catalogues rate.
    pub peak_energy_j: f64,
    /// Start of the step of that energy (s).
    pub peak_energy_at_s: f64,
    /// Largest pressure on the hull (N/m²), by [`FenderSetup::hull_pressure_npm2`].
    pub peak_hull_pressure_npm2: Option<f64>,
    /// Energy capacity with the correction factors (J).
    pub capacity_j: Option<f64>,
    /// Peak energy over the capacity.
    pub share_of_rated_energy: Option<f64>,
    /// Peak reaction over the rated reaction with the correction factors.
    pub share_of_rated_reaction: Option<f64>,
    /// The same over the largest reaction of the curve up to the rated deflection: above 1 the fender is over-rated.
    pub share_of_largest_reaction: Option<f64>,
    /// Peak deflection over the rated deflection.
    pub share_of_rated_deflection: Option<f64>,
    /// Peak hull pressure over the permissible one.
    pub share_of_hull_pressure: Option<f64>,
    /// True if it was deflected beyond the start of its stop, or beyond its projection if it has none.
    pub failed: bool,
    /// Deflection in the last step; 0 if it is not touched (m).
    pub last_deflection_m: f64,
    /// Reaction in the last step; 0 if it is not touched (N).
    pub last_reaction_n: f64,
    /// Its panel, if it has one on several cones. The shares of the rated energy, reaction and deflection are then those of
    /// the most compressed cone, and the peak deflection is that cone's.
    pub panel: Option<PanelSummary>,
    /// Its chains, in the order of the set-up.
    pub chains: Vec<ChainSummary>,
}

/// How a fender meets a hull with outlines by height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullMet {
    /// Height of the first touch (m): above the keel of a floating body, above datum of a fixed one.
    pub height_m: f64,
    /// Angle by which the hull's side leans out over the fender at the first touch (rad), positive for flare.
    pub vertical_angle_rad: f64,
    /// The vertical force on the hull of the largest size: its mean over a step (N), positive up.
    pub peak_vertical_force_n: f64,
}

impl FenderSummary {
    /// Peak energy over the rated energy of the catalogue: without the factors of this run for temperature, tolerance, speed and
    /// angle. `None` without a rating.
    #[must_use]
    pub fn share_of_catalogue_energy(&self, setup: &FenderSetup) -> Option<f64> {
        let (capacity_j, rated) = self.capacity_j.zip(setup.rated)?;
        self.share_of_rated_energy.map(|share| share * capacity_j / rated.energy_j)
    }

    /// Peak reaction over the rated reaction of the catalogue, without the factors of this run. `None` without a rating.
    #[must_use]
    pub fn share_of_catalogue_reaction(&self) -> Option<f64> {
        self.share_of_rated_reaction.map(|share| share * self.factor)
    }

    /// The quantity that governs, `energy`, `deflection` or `reaction`, and its peak over the rated one; `None` without a
    /// rating.
    ///
    /// A fender that buckles reaches its rated reaction at about a third of its travel and stays near it, so its
    /// reaction governs only where it is above the largest that its curve has up to the rated deflection.
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
