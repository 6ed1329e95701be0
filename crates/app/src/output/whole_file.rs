//! Writes a file that is either complete or absent.

use std::fs;
use std::io::Write as _;
use std::path::Path;

use super::OutputError;
use super::lock::{Lock, admit};

/// Writes `bytes` to `path`. Until the file is complete on the disk it is called `NAME.part`, which one program at a
/// time may write.
///
/// # Errors
/// Bad input if the path holds something other than a regular file, or if another program is writing the file. A failed
/// run if the file cannot be written or renamed.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    admit(path)?;
    let part = path.with_added_extension("part");
    // Removed when it is dropped, unless it was renamed.
    let lock = Lock::take(&part, "another program is writing this file")?;
    let mut file = lock.file();
    let written = file
        .set_len(0)
        .and_then(|()| file.write_all(bytes))
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&part, path));
    written.map_err(|e| OutputError::new(path, e))
}

/// Writes a file like [`write_whole`], but only if no file of that name exists yet.
///
/// # Errors
/// Fails like [`write_whole`], and also if the path exists already.
pub(crate) fn write_new(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    match fs::symlink_metadata(path) {
        Ok(_) => Err(OutputError::refused(path, "the file exists already, and is not replaced")),
        Err(_) => write_whole(path, bytes),
    }
}

/// Creates a folder for files, if the folder is missing.
///
/// # Errors
/// Bad input if the folder cannot be made.
pub(crate) fn make_folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(|e| OutputError::refused(path, e))
}
