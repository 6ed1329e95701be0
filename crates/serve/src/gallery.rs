//! The gallery: scenarios of a folder and saved sessions that the instructor can open.

use std::fs::{self, File};
use std::path::{Path, PathBuf};

use fenderline_live::message::GalleryEntry;
use fenderline_live::{Outline, Session, Source};
use fenderline_scenario::read_text;

use super::saved::{self, ENDING, Played, Watch};

/// What is read from the files of a gallery at most, and how many files of a folder are looked at for that.
const MOST: usize = 200;
const LOOKED_AT: usize = 1000;
/// A scenario and the files that it names together (bytes).
const LARGEST_SCENE: usize = 64 << 20;

/// A list of files that can be opened, by name. Nothing else can: a page names an entry, not a path.
#[derive(Clone, Debug, Default)]
pub(crate) struct Gallery {
    told: Vec<GalleryEntry>,
    paths: Vec<PathBuf>,
}

impl Gallery {
    /// Adds scenarios with a vessel in them, and recordings, of these folders; of files of one name the first.
    pub(crate) fn fill(&mut self, folders: &[&Path]) {
        for folder in folders {
            let Ok(entries) = fs::read_dir(folder) else { continue };
            let mut paths: Vec<PathBuf> = entries.flatten().map(|entry| entry.path()).collect();
            paths.sort();
            paths.iter().take(LOOKED_AT).for_each(|path| self.add(path));
        }
    }

    /// Adds a file, if it can be opened.
    pub(crate) fn add(&mut self, path: &Path) {
        let name = name_of(path);
        if self.paths.len() < MOST
            && !self.told.iter().any(|entry| entry.file == name)
            && let Some(entry) = entry(path)
        {
            self.put(path, entry);
        }
    }

    /// Adds an entry that was made of a file.
    pub(crate) fn put(&mut self, path: &Path, entry: GalleryEntry) {
        if self.paths.len() < MOST && !self.told.iter().any(|other| other.file == entry.file) {
            self.told.push(entry);
            self.paths.push(path.to_owned());
        }
    }

    /// The list for pages.
    pub(crate) fn told(&self) -> &[GalleryEntry] {
        &self.told
    }

    /// The file of an entry.
    pub(crate) fn path(&self, file: &str) -> Option<&Path> {
        let index = self.told.iter().position(|entry| entry.file == file)?;
        Some(&self.paths[index])
    }
}

fn name_of(path: &Path) -> String {
    path.file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// What a gallery tells of a file; `None` for one that cannot be opened. Of a recording its first line is read.
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
    Some(GalleryEntry { file, title: scenario.title, text: comment })
}

fn recording_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let title = saved::title(&saved::open(path).ok()??)?;
    let name = file.strip_suffix(ENDING).unwrap_or(&file);
    let text = format!("Saved as {name}; it goes on where it ended.");
    Some(GalleryEntry { title: format!("Session: {title}"), text, file })
}

/// Reads the files that a scenario names, which lie beside it.
fn beside(scenario: &Path) -> impl FnMut(&str) -> Result<String, String> {
    let folder = scenario.parent().unwrap_or(Path::new("")).to_owned();
    let mut left = LARGEST_SCENE;
    move |name| {
        let text = read_text(&folder.join(name))?;
        left = left.checked_sub(text.len()).ok_or_else(|| {
            format!("{name}: with it the files are larger than {} MiB", LARGEST_SCENE >> 20)
        })?;
        Ok(text)
    }
}

/// A session that was opened.
pub(crate) struct Opened {
    pub(crate) session: Session,
    /// What its recording begins with; `None`: the session's own first lines.
    pub(crate) recorded: Option<(File, Outline)>,
    /// What a user should know of it.
    pub(crate) notices: Vec<String>,
}

/// Opens a scenario, or a recording that goes on where it ended.
///
/// # Errors
/// What is wrong with it, for its reader, or why `watch` wanted no more.
pub(crate) fn open(path: &Path, set: &[String], watch: Watch<'_>) -> Result<Opened, String> {
    if let Some(file) = saved::open(path).map_err(|why| format!("cannot read {why}"))? {
        return open_recording(path, file, set, watch);
    }
    let text = read_text(path).map_err(|why| format!("cannot read {why}"))?;
    let (source, scenario) = Source::collect(&name_of(path), text, set.to_vec(), beside(path))
        .map_err(|e| e.to_string())?;
    if scenario.setup.world.vessels.is_empty() {
        return Err(format!("{}: it has no vessel: there is nothing to steer", path.display()));
    }
    let notices = scenario.notices.iter().map(ToString::to_string).collect();
    let session = Session::open(source).map_err(|e| e.to_string())?;
    Ok(Opened { session, recorded: None, notices })
}

fn open_recording(
    path: &Path,
    file: File,
    set: &[String],
    watch: Watch<'_>,
) -> Result<Opened, String> {
    let name = path.display();
    if !set.is_empty() {
        return Err(format!("{name}: a recorded session goes on as it began: no key can be set"));
    }
    let played = saved::play(file, watch).map_err(|e| format!("{name}, {e}"))?;
    let Played { session, outline, version, file, .. } = played;
    let mut notices: Vec<String> = saved::told_of_end(outline.ending)
        .map(|told| format!("{name}: {told}"))
        .into_iter()
        .collect();
    if version != env!("CARGO_PKG_VERSION") {
        notices.push(format!("{name}: recorded by version {version}, which may make other bits"));
    }
    Ok(Opened { session, recorded: Some((file, outline)), notices })
}
