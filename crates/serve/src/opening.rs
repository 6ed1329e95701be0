//! Work on another thread, so that the simulation goes on meanwhile: opening, saving, renaming and deleting a scenario
//! or a session, and making a report. Only one piece of work runs at a time. The simulation's thread sees the progress
//! of the work and can stop an opening.

use std::io;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use fenderline_live::message::{GalleryEntry, OpeningNow};

use super::claims::ClientId;
use super::file_change::FileChange;
use super::gallery::{self, Changed, Opened};
use super::new_file::NewFile;
use super::recorder::{Copy, Recorder, SoFar};
use super::saved::Progress as ReplayProgress;

/// A function that makes the report of a recording as a page of HTML. The arguments of the function are the name of the
/// recording's file, the bytes of the file, the number of the branch, and a flag that asks to stop. The program that
/// uses this crate supplies the function, because the crate does not know reports. The function that makes the report
/// runs on another thread.
///
/// The error of the function is the reason why there is no report, for the user.
pub type MakeReport = fn(&str, &[u8], usize, &Arc<AtomicBool>) -> Result<String, String>;

/// Time limit for opening a file of the gallery. The command `fenderline replay` has no limit of time.
const TIME_LIMIT: Duration = Duration::from_secs(600);

/// The client that asked for the work on another thread, and the number of its command.
#[derive(Clone, Debug)]
pub(crate) struct Requester {
    pub(crate) client: ClientId,
    pub(crate) label: String,
    pub(crate) id: Option<i64>,
}

/// An opened session. The opened session is already recorded to a file of its own.
pub(crate) struct Ready {
    pub(crate) opened: Opened,
    pub(crate) recorder: Recorder,
    /// The gallery's entry of the former session's recording, which can be opened again.
    pub(crate) former: Option<GalleryEntry>,
}

/// The outcome of work on another thread, for the simulation's thread.
pub(crate) enum Outcome {
    /// The opened session, or the reason why it could not be opened.
    Opened(Box<Result<Ready, String>>),
    /// The path of the saved copy and its entry in the gallery, or the reason why the session could not be saved.
    Saved(Result<(PathBuf, Option<GalleryEntry>), String>),
    /// The path of the new exercise and its entry in the gallery, or the reason why no exercise was made.
    Created(Result<(PathBuf, GalleryEntry), String>),
    /// The file of the gallery that was renamed, deleted or put back, or the reason why it was not changed.
    Changed(Result<Changed, String>),
    /// The report of the session as HTML, or the reason why no report was made.
    Reported(Result<String, String>),
    /// The thread of the work panicked, which is a bug. The message of the panic is on standard error. The present
    /// session goes on.
    Panicked,
}

/// Progress of the work is stored as an integer from 0 to this number.
const PARTS: u64 = 1000;

/// Progress of the work. Both threads share it.
#[derive(Debug, Default)]
struct Progress {
    /// True while a recording is replayed, false while it is read and checked.
    is_replaying: AtomicBool,
    /// The share of the work that is done, times [`PARTS`].
    parts: AtomicU64,
    /// A flag that is set when the work has to stop.
    stop: Arc<AtomicBool>,
}

/// The kind of work that runs on the other thread.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    /// Opening a file.
    Open(String),
    /// Saving the session.
    Save,
    /// The report of the session is made.
    Report,
    /// A new exercise is written.
    Create,
    /// A file of the gallery is renamed, deleted or put back.
    Change,
}

/// Work on another thread.
pub(crate) struct Work {
    pub(crate) requester: Requester,
    pub(crate) task: Task,
    progress: Arc<Progress>,
    thread: JoinHandle<()>,
}

impl Work {
    /// Begins to open an entry of the gallery. Opening a session begins a new recording in the folder of sessions.
    /// `former` is the recording of the session that is open before.
    ///
    /// # Errors
    /// Fails if the system gives no thread.
    pub(crate) fn open(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        file: String,
        path: PathBuf,
        (sessions, former): (PathBuf, PathBuf),
    ) -> io::Result<Work> {
        let progress = Arc::new(Progress::default());
        let (shared, name) = (Arc::clone(&progress), file.clone());
        let until = Instant::now() + TIME_LIMIT;
        let open = move || {
            let watch = &mut |at: ReplayProgress| {
                let (is_replaying, done, of) = match at {
                    ReplayProgress::Reading(done, of) => (false, done, of),
                    ReplayProgress::Replaying(done, of) => (true, done, of),
                };
                shared.is_replaying.store(is_replaying, Ordering::Relaxed);
                shared.parts.store(PARTS * done.min(of) / of.max(1), Ordering::Relaxed);
                if shared.stop.load(Ordering::Relaxed) {
                    return Err("stopped".to_owned());
                }
                if Instant::now() > until {
                    let minutes = TIME_LIMIT.as_secs() / 60;
                    return Err(format!(
                        "the opening was stopped, because it takes more than {minutes} min"
                    ));
                }
                Ok(())
            };
            gallery::open(&path, &[], None, watch).and_then(|mut opened| {
                let recorder = Recorder::begin(&sessions, &name, &mut opened)?;
                Ok(Ready { opened, recorder, former: gallery::entry(&former) })
            })
        };
        let done = move |opened| Outcome::Opened(Box::new(opened));
        Work::start(send, requester, Task::Open(file), progress, move || done(open()))
    }

