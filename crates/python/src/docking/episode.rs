//! One episode of the docking environment: from an action to the observation and the reward. The
//! Python module `fenderline.docking` has the documentation.

use fenderline_contact::number::{bounded, greater};
use fenderline_contact::{Rotation, Vec2, vec2};
use fenderline_sim::environment::EnvironmentError;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::{MeanWind, Wind, WindProfile};
use fenderline_sim::{BodyStart, BodyVelocity, SimError, Start};

use super::berth::{Berth, Lie};
use crate::run::Run;

/// Numbers of an observation.
pub(super) const SEEN: usize = 17;
/// Number of orders to the ship in an action: rudder, engine, bow and stern thruster.
pub(super) const SHIP_ORDERS: usize = 4;
/// Number of steps after which an episode is cut off.
const STEPS: u32 = 900;

/// Divisor of each number of an observation.
const SCALES: [f64; SEEN] =
    [100.0, 50.0, 0.5, 1.0, 0.3, 0.005, 1.0, 1.0, 1.0, 1.0, 10.0, 10.0, 0.5, 1.0, 10.0, 5.0, 0.05];

/// Largest value of each number of an observation; the least value is the negative of the largest, but 0 for the
/// energy.
const MOST: [f32; SEEN] = {
    let mut most = [10.0; SEEN];
    let ones = [6, 7, 8, 9, 14, 15, 16];
    let mut k = 0;
    while k < ones.len() {
        most[ones[k]] = 1.0;
        k += 1;
    }
    most
};
/// Place of the energy among the numbers of an observation.
const ENERGY: usize = 13;

pub(super) type Seen = [f32; SEEN];

/// How an episode ended. Each variant has the same number as in Python's class `_Ended`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Ended {
    NotYet = 0,
    Alongside = 1,
    Overloaded = 2,
    OverQuayLine = 3,
    LeftBasin = 4,
}

/// What a step gives.
pub(super) struct Outcome {
    pub(super) seen: Seen,
    pub(super) reward: f64,
    pub(super) ended: Ended,
    pub(super) is_truncated: bool,
}

/// Where and how fast the ship of an episode starts, and the weather.
#[derive(Clone, Copy, Debug)]
pub(super) struct Drawn {
    pub(super) position_m: Vec2,
    pub(super) heading_rad: f64,
    pub(super) velocity_mps: Vec2,
    pub(super) wind_mps: f64,
    pub(super) wind_from_rad: f64,
    pub(super) current_mps: f64,
    pub(super) current_towards_rad: f64,
}

/// The control that a number of an action sets.
#[derive(Clone, Copy, Debug)]
pub(super) struct Lever {
    pub(super) control: usize,
    /// The value of 1.
    pub(super) full: f64,
}

/// An episode.
pub(super) struct Episode {
    pub(super) run: Run,
    start: Start,
    /// Values of the controls.
    controls: Vec<f64>,
    pub(super) orders: [f64; SHIP_ORDERS],
    /// Wind along the quay, wind towards the quay, and current along the quay (m/s).
    pub(super) weather_mps: [f64; 3],
    /// Distance of the ship from the berth (m).
    far_m: f64,
    /// The largest share of its rated energy that a fender has stored in the episode.
    pub(super) share: f64,
    pub(super) steps: u32,
}

impl Episode {
    pub(super) fn new(run: Run) -> Episode {
        Episode {
            start: run.simulation.setup().start(),
            controls: vec![f64::NAN; run.controls.len()],
            run,
            orders: [0.0; SHIP_ORDERS],
            weather_mps: [0.0; 3],
            far_m: 0.0,
            share: 0.0,
            steps: 0,
        }
    }

