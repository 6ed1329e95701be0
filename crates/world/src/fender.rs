//! Fenders: their set-up, and the summary of each one after a run.

mod summaries;
mod summary;

use fenderline_contact::number::greater;
use fenderline_contact::{FenderLaw, Panel, ReactionFactors, Stop, Unloading, Vec2};

pub use self::summaries::FenderSummaries;
pub use self::summary::{FenderSummary, HullMet};
use crate::chain::ChainSetup;

/// A fender of a [`crate::setup::Setup`].
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSetup {
    /// Unique name.
    pub name: String,
    /// Index of the body that carries it, in [`crate::setup::Setup::bodies`].
    pub body: usize,
    /// Middle of the line where it is mounted, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction in which it faces, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of its face along the berth (m).
    pub width_m: f64,
    /// Height of its face (m). Width times height is the area that presses on the hull.
    pub height_m: f64,
    /// Height of the middle of its face above the still waterline (m), or above datum if its body is fixed. The lever
    /// arm with which its force heels a vessel follows from it.
    pub above_water_m: f64,
    /// It floats, as a pneumatic fender does: on a fixed body too `above_water_m` is above the water of the moment.
    pub floating: bool,
    /// Distance from the mounting to the face, uncompressed (m).
    pub projection_m: f64,
    /// Reaction by deflection.
    pub law: FenderLaw,
    /// Unloading law, used by the coupled method; `None`: unloading by the restitution of the material.
    pub unloading: Option<Unloading>,
    /// Index into [`crate::setup::Setup::materials`]: friction, restitution, damping, and k of an area law.
    pub material: usize,
    /// Rated performance; `None` if no rating is given.
    pub rated: Option<Rated>,
    /// Stop at the end of its travel.
    pub stop: Option<Stop>,
    /// Correction factors on its reaction.
    pub factors: ReactionFactors,
    /// Factor on the energy capacity by the angle between face and hull: points (angle (rad), factor). Catalogues
    /// give different angle factors for energy and reaction. If empty, the factor of the reaction is used.
    pub energy_by_angle: Vec<[f64; 2]>,
    /// How it presses on the hull.
    pub hull_pressure: HullPressure,
    /// Permissible hull pressure (N/m²).
    pub hull_pressure_limit_npm2: Option<f64>,
    /// Where its data come from.
    pub source: Option<FenderSource>,
    /// A panel on several cones. Law, stop and rated deflection are then those of each cone; rated reaction and energy are
    /// the sums over all cones.
    pub panel: Option<Panel>,
    /// Its chains. Tension chains need a panel on several cones.
    pub chains: Vec<ChainSetup>,
    /// Mass that its weight chains carry (kg).
    pub panel_mass_kg: f64,
}

impl FenderSetup {
    /// The compression time of a contact that begins at a speed (m/s), by which factors by speed are tabulated (s); `None` without a rating.
    #[must_use]
    pub fn compression_time_s(&self, speed_mps: f64) -> Option<f64> {
        let rated = self.rated.as_ref()?;
        Some(ReactionFactors::compression_time_s(speed_mps, rated.deflection_m))
    }

    /// Number of equal fenders behind a panel; 1 without one.
    #[must_use]
    pub fn cones(&self) -> f64 {
        self.panel.as_ref().map_or(1.0, |panel| panel.cones_m.len() as f64)
    }

    /// Pressure on the hull (N/m²) at a deflection (m) and a reaction (N); `None` if it is not known how the fender
    /// presses on the hull.
    #[must_use]
    pub fn hull_pressure_npm2(&self, deflection_m: f64, reaction_n: f64) -> Option<f64> {
        match self.hull_pressure {
            HullPressure::OverFace => Some(reaction_n / (self.width_m * self.height_m)),
            HullPressure::Inner { initial_npm2, rated_npm2, rated_deflection_m } => {
                let share = deflection_m / rated_deflection_m;
                Some(initial_npm2 + (rated_npm2 - initial_npm2) * share)
            }
            HullPressure::Unknown => None,
        }
    }
}

/// How a fender presses on the hull.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum HullPressure {
    /// By a panel: the reaction over the area of the face.
    OverFace,
    /// A pneumatic fender: the internal pressure, linear in the deflection from the initial pressure through the
    /// rated one. The pressure of a compressed gas is a convex function of deflection, so the line is conservative up
    /// to the rated deflection, and not beyond.
    Inner {
        /// At no deflection (N/m²).
        initial_npm2: f64,
        /// At the rated deflection (N/m²).
        rated_npm2: f64,
        /// Rated deflection (m).
        rated_deflection_m: f64,
    },
    /// No panel, and no pressure given.
    Unknown,
}

/// A fender's rated performance, without corrections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rated {
    /// Deflection (m).
    pub deflection_m: f64,
    /// The rated reaction (N): that of catalogue or user; of a curve without one, its largest reaction up to the rated deflection.
    pub reaction_n: f64,
    /// The largest reaction of the curve up to the rated deflection (N), not less than the rated one. A curve that buckles can peak
    /// a little above its rated reaction: within it the fender is not over-rated.
    pub largest_reaction_n: f64,
    /// ∫ R dδ up to the rated deflection (J).
    pub energy_j: f64,
}

impl Rated {
    /// The rating of a reaction curve at a deflection; `None` for an area law, which has no rating.
    #[must_use]
    pub fn of(law: &FenderLaw, deflection_m: f64) -> Option<Rated> {
        let FenderLaw::Curve(points) = law else { return None };
        let within = points.iter().filter(|p| p[0] < deflection_m).map(|p| p[1]);
        let reaction_n = within.fold(law.reaction_n(deflection_m), greater);
        let energy_j = law.energy_j(deflection_m);
        Some(Rated { deflection_m, reaction_n, largest_reaction_n: reaction_n, energy_j })
    }

    /// The same with the rated reaction of catalogue or user (N).
    #[must_use]
    pub fn with_reaction(self, reaction_n: f64) -> Rated {
        Rated {
            reaction_n,
            largest_reaction_n: greater(self.largest_reaction_n, reaction_n),
            ..self
        }
    }

    /// The largest reaction of the curve over the rated one, 1 or a little more.
    #[must_use]
    pub fn curve_peak(&self) -> f64 {
        self.largest_reaction_n / self.reaction_n
    }
}

/// The source of a fender's data, and how well it is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FenderSource {
    /// Type and size, for reports.
    pub designation: String,
    /// Document or page.
    pub source: String,
    /// `found`, `recalled`, `derived` or `given` by the user.
    pub standing: String,
}
