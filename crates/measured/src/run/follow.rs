//! The run that a force keeps on the measured path: what tugs, thrusters, wind and lines together gave.

use core::f64::consts::TAU;

use fenderline_contact::Wrench;
use fenderline_contact::number::{greater, lesser};
use fenderline_sim::{MassProperties, Setup};

use super::begun;
use super::start::LEAST_SHARE;
use super::water::water_only;
use crate::estimate::Uncertain;
use crate::estimate::find::Way;
use crate::estimate::parabola::Parabola;
use crate::estimate::state::motion_at;
use crate::estimate::touch::Touch;
use crate::geometry::{BerthAxes, Motion};

/// Natural period of the spring that holds the ship on her path, on her mass with its added mass (s). The spring is stiff
/// beside the minutes of an approach and soft beside the second of a row. With critical damping to the speed of the path, the
/// spring only takes energy out of the ship's motion about the path.
const PERIOD_S: f64 = 15.0;
/// Time between the points of the path (s); the path is straight between them.
const STEP_S: f64 = 1.0;
/// The start of the run is sought back from the touch in steps of this time (s).
const BACK_S: f64 = 5.0;
/// Longest way that is followed (s).
const LONGEST_S: f64 = 3600.0;

/// What a force gave that kept the ship on her measured path from the start until the touch. Each three are: along the
/// quay, positive ahead; towards the quay; and the turn, positive with the bow towards the quay.
#[derive(Clone, Debug, PartialEq)]
pub struct Followed {
    /// Distance of the hull from the nearest fender at the start (m).
    pub from_m: f64,
    /// Time from the start to the end (s).
    pub duration_s: f64,
    /// Impulse of the force (N·s, N·s) and of its moment about the centre of gravity (N·m·s).
    pub impulse: [Uncertain; 3],
    /// Largest distance of the ship from her measured path (m).
    pub off_m: f64,
}

impl Followed {
    /// Mean of the force (N, N) and of its moment (N·m).
    #[must_use]
    pub fn mean(&self) -> [Uncertain; 3] {
        self.impulse.map(|own| Uncertain {
            value: own.value / self.duration_s,
            sd: own.sd / self.duration_s,
        })
    }
}

/// The measured path at times one [`STEP_S`] apart.
struct Path {
    from_s: f64,
    points: Vec<Motion>,
}

impl Path {
    /// By parabolas through the readings of one bandwidth around each time; none after the touch is used.
    fn of(way: &Way, axes: &BerthAxes, touch: &Touch, from_s: f64) -> Option<Path> {
        let count = libm::ceil((touch.t_s - from_s) / STEP_S) as usize;
        let point = |index: usize| {
            let at_s = lesser(from_s + index as f64 * STEP_S, touch.t_s);
            let of = parabolas(way, touch, at_s)?;
            motion_at(&way.channels, axes, &of, from_s + index as f64 * STEP_S)
        };
        let points: Option<Vec<Motion>> = (0..=count).map(point).collect();
        Some(Path { from_s, points: points? })
    }

    /// Straight between two points. With `drift_mps`, the ship goes faster along the quay than measured, and is where she was
    /// measured at the touch.
    fn at(&self, t_s: f64, drift_mps: f64, touch_s: f64) -> Motion {
        let place = greater((t_s - self.from_s) / STEP_S, 0.0);
        let index = (place as usize).min(self.points.len().saturating_sub(2));
        let (one, other) =
            (&self.points[index], &self.points[self.points.len().min(index + 2) - 1]);
        let share = place - index as f64;
        let between = |one: f64, other: f64| one + share * (other - one);
        let mut motion = *one;
        motion.lie.along_m = between(one.lie.along_m, other.lie.along_m);
        motion.lie.off_m = between(one.lie.off_m, other.lie.off_m);
        motion.lie.angle_rad = between(one.lie.angle_rad, other.lie.angle_rad);
        for (rate, to) in motion.rates.iter_mut().zip(other.rates) {
            *rate = between(*rate, to);
        }
        drifting(motion, drift_mps, t_s - touch_s)
    }
}

