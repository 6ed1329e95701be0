//! Materials of a set-up.

use fenderline_contact::Material;

/// A material and its name.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedMaterial {
    /// Unique name.
    pub name: String,
    /// Parameters.
    pub material: Material,
}
