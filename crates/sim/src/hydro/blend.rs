//! One hull force for all directions of motion: the MMG polynomial under way, the low-speed form otherwise.
//!
//! The weight of the polynomial depends only on the *direction* of the motion. With c = u/√(u² + v² + (rL/2)²), the
//! cosine of the angle between the motion and straight ahead (yaw counted by the speed of the ship's ends), it is 1 for
//! c ≥ 0.8, 0 for c ≤ 0.4, and a smooth step between. In a 35° turn or a 20/20 zig-zag of the ships in the library c stays
//! above 0.8.
//!
//! Direction is used and not speed, because both forms are homogeneous of degree two in (u, v, r): with a weight of degree
//! zero their sum is so too. The sum is zero at rest, its slope is at most proportional to the speed, and there is no
//! transition speed: the polynomial applies down to dead slow ahead, and a ship that crabs or turns on the spot has the
//! cross-flow form at any speed. A polynomial in v', r' is not valid there, as r' is unbounded for small U.

use super::added_mass::AddedMass;
use super::low_speed::LowSpeedHull;
use super::mmg::{Polynomial, coriolis};
use super::particulars::Particulars;
use super::quantities::{Force, Velocity, Water, smooth_step};

/// c up to which only the low-speed form is used, and c from which on only the polynomial is.
const COSINES: [f64; 2] = [0.4, 0.8];

/// Hull coefficients for all directions of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hull {
    /// The polynomial under way, for a ship that has one.
    pub under_way: Option<Polynomial>,
    /// The low-speed form, for all other motions.
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
        // Most steps need only one of the two forms.
        if weight == 1.0 {
            return polynomial.force(velocity, ship, added, water);
        }
        if weight == 0.0 {
            return low_speed();
        }
        polynomial.force(velocity, ship, added, water) * weight + low_speed() * (1.0 - weight)
    }
}

/// Weight of the polynomial, 0 to 1; 0 at rest.
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
