//! Names that people give to recordings and exercises. A name that passes the check is valid on every operating system,
//! and is never a path.

use core::fmt;

/// Longest name of a file without its ending (bytes).
pub(crate) const LONGEST: usize = 60;
/// Names of devices on Windows (Microsoft: Naming Files, Paths, and Namespaces). The names of devices are reserved with
/// any ending. After COM and LPT a digit follows in a device's name.
const DEVICES: [&str; 4] = ["CON", "PRN", "AUX", "NUL"];
const PORTS: [&str; 2] = ["COM", "LPT"];

/// Why a file cannot have the name that a person gave.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum NameError {
    /// The name is empty, too long, or has characters other than letters, digits, `-` and `_`.
    Characters,
    /// The name is that of a device on Windows.
    Reserved(String),
}

impl fmt::Display for NameError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NameError::Characters => {
                write!(f, "a name has 1 to {LONGEST} letters, digits, - and _")
            }
            NameError::Reserved(name) => {
                write!(f, "{name} is the name of a device on Windows: choose another name")
            }
        }
    }
}

impl std::error::Error for NameError {}

/// Checks a name that a person gave, without its ending.
///
/// # Errors
/// [`NameError`].
pub(crate) fn check(name: &str) -> Result<(), NameError> {
    let letter = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if name.is_empty() || name.len() > LONGEST || !name.chars().all(letter) {
        return Err(NameError::Characters);
    }
    let upper = name.to_ascii_uppercase();
    let is_port = PORTS.iter().any(|port| {
        upper
            .strip_prefix(port)
            .is_some_and(|digit| digit.len() == 1 && digit > "0" && digit <= "9")
    });
    if is_port || DEVICES.contains(&upper.as_str()) {
        return Err(NameError::Reserved(name.to_owned()));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_no_path_and_no_device() {
        for good in ["a", "Half-way_in-001", "COM", "COM10", "CONS", "LPT0", &"x".repeat(LONGEST)] {
            assert_eq!(check(good), Ok(()), "{good}");
        }
        let long = "x".repeat(LONGEST + 1);
        for bad in
            ["", ".", "..", ".a", "a.toml", "a/b", "../a", "a\\b", "ü", "a b", "nul\0", &long]
        {
            assert_eq!(check(bad), Err(NameError::Characters), "{bad:?}");
        }
        for device in ["CON", "con", "Prn", "aux", "NUL", "com1", "LPT9"] {
            assert_eq!(check(device), Err(NameError::Reserved(device.to_owned())));
        }
    }
}
