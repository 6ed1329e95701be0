//! The outcome of a branch of a recorded session, for comparison with other branches.

use fenderline_contact::Vec2;
use fenderline_sim::{Finding, Verdict};

/// The outcome of a branch of a session, from the start of the session to the end of the branch.
#[derive(Clone, Debug, PartialEq)]
pub struct BranchOutcome {
    /// Its number.
    pub id: usize,
    /// The branch from which this branch splits off; `None` for the first branch.
    pub parent: Option<usize>,
    /// Time at which the branch splits off (s).
    pub from_s: f64,
    /// Time at which the branch ends (s).
    pub ends_s: f64,
    /// The verdict on the run up to the end of the branch.
    pub verdict: Verdict,
    /// What was found.
    pub findings: Vec<Finding>,
    /// Score of the exercise, and whether the exercise is passed (`None` if it has not ended); `None` if there is no
    /// exercise.
    pub score: Option<(f64, Option<bool>)>,
    /// Largest share of its rated energy that a fender absorbed; `None` if no rated fender was touched.
    pub fender_share: Option<f64>,
    /// Largest tension of a mooring line as a share of its break load.
    pub line_share: f64,
    /// Fastest approach of the ship's bow or stern while it is within [`BranchOutcome::NEAR_M`] of the berth and
    /// abreast of it (m/s); `None` if the ship was never so near.
    pub approach_mps: Option<f64>,
    /// Number of commands that people gave after the branch splits off.
    pub commands: usize,
    /// Number of alarms up to the end of the branch.
    pub alarms: usize,
    /// The ship's track, with about one point for each second of simulated time.
    pub way: Vec<WayPoint>,
    /// The ship's outline at the end of the branch, on the earth (m).
    pub hull_m: Vec<Vec2>,
}

/// Position and speed of the ship at one time of a branch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayPoint {
    /// The time (s).
    pub t_s: f64,
    /// Position of the ship's centre of gravity (m).
    pub at_m: Vec2,
    /// Speed over ground (m/s).
    pub speed_mps: f64,
    /// Distance of the ship's nearer end from the line of the fenders (m); `None` if there is no berth.
    pub off_m: Option<f64>,
}

impl BranchOutcome {
    /// The ship's speed counts as an approach speed within this distance from the fenders (m); the number is our
    /// choice.
    pub const NEAR_M: f64 = 5.0;
}
