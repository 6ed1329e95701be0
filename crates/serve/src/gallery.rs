//! The gallery: the scenarios of a folder and the saved sessions that the instructor can open.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use fenderline_author::berth_words;
use fenderline_live::message::GalleryEntry;
use fenderline_live::{Ghost, INTO_A_SESSION, Outline, Session, Source};
use fenderline_scenario::read_text;

use super::kept_seats::{self, KeptSeats};
use super::saved::{self, ENDING, Replayed, Watch};

/// Largest number of entries in the gallery, and largest number of files that are read from a folder to fill it.
const MOST: usize = 200;
const MOST_READ: usize = 1000;
/// The ending of an exercise's file name.
pub(crate) const EXERCISE_ENDING: &str = ".toml";
/// The folder for deleted files, which lies in the folder of exercises or recordings.
pub(crate) const DELETED: &str = "deleted";
/// Texts by which the first comment of an exercise shows that the exercise was saved from the page. A file without one
/// of these texts was written by hand, and the page cannot rename it.
const FROM_THE_PAGE: [&str; 2] = ["Made from choices:", INTO_A_SESSION];
/// Largest size of a scenario together with the files that it names (bytes).
const LARGEST_SCENARIO: usize = 64 << 20;

/// A change that was made to a file of the gallery.
#[derive(Debug)]
pub(crate) struct Changed {
    pub(crate) from: PathBuf,
    pub(crate) to: PathBuf,
    /// The gallery's entry of the file after the change.
    pub(crate) entry: GalleryEntry,
    /// True if the file is among the deleted files now.
    pub(crate) is_deleted: bool,
}

/// The list of files that can be opened, by name. No other file can be opened, because a page gives the name of an
/// entry in the list and not a path.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gallery {
    files: Files,
    /// Deleted files that can be put back.
    deleted: Files,
    /// The folder in which new exercises are saved.
    folder: PathBuf,
    /// The folder in which sessions are recorded.
    sessions: PathBuf,
}

/// Files with their entries. Each name appears once.
#[derive(Clone, Debug, Default)]
struct Files {
    entries: Vec<GalleryEntry>,
    paths: Vec<PathBuf>,
}

impl Files {
    fn place(&self, file: &str) -> Option<usize> {
        self.entries.iter().position(|entry| entry.file == file)
    }

    fn has_room_for(&self, file: &str) -> bool {
        self.paths.len() < MOST && self.place(file).is_none()
    }

    fn put(&mut self, path: &Path, entry: GalleryEntry) {
        if self.has_room_for(&entry.file) {
            self.entries.push(entry);
            self.paths.push(path.to_owned());
        }
    }

    /// Puts a file at the end of the gallery's list. The new file replaces an earlier file of the same name. If the
    /// list is full, the new file replaces the first file.
    fn put_last(&mut self, path: &Path, entry: GalleryEntry) {
        let is_full = self.paths.len() >= MOST;
        if let Some(place) = self.place(&entry.file).or(is_full.then_some(0)) {
            self.entries.remove(place);
            self.paths.remove(place);
        }
        self.put(path, entry);
    }

    fn get(&self, file: &str) -> Option<(&GalleryEntry, &Path)> {
        self.place(file).map(|place| (&self.entries[place], self.paths[place].as_path()))
    }

    /// Removes the entry that has the given path and returns the entry's index.
    fn take(&mut self, path: &Path) -> Option<usize> {
        let place = self.paths.iter().position(|other| other == path)?;
        self.entries.remove(place);
        self.paths.remove(place);
        Some(place)
    }
}

impl Gallery {
    /// An empty gallery. New exercises are saved in `folder`, and sessions are recorded in `sessions`.
    pub(crate) fn new(folder: &Path, sessions: &Path) -> Gallery {
        Gallery { folder: folder.to_owned(), sessions: sessions.to_owned(), ..Gallery::default() }
    }

    /// Adds to the gallery the scenarios that have a vessel, the recordings, and the deleted files in its folders. If
    /// several files have the same name, only the first is added.
    pub(crate) fn fill(&mut self) {
        for folder in [self.folder.clone(), self.sessions.clone()] {
            files_of(&folder).iter().for_each(|path| self.add(path));
            let deleted = folder.join(DELETED);
            if !is_folder(&deleted) {
                continue;
            }
            for path in files_of(&deleted) {
                if self.deleted.has_room_for(&name_of(&path))
                    && let Some(entry) = entry_among(&path, &folder)
                    && entry.changeable
                {
                    self.deleted.put(&path, entry);
                }
            }
        }
    }

