//! The live server: a session in real time that people steer from browsers over websockets.
//!
//! One thread simulates, and some threads serve the network. The threads share only `hub`: the latest frame for every
//! client, and a limited queue of commands.
//!
//! | of the simulation | |
//! |---|---|
//! | `engine` | the thread of the simulation, the only one that touches the session |
//! | `pacer` | its clock |
//! | `claims`, `permit`, `role_words` | which client may use which control, and what each role may do |
//! | `recorder`, `saved` | write a session to its file; read and replay a recording |
//! | `kept_seats` | the file beside the recording with links and holders of controls, for a server that starts again |
//! | `gallery`, `opening` | the files that can be opened; opening and saving on another thread |
//! | `file_change`, `file_name` | renaming, deleting and putting back files of the gallery; names of new files |
//! | `instruments` | the sentences of ships' instruments |
//!
//! | of the network | |
//! |---|---|
//! | `http`, `page` | HTTP requests, and the files of the page |
//! | `known_hosts`, `tokens` | which hosts and origins are answered, and the links to pages |
//! | `client` | the task that serves one websocket |
//! | `wire` | instrument sentences to chart programs, over TCP and UDP |
//! | `steering` | orders of controllers by NMEA sentences, over TCP |
//! | `connections`, `seats`, `rate`, `log` | limits on connections, clients, commands and log lines |
//!
//! The crate knows nothing of the command line. The program gives [`Options`], shows [`Server::greeting`] and decides
//! when the server stops.
#![forbid(unsafe_code)]

mod claims;
mod client;
mod connections;
mod engine;
mod file_change;
mod file_name;
mod gallery;
mod http;
mod hub;
mod instruments;
mod kept_seats;
mod known_hosts;
mod log;
mod new_file;
mod opening;
mod pacer;
mod page;
mod permit;
mod rate;
mod recorder;
mod role_words;
mod saved;
mod seats;
mod steering;
mod tokens;
mod wire;

use core::fmt;
use std::net::{IpAddr, SocketAddr};
use std::path::{Path, PathBuf};
use std::sync::{Arc, mpsc};
use std::thread::JoinHandle;

pub use fenderline_live::Ghost;
use fenderline_live::Session;
use fenderline_live::message::Link;
use fenderline_nautical::ChartOrigin;
use tokio::net::{TcpListener, TcpSocket, UdpSocket};
use tokio::runtime::Runtime;
use tokio::sync::oneshot;

use self::engine::Engine;
use self::gallery::Gallery;
use self::http::Site;
use self::hub::{Hub, ToEngine};
use self::known_hosts::KnownHosts;
pub use self::log::Notify;
pub use self::opening::MakeReport;
use self::page::Page;
pub use self::page::has_pages;
use self::role_words::role_words;
use self::saved::{Progress, ReplayFailure};

/// What the server serves, and to whom.
#[derive(Clone, Debug)]
pub struct Options {
    /// Scenario file, or recorded session that the server continues.
    pub scenario: PathBuf,
    /// Keys of the scenario to override, each `KEY=VALUE`.
    pub set: Vec<String>,
    /// A measured ship that pages show beside the simulated ships of the scenario; only for a scenario, because a recorded
    /// session keeps its own.
    pub ghost: Option<Ghost>,
    /// Address to listen on.
    pub bind: IpAddr,
    /// Port to listen on. With port 0 the operating system chooses a free port.
    pub port: u16,
    /// True if other machines may connect to the server.
    pub allow_remote: bool,
    /// Names under which other machines know this machine.
    pub host_names: Vec<String>,
    /// Folder with built pages. With `None` the server uses the pages that are built into the program.
    pub page: Option<PathBuf>,
    /// Folder with scenarios that the page can open. With `None` the pages can open the scenarios in the folder of the
    /// served scenario.
    pub gallery: Option<PathBuf>,
    /// Folder in which sessions are recorded.
    pub sessions: PathBuf,
    /// True to start paused. If false, the session starts when the first page connects.
    pub is_paused: bool,
    /// TCP port on which the server listens for chart programs.
    pub nmea_tcp: Option<u16>,
    /// UDP address of a chart program to which sentences are sent.
    pub nmea_udp: Option<SocketAddr>,
    /// Address on which the server listens for controllers that steer the pilot's ship by NMEA sentences.
    pub nmea_steer: Option<SocketAddr>,
    /// Geographic position of the scenario's origin in the sentences to chart programs. With `None`, positions count
    /// from the origin of the scenario's nautical chart, or from 0° N 0° E without a chart.
    pub origin: Option<ChartOrigin>,
    /// Function that makes the report of a session for the page.
    pub report: MakeReport,
    /// Function that receives notices about the server.
    pub notify: Notify,
}

