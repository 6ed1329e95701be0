//! Writes a new exercise to the gallery's folder. An exercise is never written over another file without permission,
//! and never outside the folder.

use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::{Path, PathBuf};

use fenderline_author::{BerthSource, NewExercise};
use fenderline_live::message::GalleryEntry;
use fenderline_scenario::read_text;

use super::file_name;
use super::gallery::{self, EXERCISE_ENDING};

/// What is written to a new exercise file.
#[derive(Debug)]
pub(crate) enum Content {
    /// Choices. Choices of the instructor; if the exercise takes the berth of a scenario, also the path of that
    /// scenario.
    Choices(Box<NewExercise>, Option<PathBuf>),
    /// The text of a scenario, with the texts of the files that the scenario names. The named files must lie in the
    /// folder of exercises with the same content.
    Text(String, BTreeMap<String, String>),
}

impl Content {
    /// The text that is written to the exercise file.
    fn text(&self, folder: &Path) -> Result<String, String> {
        match self {
            Content::Choices(exercise, None) => exercise.text().map_err(|error| error.to_string()),
            Content::Choices(exercise, Some(berth)) => {
                let source = read_text(berth)?;
                let file = gallery::name_of(berth);
                let source = BerthSource { file: &file, text: &source };
                // The files that the scenario names must lie in the new file's folder.
                let beside = folder.join("exercise.toml");
                let mut read = gallery::beside(&beside);
                exercise.text_at(source, &mut read).map_err(|error| error.to_string())
            }
            Content::Text(text, files) => {
                for (name, content) in files {
                    let there = read_text(&folder.join(name)).ok();
                    if there.as_ref() != Some(content) {
                        return Err(format!(
                            "the scenario names the file {name}, but the folder of exercises does not have the \
                             session's version of it: put that file there first"
                        ));
                    }
                }
                Ok(text.clone())
            }
        }
    }
}

/// An exercise file that is about to be written.
#[derive(Debug)]
pub(crate) struct NewFile {
    to: PathBuf,
    name: String,
    content: Content,
    may_replace: bool,
}

impl NewFile {
    /// Prepares an exercise file of a given name, in a folder. Preparing the file does not use the file system.
    ///
    /// # Errors
    /// Refuses a name that is not safe as a file name.
    pub(crate) fn new(
        folder: &Path,
        name: &str,
        content: Content,
        may_replace: bool,
    ) -> Result<NewFile, String> {
        file_name::check(name).map_err(|error| error.to_string())?;
        let to = folder.join(format!("{name}{EXERCISE_ENDING}"));
        Ok(NewFile { to, name: name.to_owned(), content, may_replace })
    }

    /// True if the new exercise file replaces an old one.
    fn replaces(&self) -> Result<bool, String> {
        let name = &self.name;
        match self.to.symlink_metadata() {
            Err(_) => Ok(false),
            Ok(_) if !self.may_replace => {
                Err(format!("there is already an exercise named {name}, which stays as it is"))
            }
            Ok(what) if !what.is_file() => {
                Err(format!("{name}.toml is a link or not a file, and is not replaced"))
            }
            Ok(_) => Ok(true),
        }
    }

    /// Writes the exercise file and makes its entry in the gallery.
    ///
    /// # Errors
    /// Fails if the name is taken and must not be replaced. Fails too if the path is a link or is not a file. Fails too
    /// if the choices do not make an exercise. Fails too if the file system gives an error. A call that fails
    /// changes no file.
    pub(crate) fn write(&self) -> Result<(PathBuf, GalleryEntry), String> {
        let replaces = self.replaces()?;
        let folder = self.to.parent().unwrap_or(Path::new(""));
        let text = self.content.text(folder)?;
        let failed = |error: std::io::Error| format!("{}: {error}", self.to.display());
        if replaces {
            // Writes under another name first, so that a full disk does not destroy the old exercise.
            let beside = self.to.with_extension("toml.new");
            let written =
                create(&beside, &text).and_then(|()| fs::rename(&beside, &self.to)).map_err(failed);
            if written.is_err() {
                let _ = fs::remove_file(&beside);
            }
            written?;
        } else {
            // This fails if somebody else has made a file with this name meanwhile.
            create(&self.to, &text).map_err(failed)?;
        }
        let entry = gallery::entry(&self.to);
        let entry =
            entry.ok_or_else(|| format!("{}: it cannot be read back", self.to.display()))?;
        Ok((self.to.clone(), entry))
    }
}

