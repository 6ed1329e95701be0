//! Bounds and texts that several tables of vessel files share.

use fenderline_keys::spec::{Absent, KeySpec, Kind, Quantity, key};
use fenderline_keys::units::measures as unit;

pub(super) const COEFFICIENT: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: -1e3, high: 1e3 };
pub(super) const POSITIVE: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-6, high: 1e3 };
pub(super) const ESTIMATED: &str =
    "the program estimates the value, and reports name the value as an estimate";

/// Declares a key for a coefficient without dimension, which the file must give.
pub(super) const fn coefficient(name: &'static str, doc: &'static str) -> KeySpec {
    key(name, Kind::Quantity(COEFFICIENT), Absent::Refused, doc, &["-0.04"])
}
