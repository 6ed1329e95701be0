//! Kinds of quantities with their bounds, which the keys of several tables share.

use fenderline_contact::Unloading;

use crate::spec::Quantity;
use crate::units::measures as unit;

/// A length of a vessel or a line.
pub const LENGTH: Quantity = Quantity { measure: &unit::LENGTH, low: 0.01, high: 5000.0 };
/// A coordinate on a vessel.
pub const PLACE: Quantity = Quantity { measure: &unit::LENGTH, low: -5000.0, high: 5000.0 };
/// A coordinate in the horizontal plane.
pub(super) const POSITION: Quantity = Quantity { measure: &unit::LENGTH, low: -1e8, high: 1e8 };
/// A dimension of a fender.
pub(super) const FENDER_SIZE: Quantity = Quantity { measure: &unit::LENGTH, low: 1e-3, high: 1e3 };
/// A coordinate on the face of a fender.
pub(super) const PLACE_ON_FACE: Quantity =
    Quantity { measure: &unit::LENGTH, low: -1e3, high: 1e3 };
/// A dimension of a fender in the direction of its compression: no fender is as high as 30 m.
pub(super) const FENDER_HEIGHT: Quantity =
    Quantity { measure: &unit::LENGTH, low: 1e-3, high: 30.0 };
/// A compass direction, or a direction relative to a body. The angle is at most a full turn, so that the program
/// notices degrees that are written without their unit.
pub(super) const DIRECTION: Quantity =
    Quantity { measure: &unit::ANGLE, low: -TURN_RAD, high: TURN_RAD };
/// A full turn (rad), rounded up.
const TURN_RAD: f64 = 6.3;
/// A time since the start of the run.
pub(super) const TIME: Quantity = Quantity { measure: &unit::TIME, low: 0.0, high: 1e9 };
/// Magnitude of a force that a tug, a line or a thruster exerts.
pub(super) const FORCE: Quantity = Quantity { measure: &unit::FORCE, low: 1.0, high: 1e8 };
/// A velocity component of a body.
pub(super) const SPEED: Quantity = Quantity { measure: &unit::SPEED, low: -1e4, high: 1e4 };
/// A seed of random numbers.
pub(super) const SEED: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 4_294_967_295.0 };

/// Share of the absorbed energy that a fender returns.
pub const RETURNED_ENERGY: Quantity =
    Quantity { measure: &unit::PLAIN_NUMBER, low: Unloading::MIN_RETURNED_SHARE, high: 1.0 };
