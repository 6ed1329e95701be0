//! Reads files that a user names. Only regular files of bounded size are read, so that no name can hang the program.
//!
//! A named pipe blocks whoever opens it, a device may never end, and a file can be replaced between a check and the
//! opening. So the file is checked first, which touches no device, then opened without waiting, and checked again
//! through the open handle, which renaming does not affect.

use core::fmt;
use std::fs::{File, FileType, Metadata, OpenOptions};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use crate::printable::printable_line;

/// A file that cannot be read or is refused.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FileError {
    /// The file.
    pub path: PathBuf,
    /// What is wrong with the file.
    pub fault: FileFault,
}

/// What is wrong with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileFault {
    /// An error of the operating system.
    System {
        /// Its kind.
        kind: io::ErrorKind,
        /// Its text.
        text: String,
    },
    /// The file is not a regular file; says what it is, as "a named pipe".
    NotRegular(&'static str),
    /// The file is larger than the caller allows.
    TooLarge {
        /// The largest size allowed (bytes).
        largest_bytes: u64,
    },
    /// The file is not UTF-8 text.
    NotText {
        /// The first line that is not UTF-8 text, from 1.
        line: usize,
    },
}

impl FileError {
    fn new(path: &Path, fault: FileFault) -> FileError {
        FileError { path: path.to_owned(), fault }
    }

    fn system(path: &Path, error: &io::Error) -> FileError {
        let fault = FileFault::System { kind: error.kind(), text: error.to_string() };
        FileError::new(path, fault)
    }
}

impl fmt::Display for FileError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: ", printable_line(&self.path.display().to_string()))?;
        match &self.fault {
            FileFault::System { text, .. } => f.write_str(text),
            FileFault::NotRegular(what) => {
                write!(f, "it is {what}, and only regular files are read")
            }
            FileFault::TooLarge { largest_bytes } if *largest_bytes < 1 << 20 => {
                write!(f, "it is larger than the {largest_bytes} bytes that are read")
            }
            FileFault::TooLarge { largest_bytes } => {
                write!(f, "it is larger than the {} MiB that are read", largest_bytes >> 20)
            }
            FileFault::NotText { line } => write!(f, "line {line} is not UTF-8 text"),
        }
    }
}

impl std::error::Error for FileError {}

/// Opens a regular file of at most `largest_bytes` for reading, and never waits. The file may still grow after
/// opening: a caller that streams the file must count the bytes.
///
/// # Errors
/// [`FileError`] for a file that does not exist, is not regular, or is larger.
pub fn open_regular(path: &Path, largest_bytes: u64) -> Result<File, FileError> {
    let system = |e: io::Error| FileError::system(path, &e);
    // Check before opening: opening some devices acts on them, and a pipe's writer would believe that it has a reader.
    admit(path, &std::fs::metadata(path).map_err(system)?, largest_bytes)?;
    let file = without_waiting().read(true).open(path).map_err(system)?;
    admit(path, &file.metadata().map_err(system)?, largest_bytes)?;
    Ok(file)
}

/// The content of a regular file of at most `largest_bytes`.
///
/// # Errors
/// As [`open_regular`], and for a file that grows beyond `largest_bytes` while it is read.
pub fn read_bytes(path: &Path, largest_bytes: u64) -> Result<Vec<u8>, FileError> {
    bounded(open_regular(path, largest_bytes)?, path, largest_bytes)
}

/// All of a stream of at most `largest_bytes`; `path` is its name in errors.
fn bounded(stream: impl io::Read, path: &Path, largest_bytes: u64) -> Result<Vec<u8>, FileError> {
    let mut bytes = Vec::new();
    // Reading one byte more than allowed detects a file that is larger than its metadata say, as in /proc.
    stream
        .take(largest_bytes.saturating_add(1))
        .read_to_end(&mut bytes)
        .map_err(|e| FileError::system(path, &e))?;
    if bytes.len() as u64 > largest_bytes {
        return Err(FileError::new(path, FileFault::TooLarge { largest_bytes }));
    }
    Ok(bytes)
}

/// The text of a regular file of at most `largest_bytes`.
///
/// # Errors
/// As [`read_bytes`], and for a file that is not UTF-8 text.
pub fn read_text_of(path: &Path, largest_bytes: u64) -> Result<String, FileError> {
    text(read_bytes(path, largest_bytes)?, path)
}

/// The text of a stream of at most `largest_bytes`, such as standard input; `name` is its name in errors. Waits for its end.
///
/// # Errors
/// A stream that cannot be read, is larger, or is not UTF-8 text.
pub fn read_stream_of(
    stream: impl io::Read,
    name: &str,
    largest_bytes: u64,
) -> Result<String, FileError> {
    let name = Path::new(name);
    text(bounded(stream, name, largest_bytes)?, name)
}

fn text(bytes: Vec<u8>, path: &Path) -> Result<String, FileError> {
    String::from_utf8(bytes).map_err(|e| {
        let whole = &e.as_bytes()[..e.utf8_error().valid_up_to()];
        let line = whole.iter().filter(|b| **b == b'\n').count() + 1;
        FileError::new(path, FileFault::NotText { line })
    })
}

/// Options for reading a file that a user names: opening never waits for a pipe, device or terminal, and no terminal
/// becomes the program's controlling terminal.
fn without_waiting() -> OpenOptions {
    with_flags(
        #[cfg(unix)]
        (libc::O_NONBLOCK | libc::O_NOCTTY),
    )
}

/// Options for writing a file that others may have created: as for reading, and a symbolic link is an error instead of
/// being followed.
#[must_use]
pub fn without_following() -> OpenOptions {
    with_flags(
        #[cfg(unix)]
        (libc::O_NONBLOCK | libc::O_NOCTTY | libc::O_NOFOLLOW),
    )
}

fn with_flags(#[cfg(unix)] flags: i32) -> OpenOptions {
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only unix has flags to set"))]
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, flags);
    options
}

/// What an irregular file is, as "a folder"; `None` for a regular file.
#[must_use]
pub fn irregular(kind: FileType) -> Option<&'static str> {
    if kind.is_file() {
        return None;
    }
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt as _;
        if kind.is_fifo() {
            return Some("a pipe");
        } else if kind.is_char_device() || kind.is_block_device() {
            return Some("a device");
        } else if kind.is_socket() {
            return Some("a socket");
        }
    }
    Some(if kind.is_dir() {
        "a folder"
    } else if kind.is_symlink() {
        "a symbolic link"
    } else {
        "not a regular file"
    })
}

fn admit(path: &Path, metadata: &Metadata, largest_bytes: u64) -> Result<(), FileError> {
    if let Some(what) = irregular(metadata.file_type()) {
        return Err(FileError::new(path, FileFault::NotRegular(what)));
    }
    if metadata.len() > largest_bytes {
        return Err(FileError::new(path, FileFault::TooLarge { largest_bytes }));
    }
    Ok(())
}
