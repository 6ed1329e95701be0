//! Between the order and the machinery: small states with one exact step each.
//!
//! Every step is exact for any Δt: two steps of Δt/2 under one order end where one of Δt does.

use fenderline_contact::number::bounded;

use std::f64::consts::{PI, TAU};

/// Something that follows its order at a constant rate: a rudder, a shaft.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RateLimited {
    /// Where it is, in the quantity's own unit.
    pub value: f64,
    /// How fast it moves, per second.
    pub rate_per_s: f64,
    /// Its stop to either side of zero.
    pub stop: f64,
}

/// What became of an order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Taken as given.
    Taken,
    /// Beyond the stop; the stop was ordered instead.
    Clamped,
}

impl RateLimited {
    /// A rudder amidships, with its rate (°/s) and stop (°).
    pub fn rudder(rate_degps: f64, stop_deg: f64) -> RateLimited {
        RateLimited { value: 0.0, rate_per_s: rate_degps.to_radians(), stop: stop_deg.to_radians() }
    }

    /// Moves towards the order for `step_s`. An order that is not a number counts as clamped and leaves it
    /// where it is.
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

/// An azimuth that turns at a constant rate: all the way round and by the shorter way, or between stops.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slewing {
    /// Where it points, in (−π, π] (rad).
    pub angle_rad: f64,
    /// How fast it turns (rad/s).
    pub rate_radps: f64,
    /// Its stop to either side (rad); `None`: it turns all the way round.
    pub stop_rad: Option<f64>,
}

impl Slewing {
    /// Turns towards the order for `step_s`; straight behind it, to starboard. An order beyond the stop
    /// turns it to the stop, and with stops it never turns over the stern. An order that is not a finite
    /// number leaves it where it is.
    pub fn step(&mut self, order_rad: f64, step_s: f64) -> Order {
        if !order_rad.is_finite() {
            return Order::Clamped;
        }
        let ordered_rad = wrapped(order_rad);
        let stop_rad = self.stop_rad.unwrap_or(PI);
        let target_rad = bounded(ordered_rad, -stop_rad, stop_rad);
        let way_rad = target_rad - self.angle_rad;
        let way_rad = if self.stop_rad.is_none() { wrapped(way_rad) } else { way_rad };
        let reach_rad = self.rate_radps * step_s;
        self.angle_rad = wrapped(self.angle_rad + bounded(way_rad, -reach_rad, reach_rad));
        if target_rad == ordered_rad { Order::Taken } else { Order::Clamped }
    }
}

/// The angle in (−π, π] (rad).
fn wrapped(angle_rad: f64) -> f64 {
    let rest_rad = libm::remainder(angle_rad, TAU);
    if rest_rad <= -PI { rest_rad + TAU } else { rest_rad }
}

/// Something that follows its order with a first-order lag: a thruster, a tug's pull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lag {
    /// Where it is, in the quantity's own unit.
    pub value: f64,
    /// Time constant (s); 0 follows at once.
    pub time_constant_s: f64,
}

impl Lag {
    /// Closes 1 − e^{−Δt/τ} of the difference to the order.
    pub fn step(&mut self, order: f64, step_s: f64) {
        if self.time_constant_s <= 0.0 {
            self.value = order;
            return;
        }
        let left = libm::exp(-step_s / self.time_constant_s);
        self.value = order + (self.value - order) * left;
    }
}

/// Engine telegraph.
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
    /// Every step, from full astern to full ahead at sea.
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

    /// Revolutions as a part of those at sea. Typical of slow-running ships, not of any one of them: a
    /// vessel with a table of her own uses that.
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
