//! A mooring winch: brake and motor.

use fenderline_contact::number::bounded;

use crate::range::{OutOfRange, within};

/// A winch with a band brake on a split drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winch {
    /// Tension of the line at which the winch's brake renders (N).
    pub render_n: f64,
    /// Tension of the line at which the winch's motor stalls (N).
    pub stall_n: f64,
    /// Largest rate at which the winch heaves and pays out (m/s).
    pub rate_mps: f64,
    /// Length of rope on the winch's drum at the start (m).
    pub reserve_m: f64,
    /// The automatic control that holds a tension while the order is [`WinchOrder::Hold`]; with `None` the brake holds
    /// the line.
    pub constant_tension: Option<ConstantTension>,
}

/// The automatic control of a constant-tension winch. A constant-tension winch pays out while the tension is above a
/// band around the set tension. A constant-tension winch heaves in while the tension is below the band. Motions of the
/// ship that are faster than the winch's speeds bring the tension outside the band. The brake of a constant-tension
/// winch renders as on other winches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantTension {
    /// The set tension (N).
    pub tension_n: f64,
    /// Half of the width of the tension band, as a share of the set tension: at or above 0 and below 1.
    pub band: f64,
    /// The largest speed at which the winch heaves in (m/s).
    pub heave_mps: f64,
    /// The largest speed at which the winch pays out (m/s).
    pub pay_out_mps: f64,
}

impl ConstantTension {
    /// The edges of the tension band (N).
    pub(super) fn edges_n(&self) -> [f64; 2] {
        [-self.band, self.band].map(|band| self.tension_n * (1.0 + band))
    }

    fn check(&self, render_n: f64) -> Result<(), OutOfRange> {
        within("set tension of the winch [N]", self.tension_n, 1.0, 1e9)?;
        within("band of the winch's tension", self.band, 0.0, 0.9)?;
        within("upper edge of the winch's tension [N]", self.edges_n()[1], 1.0, render_n)?;
        within("speed of heaving in [m/s]", self.heave_mps, 0.0, 20.0)?;
        within("speed of paying out [m/s]", self.pay_out_mps, 0.0, 20.0)?;
        Ok(())
    }
}

/// The order to a winch for a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum WinchOrder {
    /// Brake on. The winch holds: the brake holds the line, or a constant-tension winch holds its tension.
    #[default]
    Hold,
    /// Heave in (m/s).
    Heave(f64),
    /// Pay out (m/s).
    PayOut(f64),
}

/// Report of a winch in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WinchReport {
    /// Length of rope that slipped off because the brake rendered (m); 0 if the brake held.
    pub rendered_m: f64,
    /// Whether the winch's motor stalled: it heaved less than ordered because of the tension.
    pub stalled: bool,
    /// Whether the ordered rate of the winch was limited, because it was above the winch's maximum, negative or NaN.
    pub rate_limited: bool,
    /// Whether the winch's drum is empty.
    pub drum_empty: bool,
    /// Whether the order was to heave or pay out a line on bitts, which has no effect.
    pub no_winch: bool,
}

impl Winch {
    /// Makes a winch for a ship design minimum breaking load (MBL). The winch's brake renders at 60 % of the ship
    /// design MBL and its motor pulls 30 % (both found in public summaries of MEG4 and of brake tests, which have 60 %
    /// and a pull of 22 to 33 %). The winch's rate is 0.25 m/s (our assumption).
    #[must_use]
    pub fn of_design(ship_design_mbl_n: f64, reserve_m: f64) -> Winch {
        Winch {
            render_n: 0.6 * ship_design_mbl_n,
            stall_n: 0.3 * ship_design_mbl_n,
            rate_mps: 0.25,
            reserve_m,
            constant_tension: None,
        }
    }

    pub(super) fn check(&self) -> Result<(), OutOfRange> {
        within("render tension of the winch [N]", self.render_n, 1.0, 1e9)?;
        within("stall tension of the winch [N]", self.stall_n, 0.0, 1e9)?;
        within("rate of the winch [m/s]", self.rate_mps, 0.0, 20.0)?;
        within("rope on the drum [m]", self.reserve_m, 0.0, 1e5)?;
        self.constant_tension.map_or(Ok(()), |automatic| automatic.check(self.render_n))
    }

    /// Length by which an order moves the line in a step within the winch's maximum rate, positive outboard (m).
    pub(super) fn ordered_m(
        &self,
        order: WinchOrder,
        step_s: f64,
        report: &mut WinchReport,
    ) -> f64 {
        let (sign, rate_mps) = match order {
            WinchOrder::Hold => return 0.0,
            WinchOrder::Heave(rate_mps) => (-1.0, rate_mps),
            WinchOrder::PayOut(rate_mps) => (1.0, rate_mps),
        };
        report.rate_limited = rate_mps.is_nan() || rate_mps < 0.0 || rate_mps > self.rate_mps;
        // A NaN rate moves nothing.
        let rate_mps = if rate_mps.is_nan() { 0.0 } else { bounded(rate_mps, 0.0, self.rate_mps) };
        sign * rate_mps * step_s
    }
}
