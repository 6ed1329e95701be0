//! The contents of a fender file, in SI units. The standing of a fender is the standing of its weakest part.

use fenderline_contact::Unloading;
use fenderline_sim::hydro::vessels::Standing;

/// Fenders of one shape.
#[derive(Clone, Debug, PartialEq)]
pub struct Family {
    /// Unique name.
    pub name: String,
    /// Rated deflection over height.
    pub rated_deflection: f64,
    /// Deflection over height against reaction over rated reaction, from (0, 0), deflections rising; piecewise linear.
    pub curve: Vec<(f64, f64)>,
    /// Deflection over height against energy over rated energy as published; empty if no energy was published. For
    /// comparison only.
    pub published_energy: Vec<(f64, f64)>,
    /// Where the curve comes from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
    /// How the reaction falls in unloading.
    pub unloading: Option<FamilyUnloading>,
    /// Temperature (°C) against factor on the reaction.
    pub temperature: Option<FactorTable>,
    /// Time to rated deflection (s) against factor on the reaction.
    pub velocity: Option<FactorTable>,
    /// Angle (rad) against factor on the energy.
    pub angle_energy: Option<FactorTable>,
    /// Angle (rad) against factor on the reaction.
    pub angle_reaction: Option<FactorTable>,
    /// Manufacturing tolerance of reaction and energy.
    pub tolerance: Option<Tolerance>,
    /// Index of the size from which other sizes are scaled.
    pub reference: Option<usize>,
    /// Sizes, in the order of the file.
    pub sizes: Vec<FenderSize>,
}

/// How the reaction of a family falls in unloading.
#[derive(Clone, Debug, PartialEq)]
pub struct FamilyUnloading {
    /// The share of energy returned, or the unloading curve with deflections over height and reactions over rated
    /// reaction.
    pub law: Unloading,
    /// Where the unloading law comes from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
}

/// A table of factors.
#[derive(Clone, Debug, PartialEq)]
pub struct FactorTable {
    /// Rows, the first number rising.
    pub points: Vec<(f64, f64)>,
    /// For which fenders the factors hold, if the file says so.
    pub holds: Option<String>,
    /// Where they come from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
}

/// A manufacturing tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct Tolerance {
    /// To either side, 0.1 for ±10 %.
    pub value: f64,
    /// Where the manufacturing tolerance comes from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
}

/// One size of a family.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSize {
    /// Unique within the family.
    pub designation: String,
    /// Extent in the direction of compression (m).
    pub height_m: f64,
    /// Length along the berth (m).
    pub length_m: Option<f64>,
    /// Rated reaction (N).
    pub rated_reaction_n: f64,
    /// Rated energy as published (J); for comparison only.
    pub published_energy_j: Option<f64>,
    /// Pressure on the hull at the rated deflection (N/m²).
    pub hull_pressure_npm2: Option<f64>,
    /// Inner pressure of a pneumatic fender at zero deflection (N/m²).
    pub initial_pressure_npm2: Option<f64>,
    /// Where the size comes from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
}

/// What the side of a type of ship bears.
#[derive(Clone, Debug, PartialEq)]
pub struct HullPressureLimit {
    /// Type of ship, unique.
    pub ship: String,
    /// Greatest mean pressure under a panel (N/m²).
    pub limit_npm2: f64,
    /// Where the hull pressure limit comes from.
    pub source: String,
    /// How well the source is known.
    pub standing: Standing,
}
