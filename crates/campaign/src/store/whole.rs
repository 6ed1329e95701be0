//! Writes files that are either complete or absent.

use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

use crate::error::CampaignError;

/// Writes a file under another name, syncs it to the disk and renames it.
pub(super) fn write(
    path: &Path,
    fill: impl FnOnce(&mut BufWriter<File>) -> Result<(), CampaignError>,
) -> Result<(), CampaignError> {
    let mut part = path.as_os_str().to_owned();
    part.push(".part");
    let part = Path::new(&part);
    let failed = |error: std::io::Error| CampaignError::disk(path, &error);
    let written = (|| {
        let mut file = BufWriter::with_capacity(1 << 16, File::create(part).map_err(failed)?);
        fill(&mut file)?;
        file.flush().map_err(failed)?;
        file.get_ref().sync_all().map_err(failed)?;
        fs::rename(part, path).map_err(failed)
    })();
    if written.is_err() {
        // An error is ignored: the name marks the file as incomplete.
        let _ = fs::remove_file(part);
    }
    written
}
