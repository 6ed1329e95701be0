//! Limits what clients that come and go cost the other clients. When clients come and go, the other clients get few
//! frames and notices about it: a crowd must not cost ten times as much as the simulation. The limit is a pure state
//! machine: the caller gives the time.

use std::time::{Duration, Instant};

use crate::rate::Bucket;

/// Least wall time between a frame and the next frame that shows nothing new but the number of clients. The least time
/// between such frames is as long as a step of most scenarios. A run at the pace of wall time therefore shows the
/// number of clients in the frames of its ticks.
const BETWEEN_FRAMES: Duration = Duration::from_millis(100);
/// Notices about observers that are sent per second, and in one burst.
const NOTICES: (f64, f64) = (1.0, 10.0);

/// Changes in the number of clients that the other clients have not been told of yet.
#[derive(Debug)]
pub(super) struct Crowd {
    /// True if the number of clients differs from the number in the last frame.
    has_changed: bool,
    notices: Bucket,
    /// Number of observers that came or went without a notice.
    untold: u64,
}

impl Crowd {
    pub(super) fn new(now: Instant) -> Crowd {
        Crowd { has_changed: false, notices: Bucket::new(NOTICES.0, NOTICES.1, now), untold: 0 }
    }

    /// Notes that a client has come or gone.
    pub(super) fn change(&mut self) {
        self.has_changed = true;
    }

    /// Notes that a frame which shows the number of clients was published.
    pub(super) fn is_shown(&mut self) {
        self.has_changed = false;
    }

    /// Time at which a frame has to show the number of clients, given the time of the last frame. The time is `None` if
    /// the last frame shows the present number.
    pub(super) fn due_at(&self, published: Instant) -> Option<Instant> {
        self.has_changed.then(|| published + BETWEEN_FRAMES)
    }

    /// True if a notice may tell of an observer that has come or gone. If no notice may tell of the observer, the
    /// observer is counted.
    pub(super) fn may_tell(&mut self, now: Instant) -> bool {
        // The observers that were counted have to be told of first.
        let may = self.untold == 0 && self.notices.take(now);
        self.untold += u64::from(!may);
        may
    }

    /// Number of observers that came or went without a notice; given once a notice may tell of them together.
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
