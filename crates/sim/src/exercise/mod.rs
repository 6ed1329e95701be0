//! An exercise has a goal to reach, limits to keep, and a score that follows from both.
//!
//! An exercise evaluates a simulation after each step and changes nothing in it: a run gives the same bits with and
//! without an exercise. The score of an exercise begins at 100. Each exceeded limit deducts points in proportion to the
//! excess, up to all points of the limit at a given worst value. A limit may also decide that the exercise is failed.
//!
//! | file | content |
//! |---|---|
//! | `exercise/anchored.rs` | whether an anchor holds as the goal of an exercise asks |
//! | `exercise/condition.rs` | the conditions of a goal, and whether each is fulfilled in the present state |
//! | `exercise/limit.rs` | the limits of an exercise, and what each limit measures |
//! | `exercise/measure.rs` | the present value of each measure of an exercise |
//! | `exercise/clearance.rs` | the distance between two outlines |
//! | `exercise/assessment.rs` | the state of an exercise from step to step, and its score |
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

use fenderline_contact::Vec2;

use crate::berth::Berth;

/// The score of an exercise without a deduction.
pub const FULL_SCORE: f64 = 100.0;

/// A mark of a berth, such as a bollard, and the place of the ship that shall lie abeam of the mark, such as her bow.
#[derive(Clone, Debug, PartialEq)]
pub struct BerthMark {
    /// Name of the mark for the docking board, such as "Bow at bollard 9"; may be empty.
    pub name: String,
    /// Place of the mark in the frame of the body that carries the berth (m).
    pub at_m: Vec2,
    /// Place of the ship, forward of her body's origin (m).
    pub of_ship_m: f64,
}

/// An exercise.
#[derive(Clone, Debug, PartialEq)]
pub struct ExerciseSetup {
    /// The task of the exercise for the pilot, in words; may be empty.
    pub task: String,
    /// The ship of the exercise, by her index in [`crate::WorldSetup::vessels`].
    pub vessel: usize,
    /// The ship's berth; `None` if neither the goal nor the limits need a berth.
    pub berth: Option<Berth>,
    /// The mark of the berth abeam of which the ship shall lie, for the docking board; the mark is no part of the goal.
    pub mark: Option<BerthMark>,
    /// False if the pages' view shows marks to the instructor alone.
    pub view_marks: bool,
    /// The conditions of the goal of the exercise. The goal is reached when all conditions hold.
    pub goal: Vec<Condition>,
    /// How long all conditions must hold without a break for the goal to be reached (s).
    pub hold_s: f64,
    /// After this time the exercise ends even if the goal is not reached (s); infinite if there is no time limit.
    pub time_limit_s: f64,
    /// The least score with which a pilot passes the exercise.
    pub pass_mark: f64,
    /// The limits of the exercise, in the order of the scenario.
    pub limits: Vec<Limit>,
}
