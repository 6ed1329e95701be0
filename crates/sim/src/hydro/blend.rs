//! One hull force for every way of moving: the MMG polynomial under way, the low-speed form elsewhere.
//!
//! The weight of the polynomial depends on the *direction* of the motion alone:
//! c = u/√(u² + v² + (rL/2)²) is the cosine between the ship's motion and straight ahead, the yaw taken
//! with the speed of the ends of the ship. The polynomial counts alone for c ≥ 0.8, which holds throughout a
//! 35° turn or a 20/20 zig-zag of the ships here, not at all for c ≤ 0.4, and by a smooth step between.
//!
//! Why direction and not speed: both forms are homogeneous of degree two in (u, v, r). With a weight of
//! degree zero their mixture is so too. It is then zero at rest, steep nowhere (its slope is at most in
//! proportion to the speed), and needs no speed at which one form would take over from the other: the
//! polynomial keeps its meaning at dead slow ahead, and a ship that crabs or turns on the spot at any speed
//! has the cross-flow form. A polynomial in v', r' has no meaning there: r' grows without end as U falls.

use super::added_mass::AddedMass;
use super::low_speed::LowSpeedHull;
use super::mmg::{Polynomial, coriolis};
use super::particulars::Particulars;
use super::quantities::{Force, Velocity, Water, smooth_step};

/// c below which the low-speed form counts alone, and above which the polynomial does.
const COSINES: [f64; 2] = [0.4, 0.8];

/// Hull coefficients for every way of moving.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hull {
    /// The polynomial under way, for a ship that has one.
    pub under_way: Option<Polynomial>,
    /// Everything else.
    pub low_speed: LowSpeedHull,
}

impl Hull {
    /// A hull with a polynomial and no low-speed tests, estimated by [`LowSpeedHull::from_linear`].
    pub fn from_polynomial(polynomial: Polynomial, ship: &Particulars, added: &AddedMass) -> Hull {
        let low_speed = LowSpeedHull::from_linear(&polynomial.linear(ship, added), ship);
        Hull { under_way: Some(polynomial), low_speed }
    }

    /// Force at midship with the added mass' Coriolis terms, m_y v r and −m_x u r.
    pub fn force(
        &self,
        velocity: &Velocity,
        ship: &Particulars,
        added: &AddedMass,
        water: Water,
    ) -> Force {
        let low_speed = || {
            self.low_speed.force(velocity, ship.length_m, ship.draught_m, water)
                + coriolis(velocity, added, water)
        };
        let Some(polynomial) = &self.under_way else { return low_speed() };
        let weight = polynomial_weight(velocity, ship.length_m);
        // Most steps need only one of the two.
        if weight == 1.0 {
            return polynomial.force(velocity, ship, added, water);
        }
        if weight == 0.0 {
            return low_speed();
        }
        polynomial.force(velocity, ship, added, water) * weight + low_speed() * (1.0 - weight)
    }
}

/// How much the polynomial counts, 0 to 1; 0 at rest.
pub fn polynomial_weight(velocity: &Velocity, length_m: f64) -> f64 {
    let (u, v) = (velocity.surge_mps, velocity.sway_mps);
    let ends_mps = 0.5 * length_m * velocity.yaw_radps;
    let motion_mps = (u * u + v * v + ends_mps * ends_mps).sqrt();
    if motion_mps == 0.0 {
        return 0.0;
    }
    let [none, all] = COSINES;
    smooth_step((u / motion_mps - none) / (all - none))
}
