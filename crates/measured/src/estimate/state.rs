//! The motion of the ship by the parabolas of the channels.

use super::channels::Channels;
use super::parabola::Parabola;
use crate::geometry::{BerthAxes, Lie, Motion, Nearest};

/// Half of the step of the numerical derivative of the lie (s).
const HALF_STEP_S: f64 = 0.05;

fn lie_at(channels: &Channels, axes: &BerthAxes, of: &[Parabola; 3], t_s: f64) -> Option<Lie> {
    channels.lie(axes, [of[0].value(t_s), of[1].value(t_s), of[2].value(t_s)])
}

/// Lie and rates at the time `t_s` (s).
pub(crate) fn motion_at(
    channels: &Channels,
    axes: &BerthAxes,
    of: &[Parabola; 3],
    t_s: f64,
) -> Option<Motion> {
    let lie = lie_at(channels, axes, of, t_s)?;
    // The lie changes with the readings; along the slopes of the parabolas.
    let beside = |by_s: f64| {
        let at = |index: usize| of[index].value(t_s) + by_s * of[index].slope(t_s);
        channels.lie(axes, [at(0), at(1), at(2)])
    };
    let (before, after) = (beside(-HALF_STEP_S)?, beside(HALF_STEP_S)?);
    let rate = |before: f64, after: f64| (after - before) / (2.0 * HALF_STEP_S);
    Some(Motion {
        lie,
        rates: [
            rate(before.along_m, after.along_m),
            rate(before.off_m, after.off_m),
            rate(before.angle_rad, after.angle_rad),
        ],
    })
}

/// The time near `from_s` at which the hull is `gap_m` from the nearest fender, by the secant method within `reach_s`;
/// and that fender.
pub(crate) fn time_of_gap(
    channels: &Channels,
    axes: &BerthAxes,
    of: &[Parabola; 3],
    from_s: f64,
    reach_s: f64,
    gap_m: f64,
) -> Option<(f64, Nearest)> {
    let nearest = |t_s: f64| axes.nearest(&lie_at(channels, axes, of, t_s)?);
    let wrong = |at: &Nearest| at.gap_m - gap_m;
    let mut t_s = from_s;
    let mut own = nearest(t_s)?;
    let mut before: Option<(f64, f64)> = None;
    for _ in 0..60 {
        if wrong(&own).abs() < 1e-9 {
            return Some((t_s, own));
        }
        let slope = match before {
            Some((other_s, other)) if other_s != t_s => (wrong(&own) - other) / (t_s - other_s),
            _ => (wrong(&nearest(t_s + 0.01)?) - wrong(&own)) / 0.01,
        };
        if slope == 0.0 || !slope.is_finite() {
            return None;
        }
        before = Some((t_s, wrong(&own)));
        t_s = fenderline_contact::number::bounded(
            t_s - wrong(&own) / slope,
            from_s - reach_s,
            from_s + reach_s,
        );
        own = nearest(t_s)?;
    }
    (wrong(&own).abs() < 1e-4).then_some((t_s, own))
}
