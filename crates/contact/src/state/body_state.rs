//! The state of a body, which the host passes to each step.

use crate::maths::vec2::{Pose, Vec2};

/// Largest coordinate of a position (m). A larger coordinate is a mistake of the host, and forces could overflow.
pub(crate) const FURTHEST_M: f64 = 1e9;

/// Velocity of a body's centre of gravity, earth-fixed, and its rate of turn (m/s, rad/s).
pub(crate) type Velocity = (Vec2, f64);

/// State of a body at the start of a step, in earth-fixed axes.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyState {
    /// Position of the body's centre of gravity: north, east (m).
    pub position_m: Vec2,
    /// Heading ψ of the body, clockwise from north (rad).
    pub heading_rad: f64,
    /// Velocity of the body's centre of gravity: north, east (m/s).
    pub velocity_mps: Vec2,
    /// Rate of turn of the body, positive to starboard (rad/s).
    pub yaw_rate_radps: f64,
}

impl BodyState {
    /// Position and attitude.
    #[must_use]
    #[inline]
    pub fn pose(&self) -> Pose {
        Pose::new(self.position_m, self.heading_rad)
    }

    #[inline]
    pub(crate) fn velocity(&self) -> Velocity {
        (self.velocity_mps, self.yaw_rate_radps)
    }

    /// Returns zero if the two states are equal bit for bit.
    #[inline(always)]
    pub(crate) fn apart(&self, other: &BodyState) -> u64 {
        let bits = |state: &BodyState| {
            let BodyState { position_m, velocity_mps, heading_rad, yaw_rate_radps } = *state;
            [
                position_m.x,
                position_m.y,
                velocity_mps.x,
                velocity_mps.y,
                heading_rad,
                yaw_rate_radps,
            ]
            .map(f64::to_bits)
        };
        bits(self).iter().zip(bits(other)).fold(0, |apart, (one, two)| apart | (one ^ two))
    }

    /// Returns true if the body neither moves nor turns.
    #[inline]
    pub(crate) fn is_at_rest(&self) -> bool {
        // At rest, all bits but the signs are zero. One test covers all three numbers.
        let Vec2 { x, y } = self.velocity_mps;
        (x.to_bits() | y.to_bits() | self.yaw_rate_radps.to_bits()) << 1 == 0
    }

    /// Velocity of the material point of the body at the earth-fixed place `point_m` (eq. 14) (m/s).
    #[must_use]
    #[inline]
    pub fn velocity_at(&self, point_m: Vec2) -> Vec2 {
        self.velocity_mps + (point_m - self.position_m).spun_by(self.yaw_rate_radps)
    }
}
