//! Indices of the parts of a model, and contact parameters.

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
    /// k, area stiffness (N/m²): the modulus of an elastic (Winkler) foundation.
    pub stiffness_npm2: f64,
    /// c, area damping (N·s/m²). The paper's Table 1 prints kN·s/m.
    pub damping_nspm2: f64,
    /// k_s, shear stiffness (N/m).
    pub shear_stiffness_npm: f64,
    /// μ_s, coefficient of static friction.
    pub friction_static: f64,
    /// μ_k, coefficient of dynamic friction, at most μ_s.
    pub friction_dynamic: f64,
    /// γ, coefficient of restitution, 0 to 1. With 0 no energy is returned. In the coupled method, a ship then stays at
    /// her largest penetration, even if a smaller load holds her there.
    pub restitution: f64,
}
