//! Starts the predictions of the ships' paths. The predictions run on another thread.

use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

use fenderline_contact::number::{greater, lesser};
use fenderline_live::{Outlook, Prediction, Session};

use crate::hub::{Hub, Predicted};

/// Wall time between the starts of two predictions of the paths.
const INTERVAL: Duration = Duration::from_millis(100);
/// A prediction may start earlier than the interval says, by this wall time. Predictions start at ticks of the session,
/// whose times are not exact. Without this margin, every second tick of 0.1 s would come a little too early for a
/// prediction.
const EARLY: Duration = Duration::from_millis(20);
/// A prediction that takes more wall time than this ends early.
const LONGEST: Duration = Duration::from_secs(1);
/// Simulated time that a prediction covers (s), and simulated time between two points of a path (s).
const AHEAD_S: f64 = 300.0;
const EVERY_S: f64 = 10.0;

/// Starts predictions, one after the other.
#[derive(Debug, Default)]
pub(super) struct Predictor {
    due: Due,
    /// Number of changes to the run after which an earlier prediction could not be continued.
    changes: u64,
    thread: Option<Thread>,
}

/// Time at which the next prediction is due. A pure state machine.
#[derive(Debug, Default)]
struct Due(Option<Instant>);

impl Due {
    /// True if the next prediction may start. The state of a paused session does not change, so that one prediction is
    /// enough.
    fn is_due(&self, now: Instant, paused: bool) -> bool {
        self.0.is_none_or(|at| !paused && now + EARLY >= at)
    }

    /// Notes the start of a prediction. The next prediction is due one interval after the time at which the last was
    /// due, so that small delays do not add up.
    fn start(&mut self, now: Instant) {
        let was_due = self.0.map_or(now, |at| if at + INTERVAL < now { now } else { at });
        self.0 = Some(was_due + INTERVAL);
    }
}

/// A prediction to be made, and the number of changes to the run before it.
#[derive(Debug)]
struct Job {
    prediction: Prediction,
    changes: u64,
}

/// The latest request of the simulation's thread for a prediction.
#[derive(Debug, Default)]
struct Asked {
    job: Option<Job>,
    ended: bool,
}

/// The prediction that waits for the thread that makes predictions. A newer prediction replaces one that waits.
#[derive(Debug, Default)]
struct Inbox {
    asked: Mutex<Asked>,
    changed: Condvar,
}

impl Inbox {
    fn asked(&self) -> MutexGuard<'_, Asked> {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Takes the latest prediction to be made, and waits until there is one. The result is `None` when the simulation's
    /// thread has ended.
    fn take(&self) -> Option<Job> {
        let waits = |asked: &mut Asked| asked.job.is_none() && !asked.ended;
        let asked = self.changed.wait_while(self.asked(), waits);
        asked.unwrap_or_else(PoisonError::into_inner).job.take()
    }
}

/// The thread for predictions. The thread for predictions runs as long as the simulation's thread: threads that come
/// and go would each leave memory behind.
#[derive(Debug)]
struct Thread {
    inbox: Arc<Inbox>,
    handle: JoinHandle<()>,
}

impl Predictor {
    /// Makes the next prediction due at once and starts it from the beginning. The caller has changed the state, the
    /// orders or the whole run.
    pub(super) fn reset(&mut self) {
        self.due = Due::default();
        self.changes += 1;
    }

    /// Asks for a prediction if one is due. If the last prediction is still being made, the new prediction follows it.
    /// Only the latest request waits.
    pub(super) fn start_if_due(
        &mut self,
        now: Instant,
        paused: bool,
        session: &Session,
        hub: &Arc<Hub>,
    ) {
        if !self.due.is_due(now, paused) {
            return;
        }
        self.due.start(now);
        let Some(prediction) = session.prediction() else { return };
        // Replaces a thread that has ended by a panic.
        if self.thread.as_ref().is_none_or(|thread| thread.handle.is_finished()) {
            // If no thread can be started, the next prediction tries again.
            self.thread = Thread::start(hub).ok();
        }
        if let Some(Thread { inbox, .. }) = &self.thread {
            inbox.asked().job = Some(Job { prediction, changes: self.changes });
            inbox.changed.notify_one();
        }
    }
}

impl Drop for Predictor {
    fn drop(&mut self) {
        if let Some(Thread { inbox, .. }) = &self.thread {
            inbox.asked().ended = true;
            inbox.changed.notify_one();
        }
    }
}

