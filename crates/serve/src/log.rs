//! Writes the server's lines on the terminal. Lines about refused clients are limited to a rate that a person can read.

use std::sync::{Mutex, PoisonError};
use std::time::Instant;

use super::rate::Bucket;

/// Lines about refused clients that are written per second, and in one burst.
const LINES: (f64, f64) = (2.0, 20.0);

/// A function that writes one line for the person who runs the server.
pub type Notify = fn(&str);

/// A log of the server that leaves out lines when there are too many.
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

    /// The function that writes a line of the log, for use on another thread.
    pub(crate) fn notify_function(&self) -> Notify {
        self.notify
    }

    /// Writes a line that the person who runs the server must not miss.
    pub(crate) fn notify(&self, line: &str) {
        (self.notify)(line);
    }

    /// Writes a line about a client that was refused. If there are too many lines about refused clients, they are only
    /// counted.
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
