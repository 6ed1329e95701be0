//! Files that are complete or absent.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fenderline_scenario::without_following;

use super::lock::{Lock, admit};
use super::{OutputError, SUMMARY, result_files};

/// Name of the file whose lock keeps a second run out of the results folder. It is never renamed.
const LOCK: &str = ".fenderline.lock";

/// A file under its `.part` name; removed if it is dropped before it is complete.
pub(super) struct PartFile {
    file: BufWriter<File>,
    part: PathBuf,
    is_whole: bool,
    /// Keeps the folder locked until the last of its files is finished.
    lock: Arc<Lock>,
}

impl PartFile {
    fn new(file: File, part: PathBuf, lock: Arc<Lock>) -> PartFile {
        PartFile { file: BufWriter::with_capacity(1 << 16, file), part, is_whole: false, lock }
    }

    /// Name of the file on the disk while the file is being written.
    pub(super) fn path(&self) -> &Path {
        &self.part
    }

    /// Writes all of `bytes`.
    pub(super) fn put(&mut self, bytes: &[u8]) -> Result<(), OutputError> {
        self.file.write_all(bytes).map_err(|e| OutputError::new(&self.part, e))
    }

    /// Syncs the file's content to the disk. The file keeps its `.part` name until [`Folder::publish`].
    pub(super) fn seal(mut self) -> Result<Sealed, OutputError> {
        let synced = self.file.flush().and_then(|()| self.file.get_ref().sync_all());
        synced.map_err(|e| OutputError::new(&self.part, e))?;
        self.is_whole = true;
        let lock = Arc::clone(&self.lock);
        Ok(Sealed { part: self.part.clone(), is_published: false, _lock: lock })
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
            // An error is ignored: the `.part` name marks the file as incomplete.
            let _ = fs::remove_file(&self.part);
        }
    }
}

/// A complete file on the disk under its `.part` name; removed if it is dropped before it is published.
pub(crate) struct Sealed {
    part: PathBuf,
    is_published: bool,
    _lock: Arc<Lock>,
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
    /// The opened folder; it is opened at the start, so that a folder that cannot be synced is found before the run.
    handle: Handle,
    /// The lock of the folder, held from start to end by the folder and by each of its files.
    lock: Arc<Lock>,
}

impl Folder {
    /// Opens the results folder, creates it if needed, and removes the results of an earlier run, but no other files.
    /// Nothing is removed if one of the results' names holds anything but a regular file, such as a link or a pipe.
    ///
    /// # Errors
    /// Fails if the folder cannot be created or written, if another run is writing to it, or if something other than a
    /// file has the name of a result.
    pub(crate) fn open(path: &Path) -> Result<Folder, OutputError> {
        let refused = |e: io::Error| OutputError::refused(path, e);
        fs::create_dir_all(path).map_err(refused)?;
        let handle = Handle::open(path).map_err(refused)?;
        let lock = Lock::take(&path.join(LOCK), "another run is writing to this folder")?;
        let names = result_files();
        let names: Vec<[PathBuf; 2]> =
            names.iter().map(|name| [path.join(name), path.join(part_name(name))]).collect();
        names.iter().flatten().try_for_each(|name| admit(name))?;
        // The summary is removed first, because it marks the other files as complete.
        remove(&path.join(SUMMARY))?;
        handle.sync().map_err(refused)?;
        names.iter().flatten().try_for_each(|name| remove(name))?;
        Ok(Folder { path: path.to_owned(), handle, lock: Arc::new(lock) })
    }

    /// Starts the file `name`, under its `.part` name.
    pub(super) fn create(&self, name: &str) -> Result<PartFile, OutputError> {
        let part = self.path.join(part_name(name));
        // The old file was removed: a file that is there now belongs to another program and is not written to.
        let file = without_following()
            .write(true)
            .create_new(true)
            .open(&part)
            .map_err(|e| OutputError::new(&part, e))?;
        Ok(PartFile::new(file, part, Arc::clone(&self.lock)))
    }

    /// Writes the summary and gives all files their final names, the summary last. If a step fails, including the sync
    /// of the folder, no file of the run keeps its final name.
    pub(super) fn publish(
        self,
        files: impl IntoIterator<Item = Sealed>,
        summary: &[u8],
    ) -> Result<(), OutputError> {
        let mut summary_file = self.create(SUMMARY)?;
        summary_file.put(summary)?;
        let summary_file = summary_file.seal()?;
        if !self.lock.is_in_place() {
            let why = "the folder or its lock was moved away while the run was at work";
            return Err(OutputError::new(&self.path, why));
        }
        let mut published = Published { targets: Vec::new(), handle: &self.handle };
        for file in files {
            published.add(file)?;
        }
        self.make_durable()?;
        published.add(summary_file)?;
        self.make_durable()?;
        published.targets.clear();
        Ok(())
    }

    fn make_durable(&self) -> Result<(), OutputError> {
        self.handle.sync().map_err(|e| {
            let why =
                format!("the new files of this folder would not survive a power cut, so all were removed: {e}");
            OutputError::new(&self.path, why)
        })
    }
}

/// Files that have got their final names. If publishing stops before all files have their final names, the files are
/// removed again, the last first.
struct Published<'a> {
    targets: Vec<PathBuf>,
    handle: &'a Handle,
}

impl Published<'_> {
    fn add(&mut self, mut file: Sealed) -> Result<(), OutputError> {
        let target = file.final_path();
        fs::rename(&file.part, &target).map_err(|e| OutputError::new(&target, e))?;
        file.is_published = true;
        self.targets.push(target);
        Ok(())
    }
}

impl Drop for Published<'_> {
    fn drop(&mut self) {
        if self.targets.is_empty() {
            return;
        }
        // A second error is ignored. The summary is removed first, because it marks the others as complete.
        for target in self.targets.iter().rev() {
            let _ = fs::remove_file(target);
        }
        let _ = self.handle.sync();
    }
}

fn part_name(name: &str) -> String {
    format!("{name}.part")
}

fn remove(path: &Path) -> Result<(), OutputError> {
    match fs::remove_file(path) {
        Err(e) if e.kind() != io::ErrorKind::NotFound => {
            let why = format_args!("an earlier result cannot be removed: {e}");
            Err(OutputError::refused(path, why))
        }
        _ => Ok(()),
    }
}

/// An open folder, which can be synced so that its file names survive a power cut, if the system supports that.
struct Handle {
    #[cfg(unix)]
    folder: File,
}

impl Handle {
    fn open(path: &Path) -> io::Result<Handle> {
        #[cfg(unix)]
        return Ok(Handle { folder: File::open(path)? });
        #[cfg(not(unix))]
        {
            let _ = path;
            Ok(Handle {})
        }
    }

    fn sync(&self) -> io::Result<()> {
        #[cfg(unix)]
        match self.folder.sync_all() {
            // A file system that cannot sync folders.
            Err(e) if e.kind() != io::ErrorKind::InvalidInput => return Err(e),
            _ => {}
        }
        Ok(())
    }
}
