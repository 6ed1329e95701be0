//! Cases on several threads. Each case is one thread's, so that its bits do not depend on their number.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc::channel;
use std::thread;

/// The number of threads given, else that of the machine.
pub(super) fn threads(given: Option<NonZero<usize>>) -> usize {
    let all = || thread::available_parallelism().map_or(1, NonZero::get);
    given.map_or_else(all, NonZero::get)
}

/// Does `work` for each index below `count`, until it returns `None` for one. `each` gets what is done on this thread, in the
/// order in which it is done.
pub(super) fn each<T: Send>(
    count: usize,
    threads: usize,
    work: impl Fn(usize) -> Option<T> + Sync,
    mut each: impl FnMut(usize, T),
) {
    let (next, work) = (AtomicUsize::new(0), &work);
    let next = &next;
    thread::scope(|scope| {
        let (send, done) = channel();
        for _ in 0..threads.min(count) {
            let send = send.clone();
            scope.spawn(move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    let result = if index < count { work(index) } else { None };
                    let Some(result) = result else { return };
                    if send.send((index, result)).is_err() {
                        return;
                    }
                }
            });
        }
        drop(send);
        for (index, result) in done {
            each(index, result);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_index_is_done_once_by_any_number_of_threads() {
        for threads in [1, 2, 7] {
            let mut found = Vec::new();
            each(
                100,
                threads,
                |index| Some(index * index),
                |index, square| found.push((index, square)),
            );
            found.sort_unstable();
            assert_eq!(found, (0..100).map(|index| (index, index * index)).collect::<Vec<_>>());
        }
    }

    #[test]
    fn none_ends_a_thread_s_work() {
        let mut count = 0;
        each(1000, 2, |index| (index < 10).then_some(()), |_, ()| count += 1);
        assert_eq!(count, 10);
    }
}
