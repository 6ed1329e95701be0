//! What can be wrong with a set-up or a run.

use std::fmt;

use fenderline_contact::{DisplayNumber, ModelError, StepError};

use crate::berthing::BerthingError;
use crate::environment::EnvironmentError;
use crate::mooring::MooringError;
use crate::order::OrderError;
use crate::range::OutOfRange;

/// A set-up that cannot be simulated.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SetupError {
    /// The contact model refuses it.
    Model(ModelError),
    /// Δt, duration or a load is not a number that can be used.
    OutOfRange {
        /// What.
        field: &'static str,
        /// Its value.
        value: f64,
    },
    /// Two bodies or two fenders have the same name.
    DuplicateName {
        /// `bodies` or `fenders`.
        what: &'static str,
        /// The name.
        name: String,
    },
    /// A particular of the berthing that no ship has.
    Berthing(BerthingError),
    /// A tug with a number that no tug has.
    Tug {
        /// The tug.
        tug: String,
        /// What is wrong.
        error: OutOfRange,
    },
    /// Water that is none.
    Environment(EnvironmentError),
    /// A line that cannot be made fast where the bodies are at the start.
    Line(MooringError),
    /// An order that cannot be carried out.
    Order(OrderError),
    /// A vessel with the paper's contact method, which knows one mass for all directions.
    VesselByPaperMethod {
        /// The index of her body.
        body: usize,
    },
    /// A load or pair names a body that is not there, or a load a fixed one.
    BadBody {
        /// What names it.
        owner: &'static str,
        /// The index.
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
            SetupError::Order(error) => error.fmt(f),
            SetupError::VesselByPaperMethod { body } => {
                write!(f, "body {body} is a vessel: the paper's method has no mass matrix for her")
            }
            SetupError::Berthing(error) => write!(f, "the berthing's {error}"),
            SetupError::BadBody { owner, body } => {
                write!(f, "a {owner} names body {body}, which is not there or is fixed")
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

/// A step that failed; the simulation is where it was before it.
#[derive(Clone, Debug, PartialEq)]
pub struct SimError {
    /// Start of the step (s).
    pub t_s: f64,
    /// Why.
    pub cause: StepError,
}

impl fmt::Display for SimError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "at t = {} s: {}", self.t_s, self.cause)
    }
}

impl std::error::Error for SimError {}
