//! `fenderline serve`: a scenario in real time, steered from browsers.
//!
//! `engine` is the simulation's thread and the only one that touches the session; `pacer` is its clock, `claims` and
//! `permit` decide who may do what, `recorder` writes the session down, `gallery` opens scenarios and sessions, `saved`
//! reads recordings, `opening` does both beside the simulation. `interrupt` hears Ctrl-C. `http`
//! answers requests, `door` and `tokens` let people in, `page` is what browsers get; `client` is the task of one
//! websocket. `hub` is what lies between: the latest frame for everybody, no queue that grows. `instruments` is what
//! ships say to chart programs, `wire` how.

mod claims;
mod client;
mod crowd;
mod door;
mod engine;
mod gallery;
mod http;
mod hub;
mod instruments;
mod interrupt;
mod log;
mod opening;
mod pacer;
mod page;
mod permit;
mod rate;
mod recorder;
mod saved;
mod seats;
mod tokens;
mod wire;

use std::net::{IpAddr, SocketAddr};
use std::path::Path;
use std::sync::{Arc, mpsc};

use fenderline_live::message::{Link, Role};
use tokio::net::{TcpListener, TcpSocket, UdpSocket};
use tokio::runtime::Runtime;

use self::door::Door;
use self::engine::Engine;
use self::gallery::Gallery;
use self::http::Site;
use self::hub::{Hub, Told};
use self::page::Page;
use self::saved::{Played, Unplayed, Way};
use crate::cli::{ReplayArgs, ServeArgs};
use crate::failure::Failure;
use crate::progress::Progress;
use crate::terminal::{say, tell};

/// Threads for the network. The simulation has its own.
const NETWORK_THREADS: usize = 2;
/// What the operating system holds for a client that reads slowly (bytes): a second or two of frames.
const SEND_BUFFER: u32 = 128 << 10;
/// Where datagrams are sent from.
const ANY_4: IpAddr = IpAddr::V4(std::net::Ipv4Addr::UNSPECIFIED);
const ANY_6: IpAddr = IpAddr::V6(std::net::Ipv6Addr::UNSPECIFIED);
/// Connections that wait to be accepted.
const BACKLOG: u32 = 256;

/// Serves until it is interrupted.
///
/// # Errors
/// Bad input: a scenario, an address or a page that cannot be used. A port that is taken.
pub(crate) fn serve(args: &ServeArgs) -> Result<(), Failure> {
    let remote = !args.bind.is_loopback();
    if remote && !args.allow_remote {
        return Err(Failure::input(format_args!(
            "error: {} is not loopback: others could reach the server. Say --allow-remote if they shall",
            args.bind
        )));
    }
    let set: Vec<String> = args.set.clone();
    let mut bar = None;
    let opened = gallery::open(&args.scenario, &set, &mut |way| {
        show(&mut bar, way);
        Ok(())
    });
    drop(bar);
    let opened = opened.map_err(|why| Failure::input(format_args!("error: {why}")))?;
    for notice in &opened.notices {
        tell(&format!("notice: {notice}"));
    }
    let mut gallery = Gallery::default();
    gallery.add(&args.scenario);
    let beside = args.scenario.parent().unwrap_or(Path::new(""));
    let beside = if beside.as_os_str().is_empty() { Path::new(".") } else { beside };
    gallery.fill(&[args.gallery.as_deref().unwrap_or(beside), &args.sessions]);
    let page = match &args.page {
        Some(folder) => {
            Page::read(folder).map_err(|why| Failure::input(format_args!("error: {why}")))?
        }
        None => Page::of_repository(),
    };
    if let Some(to) = args.nmea_udp.filter(|to| !to.ip().is_loopback() && !args.allow_remote) {
        return Err(Failure::input(format_args!(
            "error: {to} is not loopback. Say --allow-remote if sentences shall go there"
        )));
    }
    let speaks = args.nmea_tcp.is_some() || args.nmea_udp.is_some();
    let (to_engine, told) = mpsc::channel();
    let hub = Arc::new(Hub::new(to_engine));
    let engine = Engine::new(
        Arc::clone(&hub),
        opened,
        gallery,
        args.sessions.clone(),
        args.paused,
        speaks.then_some(args.origin),
    )
    .map_err(|why| Failure::case(format_args!("error: {why}")))?;
    let runtime = tokio::runtime::Builder::new_multi_thread()
        .worker_threads(NETWORK_THREADS)
        .enable_all()
        .build()
        .map_err(|e| Failure::case(format_args!("error: no threads for the network: {e}")))?;
    let address = SocketAddr::new(args.bind, args.port);
    let listener = runtime.block_on(async { listen(address) }).map_err(|e| {
        Failure::case(format_args!("error: cannot listen on {address}: {e} (another --port?)"))
    })?;
    let address = listener.local_addr().unwrap_or(address);
    let wires = wires(args, &hub, &runtime)?;
    let (links, recording) = (engine.links(), engine.recording().display().to_string());
    // Dropped when the thread ends, be it by a mistake of ours: there is nothing to serve then.
    let (alive, ended) = tokio::sync::oneshot::channel::<()>();
    let simulation = std::thread::Builder::new()
        .name("simulation".into())
        .spawn(move || {
            engine.run(&told);
            drop(alive);
        })
        .map_err(|e| Failure::case(format_args!("error: no thread for the simulation: {e}")))?;
    let door = Door { remote, names: args.host.clone() };
    let site = Arc::new(Site::new(Arc::clone(&hub), page, door));
    let interrupted = interrupt::heard()
        .map_err(|e| Failure::case(format_args!("error: Ctrl-C cannot be heard: {e}")))?;
    say(&greeting(address, &links, &wires, &recording))?;
    runtime.block_on(async {
        tokio::select! {
            () = http::serve(listener, site) => {}
            _ = interrupted => {}
            _ = ended => {}
        }
    });
    hub.tell_engine(Told::Stop);
    if simulation.join().is_err() {
        return Err(Failure::case("error: the simulation's thread panicked: see above"));
    }
    say(&format!("recorded: {recording}\n"))
}

