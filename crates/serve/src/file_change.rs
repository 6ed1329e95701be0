//! Renames, deletes and puts back recordings and exercises that were saved from the page. Nothing is overwritten, and nothing outside of
//! their folders is touched. A deleted file lies in the folder `deleted` beside the others until somebody removes it by hand.

use core::fmt;
use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use fenderline_live::message::GalleryEntry;

use super::file_name::{self, NameError};
use super::gallery::{self, Changed, DELETED, EXERCISE_ENDING, Gallery};
use super::kept_seats;
use super::saved::ENDING;

/// Most deleted files of one name.
const MOST_OF_A_NAME: usize = 1000;

/// What an instructor wants of a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Wish {
    /// Another name, without its ending.
    Rename(String),
    /// To have it out of the list.
    Delete,
    /// To have it back.
    PutBack,
}

/// The files that a running session needs as they are.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InUse<'a> {
    /// The file that the session is recorded to.
    pub(crate) recording: &'a Path,
    /// The name of its scenario's file.
    pub(crate) scenario: &'a str,
}

/// Why a file stays as it is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ChangeError {
    /// The new name is no good.
    Name(NameError),
    /// The gallery has no file of this name.
    NotThere(String),
    /// No file of this name was deleted.
    NotDeleted(String),
    /// The session that goes on is recorded to it.
    IsRecorded(String),
    /// The session that goes on is one of this exercise.
    Runs(String),
    /// It was written by hand, or lies in another folder.
    NotOurs(String),
    /// There is a file of the new name.
    Taken(String),
    /// It is a link, a folder, or gone.
    NoFile(String),
    /// The file system's answer, with the path.
    Failed(PathBuf, String),
}

impl fmt::Display for ChangeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ChangeError::Name(error) => error.fmt(f),
            ChangeError::NotThere(file) => write!(f, "there is no {file} in the gallery"),
            ChangeError::NotDeleted(file) => {
                write!(f, "there is no {file} among the deleted files")
            }
            ChangeError::IsRecorded(file) => {
                write!(f, "this session is being recorded to {file}: it stays as it is")
            }
            ChangeError::Runs(file) => {
                write!(f, "this session is one of {file}: open another one first")
            }
            ChangeError::NotOurs(file) => write!(
                f,
                "{file} was not saved from the page, or lies in another folder: rename and delete it by hand"
            ),
            ChangeError::Taken(file) => {
                write!(f, "there is a file {file} already: both stay as they are")
            }
            ChangeError::NoFile(file) => write!(f, "{file} is a link, no file, or gone"),
            ChangeError::Failed(path, why) => write!(f, "{}: {why}", path.display()),
        }
    }
}

impl std::error::Error for ChangeError {}

impl From<NameError> for ChangeError {
    fn from(error: NameError) -> ChangeError {
        ChangeError::Name(error)
    }
}

/// A change that is about to be made.
#[derive(Debug)]
pub(crate) struct FileChange {
    from: PathBuf,
    to: To,
    entry: GalleryEntry,
    /// It is among the deleted files.
    is_put_back: bool,
}

/// Where a file goes.
#[derive(Debug)]
enum To {
    /// A path that must be free.
    Path(PathBuf),
    /// A folder that is made if need be, under a name that is free there.
    Deleted(PathBuf),
}

impl FileChange {
    /// What is to be done with a file of the gallery, by its name. Asks no file system.
    ///
    /// # Errors
    /// [`ChangeError`], but what only the file system knows.
    pub(crate) fn new(
        gallery: &Gallery,
        in_use: InUse<'_>,
        file: &str,
        wish: &Wish,
    ) -> Result<FileChange, ChangeError> {
        if gallery::name_of(in_use.recording) == file {
            return Err(ChangeError::IsRecorded(file.to_owned()));
        }
        let found = match wish {
            Wish::PutBack => gallery.get_deleted(file).ok_or(ChangeError::NotDeleted(file.into())),
            Wish::Rename(_) | Wish::Delete => {
                gallery.get(file).ok_or(ChangeError::NotThere(file.into()))
            }
        };
        let (entry, from) = found?;
        if in_use.scenario == file && *wish != Wish::PutBack {
            return Err(ChangeError::Runs(file.to_owned()));
        }
        if !entry.changeable {
            return Err(ChangeError::NotOurs(file.to_owned()));
        }
        let folder = from.parent().unwrap_or(Path::new(""));
        let to = match wish {
            Wish::Rename(name) => {
                file_name::check(name)?;
                To::Path(folder.join(format!("{name}{}", ending_of(file))))
            }
            Wish::Delete => To::Deleted(folder.join(DELETED)),
            Wish::PutBack => To::Path(folder.parent().unwrap_or(Path::new("")).join(file)),
        };
        let is_put_back = *wish == Wish::PutBack;
        Ok(FileChange { from: from.to_owned(), to, entry: entry.clone(), is_put_back })
    }

