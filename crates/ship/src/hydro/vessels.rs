//! A ship's data with their sources and how well these are known. The data themselves are in `vessels/` at the root of
//! the repository.

use super::actuator::RateLimited;
use super::estimate::{EstimateMethod, RatioOutOfRange};
use super::mmg::Mmg;
pub use super::source::{Figure, Source, Standing};

/// Name of a vessel, and the sources of her data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// Name and scale.
    pub title: String,
    /// All her numbers with their sources.
    pub sources: Vec<Source>,
    /// The formulas that estimate her hull, propeller or rudder; `None` if she has data for all of them.
    pub estimate_method: Option<EstimateMethod>,
    /// Ratios outside the range in which those formulas were validated.
    pub outside: Vec<RatioOutOfRange>,
}

impl Origin {
    /// The estimated groups.
    pub fn estimates(&self) -> impl Iterator<Item = &Source> {
        self.sources.iter().filter(|source| source.is_estimate)
    }
}

/// A ship ready for manoeuvres.
#[derive(Clone, Debug, PartialEq)]
pub struct Vessel {
    /// Name and sources.
    pub origin: Origin,
    /// Her manoeuvring model.
    pub ship: Mmg,
    /// Approach speed of the standard manoeuvres (m/s); `None` if not given.
    pub approach_mps: Option<f64>,
    /// Rudder amidships, with its rate and stop.
    pub steering: RateLimited,
    /// True for a model in a tank with fresh water.
    pub is_model: bool,
    /// For a full-scale ship whose `ship` has the resistance of a model: the length of the model (m).
    pub resistance_of_model_m: Option<f64>,
}
