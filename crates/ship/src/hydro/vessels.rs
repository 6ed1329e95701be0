//! A ship's data with their sources, and how well these sources are known. The data of ships are in `vessels/` at the
//! root of the repository.

use super::actuator::RateLimited;
use super::estimate::{EstimateMethod, RatioOutOfRange};
use super::mmg::Mmg;
pub use super::source::{Figure, Source, Standing};

/// Name of a vessel, and the sources of her data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Name and scale.
    pub title: String,
    /// All numbers of the vessel, with their sources.
    pub sources: Vec<Source>,
    /// The method whose formulas estimate the vessel's hull, propeller or rudder; `None` if she has data for all of
    /// them.
    pub estimate_method: Option<EstimateMethod>,
    /// Ratios of the vessel that are outside the range in which the estimating formulas were validated.
    pub outside: Vec<RatioOutOfRange>,
}

impl Origin {
    /// The estimated groups.
    pub fn estimates(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter().filter(|source| source.is_estimate)
    }
}

/// A ship ready for standard manoeuvres.
#[derive(Clone, Debug, PartialEq)]
pub struct Vessel {
    /// Name and sources.
    pub origin: Origin,
    /// Her manoeuvring model.
    pub ship: Mmg,
    /// Approach speed of the ship's standard manoeuvres (m/s); `None` if not given.
    pub approach_mps: Option<f64>,
    /// The ship's rudder, amidships, with its rate and stop.
    pub steering: RateLimited,
    /// True if the ship is a model in a tank with fresh water.
    pub is_model: bool,
    /// Length of the model (m), for a full-scale ship whose `ship` has the resistance of a model.
    pub resistance_of_model_m: Option<f64>,
}
