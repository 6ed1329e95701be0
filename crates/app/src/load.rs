//! From a scenario file and the command line's changes to a checked scenario.

use std::fs::File;
use std::io::Read as _;
use std::path::Path;

use fenderline_scenario::Scenario;

use crate::cli::Changes;
use crate::failure::Failure;

/// Scenario files above this size are not read [bytes].
const LARGEST_FILE: u64 = 16 << 20;

/// Reads and checks the scenario at `path`.
///
/// # Errors
/// [`Failure::Input`] for a file that cannot be read, is too large, is no UTF-8 text, or that the
/// scenario reader refuses.
pub(crate) fn load(path: &Path, changes: &Changes) -> Result<Scenario, Failure> {
    let overrides = changes.overrides().map_err(Failure::input)?;
    let text =
        read(path).map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
    // What the scenario names lies beside it.
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = path.display().to_string();
    Scenario::parse_among(&text, &name, &overrides, &mut |file| read(&folder.join(file)))
        .map_err(Failure::input)
}

/// The text of a file, or its name and why there is none.
pub(crate) fn read(path: &Path) -> Result<String, String> {
    let name = path.display();
    let cannot = |e: &dyn core::fmt::Display| format!("{name}: {e}");
    let mut bytes = Vec::new();
    // One byte more than allowed tells a file that is too large, be it an endless one.
    File::open(path)
        .and_then(|file| file.take(LARGEST_FILE + 1).read_to_end(&mut bytes))
        .map_err(|e| cannot(&e))?;
    if bytes.len() as u64 > LARGEST_FILE {
        return Err(cannot(&format_args!(
            "it is larger than {} MiB, which no scenario needs",
            LARGEST_FILE >> 20
        )));
    }
    String::from_utf8(bytes).map_err(|e| {
        let at = e.utf8_error().valid_up_to();
        let line = e.as_bytes()[..at].iter().filter(|b| **b == b'\n').count() + 1;
        cannot(&format_args!("line {line} is not UTF-8 text"))
    })
}
