//! Finds the factors of a fender's reaction by compression time and by temperature: each is the ratio of two energies
//! up to the rated deflection.

use super::curves::{Branch, FenderCurves, LoadingCurve, end, integral};
use super::options::FitError;
use fenderline_keys::printable::printable_number;

/// Energy of a curve to the rated deflection, divided by the energy of the reference curve.
fn factor(curve: &LoadingCurve, reference: &LoadingCurve, rated_m: f64) -> Result<f64, FitError> {
    let end_m = end(&curve.loading);
    if end_m < rated_m {
        let conflict = format!("the rated deflection is {} m", printable_number(rated_m));
        return Err(FitError::Ends { curve: curve.name(), end_m, conflict });
    }
    Ok(integral(&curve.loading, rated_m) / integral(&reference.loading, rated_m))
}

/// Table of the time to rated deflection (s) and the factor on the reaction; empty if the file has fewer than two
/// speeds.
pub(super) fn velocity(
    curves: &FenderCurves,
    reference: &LoadingCurve,
    rated_m: f64,
) -> Result<Branch, FitError> {
    let mut rows = Branch::new();
    for curve in &curves.curves {
        let Some(speed_mps) = curve.speed_mps else { continue };
        if curve.temperature_c == reference.temperature_c {
            rows.push((rated_m / speed_mps, factor(curve, reference, rated_m)?));
        } else if curve.speed_mps != reference.speed_mps {
            return Err(FitError::NotOneAtATime { curve: curve.name() });
        }
    }
    rows.sort_by(|one, other| one.0.total_cmp(&other.0));
    Ok(if rows.len() > 1 { rows } else { Branch::new() })
}

/// Table of the temperature (°C) and the factor on the reaction; empty if the file has fewer than two temperatures.
pub(super) fn temperature(
    curves: &FenderCurves,
    reference: &LoadingCurve,
    rated_m: f64,
) -> Result<Branch, FitError> {
    let mut rows = Branch::new();
    for curve in curves.curves.iter().filter(|curve| curve.speed_mps == reference.speed_mps) {
        if let Some(temperature_c) = curve.temperature_c {
            rows.push((temperature_c, factor(curve, reference, rated_m)?));
        }
    }
    rows.sort_by(|one, other| one.0.total_cmp(&other.0));
    Ok(if rows.len() > 1 { rows } else { Branch::new() })
}