/// Why the server or the replay of a recording ended.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum ServeError {
    /// The user's input cannot be used.
    Input(String),
    /// The input is good, but serving or replaying failed.
    Failed(String),
}

impl ServeError {
    fn input(error: impl fmt::Display) -> ServeError {
        ServeError::Input(error.to_string())
    }

    fn failed(error: impl fmt::Display) -> ServeError {
        ServeError::Failed(error.to_string())
    }
}

impl fmt::Display for ServeError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            ServeError::Input(text) | ServeError::Failed(text) => f.write_str(text),
        }
    }
}

impl core::error::Error for ServeError {}

/// Number of threads for network traffic. The simulation has a thread of its own.
const NETWORK_THREADS: usize = 2;
/// Size of the operating system's send buffer for each client (bytes): a second or two of frames for a client that
/// reads slowly.
const SEND_BUFFER: u32 = 128 << 10;
/// Addresses from which datagrams to chart programs are sent.
const ANY_4: IpAddr = IpAddr::V4(std::net::Ipv4Addr::UNSPECIFIED);
const ANY_6: IpAddr = IpAddr::V6(std::net::Ipv6Addr::UNSPECIFIED);
/// Number of connections that may wait until the server accepts them.
const BACKLOG: u32 = 256;

/// A server that listens for clients, and whose thread of the simulation is running.
pub struct Server {
    runtime: Runtime,
    listener: TcpListener,
    site: Arc<Site>,
    hub: Arc<Hub>,
    simulation: JoinHandle<Vec<PathBuf>>,
    simulation_ended: oneshot::Receiver<()>,
    greeting: String,
    recording: PathBuf,
}

impl Server {
    /// Opens the scenario, begins the recording and listens for clients. A recorded session is replayed first.
    /// The function `progress` gets the number of replayed ticks and their total.
    ///
    /// # Errors
    /// Fails for bad input: a scenario, an address or a page that cannot be used. Fails too if another program uses a
    /// port.
    pub fn start(
        options: &Options,
        mut progress: impl FnMut(u64, u64),
    ) -> Result<Server, ServeError> {
        let notify = options.notify;
        check_addresses(options)?;
        let opened =
            gallery::open(&options.scenario, &options.set, options.ghost.as_ref(), &mut |at| {
                if let Progress::Replaying(done, of) = at {
                    progress(done, of);
                }
                Ok(())
            });
        let opened = opened.map_err(|why| ServeError::input(format_args!("error: {why}")))?;
        for notice in &opened.notices {
            notify(&format!("notice: {notice}"));
        }
        let page = match &options.page {
            Some(folder) => {
                Page::read(folder).map_err(|why| ServeError::input(format_args!("error: {why}")))?
            }
            None => Page::embedded(notify),
        };
        let has_charts = options.nmea_tcp.is_some() || options.nmea_udp.is_some();
        let (to_engine, messages) = mpsc::channel();
        let hub = Arc::new(Hub::new(to_engine, notify));
        let engine = Engine::new(
            Arc::clone(&hub),
            opened,
            gallery(options),
            options.sessions.clone(),
            options.report,
            options.is_paused,
            (has_charts, options.origin),
        )
        .map_err(|why| ServeError::failed(format_args!("error: {why}")))?;
        let runtime = tokio::runtime::Builder::new_multi_thread()
            .worker_threads(NETWORK_THREADS)
            .enable_all()
            .build()
            .map_err(|e| {
                ServeError::failed(format_args!(
                    "error: the system gives no threads for the network: {e}"
                ))
            })?;
        let address = SocketAddr::new(options.bind, options.port);
        let listener = runtime.block_on(async { listen(address) }).map_err(|e| {
            ServeError::failed(format_args!(
                "error: cannot listen on {address}: {e} (another --port?)"
            ))
        })?;
        let address = listener.local_addr().unwrap_or(address);
        let wires = wires(options, &hub, &runtime)?;
        let (links, recording) = (engine.links(), engine.recording().to_owned());
        // The sender is dropped when the thread ends, even by a panic. The server then stops.
        let (alive, simulation_ended) = oneshot::channel::<()>();
        let simulation = std::thread::Builder::new()
            .name("simulation".into())
            .spawn(move || {
                let recordings = engine.run(&messages);
                drop(alive);
                recordings
            })
            .map_err(|e| {
                ServeError::failed(format_args!(
                    "error: the system gives no thread for the simulation: {e}"
                ))
            })?;
        let known_hosts =
            KnownHosts { remote: !options.bind.is_loopback(), names: options.host_names.clone() };
        let site = Arc::new(Site::new(Arc::clone(&hub), page, known_hosts));
        let greeting = greeting(address, &links, &wires, &recording);
        Ok(Server {
            runtime,
            listener,
            site,
            hub,
            simulation,
            simulation_ended,
            greeting,
            recording,
        })
    }

