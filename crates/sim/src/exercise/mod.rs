//! An exercise: a goal to reach and limits to keep, and the score that follows from both.
//!
//! An exercise looks at a simulation after each step and changes nothing in it: a run gives the same bits with and
//! without an exercise. The score begins at 100. Each exceeded limit takes points in proportion to the excess, up to
//! all its points at a given worst value. A limit may also decide that the exercise is failed.
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
    /// The task of the pilot in words; may be empty.
    pub task: String,
    /// The ship: an index into [`crate::WorldSetup::vessels`].
    pub vessel: usize,
    /// The ship's berth; `None` if neither goal nor limits need one.
    pub berth: Option<Berth>,
    /// The conditions of the goal. The goal is reached when all hold.
    pub goal: Vec<Condition>,
    /// How long all conditions must hold without a break (s).
    pub hold_s: f64,
    /// After this time the exercise ends even if the goal is not reached (s); infinite if there is no time limit.
    pub time_limit_s: f64,
    /// The least score with which the exercise is passed.
    pub pass_mark: f64,
    /// The limits, in the order of the scenario.
    pub limits: Vec<Limit>,
}
