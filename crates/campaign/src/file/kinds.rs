//! The words that a campaign file may use, as Rust values, and functions that several parsers of campaign files use.

use fenderline_keys::error::ScenarioError;

use super::law::LawFamily;

pub(super) type Read<T> = Result<T, ScenarioError>;

/// Largest number of cases of a full factorial campaign.
pub const MOST_CASES: usize = 1_000_000;

/// Largest number of runs of a campaign. The table of so many runs is smaller than the largest file that a report
/// reads, and one of its columns takes 0.8 GB.
pub(super) const MOST_RUNS: f64 = 1e8;

/// The words that the key `plan` may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlanKind {
    FullFactorial,
    MonteCarlo,
    LatinHypercube,
    Sobol,
    Table,
}

/// The words that the key `distribution` may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FamilyKind {
    Law(LawFamily),
    Empirical,
}

/// What a stop rule estimates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Statistic {
    /// The mean.
    Mean,
    /// A quantile.
    Quantile,
}
