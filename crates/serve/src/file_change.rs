//! Renames, deletes and puts back recordings and exercises that were saved from the page. The changes overwrite no
//! file, and touch no file outside the folders of recordings and exercises. A deleted file lies in the folder `deleted`
//! beside the other files until somebody removes it by hand.

use core::fmt;
use std::fs::{self, OpenOptions};
use std::io;
use std::path::{Path, PathBuf};

use fenderline_live::message::GalleryEntry;

use super::file_name::{self, NameError};
use super::gallery::{self, Changed, DELETED, EXERCISE_ENDING, Gallery};
use super::kept_seats;
use super::saved::ENDING;

/// Largest number of deleted files that had the same name.
const MOST_OF_A_NAME: usize = 1000;

/// What an instructor wants to do with a file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Wish {
    /// Gives the file another name. The text is the new name without its ending.
    Rename(String),
    /// Removes the file from the list of the gallery.
    Delete,
    /// Puts a deleted file back in the list of the gallery.
    PutBack,
}

/// The files that a running session needs unchanged.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InUse<'a> {
    /// The file to which the running session is recorded.
    pub(crate) recording: &'a Path,
    /// The name of the running session's scenario file.
    pub(crate) scenario: &'a str,
}

/// Why a file of the gallery was not changed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum ChangeError {
    /// The new name is not allowed.
    Name(NameError),
    /// The gallery has no file with this name.
    NotThere(String),
    /// No file with this name was deleted.
    NotDeleted(String),
    /// The running session is recorded to this file.
    IsRecorded(String),
    /// The running session is a run of this exercise.
    Runs(String),
    /// The file was written by hand, or lies in another folder.
    NotOurs(String),
    /// A file with the new name exists.
    Taken(String),
    /// The path is a link or a folder, or the file is gone.
    NoFile(String),
    /// The file system reports an error: path and message.
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
                write!(
                    f,
                    "this session is being recorded to {file}, which therefore stays as it is"
                )
            }
            ChangeError::Runs(file) => {
                write!(f, "this session is one of {file}: open another session first")
            }
            ChangeError::NotOurs(file) => write!(
                f,
                "{file} was not saved from the page, or lies in another folder: rename and delete it by hand"
            ),
            ChangeError::Taken(file) => {
                write!(f, "there is a file {file} already: both files stay as they are")
            }
            ChangeError::NoFile(file) => write!(f, "{file} is a link, is not a file, or is gone"),
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

/// A change that is ready to be made.
#[derive(Debug)]
pub(crate) struct FileChange {
    from: PathBuf,
    to: To,
    entry: GalleryEntry,
    /// True if the change puts a deleted file back into the gallery.
    is_put_back: bool,
}

/// Where a file of the gallery is moved.
#[derive(Debug)]
enum To {
    /// The file is moved to a path at which no file may exist.
    Path(PathBuf),
    /// The file is moved to the folder of deleted files, under a name that is free in this folder. The folder of
    /// deleted files is made if it is missing.
    Deleted(PathBuf),
}

impl FileChange {
    /// Plans a change of a file in the gallery, which the caller gives by its name. Planning a change does not use the
    /// file system.
    ///
    /// # Errors
    /// Returns a [`ChangeError`], except for the errors that only the file system can find.
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
    /// [`ChangeError`]. A change that fails changes no file.
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
        // If the scenario is deleted, the files that it names stay where they are.
        let with_named = if is_deleted { &from } else { &to };
        let beside = with_named.parent().unwrap_or(Path::new(""));
        let file = gallery::name_of(&to);
        // If the file has become unreadable in the meantime, its entry keeps the old title and text.
        let entry = gallery::entry_among(&to, beside).unwrap_or(GalleryEntry { file, ..entry });
        Ok(Changed { from, to, entry, is_deleted })
    }
}

fn ending_of(file: &str) -> &'static str {
    if file.ends_with(ENDING) { ENDING } else { EXERCISE_ENDING }
}

/// Makes the folder for deleted files. A link in place of this folder is refused.
fn make_folder(folder: &Path) -> Result<(), ChangeError> {
    if gallery::is_folder(folder) {
        return Ok(());
    }
    if folder.symlink_metadata().is_ok() {
        return Err(ChangeError::Failed(folder.to_owned(), "this is no folder".into()));
    }
    fs::create_dir(folder).map_err(|error| failed(folder, &error))
}

/// Moves a file into a folder. If the folder has a file of the same name, a number is added to the name.
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

/// Moves a file of the gallery to a name that must be free. The file of links that belongs to a recording moves with
/// the recording.
fn move_free(from: &Path, to: &Path) -> Result<(), ChangeError> {
    if !gallery::name_of(from).ends_with(ENDING) {
        return move_file(from, to);
    }
    let (links, links_to) = (kept_seats::beside(from), kept_seats::beside(to));
    // If another file of links lies there, this session would open with the links of another session.
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
    // Creates the file first, to take the name: `rename` alone would replace a file that somebody else has made in the
    // meantime.
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
