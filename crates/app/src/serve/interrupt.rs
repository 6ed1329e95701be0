//! Ctrl-C, heard by a thread that does nothing else: whatever the others wait for, a second one ends the program.

use std::io;
use std::process;

use tokio::sync::oneshot;

use crate::failure::INTERRUPTED;

/// Comes when Ctrl-C is pressed; pressed again it ends the program.
///
/// # Errors
/// The system gives no thread.
pub(super) fn heard() -> io::Result<oneshot::Receiver<()>> {
    let (tell, told) = oneshot::channel();
    let runtime = tokio::runtime::Builder::new_current_thread().enable_io().build()?;
    std::thread::Builder::new().name("interrupt".into()).spawn(move || {
        runtime.block_on(async {
            if tokio::signal::ctrl_c().await.is_ok() {
                let _ = tell.send(());
                if tokio::signal::ctrl_c().await.is_ok() {
                    process::exit(i32::from(INTERRUPTED));
                }
            }
        });
    })?;
    Ok(told)
}
