//! Tells when the next tick of the session is due, and how late the last ticks were. The pacer is a pure state machine:
//! the caller gives the time.

use std::time::{Duration, Instant};

/// If a tick is later than this, the missed ticks are dropped, because the machine slept or the program was stopped.
const FORGIVEN: Duration = Duration::from_secs(1);

/// Keeps ticks of the session at equal intervals of wall time.
#[derive(Clone, Debug)]
pub(crate) struct Pacer {
    step_s: f64,
    pace: f64,
    anchor: Instant,
    ticks: u64,
    late_ticks: u64,
    latest: Duration,
}

impl Pacer {
    pub(crate) fn new(step_s: f64, now: Instant) -> Pacer {
        let pace = 1.0;
        Pacer { step_s, pace, anchor: now, ticks: 0, late_ticks: 0, latest: Duration::ZERO }
    }

    /// Wall time that one step takes at the present pace.
    fn wall_step(&self) -> Duration {
        Duration::from_secs_f64(self.step_s / self.pace)
    }

    fn due_at(&self) -> Instant {
        self.anchor + Duration::from_secs_f64(self.ticks as f64 * self.step_s / self.pace)
    }

    /// Restarts the clock. After the restart, the next tick is due one step from now.
    pub(crate) fn restart(&mut self, now: Instant) {
        (self.anchor, self.ticks) = (now, 1);
    }

    /// Pace of the session: simulated time over wall time.
    pub(crate) fn pace(&self) -> f64 {
        self.pace
    }

    pub(crate) fn set_pace(&mut self, pace: f64, now: Instant) {
        self.pace = pace;
        self.restart(now);
    }

    /// Time until the next tick of the session; zero if the tick is due.
    pub(crate) fn wait(&self, now: Instant) -> Duration {
        self.due_at().saturating_duration_since(now)
    }

    pub(crate) fn is_due(&self, now: Instant) -> bool {
        self.due_at() <= now
    }

    /// Notes that a tick which is due begins now. The tick counts as late if it is delayed by more than half a step.
    pub(crate) fn begin(&mut self, now: Instant) {
        let late = now.saturating_duration_since(self.due_at());
        self.ticks += 1;
        if late > self.wall_step() / 2 {
            self.late_ticks += 1;
            self.latest = self.latest.max(late);
        }
        if late > FORGIVEN {
            // The missed ticks are counted, but they are not made up for.
            self.late_ticks += (late.as_secs_f64() / self.wall_step().as_secs_f64()) as u64;
            self.restart(now);
        }
    }

    /// Number of late ticks, and the largest delay of a tick (ms).
    pub(crate) fn late(&self) -> (u64, f64) {
        (self.late_ticks, 1e3 * self.latest.as_secs_f64())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STEP: Duration = Duration::from_millis(100);

    #[test]
    fn small_delays_do_not_add_up() {
        let start = Instant::now();
        let mut pacer = Pacer::new(0.1, start);
        for tick in 0..1000_u32 {
            let due = start + STEP * tick;
            assert!(!pacer.is_due(due - Duration::from_millis(1)));
            let now = due + Duration::from_millis(u64::from(tick) * 7 % 50);
            assert!(pacer.is_due(now));
            pacer.begin(now);
        }
        assert_eq!(pacer.late().0, 0);
    }

    #[test]
    fn late_ticks_are_counted_and_caught_up_unless_very_late() {
        let start = Instant::now();
        let mut pacer = Pacer::new(0.1, start);
        pacer.begin(start);
        let late = start + STEP + Duration::from_millis(370);
        pacer.begin(late);
        assert_eq!(pacer.late(), (1, 370.0));
        // The two ticks that should have begun meanwhile are due at once.
        assert!(pacer.is_due(late));
        pacer.begin(late);
        pacer.begin(late);
        assert_eq!(pacer.late().0, 3);
        let slept = late + Duration::from_secs(60);
        pacer.begin(slept);
        assert!(pacer.late().0 > 590 && !pacer.is_due(slept));
        assert!(pacer.is_due(slept + STEP));
    }

    #[test]
    fn a_new_pace_starts_from_now() {
        let start = Instant::now();
        let mut pacer = Pacer::new(0.1, start);
        pacer.begin(start);
        pacer.set_pace(4.0, start);
        assert_eq!(pacer.wait(start), Duration::from_millis(25));
        pacer.set_pace(0.5, start);
        assert_eq!(pacer.wait(start), Duration::from_millis(200));
    }
}
