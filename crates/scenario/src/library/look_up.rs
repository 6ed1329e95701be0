//! Errors when a fender is looked up in the library.

use core::fmt;

use fenderline_keys::printable::printable_number;
use fenderline_keys::sources::quoted;
use fenderline_keys::suggest::nearest;

/// The error for a name that the fender library or the vessel library does not have, or for a fender that cannot be
/// scaled. `Display` prints the error in one line; [`LookUpError::help`] says what to write instead.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum LookUpError {
    /// The name is unknown.
    Unknown {
        /// Kind of thing that the name should mean, such as `family of fenders`, `size of cone fenders` or `type of
        /// ship`.
        what: String,
        /// The unknown name.
        name: String,
        /// The known name that is most similar to the unknown name, if a known name is similar.
        nearest: Option<String>,
        /// All known names.
        known: Vec<String>,
    },
    /// The family has no size from which other sizes may be scaled.
    NoReference {
        /// The family.
        family: String,
    },
    /// The height or the reaction of a fender is out of range.
    OutOfRange {
        /// The quantity that is out of range, with its unit.
        quantity: &'static str,
        /// The value that is out of range.
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
            LookUpError::NoReference { .. } => {
                "give the rated reaction of the fender yourself".to_owned()
            }
            LookUpError::OutOfRange { .. } => {
                "a height must be 0.001 to 100 m, a reaction must be 1 to 1e9 N".to_owned()
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
                write!(
                    f,
                    "{family} fenders have no reference size from which other sizes could be scaled"
                )
            }
            LookUpError::OutOfRange { quantity, value } => {
                write!(f, "no fender has a {quantity} of {}", printable_number(*value))
            }
        }
    }
}

impl std::error::Error for LookUpError {}
