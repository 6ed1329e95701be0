//! Work in parallel, with results in the order of the items, whichever thread computed them.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// The number of threads given, else that of the machine; at least one.
pub(crate) fn threads(given: Option<usize>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    given.unwrap_or_else(all).max(1)
}

/// Runs `work` for each index below `count`.
pub(crate) fn each<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    if threads == 1 || count < 2 {
        return (0..count).map(work).collect();
    }
    let next = AtomicUsize::new(0);
    // One index at a time, as runs differ in length.
    let worker = || {
        let mut done = Vec::new();
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                return done;
            }
            done.push((index, work(index)));
        }
    };
    let mut results: Vec<Option<T>> = (0..count).map(|_| None).collect();
    thread::scope(|scope| {
        let workers: Vec<_> = (0..threads.min(count)).map(|_| scope.spawn(worker)).collect();
        for done in workers {
            let done = done.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic));
            for (index, result) in done {
                results[index] = Some(result);
            }
        }
    });
    results.into_iter().map(|result| result.expect("each index is taken once")).collect()
}

/// The reason why not all of the work was done.
pub(crate) enum Ended<E> {
    /// The lowest index that failed: all below it were done.
    Failed(usize, E),
    /// `watch` said no.
    Stopped,
}

/// Time between two calls of `watch`.
const WATCH: Duration = Duration::from_millis(20);

/// Runs `work` for each index below `count` on `threads` other threads, and meanwhile calls `watch` with the number of those done.
/// Where it says no, or where work fails, no further index is begun; `work` is told to stop early by its last argument. Each thread
/// has something of its own for it, which `own` makes.
pub(crate) fn each_watched<T: Send, E: Send, W>(
    count: usize,
    threads: usize,
    own: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, usize, &AtomicBool) -> Result<T, E> + Sync,
    mut watch: impl FnMut(usize) -> bool,
) -> Result<Vec<T>, Ended<E>> {
    let next = AtomicUsize::new(0);
    let finished = AtomicUsize::new(0);
    let (has_failed, is_stopped) = (AtomicBool::new(false), AtomicBool::new(false));
    let worker = || {
        let (mut done, mut own) = (Vec::new(), own());
        while !has_failed.load(Ordering::Relaxed) && !is_stopped.load(Ordering::Relaxed) {
            // Indices are taken in order, and each that was taken is done: so the lowest failure is always found.
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                break;
            }
            let result = work(&mut own, index, &is_stopped);
            has_failed.fetch_or(result.is_err(), Ordering::Relaxed);
            done.push((index, result));
            finished.fetch_add(1, Ordering::Relaxed);
        }
        done
    };
    let mut done: Vec<(usize, Result<T, E>)> = thread::scope(|scope| {
        let (all, ended) = mpsc::channel::<()>();
        let workers: Vec<_> = (0..threads.min(count))
            .map(|_| {
                let (all, worker) = (all.clone(), &worker);
                scope.spawn(move || {
                    // Dropped at the end, also of a panic.
                    let _all = all;
                    worker()
                })
            })
            .collect();
        drop(all);
        while ended.recv_timeout(WATCH) == Err(RecvTimeoutError::Timeout) {
            if !watch(finished.load(Ordering::Relaxed)) {
                is_stopped.store(true, Ordering::Relaxed);
            }
        }
        let joined = workers.into_iter().map(thread::ScopedJoinHandle::join);
        joined
            .flat_map(|done| done.unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
            .collect()
    });
    if is_stopped.load(Ordering::Relaxed) {
        return Err(Ended::Stopped);
    }
    done.sort_by_key(|(index, _)| *index);
    done.into_iter()
        .map(|(index, result)| result.map_err(|error| Ended::Failed(index, error)))
        .collect()
}

/// Runs `work` for each item in place.
pub(crate) fn each_mut<I: Send, T: Send>(
    items: &mut [I],
    threads: usize,
    work: impl Fn(usize, &mut I) -> T + Sync,
) -> Vec<T> {
    if threads == 1 || items.len() < 2 {
        return items.iter_mut().enumerate().map(|(index, item)| work(index, item)).collect();
    }
    // A few pieces per thread, as they take different times.
    let size = items.len().div_ceil(4 * threads);
    let pieces: Vec<Mutex<&mut [I]>> = items.chunks_mut(size).map(Mutex::new).collect();
    let done = each(pieces.len(), threads, |piece| {
        let mut own = pieces[piece].lock().expect("each piece is locked once");
        let numbers = piece * size..;
        own.iter_mut().zip(numbers).map(|(item, index)| work(index, item)).collect::<Vec<T>>()
    });
    done.into_iter().flatten().collect()
}
