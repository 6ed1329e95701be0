//! The readings of a stretch as three channels over time, from which the lie of the ship follows.

use fenderline_contact::number::greater;
use fenderline_contact::{Vec2, vec2};

use super::parabola::Parabola;
use crate::geometry::{BerthAxes, Lie};
use crate::log::{Log, LogKind};
use crate::mapping::{Mapping, Sensor};
use crate::stretch::Stretch;

/// How the lie follows from the channels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Source {
    /// Distances of the hull at two places along the quay (m), and the place along the quay.
    Sensors([f64; 2]),
    /// Place along and off the quay of an antenna in the ship's axes (m), and the angle.
    Antenna(Vec2),
}

/// The readings of a ship's approach.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Channels {
    pub(crate) source: Source,
    /// Lines of the rows in the file.
    pub(crate) lines: Vec<usize>,
    /// Indices of the rows in the log.
    pub(crate) rows: Vec<usize>,
    /// Times (s), rising.
    pub(crate) t_s: Vec<f64>,
    /// Three readings for each row; NaN: missing.
    pub(crate) readings: Vec<[f64; 3]>,
    /// Steps in which the readings are written.
    pub(crate) steps: [f64; 3],
    /// A channel that is not measured: its value, and the standard deviations of value and slope.
    pub(crate) assumed: Option<(f64, f64, f64)>,
    /// Standard deviations of constant errors of the channels.
    pub(crate) constant_sd: [f64; 3],
    /// Lines after which the clock jumped.
    pub(crate) jumps: Vec<usize>,
}

/// A pause longer than this may be a jump of the clock (s).
const LEAST_JUMP_S: f64 = 3.0;

impl Channels {
    /// The channels of a stretch of a log.
    pub(crate) fn of(
        log: &Log,
        stretch: &Stretch,
        axes: &BerthAxes,
        mapping: &Mapping,
    ) -> Channels {
        let rows = stretch.rows.clone();
        let own = |index: &usize| &log.rows[*index];
        let lines = rows.iter().map(|index| own(index).line).collect();
        let t_s = rows.iter().map(|index| own(index).t_s).collect();
        let mut channels = match log.kind {
            LogKind::Docking => docking(log, &rows, axes, mapping),
            _ => track(log, &rows, axes, mapping),
        };
        (channels.lines, channels.t_s, channels.rows) = (lines, t_s, rows);
        channels.mend_clock();
        channels
    }

    /// The lie by three readings.
    pub(crate) fn lie(&self, axes: &BerthAxes, readings: [f64; 3]) -> Option<Lie> {
        if readings.iter().any(|reading| !reading.is_finite()) {
            return None;
        }
        match self.source {
            Source::Sensors(places_m) => {
                axes.lie_of(readings[2], places_m, [readings[0], readings[1]])
            }
            Source::Antenna(at) => {
                let turned = Lie { along_m: 0.0, off_m: 0.0, angle_rad: readings[2] };
                let [along_m, off_m] = axes.point(&turned, at);
                Some(Lie {
                    along_m: readings[0] - along_m,
                    off_m: readings[1] - off_m,
                    angle_rad: readings[2],
                })
            }
        }
    }

    /// A parabola for each channel through the readings from `from_s` to `to_s`, at the time `at_s`.
    pub(crate) fn parabolas(&self, from_s: f64, to_s: f64, at_s: f64) -> Option<[Parabola; 3]> {
        let one = |channel: usize| match self.assumed {
            Some((value, value_sd, slope_sd)) if channel == 2 => {
                let mut covariance = [[0.0; 3]; 3];
                covariance[0][0] = value_sd * value_sd;
                covariance[1][1] = slope_sd * slope_sd;
                Some(Parabola {
                    at_s,
                    of: [value, 0.0, 0.0],
                    covariance,
                    count: usize::MAX,
                    left_out: 0,
                    deviation: 0.0,
                    correlation: 0.0,
                })
            }
            _ => {
                let within = |t_s: &f64| (from_s..=to_s).contains(t_s);
                let readings: Vec<(f64, f64)> = self
                    .t_s
                    .iter()
                    .zip(&self.readings)
                    .filter(|(t_s, own)| within(t_s) && own[channel].is_finite())
                    .map(|(t_s, own)| (*t_s, own[channel]))
                    .collect();
                let mut fit = Parabola::through(&readings, at_s, self.steps[channel])?;
                // The deviation is itself estimated from few readings: the variance of Student's distribution.
                let free = (fit.count - 3) as f64;
                if free > 2.0 {
                    fit.covariance =
                        fit.covariance.map(|row| row.map(|own| own * free / (free - 2.0)));
                }
                fit.covariance[0][0] += self.constant_sd[channel] * self.constant_sd[channel];
                Some(fit)
            }
        };
        Some([one(0)?, one(1)?, one(2)?])
    }

    /// The usual time between rows (s).
    pub(crate) fn usual_step_s(&self) -> f64 {
        let mut steps: Vec<f64> =
            self.t_s.windows(2).map(|two| two[1] - two[0]).filter(|step| *step > 0.0).collect();
        if steps.is_empty() {
            return 1.0;
        }
        steps.sort_by(f64::total_cmp);
        steps[steps.len() / 2]
    }

