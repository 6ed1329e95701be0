//! Words of campaign files as values, and what all readers of a campaign file share.

use fenderline_keys::error::ScenarioError;

use super::law::LawFamily;

pub(super) type Read<T> = Result<T, ScenarioError>;

/// Most cases of a full factorial.
pub const MOST_CASES: usize = 1_000_000;

/// Most runs of a campaign. Their table is below the largest file that a report reads, and a column of it takes 0.8 GB.
pub(super) const MOST_RUNS: f64 = 1e8;

/// The word of the key `plan`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlanKind {
    FullFactorial,
    MonteCarlo,
    LatinHypercube,
    Sobol,
    Table,
}

/// The word of the key `distribution`.
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
