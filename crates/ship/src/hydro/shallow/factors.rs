//! The effects of shallow water on a ship, as factors on her coefficients in deep water.

/// Factors of shallow water on the derivatives of a hull, each named as in [`crate::hydro::SwayPolynomial`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[allow(
    missing_docs,
    reason = "the index of each coefficient in the method's notation is its powers of v' and r'"
)]
pub struct HullFactors {
    /// Factor of shallow water on the resistance, ahead and astern.
    pub resistance: f64,
    pub x_vv: f64,
    /// Factor of shallow water on the sum (m_y + X_vr), which is X_vr with the Coriolis term of the added mass.
    pub x_vr: f64,
    pub x_rr: f64,
    pub x_vvvv: f64,
    pub y_v: f64,
    /// Factor of shallow water on the derivative Y_r, without the −m_x of the added mass.
    pub y_r: f64,
    pub y_vvv: f64,
    pub y_vvr: f64,
    pub y_vrr: f64,
    pub y_rrr: f64,
    pub n_v: f64,
    pub n_r: f64,
    pub n_vvv: f64,
    pub n_vvr: f64,
    pub n_vrr: f64,
    pub n_rrr: f64,
}

/// Factors of shallow water on propeller and rudder behind the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SternFactors {
    /// Factor of shallow water on 1 − t (t: thrust deduction), for thrust ahead.
    pub driving: f64,
    /// Factor of shallow water on the wake fraction w.
    pub wake: f64,
    /// Factor of shallow water on 1 − w (w: wake fraction), applied after [`SternFactors::wake`].
    pub inflow: f64,
    /// Factor of shallow water on the flow straightening γ_R at the rudder, for both sides.
    pub straightening: f64,
}

/// Factors of shallow water on the added mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MassFactors {
    /// In surge.
    pub surge: f64,
    /// In sway.
    pub sway: f64,
    /// In yaw.
    pub yaw: f64,
}

/// All corrections of a ship for a depth of water.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corrections {
    /// Hull.
    pub hull: HullFactors,
    /// Propeller and rudder.
    pub stern: SternFactors,
    /// Added mass.
    pub mass: MassFactors,
}