/// A state with a further speed along the quay, `since_s` after the moment at which the speed changes no place.
fn drifting(mut motion: Motion, drift_mps: f64, since_s: f64) -> Motion {
    motion.lie.along_m += drift_mps * since_s;
    motion.rates[0] += drift_mps;
    motion
}

fn parabolas(way: &Way, touch: &Touch, at_s: f64) -> Option<[Parabola; 3]> {
    let to_s = lesser(at_s + 0.5 * touch.bandwidth_s, touch.t_s);
    way.channels.parabolas(to_s - touch.bandwidth_s, to_s, at_s)
}

/// The state from which the path is followed: time (s), state, and distance of the hull from the nearest fender (m).
fn start(way: &Way, axes: &BerthAxes, touch: &Touch, from_m: f64) -> Option<(f64, Motion, f64)> {
    let channels = &way.channels;
    let earliest_s =
        greater(channels.t_s[way.from] + LEAST_SHARE * touch.bandwidth_s, touch.t_s - LONGEST_S);
    let mut found = None;
    let mut at_s = touch.t_s;
    loop {
        at_s = greater(at_s - BACK_S, earliest_s);
        // Where readings are missing, the path begins after them.
        let Some(of) = parabolas(way, touch, at_s) else { break };
        let Some(motion) = motion_at(channels, axes, &of, at_s) else { break };
        let Some(nearest) = axes.nearest(&motion.lie) else { break };
        if nearest.gap_m > 0.0 {
            found = Some((at_s, motion, nearest.gap_m));
        }
        if nearest.gap_m >= from_m || at_s <= earliest_s {
            break;
        }
    }
    found
}

/// Standard deviations of the rates at a time.
fn rates_sd(way: &Way, axes: &BerthAxes, touch: &Touch, at_s: f64) -> Option<[f64; 3]> {
    let of = parabolas(way, touch, at_s)?;
    let own = motion_at(&way.channels, axes, &of, at_s)?;
    let mut variances = [0.0; 3];
    for channel in 0..3 {
        let sd = libm::sqrt(of[channel].covariance[1][1]);
        let mut moved = of;
        moved[channel] = of[channel].moved([0.0, sd, 0.0]);
        let moved = motion_at(&way.channels, axes, &moved, at_s)?;
        for (variance, (to, from)) in variances.iter_mut().zip(moved.rates.iter().zip(own.rates)) {
            *variance += (to - from) * (to - from);
        }
    }
    Some(variances.map(libm::sqrt))
}

/// The run along the measured path from the distance `from_m`, or nearer where the log begins later, until the touch.
///
/// # Errors
/// Says why there is no such run.
pub(crate) fn follow(
    setup: &Setup,
    way: &Way,
    axes: &BerthAxes,
    touch: &Touch,
    from_m: f64,
) -> Result<Followed, String> {
    let few = "there are too few readings to follow the way to the touch";
    let (from_s, measured, gap_m) = start(way, axes, touch, from_m).ok_or(few)?;
    let duration_s = touch.t_s - from_s;
    let path = Path::of(way, axes, touch, from_s).ok_or(few)?;
    let ends = [from_s, touch.t_s].map(|at_s| rates_sd(way, axes, touch, at_s));
    let [Some(at_start), Some(at_touch)] = ends else { return Err(few.to_owned()) };
    let inertia = inertia(setup.bodies[axes.ship].mass.as_ref());
    let held = |drift_mps: f64| {
        held(setup, axes, &path, &drifting(measured, drift_mps, -duration_s), touch.t_s, drift_mps)
    };
    let own = held(0.0)?;
    // A way along the quay that nobody measured changes the moment too: the water turns a ship that goes ahead and sideways.
    let beside = match way.channels.assumed {
        Some((_, _, drift_mps)) => held(drift_mps)?.impulse,
        None => own.impulse,
    };
    // Away from the quay is positive in the axes.
    let signs = [1.0, -1.0, 1.0];
    let impulse = core::array::from_fn(|of| {
        let by_ends = inertia[of] * libm::hypot(at_start[of], at_touch[of]);
        let by_drift = beside[of] - own.impulse[of];
        // Along the quay, the speeds at the ends have the drift already.
        let by_drift = if of == 0 { 0.0 } else { by_drift };
        Uncertain { value: signs[of] * own.impulse[of], sd: libm::hypot(by_ends, by_drift) }
    });
    Ok(Followed { from_m: gap_m, duration_s: own.duration_s, impulse, off_m: own.off_m })
}

