//! The gallery: scenarios of a folder and saved sessions that the instructor can open.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::time::UNIX_EPOCH;

use fenderline_live::message::GalleryEntry;
use fenderline_live::{Outline, Session, Source};
use fenderline_scenario::{berth_words, read_text};

use super::kept_seats::{self, KeptSeats};
use super::saved::{self, ENDING, Replayed, Watch};

/// Most entries of the gallery, and most files of a folder that are read for it.
const MOST: usize = 200;
const MOST_READ: usize = 1000;
/// A scenario and the files that it names together (bytes).
const LARGEST_SCENARIO: usize = 64 << 20;

/// A list of files that can be opened, by name. Nothing else can: a page names an entry, not a path.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gallery {
    entries: Vec<GalleryEntry>,
    paths: Vec<PathBuf>,
    /// Where new exercises are saved.
    folder: PathBuf,
}

impl Gallery {
    /// Adds the scenarios with a vessel and the recordings of these folders. Of several files with one name only the first
    /// is added.
    pub(crate) fn fill(&mut self, folders: &[&Path]) {
        for folder in folders {
            let Ok(entries) = fs::read_dir(folder) else { continue };
            let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
            paths.sort();
            paths.iter().take(MOST_READ).for_each(|path| self.add(path));
        }
    }

    /// Adds a file, if it can be opened.
    pub(crate) fn add(&mut self, path: &Path) {
        let name = name_of(path);
        if self.paths.len() < MOST
            && !self.entries.iter().any(|entry| entry.file == name)
            && let Some(entry) = entry(path)
        {
            self.put(path, entry);
        }
    }

    /// Adds an entry that was made of a file.
    pub(crate) fn put(&mut self, path: &Path, entry: GalleryEntry) {
        if self.paths.len() < MOST && !self.entries.iter().any(|other| other.file == entry.file) {
            self.entries.push(entry);
            self.paths.push(path.to_owned());
        }
    }

    /// Sets the folder of new exercises.
    pub(crate) fn save_in(&mut self, folder: &Path) {
        folder.clone_into(&mut self.folder);
    }

    /// The folder of new exercises.
    pub(crate) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Adds an entry, in place of one of the same file.
    pub(crate) fn renew(&mut self, path: &Path, entry: GalleryEntry) {
        match self.entries.iter_mut().find(|other| other.file == entry.file) {
            Some(other) => *other = entry,
            None => self.put(path, entry),
        }
    }

    /// The list for pages.
    pub(crate) fn entries(&self) -> &[GalleryEntry] {
        &self.entries
    }

    /// The file of an entry.
    pub(crate) fn path(&self, file: &str) -> Option<&Path> {
        let index = self.entries.iter().position(|entry| entry.file == file)?;
        Some(&self.paths[index])
    }
}

pub(crate) fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// The entry of a file; `None` for a file that cannot be opened. Only the first line of a recording is read.
pub(crate) fn entry(path: &Path) -> Option<GalleryEntry> {
    let name = name_of(path);
    if name.ends_with(ENDING) {
        recording_entry(path, name)
    } else if name.ends_with(".toml") {
        scenario_entry(path, name)
    } else {
        None
    }
}

fn scenario_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let text = read_text(path).ok()?;
    let comment = Source::leading_comment(&text);
    let (_, scenario) = Source::collect(&file, text, vec![], beside(path)).ok()?;
    if scenario.setup.world.vessels.is_empty() {
        return None;
    }
    let berth = berth_words(&scenario.setup);
    Some(GalleryEntry { file, title: scenario.title, text: comment, berth, written_unix_s: None })
}

fn recording_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let recording = saved::open(path).ok()??;
    let title = saved::title(&recording)?;
    let written = recording.metadata().and_then(|of| of.modified()).ok();
    let written_unix_s =
        written.and_then(|at| at.duration_since(UNIX_EPOCH).ok()).map(|at| at.as_secs());
    let name = file.strip_suffix(ENDING).unwrap_or(&file);
    let text = format!("Saved as {name}. It continues where it ended.");
    Some(GalleryEntry {
        title: format!("Session: {title}"),
        text,
        file,
        berth: None,
        written_unix_s,
    })
}

/// Reads the files that a scenario names, which lie beside it.
pub(crate) fn beside(scenario: &Path) -> impl FnMut(&str) -> Result<String, String> {
    let folder = scenario.parent().unwrap_or(Path::new("")).to_owned();
    let mut left = LARGEST_SCENARIO;
    move |name| {
        let text = read_text(&folder.join(name))?;
        left = left.checked_sub(text.len()).ok_or_else(|| {
            format!(
                "{name}: the scenario and its files are larger than {} MiB",
                LARGEST_SCENARIO >> 20
            )
        })?;
        Ok(text)
    }
}

/// A session that was opened.
pub(crate) struct Opened {
    pub(crate) session: Session,
    /// The recording that it continues, with its outline; `None`: a new session.
    pub(crate) recorded: Option<(File, Outline)>,
    /// The links and the holders of controls of the recording that it continues, if they are there.
    pub(crate) seats: Option<KeptSeats>,
    /// Notices for the user.
    pub(crate) notices: Vec<String>,
}

/// Opens a scenario, or a recording, which continues where it ended.
///
/// # Errors
/// What is wrong with the file, as a text for the user; or the reason with which `watch` stopped.
pub(crate) fn open(path: &Path, set: &[String], watch: Watch<'_>) -> Result<Opened, String> {
    if let Some(file) = saved::open(path).map_err(|why| format!("cannot read {why}"))? {
        return open_recording(path, file, set, watch);
    }
    if name_of(path).ends_with(ENDING) {
        return Err(format!(
            "{}: this is not a recorded session, although it is named as one",
            path.display()
        ));
    }
    let text = read_text(path).map_err(|why| format!("cannot read {why}"))?;
    let (source, scenario) = Source::collect(&name_of(path), text, set.to_vec(), beside(path))
        .map_err(|e| e.to_string())?;
    if scenario.setup.world.vessels.is_empty() {
        return Err(format!("{}: there is no vessel in it that could be steered", path.display()));
    }
    let notices = scenario.notices.iter().map(ToString::to_string).collect();
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
            "{name}: recorded by version {version}, which may compute different bits"
        ));
    }
    let seats = kept_seats::read(&kept_seats::beside(path)).unwrap_or_else(|why| {
        notices.push(format!("{why}: everybody gets a new link"));
        None
    });
    Ok(Opened { session, recorded: Some((file, outline)), seats, notices })
}
