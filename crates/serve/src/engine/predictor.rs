//! Predictions of the ships' paths, on a thread of their own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, SyncSender};
use std::time::{Duration, Instant};

use fenderline_live::{Prediction, Session};

use crate::hub::{Hub, Predicted};

/// Wall time between the starts of two predictions.
const INTERVAL: Duration = Duration::from_millis(100);
/// How much earlier than that one may start. They start with ticks, which are not exact: without it, every second tick of a tenth of a
/// second would be a little too early.
const EARLY: Duration = Duration::from_millis(20);
/// A prediction that takes longer ends early.
const LONGEST: Duration = Duration::from_secs(1);
/// Simulated time that a prediction covers, and between two of its points (s).
const AHEAD_S: f64 = 300.0;
const EVERY_S: f64 = 10.0;

/// Starts predictions, one at a time.
#[derive(Debug, Default)]
pub(super) struct Predictor {
    due: Due,
    thread: Option<Thread>,
}

/// When the next prediction is due. A pure state machine.
#[derive(Debug, Default)]
struct Due(Option<Instant>);

impl Due {
    /// Whether a prediction may start. The state of a paused session does not change: one prediction is enough for it.
    fn is_due(&self, now: Instant, paused: bool) -> bool {
        self.0.is_none_or(|at| !paused && now + EARLY >= at)
    }

    /// A prediction starts: the next one is due an interval later than this one was, so that small delays do not add up.
    fn start(&mut self, now: Instant) {
        let was_due = self.0.map_or(now, |at| if at + INTERVAL < now { now } else { at });
        self.0 = Some(was_due + INTERVAL);
    }
}

/// The thread. It lasts: threads that come and go would each leave memory behind.
#[derive(Debug)]
struct Thread {
    work: SyncSender<Prediction>,
    /// It works or rests.
    is_busy: Arc<AtomicBool>,
}

impl Predictor {
    /// The next prediction is due at once: the state or the orders have changed.
    pub(super) fn reset(&mut self) {
        self.due = Due::default();
    }

    /// Starts a prediction if one is due and none is running.
    pub(super) fn start_if_due(
        &mut self,
        now: Instant,
        paused: bool,
        session: &Session,
        hub: &Arc<Hub>,
    ) {
        let is_busy =
            self.thread.as_ref().is_some_and(|thread| thread.is_busy.load(Ordering::Acquire));
        if is_busy || !self.due.is_due(now, paused) {
            return;
        }
        self.due.start(now);
        let Some(prediction) = session.prediction() else { return };
        let thread = match self.thread.take() {
            Some(thread) => thread,
            None => match Thread::start(hub) {
                Ok(thread) => thread,
                // The next one tries again.
                Err(_) => return,
            },
        };
        thread.is_busy.store(true, Ordering::Release);
        // A thread that has ended by a panic is replaced for the next prediction.
        self.thread = thread.work.try_send(prediction).is_ok().then_some(thread);
    }
}

impl Thread {
    fn start(hub: &Arc<Hub>) -> std::io::Result<Thread> {
        let (work, jobs) = mpsc::sync_channel(1);
        let is_busy = Arc::new(AtomicBool::new(false));
        let (busy, hub) = (Busy(Arc::clone(&is_busy)), Arc::clone(hub));
        let thread = std::thread::Builder::new().name("prediction".into());
        thread.spawn(move || predict(&jobs, &busy, &hub))?;
        Ok(Thread { work, is_busy })
    }
}

/// Free again also when the thread ends by a panic.
#[derive(Debug)]
struct Busy(Arc<AtomicBool>);

impl Busy {
    fn end(&self) {
        self.0.store(false, Ordering::Release);
    }
}

impl Drop for Busy {
    fn drop(&mut self) {
        self.end();
    }
}

/// Runs predictions until there is no engine any more.
fn predict(jobs: &Receiver<Prediction>, busy: &Busy, hub: &Hub) {
    let only_one = std::thread::available_parallelism().is_ok_and(|count| count.get() == 1);
    while let Ok(prediction) = jobs.recv() {
        let begun = Instant::now();
        let until = begun + LONGEST;
        let path = prediction.run(AHEAD_S, EVERY_S, |_| Instant::now() < until);
        hub.predictions.send_replace(Some(Arc::new(Predicted::new(path))));
        std::thread::sleep(rest(begun.elapsed(), only_one));
        busy.end();
    }
}

/// The rest after some work: predictions take at most two thirds of a processor, and half of it if there is only one.
fn rest(work: Duration, only_one: bool) -> Duration {
    if only_one { work } else { work / 2 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MS: Duration = Duration::from_millis(1);

    /// Starts within ten seconds, with a tick each tenth of a second that begins some milliseconds late, and a prediction that takes
    /// `busy_ms` with its rest.
    fn starts(busy_ms: u32) -> usize {
        let begun = Instant::now();
        let (mut due, mut busy_until, mut starts) = (Due::default(), begun, 0);
        for tick in 0..100_u32 {
            let now = begun + MS * (100 * tick + tick * 7 % 11);
            if now >= busy_until && due.is_due(now, false) {
                due.start(now);
                busy_until = now + MS * busy_ms;
                starts += 1;
            }
        }
        starts
    }

    #[test]
    fn there_is_a_prediction_for_every_tick_of_a_tenth_of_a_second_though_ticks_begin_late() {
        assert_eq!(starts(85), 100);
        assert_eq!(starts(150), 50);
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
