//! Events of the world, which the program reports to the user.

use fenderline_ship::anchor::AnchorEvent;

/// An event in a step. A state that lasts gives one event, when it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldEvent {
    /// Index of the vessel, line, tug or anchor of the event.
    pub who: usize,
    /// The kind of event.
    pub kind: WorldEventKind,
}

/// The kinds of [`WorldEvent`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WorldEventKind {
    /// An order to a vessel was beyond a stop, so the vessel goes only to the stop; or the order was NaN and had no
    /// effect.
    OrderClamped,
    /// A vessel is aground: the water is not deeper than the vessel's draught with squat.
    Aground,
    /// The water is shallower than 1.1 times a vessel's draught, where the range of the shallow-water formulas ends.
    /// The model then uses the values of the formulas at 1.1.
    ShallowHeld,
    /// A tug cannot give the ordered force at the present speed and angle.
    TugLimited,
    /// A tug refused an order with an invalid force or direction.
    TugOrderRefused,
    /// Line handlers could not make a line fast: the line is too short for its ends, cannot have the pretension, or
    /// could not go to the bollard.
    LineNotMadeFast,
    /// A line that was sent to a bollard is fast.
    LineMadeFast,
    /// A line parted.
    LineParted,
    /// A planned change parts a line, but the line was not fast.
    LineNotParted,
    /// The brake of the winch of a line renders.
    LineRenders,
    /// An event of an anchor.
    Anchor(AnchorEvent),
}
