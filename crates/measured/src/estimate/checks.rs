//! Compares the distances of a docking log with the log's own speeds and angle: feet for metres, sensors swapped.

use super::channels::{Channels, Source};
use super::find::Way;
use crate::flag::Flag;
use crate::log::Log;
use crate::mapping::Mapping;

/// The comparison begins this long before the touch (s).
const BEFORE_S: f64 = 240.0;
/// The distances must change by this much to tell something (m).
const LEAST_WAY_M: f64 = 0.5;
/// The angle must be this large to tell something (rad).
const LEAST_ANGLE_RAD: f64 = 0.006;
/// Feet in a metre.
const FEET: f64 = 1.0 / 0.3048;

/// Ways that the distances and the log's speeds tell, over the same times (m).
#[derive(Clone, Copy, Debug, Default)]
struct Told {
    by_distance_m: [f64; 2],
    /// By the sensor's own speed, and by the other sensor's speed.
    by_speed_m: [[f64; 2]; 2],
}

/// Flags of the comparison.
///
/// # Errors
/// Line and reason why the readings cannot be what the mapping says.
pub(crate) fn check(way: &Way, log: &Log, mapping: &Mapping) -> Result<Vec<Flag>, (usize, String)> {
    let Source::Sensors(places_m) = way.channels.source else { return Ok(Vec::new()) };
    let line = way.channels.lines[way.from];
    let mut flags = Vec::new();
    let told = told(&way.channels, log, way.touch);
    let ratio = |sensor: usize, of: usize| {
        let by_m = told.by_speed_m[sensor][of];
        let is_known =
            told.by_distance_m[sensor].abs() > LEAST_WAY_M && by_m.abs() > 0.1 * LEAST_WAY_M;
        is_known.then(|| (told.by_distance_m[sensor] / by_m).abs())
    };
    let near = |ratio: Option<f64>, wanted: f64, within: f64| {
        ratio.is_some_and(|ratio| (ratio / wanted - 1.0).abs() < within)
    };
    let own = [ratio(0, 0), ratio(1, 1)];
    let other = [ratio(0, 1), ratio(1, 0)];
    if own.iter().all(|own| near(*own, FEET, 0.06)) {
        let why = "the distances change 3.28 times as fast as the speeds say: distances in feet, or speeds in another unit; give the mapping's [units]";
        return Err((line, why.to_owned()));
    }
    if own.iter().all(|own| near(*own, 1.0 / FEET, 0.06)) {
        let why = "the distances change 0.305 times as fast as the speeds say: speeds in feet a second; give the mapping's [units]";
        return Err((line, why.to_owned()));
    }
    let is_off = own.iter().all(|own| own.is_some() && !near(*own, 1.0, 0.12));
    if is_off && other.iter().all(|other| near(*other, 1.0, 0.1)) {
        let why = "the sensors are swapped: the speed at the bow fits the distance at the stern, and the other way round";
        return Err((line, why.to_owned()));
    }
    if own.iter().any(|own| own.is_some() && !near(*own, 1.0, 0.1)) {
        flags.push(Flag::SpeedsDiffer);
    }
    let Some((by_distance_rad, by_log_rad)) = angles(way, log, places_m) else { return Ok(flags) };
    if by_distance_rad.abs() < LEAST_ANGLE_RAD {
        return Ok(flags);
    }
    let sign = if mapping.is_bow_in == Some(false) { -1.0 } else { 1.0 };
    let ratio = sign * by_log_rad / by_distance_rad;
    if (ratio.abs() * FEET - 1.0).abs() < 0.15 {
        let why = "the angle by the distances is 3.28 times the log's own angle: distances in feet; give the mapping's [units]";
        return Err((line, why.to_owned()));
    }
    if (ratio + 1.0).abs() < 0.4 {
        if mapping.is_bow_in.is_some() {
            let why = "the sensors are swapped: the log's own angle has the opposite sign of the distances";
            return Err((line, why.to_owned()));
        }
        flags.push(Flag::AngleOpposite);
    }
    Ok(flags)
}

fn told(channels: &Channels, log: &Log, touch: usize) -> Told {
    let mut told = Told::default();
    let usual_s = channels.usual_step_s();
    let speeds = |row: usize| log.rows[channels.rows[row]].speeds_mps;
    for sensor in 0..2 {
        let is_known = |row: &usize| {
            channels.readings[*row][sensor].is_finite()
                && speeds(*row).iter().all(|speed| speed.is_finite())
        };
        let rows: Vec<usize> = (0..=touch)
            .filter(|row| channels.t_s[*row] > channels.t_s[touch] - BEFORE_S)
            .filter(is_known)
            .collect();
        for two in rows.windows(2) {
            let step_s = channels.t_s[two[1]] - channels.t_s[two[0]];
            if step_s > 5.0 * usual_s {
                continue;
            }
            told.by_distance_m[sensor] +=
                channels.readings[two[0]][sensor] - channels.readings[two[1]][sensor];
            let (one, next) = (speeds(two[0]), speeds(two[1]));
            for (of, by_m) in told.by_speed_m[sensor].iter_mut().enumerate() {
                *by_m += 0.5 * (one[of] + next[of]) * step_s;
            }
        }
    }
    told
}

/// The median angle by the distances and by the log (rad).
fn angles(way: &Way, log: &Log, places_m: [f64; 2]) -> Option<(f64, f64)> {
    let channels = &way.channels;
    let from_s = channels.t_s[way.touch] - BEFORE_S;
    let rows = (0..=way.touch).filter(|row| channels.t_s[*row] > from_s);
    let (mut by_distance, mut by_log) = (Vec::new(), Vec::new());
    for row in rows {
        let [bow_m, stern_m, _] = channels.readings[row];
        let own_rad = log.rows[channels.rows[row]].angle_rad;
        if bow_m.is_finite() && stern_m.is_finite() && own_rad.is_finite() {
            by_distance.push(libm::atan((stern_m - bow_m) / (places_m[0] - places_m[1])));
            by_log.push(own_rad);
        }
    }
    if by_log.is_empty() {
        return None;
    }
    Some((super::find::median(by_distance), super::find::median(by_log)))
}
