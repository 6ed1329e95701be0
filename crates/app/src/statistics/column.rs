//! A column of a table.

use fenderline_campaign::statistics::design::{Asked, Findings};
use fenderline_campaign::table::Head;

/// A column with what was found about it.
pub(super) struct Column<'a> {
    pub(super) file: String,
    pub(super) head: &'a Head,
    /// Empty cells.
    pub(super) missing: usize,
    /// Values of 0 that are in no statistics.
    pub(super) zeros: usize,
    pub(super) findings: Findings,
    pub(super) asked: Asked,
}
