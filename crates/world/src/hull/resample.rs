//! Resamples outlines with different numbers of vertices at common stations.

use fenderline_contact::number::{greater, lesser};
use fenderline_contact::{Vec2, vec2};

use super::level::Level;

/// Stations that are nearer to each other than this share of the hull's length count as one station.
const SAME_STATION: f64 = 1e-9;

/// The error if a side of an outline turns back on its way from stern to bow.
pub(super) struct TurnsBack {
    /// Number of the outline.
    pub(super) level: usize,
}

/// A side of an outline from stern to bow: rows of station (0 at the stern, 1 at the bow) and offset to starboard (m),
/// with ascending stations.
type Side = Vec<(f64, f64)>;

/// Gives all outlines the same number of vertices: on each side, one vertex at each station of any outline. A station
/// is the share of the way from the outline's aftmost to its foremost point. The outlines must be in the positive
/// sense, from forward to starboard.
pub(super) fn at_common_stations(levels: &mut [Level]) -> Result<(), TurnsBack> {
    let mut sides = Vec::with_capacity(levels.len());
    for (level, of) in levels.iter().enumerate() {
        sides.push(sides_of(&of.vertices_m).ok_or(TurnsBack { level })?);
    }
    let mut stations: Vec<f64> =
        sides.iter().flat_map(|(_, both)| both.iter().flatten().map(|row| row.0)).collect();
    stations.sort_by(f64::total_cmp);
    stations.dedup_by(|next, before| *next - *before <= SAME_STATION);
    for (level, ([stern_m, bow_m], [port, starboard])) in levels.iter_mut().zip(&sides) {
        let point = |side: &Side, &station: &f64| {
            vec2(stern_m + (bow_m - stern_m) * station, offset_m(side, station))
        };
        // The outline runs forward along the port side and back along the starboard side.
        let forward = stations.iter().map(|station| point(port, station));
        let back = stations.iter().rev().map(|station| point(starboard, station));
        level.vertices_m = forward.chain(back).collect();
    }
    Ok(())
}

/// The after and forward ends of an outline (m), and its port and starboard sides; `None` if a side turns back.
fn sides_of(vertices_m: &[Vec2]) -> Option<([f64; 2], [Side; 2])> {
    let count = vertices_m.len();
    let xs = || vertices_m.iter().map(|v| v.x);
    let (stern_m, bow_m) =
        (xs().fold(f64::INFINITY, lesser), xs().fold(f64::NEG_INFINITY, greater));
    // In the positive sense the port side runs forward, and the starboard side aft.
    let is_at = |index: usize, end_m: f64| vertices_m[index % count].x == end_m;
    let last_at = |end_m: f64| {
        let start = (0..count).find(|&index| !is_at(index, end_m) && is_at(index + 1, end_m))? + 1;
        let after = (start..start + count).take_while(|&index| is_at(index, end_m)).count();
        Some([start % count, (start + after - 1) % count])
    };
    let ([starboard_end, port_start], [port_end, starboard_start]) =
        (last_at(stern_m)?, last_at(bow_m)?);
    let walk = |from: usize, to: usize| {
        let steps = (to + count - from) % count;
        let rows = (from..=from + steps).map(|index| vertices_m[index % count]);
        rows.map(|v| ((v.x - stern_m) / (bow_m - stern_m), v.y)).collect::<Side>()
    };
    let port = walk(port_start, port_end);
    let mut starboard = walk(starboard_start, starboard_end);
    starboard.reverse();
    let runs_forward = |side: &Side| side.windows(2).all(|two| two[0].0 < two[1].0);
    (runs_forward(&port) && runs_forward(&starboard))
        .then_some(([stern_m, bow_m], [port, starboard]))
}

/// The offset of a side at a station.
fn offset_m(side: &Side, station: f64) -> f64 {
    let next = side.partition_point(|row| row.0 < station);
    let Some(&(to, to_m)) = side.get(next) else { return side[side.len() - 1].1 };
    if next == 0 || to - station <= SAME_STATION {
        return to_m;
    }
    let (from, from_m) = side[next - 1];
    from_m + (to_m - from_m) * ((station - from) / (to - from))
}