    /// A reading that tells how far off the ship is: the mean distance, or the distance of the antenna.
    fn off(&self, row: usize) -> f64 {
        match self.source {
            Source::Sensors(_) => 0.5 * (self.readings[row][0] + self.readings[row][1]),
            Source::Antenna(_) => self.readings[row][1],
        }
    }

    /// Moves the rows after a jump of the clock so that they follow the rows before it: after a step back, and after
    /// a step forward in which the ship went no farther than in the usual time between two rows.
    fn mend_clock(&mut self) {
        let usual_s = self.usual_step_s();
        let mut moved_s = 0.0;
        for row in 1..self.t_s.len() {
            self.t_s[row] += moved_s;
            let step_s = self.t_s[row] - self.t_s[row - 1];
            let is_jump = step_s <= 0.0
                || (step_s > greater(LEAST_JUMP_S, 4.0 * usual_s)
                    && self.stood_still(row, step_s, usual_s));
            if is_jump {
                let by_s = usual_s - step_s;
                moved_s += by_s;
                self.t_s[row] += by_s;
                self.jumps.push(self.lines[row]);
            }
        }
    }

    /// Whether the ship went as far from the row before as in `usual_s`, though the clock says `step_s`.
    fn stood_still(&self, row: usize, step_s: f64, usual_s: f64) -> bool {
        let before: Vec<usize> =
            (row.saturating_sub(12)..row).filter(|index| self.off(*index).is_finite()).collect();
        let (Some(&first), Some(&last)) = (before.first(), before.last()) else { return false };
        let after = (row..self.t_s.len().min(row + 4)).find(|index| self.off(*index).is_finite());
        let Some(after) = after.filter(|_| last > first + 3) else { return false };
        let speed = (self.off(last) - self.off(first)) / (self.t_s[last] - self.t_s[first]);
        let went = self.off(after) - self.off(last);
        let late_s = (after - row) as f64 * usual_s;
        let (far, near) = (speed * (step_s + late_s), speed * (usual_s + late_s));
        // Plain only where the ship would have moved by more than the readings scatter.
        (far - near).abs() > 0.5 && (went - near).abs() < 0.25 * (far - near).abs()
    }
}

fn docking(log: &Log, rows: &[usize], axes: &BerthAxes, mapping: &Mapping) -> Channels {
    let sensors = mapping.sensors.unwrap_or([Sensor { place_m: 0.0, behind_m: 0.0 }; 2]);
    let is_measured = rows.iter().any(|row| log.rows[*row].readings[2].is_finite());
    let along_m = mapping.ship_place_m.unwrap_or(axes.start.along_m);
    let reading = |row: &usize| {
        let [bow_m, stern_m, own_m] = log.rows[*row].readings;
        let along_m = if is_measured { own_m } else { along_m };
        [bow_m - sensors[0].behind_m, stern_m - sensors[1].behind_m, along_m]
    };
    Channels {
        source: Source::Sensors(sensors.map(|sensor| sensor.place_m)),
        lines: Vec::new(),
        rows: Vec::new(),
        t_s: Vec::new(),
        readings: rows.iter().map(reading).collect(),
        steps: log.steps,
        assumed: (!is_measured).then_some((
            along_m,
            mapping.ship_place_sd_m,
            mapping.along_speed_sd_mps,
        )),
        constant_sd: [0.0; 3],
        jumps: Vec::new(),
    }
}

fn track(log: &Log, rows: &[usize], axes: &BerthAxes, mapping: &Mapping) -> Channels {
    let by_extent = log.extent_m.map(|extent_m| axes.antenna_of(extent_m));
    let antenna_m = mapping.antenna_m.or(by_extent).unwrap_or(vec2(0.0, 0.0));
    let reading = |row: &usize| {
        let [north_m, east_m, heading_rad] = log.rows[*row].readings;
        let at = vec2(north_m, east_m);
        if !(at.is_finite() && heading_rad.is_finite()) {
            return [f64::NAN; 3];
        }
        let [along_m, off_m] = axes.in_axes(at);
        [along_m, off_m, axes.lie(at, heading_rad).angle_rad]
    };
    let is_ais = log.kind == LogKind::Ais;
    let position_sd_m = mapping.position_sd_m.unwrap_or(if is_ais { 5.0 } else { 0.05 });
    let heading_sd_rad =
        mapping.heading_sd_rad.unwrap_or(if is_ais { 1.0_f64.to_radians() } else { 0.0 });
    let step_m = greater(log.steps[0], log.steps[1]);
    Channels {
        source: Source::Antenna(antenna_m),
        lines: Vec::new(),
        rows: Vec::new(),
        t_s: Vec::new(),
        readings: rows.iter().map(reading).collect(),
        steps: [step_m, step_m, log.steps[2]],
        assumed: None,
        constant_sd: [position_sd_m, position_sd_m, heading_sd_rad],
        jumps: Vec::new(),
    }
}
