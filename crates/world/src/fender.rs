//! Fenders: their set-up, and the summary of each one after a run.

use fenderline_contact::number::greater;
use fenderline_contact::{
    Contact, FenderLaw, Panel, ReactionFactors, Stop, Unloading, Vec2, combined_angle_rad,
};

use crate::chain::{
    ChainKind, ChainLoad, ChainSetup, ChainSummary, ChainTension, add_others, add_tension,
};
use crate::hull::{HullTouch, larger_force_n};
use crate::panel::{ConeUse, PanelSummary};
use crate::record::StepRecord;
use crate::setup::NamedMaterial;
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;

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

/// Summary of one fender after a run. Peaks are those within the steps, sub-steps included.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSummary {
    /// Index into [`crate::setup::Setup::fenders`].
    pub fender: usize,
    /// Start of the first step in which it was touched (s).
    pub first_touch_s: f64,
    /// Normal speed V_n in that step (m/s), positive when approaching.
    pub approach_speed_mps: f64,
    /// Angle between face and hull in that step (rad).
    pub approach_angle_rad: f64,
    /// How it meets a hull by height; `None` for hulls with one outline.
    pub hull: Option<HullMet>,
    /// Factor on its reaction, fixed at first touch: temperature, tolerance, speed and angle.
    pub factor: f64,
    /// Largest deflection (m).
    pub peak_deflection_m: f64,
    /// Start of the step of the largest deflection (s).
    pub peak_deflection_at_s: f64,
    /// Largest reaction along its axis (N).
    pub peak_reaction_n: f64,
    /// Start of the step of the largest reaction (s). For a fender that buckles it comes before the largest
    /// deflection.
    pub peak_reaction_at_s: f64,
    /// Largest energy absorbed along the loading curve (J), the quantity that catalogues rate.
    pub peak_energy_j: f64,
    /// Start of the step of that energy (s).
    pub peak_energy_at_s: f64,
    /// Largest pressure on the hull (N/m²), by [`FenderSetup::hull_pressure_npm2`].
    pub peak_hull_pressure_npm2: Option<f64>,
    /// Energy capacity with the correction factors (J).
    pub capacity_j: Option<f64>,
    /// Peak energy over the capacity.
    pub share_of_rated_energy: Option<f64>,
    /// Peak reaction over the rated reaction with the correction factors.
    pub share_of_rated_reaction: Option<f64>,
    /// The same over the largest reaction of the curve up to the rated deflection: above 1 the fender is over-rated.
    pub share_of_largest_reaction: Option<f64>,
    /// Peak deflection over the rated deflection.
    pub share_of_rated_deflection: Option<f64>,
    /// Peak hull pressure over the permissible one.
    pub share_of_hull_pressure: Option<f64>,
    /// True if it was deflected beyond the start of its stop, or beyond its projection if it has none.
    pub failed: bool,
    /// Deflection in the last step; 0 if it is not touched (m).
    pub last_deflection_m: f64,
    /// Reaction in the last step; 0 if it is not touched (N).
    pub last_reaction_n: f64,
    /// Its panel, if it has one on several cones. The shares of the rated energy, reaction and deflection are then those of
    /// the most compressed cone, and the peak deflection is that cone's.
    pub panel: Option<PanelSummary>,
    /// Its chains, in the order of the set-up.
    pub chains: Vec<ChainSummary>,
}

/// How a fender meets a hull with outlines by height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HullMet {
    /// Height of the first touch (m): above the keel of a floating body, above datum of a fixed one.
    pub height_m: f64,
    /// Angle by which the hull's side leans out over the fender at the first touch (rad), positive for flare.
    pub vertical_angle_rad: f64,
    /// The vertical force on the hull of the largest size: its mean over a step (N), positive up.
    pub peak_vertical_force_n: f64,
}

impl FenderSummary {
    /// Peak energy over the rated energy of the catalogue: without the factors of this run for temperature, tolerance, speed and
    /// angle. `None` without a rating.
    #[must_use]
    pub fn share_of_catalogue_energy(&self, setup: &FenderSetup) -> Option<f64> {
        let (capacity_j, rated) = self.capacity_j.zip(setup.rated)?;
        self.share_of_rated_energy.map(|share| share * capacity_j / rated.energy_j)
    }

    /// Peak reaction over the rated reaction of the catalogue, without the factors of this run. `None` without a rating.
    #[must_use]
    pub fn share_of_catalogue_reaction(&self) -> Option<f64> {
        self.share_of_rated_reaction.map(|share| share * self.factor)
    }

    /// The quantity that governs, `energy`, `deflection` or `reaction`, and its peak over the rated one; `None` without a
    /// rating.
    ///
    /// A fender that buckles reaches its rated reaction at about a third of its travel and stays near it, so its
    /// reaction governs only where it is above the largest that its curve has up to the rated deflection.
    #[must_use]
    pub fn governing(&self) -> Option<(&'static str, f64)> {
        let energy = self.share_of_rated_energy?;
        let deflection = self.share_of_rated_deflection?;
        let reaction = self.share_of_largest_reaction?;
        let mut governing = ("energy", energy);
        if deflection > governing.1 {
            governing = ("deflection", deflection);
        }
        if reaction > 1.0 && reaction > governing.1 {
            governing = ("reaction", self.share_of_rated_reaction?);
        }
        Some(governing)
    }
}

