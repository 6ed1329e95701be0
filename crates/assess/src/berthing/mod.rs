//! Compares a simulated berthing with the formulas of [`fenderline_world::berthing`].

mod hit;
mod outcome;
mod study;

pub use outcome::{AddedSway, BerthingOutcome, LaterHit, OtherShip, ShallowFactor};
pub use study::{Study, StudyStep};
