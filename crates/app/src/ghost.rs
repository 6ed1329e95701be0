//! The measured ship that `fenderline serve --ghost` shows beside the simulated ships.

use std::path::Path;

use fenderline_live::{Cast, begins_recording};
use fenderline_measured::{
    BerthAxes, GhostTrack, GhostWanted, LogsRead, Mapping, Weight, ghost as track_of, read_log,
};
use fenderline_report::plot::{counted, fixed};
use fenderline_scenario::{Override, Scenario, read_text_of};
use fenderline_serve::Ghost;
use fenderline_sim::Setup;

use crate::berthings::{LARGEST_BYTES, mapping, origin};
use crate::cli::ServeArgs;
use crate::failure::Failure;
use crate::load::Source;
use crate::terminal::notice;

/// The measured ship on the clock of the session, if the command line names a log.
///
/// # Errors
/// Fails if the log, the mapping or the scenario cannot be used, if the log has no such berthing, if the track is of another
/// place, or if the track ends before the session begins.
pub(crate) fn ghost(args: &ServeArgs) -> Result<Option<Ghost>, Failure> {
    let Some(log) = &args.ghost.ghost else { return Ok(None) };
    let source = Source::read(&args.scenario).map_err(Failure::input)?;
    if begins_recording(source.text.as_bytes()) {
        return Err(Failure::input(format_args!(
            "error: {}: a recorded session keeps the measured track with which it began; leave out --ghost",
            args.scenario.display()
        )));
    }
    let mapping = mapping(args.ghost.ghost_mapping.as_deref())?;
    let set: Vec<Override> = args
        .set
        .iter()
        .map(|text| Override::parse(text))
        .collect::<Result<_, _>>()
        .map_err(Failure::input)?;
    let scenario = source.scenario(&set).map_err(Failure::input)?;
    let refused = |why: &dyn core::fmt::Display| {
        Failure::input(format_args!("error: {}: {why}", args.scenario.display()))
    };
    let earth = match (mapping.origin_rad, args.origin) {
        (None, Some(given)) => Some(given),
        _ => origin(&mapping, &scenario).map_err(|why| refused(&why))?,
    };
    let axes = axes(&scenario.setup, &mapping).map_err(|why| refused(&why))?;
    let file = log.display().to_string();
    let text = read_text_of(log, LARGEST_BYTES)
        .map_err(|why| Failure::input(format_args!("error: cannot read {why}")))?;
    let read = read_log(&text, &file, &mapping, earth.as_ref());
    let track = track(args, &file, &read, &mapping, &axes)?;
    let track = match own_scenario(&source, &set, &mapping, &track)? {
        None => track,
        Some(own) => {
            let axes = self::axes(&own.setup, &mapping).map_err(|why| refused(&why))?;
            self::track(args, &file, &read, &mapping, &axes)?
        }
    };
    for remark in &track.remarks {
        if remark.weight == Weight::Refused {
            notice(remark);
        }
    }
    placed(args, log, &scenario, track).map(Some)
}

/// The berth of the scenario, for the ship that the mapping names, the ship of `[berthing]`, or the pilot's own ship.
fn axes(setup: &Setup, mapping: &Mapping) -> Result<BerthAxes, String> {
    let ship = match (&mapping.ship, &setup.berthing) {
        (Some(name), _) => setup
            .bodies
            .iter()
            .position(|body| body.name == *name)
            .ok_or_else(|| format!("the scenario has no body `{name}`"))?,
        (None, Some(berthing)) => berthing.ship,
        (None, None) => {
            let own = Cast::of(setup).own.ok_or("the scenario has no vessel")?;
            setup.world.vessels[own].body
        }
    };
    BerthAxes::of_ship(setup, ship)
}

fn track(
    args: &ServeArgs,
    file: &str,
    read: &LogsRead,
    mapping: &Mapping,
    axes: &BerthAxes,
) -> Result<GhostTrack, Failure> {
    let wanted = GhostWanted { number: args.ghost.ghost_berthing, most_points: Ghost::MOST_POINTS };
    track_of(read.clone(), file, mapping, axes, wanted)
        .map_err(|why| Failure::input(format_args!("error: {why}")))
}

/// The scenario with the changes that the mapping gives for the ship of the track; `None` if there are none.
fn own_scenario(
    source: &Source,
    set: &[Override],
    mapping: &Mapping,
    track: &GhostTrack,
) -> Result<Option<Scenario>, Failure> {
    let changes = mapping.ship_called(&track.ship, None).map_or(&[][..], |(_, ship)| &ship.set);
    if changes.is_empty() {
        return Ok(None);
    }
    let all: Vec<Override> = set.iter().chain(changes).cloned().collect();
    source.scenario(&all).map(Some).map_err(Failure::input)
}

/// The track on the clock of the session.
fn placed(
    args: &ServeArgs,
    log: &Path,
    scenario: &Scenario,
    track: GhostTrack,
) -> Result<Ghost, Failure> {
    let name = log.display();
    let later_s = match (args.ghost.ghost_touch, track.touch_s) {
        (None, _) => 0.0,
        (Some(at_s), Some(touch_s)) if at_s.is_finite() => at_s - touch_s,
        (Some(at_s), Some(_)) => {
            return Err(Failure::input(format_args!("error: --ghost-touch {at_s}: not a time")));
        }
        (Some(_), None) => {
            return Err(Failure::input(format_args!(
                "error: {name}: the track does not touch a fender: leave out --ghost-touch"
            )));
        }
    };
    let points: Vec<[f64; 4]> = track
        .points
        .iter()
        .map(|[t_s, north_m, east_m, heading_rad]| [t_s + later_s, *north_m, *east_m, *heading_rad])
        .collect();
    let (first_s, last_s) = match (points.first(), points.last()) {
        (Some(first), Some(last)) => (first[0], last[0]),
        _ => (0.0, 0.0),
    };
    if last_s < 0.0 {
        return Err(Failure::input(format_args!(
            "error: {name}: with --ghost-touch, the track ends {} s before the session begins",
            fixed(-last_s, 0)
        )));
    }
    if first_s > scenario.setup.duration_s {
        notice(format_args!(
            "{name}: with --ghost-touch, the track begins {} s after the end of the scenario",
            fixed(first_s - scenario.setup.duration_s, 0)
        ));
    }
    if track.of > 1 {
        notice(format_args!(
            "{name}: number {} of {} is shown; --ghost-berthing N shows another",
            args.ghost.ghost_berthing,
            counted(track.of as u64, "berthing", "berthings")
        ));
    }
    Ok(Ghost {
        ship: track.ship,
        file: log.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        outline: track.outline_m.iter().map(|at| [at.x, at.y]).collect(),
        points,
        touch_s: track.touch_s.map(|touch_s| touch_s + later_s),
    })
}