/// Builds the [`FenderSummary`]s, in the order of the set-up; `None` for a fender that was never touched.
#[derive(Clone, Debug, Default)]
pub struct FenderSummaries {
    /// The summaries.
    pub all: Vec<Option<FenderSummary>>,
    /// Each fender in this step.
    now: Vec<Now>,
    /// Whether a fender that was touched has chains.
    has_chains: bool,
    /// Chains of the fenders that are touched in this step.
    pub chains: Vec<ChainTension>,
}

/// What a fender does in a step.
#[derive(Clone, Copy, Debug, Default)]
struct Now {
    is_touched: bool,
    reaction_n: f64,
    energy_j: f64,
}

impl FenderSummaries {
    /// Before the first step, for a number of fenders.
    pub fn new(fenders: usize) -> FenderSummaries {
        FenderSummaries {
            all: vec![None; fenders],
            now: vec![Now::default(); fenders],
            has_chains: false,
            chains: Vec::new(),
        }
    }

    /// Forgets the run.
    pub fn restart(&mut self) {
        self.all.fill(None);
        self.now.fill(Now::default());
        self.chains.clear();
        self.has_chains = false;
    }

    /// Adds one step.
    pub fn add(
        &mut self,
        (setups, materials): (&[FenderSetup], &[NamedMaterial]),
        step: &StepRecord<'_>,
        sinking_mps: impl Fn(&Contact, usize) -> f64,
    ) {
        let t_s = step.t_s;
        if setups.is_empty() {
            return;
        }
        self.now.fill(Now::default());
        self.chains.clear();
        for summary in self.all.iter_mut().flatten() {
            (summary.last_deflection_m, summary.last_reaction_n) = (0.0, 0.0);
            summary.chains.iter_mut().for_each(|chain| chain.last_tension_n = 0.0);
        }
        for (number, contact) in step.contacts.iter().enumerate() {
            let Some(id) = contact.fender else { continue };
            let touch = step.hull_touches.get(number).copied().flatten();
            let index = id.0 as usize;
            let setup = &setups[index];
            let is_first = self.all[index].is_none();
            let summary = self.all[index]
                .get_or_insert_with(|| first_touch(index, setup, (contact, touch), t_s));
            self.has_chains |= !summary.chains.is_empty();
            let now = &mut self.now[index];
            now.is_touched = true;
            // Forces of several hulls on one fender add up. The reaction is the component along the fender's axis.
            let along = libm::cos(contact.tilt_rad);
            now.reaction_n += contact.peak_normal_force_n * along;
            now.energy_j += contact.energy.peak_absorbed_j;
            summary.last_reaction_n += contact.normal_force_n * along;
            let is_deeper = add_deflection(summary, setup, contact, t_s);
            let has_changed = is_first || is_deeper;
            if let (Some(met), Some(touch)) = (&mut summary.hull, touch) {
                let up_n = contact.normal_force_n * touch.slope;
                met.peak_vertical_force_n = larger_force_n(met.peak_vertical_force_n, up_n);
            }
            update_peaks(summary, setup, *now, has_changed, t_s);
            if setup.chains.iter().any(|chain| chain.kind != ChainKind::Tension) {
                let material = &materials[setup.material].material;
                let load = ChainLoad::of(contact, material, sinking_mps(contact, setup.body));
                let weight_n = STANDARD_GRAVITY_MPS2 * setup.panel_mass_kg;
                let by = (material.shear_stiffness_npm, weight_n);
                add_others(&mut summary.chains, &setup.chains, load, by, t_s);
            }
        }
        for motion in step.panels {
            let index = motion.fender.0 as usize;
            let Some(summary) = &mut self.all[index] else { continue };
            if let Some(panel) = &mut summary.panel {
                panel.add(motion, t_s);
            }
            add_tension(&mut summary.chains, &setups[index].chains, motion, t_s);
        }
        if !self.has_chains {
            return;
        }
        for summary in self.all.iter().flatten().filter(|summary| !summary.chains.is_empty()) {
            let index = summary.fender;
            if self.now[index].is_touched {
                let setups = &setups[index].chains;
                self.chains.extend(ChainTension::of(index, setups, &summary.chains));
            }
        }
    }
}