    /// Starts again, and observes.
    pub(super) fn begin(&mut self, drawn: &Drawn, berth: &Berth) -> Result<Seen, EnvironmentError> {
        let (wind_mps, from_rad) = (drawn.wind_mps, drawn.wind_from_rad);
        let wind = MeanWind { speed_mps: wind_mps, from_rad, profile: WindProfile::Uniform };
        let ahead =
            |speed_mps: f64, rad: f64| Rotation::from_angle(rad).apply(vec2(speed_mps, 0.0));
        let current_mps = ahead(drawn.current_mps, drawn.current_towards_rad);
        let (wind, current) = (Wind::steady(wind)?, Current::uniform(current_mps)?);
        (self.start.wind, self.start.current) = (Some(wind), Some(current));
        let velocity = BodyVelocity {
            surge_mps: drawn.velocity_mps.x,
            sway_mps: drawn.velocity_mps.y,
            yaw_radps: 0.0,
        };
        let (position_m, heading_rad) = (drawn.position_m, drawn.heading_rad);
        self.start.bodies[berth.ship] = BodyStart { position_m, heading_rad, velocity };
        self.run.restart(&self.start);
        // The direction of a wind is the direction from which it comes.
        let blows_mps = -ahead(wind_mps, from_rad);
        self.weather_mps = [blows_mps.x, blows_mps.y, current_mps.x];
        self.controls.fill(f64::NAN);
        (self.orders, self.share, self.steps) = ([0.0; SHIP_ORDERS], 0.0, 0);
        let lie = berth.lie(&self.run.simulation.states()[berth.ship]);
        self.far_m = lie.far_m;
        Ok(self.observe(&lie, berth))
    }

    /// Takes one step of the episode with an action: one finite number for each control in `levers`.
    pub(super) fn step(
        &mut self,
        action: &[f64],
        levers: &[Lever],
        berth: &Berth,
    ) -> Result<Outcome, SimError> {
        for (index, (lever, value)) in levers.iter().zip(action).enumerate() {
            let order = bounded(*value, -1.0, 1.0);
            self.controls[lever.control] = order * lever.full;
            if let Some(own) = self.orders.get_mut(index) {
                *own = order;
            }
        }
        self.run.order(&self.controls, |_, _| ());
        self.run.step()?;
        self.steps += 1;
        let state = self.run.simulation.states()[berth.ship];
        let lie = berth.lie(&state);
        let (mut share, mut has_failed) = (0.0, false);
        for fender in self.run.simulation.fender_summaries() {
            share = greater(share, fender.share_of_rated_energy.unwrap_or(0.0));
            has_failed |= fender.failed;
        }
        // An earlier case precedes a later case.
        let ended = if lie.is_out_of_basin(&state) {
            Ended::LeftBasin
        } else if lie.is_over_quay_line() {
            Ended::OverQuayLine
        } else if share > 1.0 || has_failed {
            Ended::Overloaded
        } else if berth.is_alongside(&state, &lie) {
            Ended::Alongside
        } else {
            Ended::NotYet
        };
        let squares: f64 = self.orders.iter().map(|order| order * order).sum();
        let at_end = match ended {
            Ended::NotYet => 0.0,
            Ended::Alongside => 100.0,
            Ended::Overloaded | Ended::OverQuayLine | Ended::LeftBasin => -100.0,
        };
        let reward = 0.1 * (self.far_m - lie.far_m)
            - 0.01
            - 0.01 * (squares / SHIP_ORDERS as f64)
            - 50.0 * greater(share - self.share, 0.0)
            + at_end;
        (self.far_m, self.share) = (lie.far_m, share);
        let is_truncated = self.steps >= STEPS && ended == Ended::NotYet;
        Ok(Outcome { seen: self.observe(&lie, berth), reward, ended, is_truncated })
    }

    /// The present observation, from how the ship lies relative to the berth.
    fn observe(&self, lie: &Lie, berth: &Berth) -> Seen {
        let state = &self.run.simulation.states()[berth.ship];
        let [rudder, engine, bow, stern] = self.orders;
        let [wind_along_mps, wind_towards_mps, current_mps] = self.weather_mps;
        let (along_m, off_m, heading_rad) = (-state.position_m.x, lie.off_m, lie.heading_rad);
        let quantities = [
            along_m,
            off_m,
            heading_rad,
            state.velocity_mps.x,
            state.velocity_mps.y,
            state.yaw_rate_radps,
            rudder,
            engine,
            bow,
            stern,
            wind_along_mps,
            wind_towards_mps,
            current_mps,
            self.share,
            along_m,
            off_m,
            heading_rad,
        ];
        core::array::from_fn(|k| {
            let least = if k == ENERGY { 0.0 } else { -MOST[k] };
            ((quantities[k] / SCALES[k]) as f32).clamp(least, MOST[k])
        })
    }
}
