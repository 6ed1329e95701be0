//! Coefficients of the wind force on a ship.

/// Wind coefficients for one angle of the wind: X = ½ρV²·CX·A_F, Y = ½ρV²·CY·A_L, N = ½ρV²·CN·A_L·L.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WindCoefficients {
    /// Coefficient CX of the longitudinal wind force; negative in a head wind.
    pub surge: f64,
    /// Coefficient CY of the lateral wind force; positive for wind from the port side.
    pub sway: f64,
    /// CN about midship.
    pub yaw: f64,
}
