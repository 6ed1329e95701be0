//! The choice of the formula for the added mass factor Cm.

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
    /// All formulas, in the order of the added masses of `BerthingOutcome` in the crate `fenderline-assess`.
    pub const ALL: [AddedMassFormula; 4] = [
        AddedMassFormula::Pianc2002,
        AddedMassFormula::Ueda,
        AddedMassFormula::VascoCosta,
        AddedMassFormula::Ufc,
    ];

    /// Index of the formula in [`AddedMassFormula::ALL`].
    #[must_use]
    pub fn index(self) -> usize {
        self as usize
    }

    /// Name of the formula in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            AddedMassFormula::Pianc2002 => "PIANC 2002",
            AddedMassFormula::Ueda => "Ueda",
            AddedMassFormula::VascoCosta => "Vasco Costa",
            AddedMassFormula::Ufc => "UFC 4-152-01",
        }
    }

    /// Name of the formula in scenarios and in `summary.json`.
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

/// The source of the Cm of a berthing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum AddedMass {
    /// A formula computes Cm.
    By(AddedMassFormula),
    /// The scenario gives Cm, 1 or more.
    Given(f64),
}
