//! A mooring winch: brake and motor.

use fenderline_contact::number::bounded;

use crate::range::{OutOfRange, within};

/// A winch with a band brake on a split drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winch {
    /// Tension at which the brake renders (N).
    pub render_n: f64,
    /// Tension at which the motor stalls (N).
    pub stall_n: f64,
    /// Maximum rate of heaving and paying out (m/s).
    pub rate_mps: f64,
    /// Rope on the drum at the start (m).
    pub reserve_m: f64,
    /// The automatic control that holds a tension while the order is [`WinchOrder::Hold`]; `None`: the brake holds the
    /// line.
    pub constant_tension: Option<ConstantTension>,
}

/// The automatic control of a constant-tension winch. The winch pays out if the tension is above a band around the set
/// tension, down to the band. The winch heaves in if the tension is below the band, up to the band. Motions faster than
/// the winch's speeds leave the tension outside the band. The brake renders as on other winches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ConstantTension {
    /// The set tension (N).
    pub tension_n: f64,
    /// Half of the width of the band, as a share of the set tension: at or above 0 and below 1.
    pub band: f64,
    /// The largest speed of heaving in (m/s).
    pub heave_mps: f64,
    /// The largest speed of paying out (m/s).
    pub pay_out_mps: f64,
}

impl ConstantTension {
    /// The edges of the band (N).
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
    /// Brake on. A constant-tension winch holds its tension.
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
    /// Length of rope rendered by the brake (m); 0 if it held.
    pub rendered_m: f64,
    /// Whether the motor stalled: it heaved less than ordered because of the tension.
    pub stalled: bool,
    /// Whether the ordered rate was limited: it was above the winch's maximum, negative or NaN.
    pub rate_limited: bool,
    /// Whether the drum is empty.
    pub drum_empty: bool,
    /// Whether the order was to heave or pay out a line on bitts, which has no effect.
    pub no_winch: bool,
}

impl Winch {
    /// A winch for a ship design MBL. The brake renders at 60 % and the motor pulls 30 % (both found in public
    /// summaries of MEG4 and of brake tests: 60 %, pull 22 to 33 %). The rate is 0.25 m/s (assumed).
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

    /// Length that an order moves in a step within the winch's maximum rate, positive outboard (m).
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
