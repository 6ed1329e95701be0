//! The options of a fender's fit to measured curves, and the reasons why a fit can fail.

use core::fmt;

use fenderline_contact::Unloading;

use fenderline_keys::printable::printable_number;
use fenderline_scenario::Standing;

/// The data that a fender file needs besides the measured curves.
#[derive(Clone, Debug, PartialEq)]
pub struct FitOptions {
    /// Name of the family.
    pub family: String,
    /// Designation of the size.
    pub designation: String,
    /// Height of the uncompressed fender in the direction of compression (m).
    pub height_m: f64,
    /// Length of the fender along the berth (m).
    pub length_m: Option<f64>,
    /// Rated deflection (m); if `None`, the deflection at which the reference loading curve ends.
    pub rated_deflection_m: Option<f64>,
    /// Rated reaction of the catalogue (N), with which the curve must agree at the rated deflection; if `None`, the
    /// curve's own reaction there.
    pub rated_reaction_n: Option<f64>,
    /// Fraction of the energy that the fender returns in unloading, where the file has no unloading curve.
    pub returned_energy: Option<f64>,
    /// Largest distance of the fitted curve from the measured rows, as a fraction of the rated reaction.
    pub tolerance: f64,
    /// Where the measured curves come from.
    pub source: String,
    /// How well the source of the curves is known.
    pub standing: Standing,
}

/// Why no fender can be fitted to valid curves.
#[derive(Clone, Debug, PartialEq)]
pub enum FitError {
    /// A number of the options is outside its range.
    OutOfRange {
        /// Name of the quantity, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// Smallest valid value.
        low: f64,
        /// Largest valid value.
        high: f64,
    },
    /// A curve goes beyond the height of the fender, or ends before the rated deflection.
    Ends {
        /// Which curve.
        curve: String,
        /// Deflection at which the curve ends (m).
        end_m: f64,
        /// Message that names the option with which the curve's end conflicts.
        conflict: String,
    },
    /// The curve's reaction at the rated deflection differs from the rated reaction.
    NotRated {
        /// The rated deflection (m).
        deflection_m: f64,
        /// The curve's reaction at the rated deflection, divided by the rated reaction.
        share: f64,
        /// Whether the rated deflection was given by the user; otherwise it is the end of the curve.
        is_given: bool,
        /// The last deflection at which the curve has the rated reaction (m), and that deflection as a share of the
        /// height.
        at: Option<(f64, f64)>,
    },
    /// The curve's reaction at the rated deflection is zero.
    NoReaction {
        /// The rated deflection (m).
        rated_deflection_m: f64,
    },
    /// The file has an unloading curve, and the returned energy is given by the user as well.
    ReturnedTwice,
    /// A curve differs from the reference curve in both speed and temperature.
    NotOneAtATime {
        /// Which curve.
        curve: String,
    },
}

impl fmt::Display for FitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FitError::OutOfRange { quantity, value, low, high } => {
                let [value, low, high] = [*value, *low, *high].map(printable_number);
                write!(f, "{quantity} is {value}, but must be between {low} and {high}")
            }
            FitError::Ends { curve, end_m, conflict } => {
                write!(f, "{curve} ends at a deflection of {end_m} m; {conflict}")
            }
            FitError::NotRated { deflection_m, share, is_given, at } => {
                let what = if *is_given { "the rated deflection" } else { "the end of the curve" };
                let [mm, percent] = [deflection_m * 1e3, share * 100.0].map(shown);
                write!(
                    f,
                    "at {what}, {mm} mm, the reaction is {percent} % of the rated reaction; it \
                     must be 100 % at the rated deflection: "
                )?;
                match at {
                    Some((at_m, of_height)) => {
                        let [mm, percent] = [at_m * 1e3, of_height * 100.0].map(shown);
                        write!(
                            f,
                            "the curve is at 100 % for the last time at {mm} mm, {percent} % of \
                             the height: if this is the rated deflection of the catalogue, give \
                             --rated-deflection \"{mm} mm\""
                        )
                    }
                    None => write!(
                        f,
                        "the curve never reaches the rated reaction: compare --rated-reaction with \
                         the catalogue, or add rows"
                    ),
                }
            }
            FitError::NoReaction { rated_deflection_m } => {
                write!(f, "the reaction at the rated deflection of {rated_deflection_m} m is zero")
            }
            FitError::ReturnedTwice => {
                write!(
                    f,
                    "the file has an unloading curve, which sets the returned energy: give only one of the two, \
                     curve or energy"
                )
            }
            FitError::NotOneAtATime { curve } => write!(
                f,
                "{curve} differs from the reference curve in speed and in temperature: vary only speed or only \
                 temperature in a curve"
            ),
        }
    }
}

/// A number rounded to a tenth, as text.
fn shown(value: f64) -> String {
    printable_number(libm::round(value * 10.0) / 10.0)
}

impl core::error::Error for FitError {}

impl FitOptions {
    /// Checks that every number of the options is within its range.
    pub(super) fn check(&self) -> Result<(), FitError> {
        let within = |quantity, value: f64, low, high| {
            let good = (low..=high).contains(&value);
            good.then_some(()).ok_or(FitError::OutOfRange { quantity, value, low, high })
        };
        within("the height [m]", self.height_m, 1e-3, 100.0)?;
        within("the length [m]", self.length_m.unwrap_or(1.0), 1e-3, 100.0)?;
        within("the rated deflection [m]", self.rated_deflection_m.unwrap_or(1e-6), 1e-6, 100.0)?;
        within("the rated reaction [N]", self.rated_reaction_n.unwrap_or(1.0), 1.0, 1e9)?;
        within(
            "the returned energy",
            self.returned_energy.unwrap_or(1.0),
            Unloading::MIN_RETURNED_SHARE,
            1.0,
        )?;
        within("the tolerance", self.tolerance, 0.0, 0.2)
    }
}
