//! The process of one force provider. The program writes questions to the standard input of the process and reads
//! answers from its standard output.

use std::io::{BufRead as _, BufReader, Read as _, Write as _};
use std::process::{Child, ChildStdin, ChildStdout, Command, ExitStatus, Stdio};
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, sync_channel};
use std::time::{Duration, Instant};

use fenderline_sim::external::{ForceProvider, ForceReply, ForceRequest};

use super::group::Group;
use super::protocol;

/// Longest line that a provider may write (bytes).
const LONGEST_LINE: u64 = 64 * 1024;

/// Largest number of questions to a provider that wait for an answer. A pipe of any operating system holds this number
/// of questions, so that a provider that does not read them cannot block the run.
const UNANSWERED: u64 = 8;
/// Number of timeouts in a row after which the run no longer waits for a provider, until the provider answers again.
const PATIENCE: u32 = 3;

/// A running provider.
pub(super) struct Process {
    child: Child,
    /// The provider and the processes that it started.
    group: Group,
    /// Standard input of the provider; `None` once the provider has closed it.
    input: Option<ChildStdin>,
    lines: Receiver<String>,
    timeout: Duration,
    asked: u64,
    /// Number of the oldest question without an answer.
    unanswered: u64,
    timeouts: u32,
}

impl Process {
    /// Starts a provider's command and sends the greeting line.
    pub(super) fn start(
        command: &[String],
        timeout_s: f64,
        hello: &str,
    ) -> Result<Process, std::io::Error> {
        let [program, arguments @ ..] = command else {
            return Err(std::io::Error::other("the command is empty"));
        };
        let mut command = Command::new(program);
        command.args(arguments).stdin(Stdio::piped()).stdout(Stdio::piped());
        let (mut child, group) = Group::start(&mut command)?;
        let output = child.stdout.take().ok_or_else(|| std::io::Error::other("no output"))?;
        let input = child.stdin.take();
        // A provider that writes without being asked fills the channel and then has to wait.
        let (send, lines) = sync_channel(64);
        std::thread::spawn(move || listen(output, &send));
        let timeout = Duration::from_secs_f64(timeout_s);
        let mut process =
            Process { child, group, input, lines, timeout, asked: 0, unanswered: 0, timeouts: 0 };
        process.say(hello);
        Ok(process)
    }

    fn say(&mut self, line: &str) {
        let said = self.input.as_mut().map(|input| {
            input.write_all(line.as_bytes()).and_then(|()| input.write_all(b"\n"))?;
            input.flush()
        });
        if matches!(said, Some(Err(_))) {
            self.input = None;
        }
    }

    /// Text that says why the provider no longer answers.
    fn epitaph(&mut self) -> String {
        match self.ended() {
            Some(status) => format!("it ended: {status}"),
            None => "it closed its output".to_owned(),
        }
    }

    /// The exit status of the provider. A process closes its output a moment before it ends; it therefore gets half a
    /// second to end.
    fn ended(&mut self) -> Option<ExitStatus> {
        let until = Instant::now() + Duration::from_millis(500);
        loop {
            if self.group.has_leader_ended(&mut self.child) {
                // Before it is waited for: after that its number may be reused.
                self.group.end();
                return self.child.wait().ok();
            }
            if Instant::now() >= until {
                return None;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

impl ForceProvider for Process {
    fn reply(&mut self, request: &ForceRequest) -> ForceReply {
        let mut is_asked = false;
        let waits = if self.timeouts < PATIENCE { self.timeout } else { Duration::ZERO };
        let mut until = Instant::now() + waits;
        loop {
            if !is_asked && self.asked < self.unanswered + UNANSWERED {
                self.say(&protocol::question(self.asked, request));
                self.asked += 1;
                is_asked = true;
            }
            let left = until.saturating_duration_since(Instant::now());
            match self.lines.recv_timeout(left) {
                Ok(line) => {
                    // A line that is not an answer is skipped.
                    let Some((n, wrench)) = protocol::answer(&line, request) else { continue };
                    if is_asked && n.saturating_add(1) == self.asked {
                        (self.unanswered, self.timeouts) = (self.asked, 0);
                        return ForceReply::Wrench(wrench);
                    }
                    // Too late for its step. The run waits again for a provider that answers again.
                    self.unanswered = self.unanswered.max(n.saturating_add(1)).min(self.asked);
                    if self.timeouts >= PATIENCE {
                        self.timeouts = 0;
                        until = Instant::now() + self.timeout;
                    }
                }
                Err(RecvTimeoutError::Timeout) => {
                    self.timeouts = self.timeouts.saturating_add(1);
                    return ForceReply::Late;
                }
                Err(RecvTimeoutError::Disconnected) => return ForceReply::Dead(self.epitaph()),
            }
        }
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        // A provider that reads its input to the end ends by itself; another one is ended.
        self.input = None;
        if self.ended().is_some() {
            return;
        }
        self.group.end();
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// Passes the provider's lines on until the provider ends or the channel is closed. A line that is too long is cut, and
/// then is no valid answer.
fn listen(output: ChildStdout, send: &SyncSender<String>) {
    let mut reader = BufReader::new(output);
    let mut line = Vec::new();
    loop {
        line.clear();
        let read = reader.by_ref().take(LONGEST_LINE).read_until(b'\n', &mut line);
        match read {
            Ok(0) | Err(_) => return,
            Ok(_) => {
                let text = String::from_utf8_lossy(&line).into_owned();
                if send.send(text).is_err() {
                    return;
                }
            }
        }
    }
}
