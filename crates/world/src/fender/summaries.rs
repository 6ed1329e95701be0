//! Builds the summary of each fender from the steps of a run.

use fenderline_contact::number::greater;
use fenderline_contact::{Contact, ReactionFactors, combined_angle_rad};
use fenderline_ship::constants::STANDARD_GRAVITY_MPS2;

use super::{FenderSetup, FenderSummary, HullMet};
use crate::chain::{ChainKind, ChainLoad, ChainSummary, ChainTension, add_others, add_tension};
use crate::hull::{HullTouch, larger_force_n};
use crate::panel::{ConeUse, PanelSummary};
use crate::record::StepRecord;
use crate::setup::material::NamedMaterial;

/// The summaries of all fenders, which are updated in each step.
#[derive(Clone, Debug, Default)]
pub struct FenderSummaries {
    /// The summaries, in the order of the set-up; `None` for a fender that was never touched.
    pub all: Vec<Option<FenderSummary>>,
    /// Reaction and energy of each fender in this step.
    now: Vec<Now>,
    /// Whether a fender that was touched has chains.
    has_chains: bool,
    /// Tensions of the chains of all fenders that are touched in this step.
    pub chains: Vec<ChainTension>,
}

/// Reaction and energy of a fender in a step.
#[derive(Clone, Copy, Debug, Default)]
struct Now {
    is_touched: bool,
    reaction_n: f64,
    energy_j: f64,
}

impl FenderSummaries {
    /// Makes the summaries of `fenders` fenders as they are before the first step.
    pub fn new(fenders: usize) -> FenderSummaries {
        FenderSummaries {
            all: vec![None; fenders],
            now: vec![Now::default(); fenders],
            has_chains: false,
            chains: Vec::new(),
        }
    }

    /// Forgets everything that happened to the fenders in the run so far.
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

/// Adds the deflection of the fender in a step to its summary. Returns true if the deflection is the largest so far.
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

/// Updates the peaks of energy and reaction in a summary, and the values that depend on these peaks and on the largest
/// deflection.
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
    // Hull pressure grows with deflection and reaction, so its peak follows from their peaks.
    let pressure_npm2 =
        setup.hull_pressure_npm2(summary.peak_deflection_m, summary.peak_reaction_n);
    summary.peak_hull_pressure_npm2 = pressure_npm2;
    summary.share_of_hull_pressure =
        pressure_npm2.zip(setup.hull_pressure_limit_npm2).map(|(pressure, limit)| pressure / limit);
}

/// Energy and reaction of the most compressed cone of a panel, each divided by the rated value of a cone.
fn shares_of_cone(setup: &FenderSetup, summary: &FenderSummary) -> (Option<f64>, Option<f64>) {
    let worst = ConeUse::of(setup, summary, summary.peak_deflection_m);
    worst.map_or((None, None), |cone| (cone.share_of_rated_energy, cone.share_of_rated_reaction))
}
