//! Units of variables.

/// The unit of a variable; all are SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unit {
    /// A pure number, a count or a switch.
    One,
    /// s
    Second,
    /// m
    Metre,
    /// m²
    SquareMetre,
    /// rad
    Radian,
    /// m/s
    MetrePerSecond,
    /// rad/s
    RadianPerSecond,
    /// 1/s
    PerSecond,
    /// kg
    Kilogram,
    /// kg·m²
    KilogramSquareMetre,
    /// N
    Newton,
    /// N·m
    NewtonMetre,
    /// N/m
    NewtonPerMetre,
    /// N/m²
    NewtonPerSquareMetre,
    /// N·s/m²
    NewtonSecondPerSquareMetre,
    /// J
    Joule,
}

impl Unit {
    /// Name in a model description; `None` for a pure number.
    pub(crate) fn name(self) -> Option<&'static str> {
        Some(match self {
            Unit::One => return None,
            Unit::Second => "s",
            Unit::Metre => "m",
            Unit::SquareMetre => "m2",
            Unit::Radian => "rad",
            Unit::MetrePerSecond => "m/s",
            Unit::RadianPerSecond => "rad/s",
            Unit::PerSecond => "1/s",
            Unit::Kilogram => "kg",
            Unit::KilogramSquareMetre => "kg.m2",
            Unit::Newton => "N",
            Unit::NewtonMetre => "N.m",
            Unit::NewtonPerMetre => "N/m",
            Unit::NewtonPerSquareMetre => "N/m2",
            Unit::NewtonSecondPerSquareMetre => "N.s/m2",
            Unit::Joule => "J",
        })
    }

    /// Exponents of kg, m, s and rad.
    pub(crate) fn exponents(self) -> [i32; 4] {
        match self {
            Unit::One => [0, 0, 0, 0],
            Unit::Second => [0, 0, 1, 0],
            Unit::Metre => [0, 1, 0, 0],
            Unit::SquareMetre => [0, 2, 0, 0],
            Unit::Radian => [0, 0, 0, 1],
            Unit::MetrePerSecond => [0, 1, -1, 0],
            Unit::RadianPerSecond => [0, 0, -1, 1],
            Unit::PerSecond => [0, 0, -1, 0],
            Unit::Kilogram => [1, 0, 0, 0],
            Unit::KilogramSquareMetre => [1, 2, 0, 0],
            Unit::Newton => [1, 1, -2, 0],
            Unit::NewtonMetre | Unit::Joule => [1, 2, -2, 0],
            Unit::NewtonPerMetre => [1, 0, -2, 0],
            Unit::NewtonPerSquareMetre => [1, -1, -2, 0],
            Unit::NewtonSecondPerSquareMetre => [1, -1, -1, 0],
        }
    }
}