/// What one run along the path gave, in the axes of the berth.
struct Held {
    impulse: [f64; 3],
    duration_s: f64,
    off_m: f64,
}

/// Runs from a state along the path until the touch, or until she touches a fender in the run.
fn held(
    setup: &Setup,
    axes: &BerthAxes,
    path: &Path,
    from: &Motion,
    touch_s: f64,
    drift_mps: f64,
) -> Result<Held, String> {
    let inertia = inertia(setup.bodies[axes.ship].mass.as_ref());
    let until_s = touch_s - path.from_s;
    let mut setup = water_only(setup);
    setup.duration_s = until_s + setup.step_s;
    let step_s = setup.step_s;
    let mut wrenches = vec![Wrench::default(); setup.bodies.len()];
    let mut simulation = begun(&mut setup, axes, from)?;
    let frequency = TAU / PERIOD_S;
    let [stiffness, damping] = [frequency * frequency, 2.0 * frequency];
    let origin_m = axes.from_axes([0.0, 0.0]);
    let (mut impulse, mut off_m) = ([0.0; 3], 0.0);
    while simulation.time_s() + 0.5 * step_s < until_s && simulation.contacts().is_empty() {
        let state = simulation.states()[axes.ship];
        let wanted = path.at(path.from_s + simulation.time_s(), drift_mps, touch_s);
        let lie = axes.lie(state.position_m, state.heading_rad);
        let from = axes.in_axes(state.position_m);
        let to = axes.in_axes(state.position_m + state.velocity_mps);
        let rates = [to[0] - from[0], to[1] - from[1], axes.rate_of_turn(state.yaw_rate_radps)];
        let away = [
            wanted.lie.along_m - lie.along_m,
            wanted.lie.off_m - lie.off_m,
            wanted.lie.angle_rad - lie.angle_rad,
        ];
        off_m = greater(off_m, libm::hypot(away[0], away[1]));
        let pull = |of: usize| {
            inertia[of] * (stiffness * away[of] + damping * (wanted.rates[of] - rates[of]))
        };
        let force = [pull(0), pull(1), pull(2)];
        wrenches[axes.ship] = Wrench {
            force_n: axes.from_axes([force[0], force[1]]) - origin_m,
            moment_nm: axes.rate_of_turn(force[2]),
        };
        simulation.set_external(&wrenches);
        simulation.step().map_err(|error| format!("the run along the measured path: {error}"))?;
        for (total, own) in impulse.iter_mut().zip(force) {
            *total += own * step_s;
        }
    }
    let duration_s = simulation.time_s();
    if duration_s <= 0.0 {
        return Err("there is no time to follow the way to the touch".to_owned());
    }
    Ok(Held { impulse, duration_s, off_m })
}

/// Masses along and across the quay (kg) and moment of inertia (kg·m²), with the added ones, of a ship that lies nearly
/// along the quay.
fn inertia(of: Option<&MassProperties>) -> [f64; 3] {
    let of = of.copied().unwrap_or_default();
    [
        of.mass_kg + of.added_surge_kg,
        of.mass_kg + of.added_sway_kg,
        of.yaw_inertia_kgm2 + of.added_yaw_kgm2,
    ]
}
