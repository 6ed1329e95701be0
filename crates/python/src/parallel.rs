//! Work in parallel, with results in the order of the items, whichever thread computed them.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

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