impl Thread {
    fn start(hub: &Arc<Hub>) -> std::io::Result<Thread> {
        let (inbox, hub) = (Arc::<Inbox>::default(), Arc::clone(hub));
        let of_thread = Arc::clone(&inbox);
        let thread = std::thread::Builder::new().name("prediction".into());
        let handle = thread.spawn(move || predict(&of_thread, &hub))?;
        Ok(Thread { inbox, handle })
    }
}

/// Makes predictions until the simulation's thread has ended.
fn predict(inbox: &Inbox, hub: &Hub) {
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    let mut allowance = Allowance::new(if processors == 1 { 0.5 } else { 2.0 / 3.0 });
    let (mut outlook, mut changes) = (Outlook::default(), 0);
    while let Some(job) = inbox.take() {
        if job.changes != changes {
            outlook.forget();
            changes = job.changes;
        }
        let begun = Instant::now();
        let until = begun + LONGEST;
        let path = outlook.run(job.prediction, AHEAD_S, EVERY_S, || Instant::now() < until);
        hub.predictions.send_replace(Some(Arc::new(Predicted::new(path))));
        std::thread::sleep(allowance.rest(begun, Instant::now()));
    }
}

/// Limits the time that predictions take, to leave some of a processor's time for other work.
#[derive(Debug)]
struct Allowance {
    /// Share of a processor's time that predictions may use.
    share: f64,
    /// Time that was left for predictions at the moment `at` (s).
    left_s: f64,
    at: Option<Instant>,
}

/// Largest allowance of time for predictions, after a long time without predictions (s). With this allowance, some
/// predictions may follow each other without a rest.
const MOST_LEFT_S: f64 = 0.5;

impl Allowance {
    fn new(share: f64) -> Allowance {
        Allowance { share, left_s: MOST_LEFT_S, at: None }
    }

    /// The rest that must follow a prediction, from the times of its beginning and end.
    fn rest(&mut self, begun: Instant, ended: Instant) -> Duration {
        let gained_s = self.at.map_or(0.0, |at| self.share * (ended - at).as_secs_f64());
        self.at = Some(ended);
        self.left_s = lesser(self.left_s + gained_s, MOST_LEFT_S) - (ended - begun).as_secs_f64();
        Duration::from_secs_f64(greater(-self.left_s / self.share, 0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    /// Number of starts within ten seconds. There is a tick each tenth of a second, which begins some milliseconds
    /// late.
    #[test]
    fn there_is_a_prediction_for_every_tick_of_a_tenth_of_a_second_though_ticks_begin_late() {
        let begun = Instant::now();
        let mut due = Due::default();
        let starts = (0..100_u32).filter(|tick| {
            let now = begun + MS * (100 * tick + tick * 7 % 11);
            let is_due = due.is_due(now, false);
            if is_due {
                due.start(now);
            }
            is_due
        });
        assert_eq!(starts.count(), 100);
    }

    /// Number of predictions within a minute, if each takes this long and another one always waits.
    fn made(work_ms: u32) -> u32 {
        let begun = Instant::now();
        let mut allowance = Allowance::new(0.5);
        let (mut now, mut made) = (begun, 0);
        while now < begun + MS * 60_000 {
            let ended = now + MS * work_ms;
            now = ended + allowance.rest(now, ended);
            made += 1;
        }
        made
    }

    #[test]
    fn long_predictions_take_half_of_a_processor_where_there_is_one_and_a_few_need_no_rest() {
        // Half of a minute, and the half second at the start.
        for work_ms in [20, 120, 1000] {
            let worked_ms = made(work_ms) * work_ms;
            assert!((30_000..=31_500).contains(&worked_ms), "{work_ms} ms: {worked_ms} ms");
        }
        let mut allowance = Allowance::new(0.5);
        let begun = Instant::now();
        for turn in 0..4 {
            let at = begun + MS * (150 * turn);
            assert_eq!(allowance.rest(at, at + MS * 120), Duration::ZERO);
        }
    }

    #[test]
    fn a_flood_of_messages_starts_no_more_than_ten_predictions_a_second() {
        let begun = Instant::now();
        let mut due = Due::default();
        let starts = (0..10_000).filter(|ms| {
            let now = begun + MS * *ms;
            let is_due = due.is_due(now, false);
            if is_due {
                due.start(now);
            }
            is_due
        });
        assert_eq!(starts.count(), 101);
    }

    #[test]
    fn a_paused_session_gets_one_prediction_and_the_time_without_any_is_not_made_up_for() {
        let begun = Instant::now();
        let mut due = Due::default();
        assert!(due.is_due(begun, true));
        due.start(begun);
        assert!(!due.is_due(begun + MS * 5000, true) && due.is_due(begun + MS * 5000, false));
        due.start(begun + MS * 5000);
        assert!(!due.is_due(begun + MS * 5050, false));
    }
}
