//! Coefficients of the wind force on a ship.

/// Coefficients for one angle: X = ½ρV²·CX·A_F, Y = ½ρV²·CY·A_L, N = ½ρV²·CN·A_L·L.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WindCoefficients {
    /// CX; negative in a head wind.
    pub surge: f64,
    /// CY; positive for wind from the port side.
    pub sway: f64,
    /// CN about midship.
    pub yaw: f64,
}
