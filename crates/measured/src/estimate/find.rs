//! Finds the rows at which a ship first touches a fender.

use fenderline_contact::number::greater;

use super::channels::{Channels, Source};
use crate::geometry::BerthAxes;

/// A ship that comes to the fenders must have been farther than this from them (m).
const ARMED_M: f64 = 1.0;
/// After a touch, a ship that has been farther than this from the fenders comes again (m).
const LEFT_M: f64 = 5.0;
/// A track with the hull nearer than this may lie alongside (m).
const NEAR_M: f64 = 20.0;
/// Largest constant error of a track square to the quay that is taken out (m).
const MOST_ZERO_M: f64 = 15.0;
/// A ship lies at rest if the medians of two lengths of time that follow each other differ by less than this (m).
const REST_M: f64 = 0.3;
/// She is at the fenders from this number of deviations on.
const SCATTER: f64 = 2.5;
/// She must lie at rest for this long (s).
const REST_S: f64 = 180.0;
/// Fewest rows at rest.
const REST_ROWS: usize = 9;
/// A track whose rest is nearer than this to the fenders is not moved (m).
const LEAST_ZERO_M: f64 = 0.1;
/// Standard deviation of the constant error that is left after a track was moved (m): fenders are compressed a little.
pub(crate) const ZEROED_SD_M: f64 = 0.15;

/// A ship's way to her first touch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Way {
    /// The channels, which are moved by `zero_m` for a track.
    pub(crate) channels: Channels,
    /// First row of the way.
    pub(crate) from: usize,
    /// First row at or behind the faces of the fenders.
    pub(crate) touch: usize,
    /// By how much the track was moved away from the water (m).
    pub(crate) zero_m: Option<f64>,
}

/// What was found in a stretch.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Found {
    pub(crate) ways: Vec<Way>,
    /// Row and distance of the nearest approach (m), if the hull was ever abreast of a fender.
    pub(crate) nearest: Option<(usize, f64)>,
    /// Whether the ship lies at the fenders in the first rows.
    pub(crate) is_alongside_at_start: bool,
}

/// The touches in the channels of a stretch.
pub(crate) fn find(channels: &Channels, axes: &BerthAxes) -> Found {
    let gaps = gaps(channels, axes);
    let known = gaps.iter().enumerate().filter(|(_, gap)| gap.is_finite());
    let nearest = known.map(|(row, gap)| (row, *gap)).min_by(|a, b| a.1.total_cmp(&b.1));
    let first = gaps.iter().find(|gap| gap.is_finite());
    let is_alongside_at_start = first.is_some_and(|gap| *gap <= ARMED_M);
    let ways = match channels.source {
        Source::Sensors(_) => touches(&gaps, 0, gaps.len(), 0.0)
            .into_iter()
            .map(|(from, touch)| Way { channels: channels.clone(), from, touch, zero_m: None })
            .collect(),
        Source::Antenna(_) => ways_of_track(channels, &gaps),
    };
    Found { ways, nearest, is_alongside_at_start }
}

/// Distance of the hull from the nearest fender for each row, smoothed by the median of five rows; NaN if not known.
fn gaps(channels: &Channels, axes: &BerthAxes) -> Vec<f64> {
    let raw: Vec<f64> = channels
        .readings
        .iter()
        .map(|readings| {
            let lie = channels.lie(axes, *readings);
            lie.and_then(|lie| axes.nearest(&lie)).map_or(f64::NAN, |nearest| nearest.gap_m)
        })
        .collect();
    let smooth = |row: usize| {
        let around = &raw[row.saturating_sub(2)..raw.len().min(row + 3)];
        median(around.iter().copied().filter(|gap| gap.is_finite()).collect())
    };
    (0..raw.len()).map(|row| if raw[row].is_finite() { smooth(row) } else { f64::NAN }).collect()
}