    /// The text that the program prints for the user: the address, a link for each role, the ports for chart programs,
    /// and the recording's file.
    pub fn greeting(&self) -> &str {
        &self.greeting
    }

    /// Serves until `stop` is sent or dropped, or the simulation's thread ends. Returns the files of the recordings
    /// that were made, one for each session, in their order.
    ///
    /// # Errors
    /// The simulation's thread panicked.
    pub fn run(self, stop: oneshot::Receiver<()>) -> Result<Vec<PathBuf>, ServeError> {
        let Server { runtime, listener, site, hub, simulation, simulation_ended, .. } = self;
        runtime.block_on(async {
            tokio::select! {
                () = http::serve(listener, site) => {}
                _ = stop => {}
                _ = simulation_ended => {}
            }
        });
        hub.send_to_engine(ToEngine::Stop);
        simulation.join().map_err(|_| {
            ServeError::failed(
                "error: the thread of the simulation panicked: see its message above",
            )
        })
    }
}

/// Refuses addresses of other machines, unless the user allows them.
fn check_addresses(options: &Options) -> Result<(), ServeError> {
    if options.allow_remote {
        return Ok(());
    }
    if !options.bind.is_loopback() {
        return Err(ServeError::input(format_args!(
            "error: {} is not a loopback address: other machines could reach the server. Give --allow-remote if \
             you want that",
            options.bind
        )));
    }
    if let Some(at) = options.nmea_steer.filter(|at| !at.ip().is_loopback()) {
        return Err(ServeError::input(format_args!(
            "error: {at} is not a loopback address: anybody who reaches the address could steer the ship without a link. \
             Give --allow-remote if you want that"
        )));
    }
    match options.nmea_udp {
        Some(to) if !to.ip().is_loopback() => Err(ServeError::input(format_args!(
            "error: {to} is not a loopback address. Give --allow-remote to send sentences to another machine"
        ))),
        _ => Ok(()),
    }
}

/// Fills the gallery: first the scenario, then the scenarios in its folder or the given folder, then recorded sessions.
fn gallery(options: &Options) -> Gallery {
    let beside = options.scenario.parent().unwrap_or(Path::new(""));
    let beside = if beside.as_os_str().is_empty() { Path::new(".") } else { beside };
    let folder = options.gallery.as_deref().unwrap_or(beside);
    let mut gallery = Gallery::new(folder, &options.sessions);
    gallery.add(&options.scenario);
    gallery.fill();
    gallery
}

/// Starts the connections to chart programs and controllers. Returns a line for the user about each connection.
fn wires(options: &Options, hub: &Arc<Hub>, runtime: &Runtime) -> Result<String, ServeError> {
    let mut lines = String::new();
    let cannot = |what: String| move |e| ServeError::failed(format_args!("error: {what}: {e}"));
    if let Some(port) = options.nmea_tcp {
        let at = SocketAddr::new(options.bind, port);
        let listener = runtime
            .block_on(TcpListener::bind(at))
            .map_err(cannot(format!("the server cannot listen for chart programs on {at}")))?;
        let at = listener.local_addr().unwrap_or(at);
        lines += &format!("NMEA 0183 and AIS over TCP on {at}\n");
        runtime.spawn(wire::tcp(listener, Arc::clone(hub)));
    }
    if let Some(at) = options.nmea_steer {
        let listener = runtime
            .block_on(TcpListener::bind(at))
            .map_err(cannot(format!("the server cannot listen for controllers on {at}")))?;
        let at = listener.local_addr().unwrap_or(at);
        lines += &format!("NMEA 0183 orders of a controller over TCP on {at}\n");
        runtime.spawn(steering::serve(listener, Arc::clone(hub)));
    }
    if let Some(to) = options.nmea_udp {
        let from = SocketAddr::new(if to.is_ipv4() { ANY_4 } else { ANY_6 }, 0);
        let socket = runtime
            .block_on(UdpSocket::bind(from))
            .map_err(cannot(format!("cannot send to {to}")))?;
        lines += &format!("NMEA 0183 and AIS over UDP to {to}\n");
        runtime.spawn(wire::udp(socket, to, Arc::clone(hub)));
    }
    Ok(lines)
}

