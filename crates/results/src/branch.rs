//! The outcome of a branch of a recorded session, for comparison with other branches.

use fenderline_contact::Vec2;
use fenderline_sim::{Finding, Verdict};

/// A branch of a session from the start of the session to the end of the branch.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchOutcome {
    /// Its number.
    pub id: usize,
    /// The branch from which this branch goes off; `None` for the first branch.
    pub parent: Option<usize>,
    /// When the branch goes off (s).
    pub from_s: f64,
    /// End of the branch (s).
    pub ends_s: f64,
    /// The verdict on the run up to the end of the branch.
    pub verdict: Verdict,
    /// What was found.
    pub findings: Vec<Finding>,
    /// The score of the exercise, and whether it is passed (`None`: not ended); `None` without an exercise.
    pub score: Option<(f64, Option<bool>)>,
    /// Largest share of rated energy of a fender; `None` without rated fenders that were touched.
    pub fender_share: Option<f64>,
    /// Largest share of the breaking load of a line.
    pub line_share: f64,
    /// Fastest approach of an end of the ship within [`BranchOutcome::NEAR_M`] of the berth, abreast of it
    /// (m/s); `None` if the ship was never so near.
    pub approach_mps: Option<f64>,
    /// Commands of people after the branch goes off.
    pub commands: usize,
    /// Alarms up to the end of the branch.
    pub alarms: usize,
    /// The ship's way, about once a second of simulated time.
    pub way: Vec<WayPoint>,
    /// The ship's outline at the end of the branch, on the earth (m).
    pub hull_m: Vec<Vec2>,
}

/// The ship at a time of a branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayPoint {
    /// The time (s).
    pub t_s: f64,
    /// Her centre of gravity (m).
    pub at_m: Vec2,
    /// Speed over ground (m/s).
    pub speed_mps: f64,
    /// Distance of the ship's nearer end from the line of the fenders (m); `None` without a berth.
    pub off_m: Option<f64>,
}

impl BranchOutcome {
    /// A speed counts as an approach within this distance from the fenders (m); our choice.
    pub const NEAR_M: f64 = 5.0;
}
