//! Nominal values: the order of magnitude of a variable. Masters scale tolerances and plots by the nominal values; no
//! result depends on them.

use fenderline_sim::Setup;

use crate::table::{Class, Variable};
use crate::unit::Unit;

/// Size and mass of the moving bodies of a scenario, as powers of ten.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Scales {
    /// Mass of the heaviest body (kg).
    mass_kg: f64,
    /// Extent of the largest body that floats (m).
    length_m: f64,
}

impl Scales {
    pub(super) fn of(setup: &Setup) -> Scales {
        let (mut mass_kg, mut length_m) = (1.0, 1.0);
        for body in &setup.bodies {
            if let Some(mass) = &body.mass {
                mass_kg = larger(mass_kg, mass.mass_kg);
                length_m = larger(length_m, 2.0 * body.outline.radius_m());
            }
        }
        Scales { mass_kg: power_of_ten(mass_kg), length_m: power_of_ten(length_m) }
    }
}

/// The nominal value of a real variable; `None` for 1, which masters assume. The nominal acceleration is 0.1 m/s², the
/// nominal speed of an impact 0.1 m/s, the nominal deflection 0.1 m.
pub(super) fn nominal(variable: &Variable, scales: Scales) -> Option<f64> {
    if variable.class != Class::Real {
        return None;
    }
    let Scales { mass_kg, length_m } = scales;
    let is_deflection =
        ["deflection", "depth", "shear", "motion"].iter().any(|word| variable.name.contains(word));
    let force_n = 0.1 * mass_kg;
    let value = match variable.unit {
        Unit::Metre if is_deflection => 0.1,
        Unit::Metre => length_m,
        Unit::RadianPerSecond => 0.01,
        Unit::Kilogram => mass_kg,
        Unit::KilogramSquareMetre => mass_kg * length_m * length_m / 10.0,
        Unit::Newton => force_n,
        Unit::NewtonMetre => force_n * length_m,
        Unit::NewtonPerMetre => force_n / 0.1,
        Unit::NewtonPerSquareMetre => 1e6,
        Unit::NewtonSecondPerSquareMetre => 1e5,
        Unit::NewtonSecond => 0.1 * mass_kg,
        Unit::Joule => 0.01 * mass_kg,
        Unit::One
        | Unit::Second
        | Unit::SquareMetre
        | Unit::Radian
        | Unit::MetrePerSecond
        | Unit::PerSecond => return None,
    };
    Some(value)
}

fn larger(one: f64, other: f64) -> f64 {
    if other > one { other } else { one }
}

/// The largest power of ten that is not above a number of at least 1.
fn power_of_ten(number: f64) -> f64 {
    let mut power = 1.0;
    while power * 10.0 <= number {
        power *= 10.0;
    }
    power
}