/// Opens a listening socket. The connections of the listening socket have small send buffers, so that a slow client
/// does not read old frames.
fn listen(address: SocketAddr) -> std::io::Result<TcpListener> {
    let socket = if address.is_ipv4() { TcpSocket::new_v4()? } else { TcpSocket::new_v6()? };
    // The port of a server that has just ended can be used again. On Windows the option has another meaning.
    #[cfg(not(windows))]
    socket.set_reuseaddr(true)?;
    socket.set_send_buffer_size(SEND_BUFFER)?;
    socket.bind(address)?;
    socket.listen(BACKLOG)
}

/// The text that is printed for the user when the server has started.
fn greeting(address: SocketAddr, links: &[Link], wires: &str, recording: &Path) -> String {
    // The unspecified address stands for all addresses of this machine. A browser cannot open it.
    let shown = match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => format!("localhost:{}", address.port()),
        IpAddr::V6(ip) if ip.is_unspecified() => format!("localhost:{}", address.port()),
        _ => address.to_string(),
    };
    let width = links.iter().map(|link| role_words(&link.role).len()).max().unwrap_or(0);
    let mut text = format!(
        "fenderline is on http://{shown}. Ctrl-C ends the server; a second Ctrl-C ends it at once. Open one of these:\n"
    );
    for Link { role, path } in links {
        text += &format!("  {:width$}  http://{shown}{path}\n", role_words(role));
    }
    text + wires
        + &format!(
            "Whoever has a link has the role of that link. Recorded to {}\n",
            recording.display()
        )
}

/// A recorded session that was replayed to its end.
#[derive(Debug)]
pub struct Replayed {
    /// The session at the end of its recording. It is not recorded.
    pub session: Session,
    /// Number of branches of the replayed session.
    pub branches: usize,
    /// Number of ticks of all branches together.
    pub ticks: u64,
    /// Number of recorded states. Number of recorded states, every one of which the replay reached with the same bits.
    pub equal_states: u64,
    /// Says what is missing at the recording's end. The text is `None` for a complete recording.
    pub incomplete: Option<String>,
}

/// True if a file begins as a recorded session does. The result is false for a file that cannot be opened.
#[must_use]
pub fn is_recording(path: &Path) -> bool {
    matches!(saved::open(path), Ok(Some(_)))
}

/// Replays a recorded session and compares every recorded state. The function `progress` gets the number of replayed
/// ticks and their total.
///
/// # Errors
/// Fails for a file that is not a recording or is damaged, and for a session whose replay differs in any bit.
pub fn replay(session: &Path, mut progress: impl FnMut(u64, u64)) -> Result<Replayed, ServeError> {
    let name = session.display();
    let file = saved::open(session)
        .map_err(|why| ServeError::input(format_args!("error: cannot read {why}")))?;
    let file = file.ok_or_else(|| {
        ServeError::input(format_args!("error: {name}: this is not a recorded session"))
    })?;
    let replayed = saved::replay(file, &mut |at| {
        if let Progress::Replaying(done, of) = at {
            progress(done, of);
        }
        Ok(())
    });
    replayed.map(Replayed::of).map_err(|why| match why {
        ReplayFailure::Differs(error) => ServeError::failed(format_args!("error: {name}, {error}")),
        other => ServeError::input(format_args!("error: {name}, {other}")),
    })
}

/// Replays a recording in memory, as [`replay`] does for a file. The function `stop` is called from time to time; if it
/// returns true, the replay stops.
///
/// # Errors
/// Fails as [`replay`] does, but without the file's name in the error. The replay was stopped.
pub fn replay_bytes(
    recording: &[u8],
    mut stop: impl FnMut() -> bool,
) -> Result<Replayed, ServeError> {
    let watch = &mut |_| if stop() { Err("stopped".to_owned()) } else { Ok(()) };
    let replayed = saved::replay(std::io::Cursor::new(recording), watch);
    replayed.map(Replayed::of).map_err(|why| match why {
        ReplayFailure::Differs(error) => ServeError::failed(error),
        other => ServeError::input(other),
    })
}

impl Replayed {
    fn of<R>(replayed: saved::Replayed<R>) -> Replayed {
        let saved::Replayed { session, equal_states, outline, .. } = replayed;
        Replayed {
            session,
            branches: outline.branches,
            ticks: outline.ticks,
            equal_states,
            incomplete: saved::missing_at_end(outline.ending),
        }
    }
}

impl fmt::Debug for Server {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Server").field("recording", &self.recording).finish_non_exhaustive()
    }
}
