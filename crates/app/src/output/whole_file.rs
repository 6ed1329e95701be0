//! One file that appears whole or not at all.

use std::fs;
use std::io::Write as _;
use std::path::Path;

use super::OutputError;
use super::lock::{Lock, admit};

/// Writes `bytes` to `path`. Until it is whole and on the disk it is called `NAME.part`, which one program at a time
/// may write.
///
/// # Errors
/// Bad input where the place cannot be used: it holds no regular file, or another program is writing it. A file
/// that cannot be written or renamed.
pub(crate) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), OutputError> {
    admit(path)?;
    let part = path.with_added_extension("part");
    // Dropped on the way out: removed where it is not renamed.
    let lock = Lock::take(&part, "another program is writing it")?;
    let mut file = lock.file();
    let written = file
        .set_len(0)
        .and_then(|()| file.write_all(bytes))
        .and_then(|()| file.sync_all())
        .and_then(|()| fs::rename(&part, path));
    written.map_err(|e| OutputError::new(path, e))
}

/// Makes a folder for files, where there is none.
///
/// # Errors
/// Bad input: it cannot be made.
pub(crate) fn make_folder(path: &Path) -> Result<(), OutputError> {
    fs::create_dir_all(path).map_err(|e| OutputError::refused(path, e))
}
