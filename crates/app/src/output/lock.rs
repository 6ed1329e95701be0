//! A file that one run at a time holds.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use fenderline_scenario::{irregular, without_following};

use super::OutputError;

/// How often a lock file is opened anew that its holder took away in the meantime. Each time another run came to
/// its end between two of our calls: who loses so often is told that another run is at work, which is so.
const TRIES: u32 = 100;

/// An open and locked file. The lock goes when the program does, however that ends; the file goes with it where
/// that is safe.
///
/// A lock holds a file, not its name. So after it was had, the name is asked whether it is still that file's: else
/// two runs could hold the lock of one name, one on a file that was renamed or removed.
#[derive(Debug)]
pub(super) struct Lock {
    file: File,
    path: PathBuf,
}

impl Lock {
    /// Opens and locks `path`, which is made where need be; never waits. `busy` tells what it means that another
    /// holds it.
    ///
    /// # Errors
    /// Bad input: another holds it; it is no regular file; it cannot be opened; the file system has no locks.
    pub(super) fn take(path: &Path, busy: &str) -> Result<Lock, OutputError> {
        for _ in 0..TRIES {
            admit(path)?;
            let mut options = without_following();
            let file = options
                .read(true)
                .write(true)
                .create(true)
                .truncate(false)
                .open(path)
                .map_err(|e| OutputError::refused(path, e))?;
            let opened = file.metadata().map_err(|e| OutputError::refused(path, e))?;
            if let Some(what) = irregular(opened.file_type()) {
                return Err(not_ours(path, what));
            }
            match file.try_lock() {
                Ok(()) => {}
                Err(TryLockError::WouldBlock) => return Err(OutputError::refused(path, busy)),
                Err(TryLockError::Error(e)) => {
                    let why = format!(
                        "no run can be sure to be alone here, as this file system has no locks: {e}"
                    );
                    return Err(OutputError::refused(path, why));
                }
            }
            let lock = Lock { file, path: path.to_owned() };
            if lock.is_in_place() {
                return Ok(lock);
            }
        }
        Err(OutputError::refused(path, busy))
    }

    /// The file.
    pub(super) fn file(&self) -> &File {
        &self.file
    }

    /// Whether the name is still that of the locked file.
    #[cfg(unix)]
    pub(super) fn is_in_place(&self) -> bool {
        use std::os::unix::fs::MetadataExt as _;
        let (Ok(held), Ok(named)) = (self.file.metadata(), fs::symlink_metadata(&self.path)) else {
            return false;
        };
        (held.dev(), held.ino()) == (named.dev(), named.ino())
    }

    /// Elsewhere a lock's file is never taken away, so that nothing comes between a name and its file.
    #[cfg(not(unix))]
    pub(super) fn is_in_place(&self) -> bool {
        self.path.exists()
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Before the lock is let go, so that it is ours that is removed. Who waits with the old file open finds
        // out that the name is no longer its.
        if cfg!(unix) && self.is_in_place() {
            // Nothing better can be done with an error: a lock file that nobody holds keeps nobody out.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Refuses to write where something lies that no run leaves: it would be followed, waited for or lost.
///
/// # Errors
/// Bad input: what lies under the name is no regular file.
pub(super) fn admit(path: &Path) -> Result<(), OutputError> {
    match fs::symlink_metadata(path) {
        Ok(there) => match irregular(there.file_type()) {
            Some(what) => Err(not_ours(path, what)),
            None => Ok(()),
        },
        Err(e) if e.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(e) => Err(OutputError::refused(path, e)),
    }
}

fn not_ours(path: &Path, what: &str) -> OutputError {
    let why = format!("it is {what}, which fenderline did not write and does not replace");
    OutputError::refused(path, why)
}
