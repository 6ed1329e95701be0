//! Programs with a time limit: a test of a program that hangs fails, and does not hang itself.
#![allow(dead_code, reason = "each test file uses its own part")]

use std::io::{BufRead as _, BufReader, Read};
use std::process::{Child, ChildStdout, Command, ExitStatus, Output, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// Longer than any program of the tests takes on a busy machine.
pub(crate) const LIMIT: Duration = Duration::from_secs(300);

/// Runs a program to its end. Its standard input is empty.
///
/// # Panics
/// The program is still running after [`LIMIT`]; it is killed.
pub(crate) fn output(command: &mut Command) -> Output {
    let child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn();
    output_of(child.unwrap_or_else(|e| panic!("{command:?} starts: {e}")))
}

/// Waits for the end of a program. An output that is not piped is empty.
///
/// # Panics
/// As [`output`].
pub(crate) fn output_of(mut child: Child) -> Output {
    let stdout = child.stdout.take().map(all_of);
    let stderr = child.stderr.take().map(all_of);
    let status = end_of(&mut child);
    let bytes = |from: Option<Receiver<Vec<u8>>>| {
        from.map(|from| from.recv_timeout(LIMIT).expect("its output ends")).unwrap_or_default()
    };
    Output { status, stdout: bytes(stdout), stderr: bytes(stderr) }
}

/// Waits for the end of a program.
///
/// # Panics
/// As [`output`].
pub(crate) fn end_of(child: &mut Child) -> ExitStatus {
    let until = Instant::now() + LIMIT;
    loop {
        if let Some(status) = child.try_wait().expect("its state") {
            return status;
        }
        if Instant::now() > until {
            let _ = child.kill();
            panic!("the program still runs after {} s", LIMIT.as_secs());
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

/// Everything that a program writes to a pipe.
fn all_of(mut pipe: impl Read + Send + 'static) -> Receiver<Vec<u8>> {
    let (send, receive) = channel();
    std::thread::spawn(move || {
        let mut bytes = Vec::new();
        let _ = pipe.read_to_end(&mut bytes);
        let _ = send.send(bytes);
    });
    receive
}

/// The lines that a program prints. They are read to the end whether they are used or not, so that the program never waits
/// for its reader.
pub(crate) struct Lines(Receiver<String>);

impl Lines {
    pub(crate) fn of(pipe: ChildStdout) -> Lines {
        let (send, receive) = channel();
        std::thread::spawn(move || {
            for line in BufReader::new(pipe).lines().map_while(Result::ok) {
                let _ = send.send(line);
            }
        });
        Lines(receive)
    }

    /// The next line; `None` after the last one.
    ///
    /// # Panics
    /// There is no line and no end within [`LIMIT`].
    pub(crate) fn next(&self) -> Option<String> {
        match self.0.recv_timeout(LIMIT) {
            Ok(line) => Some(line),
            Err(RecvTimeoutError::Disconnected) => None,
            Err(RecvTimeoutError::Timeout) => panic!("no line within {} s", LIMIT.as_secs()),
        }
    }
}
