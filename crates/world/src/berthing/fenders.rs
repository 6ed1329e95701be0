//! Requirements on the fenders of a berth other than the energy: spacing, hull pressure and compression time.

use fenderline_contact::number::lesser;

use super::check::{LENGTH, Range};
use super::error::BerthingError;

static BOW_RADIUS: Range = Range::new("bow radius [m]", 0.1, 10_000.0);
static PROJECTION: Range = Range::new("projection of the compressed fender [m]", 0.0, 100.0);
static CLEARANCE: Range = Range::new("clearance [m]", 0.0, 100.0);
static REACTION: Range = Range::new("reaction [N]", 0.0, 1e12);
static PANEL_AREA: Range = Range::new("panel area [m²]", 1e-4, 1e6);
static DEFLECTION: Range = Range::new("rated deflection [m]", 1e-6, 100.0);
static CLOSING_SPEED: Range = Range::new("berthing speed [m/s]", 1e-9, 50.0);

/// The greatest spacing of fenders along a berth (m): 2√(R_b² − (R_b − p + c)²), and at most 0.15 of the ship's length.
/// With the greatest spacing, a bow of radius R_b that compresses two fenders to a projection p keeps a clearance c
/// from the quay.
///
/// Source of the formula: found (public fender design manuals).
///
/// # Errors
/// Fails if a length is out of the range of real ships and berths, or if the fender stands out no more than the
/// clearance.
pub fn largest_spacing_m(
    bow_radius_m: f64,
    projection_m: f64,
    clearance_m: f64,
    length_m: f64,
) -> Result<f64, BerthingError> {
    let radius_m = BOW_RADIUS.check(bow_radius_m)?;
    let projection_m = PROJECTION.check(projection_m)?;
    let clearance_m = CLEARANCE.check(clearance_m)?;
    let by_length_m = 0.15 * LENGTH.check(length_m)?;
    let sagitta_m = projection_m - clearance_m;
    if sagitta_m <= 0.0 {
        return Err(BerthingError::NoClearance { projection_m, clearance_m });
    }
    // R² − (R − s)², written so that no digits cancel. Beyond a half circle the chord does not grow.
    let sagitta_m = lesser(sagitta_m, radius_m);
    let half_chord_m = libm::sqrt(sagitta_m * (2.0 * radius_m - sagitta_m));
    Ok(lesser(2.0 * half_chord_m, by_length_m))
}

/// Mean pressure of a fender on the hull (N/m²): the reaction divided by the flat area of the panel. The panel of the
/// fender determines the pressure on the hull, not the rubber. The limits of hull pressure by type of ship are in the
/// data file `fenders/hull_pressure.toml`.
///
/// # Errors
/// Fails if the reaction or the area is out of range.
pub fn hull_pressure_npm2(reaction_n: f64, panel_area_m2: f64) -> Result<f64, BerthingError> {
    Ok(REACTION.check(reaction_n)? / PANEL_AREA.check(panel_area_m2)?)
}

/// Time to rated deflection (s): t = δ_rated/(0.74·V). Fender catalogues tabulate velocity factors by the time to rated
/// deflection.
///
/// Source of the formula: found (a public calculator for cone fenders); we know only from memory that 0.74 V is the
/// mean speed during compression.
///
/// # Errors
/// Fails if the deflection or the speed is out of range.
pub fn compression_time_s(rated_deflection_m: f64, speed_mps: f64) -> Result<f64, BerthingError> {
    Ok(DEFLECTION.check(rated_deflection_m)? / (0.74 * CLOSING_SPEED.check(speed_mps)?))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Geometry: the fenders stand at the ends of a chord. A circle with the bow's radius through both fenders comes
    /// within exactly the clearance of the quay.
    #[test]
    fn the_bow_keeps_its_clearance_between_two_fenders() {
        for (radius_m, projection_m, clearance_m) in [(80.0, 1.2, 0.2), (30.0, 0.6, 0.05)] {
            let spacing_m = largest_spacing_m(radius_m, projection_m, clearance_m, 1000.0).unwrap();
            let centre_m =
                projection_m + libm::sqrt(radius_m * radius_m - spacing_m * spacing_m / 4.0);
            let left_m = centre_m - radius_m;
            assert!((left_m - clearance_m).abs() < 1e-12, "{left_m}");
        }
        assert_eq!(largest_spacing_m(80.0, 1.2, 0.2, 100.0), Ok(15.0), "0.15 L");
        assert_eq!(largest_spacing_m(1.0, 50.0, 0.0, 1000.0), Ok(2.0), "a bow's breadth at most");
    }

    #[test]
    fn pressure_and_time_are_the_plain_quotients() {
        assert_eq!(hull_pressure_npm2(1e6, 5.0), Ok(2e5));
        // A public calculator: SCN1050 at 0.1 m/s, 10.2 s.
        let time_s = compression_time_s(0.72 * 1.05, 0.1).unwrap();
        assert!((time_s - 10.216).abs() < 1e-3, "{time_s}");
    }

    #[test]
    fn impossible_berths_are_refused() {
        let error = largest_spacing_m(80.0, 0.2, 0.2, 200.0).unwrap_err();
        assert_eq!(error, BerthingError::NoClearance { projection_m: 0.2, clearance_m: 0.2 });
        assert!(error.to_string().contains("0.2 m"));
        assert!(largest_spacing_m(0.0, 1.0, 0.1, 200.0).is_err());
        assert!(hull_pressure_npm2(1e6, 0.0).is_err());
        assert!(compression_time_s(0.7, 0.0).is_err());
    }
}
