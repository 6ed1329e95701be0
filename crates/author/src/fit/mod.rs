//! From measured, calculated or catalogue curves to a fender of the library.
//!
//! `curves` reads and checks a file of columns. `fitted` fits a family with one size to it: `thinning` drops points,
//! `factors` finds the factors by speed and temperature. `file` writes the result as TOML.

mod curves;
mod factors;
mod file;
mod fitted;
mod options;
mod thinning;

pub use curves::{Branch, CatalogueScale, FenderCurves, LoadingCurve};
pub use fitted::FittedFender;
pub use options::{FitError, FitOptions};
