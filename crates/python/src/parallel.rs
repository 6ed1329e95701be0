//! Does work in parallel, and returns results in the order of the items, whichever thread computed them.

use std::num::NonZero;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::mpsc::{self, Receiver, RecvTimeoutError};
use std::thread;
use std::time::Duration;

/// The given number of threads, or else the number of threads of the machine; at least one.
pub(crate) fn threads(given: Option<usize>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    given.unwrap_or_else(all).max(1)
}

/// The results that one thread computed, each with the index of its item.
type Share<T> = Vec<(usize, T)>;

/// Runs `work` for the indices below `count` on `others` other threads, until `goes_on` returns false. Each thread
/// takes one index after the other, because pieces of work differ in length. Each thread has its own data for `work`,
/// which `own` makes. Meanwhile the calling thread runs `here` with two arguments: a channel that tells when all other
/// threads have ended, and a function with which the calling thread works on indices too. The results are in the order
/// of the indices, and the work of every index that a thread took is done.
fn spread<T: Send, W>(
    (count, others): (usize, usize),
    own: impl Fn() -> W + Sync,
    goes_on: impl Fn() -> bool + Sync,
    work: impl Fn(&mut W, usize) -> T + Sync,
    here: impl FnOnce(&Receiver<()>, &dyn Fn() -> Share<T>) -> Share<T>,
) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let worker = || {
        let (mut done, mut own) = (Vec::new(), own());
        while goes_on() {
            let index = next.fetch_add(1, Ordering::Relaxed);
            if index >= count {
                break;
            }
            done.push((index, work(&mut own, index)));
        }
        done
    };
    let mut done: Share<T> = thread::scope(|scope| {
        let (all, ended) = mpsc::channel::<()>();
        let workers: Vec<_> = (0..others.min(count))
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
        let mut done = here(&ended, &worker);
        for other in workers {
            done.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        done
    });
    // Each share is in order: a stable sort merges them.
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, result)| result).collect()
}

/// Runs `work` for each index below `count`, also on the calling thread: short work is begun before another thread has
/// started.
pub(crate) fn each<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    if threads == 1 || count < 2 {
        return (0..count).map(work).collect();
    }
    spread((count, threads - 1), || (), || true, |(), index| work(index), |_, worker| worker())
}

/// Runs `work` for each index as [`each`] does, but only on other threads.
pub(crate) fn each_elsewhere<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> T + Sync,
) -> Vec<T> {
    spread((count, threads), || (), || true, |(), index| work(index), |_, _| Vec::new())
}

/// Why some of the work was not done.
pub(crate) enum Ended<E> {
    /// The lowest index whose work failed, with its error: the work of all lower indices was done.
    Failed(usize, E),
    /// `watch` said no.
    Stopped,
}

/// Time between two calls of the function `watch` of [`each_watched`].
const WATCH: Duration = Duration::from_millis(20);

/// Runs `work` for each index as [`each`] does, but only on other threads; meanwhile the calling thread calls `watch`
/// with the number of indices that are done. If `watch` returns false or work fails, no further index is begun; the
/// last argument of `work` tells running work to stop early. Each thread has its own data for `work`, which `own`
/// makes.
pub(crate) fn each_watched<T: Send, E: Send, W>(
    count: usize,
    threads: usize,
    own: impl Fn() -> W + Sync,
    work: impl Fn(&mut W, usize, &AtomicBool) -> Result<T, E> + Sync,
    mut watch: impl FnMut(usize) -> bool,
) -> Result<Vec<T>, Ended<E>> {
    let finished = AtomicUsize::new(0);
    let (has_failed, is_stopped) = (AtomicBool::new(false), AtomicBool::new(false));
    let goes_on = || !has_failed.load(Ordering::Relaxed) && !is_stopped.load(Ordering::Relaxed);
    let one = |own: &mut W, index: usize| {
        let result = work(own, index, &is_stopped);
        has_failed.fetch_or(result.is_err(), Ordering::Relaxed);
        finished.fetch_add(1, Ordering::Relaxed);
        result
    };
    let done = spread((count, threads), own, goes_on, one, |ended, _| {
        while ended.recv_timeout(WATCH) == Err(RecvTimeoutError::Timeout) {
            if !watch(finished.load(Ordering::Relaxed)) {
                is_stopped.store(true, Ordering::Relaxed);
            }
        }
        Vec::new()
    });
    if is_stopped.load(Ordering::Relaxed) {
        return Err(Ended::Stopped);
    }
    // Indices are taken in order, and each that was taken is done: the first failure is the lowest, and its place is its index.
    let numbered = done.into_iter().enumerate();
    numbered.map(|(index, result)| result.map_err(|error| Ended::Failed(index, error))).collect()
}

/// Runs `work` for each item, which `work` may change in place.
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
        let mut own = pieces[piece].lock().expect("each piece of work is locked only once");
        let numbers = piece * size..;
        own.iter_mut().zip(numbers).map(|(item, index)| work(index, item)).collect::<Vec<T>>()
    });
    done.into_iter().flatten().collect()
}
