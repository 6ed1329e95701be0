//! A column of a table whose statistics are asked for.

use fenderline_campaign::statistics::design::{Asked, Findings};
use fenderline_campaign::table::Head;

/// A column of numbers with the statistics that were computed from it.
pub(super) struct Column<'a> {
    pub(super) file: String,
    pub(super) head: &'a Head,
    /// Empty cells.
    pub(super) missing: usize,
    /// Number of values of 0, which are left out of the statistics.
    pub(super) zeros: usize,
    pub(super) findings: Findings,
    pub(super) asked: Asked,
}
