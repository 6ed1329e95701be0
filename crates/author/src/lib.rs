//! Writes files for people: new exercises, scenarios with changed keys, and fender files from measured curves.
#![forbid(unsafe_code)]

mod fit;
mod new_exercise;
mod new_harbour;
mod rewrite;

pub use fit::{
    Branch, CatalogueScale, FenderCurves, FitError, FitOptions, FittedFender, LoadingCurve,
};
pub use new_exercise::{
    BerthSource, BerthingSide, NewBerth, NewExercise, NewExerciseError, NewShip, NewTugs,
    NewWeather, berth_words, can_be_ship, can_be_tug, fixed_berth,
};
pub use new_harbour::{NewHarbour, NewHarbourError};
pub use rewrite::{Edit, rewritten};
