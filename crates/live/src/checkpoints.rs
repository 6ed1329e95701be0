//! Checkpoints: states of a session that are kept, so that a rewind need not start from the beginning.

/// Number of ticks between two checkpoints at the beginning of a session. The number of ticks between checkpoints
/// doubles whenever there are too many checkpoints.
const FIRST_INTERVAL: u64 = 100;
/// Largest number of checkpoints. The state of a harbour scene takes some 100 kB.
const MOST: usize = 48;

/// Checkpoints of one or more branches of a session. The number of checkpoints is limited: in a long session the
/// intervals between them grow.
#[derive(Clone, Debug)]
pub(crate) struct Checkpoints<S> {
    interval: u64,
    /// For each checkpoint its branch, its tick, and the simulation's state before the commands of that tick.
    kept: Vec<(usize, u64, S)>,
}

impl<S: Clone> Checkpoints<S> {
    /// Begins with a checkpoint of the state at the start, which is never dropped.
    pub(crate) fn new(start: S) -> Checkpoints<S> {
        Checkpoints { interval: FIRST_INTERVAL, kept: vec![(0, 0, start)] }
    }

    /// Keeps the state of a tick if a checkpoint is due at this tick.
    pub(crate) fn offer(&mut self, branch: usize, tick: u64, state: &S) {
        if !tick.is_multiple_of(self.interval)
            || self.kept.iter().any(|(b, t, _)| (*b, *t) == (branch, tick))
        {
            return;
        }
        self.kept.push((branch, tick, state.clone()));
        while self.kept.len() > MOST {
            self.interval *= 2;
            let interval = self.interval;
            // Tick 0 is a multiple of every interval, so the start stays.
            self.kept.retain(|(_, tick, _)| tick.is_multiple_of(interval));
            if self.kept.len() > MOST && interval > u64::MAX / 4 {
                self.kept.truncate(1);
            }
        }
    }

    /// The latest checkpoint of a branch with a tick within `from..=to`, and its tick.
    pub(crate) fn latest(&self, branch: usize, from: u64, to: u64) -> Option<(u64, &S)> {
        let own = self.kept.iter().filter(|(b, t, _)| *b == branch && (from..=to).contains(t));
        own.max_by_key(|(_, tick, _)| *tick).map(|(_, tick, state)| (*tick, state))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn their_number_is_bounded_and_the_start_is_kept() {
        let mut kept = Checkpoints::new(0_u64);
        for tick in 0..1_000_000 {
            kept.offer(usize::from(tick > 500_000), tick, &tick);
            assert!(kept.kept.len() <= MOST);
        }
        assert_eq!(kept.latest(0, 0, 99), Some((0, &0)));
        let (tick, state) = kept.latest(1, 0, 1_000_000).expect("there are some");
        assert!(tick == *state && tick > 900_000);
    }
}