/// The median; NaN of nothing.
pub(crate) fn median(mut values: Vec<f64>) -> f64 {
    if values.is_empty() {
        return f64::NAN;
    }
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// First rows of the ways and rows of the touches between two rows. A ship is at the fenders from the distance
/// `level_m` on.
fn touches(gaps: &[f64], from: usize, to: usize, level_m: f64) -> Vec<(usize, usize)> {
    let mut all = Vec::new();
    let (mut start, mut is_armed, mut has_touched) = (from, false, false);
    for (row, gap) in gaps.iter().enumerate().take(to).skip(from) {
        if *gap > if has_touched { LEFT_M } else { ARMED_M } {
            if !is_armed && has_touched {
                start = row;
            }
            is_armed = true;
        }
        if is_armed && *gap <= level_m {
            all.push((start, row));
            (is_armed, has_touched) = (false, true);
        }
    }
    all
}

/// The ways of a track. Where the ship lies at rest near the fenders after she came, the track is moved so that she
/// lies at them.
fn ways_of_track(channels: &Channels, gaps: &[f64]) -> Vec<Way> {
    let mut ways = Vec::new();
    let mut from = 0;
    let mut row = 0;
    while row < gaps.len() {
        if gaps[row].is_nan() || gaps[row] >= NEAR_M {
            row += 1;
            continue;
        }
        let is_left = |gap: &f64| *gap >= NEAR_M;
        let end = gaps[row..].iter().position(is_left).map_or(gaps.len(), |count| row + count);
        let rest = rest(&gaps[row..end], &channels.t_s[row..end]);
        let rest = rest.filter(|rest| rest.at_m.abs() > LEAST_ZERO_M);
        let zero_m = rest.map(|rest| rest.at_m);
        let shift_m = zero_m.unwrap_or(0.0);
        // Where a track scatters, nobody sees when she reaches the place of her rest: the parabola ends before, and
        // goes on to the fender.
        let level_m = rest.map_or(0.0, |rest| LEAST_ZERO_M + SCATTER * rest.deviation_m);
        let moved: Vec<f64> = gaps.iter().map(|gap| gap - shift_m).collect();
        for (start, touch) in touches(&moved, from, end, level_m) {
            let mut own = channels.clone();
            for readings in &mut own.readings {
                readings[1] -= shift_m;
            }
            if zero_m.is_some() {
                own.constant_sd[1] = fenderline_contact::number::lesser(
                    greater(ZEROED_SD_M, own.steps[1]),
                    greater(own.constant_sd[1], ZEROED_SD_M),
                );
            }
            ways.push(Way { channels: own, from: start, touch, zero_m });
        }
        (from, row) = (end, end);
    }
    ways
}

/// Where a ship rests.
#[derive(Clone, Copy, Debug)]
struct Rest {
    /// Distance from the fenders (m).
    at_m: f64,
    /// Scatter of that distance (m).
    deviation_m: f64,
}

/// Where a ship first rests in some rows; `None` if she does not rest there. The errors of a track wander, so the rest
/// soon after she came tells more than a later one.
fn rest(gaps: &[f64], t_s: &[f64]) -> Option<Rest> {
    let is_known = |own: &(&f64, &f64)| own.0.is_finite();
    let (known, times): (Vec<f64>, Vec<f64>) = gaps.iter().zip(t_s).filter(is_known).unzip();
    let mut from = 0;
    while from < known.len() {
        let rows = |since_s: f64| times.partition_point(|t_s| *t_s < times[from] + since_s) - from;
        let half = rows(0.5 * REST_S).max(REST_ROWS);
        let whole = rows(REST_S).max(2 * REST_ROWS);
        if from + whole >= known.len() {
            return None;
        }
        let before = median(known[from..from + half].to_vec());
        let at_m = median(known[from + half..from + whole].to_vec());
        if (before - at_m).abs() < REST_M && at_m.abs() < MOST_ZERO_M {
            let off = known[from + half..from + whole].iter().map(|gap| (gap - at_m).abs());
            return Some(Rest { at_m, deviation_m: 1.4826 * median(off.collect()) });
        }
        from += (half / 4).max(1);
    }
    None
}