/// Writes a new file. Writes a new file; fails if the file exists.
fn create(path: &Path, text: &str) -> std::io::Result<()> {
    let mut file = OpenOptions::new().write(true).create_new(true).open(path)?;
    file.write_all(text.as_bytes())?;
    file.sync_all()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn exercise(title: &str) -> NewExercise {
        serde_json::from_value(serde_json::json!({
            "title": title,
            "berth": {
                "length_m": 300, "depth_m": 24, "fender": "cone SPC", "size": null, "height_m": 1.6,
                "rated_reaction_n": 1.5e6, "fenders": 5, "fender_spacing_m": 30, "bollard_spacing_m": 25
            },
            "ship": {
                "vessel": "bulk-carrier", "side": "starboard", "off_m": 60, "astern_m": 200, "speed_mps": 0.8
            },
            "tugs": { "vessel": "asd-tug", "number": 1 },
            "weather": {
                "wind_mps": 0, "wind_from_rad": 0, "gusts": false, "current_mps": 0, "current_to_rad": 0,
                "visibility_m": null
            }
        }))
        .expect("choices")
    }

    fn choices(exercise: NewExercise) -> Content {
        Content::Choices(Box::new(exercise), None)
    }

    #[test]
    fn an_exercise_is_never_saved_over_another_without_leave_and_never_outside_of_its_folder() {
        let folder = std::env::temp_dir().join(format!("fenderline-new-{}", std::process::id()));
        fs::create_dir_all(&folder).expect("a folder");
        let new = |name: &str, title: &str, may_replace| {
            NewFile::new(&folder, name, choices(exercise(title)), may_replace)?.write()
        };
        let (path, entry) = new("mine", "One", false).expect("it is new");
        assert_eq!((entry.file.as_str(), entry.title.as_str()), ("mine.toml", "One"));
        assert!(entry.changeable, "it was saved from the page");
        let first = fs::read(&path).expect("a file");
        // A text that names files which do not exist, or whose content differs.
        let named = |content: &str| {
            let files = BTreeMap::from([("chart.geojson".to_owned(), content.to_owned())]);
            let text = Content::Text("title = \"x\"".to_owned(), files);
            NewFile::new(&folder, "named", text, false).expect("a good name").write().unwrap_err()
        };
        assert!(named("{}").contains("names the file chart.geojson"), "{}", named("{}"));
        assert!(new("mine", "Two", false).unwrap_err().contains("already"));
        assert_eq!(fs::read(&path).expect("a file"), first);
        // A mistake in the choices changes nothing either.
        let mut bad = exercise("Two");
        bad.berth.fenders = 0;
        let refused =
            NewFile::new(&folder, "mine", choices(bad), true).expect("a good name").write();
        assert!(refused.unwrap_err().contains("at least one fender"));
        assert_eq!(fs::read(&path).expect("a file"), first);
        assert_eq!(new("mine", "Two", true).expect("it may").1.title, "Two");
        for name in
            ["", "..", "a/b", "../mine", "a.toml", "ü", "a b", "a\\b", "nul\0", &"a".repeat(61)]
        {
            assert!(new(name, "x", true).unwrap_err().contains("letters"), "{name}");
        }
        assert!(new("con", "x", true).unwrap_err().contains("a device on Windows"));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink(&path, folder.join("link.toml")).expect("a link");
            assert!(new("link", "x", true).unwrap_err().contains("a link"));
        }
        let files = fs::read_dir(&folder).expect("a folder").count();
        assert_eq!(files, if cfg!(unix) { 2 } else { 1 });
        fs::remove_dir_all(&folder).expect("it is ours");
    }
}
