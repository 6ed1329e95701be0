//! Clients that come and go. However many do, the others get few frames and notices of it: a crowd must not cost ten times what
//! the simulation costs. A pure state machine: the caller gives the time.

use std::time::{Duration, Instant};

use crate::rate::Bucket;

/// Least wall time from a frame to one that shows nothing new but the number of clients. It is a step of most scenarios, so that a
/// run at the pace of wall time shows the number with its ticks.
const BETWEEN_FRAMES: Duration = Duration::from_millis(100);
/// Notices about observers per second, and in one burst.
const NOTICES: (f64, f64) = (1.0, 10.0);

/// What the others have not been told yet.
#[derive(Debug)]
pub(super) struct Crowd {
    /// The number of clients differs from that of the last frame.
    has_changed: bool,
    notices: Bucket,
    /// Observers that came or went without a notice.
    untold: u64,
}

impl Crowd {
    pub(super) fn new(now: Instant) -> Crowd {
        Crowd { has_changed: false, notices: Bucket::new(NOTICES.0, NOTICES.1, now), untold: 0 }
    }

    /// A client has come or gone.
    pub(super) fn change(&mut self) {
        self.has_changed = true;
    }

    /// A frame was published: it has the number of clients.
    pub(super) fn is_shown(&mut self) {
        self.has_changed = false;
    }

    /// When a frame has to show the number of clients, from the time of the last frame; `None`: it is shown.
    pub(super) fn due_at(&self, published: Instant) -> Option<Instant> {
        self.has_changed.then(|| published + BETWEEN_FRAMES)
    }

    /// Whether to tell of an observer by a notice of her own. Otherwise she is counted.
    pub(super) fn may_tell(&mut self, now: Instant) -> bool {
        // Those who were counted come first.
        let may = self.untold == 0 && self.notices.take(now);
        self.untold += u64::from(!may);
        may
    }

    /// How many observers came or went without a notice, once they may be told of together.
    pub(super) fn untold(&mut self, now: Instant) -> Option<u64> {
        (self.untold > 0 && self.notices.take(now)).then(|| std::mem::take(&mut self.untold))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_crowd_that_comes_and_goes_gives_one_frame_for_each_step_and_few_notices() {
        let start = Instant::now();
        let mut crowd = Crowd::new(start);
        let (mut published, mut frames, mut notices, mut told) = (start, 0, 0, 0);
        for ms in 0..10_000 {
            let now = start + Duration::from_millis(ms);
            crowd.change();
            if crowd.may_tell(now) {
                (notices, told) = (notices + 1, told + 1);
            }
            if crowd.due_at(published).is_some_and(|at| at <= now) {
                (published, frames) = (now, frames + 1);
                crowd.is_shown();
            }
            if let Some(others) = crowd.untold(now) {
                (notices, told) = (notices + 1, told + others);
            }
        }
        assert_eq!(frames, 99);
        assert!((15..=20).contains(&notices) && told > 8_000, "{notices} {told}");
        assert!(crowd.due_at(published).is_some());
        crowd.is_shown();
        assert_eq!(crowd.due_at(published), None);
        let later = start + Duration::from_secs(20);
        assert_eq!(crowd.untold(later).map(|others| others + told), Some(10_000));
        assert_eq!(crowd.untold(later), None);
    }
}