    /// Begins to save a copy of a recording.
    ///
    /// # Errors
    /// Fails if the system gives no thread.
    pub(crate) fn save(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        copy: Copy,
    ) -> io::Result<Work> {
        let save = move || {
            let saved = copy.make();
            Outcome::Saved(saved.map(|path| {
                let entry = gallery::entry(&path);
                (path, entry)
            }))
        };
        Work::start(send, requester, Task::Save, Arc::default(), save)
    }

    /// Begins to write a new exercise.
    ///
    /// # Errors
    /// Fails if the system gives no thread.
    pub(crate) fn create(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        file: NewFile,
    ) -> io::Result<Work> {
        let create = move || Outcome::Created(file.write());
        Work::start(send, requester, Task::Create, Arc::default(), create)
    }

    /// Begins to rename, delete or put back a file of the gallery.
    ///
    /// # Errors
    /// Fails if the system gives no thread.
    pub(crate) fn change(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        change: FileChange,
    ) -> io::Result<Work> {
        let make = move || Outcome::Changed(change.make().map_err(|error| error.to_string()));
        Work::start(send, requester, Task::Change, Arc::default(), make)
    }

    /// Begins to make the report of a branch of a recording.
    ///
    /// # Errors
    /// Fails if the system gives no thread.
    pub(crate) fn report(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        (recording, branch): (SoFar, usize),
        make: MakeReport,
    ) -> io::Result<Work> {
        let progress = Arc::new(Progress::default());
        let stop = Arc::clone(&progress.stop);
        let report = move || {
            let read = recording.read();
            Outcome::Reported(read.and_then(|(name, bytes)| make(&name, &bytes, branch, &stop)))
        };
        Work::start(send, requester, Task::Report, progress, report)
    }

    fn start(
        send: impl FnOnce(Outcome) + Send + 'static,
        requester: Requester,
        task: Task,
        progress: Arc<Progress>,
        work: impl FnOnce() -> Outcome + Send + 'static,
    ) -> io::Result<Work> {
        let thread = std::thread::Builder::new().name("opening".into()).spawn(move || {
            let outcome = catch_unwind(AssertUnwindSafe(work));
            send(outcome.unwrap_or(Outcome::Panicked));
        })?;
        Ok(Work { requester, task, progress, thread })
    }

    /// The progress of the opening, if a file is being opened.
    pub(crate) fn now(&self) -> Option<OpeningNow> {
        let file = self.file()?.to_owned();
        let at = if self.progress.is_replaying.load(Ordering::Relaxed) { "plays" } else { "reads" };
        let parts = self.progress.parts.load(Ordering::Relaxed);
        let share = parts as f64 / PARTS as f64;
        Some(OpeningNow { file, at, share })
    }

    /// The name of the file that is being opened, if one is.
    pub(crate) fn file(&self) -> Option<&str> {
        match &self.task {
            Task::Open(file) => Some(file),
            Task::Save | Task::Report | Task::Create | Task::Change => None,
        }
    }

    /// Asks the work to stop if it opens a file. Returns false if nothing is being opened.
    pub(crate) fn stop(&self) -> bool {
        let is_opening = self.file().is_some();
        if is_opening {
            self.progress.stop.store(true, Ordering::Relaxed);
        }
        is_opening
    }

    pub(crate) fn is_stopped(&self) -> bool {
        self.progress.stop.load(Ordering::Relaxed)
    }

    /// Waits until the work has saved a session or an exercise or moved a file, so that no partial file is left. Other
    /// work is not waited for.
    pub(crate) fn finish(self) {
        if matches!(self.task, Task::Save | Task::Create | Task::Change) {
            let _ = self.thread.join();
        }
    }
}
