//! The track of a measured ship for a live session, which shows her beside the simulated ships.

use core::fmt;

use fenderline_contact::Vec2;
use fenderline_contact::number::lesser;

use crate::berthing::is_expected;
use crate::estimate::channels::Channels;
use crate::estimate::find::find;
use crate::estimate::touch::touch;
use crate::geometry::BerthAxes;
use crate::log::LogsRead;
use crate::mapping::Mapping;
use crate::remark::{Remark, Remarks};
use crate::stretch::stretches;

/// A track that stays farther than this from the berth and from the place of the scenario's ship is of another place (m).
const ANOTHER_PLACE_M: f64 = 5000.0;

/// Which track of a log is wanted, and how many points it may have.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct GhostWanted {
    /// Number of the berthing in the order of time, from 1; without a touch, of the stretch of the log.
    pub number: usize,
    /// Largest number of points, at least 2.
    pub most_points: usize,
}

/// The track of a measured ship.
#[derive(Clone, Debug, PartialEq)]
pub struct GhostTrack {
    /// Name of the ship; empty if the log names none.
    pub ship: String,
    /// Corners of the hull in the ship's axes (m).
    pub outline_m: Vec<Vec2>,
    /// Time from the first point (s), position of the centre of gravity north and east (m), and heading (rad).
    pub points: Vec<[f64; 4]>,
    /// Time from the first point to the first touch of a fender (s); `None` without a touch.
    pub touch_s: Option<f64>,
    /// How many berthings, or stretches without a touch, the log has.
    pub of: usize,
    /// What was guessed, mended and left out.
    pub remarks: Vec<Remark>,
}

/// Why a log has no track for a live session.
#[derive(Clone, Debug, PartialEq)]
pub enum GhostError {
    /// The log cannot be used; the remarks say why.
    NoTrack {
        /// Name of the file.
        file: String,
        /// The remark that says why.
        remark: Option<Remark>,
    },
    /// The log has fewer tracks than the wanted number.
    Number {
        /// Name of the file.
        file: String,
        /// The number that was wanted.
        wanted: usize,
        /// How many tracks there are.
        of: usize,
    },
    /// The track is of another place.
    AnotherPlace {
        /// Name of the file.
        file: String,
        /// The least distance of the track from berth and ship of the scenario (m).
        distance_m: f64,
    },
}

impl fmt::Display for GhostError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            GhostError::NoTrack { remark: Some(remark), .. } => remark.fmt(f),
            GhostError::NoTrack { file, remark: None } => {
                write!(f, "{file}: the log has no place and heading of a ship")
            }
            GhostError::Number { file, wanted, of } => write!(
                f,
                "{file}: number {wanted} is wanted, but the log has {}",
                fenderline_report::plot::counted(*of as u64, "track", "tracks")
            ),
            GhostError::AnotherPlace { file, distance_m } => write!(
                f,
                "{file}: the track is of another place: it stays {} km away from berth and ship of the scenario",
                fenderline_report::plot::fixed(distance_m / 1000.0, 1)
            ),
        }
    }
}

impl core::error::Error for GhostError {}

/// A track before its points are thinned out.
struct Candidate {
    ship: String,
    from_s: f64,
    points: Vec<[f64; 4]>,
    touch_s: Option<f64>,
}

