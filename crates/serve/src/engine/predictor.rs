//! Predictions of the ships' paths, on a thread of their own.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

use fenderline_live::Session;

use crate::hub::{Hub, Predicted};

/// Least wall time between the starts of two predictions.
const INTERVAL: Duration = Duration::from_millis(100);
/// A prediction that takes longer ends early.
const LONGEST: Duration = Duration::from_secs(1);
/// Simulated time that a prediction covers, and between two of its points (s).
const AHEAD_S: f64 = 300.0;
const EVERY_S: f64 = 10.0;

/// Starts predictions, one at a time.
#[derive(Debug, Default)]
pub(super) struct Predictor {
    started: Option<Instant>,
    is_running: Arc<AtomicBool>,
}

impl Predictor {
    /// The next prediction is due at once: the state or the orders have changed.
    pub(super) fn reset(&mut self) {
        self.started = None;
    }

    /// Starts a prediction if one is due and none is running. The state of a paused session does not change: one
    /// prediction is enough for it.
    pub(super) fn start_if_due(
        &mut self,
        now: Instant,
        paused: bool,
        session: &Session,
        hub: &Arc<Hub>,
    ) {
        let is_due = self.started.is_none_or(|at| !paused && now >= at + INTERVAL);
        if !is_due || self.is_running.load(Ordering::Acquire) {
            return;
        }
        self.started = Some(now);
        let Some(prediction) = session.prediction() else { return };
        self.is_running.store(true, Ordering::Release);
        let (is_running, hub) = (Arc::clone(&self.is_running), Arc::clone(hub));
        let predict = move || {
            let begun = Instant::now();
            let until = begun + LONGEST;
            let path = prediction.run(AHEAD_S, EVERY_S, |_| Instant::now() < until);
            hub.predictions.send_replace(Some(Arc::new(Predicted::new(path))));
            // A pause as long as the work: predictions take at most half of a processor.
            std::thread::sleep(begun.elapsed());
            is_running.store(false, Ordering::Release);
        };
        let thread = std::thread::Builder::new().name("prediction".into()).spawn(predict);
        if thread.is_err() {
            self.is_running.store(false, Ordering::Release);
        }
    }
}
