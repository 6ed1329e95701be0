//! Two bodies that may touch, and the constants of the pair.

use crate::maths::number::lesser;
use crate::model::material::{Material, MaterialId};
use crate::model::ranked::{Ranked, RankedBody};

/// Stands in place of an island's number for two bodies that both float: their island depends on the other candidates.
pub(crate) const JOINED: u32 = u32::MAX;

/// Two bodies that may touch, by rank, with the lower rank first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct RankedPair {
    pub(crate) a: u32,
    pub(crate) b: u32,
    pub(crate) material: MaterialId,
    /// Rank of the body that floats; [`JOINED`] if both bodies float.
    pub(crate) island: u32,
}

/// Bounds on the natural frequencies of a contact between two outlines. In most steps these bounds show that the
/// contact needs no sub-steps.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Bounds {
    /// Bounds on the squares of the rates of the contact's spring and damper (1/s²), for the inverse mass
    /// `inverse_mass` (1/kg).
    pub(crate) spring_rate_squared: f64,
    pub(crate) damping_rate_squared: f64,
    pub(crate) inverse_mass: f64,
    /// About half the width of the narrower body (m).
    pub(crate) half_width_m: f64,
    /// Half of the length of the longest chord that a contact of the pair can have (m).
    pub(crate) half_chord_m: f64,
    /// 1 if body B is the smaller body, 0 if body A is the smaller body.
    pub(crate) b_is_smaller: f64,
    pub(crate) bodies: [InverseMassBound; 2],
}

/// Upper bounds on a body's inverse mass at a contact.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct InverseMassBound {
    /// The largest inverse mass of the body in any direction, without rotation (1/kg).
    pub(crate) lightest_inverse_mass: f64,
    /// Inverse of the body's yaw inertia (1/(kg·m²)).
    pub(crate) of_yaw: f64,
}

impl InverseMassBound {
    fn of(body: &RankedBody) -> InverseMassBound {
        InverseMassBound {
            lightest_inverse_mass: body.lightest_inverse_mass,
            of_yaw: body.inverse_of_turning,
        }
    }
}

impl RankedPair {
    /// Makes a pair of two bodies, at least one of which floats.
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
    /// Computes bounds that hold for every contact between the outlines of the pair.
    pub(crate) fn of(ranked: &Ranked, materials: &[Material], pair: &RankedPair) -> Bounds {
        let ranks = [pair.a as usize, pair.b as usize];
        let [a, b] = ranks.map(|rank| &ranked[rank]);
        let half_widths_m = ranks.map(|rank| ranked.rest(rank).half_width_m);
        let material = &materials[pair.material.0 as usize];
        // Twice the value without rotation: this allows for a contact off the centre.
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
            bodies: [a, b].map(InverseMassBound::of),
        }
    }
}

/// The longest chord of a contact of the pair (m): a chord is at most as long as the smaller body.
fn longest_chord_m(a: &RankedBody, b: &RankedBody) -> f64 {
    2.0 * lesser(a.radius_m, b.radius_m)
}
