//! Units of the tables that people read.

use core::f64::consts::PI;

/// A unit of the tables that people read, and how a value in SI becomes a number in this unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scale {
    /// The unit, such as `kN`; empty for words.
    pub unit: &'static str,
    by: By,
}

#[derive(Clone, Copy, Debug, PartialEq)]
enum By {
    Times(f64),
    Per(f64),
}

impl Scale {
    const fn times(unit: &'static str, factor: f64) -> Scale {
        Scale { unit, by: By::Times(factor) }
    }

    const fn per(unit: &'static str, divisor: f64) -> Scale {
        Scale { unit, by: By::Per(divisor) }
    }

    /// Converts a value in SI to this unit, rounded once.
    #[must_use]
    pub fn of(self, value: f64) -> f64 {
        match self.by {
            By::Times(factor) => value * factor,
            By::Per(divisor) => value / divisor,
        }
    }

    /// Multiplies a value in SI by the factor of this unit. The tables of campaigns hold this product, whose last bit
    /// can differ from that of [`Scale::of`].
    #[must_use]
    pub fn product(self, value: f64) -> f64 {
        match self.by {
            By::Times(factor) => value * factor,
            By::Per(divisor) => value * (1.0 / divisor),
        }
    }

    /// The unit in report and workbook, where the unit of an energy is `kJ (kN·m)`.
    #[must_use]
    pub fn page_unit(self) -> &'static str {
        if self.unit == "kJ" { "kJ (kN·m)" } else { self.unit }
    }

    /// The unit in plain letters, for a terminal.
    #[must_use]
    pub fn plain_unit(self) -> String {
        self.unit.replace('²', "2").replace('·', " ")
    }
}

/// The units that tables use.
pub mod scales {
    use super::{PI, Scale};
    use fenderline_sim::constants::{KNOT_MPS, STANDARD_GRAVITY_MPS2};

    /// A word, which has no unit.
    pub const WORD: Scale = Scale::times("", 1.0);
    /// A pure number.
    pub const FACTOR: Scale = Scale::times("–", 1.0);
    /// A share.
    pub const PERCENT: Scale = Scale::times("%", 100.0);
    /// Times.
    pub const SECONDS: Scale = Scale::times("s", 1.0);
    /// Lengths.
    pub const METRES: Scale = Scale::times("m", 1.0);
    /// Deflections.
    pub const MILLIMETRES: Scale = Scale::times("mm", 1e3);
    /// Angles.
    pub const DEGREES: Scale = Scale::times("deg", 180.0 / PI);
    /// Rates of turn.
    pub const DEGREES_PER_SECOND: Scale = Scale::times("deg/s", 180.0 / PI);
    /// Degrees per minute, for the rates of turn of ships.
    pub const DEGREES_PER_MINUTE: Scale = Scale::times("deg/min", 60.0 * (180.0 / PI));
    /// Speeds.
    pub const METRES_PER_SECOND: Scale = Scale::times("m/s", 1.0);
    /// Speeds.
    pub const KNOTS: Scale = Scale::per("kn", KNOT_MPS);
    /// Forces.
    pub const KILONEWTONS: Scale = Scale::per("kN", 1e3);
    /// Forces, as tonnes.
    pub const TONNES_FORCE: Scale = Scale::per("t", 1e3 * STANDARD_GRAVITY_MPS2);
    /// Masses.
    pub const TONNES: Scale = Scale::per("t", 1e3);
    /// Energies.
    pub const KILOJOULES: Scale = Scale::per("kJ", 1e3);
    /// Impulses.
    pub const KILONEWTON_SECONDS: Scale = Scale::per("kN·s", 1e3);
    /// Pressures.
    pub const KILONEWTONS_PER_M2: Scale = Scale::per("kN/m²", 1e3);
    /// Stiffnesses.
    pub const MEGANEWTONS_PER_M: Scale = Scale::per("MN/m", 1e6);
}
