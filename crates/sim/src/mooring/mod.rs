//! Mooring lines: ropes, tails, winches, and heavy cables that hang.
//!
//! A [`Line`] is the constant part, checked once; a [`LineState`] is plain data that can be copied,
//! compared and replayed. [`Line::step`] takes where the two ends are and gives the forces on them.
//! Lines are quasi-static: no inertia, no drag, no bending; a rope's curve is the same up and down, so
//! that only the winch takes energy out.
//!
//! MEG4 (found in public summaries; the guideline was not read): a line's design break force is 100 to
//! 105 % of the ship design MBL, a tail's 125 to 130 %; working load 55 % (wire) or 50 % (synthetic);
//! brakes are set to render at 60 %.

mod catenary;
mod error;
mod line;
mod rope;
mod solve;
mod winch;

pub use catenary::{Cable, Catenary, catenary};
pub use error::{MooringError, RopeError};
pub use line::{Fitting, Holding, Line, LineEnds, LineKind, LineLoad, LineSetup, LineState, Tail};
pub use rope::{Rope, RopeCurve};
pub use winch::{Winch, WinchNotes, WinchOrder};
