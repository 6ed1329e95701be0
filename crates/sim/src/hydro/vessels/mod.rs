//! Published ships, each with where its coefficients come from and how sure they are.

mod esso_osaka;
mod kcs;
mod kvlcc2;

pub use esso_osaka::esso_osaka_model;
pub use kcs::kcs;
pub use kvlcc2::{kvlcc2, kvlcc2_model};

use super::actuator::RateLimited;
use super::mmg::Mmg;

/// How sure a group of coefficients is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Standing {
    /// Published; taken from the design sheet, which took it from the source.
    Published,
    /// Recalled or taken at second hand: to be checked.
    Recalled,
    /// Estimated here; shown to users as unvalidated.
    Estimated,
}

/// Where one group of coefficients comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// Which coefficients.
    pub group: &'static str,
    /// Where from.
    pub source: &'static str,
    /// How sure.
    pub standing: Standing,
}

/// A ship ready for manoeuvres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vessel {
    /// Her name, with her scale.
    pub name: &'static str,
    /// Her manoeuvring model.
    pub ship: Mmg,
    /// Speed of approach of the standard manoeuvres [m/s].
    pub approach_mps: f64,
    /// Rudder amidships, with its rate and stop.
    pub steering: RateLimited,
    /// Where the numbers come from.
    pub sources: &'static [Source],
}

/// The parts of a model that every ship without low-speed tests of her own shares.
const LOW_SPEED_ESTIMATED: Source = Source {
    group: "low-speed hull",
    source: "linear terms of the polynomial, Hoerner's cross-flow drag, Esso Osaka's resistance astern over ahead",
    standing: Standing::Estimated,
};
const SERIES_FOR_OTHER_QUADRANTS: Source = Source {
    group: "propeller outside its first quadrant, torque",
    source: "Wageningen B4-70 of the nearest pitch, Roddy et al. (2006), from a transcription",
    standing: Standing::Recalled,
};

/// Thrust deduction astern with which the series of pitch 0.8, −0.255 at bollard, gives the −0.175 ρn²D⁴
/// that Miyauchi et al. (2022) have for Esso Osaka (pitch 0.715) by the design sheet.
const DEDUCTION_ASTERN: f64 = 0.314;
const DEDUCTION_ASTERN_ESTIMATED: Source = Source {
    group: "thrust deduction astern",
    source: "Esso Osaka's force astern at bollard over the series' thrust",
    standing: Standing::Estimated,
};
