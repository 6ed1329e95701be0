//! Errors in hydrodynamic data.

use std::fmt;

use super::MOTIONS;

/// The table of a hydrodynamic database in which an error lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Table of added mass and damping by frequency.
    Radiation,
    /// Table of added mass at infinite frequency.
    Infinite,
    /// Table of exciting forces by frequency and heading.
    Excitation,
    /// Table of mean drift by frequency and heading.
    Drift,
    /// Table of mass, restoring, reference point and depth.
    Head,
}

/// An error in hydrodynamic data.
#[derive(Clone, Debug, PartialEq)]
pub struct SeakeepingError {
    /// The table in which the error lies.
    pub part: Part,
    /// The row in the table, counted from 0, if the error belongs to a row.
    pub row: Option<usize>,
    /// The reason.
    pub reason: Reason,
}

/// Makes an error about a row of a table.
pub(super) fn error(part: Part, row: Option<usize>, reason: Reason) -> SeakeepingError {
    SeakeepingError { part, row, reason }
}

/// The reason.
#[derive(Clone, Debug, PartialEq)]
pub enum Reason {
    /// A list of the hydrodynamic data is shorter or longer than it must be.
    Length {
        /// What is counted.
        what: &'static str,
        /// How many items the list must have.
        expected: usize,
        /// How many items the list has.
        found: usize,
    },
    /// The numbers of an axis (frequencies or headings) do not rise from row to row.
    NotRising(&'static str),
    /// A number of the hydrodynamic data is not finite, or is larger than for any ship.
    NotANumber(&'static str),
    /// A diagonal entry of the damping is negative.
    NegativeDamping {
        /// The motion.
        motion: usize,
        /// The negative damping of the motion (N·s/m, N·m·s).
        damping: f64,
    },
    /// A matrix of the hydrodynamic data is not symmetric.
    NotSymmetric {
        /// The matrix.
        matrix: &'static str,
        /// The two motions to which the wrong entry of the matrix belongs.
        entry: [usize; 2],
        /// The entry of the matrix and the entry that should be equal to it.
        values: [f64; 2],
    },
    /// Mass and added mass of a motion are not positive.
    NoMass {
        /// The motion.
        motion: usize,
    },
    /// A motion of the ship in several directions at once has a negative damping, though no direction alone has one.
    NegativeTogether {
        /// The two directions, for example sway and roll, that have the largest part in this motion.
        motions: [usize; 2],
        /// The negative damping, divided by the largest damping of these motions; each motion is measured by the root
        /// of its largest damping.
        share: f64,
    },
    /// A motion of the ship in several directions at once has a negative mass or restoring, though no direction alone has
    /// one.
    CouplesTooMuch {
        /// The word `mass` or `restoring`.
        what: &'static str,
        /// The two directions, for example sway and roll, that have the largest part in this motion.
        motions: [usize; 2],
    },
    /// Exciting forces and damping contradict each other (Haskind's relation).
    ForcesOfOtherUnits {
        /// The motion.
        motion: usize,
        /// The frequency (rad/s).
        at_radps: f64,
        /// The damping that follows from the exciting forces, divided by the damping of the table.
        ratio: f64,
    },
    /// A value of the hydrodynamic data does not fit the ship, for example because of wrong units.
    Implausible {
        /// Name of the quantity that does not fit, with its unit.
        what: &'static str,
        /// Value of the quantity.
        value: f64,
        /// The range of the quantity for any ship of this displacement.
        range: [f64; 2],
    },
    /// The damping jumps between two frequencies, because they are too far apart.
    TooCoarse {
        /// The motion.
        motion: usize,
        /// The two frequencies between which the damping jumps (rad/s).
        between_radps: [f64; 2],
    },
    /// The damping at the last frequency is still large: the retardation function would not decay.
    TooShort {
        /// The motion.
        motion: usize,
        /// The damping at the last frequency, divided by its maximum.
        share: f64,
        /// The last frequency (rad/s).
        last_radps: f64,
    },
    /// The damping at the first frequency is large: long waves are missing.
    StartsLate {
        /// The motion.
        motion: usize,
        /// The damping at the first frequency, divided by its maximum.
        share: f64,
        /// The first frequency (rad/s).
        first_radps: f64,
    },
    /// Added mass and damping contradict each other.
    Inconsistent {
        /// The motion.
        motion: usize,
        /// The largest difference between added mass and damping, divided by the largest added mass.
        share: f64,
    },
    /// The headings of the hydrodynamic data leave a gap.
    HeadingGap {
        /// The gap (deg).
        between_deg: [f64; 2],
    },
    /// By the hydrodynamic data the ship does not float upright.
    Unstable {
        /// The motion.
        motion: usize,
    },
}

impl fmt::Display for SeakeepingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.reason {
            Reason::Length { what, expected, found } => {
                write!(f, "the data must have {expected} {what}, but have {found}")
            }
            Reason::NotRising(axis) => write!(f, "the {axis} must rise from row to row"),
            Reason::NotANumber(what) => write!(f, "{what} is not a finite number"),
            Reason::NegativeDamping { motion, damping } => write!(
                f,
                "the damping of {} is negative ({damping:.4e}): waves would drive the ship; take a finer mesh, or a lid \
                 against irregular frequencies",
                MOTIONS[*motion]
            ),
            Reason::NotSymmetric { matrix, entry: [i, j], values: [one, other] } => write!(
                f,
                "the {matrix} is not symmetric: {} and {} have {one:.4e} one way and {other:.4e} the other",
                MOTIONS[*i], MOTIONS[*j]
            ),
            Reason::NoMass { motion } => {
                write!(f, "mass and added mass of {} are not positive", MOTIONS[*motion])
            }
            Reason::NegativeTogether { motions: [one, other], share } => write!(
                f,
                "the damping of {} and {} together is negative, {:.1} % of its maximum, though each alone is damped: their coupling \
                 is too large, or the mesh too coarse",
                MOTIONS[*one],
                MOTIONS[*other],
                100.0 * share
            ),
            Reason::CouplesTooMuch { what, motions: [one, other] } => write!(
                f,
                "the {what} of {} and {} together is negative, so a motion of both would grow without bound: their coupling is too \
                 large; are the units kg, m, s, N?",
                MOTIONS[*one], MOTIONS[*other]
            ),
            Reason::ForcesOfOtherUnits { motion, at_radps, ratio } => write!(
                f,
                "the exciting forces in {} at {at_radps} rad/s ask for {ratio:.1e} times the \
                 damping that the data have (Haskind's relation): are the forces in N and N m for \
                 a wave of 1 m amplitude?",
                MOTIONS[*motion]
            ),
            Reason::Implausible { what, value, range: [low, high] } => write!(
                f,
                "{what} is {value:.4e}, but a ship of this displacement has {low:.2e} to {high:.2e}: are the units kg, m, \
                 s, N?"
            ),
            Reason::TooCoarse { motion, between_radps: [low, high] } => write!(
                f,
                "the damping of {} changes by more than 60 % of its maximum between {low} and {high} rad/s: the frequencies \
                 are too far apart there",
                MOTIONS[*motion]
            ),
            Reason::TooShort { motion, share, last_radps } => write!(
                f,
                "the damping of {} is still {:.0} % of its maximum at the last frequency, {last_radps} rad/s: the \
                 retardation function does not decay; add higher frequencies",
                MOTIONS[*motion],
                100.0 * share
            ),
            Reason::StartsLate { motion, share, first_radps } => write!(
                f,
                "the damping of {} is {:.0} % of its maximum at the first frequency, {first_radps} rad/s: add lower \
                 frequencies",
                MOTIONS[*motion],
                100.0 * share
            ),
            Reason::Inconsistent { motion, share } => write!(
                f,
                "added mass and damping of {} contradict each other (Ogilvie's relations) by {:.0} % of the added mass: \
                 the added mass at infinite frequency may be wrong, or frequencies are missing",
                MOTIONS[*motion],
                100.0 * share
            ),
            Reason::HeadingGap { between_deg: [low, high] } => write!(
                f,
                "the headings leave a gap from {low:.1} to {high:.1} degrees; they must cover 0 to 180, or all round, in \
                 steps of at most 45"
            ),
            Reason::Unstable { motion } => {
                write!(f, "the ship has no positive restoring in {}", MOTIONS[*motion])
            }
        }
    }
}

impl std::error::Error for SeakeepingError {}