/// The track of a log for a live session. Readings are taken as they are; a track that lies alongside afterwards is moved
/// as for `fenderline berthings`.
///
/// # Errors
/// [`GhostError`].
pub fn ghost(
    read: LogsRead,
    file: &str,
    mapping: &Mapping,
    axes: &BerthAxes,
    wanted: GhostWanted,
) -> Result<GhostTrack, GhostError> {
    let mut own = Remarks::of(file);
    let mut all: Vec<Candidate> = Vec::new();
    for log in &read.logs {
        if log.mmsi.is_some() && !is_expected(log, mapping, axes) {
            continue;
        }
        for stretch in stretches(log, &mut own) {
            let name = match log.names[stretch.name].as_str() {
                "" => log.ship.clone(),
                name => name.to_owned(),
            };
            all.extend(of_stretch(
                &Channels::of(log, &stretch, axes, mapping),
                mapping,
                axes,
                &name,
            ));
        }
    }
    let remarks: Vec<Remark> = read.remarks.into_iter().chain(own.all).collect();
    if all.iter().any(|track| track.touch_s.is_some()) {
        all.retain(|track| track.touch_s.is_some());
    }
    all.sort_by(|one, other| one.from_s.total_cmp(&other.from_s));
    let of = all.len();
    if of == 0 {
        let worst = remarks.iter().max_by_key(|remark| remark.weight).cloned();
        return Err(GhostError::NoTrack { file: file.to_owned(), remark: worst });
    }
    if wanted.number == 0 || wanted.number > of {
        let (file, wanted) = (file.to_owned(), wanted.number);
        return Err(GhostError::Number { file, wanted, of });
    }
    let track = all.swap_remove(wanted.number - 1);
    let places =
        [axes.from_axes([0.0, 0.0]), axes.from_axes([axes.start.along_m, axes.start.off_m])];
    let away_m = |point: &[f64; 4]| {
        let off = places.map(|at| libm::hypot(point[1] - at.x, point[2] - at.y));
        lesser(off[0], off[1])
    };
    let distance_m = track.points.iter().map(away_m).fold(f64::INFINITY, lesser);
    if distance_m > ANOTHER_PLACE_M {
        return Err(GhostError::AnotherPlace { file: file.to_owned(), distance_m });
    }
    Ok(GhostTrack {
        ship: track.ship,
        outline_m: axes.hull().to_vec(),
        points: thinned(&track.points, wanted.most_points),
        touch_s: track.touch_s,
        of,
        remarks,
    })
}

/// The ways of a stretch to touches, each until the next way begins; the whole stretch if there is no touch.
fn of_stretch(
    channels: &Channels,
    mapping: &Mapping,
    axes: &BerthAxes,
    ship: &str,
) -> Vec<Candidate> {
    let found = find(channels, axes);
    let candidate = |own: &Channels, from: usize, end: usize, touch_s: Option<f64>| {
        let points = points(own, axes, from, end);
        let from_s = points.first()?[0];
        let since = |point: &[f64; 4]| [point[0] - from_s, point[1], point[2], point[3]];
        Some(Candidate {
            ship: ship.to_owned(),
            from_s,
            points: points.iter().map(since).collect(),
            touch_s: touch_s.map(|t_s| t_s - from_s),
        })
    };
    if found.ways.is_empty() {
        return candidate(channels, 0, channels.t_s.len(), None).into_iter().collect();
    }
    let ways = found.ways.iter().enumerate().filter_map(|(index, way)| {
        let end = found.ways.get(index + 1).map_or(channels.t_s.len(), |next| next.from);
        let at_row_s = way.channels.t_s[way.touch];
        let touch_s = touch(way, axes, mapping.bandwidth_s).map_or(at_row_s, |own| own.0.t_s);
        candidate(&way.channels, way.from, end, Some(touch_s))
    });
    ways.collect()
}

/// Time, position and heading of the rows in which all readings are known, in the order of time.
fn points(channels: &Channels, axes: &BerthAxes, from: usize, end: usize) -> Vec<[f64; 4]> {
    let mut all: Vec<[f64; 4]> = Vec::new();
    for row in from..end {
        let Some(lie) = channels.lie(axes, channels.readings[row]) else { continue };
        let at_m = axes.from_axes([lie.along_m, lie.off_m]);
        let t_s = channels.t_s[row];
        if all.last().is_none_or(|last| t_s > last[0]) {
            all.push([t_s, at_m.x, at_m.y, axes.heading(lie.angle_rad)]);
        }
    }
    all
}

/// Every n-th point and the last, so that there are no more than `most`.
fn thinned(points: &[[f64; 4]], most: usize) -> Vec<[f64; 4]> {
    let every = points.len().div_ceil(most.max(2) - 1).max(1);
    let mut all: Vec<[f64; 4]> = points.iter().copied().step_by(every).collect();
    if let Some(last) = points.last().filter(|last| all.last() != Some(*last)) {
        all.push(*last);
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_long_track_is_thinned_and_keeps_its_ends() {
        for count in [1_usize, 2, 3, 1999, 2000, 2001, 4000, 4001, 86_400] {
            let points: Vec<[f64; 4]> = (0..count).map(|t| [t as f64, 0.0, 0.0, 0.0]).collect();
            let few = thinned(&points, 2000);
            assert!(few.len() <= 2000, "{count}: {}", few.len());
            assert_eq!((few.first(), few.last()), (points.first(), points.last()));
            assert!(few.len() == count || few.len() > 900, "{count}: {}", few.len());
        }
    }
}
