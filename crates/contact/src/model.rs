//! The constant part of a contact problem: bodies, materials and who may touch whom.

use alloc::string::String;
use alloc::vec::Vec;

use crate::outline::Outline;
use crate::error::ModelError;

/// Index of a body, in the order in which bodies were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub u32);

/// Index of a material, in the order in which materials were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u32);

/// Contact parameters of a pair of bodies (Table 1 of the paper).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// k, area stiffness [N/m²]: the modulus of an elastic (Winkler) foundation.
    pub stiffness_npm2: f64,
    /// c, area damping [N·s/m²] (the paper's Table 1 prints kN·s/m).
    pub damping_nspm2: f64,
    /// k_s, shear stiffness [N/m].
    pub shear_stiffness_npm: f64,
    /// μ_s, coefficient of static friction.
    pub friction_static: f64,
    /// μ_k, coefficient of dynamic friction, at most μ_s.
    pub friction_dynamic: f64,
    /// γ, coefficient of restitution, 0 to 1.
    pub restitution: f64,
}

/// How a body answers a force, as the limiter of eq. 9–26 sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mobility {
    /// A quay or a fender on it: infinite mass, inverse mass zero.
    Fixed,
    /// A floating body.
    Free {
        /// Displacement plus the smallest added mass (§3.1 of the paper) [kg].
        mass_kg: f64,
        /// Moment of inertia about the vertical through the centre of gravity [kg·m²].
        yaw_inertia_kgm2: f64,
    },
}

/// A body as the engine knows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    /// Name, used in errors.
    pub name: String,
    /// Fixes the order of all sums and the content of snapshots, whatever the order in which
    /// bodies are added; unique in a model.
    pub key: u64,
    /// Outline in the body's frame, origin at the centre of gravity.
    pub outline: Outline,
    /// Mass and inertia.
    pub mobility: Mobility,
}

/// Two bodies that may touch, and with which material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pair {
    /// The two bodies, in any order.
    pub bodies: [BodyId; 2],
    /// Their common material.
    pub material: MaterialId,
}
