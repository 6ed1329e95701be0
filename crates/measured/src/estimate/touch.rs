//! The state of the ship at the first touch.

use fenderline_contact::number::{bounded, greater, lesser};

use super::Uncertain;
use super::channels::{Channels, Source};
use super::find::Way;
use super::parabola::Parabola;
use super::state::{motion_at, time_of_gap};
use crate::flag::Flag;
use crate::geometry::{BerthAxes, Motion};

/// Length of time through which parabolas are laid if the mapping gives none (s): a compromise between the scatter of
/// 1 cm lasers, which needs 20 s, and the changes of speed in the last minute.
const USUAL_S: f64 = 30.0;
/// The usual length grows until it holds this number of rows, up to [`LONGEST_S`].
const WANTED_ROWS: f64 = 12.0;
/// Longest length of time without a mapping's (s).
const LONGEST_S: f64 = 120.0;
/// A ship touches the edge of a face, or the whole face at once: the place of the contact has at least a deviation of
/// this share of the width of the face.
const FACE_SHARE: f64 = 0.05;
/// Places of the two places of the contact in [`Values`].
const FORWARD: usize = 3;
const ALONG: usize = 4;
/// Largest number of rounds in which the time of the touch is found.
const ROUNDS: usize = 12;

/// The state of a ship at her first touch of a fender, by the measurement.
#[derive(Clone, Debug, PartialEq)]
pub struct Touch {
    /// Time of the touch (s), on the log's clock after jumps were mended.
    pub t_s: f64,
    /// Standard deviation of the time of the touch (s).
    pub t_sd_s: f64,
    /// Speed of the point of contact towards the quay, square to it (m/s).
    pub speed_mps: Uncertain,
    /// Angle between ship and quay, positive with the bow towards the quay (rad).
    pub angle_rad: Uncertain,
    /// Rate of turn, positive to starboard (rad/s).
    pub turn_radps: Uncertain,
    /// Place of the contact forward of the ship's centre of gravity (m).
    pub forward_m: Uncertain,
    /// Place of the contact along the quay from the middle of the fenders (m).
    pub along_m: Uncertain,
    /// Speed of the centre of gravity along the quay, positive ahead (m/s).
    pub ahead_mps: Uncertain,
    /// Speed of the centre of gravity towards the quay (m/s).
    pub centre_mps: Uncertain,
    /// Index of the first fender in the set-up's fenders.
    pub fender: usize,
    /// Lie and rates.
    pub motion: Motion,
    /// Length of time through which the parabolas are laid (s).
    pub bandwidth_s: f64,
    /// Fewest readings of a channel in that time.
    pub readings: usize,
    /// Readings that were left out because they lie far from the others.
    pub left_out: usize,
}

/// What is computed from parabolas.
#[derive(Clone, Copy, Debug)]
struct Values {
    t_s: f64,
    /// speed, angle, turn, forward, along, ahead, centre
    of: [f64; 7],
    fender: usize,
    motion: Motion,
}

fn values(
    channels: &Channels,
    axes: &BerthAxes,
    of: &[Parabola; 3],
    from_s: f64,
    reach_s: f64,
) -> Option<Values> {
    let (t_s, nearest) = time_of_gap(channels, axes, of, from_s, reach_s, 0.0)?;
    let motion = motion_at(channels, axes, of, t_s)?;
    let (forward_m, speed_mps) = axes.at_ship(&motion, [nearest.along_m, nearest.off_m]);
    Some(Values {
        t_s,
        of: [
            speed_mps,
            motion.lie.angle_rad,
            axes.rate_of_turn(motion.rates[2]),
            forward_m,
            nearest.along_m,
            motion.rates[0],
            -motion.rates[1],
        ],
        fender: nearest.fender,
        motion,
    })
}

/// The length of time before the touch whose readings are used (s).
pub(crate) fn bandwidth_s(channels: &Channels, given_s: Option<f64>) -> f64 {
    given_s.unwrap_or_else(|| bounded(WANTED_ROWS * channels.usual_step_s(), USUAL_S, LONGEST_S))
}

