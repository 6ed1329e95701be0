//! Curves of an approach, for the report.

use fenderline_contact::number::{bounded, lesser};

use crate::estimate::channels::Source;
use crate::estimate::find::Way;
use crate::estimate::state::motion_at;
use crate::estimate::touch::Touch;
use crate::geometry::{BerthAxes, Lie};

/// The curves begin this many bandwidths before the touch.
const BEFORE: f64 = 8.0;
/// Shortest and longest time before the touch (s).
const SPAN_S: [f64; 2] = [120.0, 900.0];
/// The readings are shown to this part of the time before the touch after it.
const AFTER: f64 = 0.25;
/// Number of points of a smoothed line.
const POINTS: u32 = 60;

/// Points of time from the touch (s) and value.
pub type Line = Vec<(f64, f64)>;

/// What the report draws of an approach.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Curves {
    /// Readings: name, and distances (m) from the line of the fenders over time.
    pub readings: Vec<(&'static str, Line)>,
    /// Distance of the hull from the nearest fender by the parabolas (m).
    pub gap_m: Line,
    /// Speed of the later point of contact towards the quay by the parabolas (m/s).
    pub speed_mps: Line,
    /// Two standard deviations around the speed (m/s).
    pub speed_low_mps: Line,
    /// See `speed_low_mps`.
    pub speed_high_mps: Line,
    /// Where the ship lies over the time from the touch (s) by the parabolas; the last of them is the touch.
    pub lies: Vec<(f64, Lie)>,
}

/// The curves of a way.
pub(crate) fn curves(way: &Way, axes: &BerthAxes, touch: &Touch) -> Curves {
    let channels = &way.channels;
    let whole_s = bounded(BEFORE * touch.bandwidth_s, SPAN_S[0], SPAN_S[1]);
    let span_s = lesser(whole_s, touch.t_s - channels.t_s[way.from]);
    let shown = (0..channels.t_s.len()).filter(|row| {
        let since_s = channels.t_s[*row] - touch.t_s;
        (-span_s..=AFTER * span_s).contains(&since_s)
    });
    let rows: Vec<usize> = shown.collect();
    let line = |of: &dyn Fn(usize) -> f64| {
        let points = rows.iter().map(|row| (channels.t_s[*row] - touch.t_s, of(*row)));
        points.filter(|point| point.1.is_finite()).collect::<Line>()
    };
    let readings = match channels.source {
        Source::Sensors(_) => vec![
            ("bow sensor", line(&|row| channels.readings[row][0])),
            ("stern sensor", line(&|row| channels.readings[row][1])),
        ],
        Source::Antenna(_) => vec![(
            "hull at the nearest fender",
            line(&|row| {
                let lie = channels.lie(axes, channels.readings[row]);
                lie.and_then(|lie| axes.nearest(&lie)).map_or(f64::NAN, |nearest| nearest.gap_m)
            }),
        )],
    };
    let mut curves = Curves { readings, ..Curves::default() };
    for point in 0..=POINTS {
        let since_s = -span_s * (1.0 - f64::from(point) / f64::from(POINTS));
        let at_s = touch.t_s + since_s;
        let to_s = lesser(at_s + 0.5 * touch.bandwidth_s, touch.t_s);
        let Some(of) = channels.parabolas(to_s - touch.bandwidth_s, to_s, at_s) else { continue };
        let Some(motion) = motion_at(channels, axes, &of, at_s) else { continue };
        curves.lies.push((since_s, motion.lie));
        if let Some(nearest) = axes.nearest(&motion.lie) {
            curves.gap_m.push((since_s, nearest.gap_m));
        }
        let along_m = motion.lie.along_m + touch.along_m.value - touch.motion.lie.along_m;
        let speed_mps = axes.at_ship(&motion, [along_m, 0.0]).1;
        let by = |channel: usize| {
            let sd = libm::sqrt(of[channel].covariance[1][1]);
            let mut moved = of;
            moved[channel] = of[channel].moved([0.0, sd, 0.0]);
            let moved = motion_at(channels, axes, &moved, at_s);
            moved.map_or(0.0, |moved| axes.at_ship(&moved, [along_m, 0.0]).1 - speed_mps)
        };
        let sd_mps = libm::sqrt((0..3).map(|channel| by(channel) * by(channel)).sum::<f64>());
        curves.speed_mps.push((since_s, speed_mps));
        curves.speed_low_mps.push((since_s, speed_mps - 2.0 * sd_mps));
        curves.speed_high_mps.push((since_s, speed_mps + 2.0 * sd_mps));
    }
    curves
}
