//! `fenderline serve` and `fenderline replay`: the command line of the live server.

use fenderline_serve::{Options, Replayed, ServeError, Server};

use crate::cli::{ReplayArgs, ServeArgs};
use crate::debrief::debrief;
use crate::engine_dump;
use crate::failure::Failure;
use crate::ghost::ghost;
use crate::interrupt::stop_on_interrupt;
use crate::progress::with_progress;
use crate::terminal::{notice, remark, say};

/// Runs the live server until it is interrupted.
///
/// # Errors
/// Fails if a scenario, a measured track, an address or a web page cannot be used, or if the port is taken.
pub(crate) fn serve(args: &ServeArgs) -> Result<(), Failure> {
    let options = Options {
        scenario: args.scenario.clone(),
        set: args.set.clone(),
        ghost: ghost(args)?,
        bind: args.bind,
        port: args.port,
        allow_remote: args.allow_remote,
        host_names: args.host.clone(),
        page: args.page.clone(),
        gallery: args.gallery.clone(),
        sessions: args.sessions.clone(),
        is_paused: args.paused,
        nmea_tcp: args.nmea_tcp,
        nmea_udp: args.nmea_udp,
        nmea_steer: args.nmea_steer,
        origin: args.origin,
        report: debrief,
        notify: remark,
    };
    let server = with_progress(|progress| Server::start(&options, progress))?;
    let interrupted = stop_on_interrupt()
        .map_err(|e| Failure::case(format_args!("error: cannot listen for Ctrl-C: {e}")))?;
    say(server.greeting())?;
    for recording in server.run(interrupted)? {
        say(&format!("recorded: {}\n", recording.display()))?;
    }
    Ok(())
}

/// Replays a recorded session and compares every recorded state; or replays a dump of a contact engine.
///
/// # Errors
/// Fails if the file is not a recording or is damaged, or if the replay of the session differs in any bit.
pub(crate) fn replay(args: &ReplayArgs) -> Result<(), Failure> {
    if engine_dump::is_one(&args.session) {
        return engine_dump::replay(&args.session);
    }
    let replayed = with_progress(|progress| fenderline_serve::replay(&args.session, progress))?;
    let Replayed { session, branches, ticks, equal_states, incomplete } = replayed;
    let title = session.title();
    let whole = match incomplete {
        None => "whole",
        Some(what) => {
            notice(format_args!("{}: {what}", args.session.display()));
            "without its end"
        }
    };
    say(&format!(
        "{title}: {branches} branches, {ticks} ticks, {whole}; the same bits in all {equal_states} recorded states\n"
    ))
}

impl From<ServeError> for Failure {
    fn from(error: ServeError) -> Failure {
        match error {
            ServeError::Input(text) => Failure::Input(text),
            ServeError::Failed(text) => Failure::Case(text),
        }
    }
}