/// The state at the touch of a way, and flags of its quality.
///
/// # Errors
/// Says why the readings do not give the state.
pub(crate) fn touch(
    way: &Way,
    axes: &BerthAxes,
    given_s: Option<f64>,
) -> Result<(Touch, Vec<Flag>, [Parabola; 3]), String> {
    let channels = &way.channels;
    let bandwidth_s = bandwidth_s(channels, given_s);
    let few = || {
        format!("there are too few readings of each sensor in the {bandwidth_s} s before the touch")
    };
    let no_touch = || "the readings before the touch do not lead to a fender".to_owned();
    let first_s = channels.t_s[way.touch];
    let mut t_s = first_s;
    let mut fit = None;
    for _ in 0..ROUNDS {
        // No reading after the touch: the fender has slowed the ship by then.
        let to_s = lesser(t_s, first_s);
        let of = channels.parabolas(to_s - bandwidth_s, to_s, t_s).ok_or_else(few)?;
        let own = values(channels, axes, &of, t_s, 0.5 * bandwidth_s).ok_or_else(no_touch)?;
        let is_settled = (own.t_s - t_s).abs() < 1e-3;
        let next_s = bounded(own.t_s, first_s - bandwidth_s, first_s + bandwidth_s);
        fit = Some((of, own));
        if is_settled {
            break;
        }
        t_s = next_s;
    }
    let (of, own) = fit.ok_or_else(no_touch)?;
    if own.of[0] <= 0.0 {
        return Err("the ship does not come nearer before the touch".to_owned());
    }
    let mut sd = deviations(channels, axes, &of, &own, bandwidth_s);
    let face_sd_m = FACE_SHARE * axes.face_width_m(own.fender);
    for place in [FORWARD, ALONG] {
        sd[place] = libm::hypot(sd[place], face_sd_m);
    }
    let value = |index: usize| Uncertain { value: own.of[index], sd: sd[index] };
    let measured = of.iter().filter(|parabola| parabola.count < usize::MAX);
    let readings = measured.clone().map(|parabola| parabola.count).min().unwrap_or(0);
    let left_out = measured.map(|parabola| parabola.left_out).sum();
    let touch = Touch {
        t_s: own.t_s,
        t_sd_s: sd[7],
        speed_mps: value(0),
        angle_rad: value(1),
        turn_radps: value(2),
        forward_m: value(FORWARD),
        along_m: value(ALONG),
        ahead_mps: value(5),
        centre_mps: value(6),
        fender: own.fender,
        motion: own.motion,
        bandwidth_s,
        readings,
        left_out,
    };
    let flags = flags(way, &touch, &of);
    Ok((touch, flags, of))
}

/// Standard deviations of all values and of the time, to first order: each direction of each parabola's uncertainty is
/// gone both ways.
fn deviations(
    channels: &Channels,
    axes: &BerthAxes,
    of: &[Parabola; 3],
    own: &Values,
    bandwidth_s: f64,
) -> [f64; 8] {
    let mut variances = [0.0; 8];
    for channel in 0..3 {
        for direction in of[channel].directions() {
            if direction == [0.0; 3] {
                continue;
            }
            let gone = |sign: f64| {
                let mut moved = *of;
                moved[channel] = of[channel].moved(direction.map(|by| sign * by));
                values(channels, axes, &moved, own.t_s, bandwidth_s)
            };
            let (low, high) = (gone(-1.0), gone(1.0));
            let all = |of: &Values| {
                let mut all = [of.t_s; 8];
                all[..7].copy_from_slice(&of.of);
                all
            };
            let difference = match (low, high) {
                (Some(low), Some(high)) => pair(all(&low), all(&high), 0.5),
                (None, Some(other)) | (Some(other), None) => pair(all(own), all(&other), 1.0),
                (None, None) => [0.0; 8],
            };
            for (variance, by) in variances.iter_mut().zip(difference) {
                *variance += by * by;
            }
        }
    }
    variances.map(libm::sqrt)
}

fn pair(one: [f64; 8], other: [f64; 8], share: f64) -> [f64; 8] {
    let mut by = [0.0; 8];
    for (own, (one, other)) in by.iter_mut().zip(one.iter().zip(other)) {
        *own = share * (other - one);
    }
    by
}

fn flags(way: &Way, touch: &Touch, of: &[Parabola; 3]) -> Vec<Flag> {
    let channels = &way.channels;
    let from_s = touch.t_s - touch.bandwidth_s;
    let mut flags = Vec::new();
    let within: Vec<usize> = (0..channels.t_s.len())
        .filter(|row| channels.t_s[*row] >= from_s && channels.t_s[*row] <= touch.t_s)
        .collect();
    let measured = if channels.assumed.is_some() { 2 } else { 3 };
    let mut longest_s: f64 = 0.0;
    let mut last_s: f64 = 0.0;
    for channel in 0..measured {
        let known = within.iter().filter(|row| channels.readings[**row][channel].is_finite());
        let times: Vec<f64> = known.map(|row| channels.t_s[*row]).collect();
        longest_s = times.windows(2).map(|two| two[1] - two[0]).fold(longest_s, greater);
        last_s = greater(last_s, times.last().map_or(touch.bandwidth_s, |t_s| touch.t_s - t_s));
    }
    if longest_s > touch.bandwidth_s / 3.0 {
        flags.push(Flag::Gap);
    }
    if last_s > touch.bandwidth_s / 4.0 {
        flags.push(Flag::Extrapolated);
    }
    if touch.left_out > 0 {
        flags.push(Flag::Outliers);
    }
    let lines = channels.lines[way.from]..=channels.lines[way.touch];
    if channels.jumps.iter().any(|line| lines.contains(line)) {
        flags.push(Flag::ClockJump);
    }
    let is_lost = |row: &usize| channels.readings[*row].iter().any(|reading| reading.is_nan());
    if within.iter().any(is_lost) {
        flags.push(Flag::HullLost);
    }
    let follows = |own: &Parabola| {
        own.count < usize::MAX && own.correlation > 2.0 / libm::sqrt(own.count as f64)
    };
    if of.iter().any(follows) {
        flags.push(Flag::Waves);
    }
    if way.zero_m.is_some() {
        flags.push(Flag::ZeroedAtRest);
    }
    if channels.assumed.is_some() && matches!(channels.source, Source::Sensors(_)) {
        flags.push(Flag::PlaceAssumed);
    }
    flags
}
