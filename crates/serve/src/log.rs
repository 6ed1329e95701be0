//! Lines about refused clients on the server's terminal, limited to a rate that a person can read.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use super::rate::Bucket;

/// Lines per second, and lines in one burst.
const LINES: (f64, f64) = (2.0, 20.0);

/// Writes one line for the person who runs the server.
pub type Notify = fn(&str);

/// A log that leaves out lines when there are too many.
#[derive(Debug)]
pub(crate) struct Log {
    thinned: Mutex<Thinned>,
    notify: Notify,
}

#[derive(Debug)]
struct Thinned {
    bucket: Bucket,
    left_out: u64,
}

impl Log {
    pub(crate) fn new(notify: Notify) -> Log {
        let bucket = Bucket::new(LINES.0, LINES.1, Instant::now());
        Log { thinned: Mutex::new(Thinned { bucket, left_out: 0 }), notify }
    }

    /// What writes a line, for another thread.
    pub(crate) fn notify_function(&self) -> Notify {
        self.notify
    }

    /// A line that must not be missed.
    pub(crate) fn notify(&self, line: &str) {
        (self.notify)(line);
    }

    /// A line about a refusal; beyond the rate it is only counted.
    pub(crate) fn refused(&self, line: &str) {
        let mut thinned = self.thinned.lock().unwrap_or_else(PoisonError::into_inner);
        if !thinned.bucket.take(Instant::now()) {
            thinned.left_out += 1;
            return;
        }
        let left_out = std::mem::take(&mut thinned.left_out);
        drop(thinned);
        if left_out > 0 {
            self.notify(&format!("({left_out} similar lines left out)"));
        }
        // Control characters are removed: a client's text must not control the terminal.
        let line: String = line.chars().take(300).filter(|c| !c.is_control()).collect();
        self.notify(&line);
    }
}
