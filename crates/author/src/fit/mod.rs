//! Makes a fender of the library from measured, calculated or catalogue curves.
//!
//! `curves` reads and checks a file with columns of deflections and reactions. `fitted` fits a fender family with one
//! size to the curves: `thinning` drops points, `factors` finds the factors by speed and temperature. `file` writes the
//! fitted fender as TOML.

mod curves;
mod factors;
mod file;
mod fitted;
mod options;
mod thinning;

pub use curves::{Branch, CatalogueScale, FenderCurves, LoadingCurve};
pub use fitted::FittedFender;
pub use options::{FitError, FitOptions};
