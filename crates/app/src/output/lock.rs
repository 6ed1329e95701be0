//! A lock file, held by one run at a time.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use fenderline_scenario::{irregular, without_following};

use super::OutputError;

/// How often a lock file is opened again if its holder removed it between opening and locking. After so many attempts
/// the folder is reported as held by another run.
const TRIES: u32 = 100;

/// An open and locked file. The lock ends with the program, however the program ends. The lock file is then removed
/// too, if that is safe.
///
/// A lock belongs to a file, not to the file's name. After locking, the program therefore checks that the name still
/// belongs to the locked file. Otherwise two runs could hold locks under one name, one of them on a file that was
/// renamed or removed.
#[derive(Debug)]
pub(super) struct Lock {
    file: File,
    path: PathBuf,
}

impl Lock {
    /// Opens and locks the file `path`, which is created if needed. Never waits. `busy` is the message if another
    /// program holds the lock.
    ///
    /// # Errors
    /// Fails if another program holds the lock, if the path is not a regular file or cannot be opened, or if the file
    /// system has no locks.
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
                        "this file system has no locks, so that another run could write here too: {e}"
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

    /// Whether the path still belongs to the locked file.
    #[cfg(unix)]
    pub(super) fn is_in_place(&self) -> bool {
        use std::os::unix::fs::MetadataExt as _;
        let (Ok(held), Ok(named)) = (self.file.metadata(), fs::symlink_metadata(&self.path)) else {
            return false;
        };
        (held.dev(), held.ino()) == (named.dev(), named.ino())
    }

    /// Whether the lock file still exists. On systems other than Unix lock files are never removed, so that the path
    /// stays that of the locked file.
    #[cfg(not(unix))]
    pub(super) fn is_in_place(&self) -> bool {
        self.path.exists()
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // Before unlocking, so that our own file is removed. A program that has the old file open finds that the name
        // has changed.
        if cfg!(unix) && self.is_in_place() {
            // An error is ignored: a lock file that nobody holds does no harm.
            let _ = fs::remove_file(&self.path);
        }
    }
}

/// Refuses a path that holds anything but a regular file: a link would be followed, a pipe would block the program, a
/// folder would be lost.
///
/// # Errors
/// Fails if the path does not hold a regular file.
pub(crate) fn admit(path: &Path) -> Result<(), OutputError> {
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
    let why = format!("the path is {what}, which fenderline does not replace");
    OutputError::refused(path, why)
}
