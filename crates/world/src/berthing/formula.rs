//! Which formula gives Cm.

/// The formulas for Cm, the added mass factor.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AddedMassFormula {
    /// [`super::pianc_2002_added_mass`].
    Pianc2002,
    /// [`super::ueda_added_mass`].
    Ueda,
    /// [`super::vasco_costa_added_mass`].
    VascoCosta,
    /// [`super::ufc_added_mass`].
    Ufc,
}

impl AddedMassFormula {
    /// All of them, in the order of `BerthingOutcome` of the crate `fenderline-assess`.
    pub const ALL: [AddedMassFormula; 4] = [
        AddedMassFormula::Pianc2002,
        AddedMassFormula::Ueda,
        AddedMassFormula::VascoCosta,
        AddedMassFormula::Ufc,
    ];

    /// Its place in [`AddedMassFormula::ALL`].
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// Its name for people.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            AddedMassFormula::Pianc2002 => "PIANC 2002",
            AddedMassFormula::Ueda => "Ueda",
            AddedMassFormula::VascoCosta => "Vasco Costa",
            AddedMassFormula::Ufc => "UFC 4-152-01",
        }
    }

    /// Its name in scenarios and in `summary.json`.
    #[must_use]
    pub fn key(self) -> &'static str {
        match self {
            AddedMassFormula::Pianc2002 => "pianc_2002",
            AddedMassFormula::Ueda => "ueda",
            AddedMassFormula::VascoCosta => "vasco_costa",
            AddedMassFormula::Ufc => "ufc",
        }
    }
}

/// Where the Cm of a berthing comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AddedMass {
    /// A formula.
    By(AddedMassFormula),
    /// Given, 1 or more.
    Given(f64),
}
