//! The program as a server of its own for each test, on a free port.
#![allow(dead_code, reason = "each test file uses its own part")]

use std::collections::BTreeMap;
use std::ffi::OsString;
use std::fs;
use std::io::{BufRead as _, BufReader, Read as _};
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::{Arc, Mutex};

use crate::support::limited::{self, Lines};

static NEXT: AtomicU32 = AtomicU32::new(0);

/// A running server; killed when dropped.
pub(crate) struct Server {
    child: Child,
    folder: PathBuf,
    recording: PathBuf,
    links: BTreeMap<String, String>,
    /// What it has said on its standard error so far.
    said: Arc<Mutex<String>>,
    pub(crate) port: u16,
    /// Where chart programs connect, if it was asked for.
    pub(crate) nmea: Option<SocketAddr>,
    /// Where controllers connect, if it was asked for.
    pub(crate) steer: Option<SocketAddr>,
}

/// The program under test: the one that the environment names, or the one that cargo built with the tests.
fn program_path() -> OsString {
    std::env::var_os("FENDERLINE_PROGRAM")
        .unwrap_or_else(|| OsString::from(env!("CARGO_BIN_EXE_fenderline")))
}

pub(crate) fn program() -> Command {
    Command::new(program_path())
}

pub(crate) fn scenario() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/berth/alongside_with_two_tugs.toml")
}

impl Server {
    /// The harbour scene, with some options.
    pub(crate) fn start(options: &[&str]) -> Server {
        Server::start_in(None, options)
    }

    /// A recorded session.
    pub(crate) fn start_with(session: &Path, options: &[&str]) -> Server {
        Server::start_in(Some(session), options)
    }

    /// The harbour scene, by a shell that first does something to itself: limits, a library that lies.
    #[cfg(unix)]
    pub(crate) fn start_under(limits: &str, options: &[&str]) -> Server {
        let mut shell = Command::new("sh");
        shell.args(["-c", &format!("{limits}; exec \"$0\" \"$@\"")]);
        shell.arg(program_path());
        Server::start_by(shell, None, options)
    }

    fn start_in(session: Option<&Path>, options: &[&str]) -> Server {
        Server::start_by(program(), session, options)
    }

    /// Kills it, and starts it again with its own recording, folder and port.
    pub(crate) fn killed_and_started_again(mut self, options: &[&str]) -> Server {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let (folder, recording) = (std::mem::take(&mut self.folder), self.recording.clone());
        Server::start_at(program(), folder, &recording, self.port, options)
    }

    /// Links of all roles, as paths.
    pub(crate) fn links(&self) -> &BTreeMap<String, String> {
        &self.links
    }

    /// The file of its recording.
    pub(crate) fn recording(&self) -> &Path {
        &self.recording
    }

    /// What it has said on its standard error so far.
    pub(crate) fn said(&self) -> String {
        self.said.lock().expect("no panic").clone()
    }

