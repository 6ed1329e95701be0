//! Errors of looking up a fender.

use core::fmt;

use fenderline_keys::printable::printable_number;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

/// A name or rating that the library does not have. Displays in one line; [`LookUpError::help`] says what to write
/// instead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LookUpError {
    /// The name is unknown.
    Unknown {
        /// Kind of thing that the name should mean: `family`, `size of cone fenders`, `type of ship`.
        what: String,
        /// The name.
        name: String,
        /// The nearest known name, if one is near.
        nearest: Option<String>,
        /// All known names.
        known: Vec<String>,
    },
    /// The family has no size from which other sizes may be scaled.
    NoReference {
        /// The family.
        family: String,
    },
    /// A height or reaction out of range.
    OutOfRange {
        /// The number out of range, with its unit.
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
}

impl LookUpError {
    /// The error for an unknown name.
    pub(crate) fn unknown<'a>(
        what: String,
        name: &str,
        known: impl Iterator<Item = &'a str> + Clone,
    ) -> LookUpError {
        LookUpError::Unknown {
            what,
            name: name.to_owned(),
            nearest: nearest(name, known.clone()).map(str::to_owned),
            known: known.map(str::to_owned).collect(),
        }
    }

    /// What to write instead.
    #[must_use]
    pub fn help(&self) -> String {
        match self {
            LookUpError::Unknown { nearest: Some(nearest), .. } => {
                format!("did you mean \"{nearest}\"?")
            }
            LookUpError::Unknown { known, .. } if known.is_empty() => {
                "no such table was found: give height and rated reaction yourself".to_owned()
            }
            LookUpError::Unknown { known, .. } => {
                let known: Vec<_> = known.iter().map(|name| format!("\"{name}\"")).collect();
                format!("there are {}", known.join(", "))
            }
            LookUpError::NoReference { .. } => "give the rated reaction yourself".to_owned(),
            LookUpError::OutOfRange { .. } => {
                "a height is 0.001 to 100 m, a reaction 1 to 1e9 N".to_owned()
            }
        }
    }
}

impl fmt::Display for LookUpError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            LookUpError::Unknown { what, name, .. } => {
                write!(f, "there is no {what} named {}", quoted(name))
            }
            LookUpError::NoReference { family } => {
                write!(f, "{family} fenders have no reference size to scale from")
            }
            LookUpError::OutOfRange { quantity, value } => {
                write!(f, "no fender has a {quantity} of {}", printable_number(*value))
            }
        }
    }
}

impl std::error::Error for LookUpError {}
