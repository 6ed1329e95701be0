//! How an estimate is reported: quantities, formula and source.

use crate::hydro::source::{Figure, Source, Standing};

/// Makes the report of an estimate.
pub(super) fn estimate(
    group: &str,
    figures: Vec<Figure>,
    source: &str,
    standing: Standing,
) -> Source {
    Source {
        group: group.to_owned(),
        figures,
        source: source.to_owned(),
        standing,
        is_estimate: true,
    }
}
