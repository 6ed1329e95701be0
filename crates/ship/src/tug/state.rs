//! The state of a vector tug: its orders, with their delay, and the lag of its force.

use core::f64::consts::TAU;

use fenderline_contact::number::lesser;
use fenderline_contact::{Vec2, vec2};

use super::envelope::TugEnvelope;
use crate::range::{OutOfRange, within};
use crate::step_time::StepTime;

/// Share of the bollard pull: a tug changes between pushing and pulling when her force is below this share.
const SLACK_SHARE: f64 = 0.01;

/// A tug that acts as a force at a point of a ship: the data that do not change in a run.
#[derive(Clone, Debug, PartialEq)]
pub struct VectorTug {
    /// Name, for messages.
    pub name: String,
    /// The forces that the tug can give.
    pub envelope: TugEnvelope,
    /// Point where the tug pushes, forward and to starboard of the ship's midship (m).
    pub push_at_m: Vec2,
    /// Fairlead of the tug's line, forward and to starboard of the ship's midship (m).
    pub pull_at_m: Vec2,
    /// Time after which the tug begins to carry out an order (s).
    pub delay_s: f64,
    /// Time constant of the lag of the tug's force (s).
    pub force_lag_s: f64,
    /// Time constant of the lag of the force's direction (s).
    pub direction_lag_s: f64,
}

/// An order to a vector tug.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum TugOrder {
    /// Stand by: no force.
    #[default]
    StandBy,
    /// Push against the hull.
    Push {
        /// Force (N).
        force_n: f64,
        /// Direction in which the tug pushes the ship, from the ship's bow, positive to starboard (rad).
        direction_rad: f64,
    },
    /// Pull on the line.
    Pull {
        /// Force (N).
        force_n: f64,
        /// Direction in which the tug pulls the ship, from the ship's bow, positive to starboard (rad).
        direction_rad: f64,
    },
}

/// The state of a tug that changes in a run: plain data.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TugState {
    /// The order that the tug carries out at present.
    pub order: TugOrder,
    /// Orders that the tug has not yet begun, oldest first, with the time (s) at which they begin.
    pub waiting: Vec<(f64, TugOrder)>,
    /// Force (N).
    pub force_n: f64,
    /// Present direction of the tug's force from the ship's bow, positive to starboard (rad).
    pub direction_rad: f64,
    /// Whether the tug pulls on her line instead of pushing at the hull.
    pub on_line: bool,
}

/// A tug's force on a ship in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TugForce {
    /// Force and moment [X, Y, N] of the tug about midship in the ship's axes (N, N, N·m).
    pub force: [f64; 3],
    /// Point of the ship where the tug's force acts, from midship (m).
    pub at_m: Vec2,
    /// Whether the ordered force was limited to the force that the tug can give at this speed and angle.
    pub limited: bool,
    /// Whether the tug began an order in this step.
    pub began: bool,
}

impl VectorTug {
    /// Checks every number.
    ///
    /// # Errors
    /// Fails at the first number of the tug that is out of range, and names it.
    pub fn check(&self) -> Result<(), OutOfRange> {
        self.envelope.check()?;
        for place_m in [self.push_at_m, self.pull_at_m] {
            within("place of a tug, forward [m]", place_m.x, -1000.0, 1000.0)?;
            within("place of a tug, to starboard [m]", place_m.y, -1000.0, 1000.0)?;
        }
        within("delay of a tug [s]", self.delay_s, 0.0, 3600.0)?;
        within("lag of a tug's force [s]", self.force_lag_s, 0.0, 3600.0)?;
        within("lag of a tug's direction [s]", self.direction_lag_s, 0.0, 3600.0)?;
        Ok(())
    }

    /// Gives an order to the tug at a time. The tug begins to carry out an order after the delay. The tug carries out
    /// orders one after the other.
    ///
    /// # Errors
    /// Fails for a force below 0 or above 10⁸ N, or a direction out of range; the tug's state is then unchanged. An
    /// ordered force above the bollard pull is accepted, but limited in each step.
    pub fn order(&self, state: &mut TugState, t_s: f64, order: TugOrder) -> Result<(), OutOfRange> {
        if let TugOrder::Push { force_n, direction_rad }
        | TugOrder::Pull { force_n, direction_rad } = order
        {
            within("force ordered of a tug [N]", force_n, 0.0, 1e8)?;
            within("direction ordered of a tug [rad]", direction_rad, -100.0, 100.0)?;
        }
        let begins_s = within("time of an order [s]", t_s + self.delay_s, -1e12, 1e12)?;
        state.waiting.push((begins_s, order));
        Ok(())
    }

