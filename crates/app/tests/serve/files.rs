//! Recordings and saved exercises are renamed, deleted and put back from the page: by the instructor alone, nothing is overwritten, and nothing
//! outside of their folders is touched.

use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

use serde_json::{Value, json};
use tokio::time::sleep;

use super::{block_on, reason};
use crate::client::Client;
use crate::server::{self, Server};

const KEPT: &str = "kept.session.jsonl";

/// A folder of exercises, removed at the end.
struct Gallery(PathBuf);

impl Gallery {
    /// With a scenario that somebody wrote by hand.
    fn new(name: &str) -> Gallery {
        let name = format!("fenderline-files-{}-{name}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(&folder).expect("a folder");
        fs::copy(server::scenario(), folder.join("by_hand.toml")).expect("copied");
        Gallery(folder)
    }

    fn options(&self) -> [&str; 3] {
        ["--paused", "--gallery", self.0.to_str().expect("a plain path")]
    }

    fn start(&self) -> Server {
        Server::start(&self.options())
    }
}

impl Drop for Gallery {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn rename(file: &str, name: &str) -> Value {
    json!({ "do": "rename", "file": file, "name": name })
}

fn delete(file: &str) -> Value {
    json!({ "do": "delete", "file": file })
}

fn put_back(file: &str) -> Value {
    json!({ "do": "put_back", "file": file })
}

fn save(name: &str) -> Value {
    json!({ "do": "save", "name": name })
}

fn save_exercise(name: &str) -> Value {
    json!({ "do": "save_exercise", "name": name, "title": "Mine", "replace": false })
}

async fn accepted(client: &mut Client, action: Value) {
    let answer = client.ask(action.clone()).await;
    assert_eq!(answer["type"], "ack", "{action}: {answer}");
}

async fn refused(client: &mut Client, action: Value, word: &str) {
    // A client may give some thirty commands a second.
    sleep(Duration::from_millis(40)).await;
    let answer = client.ask(action.clone()).await;
    assert!(reason(&answer).contains(word), "{action}: {answer}");
}

/// The names of a list of the greeting, sorted.
fn names(hello: &Value, list: &str) -> Vec<String> {
    let files = hello[list].as_array().expect("a list").iter();
    let mut names: Vec<String> =
        files.map(|entry| entry["file"].as_str().expect("a name").to_owned()).collect();
    names.sort();
    names
}

/// The names of the files of a folder, sorted.
fn files(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(folder)
        .expect("a folder")
        .flatten()
        .filter(|entry| entry.path().is_file())
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    names.sort();
    names
}

#[test]
fn the_instructor_renames_deletes_and_puts_back_and_a_server_that_starts_again_knows() {
    block_on(async {
        let gallery = Gallery::new("good");
        let server = gallery.start();
        let options = gallery.options();
        let sessions = server.sessions();
        let mut instructor = Client::join(&server, "instructor").await;
        let pilot = Client::join(&server, "pilot").await;
        assert!(pilot.hello["deleted"].is_null(), "what was deleted is the instructor's");
        accepted(&mut instructor, save("kept")).await;
        accepted(&mut instructor, save_exercise("mine")).await;
        let text = fs::read(sessions.join(KEPT)).expect("it was saved");
        accepted(&mut instructor, rename(KEPT, "second_try")).await;
        accepted(&mut instructor, rename("mine.toml", "ours")).await;
        let hello = instructor
            .hello_with(|hello| names(hello, "gallery").contains(&"ours.toml".to_owned()))
            .await;
        assert_eq!(
            names(&hello, "gallery"),
            ["by_hand.toml", "harbour.toml", "ours.toml", "second_try.session.jsonl"]
        );
        let entry = |file: &str| {
            let entries = hello["gallery"].as_array().expect("a list").iter();
            entries.clone().find(|entry| entry["file"] == file).expect("an entry").clone()
        };
        assert!(entry("second_try.session.jsonl")["text"].to_string().contains("second_try"));
        let changeable = |file: &str| entry(file)["changeable"] == true;
        assert!(changeable("ours.toml") && changeable("second_try.session.jsonl"));
        assert!(!changeable("by_hand.toml") && !changeable("harbour.toml"));
        assert_eq!(fs::read(sessions.join("second_try.session.jsonl")).ok(), Some(text.clone()));
        assert_eq!(files(&gallery.0), ["by_hand.toml", "ours.toml"]);
        // Deleted, a second one of the same name too, and back.
        accepted(&mut instructor, delete("second_try.session.jsonl")).await;
        accepted(&mut instructor, delete("ours.toml")).await;
        accepted(&mut instructor, save_exercise("ours")).await;
        accepted(&mut instructor, delete("ours.toml")).await;
        let deleted = ["ours-2.toml", "ours.toml", "second_try.session.jsonl"];
        let hello = instructor.hello_with(|hello| names(hello, "deleted").len() == 3).await;
        assert_eq!(names(&hello, "deleted"), deleted);
        assert_eq!(names(&hello, "gallery"), ["by_hand.toml", "harbour.toml"]);
        assert_eq!(files(&gallery.0.join("deleted")), ["ours-2.toml", "ours.toml"]);
        accepted(&mut instructor, put_back("second_try.session.jsonl")).await;
        accepted(&mut instructor, put_back("ours-2.toml")).await;
        assert_eq!(fs::read(sessions.join("second_try.session.jsonl")).ok(), Some(text));
        assert_eq!(files(&gallery.0), ["by_hand.toml", "ours-2.toml"]);
        // It opens. The session that ended has links: they go with it, and come back with it.
        instructor.load("ours-2.toml").await;
        instructor.load("second_try.session.jsonl").await;
        let ended = "harbour-001";
        let (recording, links) = (format!("{ended}.session.jsonl"), format!("{ended}.links.json"));
        let secret = fs::read(sessions.join(&links)).expect("links");
        // Without a step it is not in the list.
        refused(&mut instructor, delete(&recording), "there is no").await;
        let server = server.killed_and_started_again(&options);
        let mut instructor = Client::join(&server, "instructor").await;
        accepted(&mut instructor, rename("second_try.session.jsonl", "third")).await;
        accepted(&mut instructor, save("last")).await;
        fs::write(sessions.join("last.links.json"), &secret).expect("written");
        accepted(&mut instructor, rename("last.session.jsonl", "latest")).await;
        accepted(&mut instructor, delete("latest.session.jsonl")).await;
        let gone = sessions.join("deleted");
        assert_eq!(files(&gone), ["latest.links.json", "latest.session.jsonl"]);
        assert_eq!(fs::read(gone.join("latest.links.json")).ok(), Some(secret.clone()));
        let server = server.killed_and_started_again(&options);
        let mut instructor = Client::join(&server, "instructor").await;
        assert_eq!(names(&instructor.hello, "deleted"), ["latest.session.jsonl", "ours.toml"]);
        accepted(&mut instructor, put_back("latest.session.jsonl")).await;
        assert_eq!(fs::read(sessions.join("latest.links.json")).ok(), Some(secret));
        assert!(files(&gone).is_empty());
        server.stop_and_check();
    });
}

#[test]
fn a_file_stays_as_it_is_and_the_instructor_reads_why() {
    block_on(async {
        let gallery = Gallery::new("bad");
        let server = gallery.start();
        let sessions = server.sessions();
        let mut instructor = Client::join(&server, "instructor").await;
        for name in ["kept", "other"] {
            accepted(&mut instructor, save(name)).await;
        }
        accepted(&mut instructor, save_exercise("mine")).await;
        let before = (files(&sessions), files(&gallery.0));
        // Only the instructor.
        for role in ["pilot", "master of aft", "observer"] {
            let mut other = Client::join(&server, role).await;
            for action in [rename(KEPT, "x"), delete(KEPT), put_back(KEPT)] {
                refused(&mut other, action, "only the instructor").await;
            }
        }
        // Names that are none, or of another kind.
        let long = "x".repeat(61);
        for name in [
            "",
            ".",
            "..",
            ".kept",
            "a/b",
            "../kept",
            "/tmp/kept",
            "a\\b",
            "a b",
            "x.toml",
            "ü",
            &long,
        ] {
            refused(&mut instructor, rename(KEPT, name), "letters, digits").await;
            refused(&mut instructor, rename("mine.toml", name), "letters, digits").await;
            refused(&mut instructor, save(name), "letters, digits").await;
        }
        for device in ["con", "NUL", "Com1", "lpt9"] {
            refused(&mut instructor, rename(KEPT, device), "a device on Windows").await;
            refused(&mut instructor, save(device), "a device on Windows").await;
            refused(&mut instructor, save_exercise(device), "a device on Windows").await;
        }
        // Files that the gallery has not: paths lead nowhere.
        let absolute = sessions.join(KEPT);
        for file in [
            "",
            ".",
            "..",
            "none.toml",
            "kept",
            "../sessions/kept.session.jsonl",
            "sessions/kept.session.jsonl",
            "..\\mine.toml",
            absolute.to_str().expect("a plain path"),
            "kept.links.json",
        ] {
            refused(&mut instructor, rename(file, "x"), "in the gallery").await;
            refused(&mut instructor, delete(file), "in the gallery").await;
            refused(&mut instructor, put_back(file), "among the deleted files").await;
        }
        // What is in use, and what was written by hand.
        let recording = server.recording().file_name().expect("a name").to_string_lossy();
        for (file, word) in [
            (&*recording, "is being recorded"),
            ("harbour.toml", "this session is one of"),
            ("by_hand.toml", "not saved from the page"),
        ] {
            refused(&mut instructor, rename(file, "x"), word).await;
            refused(&mut instructor, delete(file), word).await;
        }
        refused(&mut instructor, put_back(&recording), "is being recorded").await;
        refused(&mut instructor, put_back(KEPT), "among the deleted files").await;
        // Names that are taken, one by the links of another session alone.
        refused(&mut instructor, rename(KEPT, "other"), "already").await;
        refused(&mut instructor, rename("mine.toml", "by_hand"), "already").await;
        fs::write(sessions.join("once.links.json"), "{}").expect("written");
        refused(&mut instructor, rename(KEPT, "once"), "once.links.json already").await;
        fs::remove_file(sessions.join("once.links.json")).expect("it is ours");
        refused(&mut instructor, json!({ "do": "rename", "file": KEPT }), "missing field").await;
        refused(
            &mut instructor,
            json!({ "do": "delete", "file": KEPT, "name": "x" }),
            "unknown field",
        )
        .await;
        assert_eq!((files(&sessions), files(&gallery.0)), before);
        // Deleted, and another one saved in its place.
        accepted(&mut instructor, delete("mine.toml")).await;
        accepted(&mut instructor, save_exercise("mine")).await;
        refused(&mut instructor, put_back("mine.toml"), "already").await;
        refused(&mut instructor, rename("mine-2.toml", "x"), "in the gallery").await;
        // The exercise that runs.
        instructor.load("mine.toml").await;
        refused(&mut instructor, delete("mine.toml"), "this session is one of").await;
        refused(&mut instructor, rename("mine.toml", "x"), "this session is one of").await;
        // Somebody has put something else in its place.
        fs::remove_file(sessions.join(KEPT)).expect("it is ours");
        refused(&mut instructor, delete(KEPT), "gone").await;
        #[cfg(unix)]
        {
            let link = |to: &str, at: &Path| std::os::unix::fs::symlink(to, at).expect("a link");
            link("other.session.jsonl", &sessions.join(KEPT));
            refused(&mut instructor, rename(KEPT, "x"), "a link").await;
            let outside = gallery.0.join("outside");
            fs::create_dir(&outside).expect("a folder");
            link(outside.to_str().expect("a plain path"), &sessions.join("deleted"));
            refused(&mut instructor, delete("other.session.jsonl"), "no folder").await;
            assert!(files(&outside).is_empty());
            let deleted = gallery.0.join("deleted");
            fs::rename(&deleted, gallery.0.join("aside")).expect("it is ours");
            fs::remove_file(gallery.0.join("mine.toml")).expect("it is ours");
            link(gallery.0.join("aside").to_str().expect("a plain path"), &deleted);
            refused(&mut instructor, put_back("mine.toml"), "a link").await;
        }
        fs::remove_file(sessions.join(KEPT)).unwrap_or(());
        server.stop_and_check();
    });
}
