//! Ctrl-C while a run is at work: the first asks it to end with the results so far, the second ends the program at once.
//! SIGTERM ends it at once too. No process of a provider is left behind. Ctrl-C while the server is at work ends it.

use std::io;
use std::process;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use tokio::sync::oneshot;

use crate::failure::INTERRUPTED;

/// Sent when Ctrl-C is pressed; pressed again it ends the program. A thread of its own listens, so that a second one
/// ends the program whatever the others wait for.
///
/// # Errors
/// The system gives no thread.
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

/// Whether the user has asked for the end.
pub(crate) struct Interrupt(Arc<AtomicBool>);

impl Interrupt {
    /// Listens from now on to the end of the program. Where the system lets nobody listen, Ctrl-C ends the program as
    /// it does every other; where the shell that started it had it ignored, as for what runs in the background, it
    /// stays ignored.
    pub(crate) fn listen() -> Interrupt {
        let asked = Arc::new(AtomicBool::new(false));
        #[cfg(unix)]
        if !unix::is_ignored() {
            unix::listen(&asked);
        }
        Interrupt(asked)
    }

    /// Whether the run shall end.
    pub(crate) fn is_asked(&self) -> bool {
        self.0.load(Ordering::Relaxed)
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

    use crate::failure::INTERRUPTED;
    use crate::provider::end_all;
    use crate::terminal::tell;

    /// What a shell sees of a program that SIGTERM ended.
    const TERMINATED: i32 = 143;

    /// Starts the thread that listens, and waits until it does.
    pub(super) fn listen(asked: &Arc<AtomicBool>) {
        let asked = Arc::clone(asked);
        let (listening, is_listening) = channel();
        let thread = std::thread::Builder::new().name("interrupt".into());
        if thread.spawn(move || hear(&asked, listening)).is_ok() {
            // An error says that it ended, and so that Ctrl-C does what it always does.
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
                        tell("interrupted: the results so far are written; once more ends it at once, without them");
                    }
                    _ = terminate.recv() => end(TERMINATED),
                }
            }
        });
    }

    /// At once: files stay under their `.part` names, as after a kill, and the next run removes them.
    fn end(code: i32) -> ! {
        end_all();
        std::process::exit(code)
    }

    /// Whether SIGINT was ignored when the program started; told by Linux alone.
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