/// The summary of a fender at its first touch.
fn first_touch(
    index: usize,
    setup: &FenderSetup,
    (contact, touch): (&Contact, Option<HullTouch>),
    t_s: f64,
) -> FenderSummary {
    let slope = touch.map_or(0.0, |touch| touch.slope);
    let angle_rad = combined_angle_rad(contact.tilt_rad, slope);
    let capacity_j = setup.rated.map(|rated| {
        let energy_factor = match setup.energy_by_angle.as_slice() {
            [] => contact.factor,
            points => {
                let by_angle = ReactionFactors {
                    by_angle: setup.factors.by_angle.clone(),
                    ..ReactionFactors::default()
                };
                let of_energy =
                    ReactionFactors { by_angle: points.to_vec(), ..ReactionFactors::default() };
                contact.factor * of_energy.of_angle(angle_rad) / by_angle.of_angle(angle_rad)
            }
        };
        rated.energy_j * energy_factor
    });
    FenderSummary {
        fender: index,
        first_touch_s: t_s,
        approach_speed_mps: contact.v_normal_mps,
        approach_angle_rad: contact.tilt_rad,
        hull: touch.map(|touch| HullMet {
            height_m: touch.height_m,
            vertical_angle_rad: libm::atan(touch.slope),
            peak_vertical_force_n: 0.0,
        }),
        factor: contact.factor,
        peak_deflection_m: 0.0,
        peak_deflection_at_s: t_s,
        peak_reaction_n: 0.0,
        peak_reaction_at_s: t_s,
        peak_energy_j: 0.0,
        peak_energy_at_s: t_s,
        peak_hull_pressure_npm2: None,
        capacity_j,
        share_of_rated_energy: setup.rated.map(|_| 0.0),
        share_of_rated_reaction: setup.rated.map(|_| 0.0),
        share_of_largest_reaction: setup.rated.map(|_| 0.0),
        share_of_rated_deflection: setup.rated.map(|_| 0.0),
        share_of_hull_pressure: None,
        failed: false,
        last_deflection_m: 0.0,
        last_reaction_n: 0.0,
        panel: setup.panel.as_ref().map(|panel| PanelSummary::new(panel, t_s)),
        chains: setup.chains.iter().map(|chain| ChainSummary::new(chain, t_s)).collect(),
    }
}

/// Adds the deflection in a step. Returns true where it is the largest so far.
fn add_deflection(
    summary: &mut FenderSummary,
    setup: &FenderSetup,
    contact: &Contact,
    t_s: f64,
) -> bool {
    summary.last_deflection_m = greater(summary.last_deflection_m, contact.depth_m);
    let deflection_m = contact.peak_depth_m;
    let is_deeper = deflection_m > summary.peak_deflection_m;
    if is_deeper {
        summary.peak_deflection_m = deflection_m;
        summary.peak_deflection_at_s = t_s;
        summary.share_of_rated_deflection = setup.rated.map(|r| deflection_m / r.deflection_m);
        let travel_m = setup.stop.map_or(setup.projection_m, |stop| stop.from_m);
        summary.failed |= deflection_m > travel_m;
    }
    is_deeper
}

/// Updates the peaks of energy and reaction, and what depends on them and on the largest deflection, which may have changed.
fn update_peaks(
    summary: &mut FenderSummary,
    setup: &FenderSetup,
    Now { reaction_n, energy_j, .. }: Now,
    has_changed: bool,
    t_s: f64,
) {
    let (is_stronger, is_fuller) =
        (reaction_n > summary.peak_reaction_n, energy_j > summary.peak_energy_j);
    if !has_changed && !is_stronger && !is_fuller {
        return;
    }
    if is_fuller {
        summary.peak_energy_j = energy_j;
        summary.peak_energy_at_s = t_s;
        summary.share_of_rated_energy = summary.capacity_j.map(|capacity_j| energy_j / capacity_j);
    }
    if is_stronger {
        summary.peak_reaction_n = reaction_n;
        summary.peak_reaction_at_s = t_s;
        summary.share_of_rated_reaction =
            setup.rated.map(|rated| reaction_n / (rated.reaction_n * summary.factor));
    }
    if setup.panel.is_some() {
        let (energy, reaction) = shares_of_cone(setup, summary);
        (summary.share_of_rated_energy, summary.share_of_rated_reaction) = (energy, reaction);
    }
    let largest = summary.share_of_rated_reaction.zip(setup.rated);
    summary.share_of_largest_reaction = largest.map(|(share, rated)| share / rated.curve_peak());
    // Hull pressure grows with deflection and reaction, so its peak is at their peaks.
    let pressure_npm2 =
        setup.hull_pressure_npm2(summary.peak_deflection_m, summary.peak_reaction_n);
    summary.peak_hull_pressure_npm2 = pressure_npm2;
    summary.share_of_hull_pressure =
        pressure_npm2.zip(setup.hull_pressure_limit_npm2).map(|(pressure, limit)| pressure / limit);
}

/// Energy and reaction of the most compressed cone of a panel over its rated ones.
fn shares_of_cone(setup: &FenderSetup, summary: &FenderSummary) -> (Option<f64>, Option<f64>) {
    let worst = ConeUse::of(setup, summary, summary.peak_deflection_m);
    worst.map_or((None, None), |cone| (cone.share_of_rated_energy, cone.share_of_rated_reaction))
}
