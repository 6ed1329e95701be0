//! Handles Ctrl-C. During a run the first Ctrl-C ends the run with the results so far; the second Ctrl-C ends the
//! program at once, as SIGTERM does. No process of a force provider is left behind. Ctrl-C also ends the live server.

use std::io;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use tokio::sync::oneshot;

use crate::failure::INTERRUPTED;

/// The returned channel receives a message at the first Ctrl-C; the second Ctrl-C ends the program. A separate thread
/// listens for Ctrl-C, so that the other threads may block.
///
/// # Errors
/// Fails if the system gives no thread.
pub(crate) fn stop_on_interrupt() -> io::Result<oneshot::Receiver<()>> {
    let (send, stop) = oneshot::channel();
    let runtime = tokio::runtime::Builder::new_current_thread().enable_io().build()?;
    std::thread::Builder::new().name("interrupt".into()).spawn(move || {
        runtime.block_on(async {
            if tokio::signal::ctrl_c().await.is_ok() {
                let _ = send.send(());
                if tokio::signal::ctrl_c().await.is_ok() {
                    process::exit(i32::from(INTERRUPTED));
                }
            }
        });
    })?;
    Ok(stop)
}

/// Whether the user has asked the run to end.
pub(crate) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens for Ctrl-C until the program ends. If the system does not allow listening, Ctrl-C ends the program as
    /// usual. If the shell ignores SIGINT for the program, as for background jobs, SIGINT stays ignored.
    pub(crate) fn listen() -> Interrupt {
        let asked = Arc::new(AtomicBool::new(false));
        #[cfg(unix)]
        if !unix::is_ignored() {
            unix::listen(&asked);
        }
        #[cfg(windows)]
        windows::listen(&asked);
        Interrupt(asked)
    }

    /// Makes an `Interrupt` that is asked for by setting the given flag, and not by Ctrl-C.
    pub(crate) fn asked_by(flag: &Arc<AtomicBool>) -> Interrupt {
        Interrupt(Arc::clone(flag))
    }

    /// Whether the user has asked the run to end.
    pub(crate) fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// The message that the first Ctrl-C prints.
#[cfg(any(unix, windows))]
const TOLD: &str = "interrupted: the results so far are written; a second Ctrl-C ends the program \
    at once, without results";

#[cfg(windows)]
mod windows {
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::mpsc::channel;

    use tokio::signal::windows::ctrl_c;

    use super::TOLD;
    use crate::failure::INTERRUPTED;
    use crate::terminal::tell;

    /// Starts the thread that listens for Ctrl-C, and waits until the thread listens. Without a console Ctrl-C does not
    /// reach the program.
    pub(super) fn listen(asked: &Arc<AtomicBool>) {
        let asked = Arc::clone(asked);
        let (listening, is_listening) = channel::<()>();
        let thread = std::thread::Builder::new().name("interrupt".into());
        let hear = move || {
            let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
            let Ok(runtime) = runtime else { return };
            runtime.block_on(async {
                let Ok(mut interrupt) = ctrl_c() else { return };
                drop(listening);
                while interrupt.recv().await.is_some() {
                    if asked.swap(true, Ordering::Relaxed) {
                        // Files keep their `.part` names, and the next run removes them.
                        std::process::exit(i32::from(INTERRUPTED));
                    }
                    tell(TOLD);
                }
            });
        };
        if thread.spawn(hear).is_ok() {
            // An error means that it listens, or has ended.
            let _ = is_listening.recv();
        }
    }
}

#[cfg(unix)]
mod unix {
    use std::path::Path;
    use std::sync::Arc;
    use std::sync::atomic::{AtomicBool, Ordering};
    use std::sync::mpsc::{Sender, channel};

    use fenderline_scenario::read_text_of;
    use tokio::signal::unix::{SignalKind, signal};

    use super::TOLD;
    use crate::failure::INTERRUPTED;
    use crate::provider::end_all;
    use crate::terminal::tell;

    /// The exit code that a shell reports for a program that SIGTERM ended.
    const TERMINATED: i32 = 143;

    /// Starts the thread that listens for Ctrl-C, and waits until the thread listens.
    pub(super) fn listen(asked: &Arc<AtomicBool>) {
        let asked = Arc::clone(asked);
        let (listening, is_listening) = channel();
        let thread = std::thread::Builder::new().name("interrupt".into());
        if thread.spawn(move || hear(&asked, listening)).is_ok() {
            // An error means that the thread ended: Ctrl-C then ends the program as usual.
            let _ = is_listening.recv();
        }
    }

    fn hear(asked: &AtomicBool, listening: Sender<()>) {
        let runtime = tokio::runtime::Builder::new_current_thread().enable_all().build();
        let Ok(runtime) = runtime else { return };
        runtime.block_on(async {
            let both = (signal(SignalKind::interrupt()), signal(SignalKind::terminate()));
            let (Ok(mut interrupt), Ok(mut terminate)) = both else { return };
            drop(listening);
            loop {
                tokio::select! {
                    _ = interrupt.recv() => {
                        if asked.swap(true, Ordering::Relaxed) {
                            end(i32::from(INTERRUPTED));
                        }
                        tell(TOLD);
                    }
                    _ = terminate.recv() => end(TERMINATED),
                }
            }
        });
    }

    /// Ends the program at once. Unfinished files keep their `.part` names, and the next run removes these files.
    fn end(code: i32) -> ! {
        end_all();
        std::process::exit(code)
    }

    /// Whether SIGINT was ignored when the program started. Only Linux reports it.
    pub(super) fn is_ignored() -> bool {
        const SIGINT_BIT: u64 = 1 << 1;
        let Ok(status) = read_text_of(Path::new("/proc/self/status"), 1 << 16) else {
            return false;
        };
        let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
        let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
        mask.is_some_and(|mask| mask & SIGINT_BIT != 0)
    }
}
