//! Joins two forms of the hull force for all directions of motion: the MMG polynomial under way, the low-speed form
//! otherwise.
//!
//! The weight of the polynomial depends only on the *direction* of the motion: on drift and on yaw, each by itself. A
//! manoeuvring polynomial is fitted in a limited range: drift angles up to 20° or so, yaw rates rL/U up to 1 or so.
//! Beyond the range of the fit, the cubic terms of the polynomial do not describe the hull.
//!
//! | | the polynomial alone | the low-speed form alone |
//! |---|---|---|
//! | drift ahead, deep water | up to 31° | from 46° |
//! | drift angle of a ship going ahead, in 1.5 draughts of water | up to 19° | from 31° |
//! | drift angle of a ship going ahead, in 1.1 draughts of water | up to 15° | from 27° |
//! | yaw rate rL/U | up to 1.5 | from 3 |
//!
//! The limits of the drift angle decrease with draught over depth, because near the bottom a hull stalls earlier
//! ([`Stall`]). In shallow water ships also drift less in their turns: tankers of known particulars by 26° in deep
//! water, 21° at 2 draughts of water, 16° at 1.5 and 6° at 1.2. In turns with 35° of rudder and in zig-zags the
//! polynomial therefore acts alone (`tests/hydro_manoeuvres.rs`).
//!
//! The weight of the polynomial depends on direction and not on speed, because both forms are homogeneous of degree two
//! in (u, v, r). With a weight of degree zero the sum of the two forms is homogeneous of degree two as well. The sum of
//! the two forms is zero at rest, and its slope is at most proportional to the speed. There is no speed at which the
//! forms change: the polynomial applies down to dead slow ahead, and a ship that crabs or turns on the spot has the
//! cross-flow form at any speed.

use super::added_mass::AddedMass;
use super::low_speed::LowSpeedHull;
use super::particulars::Particulars;
use super::polynomial::{Polynomial, coriolis};
use super::quantities::{Force, Velocity, Water, smooth_step};
use super::stall::Stall;

/// Up to the first value of |v|/U only the polynomial is used, and from the second value on only the low-speed form.
/// The two limits of |v|/U are for deep water.
const DRIFT: [f64; 2] = [0.52, 0.72];
/// How much the two limits of |v|/U decrease for each unit of draught over depth.
const DRIFT_BY_DEPTH: [f64; 2] = [0.285, 0.297];
/// The two limits of |r|L/U at any depth: up to the first only the polynomial is used, from the second on only the
/// low-speed form.
const YAW: [f64; 2] = [1.5, 3.0];

/// Hull coefficients for all directions of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hull {
    /// The polynomial for the ship under way; `None` if she has none.
    pub under_way: Option<Polynomial>,
    /// The low-speed form of the hull force, for all motions except those of a ship under way.
    pub low_speed: LowSpeedHull,
    /// The lift that the low-speed form loses as the drift increases.
    pub stall: Stall,
}

impl Hull {
    /// Makes the coefficients of a hull in deep water.
    pub fn deep(under_way: Option<Polynomial>, low_speed: LowSpeedHull) -> Hull {
        Hull { under_way, low_speed, stall: Stall::of(&low_speed, &low_speed, 0.0) }
    }

    /// Makes the coefficients of a hull that has a polynomial but no low-speed tests. [`LowSpeedHull::from_linear`]
    /// estimates the low-speed form of a hull without low-speed tests.
    pub fn from_polynomial(polynomial: Polynomial, ship: &Particulars, added: &AddedMass) -> Hull {
        let low_speed = LowSpeedHull::from_linear(&polynomial.linear(ship, added), ship);
        Hull::deep(Some(polynomial), low_speed)
    }

    /// Force of the hull at midship, with the Coriolis terms of the added mass, m_y v r and −m_x u r.
    pub fn force(
        &self,
        velocity: &Velocity,
        ship: &Particulars,
        added: &AddedMass,
        water: Water,
    ) -> Force {
        let low_speed = || {
            let form = self.stall.after(&self.low_speed, velocity);
            form.force(velocity, ship.length_m, ship.draught_m, water)
                + coriolis(velocity, added, water)
        };
        let Some(polynomial) = &self.under_way else { return low_speed() };
        let weight = polynomial_weight(velocity, ship.length_m, self.stall.draught_over_depth);
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

/// Weight of the polynomial in the hull force, 0 to 1; 0 at rest, astern and abeam.
///
/// The ratio `draught_over_depth` is 0 in deep water.
pub fn polynomial_weight(velocity: &Velocity, length_m: f64, draught_over_depth: f64) -> f64 {
    let speed_mps = velocity.speed_mps();
    if velocity.surge_mps <= 0.0 || speed_mps == 0.0 {
        return 0.0;
    }
    let drift = velocity.sway_mps.abs() / speed_mps;
    let yaw = velocity.yaw_radps.abs() * length_m / speed_mps;
    let [all, none] = [0, 1].map(|limit| DRIFT[limit] - DRIFT_BY_DEPTH[limit] * draught_over_depth);
    faded(drift, [all, none]) * faded(yaw, YAW)
}

/// Returns a weight: 1 up to the first limit, 0 from the second limit on, and a smooth step between.
fn faded(value: f64, [all, none]: [f64; 2]) -> f64 {
    1.0 - smooth_step((value - all) / (none - all))
}