    /// Makes the change.
    ///
    /// # Errors
    /// [`ChangeError`]. Nothing is changed then.
    pub(crate) fn make(self) -> Result<Changed, ChangeError> {
        let FileChange { from, to, entry, is_put_back } = self;
        let name = gallery::name_of(&from);
        if !from.symlink_metadata().is_ok_and(|of| of.is_file()) {
            return Err(ChangeError::NoFile(name));
        }
        let is_deleted = matches!(to, To::Deleted(_));
        if is_put_back && !from.parent().is_some_and(gallery::is_folder) {
            return Err(ChangeError::NoFile(name));
        }
        let to = match to {
            To::Path(to) => move_free(&from, &to).map(|()| to)?,
            To::Deleted(folder) => {
                make_folder(&folder)?;
                move_to(&from, &folder)?
            }
        };
        // Files that a deleted scenario names stay where they are.
        let with_named = if is_deleted { &from } else { &to };
        let beside = with_named.parent().unwrap_or(Path::new(""));
        let file = gallery::name_of(&to);
        // What has become unreadable meanwhile keeps what it was called.
        let entry = gallery::entry_among(&to, beside).unwrap_or(GalleryEntry { file, ..entry });
        Ok(Changed { from, to, entry, is_deleted })
    }
}

fn ending_of(file: &str) -> &'static str {
    if file.ends_with(ENDING) { ENDING } else { EXERCISE_ENDING }
}

/// The folder for deleted files: never through a link.
fn make_folder(folder: &Path) -> Result<(), ChangeError> {
    if gallery::is_folder(folder) {
        return Ok(());
    }
    if folder.symlink_metadata().is_ok() {
        return Err(ChangeError::Failed(folder.to_owned(), "this is no folder".into()));
    }
    fs::create_dir(folder).map_err(|error| failed(folder, &error))
}

/// Moves a file into a folder, with a number where its name is taken there.
fn move_to(from: &Path, folder: &Path) -> Result<PathBuf, ChangeError> {
    let file = gallery::name_of(from);
    let ending = ending_of(&file);
    let stem = file.strip_suffix(ending).unwrap_or(&file);
    for number in 1..=MOST_OF_A_NAME {
        let to = folder.join(match number {
            1 => file.clone(),
            _ => format!("{stem}-{number}{ending}"),
        });
        match move_free(from, &to) {
            Err(ChangeError::Taken(_)) => {}
            moved => return moved.map(|()| to),
        }
    }
    Err(ChangeError::Taken(file))
}

/// Moves a file, and that of a recording's links, to names that must be free.
fn move_free(from: &Path, to: &Path) -> Result<(), ChangeError> {
    if !gallery::name_of(from).ends_with(ENDING) {
        return move_file(from, to);
    }
    let (links, links_to) = (kept_seats::beside(from), kept_seats::beside(to));
    // The links of another session would open this one.
    if links_to.symlink_metadata().is_ok() {
        return Err(ChangeError::Taken(gallery::name_of(&links_to)));
    }
    let has_links = links.symlink_metadata().is_ok_and(|of| of.is_file());
    if has_links {
        move_file(&links, &links_to)?;
    }
    let moved = move_file(from, to);
    if moved.is_err() && has_links {
        let _ = move_file(&links_to, &links);
    }
    moved
}

/// Moves a file to a name that must be free.
fn move_file(from: &Path, to: &Path) -> Result<(), ChangeError> {
    // Takes the name first: `rename` alone would replace a file that somebody else has made meanwhile.
    match OpenOptions::new().write(true).create_new(true).open(to) {
        Ok(_) => {}
        Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
            return Err(ChangeError::Taken(gallery::name_of(to)));
        }
        Err(error) => return Err(failed(to, &error)),
    }
    fs::rename(from, to).map_err(|error| {
        let _ = fs::remove_file(to);
        failed(from, &error)
    })
}

fn failed(path: &Path, error: &io::Error) -> ChangeError {
    ChangeError::Failed(path.to_owned(), error.to_string())
}
