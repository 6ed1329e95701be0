//! One fender of a catalogue, with all data that a run needs.

use super::curve;
use fenderline_contact::Unloading;
use fenderline_sim::hydro::vessels::Standing;

use super::family::{FactorTable, Family, FenderSize};

/// A fender with its performance in SI units under rated conditions, without corrections and tolerance.
#[derive(Clone, Debug, PartialEq)]
pub struct CatalogueFender {
    /// Name of the fender's family.
    pub family: String,
    /// Designation of the size within the family; for a size that the catalogue does not have, a description of how the
    /// size was scaled.
    pub designation: String,
    /// Height of the fender, which is its extent in the direction of compression (m).
    pub height_m: f64,
    /// Length of the fender along the berth (m), if the size has a length.
    pub length_m: Option<f64>,
    /// Rated deflection of the fender (m).
    pub rated_deflection_m: f64,
    /// Reaction at the rated deflection (N).
    pub rated_reaction_n: f64,
    /// Energy absorbed up to the rated deflection (J), which is the integral of the reaction.
    pub rated_energy_j: f64,
    /// Published rated energy (J), if any was published. The published energy differs from the integral of the reaction
    /// by several per cent (13 % for the smallest pneumatic fender), and the program does not use it.
    pub published_energy_j: Option<f64>,
    /// Performance curve, piecewise linear from (0, 0): points of deflection (m) and reaction (N), with rising
    /// deflections. The curve may reach beyond the rated deflection.
    pub curve: Vec<(f64, f64)>,
    /// Unloading law, if the family has one.
    pub unloading: Option<Unloading>,
    /// Factors on the reaction by temperature (°C); empty if there are no data.
    pub temperature_factors: Vec<(f64, f64)>,
    /// Factors on the reaction by the time to the rated deflection (s); empty if there are no data.
    pub velocity_factors: Vec<(f64, f64)>,
    /// Factors on the energy by the angle of compression (rad); empty if there are no data.
    pub angle_energy_factors: Vec<(f64, f64)>,
    /// Factors on the reaction by the angle of compression (rad); empty if there are no data.
    pub angle_reaction_factors: Vec<(f64, f64)>,
    /// Manufacturing tolerance of reaction and energy, 0.1 for ±10 %, if known.
    pub tolerance: Option<f64>,
    /// Pressure on the hull at the rated deflection (N/m²); `None` if the pressure depends on the panel.
    pub hull_pressure_npm2: Option<f64>,
    /// Inner pressure of a pneumatic fender at zero deflection (N/m²).
    pub initial_pressure_npm2: Option<f64>,
    /// Whether a panel of the fender presses on the hull. False if any size of the fender's family has a hull pressure
    /// of its own.
    pub has_panel: bool,
    /// Sources of the performance curve and of the rating.
    pub source: String,
    /// The weaker one of the standings of performance curve and rating; a standing says how well a source is known. The
    /// standing is at best `Derived` if the published energy and the integral of the reaction differ by more than
    /// [`CatalogueFender::TOLERANCE`], because the curve was then not measured on this size. Unloading, factors and
    /// tolerance have separate standings in the family.
    pub standing: Standing,
}

impl CatalogueFender {
    /// The manufacturing tolerance that fenders commonly have, ±10 %.
    pub const TOLERANCE: f64 = 0.1;

    /// Difference between computed and published energy, as a share of the published energy; `None` if no energy was
    /// published.
    #[must_use]
    pub fn energy_difference(&self) -> Option<f64> {
        self.published_energy_j.map(|published_j| self.rated_energy_j / published_j - 1.0)
    }

    /// Makes the catalogue fender for a size of a family.
    pub(super) fn new(family: &Family, size: &FenderSize) -> CatalogueFender {
        let (height_m, reaction_n) = (size.height_m, size.rated_reaction_n);
        let rows = |table: &Option<FactorTable>| {
            table.as_ref().map_or_else(Vec::new, |table| table.points.clone())
        };
        let energy = curve::integral(&family.curve, family.rated_deflection);
        let mut fender = CatalogueFender {
            family: family.name.clone(),
            designation: size.designation.clone(),
            height_m,
            length_m: size.length_m,
            rated_deflection_m: family.rated_deflection * height_m,
            rated_reaction_n: reaction_n,
            rated_energy_j: energy * reaction_n * height_m,
            published_energy_j: size.published_energy_j,
            curve: family.curve.iter().map(|(d, r)| (d * height_m, r * reaction_n)).collect(),
            unloading: family
                .unloading
                .as_ref()
                .map(|own| scaled_law(&own.law, height_m, reaction_n)),
            temperature_factors: rows(&family.temperature),
            velocity_factors: rows(&family.velocity),
            angle_energy_factors: rows(&family.angle_energy),
            angle_reaction_factors: rows(&family.angle_reaction),
            tolerance: family.tolerance.as_ref().map(|tolerance| tolerance.value),
            hull_pressure_npm2: size.hull_pressure_npm2,
            initial_pressure_npm2: size.initial_pressure_npm2,
            has_panel: family.sizes.iter().all(|size| size.hull_pressure_npm2.is_none()),
            source: format!("curve: {}; rating: {}", family.source, size.source),
            standing: family.standing.max(size.standing),
        };
        if let Some(unloading) = &family.unloading {
            let (standing, source) = (unloading.standing.word(), &unloading.source);
            fender.source += &format!("; unloading ({standing}): {source}");
        }
        if let Some(difference) = fender.energy_difference() {
            let percent = 100.0 * difference.abs();
            let side = if difference < 0.0 { "below" } else { "above" };
            fender.source += &format!(
                "; energy: the curve's integral, {percent:.1} % {side} the published energy"
            );
            if difference.abs() > CatalogueFender::TOLERANCE {
                fender.standing = fender.standing.max(Standing::Derived);
            }
        }
        fender
    }
}

/// Scales the unloading law of a family to a fender's height and rated reaction.
fn scaled_law(law: &Unloading, height_m: f64, reaction_n: f64) -> Unloading {
    match law {
        Unloading::ReturnedEnergy(share) => Unloading::ReturnedEnergy(*share),
        Unloading::Curve(points) => {
            Unloading::Curve(points.iter().map(|[d, r]| [d * height_m, r * reaction_n]).collect())
        }
    }
}

/// Makes a geometrically similar size of another height. Lengths scale with the height, the reaction with the square of
/// the height, and so the energy with the cube of the height; pressures stay the same.
pub(super) fn scaled(reference: &FenderSize, height_m: f64) -> FenderSize {
    let ratio = height_m / reference.height_m;
    FenderSize {
        designation: format!("{height_m} m, scaled from {}", reference.designation),
        height_m,
        length_m: reference.length_m.map(|length_m| ratio * length_m),
        rated_reaction_n: ratio * ratio * reference.rated_reaction_n,
        published_energy_j: None,
        hull_pressure_npm2: reference.hull_pressure_npm2,
        initial_pressure_npm2: reference.initial_pressure_npm2,
        source: format!(
            "scaled from {} by height squared ({})",
            reference.designation, reference.source
        ),
        standing: reference.standing.max(Standing::Derived),
    }
}
