//! Opening a scenario or a session, saving, renaming and deleting one, and making a report, on a thread of their own, so that the simulation goes on. One at a time;
//! the simulation's thread sees the progress and can stop an opening.

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

/// Makes the report of a recording, as a page of HTML: from the name of its file, its bytes, the number of the branch, and a flag that asks to stop. The
/// program gives it, because this crate knows no reports. It runs on a thread of its own.
///
/// The error is the reason for the user.
pub type MakeReport = fn(&str, &[u8], usize, &Arc<AtomicBool>) -> Result<String, String>;

/// Time limit of an opening. `fenderline replay` has none.
const TIME_LIMIT: Duration = Duration::from_secs(600);

/// The client that asked for the work, and the number of its command.
#[derive(Clone, Debug)]
pub(crate) struct Requester {
    pub(crate) client: ClientId,
    pub(crate) label: String,
    pub(crate) id: Option<i64>,
}

/// A session to continue with, already recorded to a file of its own.
pub(crate) struct Ready {
    pub(crate) opened: Opened,
    pub(crate) recorder: Recorder,
    /// The entry of the former session's recording, which can be opened again.
    pub(crate) former: Option<GalleryEntry>,
}

/// The result of the work, for the simulation's thread.
pub(crate) enum Outcome {
    /// A session to continue with; or why it could not be opened.
    Opened(Box<Result<Ready, String>>),
    /// The path of a copy and its entry in the gallery; or why it could not be saved.
    Saved(Result<(PathBuf, Option<GalleryEntry>), String>),
    /// The path of a new exercise and its entry in the gallery; or why there is none.
    Created(Result<(PathBuf, GalleryEntry), String>),
    /// A file of the gallery was renamed, deleted or put back; or why it stays as it is.
    Changed(Result<Changed, String>),
    /// The report of the session, as HTML; or why there is none.
    Reported(Result<String, String>),
    /// The thread panicked, which is a bug; the panic is on standard error. The present session goes on.
    Panicked,
}

/// The progress is stored as an integer share of this.
const PARTS: u64 = 1000;

/// Progress of the work, shared by both threads.
#[derive(Debug, Default)]
struct Progress {
    /// A recording is replayed; false while it is read and checked.
    is_replaying: AtomicBool,
    /// Share that is done, times [`PARTS`].
    parts: AtomicU64,
    /// The work shall stop.
    stop: Arc<AtomicBool>,
}

/// What is done on the other thread.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Task {
    /// A file is opened.
    Open(String),
    /// The session is saved.
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
    /// Begins to open an entry of the gallery, and its recording in a folder. `former` is the recording of the present session.
    ///
    /// # Errors
    /// The system gives no thread.
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
                    return Err(format!("stopped: it takes more than {minutes} min"));
                }
                Ok(())
            };
            gallery::open(&path, &[], watch).and_then(|mut opened| {
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
    /// The system gives no thread.
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
    /// The system gives no thread.
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
    /// The system gives no thread.
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
    /// The system gives no thread.
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

    /// The progress, if something is being opened.
    pub(crate) fn now(&self) -> Option<OpeningNow> {
        let file = self.file()?.to_owned();
        let at = if self.progress.is_replaying.load(Ordering::Relaxed) { "plays" } else { "reads" };
        let parts = self.progress.parts.load(Ordering::Relaxed);
        let share = parts as f64 / PARTS as f64;
        Some(OpeningNow { file, at, share })
    }

    /// The file that is opened, if one is.
    pub(crate) fn file(&self) -> Option<&str> {
        match &self.task {
            Task::Open(file) => Some(file),
            Task::Save | Task::Report | Task::Create | Task::Change => None,
        }
    }

    /// Asks an opening to stop. Returns false if nothing is being opened.
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

    /// Waits until a session or an exercise is saved, or a file moved, so that no partial file is left. Nothing else is waited for.
    pub(crate) fn finish(self) {
        if matches!(self.task, Task::Save | Task::Create | Task::Change) {
            let _ = self.thread.join();
        }
    }
}
