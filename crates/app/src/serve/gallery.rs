//! What the instructor can open: scenarios of a folder, and saved sessions.

use std::fs;
use std::path::{Path, PathBuf};

use fenderline_live::message::GalleryEntry;
use fenderline_live::{Recording, Session, Source};
use fenderline_scenario::read_text as read;

use super::recorder::ENDING;

/// What is read from the files of a gallery at most.
const MOST: usize = 200;

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
            paths.iter().for_each(|path| self.add(path));
        }
    }

    /// Adds a file that can be opened.
    pub(crate) fn add(&mut self, path: &Path) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if self.paths.len() >= MOST || self.told.iter().any(|entry| entry.file == name) {
            return;
        }
        let entry = if name.ends_with(ENDING) {
            recording_entry(path, name)
        } else if name.ends_with(".toml") {
            scenario_entry(path, name)
        } else {
            None
        };
        if let Some(entry) = entry {
            self.told.push(entry);
            self.paths.push(path.to_owned());
        }
    }

    /// As pages are told.
    pub(crate) fn told(&self) -> &[GalleryEntry] {
        &self.told
    }

    /// The file of an entry.
    pub(crate) fn path(&self, file: &str) -> Option<&Path> {
        let index = self.told.iter().position(|entry| entry.file == file)?;
        Some(&self.paths[index])
    }
}

fn scenario_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let text = read(path).ok()?;
    let folder = path.parent().unwrap_or(Path::new(""));
    let beside = |name: &str| read(&folder.join(name));
    let comment = Source::leading_comment(&text);
    let (_, scenario) = Source::collect(&file, text, vec![], beside).ok()?;
    if scenario.setup.world.vessels.is_empty() {
        return None;
    }
    Some(GalleryEntry { file, title: scenario.title, text: comment })
}

fn recording_entry(path: &Path, file: String) -> Option<GalleryEntry> {
    let text = read(path).ok()?;
    let first = &text[..=text.find('\n')?];
    let title = Recording::parse(first).ok()?.source.scenario().ok()?.title;
    let name = file.strip_suffix(ENDING).unwrap_or(&file);
    let text = format!("Saved as {name}; it goes on where it ended.");
    Some(GalleryEntry { title: format!("Session: {title}"), text, file })
}

/// A session that was opened, and the text that its recording begins with.
pub(crate) struct Opened {
    pub(crate) session: Session,
    pub(crate) recorded: String,
    /// What a user should know of it.
    pub(crate) notices: Vec<String>,
}

/// Opens a scenario, or a recording that goes on where it ended.
///
/// # Errors
/// What is wrong with it, for its reader.
pub(crate) fn open(path: &Path, set: &[String]) -> Result<Opened, String> {
    let text = read(path).map_err(|why| format!("cannot read {why}"))?;
    if Recording::is_one(&text) {
        return open_recording(path, &text, set);
    }
    let folder = path.parent().unwrap_or(Path::new(""));
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let beside = |name: &str| read(&folder.join(name));
    let (source, scenario) =
        Source::collect(&name, text, set.to_vec(), beside).map_err(|e| e.to_string())?;
    if scenario.setup.world.vessels.is_empty() {
        return Err(format!("{}: it has no vessel: there is nothing to steer", path.display()));
    }
    let notices = scenario.notices.iter().map(ToString::to_string).collect();
    let recorded = Recording::header(&source);
    let session = Session::open(source).map_err(|e| e.to_string())?;
    Ok(Opened { session, recorded, notices })
}

fn open_recording(path: &Path, text: &str, set: &[String]) -> Result<Opened, String> {
    let name = path.display();
    if !set.is_empty() {
        return Err(format!("{name}: a recorded session goes on as it began: no key can be set"));
    }
    let recording = Recording::parse(text).map_err(|e| format!("{name}, {e}"))?;
    let mut notices = Vec::new();
    if recording.torn_bytes > 0 {
        let torn = recording.torn_bytes;
        notices.push(format!("{name}: {torn} bytes of a last line that was torn off are dropped"));
    }
    if recording.version != env!("CARGO_PKG_VERSION") {
        let version = &recording.version;
        notices.push(format!("{name}: recorded by version {version}, which may make other bits"));
    }
    let (session, _) = Session::replay(&recording).map_err(|e| format!("{name}, {e}"))?;
    let recorded = text[..recording.whole_bytes].to_owned();
    Ok(Opened { session, recorded, notices })
}
