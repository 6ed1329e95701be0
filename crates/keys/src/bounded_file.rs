//! Reads files that a user names. The program reads only regular files of bounded size, so that no file name can make
//! it hang.
//!
//! Opening a named pipe blocks the program, reading a device may never end, and somebody can replace a file between a
//! check of the file and its opening. The program therefore checks the file's metadata first, then opens the file
//! without waiting, and checks the metadata again through the open handle, which a renaming of the file does not
//! affect.

use core::fmt;
use std::fs::{File, FileType, Metadata, OpenOptions};
use std::io::{self, Read as _};
use std::path::{Path, PathBuf};

use crate::printable::printable_line;

/// The error for a file that cannot be read or that the program refuses to read.
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
    /// The operating system reports an error.
    System {
        /// The kind of the operating system's error.
        kind: io::ErrorKind,
        /// The text of the operating system's error.
        text: String,
    },
    /// The file is not a regular file; the text says what the file is, for example "a pipe".
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

/// Opens a regular file of at most `largest_bytes` for reading, and never waits. The file may still grow after it was
/// opened, so a caller that reads the file piece by piece must count the bytes.
///
/// # Errors
/// Returns a [`FileError`] if the file does not exist, is not a regular file, or is larger than `largest_bytes`.
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
/// Fails like [`open_regular`], and also if the file grows beyond `largest_bytes` while it is read.
pub fn read_bytes(path: &Path, largest_bytes: u64) -> Result<Vec<u8>, FileError> {
    bounded(open_regular(path, largest_bytes)?, path, largest_bytes)
}

/// Reads a stream of at most `largest_bytes` to its end; errors call the stream `path`.
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
/// Fails like [`read_bytes`], and also if the file is not UTF-8 text.
pub fn read_text_of(path: &Path, largest_bytes: u64) -> Result<String, FileError> {
    text(read_bytes(path, largest_bytes)?, path)
}

/// Reads the text of a stream of at most `largest_bytes`, such as standard input, and waits for the end of the stream.
/// Errors call the stream `name`.
///
/// # Errors
/// Fails if the stream cannot be read, is larger than `largest_bytes`, or is not UTF-8 text.
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

/// Options for opening a file that a user names for reading: opening the file never waits for a pipe, device or
/// terminal, and a terminal opened in this way does not become the program's controlling terminal.
fn without_waiting() -> OpenOptions {
    with_flags(
        #[cfg(unix)]
        (libc::O_NONBLOCK | libc::O_NOCTTY),
    )
}

/// Options for opening a file for writing that another program may have created: opening the file never waits, and
/// fails if the path is a symbolic link.
#[must_use]
pub fn without_following() -> OpenOptions {
    with_flags(
        #[cfg(unix)]
        (libc::O_NONBLOCK | libc::O_NOCTTY | libc::O_NOFOLLOW),
    )
}

fn with_flags(#[cfg(unix)] flags: i32) -> OpenOptions {
    #[cfg_attr(not(unix), expect(unused_mut, reason = "only on Unix does the function set flags"))]
    let mut options = OpenOptions::new();
    #[cfg(unix)]
    std::os::unix::fs::OpenOptionsExt::custom_flags(&mut options, flags);
    options
}

/// Says in words what a file is that is not a regular file, for example "a folder"; `None` for a regular file.
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
