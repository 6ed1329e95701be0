//! Units of variables.

/// The SI unit of an FMU variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unit {
    /// A variable without a unit: a pure number, a count or a switch.
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
    /// N·s
    NewtonSecond,
    /// J
    Joule,
}

impl Unit {
    /// Name of the unit in a model description; `None` for a pure number.
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
            Unit::NewtonSecond => "N.s",
            Unit::Joule => "J",
        })
    }

    /// The unit of a summary quantity, found by the unit's symbol in the catalogue of quantities.
    ///
    /// # Panics
    /// Panics for a symbol that is not the unit of any variable of an FMU; the tests try the symbols of all quantities.
    pub(crate) fn of_symbol(symbol: &str) -> Unit {
        match symbol {
            "1" => Unit::One,
            "s" => Unit::Second,
            "m" => Unit::Metre,
            "rad" => Unit::Radian,
            "m/s" => Unit::MetrePerSecond,
            "N" => Unit::Newton,
            "N/m²" => Unit::NewtonPerSquareMetre,
            "N·s" => Unit::NewtonSecond,
            "J" => Unit::Joule,
            _ => panic!("an FMU has no variable whose unit is {symbol}"),
        }
    }

    /// The powers of kg, m, s and rad of which the unit is the product.
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
            Unit::NewtonSecond => [1, 1, -1, 0],
            Unit::NewtonMetre | Unit::Joule => [1, 2, -2, 0],
            Unit::NewtonPerMetre => [1, 0, -2, 0],
            Unit::NewtonPerSquareMetre => [1, -1, -2, 0],
            Unit::NewtonSecondPerSquareMetre => [1, -1, -1, 0],
        }
    }
}
