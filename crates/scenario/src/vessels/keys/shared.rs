//! What the tables of vessel files share.

use fenderline_keys::spec::Quantity;
use fenderline_keys::units::measures as unit;

pub(super) const COEFFICIENT: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: -1e3, high: 1e3 };
pub(super) const POSITIVE: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-6, high: 1e3 };
pub(super) const ESTIMATED: &str = "estimated; reports name it as an estimate";

/// Keys of coefficients without dimension, all of which must be given.
macro_rules! coefficients {
    ($($name:literal: $doc:literal),* $(,)?) => {
        &[$(fenderline_keys::spec::key(
            $name,
            fenderline_keys::spec::Kind::Quantity(COEFFICIENT),
            fenderline_keys::spec::Absent::Refused,
            $doc,
            &["-0.04"],
        )),*]
    };
}
pub(super) use coefficients;