    fn start_by(command: Command, session: Option<&Path>, options: &[&str]) -> Server {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("fenderline-serve-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(folder.join("page/assets")).expect("a folder");
        fs::write(folder.join("page/index.html"), "<p>a page").expect("written");
        fs::write(folder.join("page/assets/a.js"), "1").expect("written");
        let scene = folder.join("harbour.toml");
        fs::copy(scenario(), &scene).expect("copied");
        Server::start_at(command, folder, session.unwrap_or(&scene), 0, options)
    }

    fn start_at(
        mut command: Command,
        folder: PathBuf,
        session: &Path,
        port: u16,
        options: &[&str],
    ) -> Server {
        command.arg("serve").arg(session).args(["--port", &port.to_string()]).args(options);
        command.arg("--page").arg(folder.join("page"));
        command.arg("--sessions").arg(folder.join("sessions"));
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        let lines = Lines::of(child.stdout.take().expect("piped"));
        let mut links = BTreeMap::new();
        let (mut port, mut recording, mut nmea, mut steer) = (0, PathBuf::new(), None, None);
        while recording.as_os_str().is_empty() {
            let Some(line) = lines.next() else {
                let mut why = String::new();
                let _ = child.stderr.take().expect("piped").read_to_string(&mut why);
                panic!("no links: {why}");
            };
            if let Some((_, file)) = line.split_once("Recorded to ") {
                recording = PathBuf::from(file);
            } else if let Some((_, at)) = line.split_once("AIS over TCP on ") {
                nmea = Some(at.parse().expect("an address"));
            } else if let Some((_, at)) = line.split_once("of a controller over TCP on ") {
                steer = Some(at.parse().expect("an address"));
            } else if let Some((role, url)) = line.split_once("  http://") {
                let (host, path) = url.split_once('/').expect("a path");
                port = host.rsplit(':').next().and_then(|p| p.parse().ok()).expect("a port");
                links.insert(role.trim().to_owned(), format!("/{path}"));
            }
        }
        // Its later messages are read, so that it does not wait for a reader.
        let errors = BufReader::new(child.stderr.take().expect("piped"));
        let said = Arc::new(Mutex::new(String::new()));
        let heard = Arc::clone(&said);
        std::thread::spawn(move || {
            for line in errors.lines().map_while(Result::ok) {
                *heard.lock().expect("no panic") += &(line + "\n");
            }
        });
        Server { child, folder, recording, links, said, port, nmea, steer }
    }

    /// The link of a role, as a path.
    pub(crate) fn path(&self, role: &str) -> String {
        self.links.get(role).unwrap_or_else(|| panic!("no {role} among {:?}", self.links)).clone()
    }

    pub(crate) fn sessions(&self) -> PathBuf {
        self.folder.join("sessions")
    }

    /// The recordings in its folder.
    pub(crate) fn recordings(&self) -> Vec<PathBuf> {
        let files = fs::read_dir(self.sessions()).expect("a folder").flatten();
        let files = files.map(|entry| entry.path());
        files.filter(|path| path.to_string_lossy().ends_with(".session.jsonl")).collect()
    }

    /// The memory that it holds (KiB); 0 if the system does not tell.
    pub(crate) fn memory_kib(&self) -> u64 {
        let status = fs::read_to_string(format!("/proc/{}/status", self.child.id()));
        let status = status.unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
        line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(0)
    }

    /// The processor time of its thread of this name, and the time for which that was ready but had to wait for a processor (s);
    /// `None` if the system does not tell.
    pub(crate) fn thread_times_s(&self, name: &str) -> Option<[f64; 2]> {
        let tasks = fs::read_dir(format!("/proc/{}/task", self.child.id())).ok()?;
        let mut tasks = tasks.flatten().map(|task| task.path());
        let is_it = |task: &PathBuf| {
            fs::read_to_string(task.join("comm")).is_ok_and(|comm| comm.trim_end() == name)
        };
        let text = fs::read_to_string(tasks.find(is_it)?.join("schedstat")).ok()?;
        let mut numbers = text.split_whitespace().map(|word| word.parse::<f64>().ok());
        Some([1e-9 * numbers.next()??, 1e-9 * numbers.next()??])
    }

    fn end(&mut self) -> String {
        let _ = self.child.kill();
        let _ = self.child.wait();
        fs::read_to_string(&self.recording).expect("a recording")
    }

    /// Interrupts it as Ctrl-C does; its recording.
    #[cfg(unix)]
    pub(crate) fn interrupt(mut self) -> (PathBuf, String) {
        let id = self.child.id().to_string();
        let told = Command::new("kill").args(["-INT", &id]).status().expect("kill");
        assert!(told.success());
        assert_eq!(limited::end_of(&mut self.child).code(), Some(0));
        self.kill()
    }

    /// Kills it; its recording.
    pub(crate) fn kill(mut self) -> (PathBuf, String) {
        let text = self.end();
        let kept = std::env::temp_dir().join(format!(
            "fenderline-killed-{}-{}.session.jsonl",
            std::process::id(),
            NEXT.fetch_add(1, Ordering::Relaxed)
        ));
        fs::write(&kept, &text).expect("written");
        (kept, text)
    }

    /// Kills it, and plays every session that it recorded again: the same bits.
    pub(crate) fn stop_and_check(mut self) {
        assert!(self.child.try_wait().expect("its state").is_none(), "it ended by itself");
        self.end();
        for session in self.recordings() {
            let said = replay(&session);
            assert!(said.contains("the same bits"), "{said}");
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// What `fenderline replay` says of a session.
pub(crate) fn replay(session: &Path) -> String {
    replayed(session).1
}

/// What `fenderline replay` says of a session, and its exit code.
pub(crate) fn replayed(session: &Path) -> (Option<i32>, String) {
    let output = limited::output(program().arg("replay").arg(session));
    let text = [output.stdout, output.stderr].concat();
    (output.status.code(), String::from_utf8_lossy(&text).into_owned())
}

/// What it says when it does not start.
pub(crate) fn refused(options: &[&str]) -> String {
    let output = limited::output(program().arg("serve").arg(scenario()).args(options));
    assert_eq!(output.status.code(), Some(2));
    String::from_utf8_lossy(&output.stderr).into_owned()
}
