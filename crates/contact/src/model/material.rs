//! Indices of the parts of a model, and the contact parameters of materials.

/// Index of a body, in the order in which bodies were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct BodyId(pub u32);

/// Index of a material, in the order in which materials were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(pub u32);

/// Index of a fender, in the order in which fenders were added.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct FenderId(pub u32);

/// Contact parameters of a pair of bodies (Table 1 of the paper).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Area stiffness k (N/m²): the modulus of an elastic (Winkler) foundation.
    pub stiffness_npm2: f64,
    /// c, area damping (N·s/m²). For the area damping, Table 1 of the paper prints the unit kN·s/m.
    pub damping_nspm2: f64,
    /// k_s, shear stiffness (N/m).
    pub shear_stiffness_npm: f64,
    /// Coefficient of static friction μ_s.
    pub friction_static: f64,
    /// Coefficient of dynamic friction μ_k, at most μ_s.
    pub friction_dynamic: f64,
    /// Coefficient of restitution γ, from 0 to 1. With a coefficient of 0, the contact returns no energy. In the
    /// coupled method, a ship with γ = 0 stays at her largest penetration, even if a smaller load holds her there.
    pub restitution: f64,
}
