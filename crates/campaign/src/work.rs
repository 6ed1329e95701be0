//! Runs on several threads. One thread makes a run from start to end, so that the bits of its results do not depend on
//! the number of threads.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::mpsc::sync_channel;
use std::thread;

use crate::error::CampaignError;
use crate::row::Row;
use crate::run::{Runner, Runs};
use crate::run_numbers::RunNumbers;

/// Number of finished rows that may wait to be written, so that the memory stays bounded if the disk is slow.
const WAITING: usize = 1024;

/// Largest number of threads that make runs: more than any machine has, and few enough that each can be started.
pub const MOST_THREADS: usize = 1024;

/// Makes the runs `numbers` on `threads` threads, [`MOST_THREADS`] at most, until all runs are made or `is_stopped`
/// returns true. `use_row` gets each row on the calling thread, in the order in which the runs end; if it returns
/// false, no further run is begun and no further row is used.
///
/// # Errors
/// Fails with the error that `use_row` returns; no row is used after the error.
pub fn make(
    runs: &Runs,
    numbers: &RunNumbers,
    threads: usize,
    is_stopped: &(dyn Fn() -> bool + Sync),
    use_row: &mut dyn FnMut(Row) -> Result<bool, CampaignError>,
) -> Result<(), CampaignError> {
    let next = AtomicU64::new(0);
    let has_ended = AtomicBool::new(false);
    let (next, has_ended) = (&next, &has_ended);
    thread::scope(|scope| {
        let (send, rows) = sync_channel(WAITING);
        let most = usize::try_from(numbers.count()).unwrap_or(usize::MAX);
        for _ in 0..threads.min(MOST_THREADS).min(most) {
            let send = send.clone();
            scope.spawn(move || {
                let mut runner = Runner::new(runs);
                let is_stopped = || has_ended.load(Ordering::Relaxed) || is_stopped();
                while !is_stopped() {
                    let Some(run) = numbers.get(next.fetch_add(1, Ordering::Relaxed)) else {
                        return;
                    };
                    let Some(row) = runner.run(run, &is_stopped) else { return };
                    if send.send(row).is_err() {
                        return;
                    }
                }
            });
        }
        drop(send);
        let mut outcome = Ok(());
        for row in rows {
            match use_row(row) {
                Ok(true) => {}
                other => {
                    outcome = other.map(|_| ());
                    has_ended.store(true, Ordering::Relaxed);
                    break;
                }
            }
        }
        outcome
    })
}
