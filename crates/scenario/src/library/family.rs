//! The contents of a fender file, in SI units. The standing of a fender, which says how well its source is known, is
//! the weakest standing of its parts.

use fenderline_contact::Unloading;
use fenderline_sim::hydro::vessels::Standing;

/// Fenders of one shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// Name of the family, which is unique.
    pub name: String,
    /// Rated deflection divided by the height of the fender.
    pub rated_deflection: f64,
    /// Performance curve, piecewise linear from (0, 0): each point is a deflection divided by the height, and a
    /// reaction divided by the rated reaction. The deflections rise.
    pub curve: Vec<(f64, f64)>,
    /// Published energy curve, for comparison only: each point is a deflection divided by the height, and an energy
    /// divided by the rated energy. The curve is empty if no energy was published.
    pub published_energy: Vec<(f64, f64)>,
    /// Source of the performance curve.
    pub source: String,
    /// How well the source of the performance curve is known.
    pub standing: Standing,
    /// How the reaction falls in unloading; `None` if the file has no unloading law.
    pub unloading: Option<FamilyUnloading>,
    /// Factors on the reaction by temperature (°C).
    pub temperature: Option<FactorTable>,
    /// Factors on the reaction by the time to the rated deflection (s).
    pub velocity: Option<FactorTable>,
    /// Factors on the energy by the angle of compression (rad).
    pub angle_energy: Option<FactorTable>,
    /// Factors on the reaction by the angle of compression (rad).
    pub angle_reaction: Option<FactorTable>,
    /// Manufacturing tolerance of reaction and energy.
    pub tolerance: Option<Tolerance>,
    /// Index of the size from which other sizes are scaled.
    pub reference: Option<usize>,
    /// Sizes of the family, in the order of the file.
    pub sizes: Vec<FenderSize>,
}

/// How the reaction of a family falls in unloading.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyUnloading {
    /// The unloading law: the share of the energy that is returned, or the unloading curve, whose deflections are
    /// divided by the height and reactions by the rated reaction.
    pub law: Unloading,
    /// Source of the unloading law.
    pub source: String,
    /// How well the source of the unloading law is known.
    pub standing: Standing,
}

/// A table of factors on the reaction or on the energy of a fender.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorTable {
    /// Rows of the table; the first number increases from row to row.
    pub points: Vec<(f64, f64)>,
    /// For which fenders the factors hold, if the file says so.
    pub holds: Option<String>,
    /// Source of the factors.
    pub source: String,
    /// How well the source of the factors is known.
    pub standing: Standing,
}

/// A manufacturing tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// The tolerance to either side: 0.1 for ±10 %.
    pub value: f64,
    /// Source of the manufacturing tolerance.
    pub source: String,
    /// How well the source of the manufacturing tolerance is known.
    pub standing: Standing,
}

/// One size of a family of fenders.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSize {
    /// Designation of the size, unique within the family.
    pub designation: String,
    /// Height of the fender, which is its extent in the direction of compression (m).
    pub height_m: f64,
    /// Length of the fender along the berth (m).
    pub length_m: Option<f64>,
    /// Rated reaction (N).
    pub rated_reaction_n: f64,
    /// Published rated energy (J), for comparison only.
    pub published_energy_j: Option<f64>,
    /// Pressure on the hull at the rated deflection (N/m²).
    pub hull_pressure_npm2: Option<f64>,
    /// Inner pressure of a pneumatic fender at zero deflection (N/m²).
    pub initial_pressure_npm2: Option<f64>,
    /// Source of the size and its rating.
    pub source: String,
    /// How well the source of the size is known.
    pub standing: Standing,
}

/// The pressure that the side of a type of ship can bear.
#[derive(Clone, Debug, PartialEq)]
pub struct HullPressureLimit {
    /// Type of ship, unique.
    pub ship: String,
    /// Greatest mean pressure under a fender panel (N/m²).
    pub limit_npm2: f64,
    /// Source of the hull pressure limit.
    pub source: String,
    /// How well the source of the hull pressure limit is known.
    pub standing: Standing,
}
