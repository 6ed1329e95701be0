//! Two bodies that may touch, and what is so of them in every step.

use crate::model::{MaterialId, Model};
use crate::number::lesser;
use crate::ranked::RankedBody;

/// Stands for the island of two bodies that both float: which it is depends on who else is near.
pub(crate) const JOINED: u32 = u32::MAX;

/// Two bodies by rank, the lower first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RankedPair {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) material: MaterialId,
    /// The one of the two that floats; [`JOINED`] where both do.
    pub(crate) island: u32,
}

/// Bounds that tell, in most steps, that a contact of two outlines needs no sub-steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bounds {
    /// On the squares of the rates of spring and of damper (1/s²), for this inverse mass (1/kg).
    pub(crate) spring_rate_squared: f64,
    pub(crate) damping_rate_squared: f64,
    pub(crate) inverse_mass: f64,
    /// About half the width of the narrower body (m).
    pub(crate) half_width_m: f64,
    /// Half of the longest chord (m).
    pub(crate) half_chord_m: f64,
    /// 1 where B is the smaller body, 0 where A is.
    pub(crate) b_is_smaller: f64,
    pub(crate) yields: [Yielding; 2],
}

/// Bounds on how a body answers a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Yielding {
    /// The largest inverse mass in any direction, without rotation (1/kg).
    pub(crate) lightest_inverse_mass: f64,
    /// Inverse of the inertia in yaw (1/(kg·m²)).
    pub(crate) of_turning: f64,
}

impl Yielding {
    fn of(body: &RankedBody) -> Yielding {
        Yielding {
            lightest_inverse_mass: body.lightest_inverse_mass,
            of_turning: body.inverse_of_turning,
        }
    }

    /// Does it not yield at all?
    // By the bits: asked of a number, it would be asked for NaN too.
    #[inline]
    pub(crate) fn is_fixed(&self) -> bool {
        self.lightest_inverse_mass.to_bits() == 0
    }
}

impl RankedPair {
    /// Of two bodies of which one floats at least.
    pub(crate) fn new(
        (a, body_a): (u32, &RankedBody),
        (b, body_b): (u32, &RankedBody),
        material: MaterialId,
    ) -> RankedPair {
        let island = match (body_a.is_fixed(), body_b.is_fixed()) {
            (true, _) => b,
            (_, true) => a,
            _ => JOINED,
        };
        RankedPair { a, b, material, island }
    }
}

impl Bounds {
    pub(crate) fn of(model: &Model, pair: &RankedPair) -> Bounds {
        let ranks = [pair.a as usize, pair.b as usize];
        let [a, b] = ranks.map(|rank| &model.ranked[rank]);
        let half_widths_m = ranks.map(|rank| model.ranked.rest(rank).half_width_m);
        let material = &model.materials()[pair.material.0 as usize];
        // Twice that without rotation allows for a contact off the centre.
        let inverse_mass = 2.0 * (a.lightest_inverse_mass + b.lightest_inverse_mass);
        let per_force = longest_chord_m(a, b) * inverse_mass;
        let damping_rate = material.damping_nspm2 * per_force;
        Bounds {
            spring_rate_squared: material.stiffness_npm2 * per_force,
            damping_rate_squared: damping_rate * damping_rate,
            inverse_mass,
            half_width_m: lesser(half_widths_m[0], half_widths_m[1]),
            half_chord_m: 0.5 * longest_chord_m(a, b),
            b_is_smaller: if a.radius_m <= b.radius_m { 0.0 } else { 1.0 },
            yields: [a, b].map(Yielding::of),
        }
    }
}

/// A chord is at most as long as the smaller body (m).
fn longest_chord_m(a: &RankedBody, b: &RankedBody) -> f64 {
    2.0 * lesser(a.radius_m, b.radius_m)
}
