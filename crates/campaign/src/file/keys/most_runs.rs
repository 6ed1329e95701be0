//! How many runs a campaign may have.

/// Most runs of a campaign. Their table is below the largest file that a report reads, and a column of it takes 0.8 GB.
pub(super) const MOST_RUNS: f64 = 1e8;
