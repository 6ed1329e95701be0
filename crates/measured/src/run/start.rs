//! The measured state some metres off the fenders, and states beside it.

use crate::estimate::find::Way;
use crate::estimate::state::{motion_at, time_of_gap};
use crate::estimate::touch::Touch;
use crate::geometry::{BerthAxes, Motion};

/// States from which a ship is run.
pub(super) struct Starts {
    pub(super) measured: Motion,
    /// States beside it: one standard deviation away in each direction of its uncertainty.
    pub(super) beside: Vec<Motion>,
    /// Distance of the hull from the nearest fender (m).
    pub(super) gap_m: f64,
    /// Time from the start to the measured touch (s).
    pub(super) until_touch_s: f64,
}

/// Part of the bandwidth that may be missing at the start of a log.
pub(super) const LEAST_SHARE: f64 = 0.3;

/// The state at which the hull is `run_from_m` from the nearest fender, or nearer where the log begins later.
pub(super) fn starts(
    way: &Way,
    axes: &BerthAxes,
    touch: &Touch,
    run_from_m: f64,
) -> Result<Starts, String> {
    let channels = &way.channels;
    let speed_mps = touch.speed_mps.value;
    let earliest_s = channels.t_s[way.from] + LEAST_SHARE * touch.bandwidth_s;
    let mut t_s = touch.t_s - run_from_m / speed_mps;
    let few = "there are too few readings before the touch for a run from the measured state";
    // The parabola is laid through readings before and after the moment, but none after the touch.
    for _ in 0..6 {
        if t_s < earliest_s {
            t_s = earliest_s;
        }
        let half_s = 0.5 * touch.bandwidth_s;
        let to_s = fenderline_contact::number::lesser(t_s + half_s, touch.t_s);
        let of = channels.parabolas(to_s - touch.bandwidth_s, to_s, t_s).ok_or(few)?;
        let found = time_of_gap(channels, axes, &of, t_s, half_s, run_from_m);
        let next_s = match found {
            Some((next_s, _)) if next_s >= earliest_s && next_s < touch.t_s => next_s,
            _ => t_s,
        };
        if (next_s - t_s).abs() > 0.05 {
            t_s = next_s;
            continue;
        }
        let measured = motion_at(channels, axes, &of, t_s).ok_or(few)?;
        let nearest = axes.nearest(&measured.lie).ok_or(few)?;
        if nearest.gap_m <= 0.0 {
            return Err(few.to_owned());
        }
        let mut beside = Vec::new();
        for channel in 0..3 {
            for direction in of[channel].directions() {
                // How the readings curve has no part in a state.
                if direction[0] == 0.0 && direction[1] == 0.0 {
                    continue;
                }
                let mut moved = of;
                moved[channel] = of[channel].moved(direction);
                beside.extend(motion_at(channels, axes, &moved, t_s));
            }
        }
        let until_touch_s = touch.t_s - t_s;
        return Ok(Starts { measured, beside, gap_m: nearest.gap_m, until_touch_s });
    }
    Err("the readings before the touch do not lead to a state for the run".to_owned())
}
