//! The recording's file: begun with a session, added to as commands come.

use std::fs::{self, File, OpenOptions};
use std::io::{self, Write as _};
use std::path::{Path, PathBuf};

/// The end of a recording's file name.
pub(crate) const ENDING: &str = ".session.jsonl";

/// An open recording. Every line is given to the operating system at once: killing the program loses none.
#[derive(Debug)]
pub(crate) struct Recorder {
    folder: PathBuf,
    path: PathBuf,
    file: File,
}

impl Recorder {
    /// Begins a file named after the scenario, with the next free number, in a folder that is made if need be.
    ///
    /// # Errors
    /// As the file system has it, with the path.
    pub(crate) fn begin(folder: &Path, scenario: &str, text: &str) -> Result<Recorder, String> {
        let told = |path: &Path, e: &io::Error| format!("{}: {e}", path.display());
        fs::create_dir_all(folder).map_err(|e| told(folder, &e))?;
        let stem = scenario.strip_suffix(ENDING).unwrap_or(scenario);
        let stem = Path::new(stem).file_stem().unwrap_or_default().to_string_lossy().into_owned();
        for number in 1..100_000 {
            let path = folder.join(format!("{stem}-{number:03}{ENDING}"));
            match OpenOptions::new().append(true).create_new(true).open(&path) {
                Ok(mut file) => {
                    file.write_all(text.as_bytes()).map_err(|e| told(&path, &e))?;
                    return Ok(Recorder { folder: folder.to_owned(), path, file });
                }
                Err(e) if e.kind() == io::ErrorKind::AlreadyExists => {}
                Err(e) => return Err(told(&path, &e)),
            }
        }
        Err(format!("{}: no number is free for {stem}", folder.display()))
    }

    /// Where it is written.
    pub(crate) fn path(&self) -> &Path {
        &self.path
    }

    /// Adds lines.
    ///
    /// # Errors
    /// As the file system has it, with the path.
    pub(crate) fn add(&mut self, lines: &str) -> Result<(), String> {
        self.file.write_all(lines.as_bytes()).map_err(|e| format!("{}: {e}", self.path.display()))
    }

    /// Keeps a copy under a name of letters, digits, `-` and `_`.
    ///
    /// # Errors
    /// A name that is none, or is taken; as the file system has it.
    pub(crate) fn save(&self, name: &str) -> Result<PathBuf, String> {
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
        if name.is_empty() || name.len() > 60 || !name.chars().all(letter) {
            return Err("a name has 1 to 60 letters, digits, - and _".to_owned());
        }
        let path = self.folder.join(format!("{name}{ENDING}"));
        if path.exists() {
            return Err(format!("there is a session named {name} already"));
        }
        fs::copy(&self.path, &path).map_err(|e| format!("{}: {e}", path.display()))?;
        Ok(path)
    }
}