/// Starts what speaks to chart programs; a line for the user about each.
fn wires(args: &ServeArgs, hub: &Arc<Hub>, runtime: &Runtime) -> Result<String, Failure> {
    let mut told = String::new();
    let cannot = |what: String| move |e| Failure::case(format_args!("error: {what}: {e}"));
    if let Some(port) = args.nmea_tcp {
        let at = SocketAddr::new(args.bind, port);
        let listener = runtime
            .block_on(TcpListener::bind(at))
            .map_err(cannot(format!("cannot listen for chart programs on {at}")))?;
        let at = listener.local_addr().unwrap_or(at);
        told += &format!("NMEA 0183 and AIS over TCP on {at}\n");
        runtime.spawn(wire::tcp(listener, Arc::clone(hub)));
    }
    if let Some(to) = args.nmea_udp {
        let from = SocketAddr::new(if to.is_ipv4() { ANY_4 } else { ANY_6 }, 0);
        let socket = runtime
            .block_on(UdpSocket::bind(from))
            .map_err(cannot(format!("cannot send to {to}")))?;
        told += &format!("NMEA 0183 and AIS over UDP to {to}\n");
        runtime.spawn(wire::udp(socket, to, Arc::clone(hub)));
    }
    Ok(told)
}

/// A socket that listens. What it accepts holds little back: who reads slowly shall not read of long ago.
fn listen(address: SocketAddr) -> std::io::Result<TcpListener> {
    let socket = if address.is_ipv4() { TcpSocket::new_v4()? } else { TcpSocket::new_v6()? };
    // Elsewhere than on Windows it means that the port of a server that has just ended is free.
    #[cfg(not(windows))]
    socket.set_reuseaddr(true)?;
    socket.set_send_buffer_size(SEND_BUFFER)?;
    socket.bind(address)?;
    socket.listen(BACKLOG)
}

/// What the user is told when the server is there.
fn greeting(address: SocketAddr, links: &[Link], wires: &str, recording: &str) -> String {
    // Every address of this machine is no address to go to.
    let shown = match address.ip() {
        IpAddr::V4(ip) if ip.is_unspecified() => format!("localhost:{}", address.port()),
        IpAddr::V6(ip) if ip.is_unspecified() => format!("localhost:{}", address.port()),
        _ => address.to_string(),
    };
    let name = |role: &Role| match role {
        Role::Instructor => "instructor".to_owned(),
        Role::Pilot => "pilot".to_owned(),
        Role::Tugmaster { tug } => format!("master of {tug}"),
        Role::Observer => "observer".to_owned(),
    };
    let width = links.iter().map(|link| name(&link.role).len()).max().unwrap_or(0);
    let mut text = format!(
        "fenderline is on http://{shown} (Ctrl-C ends it, once more at once). Open one of these:\n"
    );
    for Link { role, path } in links {
        text += &format!("  {:width$}  http://{shown}{path}\n", name(role));
    }
    text + wires + &format!("Who has a link has its role. Recorded to {recording}\n")
}

/// Plays a recorded session again and holds every recorded state against it.
///
/// # Errors
/// A file that is no recording or a damaged one; a session that does not come to the same bits.
pub(crate) fn replay(args: &ReplayArgs) -> Result<(), Failure> {
    let name = args.session.display();
    let file = saved::open(&args.session)
        .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
    let file = file
        .ok_or_else(|| Failure::input(format_args!("error: {name}: it is no recorded session")))?;
    let mut bar = None;
    let played = saved::play(file, &mut |way| {
        show(&mut bar, way);
        Ok(())
    });
    drop(bar);
    let Played { session, same, outline, .. } = played.map_err(|why| match why {
        Unplayed::Differs(error) => Failure::case(format_args!("error: {name}, {error}")),
        other => Failure::input(format_args!("error: {name}, {other}")),
    })?;
    let whole = match saved::told_of_end(outline.ending) {
        None => "whole",
        Some(told) => {
            tell(&format!("notice: {name}: {told}"));
            "without its end"
        }
    };
    say(&format!(
        "{}: {} branches, {} ticks, {whole}; the same bits in all {same} recorded states\n",
        session.title(),
        outline.branches,
        outline.ticks,
    ))
}

/// Shows on the terminal how far a replay is.
fn show(bar: &mut Option<Progress>, way: Way) {
    if let Way::Plays(done, of) = way {
        bar.get_or_insert_with(|| Progress::new(of)).advance(done);
    }
}
