//! Dimensions: exponents of length, mass, time and angle.

use core::fmt;

/// The dimension of a quantity: the exponents of the base units. The plane angle counts as a base unit, so that a rate
/// of turn is not a frequency and a heading is not a plain number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Dimension {
    metre: i8,
    kilogram: i8,
    second: i8,
    radian: i8,
}

impl Dimension {
    pub(super) const NONE: Dimension = Dimension::new(0, 0, 0, 0);

    pub(super) const fn new(metre: i8, kilogram: i8, second: i8, radian: i8) -> Dimension {
        Dimension { metre, kilogram, second, radian }
    }

    /// The dimension with a force in place of the mass, for a user who writes a mass and means its weight.
    pub fn of_weight(self) -> Option<Dimension> {
        self.times(Dimension::new(1, 0, -2, 0), 1)
    }

    /// The dimension `self · other^power`; `None` beyond the 127th power.
    pub(super) fn times(self, other: Dimension, power: i32) -> Option<Dimension> {
        let exponent = |a: i8, b: i8| i8::try_from(i32::from(a) + i32::from(b) * power).ok();
        Some(Dimension {
            metre: exponent(self.metre, other.metre)?,
            kilogram: exponent(self.kilogram, other.kilogram)?,
            second: exponent(self.second, other.second)?,
            radian: exponent(self.radian, other.radian)?,
        })
    }

    /// The dimension written in base units, as in `kg·m/s²`.
    fn base_units(self) -> String {
        let bases =
            [("kg", self.kilogram), ("m", self.metre), ("rad", self.radian), ("s", self.second)];
        let side = |sign: i8| {
            let factors = bases.iter().filter(|(_, power)| power.signum() == sign);
            factors
                .map(|(name, power)| match power.unsigned_abs() {
                    1 => (*name).to_owned(),
                    2 => format!("{name}²"),
                    3 => format!("{name}³"),
                    power => format!("{name}^{power}"),
                })
                .collect::<Vec<_>>()
        };
        let (over, under) = (side(1), side(-1));
        let over_text = if over.is_empty() { "1".to_owned() } else { over.join("·") };
        match under.as_slice() {
            [] => over_text,
            [one] => format!("{over_text}/{one}"),
            _ => format!("{over_text}/({})", under.join("·")),
        }
    }
}

/// Prints the dimension as errors name it: `a speed [m/s]`, or `a quantity [kg²/m]` for a dimension without a name.
impl fmt::Display for Dimension {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match measures::ALL.iter().find(|measure| measure.dimension == *self) {
            Some(measure) => measure.fmt(f),
            None => write!(f, "a quantity [{}]", self.base_units()),
        }
    }
}

/// The named kinds of quantity.
pub mod measures {
    use super::Dimension;
    use core::fmt;

    /// A kind of quantity that a key may hold.
    #[derive(Debug, PartialEq, Eq)]
    pub struct Measure {
        /// Name of the quantity with its article, as in `a speed`.
        pub name: &'static str,
        /// SI unit of the quantity, empty for a plain number.
        pub unit: &'static str,
        /// An example of a value with a unit.
        pub example: &'static str,
        /// Dimension of the quantity.
        pub dimension: Dimension,
    }

    impl Measure {
        /// Says how to write such a quantity, with an example.
        pub fn help(&self) -> String {
            let Measure { name, example, .. } = self;
            if core::ptr::eq(self, &CELSIUS) {
                format!("write {name}, as \"{example}\", or a plain number of degrees Celsius")
            } else if self.dimension == Dimension::NONE {
                format!("write {name}, as {example}")
            } else {
                format!("write {name}, as \"{example}\", or a number in SI units, without quotes")
            }
        }
    }

    /// A temperature in degrees Celsius. A temperature has no dimension here, because its units are not multiples of
    /// each other.
    pub static CELSIUS: Measure = Measure {
        name: "a temperature",
        unit: "°C",
        example: "10 degC",
        dimension: Dimension::NONE,
    };

    impl fmt::Display for Measure {
        fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
            match self.unit {
                "" => f.write_str(self.name),
                unit => write!(f, "{} [{unit}]", self.name),
            }
        }
    }

    macro_rules! measures {
        ($($id:ident = $name:literal, $unit:literal, $example:literal, ($m:literal, $kg:literal, $s:literal, $rad:literal);)*) => {
            $(
                #[doc = concat!($name, ", in ", $unit, ".")]
                pub static $id: Measure =
                    Measure {
                        name: $name,
                        unit: $unit,
                        example: $example,
                        dimension: Dimension::new($m, $kg, $s, $rad),
                    };
            )*
            /// All named kinds of quantity; the first one of a dimension gives the dimension its name.
            pub static ALL: &[&Measure] = &[$(&$id),*];
        };
    }

    measures! {
        PLAIN_NUMBER = "a plain number", "", "0.5", (0, 0, 0, 0);
        LENGTH = "a length", "m", "1.5 m", (1, 0, 0, 0);
        AREA = "an area", "m²", "20 m^2", (2, 0, 0, 0);
        VOLUME = "a volume", "m³", "100 m^3", (3, 0, 0, 0);
        INERTIA_OVER_DENSITY = "a moment of inertia over a density", "m^5", "100 m^5", (5, 0, 0, 0);
        MASS = "a mass", "kg", "930 t", (0, 1, 0, 0);
        MASS_PER_LENGTH = "a mass per length", "kg/m", "7.2 kg/m", (-1, 1, 0, 0);
        TIME = "a time", "s", "0.1 s", (0, 0, 1, 0);
        FREQUENCY = "a frequency", "1/s", "2 1/s", (0, 0, -1, 0);
        ANGLE = "an angle", "rad", "30 deg", (0, 0, 0, 1);
        RATE_OF_TURN = "a rate of turn", "rad/s", "3 deg/s", (0, 0, -1, 1);
        SPEED = "a speed", "m/s", "4 kn", (1, 0, -1, 0);
        ACCELERATION = "an acceleration", "m/s²", "0.5 m/s^2", (1, 0, -2, 0);
        FORCE = "a force", "N", "500 kN", (1, 1, -2, 0);
        MOMENT = "a moment or energy", "N·m", "500 kN.m", (2, 1, -2, 0);
        POWER = "a power", "W", "2000 kW", (2, 1, -3, 0);
        STIFFNESS_PER_AREA = "a stiffness per area or pressure", "N/m²", "500 kN/m^2", (-1, 1, -2, 0);
        DAMPING_PER_AREA = "a damping per area", "N·s/m²", "20 kN.s/m^2", (-1, 1, -1, 0);
        STIFFNESS = "a stiffness", "N/m", "3000 kN/m", (0, 1, -2, 0);
        DAMPING = "a damping", "N·s/m", "20 kN.s/m", (0, 1, -1, 0);
        MOMENT_OF_INERTIA = "a moment of inertia", "kg·m²", "5e9 kg.m^2", (2, 1, 0, 0);
        DENSITY = "a density", "kg/m³", "1025 kg/m^3", (-3, 1, 0, 0);
        STIFFNESS_PER_VOLUME = "a stiffness per volume", "N/m³", "30 MN/m^3", (-2, 1, -2, 0);
    }
}
