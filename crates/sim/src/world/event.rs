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
    /// A line could not be made fast where its ends were: too short, or no such pretension.
    LineNotMadeFast,
    /// A line parted.
    LineParted,
    /// The brake of a line's winch renders. Told when it begins.
    LineRenders,
}