    /// Adds a file to the gallery, if the file can be opened.
    pub(crate) fn add(&mut self, path: &Path) {
        if self.files.has_room_for(&name_of(path))
            && let Some(entry) = entry(path)
        {
            self.put(path, entry);
        }
    }

    /// Adds a file's entry to the gallery.
    pub(crate) fn put(&mut self, path: &Path, entry: GalleryEntry) {
        let changeable = entry.changeable && self.is_in_its_folders(path);
        self.files.put(path, GalleryEntry { changeable, ..entry });
    }

    /// True if a file lies in the folder of exercises or in the folder of recordings.
    fn is_in_its_folders(&self, path: &Path) -> bool {
        let parent = path.parent().unwrap_or(Path::new(""));
        [&self.folder, &self.sessions].into_iter().any(|folder| is_same_folder(folder, parent))
    }

    /// The folder in which new exercises are saved.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Adds an entry. A new entry replaces the entry of the same file.
    pub(crate) fn renew(&mut self, path: &Path, entry: GalleryEntry) {
        match self.files.place(&entry.file) {
            Some(place) => self.files.entries[place] = entry,
            None => self.put(path, entry),
        }
    }

    /// Updates the lists after a file was renamed, deleted or put back.
    pub(crate) fn moved(&mut self, changed: Changed) {
        let Changed { from, to, entry, is_deleted } = changed;
        let place = self.files.take(&from);
        self.deleted.take(&from);
        match place {
            _ if is_deleted => self.deleted.put_last(&to, entry),
            // The entry stays at its place in the list.
            Some(place) => {
                self.files.entries.insert(place, entry);
                self.files.paths.insert(place, to);
            }
            None => self.put(&to, entry),
        }
    }

    /// The list for pages.
    pub(crate) fn entries(&self) -> &[GalleryEntry] {
        &self.files.entries
    }

    /// The list of deleted files, for instructors.
    pub(crate) fn deleted(&self) -> &[GalleryEntry] {
        &self.deleted.entries
    }

    /// An entry of the gallery, and the path of its file.
    pub(crate) fn get(&self, file: &str) -> Option<(&GalleryEntry, &Path)> {
        self.files.get(file)
    }

    /// An entry of a deleted file, and the path of the file.
    pub(crate) fn get_deleted(&self, file: &str) -> Option<(&GalleryEntry, &Path)> {
        self.deleted.get(file)
    }

    /// The path of the file that belongs to an entry.
    pub(crate) fn path(&self, file: &str) -> Option<&Path> {
        self.files.get(file).map(|(_, path)| path)
    }
}

/// True if the path is that of a folder. A link to a folder does not count as a folder.
pub(crate) fn is_folder(path: &Path) -> bool {
    path.symlink_metadata().is_ok_and(|of| of.is_dir())
}

/// The first files of a folder, in the order of their names.
fn files_of(folder: &Path) -> Vec<PathBuf> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
    paths.sort();
    paths.truncate(MOST_READ);
    paths
}

/// True if two paths, as they are written, name the same folder. An empty path stands for the present folder.
fn is_same_folder(one: &Path, other: &Path) -> bool {
    let written = |path: &Path| match path.as_os_str().is_empty() {
        true => PathBuf::from("."),
        false => path.to_owned(),
    };
    written(one) == written(other)
}

pub(crate) fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The gallery's entry of a file; `None` if the file cannot be opened. Of a recording, only the first line is read.
pub(crate) fn entry(path: &Path) -> Option<GalleryEntry> {
    entry_among(path, path.parent().unwrap_or(Path::new("")))
}

/// The gallery's entry of a file whose scenario names files in `folder`.
pub(crate) fn entry_among(path: &Path, folder: &Path) -> Option<GalleryEntry> {
    let name = name_of(path);
    if name.ends_with(ENDING) {
        recording_entry(path, name)
    } else if name.ends_with(EXERCISE_ENDING) {
        scenario_entry(path, name, folder)
    } else {
        None
    }
}

fn scenario_entry(path: &Path, file: String, folder: &Path) -> Option<GalleryEntry> {
    let text = read_text(path).ok()?;
    let comment = Source::leading_comment(&text);
    let (_, scenario) = Source::collect(&file, text, vec![], within(folder)).ok()?;
    if scenario.setup.world.vessels.is_empty() {
        return None;
    }
    let berth = berth_words(&scenario.setup);
    let changeable = FROM_THE_PAGE.iter().any(|words| comment.contains(words));
    let (title, text) = (scenario.title, comment);
    Some(GalleryEntry { file, title, text, berth, written_unix_s: None, changeable })
}

