//! Trial manoeuvres. The trials run on another thread, one after the other. Each client has at most one trial; a newer
//! trial replaces it.

use std::collections::VecDeque;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use fenderline_live::message::{self, Reply};
use fenderline_live::{Refusal, Trial};
use tokio::sync::mpsc;

use crate::claims::ClientId;
use crate::hub::Text;
use crate::rate::Bucket;

/// Wall time until the first answer of a trial, and between two of its answers. Each answer shows the result of the
/// trial so far. With the time for network and drawing, the first answer is on the screen within 0.3 s.
const FIRST_ANSWER: Duration = Duration::from_millis(60);
const BETWEEN_ANSWERS: Duration = Duration::from_millis(120);
/// Longest wall time of a trial, and of a trial while other trials wait.
const LONGEST: Duration = Duration::from_secs(4);
const LONGEST_BESIDE_OTHERS: Duration = Duration::from_millis(400);
/// Trials that one client may start per second, and in one burst. Each trial copies the run, which takes time of the
/// simulation's thread.
const RATE: (f64, f64) = (10.0, 10.0);

/// A client's trial that waits or runs.
struct Job {
    client: ClientId,
    /// Number of the command that asked for the trial.
    id: i64,
    trial: Trial,
    out: mpsc::Sender<Text>,
    stop: Arc<AtomicBool>,
}

#[derive(Default)]
struct State {
    waiting: VecDeque<Job>,
    /// The client whose trial runs at present, and the flag that stops this trial.
    running: Option<(ClientId, Arc<AtomicBool>)>,
    ended: bool,
}

#[derive(Default)]
struct Shared {
    state: Mutex<State>,
    changed: Condvar,
}

impl Shared {
    fn state(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The trials of all clients. The thread for trials starts with the first trial.
#[derive(Default)]
pub(super) struct Trials {
    shared: Arc<Shared>,
    thread: Option<JoinHandle<()>>,
}

impl Trials {
    /// Makes the limit for the trials of one client.
    pub(super) fn bucket(now: Instant) -> Bucket {
        Bucket::new(RATE.0, RATE.1, now)
    }

    /// Starts a trial of a client, and sends the answers of the trial to `out`. An earlier trial of the client is
    /// stopped.
    ///
    /// # Errors
    /// Fails if the system gives no thread for trials.
    pub(super) fn start(
        &mut self,
        (client, id): (ClientId, i64),
        trial: Trial,
        out: mpsc::Sender<Text>,
    ) -> Result<(), Refusal> {
        if self.thread.as_ref().is_none_or(JoinHandle::is_finished) {
            let shared = Arc::clone(&self.shared);
            let thread = std::thread::Builder::new().name("trials".into());
            let thread = thread.spawn(move || work(&shared));
            self.thread = Some(thread.map_err(|e| {
                Refusal::new(format_args!("the server has no thread that runs trials: {e}"))
            })?);
        }
        let job = Job { client, id, trial, out, stop: Arc::default() };
        let mut state = self.shared.state();
        state.stop(client);
        state.waiting.push_back(job);
        drop(state);
        self.shared.changed.notify_one();
        Ok(())
    }

    /// Ends the trial of a client that has disconnected.
    pub(super) fn leave(&self, client: ClientId) {
        self.shared.state().stop(client);
    }
}

impl State {
    fn stop(&mut self, client: ClientId) {
        self.waiting.retain(|job| job.client != client);
        if let Some((of, stop)) = &self.running
            && *of == client
        {
            stop.store(true, Ordering::Relaxed);
        }
    }
}

impl Drop for Trials {
    fn drop(&mut self) {
        let mut state = self.shared.state();
        state.ended = true;
        state.waiting.clear();
        if let Some((_, stop)) = &state.running {
            stop.store(true, Ordering::Relaxed);
        }
        drop(state);
        self.shared.changed.notify_one();
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}

/// Runs the trials on their thread, until the server ends.
fn work(shared: &Shared) {
    loop {
        let mut state = shared.state();
        state.running = None;
        while state.waiting.is_empty() && !state.ended {
            state = shared.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        if state.ended {
            return;
        }
        let Some(job) = state.waiting.pop_front() else { continue };
        state.running = Some((job.client, Arc::clone(&job.stop)));
        drop(state);
        run(job, || shared.state().waiting.is_empty());
    }
}

/// Runs a trial and sends the answers of the trial. The trial ends early if it is stopped, takes too long, or its
/// client does not read.
fn run(job: Job, is_alone: impl Fn() -> bool) {
    let Job { id, trial, out, stop, .. } = job;
    let (tick, horizon_s) = (trial.tick(), trial.horizon_s());
    let begun = Instant::now();
    let mut next = begun + FIRST_ANSWER;
    let send = |answer: &Reply| out.try_send(message::text(answer).into()).is_ok();
    let answer = trial.run(id, |paths| {
        let now = Instant::now();
        if now >= next {
            next = now + BETWEEN_ANSWERS;
            if !send(&Trial::so_far(id, tick, horizon_s, paths)) {
                return false;
            }
        }
        let longest = if is_alone() { LONGEST } else { LONGEST_BESIDE_OTHERS };
        !stop.load(Ordering::Relaxed) && now < begun + longest
    });
    if !stop.load(Ordering::Relaxed) {
        send(&answer);
    }
}
