//! An exercise: a goal to reach and limits to keep, and the score that follows from both.
//!
//! It looks at a simulation after each step and changes nothing in it, so that a run gives the same bits with and without an
//! exercise. The score begins at 100. Each limit that is exceeded takes points in proportion to the excess, up to all its points at
//! a given worst value; a limit may also decide that the exercise is failed.
//!
//! | file | content |
//! |---|---|
//! | `exercise/anchored.rs` | whether an anchor holds as a goal asks |
//! | `exercise/condition.rs` | the parts of a goal, and whether each is fulfilled now |
//! | `exercise/limit.rs` | the limits, and what each measures |
//! | `exercise/measure.rs` | the present value of each measure |
//! | `exercise/clearance.rs` | the distance between two outlines |
//! | `exercise/assessment.rs` | the state from step to step, and the score |
//! | `exercise/words.rs` | conditions, limits and deductions in words |

mod anchored;
mod assessment;
mod clearance;
mod condition;
mod limit;
mod measure;
mod words;

pub use anchored::AnchorPlace;
pub use assessment::{Assessment, Deduction, Mark, State};
pub use condition::{Condition, Fulfilled};
pub use limit::{Limit, Measure};
pub use measure::Subject;

use crate::berth::Berth;

/// The score of an exercise without a deduction.
pub const FULL_SCORE: f64 = 100.0;

/// An exercise.
#[derive(Clone, Debug, PartialEq)]
pub struct ExerciseSetup {
    /// What the pilot is asked to do, in words; may be empty.
    pub task: String,
    /// The ship: an index into [`crate::WorldSetup::vessels`].
    pub vessel: usize,
    /// Her berth; `None` if neither goal nor limits need one.
    pub berth: Option<Berth>,
    /// The goal: all conditions together.
    pub goal: Vec<Condition>,
    /// How long all conditions must hold without a break (s).
    pub hold_s: f64,
    /// After this time the exercise ends without its goal (s); infinite without a limit.
    pub time_limit_s: f64,
    /// The least score with which it is passed.
    pub pass_mark: f64,
    /// The limits, in the order of the scenario.
    pub limits: Vec<Limit>,
}
