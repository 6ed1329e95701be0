//! From a scenario file and the command line's changes to a checked scenario.

use std::path::Path;

use fenderline_scenario::Scenario;

use crate::cli::Changes;
use crate::failure::Failure;

/// Reads and checks the scenario at `path`.
///
/// # Errors
/// [`Failure::Input`] for a file that cannot be read, is too large, is not UTF-8 text, or that the
/// scenario reader refuses.
pub(crate) fn load(path: &Path, changes: &Changes) -> Result<Scenario, Failure> {
    let overrides = changes.overrides().map_err(Failure::input)?;
    Scenario::load(path, &overrides).map_err(Failure::input)
}