    /// The force of the tug at the end of a step that begins at `t_s`. `water_mps` is the velocity of the ship through
    /// the water in the ship's axes, forward and to starboard (m/s). Force and direction of the tug follow the order as
    /// exact exponentials, for a step of any length. Between pushing and pulling the tug's force first falls to zero.
    /// An order to the tug takes effect in the first step that begins at its time or later.
    pub fn step(
        &self,
        state: &mut TugState,
        StepTime { t_s, step_s }: StepTime,
        water_mps: Vec2,
        water_density_kgpm3: f64,
    ) -> TugForce {
        let began = begin_orders(state, t_s);
        let target = Target::of(state);
        let at_hand = self.change_over(state, &target);
        if at_hand && target.wanted_n > 0.0 {
            let off_rad = libm::remainder(target.direction_rad - state.direction_rad, TAU);
            if state.force_n <= SLACK_SHARE * self.envelope.bollard_pull_n {
                // While the tug has no force, she first takes her position.
                state.direction_rad = target.direction_rad;
            } else {
                state.direction_rad += off_rad * share(step_s, self.direction_lag_s);
            }
        }
        let available_n = self.available_n(state.direction_rad, water_mps, water_density_kgpm3);
        let wanted_n = if at_hand { target.wanted_n } else { 0.0 };
        let goal_n = lesser(wanted_n, available_n);
        state.force_n += (goal_n - state.force_n) * share(step_s, self.force_lag_s);
        // The present envelope also limits the lagged force.
        let given_n = lesser(state.force_n, available_n);
        let at_m = if state.on_line { self.pull_at_m } else { self.push_at_m };
        let direction =
            vec2(libm::cos(state.direction_rad), libm::sin(state.direction_rad)) * given_n;
        TugForce {
            force: [direction.x, direction.y, at_m.cross(direction)],
            at_m,
            limited: wanted_n > available_n,
            began,
        }
    }

    /// True if the tug is at the hull or on her line, as her order needs. The tug changes between hull and line once
    /// her force is small.
    fn change_over(&self, state: &mut TugState, target: &Target) -> bool {
        let Some(on_line) = target.on_line else { return true };
        if state.on_line != on_line && state.force_n <= SLACK_SHARE * self.envelope.bollard_pull_n {
            state.on_line = on_line;
        }
        state.on_line == on_line
    }

    fn available_n(&self, direction_rad: f64, water_mps: Vec2, density_kgpm3: f64) -> f64 {
        let speed_mps = water_mps.length();
        let course_rad = libm::atan2(water_mps.y, water_mps.x);
        self.envelope.available_n(direction_rad - course_rad, speed_mps, density_kgpm3)
    }
}

/// Begins the tug's orders that are due. Returns true if any order to the tug was due.
fn begin_orders(state: &mut TugState, t_s: f64) -> bool {
    let due = state.waiting.iter().take_while(|(begins_s, _)| *begins_s <= t_s).count();
    for (_, order) in state.waiting.drain(..due) {
        state.order = order;
    }
    due > 0
}

/// The force that an order to a tug asks for.
struct Target {
    wanted_n: f64,
    direction_rad: f64,
    /// True if the order needs the tug on her line, false if it needs her at the hull; `None` if it needs neither.
    on_line: Option<bool>,
}

impl Target {
    fn of(state: &TugState) -> Target {
        match state.order {
            TugOrder::StandBy => {
                Target { wanted_n: 0.0, direction_rad: state.direction_rad, on_line: None }
            }
            TugOrder::Push { force_n, direction_rad } => {
                Target { wanted_n: force_n, direction_rad, on_line: Some(false) }
            }
            TugOrder::Pull { force_n, direction_rad } => {
                Target { wanted_n: force_n, direction_rad, on_line: Some(true) }
            }
        }
    }
}

/// Share 1 − e^(−Δt/τ) of a change that a first-order lag covers in a step; 1 without a lag.
fn share(step_s: f64, lag_s: f64) -> f64 {
    if lag_s > 0.0 { -libm::expm1(-step_s / lag_s) } else { 1.0 }
}
