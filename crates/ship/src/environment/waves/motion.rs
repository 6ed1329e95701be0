//! First-order motion of a ship in a sea, by response amplitude operators.

use fenderline_contact::Vec2;

use super::box_ship::BoxShip;
use super::complex::Complex;
use super::rao::RaoTable;
use super::sea::Sea;

/// The response of a ship to waves.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionResponse {
    /// The response is a table of response amplitude operators, computed or measured elsewhere.
    Table(RaoTable),
    /// The built-in estimate. The response is estimated from the ship's particulars, and reports say so.
    Estimate(BoxShip),
}

/// Position, velocity and heading of a ship in waves.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ShipInWaves {
    /// Position of the ship's midship point, north and east (m).
    pub position_m: Vec2,
    /// Velocity of the ship, north and east (m/s).
    pub velocity_mps: Vec2,
    /// Heading (rad).
    pub heading_rad: f64,
}

/// Motion of a ship due to first-order wave forces, to be added to her manoeuvring motion: surge, sway, heave down (m),
/// roll to starboard, pitch bow up, yaw (rad).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FirstOrderMotion {
    /// The motion.
    pub motion: [f64; 6],
    /// Rates of change of the motions (m/s, rad/s); the frequency of encounter includes the effect of the ship's speed.
    pub rate: [f64; 6],
}

impl MotionResponse {
    fn at(&self, frequency_radps: f64, direction_rad: f64, ahead_mps: f64) -> [Complex; 6] {
        match self {
            MotionResponse::Table(table) => table.at(frequency_radps, direction_rad),
            MotionResponse::Estimate(ship) => ship.at(frequency_radps, direction_rad, ahead_mps),
        }
    }
}

/// The motion of a ship in a sea at a time: Σ Re{H(ω, μ)·a·e^{i(ωt − k·x + ε)}} at her midship point x. The ship's
/// position is in the phase of each harmonic, so the frequency of encounter is included.
#[must_use]
pub fn first_order_motion(
    sea: &Sea,
    response: &MotionResponse,
    ship: &ShipInWaves,
    t_s: f64,
) -> FirstOrderMotion {
    let (sin, cos) = (libm::sin(ship.heading_rad), libm::cos(ship.heading_rad));
    let ahead_mps = ship.velocity_mps.x * cos + ship.velocity_mps.y * sin;
    let mut sum = FirstOrderMotion::default();
    for c in &sea.components {
        let direction_rad = sea.directions_rad[c.direction] - ship.heading_rad;
        let operators = response.at(c.frequency_radps, direction_rad, ahead_mps);
        let angle_rad = c.angle_rad(ship.position_m, t_s);
        let wave = Complex::new(libm::cos(angle_rad), libm::sin(angle_rad)) * c.amplitude_m;
        let encounter_radps = c.frequency_radps - c.number_radpm.dot(ship.velocity_mps);
        for (k, operator) in operators.into_iter().enumerate() {
            let moved = operator * wave;
            sum.motion[k] += moved.re;
            // d/dt Re{z e^{iω_e t}} = −ω_e Im{…}.
            sum.rate[k] -= encounter_radps * moved.im;
        }
    }
    sum
}
