//! The program as a server of its own for each test, on a free port.
#![allow(dead_code, reason = "each test file uses its own part")]

#[path = "../support/limited.rs"]
pub(crate) mod limited;

use std::collections::BTreeMap;
use std::fs;
use std::io::Read as _;
use std::net::SocketAddr;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::atomic::{AtomicU32, Ordering};

use limited::Lines;

static NEXT: AtomicU32 = AtomicU32::new(0);

/// A running server; killed when dropped.
pub(crate) struct Server {
    child: Child,
    folder: PathBuf,
    recording: PathBuf,
    links: BTreeMap<String, String>,
    pub(crate) port: u16,
    /// Where chart programs connect, if it was asked for.
    pub(crate) nmea: Option<SocketAddr>,
}

pub(crate) fn program() -> Command {
    Command::new(env!("CARGO_BIN_EXE_fenderline"))
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
        shell.arg(env!("CARGO_BIN_EXE_fenderline"));
        Server::start_by(shell, None, options)
    }

    fn start_in(session: Option<&Path>, options: &[&str]) -> Server {
        Server::start_by(program(), session, options)
    }

    fn start_by(mut command: Command, session: Option<&Path>, options: &[&str]) -> Server {
        let number = NEXT.fetch_add(1, Ordering::Relaxed);
        let name = format!("fenderline-serve-{}-{number}", std::process::id());
        let folder = std::env::temp_dir().join(name);
        fs::create_dir_all(folder.join("page/assets")).expect("a folder");
        fs::write(folder.join("page/index.html"), "<p>a page").expect("written");
        fs::write(folder.join("page/assets/a.js"), "1").expect("written");
        let scene = folder.join("harbour.toml");
        fs::copy(scenario(), &scene).expect("copied");
        command.arg("serve").arg(session.unwrap_or(&scene)).args(["--port", "0"]).args(options);
        command.arg("--page").arg(folder.join("page"));
        command.arg("--sessions").arg(folder.join("sessions"));
        let mut child =
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().expect("it starts");
        let lines = Lines::of(child.stdout.take().expect("piped"));
        let mut links = BTreeMap::new();
        let (mut port, mut recording, mut nmea) = (0, PathBuf::new(), None);
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
            } else if let Some((role, url)) = line.split_once("  http://") {
                let (host, path) = url.split_once('/').expect("a path");
                port = host.rsplit(':').next().and_then(|p| p.parse().ok()).expect("a port");
                links.insert(role.trim().to_owned(), format!("/{path}"));
            }
        }
        // Its later messages are read and dropped, so that it does not wait for a reader.
        let mut errors = child.stderr.take().expect("piped");
        std::thread::spawn(move || {
            let mut said = String::new();
            let _ = errors.read_to_string(&mut said);
        });
        Server { child, folder, recording, links, port, nmea }
    }

    /// The link of a role, as a path.
    pub(crate) fn path(&self, role: &str) -> String {
        self.links.get(role).unwrap_or_else(|| panic!("no {role} among {:?}", self.links)).clone()
    }

    pub(crate) fn sessions(&self) -> PathBuf {
        self.folder.join("sessions")
    }

    /// The memory that it holds (KiB); 0 where the system does not tell.
    pub(crate) fn memory_kib(&self) -> u64 {
        let status = fs::read_to_string(format!("/proc/{}/status", self.child.id()));
        let status = status.unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"));
        line.and_then(|line| line.split_whitespace().next()?.parse().ok()).unwrap_or(0)
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
        for entry in fs::read_dir(self.sessions()).expect("a folder").flatten() {
            let said = replay(&entry.path());
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
