//! Fenders: their set-up, and the summary of each fender after a run.

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
    /// Index in [`crate::setup::Setup::bodies`] of the body that carries the fender.
    pub body: usize,
    /// Middle of the line where the fender is mounted, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction in which the fender faces, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of the fender's face along the berth (m).
    pub width_m: f64,
    /// Height of the fender's face (m). Width times height of the face is the area that presses on the hull.
    pub height_m: f64,
    /// Height of the middle of the fender's face above the still waterline (m), or above datum if the fender's body is
    /// fixed. The lever arm with which the fender's force heels a vessel follows from this height.
    pub above_water_m: f64,
    /// True if the fender floats, as a pneumatic fender does: `above_water_m` is then above the present water level,
    /// even on a fixed body.
    pub floating: bool,
    /// Distance from the mounting to the face of the uncompressed fender (m).
    pub projection_m: f64,
    /// Reaction by deflection.
    pub law: FenderLaw,
    /// Unloading law of the fender in the coupled method; `None` if the reaction falls by the restitution of the
    /// material.
    pub unloading: Option<Unloading>,
    /// Index in [`crate::setup::Setup::materials`] of the fender's material, which gives friction, restitution,
    /// damping, and the stiffness k of an area law.
    pub material: usize,
    /// Rated performance of the fender; `None` if no rating is given.
    pub rated: Option<Rated>,
    /// Stop at the end of the fender's travel.
    pub stop: Option<Stop>,
    /// Correction factors on the fender's reaction.
    pub factors: ReactionFactors,
    /// Factors on the energy capacity by the angle between face and hull: points of angle (rad) and factor. Catalogues
    /// give different angle factors for energy and reaction. If this list is empty, the factor on the reaction is used
    /// for the energy, too.
    pub energy_by_angle: Vec<[f64; 2]>,
    /// How the fender presses on the hull.
    pub hull_pressure: HullPressure,
    /// Permissible hull pressure (N/m²).
    pub hull_pressure_limit_npm2: Option<f64>,
    /// Source of the fender's data.
    pub source: Option<FenderSource>,
    /// The fender's panel on several cones, if it has such a panel. With a panel on several cones, law, stop and rated
    /// deflection are those of each cone; rated reaction and rated energy are the sums over all cones.
    pub panel: Option<Panel>,
    /// Its chains. Tension chains of a fender need a panel on several cones.
    pub chains: Vec<ChainSetup>,
    /// Mass that the fender's weight chains carry (kg).
    pub panel_mass_kg: f64,
}

impl FenderSetup {
    /// The compression time, by which factors by speed are tabulated (s), of a contact that begins at the speed
    /// `speed_mps` (m/s); `None` if the fender has no rating.
    #[must_use]
    pub fn compression_time_s(&self, speed_mps: f64) -> Option<f64> {
        let rated = self.rated.as_ref()?;
        Some(ReactionFactors::compression_time_s(speed_mps, rated.deflection_m))
    }

    /// Number of equal fenders behind the panel; 1 if the fender has no panel on several cones.
    #[must_use]
    pub fn cones(&self) -> f64 {
        self.panel.as_ref().map_or(1.0, |panel| panel.cones_m.len() as f64)
    }

    /// Pressure of the fender on the hull (N/m²) at a deflection (m) and a reaction (N); `None` if it is not known how
    /// the fender presses on the hull.
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
    /// The fender presses with a panel: the pressure is the reaction divided by the area of the face.
    OverFace,
    /// A pneumatic fender presses with its internal pressure, which is linear in the deflection from the initial
    /// pressure through the rated pressure. The pressure of a compressed gas is a convex function of deflection, so the
    /// linear pressure is conservative up to the rated deflection, and not beyond.
    Inner {
        /// Internal pressure at no deflection (N/m²).
        initial_npm2: f64,
        /// Internal pressure at the rated deflection (N/m²).
        rated_npm2: f64,
        /// Rated deflection (m).
        rated_deflection_m: f64,
    },
    /// The fender has no panel, and no pressure is given.
    Unknown,
}

/// A fender's rated performance, without corrections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rated {
    /// Rated deflection (m).
    pub deflection_m: f64,
    /// The rated reaction of the catalogue or the user (N); if a curve has no rated reaction, the largest reaction of
    /// the curve up to the rated deflection.
    pub reaction_n: f64,
    /// The largest reaction of the curve up to the rated deflection (N), but not less than the rated reaction. The
    /// curve of a fender that buckles can peak a little above the rated reaction; reactions up to this peak do not
    /// exceed the rating.
    pub largest_reaction_n: f64,
    /// Rated energy: the integral ∫ R dδ of the reaction up to the rated deflection (J).
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

    /// This rating with the rated reaction of the catalogue or the user (N).
    #[must_use]
    pub fn with_reaction(self, reaction_n: f64) -> Rated {
        Rated {
            reaction_n,
            largest_reaction_n: greater(self.largest_reaction_n, reaction_n),
            ..self
        }
    }

    /// The largest reaction of the curve divided by the rated reaction, which is 1 or a little more.
    #[must_use]
    pub fn curve_peak(&self) -> f64 {
        self.largest_reaction_n / self.reaction_n
    }
}

/// The source of a fender's data, and how well this source is known.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FenderSource {
    /// Name of the fender's family in the library; `None` for a fender whose reaction the scenario gives.
    pub family: Option<String>,
    /// Type and size of the fender, for reports.
    pub designation: String,
    /// Document or page.
    pub source: String,
    /// How well the source is known: `found`, `recalled`, `derived`, or `given` by the user.
    pub standing: String,
}
