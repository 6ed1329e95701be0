//! A mooring winch: what its brake holds, and what its motor hauls.

use fenderline_contact::number::bounded;

use crate::range::{OutOfRange, within};

/// A winch with a band brake on a split drum.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Winch {
    /// Tension at which the brake renders (N).
    pub render_n: f64,
    /// Tension against which the motor heaves no more (N).
    pub stall_n: f64,
    /// Greatest rate of heaving and paying out (m/s).
    pub rate_mps: f64,
    /// Rope left on the drum at the start (m).
    pub reserve_m: f64,
}

/// What a winch is told to do for a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum WinchOrder {
    /// Brake on.
    #[default]
    Hold,
    /// Heave in (m/s).
    Heave(f64),
    /// Pay out (m/s).
    PayOut(f64),
}

/// What happened at the winch in a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WinchReport {
    /// Rope that the brake let go (m); 0 where it held.
    pub rendered_m: f64,
    /// The motor heaved less than it was told, because of the tension.
    pub stalled: bool,
    /// An order beyond the winch's rate, or none of a number: the rate was held to its limit.
    pub rate_limited: bool,
    /// The drum is empty.
    pub drum_empty: bool,
    /// An order to heave or pay out to a line that is on bitts; nothing was done.
    pub no_winch: bool,
}

impl Winch {
    /// A winch for a ship design MBL: brake set to render at 60 %, motor 30 % (both found in public
    /// summaries of MEG4 and of brake tests: 60 %, pull 22 to 33 %), 0.25 m/s (assumed).
    #[must_use]
    pub fn of_design(ship_design_mbl_n: f64, reserve_m: f64) -> Winch {
        Winch {
            render_n: 0.6 * ship_design_mbl_n,
            stall_n: 0.3 * ship_design_mbl_n,
            rate_mps: 0.25,
            reserve_m,
        }
    }

    pub(super) fn check(&self) -> Result<(), OutOfRange> {
        within("render tension of the winch [N]", self.render_n, 1.0, 1e9)?;
        within("stall tension of the winch [N]", self.stall_n, 0.0, 1e9)?;
        within("rate of the winch [m/s]", self.rate_mps, 0.0, 20.0)?;
        within("rope on the drum [m]", self.reserve_m, 0.0, 1e5)?;
        Ok(())
    }

    /// Rope that an order moves in a step, out positive (m), its rate within the winch's.
    pub(super) fn ordered_m(&self, order: WinchOrder, step_s: f64, notes: &mut WinchReport) -> f64 {
        let (sign, rate_mps) = match order {
            WinchOrder::Hold => return 0.0,
            WinchOrder::Heave(rate_mps) => (-1.0, rate_mps),
            WinchOrder::PayOut(rate_mps) => (1.0, rate_mps),
        };
        notes.rate_limited = rate_mps.is_nan() || rate_mps < 0.0 || rate_mps > self.rate_mps;
        // A rate that is no number moves nothing.
        let rate_mps = if rate_mps.is_nan() { 0.0 } else { bounded(rate_mps, 0.0, self.rate_mps) };
        sign * rate_mps * step_s
    }
}
