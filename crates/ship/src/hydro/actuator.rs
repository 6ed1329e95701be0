//! Actuators: rate limits and first-order lags between an order and what the machinery does.
//!
//! Every step of an actuator is exact for any Δt: two steps of Δt/2 under the same order give the same result as one
//! step of Δt.

use fenderline_contact::number::bounded;

use std::f64::consts::{PI, TAU};

/// An actuator that follows its order at a constant rate: a rudder, a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateLimited {
    /// Present value of the actuator, such as a rudder angle or a shaft speed.
    pub value: f64,
    /// Largest rate of change of the actuator, per second.
    pub rate_per_s: f64,
    /// Largest value to either side of zero, where the actuator stops.
    pub stop: f64,
}

/// Whether an order to an actuator was followed or limited.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// The order was followed.
    Taken,
    /// The order was beyond the actuator's stop and was limited to the stop.
    Clamped,
}

impl RateLimited {
    /// A rudder amidships, with its rate (°/s) and stop (°).
    pub fn rudder(rate_degps: f64, stop_deg: f64) -> RateLimited {
        RateLimited { value: 0.0, rate_per_s: rate_degps.to_radians(), stop: stop_deg.to_radians() }
    }

    /// Moves the actuator towards the order for `step_s`. An order of NaN counts as limited and does not move the
    /// actuator.
    pub fn step(&mut self, order: f64, step_s: f64) -> Order {
        if order.is_nan() {
            return Order::Clamped;
        }
        let target = bounded(order, -self.stop, self.stop);
        let reach = self.rate_per_s * step_s;
        self.value += bounded(target - self.value, -reach, reach);
        if target == order { Order::Taken } else { Order::Clamped }
    }
}

/// The direction of a thruster or tug that turns at a constant rate. A direction without stops turns the shorter way; a
/// direction with stops stays between the stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slewing {
    /// Current direction of the thruster or tug in (−π, π] (rad).
    pub angle_rad: f64,
    /// Rate of turn (rad/s).
    pub rate_radps: f64,
    /// Stop of the direction on either side (rad); `None` if it turns without limit.
    pub stop_rad: Option<f64>,
}

impl Slewing {
    /// Turns the direction towards the order for `step_s`. If the order is exactly opposite, the direction turns to
    /// starboard. For an order beyond a stop, the direction turns to the stop. A direction with stops never turns
    /// through the stern. An order that is not finite does not turn the direction.
    pub fn step(&mut self, order_rad: f64, step_s: f64) -> Order {
        if !order_rad.is_finite() {
            return Order::Clamped;
        }
        let ordered_rad = wrapped(order_rad);
        let stop_rad = self.stop_rad.unwrap_or(PI);
        let target_rad = bounded(ordered_rad, -stop_rad, stop_rad);
        let turn_rad = target_rad - self.angle_rad;
        let turn_rad = if self.stop_rad.is_none() { wrapped(turn_rad) } else { turn_rad };
        let reach_rad = self.rate_radps * step_s;
        self.angle_rad = wrapped(self.angle_rad + bounded(turn_rad, -reach_rad, reach_rad));
        if target_rad == ordered_rad { Order::Taken } else { Order::Clamped }
    }
}

/// Returns an angle, wrapped to (−π, π] (rad).
fn wrapped(angle_rad: f64) -> f64 {
    let rest_rad = libm::remainder(angle_rad, TAU);
    if rest_rad <= -PI { rest_rad + TAU } else { rest_rad }
}

/// An actuator that follows its order with a first-order lag: a thruster, a tug's force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// Present value of the actuator, such as a thrust.
    pub value: f64,
    /// Time constant of the lag (s); 0 for no lag.
    pub time_constant_s: f64,
}

impl Lag {
    /// Moves the actuator for a step: the difference to the order is reduced by the factor e^{−Δt/τ}.
    pub fn step(&mut self, order: f64, step_s: f64) {
        if self.time_constant_s <= 0.0 {
            self.value = order;
            return;
        }
        let left = libm::exp(-step_s / self.time_constant_s);
        self.value = order + (self.value - order) * left;
    }
}

/// Positions of the engine telegraph.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Telegraph {
    /// Full astern.
    FullAstern,
    /// Half astern.
    HalfAstern,
    /// Slow astern.
    SlowAstern,
    /// Dead slow astern.
    DeadSlowAstern,
    /// Stop.
    Stop,
    /// Dead slow ahead.
    DeadSlowAhead,
    /// Slow ahead.
    SlowAhead,
    /// Half ahead.
    HalfAhead,
    /// Full ahead, manoeuvring.
    FullAhead,
    /// Full ahead at sea.
    NavigationFull,
}

impl Telegraph {
    /// All positions of the engine telegraph, from full astern to full ahead at sea.
    pub const ALL: [Telegraph; 10] = [
        Telegraph::FullAstern,
        Telegraph::HalfAstern,
        Telegraph::SlowAstern,
        Telegraph::DeadSlowAstern,
        Telegraph::Stop,
        Telegraph::DeadSlowAhead,
        Telegraph::SlowAhead,
        Telegraph::HalfAhead,
        Telegraph::FullAhead,
        Telegraph::NavigationFull,
    ];

    /// The telegraph's order in words, as in scenario files.
    #[must_use]
    pub const fn word(self) -> &'static str {
        match self {
            Telegraph::FullAstern => "full astern",
            Telegraph::HalfAstern => "half astern",
            Telegraph::SlowAstern => "slow astern",
            Telegraph::DeadSlowAstern => "dead slow astern",
            Telegraph::Stop => "stop",
            Telegraph::DeadSlowAhead => "dead slow ahead",
            Telegraph::SlowAhead => "slow ahead",
            Telegraph::HalfAhead => "half ahead",
            Telegraph::FullAhead => "full ahead",
            Telegraph::NavigationFull => "navigation full",
        }
    }

    /// Revolutions of a telegraph order divided by the revolutions at full ahead at sea. The revolutions of the
    /// telegraph orders are typical values for slow-running engines. A vessel with her own table of revolutions uses
    /// that table instead.
    pub fn revolutions_ratio(self) -> f64 {
        match self {
            Telegraph::FullAstern => -0.70,
            Telegraph::HalfAstern => -0.55,
            Telegraph::SlowAstern => -0.40,
            Telegraph::DeadSlowAstern => -0.30,
            Telegraph::Stop => 0.0,
            Telegraph::DeadSlowAhead => 0.30,
            Telegraph::SlowAhead => 0.40,
            Telegraph::HalfAhead => 0.55,
            Telegraph::FullAhead => 0.70,
            Telegraph::NavigationFull => 1.0,
        }
    }
}
