//! From curves that somebody measured, calculated or took from a catalogue to a fender of the library.
//!
//! `curves` reads and checks a file of columns, `fitted` makes a family with one size of it.

mod curves;
mod fitted;

pub use curves::{Branch, FenderCurves, LoadingCurve};
pub use fitted::{FitError, FitOptions, FittedFender};
