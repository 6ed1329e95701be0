//! What the tables of vessel files share.

use fenderline_keys::spec::{Absent, KeySpec, Kind, Quantity, key};
use fenderline_keys::units::measures as unit;

pub(super) const COEFFICIENT: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: -1e3, high: 1e3 };
pub(super) const POSITIVE: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-6, high: 1e3 };
pub(super) const ESTIMATED: &str = "estimated; reports name it as an estimate";

/// A key of a coefficient without dimension, which must be given.
pub(super) const fn coefficient(name: &'static str, doc: &'static str) -> KeySpec {
    key(name, Kind::Quantity(COEFFICIENT), Absent::Refused, doc, &["-0.04"])
}
