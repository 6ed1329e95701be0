//! What happens in a world that a user should know of.

/// Something that happened in a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorldEvent {
    /// Index of the vessel, the line or the tug it is about.
    pub who: usize,
    /// What happened.
    pub kind: WorldEventKind,
}

/// The kinds of [`WorldEvent`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WorldEventKind {
    /// An order of a vessel was beyond a stop, or no number: the stop was ordered. Told when it begins.
    OrderClamped,
    /// The water is no deeper than a vessel's draught: the bottom holds her. Told when it begins.
    Aground,
    /// The water is shallower than 1.1 of a vessel's draughts: no formula for shallow water is made for that, and
    /// what shallow water does to her is held. Told when it begins.
    ShallowHeld,
    /// A tug cannot give at this speed and angle what she is ordered to. Told when it begins.
    TugLimited,
    /// An order to a tug with a force or a direction that is none.
    TugOrderRefused,
    /// A line could not be made fast where its ends were: too short, or no such pretension.
    LineNotMadeFast,
    /// A line parted.
    LineParted,
    /// The brake of a line's winch renders. Told when it begins.
    LineRenders,
}
