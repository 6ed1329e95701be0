//! Events of the world that are reported to the user.

use fenderline_ship::anchor::AnchorEvent;

/// An event in a step. A state that lasts is reported once, when it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldEvent {
    /// Index of the vessel, line, tug or anchor concerned.
    pub who: usize,
    /// The kind of event.
    pub kind: WorldEventKind,
}

/// The kinds of [`WorldEvent`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WorldEventKind {
    /// An order to a vessel was beyond a stop and was limited to the stop; or it was NaN and had no effect.
    OrderClamped,
    /// A vessel is aground: the water is not deeper than the vessel's draught with squat.
    Aground,
    /// The water is shallower than 1.1 times a vessel's draught, where the range of the shallow-water formulas ends.
    /// The values at 1.1 are used.
    ShallowHeld,
    /// A tug cannot give the ordered force at this speed and angle.
    TugLimited,
    /// A tug refused an order with an invalid force or direction.
    TugOrderRefused,
    /// A line could not be made fast: it is too short for its ends, cannot have the pretension, or could not be sent to
    /// the bollard.
    LineNotMadeFast,
    /// A line that was sent to a bollard is fast.
    LineMadeFast,
    /// A line parted.
    LineParted,
    /// A line that was planned to part was not fast.
    LineNotParted,
    /// The brake of the winch of a line renders.
    LineRenders,
    /// An event of an anchor.
    Anchor(AnchorEvent),
}
