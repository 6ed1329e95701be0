//! Campaigns: many runs of one scenario with values that are drawn from distributions, their tables and statistics.

pub mod statistics;
pub mod table;
