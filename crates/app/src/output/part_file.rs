//! Files that appear complete or not at all.

use std::fs::{self, File, OpenOptions, TryLockError};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use super::{OutputError, RESULT_FILES, SUMMARY};

/// A file under its `.part` name; removed when it is dropped before it is whole.
pub(super) struct PartFile {
    file: BufWriter<File>,
    part: PathBuf,
    is_whole: bool,
}

impl PartFile {
    fn new(file: File, part: PathBuf) -> PartFile {
        PartFile { file: BufWriter::with_capacity(1 << 16, file), part, is_whole: false }
    }

    /// The name on the disk while it is being written.
    pub(super) fn path(&self) -> &Path {
        &self.part
    }

    /// Writes all of `bytes`.
    pub(super) fn put(&mut self, bytes: &[u8]) -> Result<(), OutputError> {
        self.file.write_all(bytes).map_err(|e| OutputError::new(&self.part, e))
    }

    /// Brings the content to the disk. The file keeps its `.part` name until [`Folder::publish`].
    pub(super) fn seal(mut self) -> Result<Sealed, OutputError> {
        let synced = self.file.flush().and_then(|()| self.file.get_ref().sync_all());
        synced.map_err(|e| OutputError::new(&self.part, e))?;
        self.is_whole = true;
        Ok(Sealed { part: self.part.clone(), is_published: false })
    }
}

impl Write for PartFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for PartFile {
    fn drop(&mut self) {
        if !self.is_whole {
            // Nothing better can be done with an error here: the `.part` name already says it.
            let _ = fs::remove_file(&self.part);
        }
    }
}

/// A file that is whole on the disk under its `.part` name; removed when it is dropped before it
/// is published.
pub(crate) struct Sealed {
    part: PathBuf,
    is_published: bool,
}

impl Sealed {
    fn final_path(&self) -> PathBuf {
        self.part.with_extension("")
    }
}

impl Drop for Sealed {
    fn drop(&mut self) {
        if !self.is_published {
            let _ = fs::remove_file(&self.part);
        }
    }
}

/// The folder of a run's results, held by one run at a time.
pub(crate) struct Folder {
    path: PathBuf,
    /// Open and locked from start to end: its lock keeps a second run out of the folder, and goes
    /// when the program does, however that ends.
    summary: PartFile,
}

impl Folder {
    /// Opens the folder, which it creates where need be, and removes the results of an earlier
    /// run from it: those files only that a run writes.
    ///
    /// # Errors
    /// A folder that cannot be created or written, or in which another run is at work.
    pub(crate) fn open(path: &Path) -> Result<Folder, OutputError> {
        fs::create_dir_all(path).map_err(|e| OutputError::new(path, e))?;
        let summary = open_locked(path.join(part_name(SUMMARY)))?;
        for name in RESULT_FILES {
            // The mark of completeness is the first to go.
            remove(&path.join(name))?;
            if name != SUMMARY {
                remove(&path.join(part_name(name)))?;
            }
        }
        Ok(Folder { path: path.to_owned(), summary })
    }

    /// Starts `name`, under its `.part` name.
    pub(super) fn create(&self, name: &str) -> Result<PartFile, OutputError> {
        let part = self.path.join(part_name(name));
        let file = File::create(&part).map_err(|e| OutputError::new(&part, e))?;
        Ok(PartFile::new(file, part))
    }

    /// Writes the summary and gives all files their final names, the summary last.
    pub(super) fn publish(
        mut self,
        files: impl IntoIterator<Item = Sealed>,
        summary: &[u8],
    ) -> Result<(), OutputError> {
        self.summary.put(summary)?;
        let summary = self.summary.seal()?;
        let mut published = Vec::new();
        for mut file in files.into_iter().chain([summary]) {
            let target = file.final_path();
            if let Err(e) = fs::rename(&file.part, &target) {
                for path in published {
                    let _ = fs::remove_file(path);
                }
                return Err(OutputError::new(&target, e));
            }
            file.is_published = true;
            published.push(target);
        }
        sync_folder(&self.path)
    }
}

fn part_name(name: &str) -> String {
    format!("{name}.part")
}

fn open_locked(part: PathBuf) -> Result<PartFile, OutputError> {
    let error = |e: &dyn core::fmt::Display| OutputError::new(&part, e);
    let file = OpenOptions::new()
        .write(true)
        .create(true)
        .truncate(false)
        .open(&part)
        .map_err(|e| error(&e))?;
    match file.try_lock() {
        Err(TryLockError::WouldBlock) => {
            return Err(error(&"another run is writing to this folder"));
        }
        // A file system without locks: the run goes on without the guard.
        Ok(()) | Err(TryLockError::Error(_)) => {}
    }
    file.set_len(0).map_err(|e| error(&e))?;
    Ok(PartFile::new(file, part))
}

fn remove(path: &Path) -> Result<(), OutputError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => {
            Err(OutputError::new(path, format_args!("an earlier result cannot be removed: {e}")))
        }
        _ => Ok(()),
    }
}

/// Makes the new names last through a power cut, where the system can do that for a folder.
#[cfg(unix)]
fn sync_folder(path: &Path) -> Result<(), OutputError> {
    File::open(path).and_then(|folder| folder.sync_all()).map_err(|e| OutputError::new(path, e))
}

#[cfg(not(unix))]
fn sync_folder(_path: &Path) -> Result<(), OutputError> {
    Ok(())
}
