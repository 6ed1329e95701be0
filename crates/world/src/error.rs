//! Errors of a set-up and of a run.

use std::fmt;

use fenderline_contact::{DisplayNumber, ModelError, StepError};

use crate::berthing::BerthingError;
use crate::change::ChangeError;
use crate::order::OrderError;
use crate::world::NoDepth;
use fenderline_ship::anchor::AnchorError;
use fenderline_ship::environment::EnvironmentError;
use fenderline_ship::mooring::MooringError;
use fenderline_ship::range::OutOfRange;

/// Reasons why a set-up cannot be simulated.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SetupError {
    /// The contact model is invalid.
    Model(ModelError),
    /// A number of the set-up is out of range or not finite.
    OutOfRange {
        /// Name of the number.
        field: &'static str,
        /// Value of the number.
        value: f64,
    },
    /// Two bodies or two fenders have the same name.
    DuplicateName {
        /// What has the same name: `bodies` or `fenders`.
        what: &'static str,
        /// The name that occurs twice.
        name: String,
    },
    /// A particular of the berthing is out of range.
    Berthing(BerthingError),
    /// A numeric value of a tug, such as her bollard pull, is out of range.
    Tug {
        /// Name of the tug.
        tug: String,
        /// Which number is out of range, and the range.
        error: OutOfRange,
    },
    /// The environment is invalid.
    Environment(EnvironmentError),
    /// A line does not fit between the initial positions of its ends.
    Line(MooringError),
    /// An anchor is invalid.
    Anchor(AnchorError),
    /// A number of the handling of lines is out of range.
    LineHandling {
        /// Which number is out of range, and the range.
        error: OutOfRange,
    },
    /// A planned change cannot be carried out.
    Change(ChangeError),
    /// An order cannot be carried out.
    Order(OrderError),
    /// The set-up has a vessel and the contact method of Moreno et al. (2023), which has one mass for all directions.
    VesselByPaperMethod {
        /// Index of the vessel's body.
        body: usize,
    },
    /// The set-up has a body with outlines at several heights and the contact method of Moreno et al. (2023).
    HullByPaperMethod {
        /// Index of the body.
        body: usize,
    },
    /// The set-up has a flexible dolphin and the contact method of Moreno et al. (2023), or a flexible dolphin and an
    /// integrator that is not semi-implicit.
    DolphinNeedsEngine {
        /// Name of the dolphin's body.
        body: String,
    },
    /// The set-up has a vessel with hydrodynamic data, but another method or integrator than the coupled method and the
    /// semi-implicit integrator, with which the engine moves bodies.
    SeakeepingNeedsEngine {
        /// Index of the vessel's body.
        body: usize,
    },
    /// A host program that moves its bodies itself has a set-up with a flexible dolphin.
    DolphinOfHost {
        /// Name of the dolphin's body.
        body: String,
    },
    /// A vessel starts where no depth is known.
    NoDepth(NoDepthUnder),
    /// A body index that does not exist, or the index of a fixed body where a floating one is needed.
    BadBody {
        /// The part of the set-up that refers to the body.
        owner: &'static str,
        /// Index of the body.
        body: usize,
    },
}

impl fmt::Display for SetupError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SetupError::Model(error) => error.fmt(f),
            SetupError::OutOfRange { field, value } => {
                write!(f, "{field} is {}", DisplayNumber(*value))
            }
            SetupError::DuplicateName { what, name } => {
                write!(f, "two {what} are named `{name}`")
            }
            SetupError::Tug { tug, error } => write!(f, "tug `{tug}`: {error}"),
            SetupError::Environment(error) => error.fmt(f),
            SetupError::Line(error) => error.fmt(f),
            SetupError::Anchor(error) => error.fmt(f),
            SetupError::LineHandling { error } => write!(f, "in the handling of lines, {error}"),
            SetupError::Change(error) => write!(f, "a planned change: {error}"),
            SetupError::Order(error) => error.fmt(f),
            SetupError::VesselByPaperMethod { body } => {
                write!(
                    f,
                    "body {body} is a vessel, but the paper's method has no mass matrix: use \
                     `method = \"coupled\"`"
                )
            }
            SetupError::HullByPaperMethod { body } => {
                write!(
                    f,
                    "body {body} has outlines at several heights, which need the coupled method: \
                     use `method = \"coupled\"`"
                )
            }
            SetupError::DolphinNeedsEngine { body } => write!(
                f,
                "body `{body}` is a flexible dolphin, which needs the coupled method and the semi-implicit \
                 integrator: use `method = \"coupled\"` and `integrator = \"semi_implicit\"`"
            ),
            SetupError::SeakeepingNeedsEngine { body } => write!(
                f,
                "body {body} is a vessel with hydrodynamic data, which needs the coupled method and the semi-implicit \
                 integrator: use `method = \"coupled\"` and `integrator = \"semi_implicit\"`"
            ),
            SetupError::DolphinOfHost { body } => write!(
                f,
                "body `{body}` is a flexible dolphin, which only a simulation can move, not a host that moves \
                 its bodies itself: make the dolphin a fixed body"
            ),
            SetupError::Berthing(error) => write!(f, "the berthing's {error}"),
            SetupError::NoDepth(error) => write!(f, "at the start: {error}"),
            SetupError::BadBody { owner, body } => {
                write!(f, "a {owner} refers to body {body}, which does not exist or is fixed")
            }
        }
    }
}

impl std::error::Error for SetupError {}

impl From<ModelError> for SetupError {
    fn from(error: ModelError) -> SetupError {
        SetupError::Model(error)
    }
}

/// The error for a step that failed; the failed step has not changed the simulation.
#[derive(Clone, Debug, PartialEq)]
pub struct SimError {
    /// Start of the step that failed (s).
    pub t_s: f64,
    /// The cause.
    pub cause: StepFault,
}

/// The cause of a step that failed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum StepFault {
    /// The contact engine refuses the step.
    Engine(StepError),
    /// A vessel is where no depth is known.
    NoDepth(NoDepthUnder),
}

impl fmt::Display for StepFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            StepFault::Engine(error) => error.fmt(f),
            StepFault::NoDepth(error) => error.fmt(f),
        }
    }
}

impl std::error::Error for StepFault {}

/// A vessel at a place where the bottom has no data.
#[derive(Clone, Debug, PartialEq)]
pub struct NoDepthUnder {
    /// Name of the vessel's body.
    pub body: String,
    /// The place under the hull at which no depth is known.
    pub place: NoDepth,
}

impl fmt::Display for NoDepthUnder {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` is off the data of the bottom: {}", self.body, self.place)
    }
}

impl std::error::Error for NoDepthUnder {}

impl fmt::Display for SimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at t = {} s: {}", self.t_s, self.cause)
    }
}

impl std::error::Error for SimError {}
