//! What takes a while is done beside the simulation's thread: opening a scenario or a session, and saving one. One at a
//! time; its owner sees how far it is, and can stop it.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use fenderline_live::message::{GalleryEntry, OpeningNow};

use super::claims::ClientId;
use super::gallery::{self, Opened};
use super::recorder::{Copy, Recorder};
use super::saved::Way;

/// A recording that is played for longer is given up: `fenderline replay` has no such limit.
const LONGEST: Duration = Duration::from_secs(600);

/// Who asked, and with which command.
#[derive(Clone, Debug)]
pub(crate) struct Asked {
    pub(crate) client: ClientId,
    pub(crate) label: String,
    pub(crate) id: Option<i64>,
}

/// What came of it, for the simulation's thread.
pub(crate) enum Outcome {
    /// Something to go on with, already recorded to a file of its own; or why not.
    Opened(Box<Result<(Opened, Recorder), String>>),
    /// A copy, and its entry in the gallery; or why not.
    Saved(Result<(PathBuf, Option<GalleryEntry>), String>),
    /// Its thread panicked: a mistake of ours, told on standard error. The session goes on.
    Lost,
}

/// Shares of work are counted in so many parts.
const PARTS: u64 = 1000;

/// How far it is, and whether it shall go on.
#[derive(Debug, Default)]
struct Progress {
    plays: AtomicBool,
    parts: AtomicU64,
    stop: AtomicBool,
}

/// Something that is being done.
pub(crate) struct Work {
    pub(crate) asked: Asked,
    /// What is opened; `None` where a session is saved.
    pub(crate) file: Option<String>,
    progress: Arc<Progress>,
    thread: JoinHandle<()>,
}

impl Work {
    /// Opens an entry of the gallery, and begins its recording in a folder.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn open(
        send: impl FnOnce(Outcome) + Send + 'static,
        asked: Asked,
        file: String,
        path: PathBuf,
        sessions: PathBuf,
    ) -> io::Result<Work> {
        let progress = Arc::new(Progress::default());
        let (seen, name) = (Arc::clone(&progress), file.clone());
        let until = Instant::now() + LONGEST;
        let open = move || {
            let watch = &mut |way: Way| {
                let (plays, done, of) = match way {
                    Way::Reads(done, of) => (false, done, of),
                    Way::Plays(done, of) => (true, done, of),
                };
                seen.plays.store(plays, Ordering::Relaxed);
                seen.parts.store(PARTS * done.min(of) / of.max(1), Ordering::Relaxed);
                if seen.stop.load(Ordering::Relaxed) {
                    return Err("it was stopped".to_owned());
                }
                if Instant::now() > until {
                    let minutes = LONGEST.as_secs() / 60;
                    return Err(format!("it takes more than {minutes} min, and is given up"));
                }
                Ok(())
            };
            gallery::open(&path, &[], watch).and_then(|mut opened| {
                let recorder = Recorder::begin(&sessions, &name, &mut opened)?;
                Ok((opened, recorder))
            })
        };
        let done = move |opened| Outcome::Opened(Box::new(opened));
        Work::start(send, asked, Some(file), progress, move || done(open()))
    }

    /// Saves a copy of a recording.
    ///
    /// # Errors
    /// The system gives no thread.
    pub(crate) fn save(
        send: impl FnOnce(Outcome) + Send + 'static,
        asked: Asked,
        copy: Copy,
    ) -> io::Result<Work> {
        let save = move || {
            let saved = copy.make();
            Outcome::Saved(saved.map(|path| {
                let entry = gallery::entry(&path);
                (path, entry)
            }))
        };
        Work::start(send, asked, None, Arc::default(), save)
    }

    fn start(
        send: impl FnOnce(Outcome) + Send + 'static,
        asked: Asked,
        file: Option<String>,
        progress: Arc<Progress>,
        work: impl FnOnce() -> Outcome + Send + 'static,
    ) -> io::Result<Work> {
        let thread = std::thread::Builder::new().name("opening".into()).spawn(move || {
            let outcome = catch_unwind(AssertUnwindSafe(work));
            send(outcome.unwrap_or(Outcome::Lost));
        })?;
        Ok(Work { asked, file, progress, thread })
    }

    /// How far it is, if something is being opened.
    pub(crate) fn now(&self) -> Option<OpeningNow> {
        let at = if self.progress.plays.load(Ordering::Relaxed) { "plays" } else { "reads" };
        let parts = self.progress.parts.load(Ordering::Relaxed);
        let share = parts as f64 / PARTS as f64;
        Some(OpeningNow { file: self.file.clone()?, at, share })
    }

    /// It shall not go on; false for a session that is being saved.
    pub(crate) fn stop(&self) -> bool {
        self.progress.stop.store(true, Ordering::Relaxed);
        self.file.is_some()
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.progress.stop.load(Ordering::Relaxed)
    }

    /// Waits for a session that is being saved: half a copy is none. What is being opened is left alone.
    pub(crate) fn finish(self) {
        if self.file.is_none() {
            let _ = self.thread.join();
        }
    }
}