fn recording_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let recording = saved::open(path).ok()??;
    let title = saved::title(&recording)?;
    let written = recording.metadata().and_then(|of| of.modified()).ok();
    let written_unix_s =
        written.and_then(|at| at.duration_since(UNIX_EPOCH).ok()).map(|at| at.as_secs());
    let name = file.strip_suffix(ENDING).unwrap_or(&file);
    let text = format!("Saved as {name}. The session continues where it ended.");
    Some(GalleryEntry {
        title: format!("Session: {title}"),
        text,
        file,
        berth: None,
        written_unix_s,
        changeable: true,
    })
}

/// Makes a function that reads the files which a scenario beside them names. The named files lie in the same folder as
/// the scenario.
pub(crate) fn beside(scenario: &Path) -> impl FnMut(&str) -> Result<String, String> {
    within(scenario.parent().unwrap_or(Path::new("")))
}

/// Makes a function that reads the files which a scenario names, from the folder `folder`.
fn within(folder: &Path) -> impl FnMut(&str) -> Result<String, String> {
    let folder = folder.to_owned();
    let mut left = LARGEST_SCENARIO;
    move |name| {
        let text = read_text(&folder.join(name))?;
        left = left.checked_sub(text.len()).ok_or_else(|| {
            format!(
                "{name}: with this file, the scenario and its files are larger than {} MiB",
                LARGEST_SCENARIO >> 20
            )
        })?;
        Ok(text)
    }
}

/// A session that was opened from a scenario or from a recording.
pub(crate) struct Opened {
    pub(crate) session: Session,
    /// The recording that the session continues, with the recording's outline; `None` for a new session.
    pub(crate) recorded: Option<(File, Outline)>,
    /// The links and the holders of controls that belong to the continued recording, if they were kept.
    pub(crate) seats: Option<KeptSeats>,
    /// Notices for the user.
    pub(crate) notices: Vec<String>,
}

/// Opens a scenario or a recording as a session. A recording continues where it ended. Pages show `ghost` beside the
/// ships of a scenario.
///
/// # Errors
/// The error says what is wrong with the file, as a text for the user. If `watch` stopped the opening, the error is the
/// reason that `watch` gave.
pub(crate) fn open(
    path: &Path,
    set: &[String],
    ghost: Option<&Ghost>,
    watch: Watch<'_>,
) -> Result<Opened, String> {
    if let Some(file) = saved::open(path).map_err(|why| format!("cannot read {why}"))? {
        if let Some(ghost) = ghost {
            return Err(format!(
                "{}: a recorded session keeps the measured track with which it began; {} cannot be added",
                path.display(),
                ghost.file
            ));
        }
        return open_recording(path, file, set, watch);
    }
    if name_of(path).ends_with(ENDING) {
        return Err(format!(
            "{}: this is not a recorded session, although the file's name says so",
            path.display()
        ));
    }
    let text = read_text(path).map_err(|why| format!("cannot read {why}"))?;
    let (mut source, scenario) = Source::collect(&name_of(path), text, set.to_vec(), beside(path))
        .map_err(|e| e.to_string().trim_start_matches("error: ").to_owned())?;
    if scenario.setup.world.vessels.is_empty() {
        return Err(format!(
            "{}: the scenario has no vessel that could be steered",
            path.display()
        ));
    }
    let notices = scenario.notices.iter().map(ToString::to_string).collect();
    source.ghost = ghost.cloned();
    let session = Session::open(source).map_err(|e| e.to_string())?;
    Ok(Opened { session, recorded: None, seats: None, notices })
}

fn open_recording(
    path: &Path,
    file: File,
    set: &[String],
    watch: Watch<'_>,
) -> Result<Opened, String> {
    let name = path.display();
    if !set.is_empty() {
        return Err(format!("{name}: keys of a recorded session cannot be set"));
    }
    let replayed = saved::replay(file, watch).map_err(|e| format!("{name}, {e}"))?;
    let Replayed { session, outline, version, file, .. } = replayed;
    let mut notices: Vec<String> = saved::missing_at_end(outline.ending)
        .map(|missing| format!("{name}: {missing}"))
        .into_iter()
        .collect();
    if version != env!("CARGO_PKG_VERSION") {
        notices.push(format!(
            "{name} was recorded by version {version} of the program, which may compute different bits"
        ));
    }
    let seats = kept_seats::read(&kept_seats::beside(path)).unwrap_or_else(|why| {
        notices.push(format!("{why}: everybody gets a new link"));
        None
    });
    Ok(Opened { session, recorded: Some((file, outline)), seats, notices })
}
