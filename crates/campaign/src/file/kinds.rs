//! The kinds of plans and of distributions, as the file has words for them.

use super::law::LawFamily;

/// The word of the key `plan`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PlanKind {
    FullFactorial,
    MonteCarlo,
    LatinHypercube,
    Sobol,
    Table,
}

/// The word of the key `distribution`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum FamilyKind {
    Law(LawFamily),
    Empirical,
}
