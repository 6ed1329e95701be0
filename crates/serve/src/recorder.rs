//! Writes the recording of the running session.

use std::fs::{self, File, OpenOptions};
use std::io::{self, BufReader, BufWriter, Read as _, Seek as _, Write as _};
use std::path::{Path, PathBuf};

use fenderline_live::{LARGEST_RECORDING_BYTES, copy_kept};
use fenderline_scenario::open_regular;

use super::file_name;
use super::gallery::Opened;
use super::saved::ENDING;

/// An open recording. Every line of the recording goes to the operating system at once. If the program is killed, no
/// line of the recording is lost.
#[derive(Debug)]
pub(crate) struct Recorder {
    folder: PathBuf,
    path: PathBuf,
    file: File,
    /// Number of bytes that the recording has so far.
    bytes: u64,
}

impl Recorder {
    /// Creates the recording's file and writes the start of the session. The recording's file is named after the
    /// scenario, with the next free number. The folder of recordings is created if it is missing.
    ///
    /// # Errors
    /// Fails with an error of the file system, which names the path. Fails too for a recording that was changed after
    /// its replay. If the call fails, no file is left.
    pub(crate) fn begin(
        folder: &Path,
        scenario: &str,
        opened: &mut Opened,
    ) -> Result<Recorder, String> {
        fs::create_dir_all(folder).map_err(|e| with_path(folder, &e))?;
        let (path, file) = next_free(folder, scenario)?;
        let mut recorder = Recorder { folder: folder.to_owned(), path, file, bytes: 0 };
        match recorder.begin_with(opened) {
            Ok(()) => Ok(recorder),
            Err(why) => {
                recorder.discard();
                Err(why)
            }
        }
    }

    fn begin_with(&mut self, opened: &mut Opened) -> Result<(), String> {
        if let Some((file, outline)) = opened.recorded.take() {
            (&file).rewind().map_err(|e| e.to_string())?;
            let mut output = BufWriter::new(&self.file);
            copy_kept(BufReader::new(&file), &outline, &mut output)
                .map_err(|e| format!("{}: the recording cannot go on: {e}", self.path.display()))?;
            output.flush().map_err(|e| with_path(&self.path, &e))?;
            self.bytes = outline.kept_bytes;
        }
        self.add(&opened.session.take_lines())
    }

    /// Removes the recording of a session that was not started.
    pub(crate) fn discard(self) {
        let _ = fs::remove_file(&self.path);
    }

    /// Path of the file.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Adds lines.
    ///
    /// # Errors
    /// Fails with an error of the file system, which names the path.
    pub(crate) fn add(&mut self, lines: &str) -> Result<(), String> {
        self.file.write_all(lines.as_bytes()).map_err(|e| with_path(&self.path, &e))?;
        self.bytes += lines.len() as u64;
        Ok(())
    }

    /// The recording so far, to be read on another thread. `end_line` becomes the last line of the recording.
    pub(crate) fn so_far(&self, end_line: String) -> SoFar {
        SoFar { from: self.path.clone(), bytes: self.bytes, end_line }
    }

    /// Prepares a copy of the recording so far, under a name of letters, digits, `-` and `_`. `end_line` becomes the
    /// last line of the copy. Preparing the copy does not use the file system.
    ///
    /// # Errors
    /// Refuses a name that is not allowed for a file.
    pub(crate) fn copy(&self, name: &str, end_line: String) -> Result<Copy, String> {
        file_name::check(name).map_err(|error| error.to_string())?;
        let to = self.folder.join(format!("{name}{ENDING}"));
        let (from, name) = (self.path.clone(), name.to_owned());
        Ok(Copy { from, bytes: self.bytes, end_line, to, name })
    }
}

/// A recording up to a moment, which has not been read yet.
#[derive(Debug)]
pub(crate) struct SoFar {
    from: PathBuf,
    bytes: u64,
    end_line: String,
}

impl SoFar {
    /// The name of the recording's file, and the file's bytes followed by the last line.
    ///
    /// # Errors
    /// Fails with an error of the file system. Fails too if the file is shorter than the recording was.
    pub(crate) fn read(self) -> Result<(String, Vec<u8>), String> {
        let name = self.from.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let from = open_regular(&self.from, LARGEST_RECORDING_BYTES).map_err(|e| e.to_string())?;
        let mut bytes = Vec::new();
        let read = from.take(self.bytes).read_to_end(&mut bytes);
        read.map_err(|e| with_path(&self.from, &e))?;
        if (bytes.len() as u64) < self.bytes {
            return Err(format!(
                "{name}: the file is shorter than the recording that was written to it"
            ));
        }
        bytes.extend_from_slice(self.end_line.as_bytes());
        Ok((name, bytes))
    }
}

/// A copy of a recording, which has not been written yet.
#[derive(Debug)]
pub(crate) struct Copy {
    from: PathBuf,
    bytes: u64,
    end_line: String,
    to: PathBuf,
    name: String,
}

impl Copy {
    /// Writes the copy of the recording and returns the copy's path.
    ///
    /// # Errors
    /// Fails if the name is taken. Fails too with an error of the file system. No copy is left if the call fails.
    pub(crate) fn make(self) -> Result<PathBuf, String> {
        let from = open_regular(&self.from, LARGEST_RECORDING_BYTES).map_err(|e| e.to_string())?;
        let to = OpenOptions::new().write(true).create_new(true).open(&self.to);
        let mut to = to.map_err(|e| match e.kind() {
            io::ErrorKind::AlreadyExists => {
                format!("there is a session named {} already", self.name)
            }
            _ => with_path(&self.to, &e),
        })?;
        let written = io::copy(&mut from.take(self.bytes), &mut to).and_then(|bytes| {
            let lacks =
                io::Error::other("the file is shorter than the recording that was written to it");
            if bytes < self.bytes { Err(lacks) } else { to.write_all(self.end_line.as_bytes()) }
        });
        if let Err(e) = written {
            let _ = fs::remove_file(&self.to);
            return Err(with_path(&self.to, &e));
        }
        Ok(self.to)
    }
}

fn with_path(path: &Path, e: &io::Error) -> String {
    format!("{}: {e}", path.display())
}

/// Creates a file with the next free number after its name.
fn next_free(folder: &Path, scenario: &str) -> Result<(PathBuf, File), String> {
    let stem = scenario.strip_suffix(ENDING).unwrap_or(scenario);
    let stem = Path::new(stem).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    for number in 1..100_000 {
        let path = folder.join(format!("{stem}-{number:03}{ENDING}"));
        match OpenOptions::new().append(true).create_new(true).open(&path) {
            Ok(file) => return Ok((path, file)),
            Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
            Err(e) => return Err(with_path(&path, &e)),
        }
    }
    Err(format!("{}: no number is free for {stem}", folder.display()))
}
