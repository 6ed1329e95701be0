//! Fenders: what a set-up says of them and what a run did to them.

use fenderline_contact::number::greater;
use fenderline_contact::{Contact, FenderLaw, ReactionFactors, Stop, Unloading, Vec2};

/// A fender of a [`crate::Setup`].
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSetup {
    /// Unique name.
    pub name: String,
    /// Index of the body that carries it, in [`crate::Setup::bodies`].
    pub body: usize,
    /// Middle of the line where it is mounted, in the body's frame (m).
    pub position_m: Vec2,
    /// Direction in which it faces, in the body's frame: 0 forward, positive to starboard (rad).
    pub facing_rad: f64,
    /// Width of its face along the berth (m).
    pub width_m: f64,
    /// Height of its face (m); with the width the area that presses on the hull.
    pub height_m: f64,
    /// Middle of its face above the still waterline (m), above datum where its body is fixed: where its force
    /// heels a vessel.
    pub above_water_m: f64,
    /// From the mounting to the face, uncompressed (m).
    pub projection_m: f64,
    /// Reaction from deflection.
    pub law: FenderLaw,
    /// How its reaction falls when the hull retreats, by the coupled method; `None`: by its material's restitution.
    pub unloading: Option<Unloading>,
    /// Index into [`crate::Setup::materials`]: friction, restitution, damping, and k of an area law.
    pub material: usize,
    /// What it is made for; `None` where nobody said.
    pub rated: Option<Rated>,
    /// Where it stiffens to a stop.
    pub stop: Option<Stop>,
    /// Corrections of its reaction.
    pub factors: ReactionFactors,
    /// Points (angle between face and hull (rad), factor on the energy that it can take): catalogues
    /// give another factor for the energy than for the reaction. Empty: that of the reaction.
    pub energy_by_angle: Vec<[f64; 2]>,
    /// How it presses on the hull.
    pub hull_pressure: HullPressure,
    /// The pressure that the hull takes (N/m²).
    pub hull_pressure_limit_npm2: Option<f64>,
    /// Where its data come from.
    pub source: Option<FenderSource>,
}

impl FenderSetup {
    /// Pressure on the hull (N/m²) at a deflection (m) and a reaction (N); `None` where nobody said how
    /// it presses.
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
    /// By its inner pressure, on as much of its skin as lies against the hull: a straight line from the
    /// pressure at no deflection to the one at the rated deflection, and on beyond it. A gas that is pressed
    /// together rises ever faster, so the line is on the safe side up to the rated deflection, and not beyond.
    Inner {
        /// At no deflection (N/m²).
        initial_npm2: f64,
        /// At the rated deflection (N/m²).
        rated_npm2: f64,
        /// Rated deflection (m).
        rated_deflection_m: f64,
    },
    /// Without a panel, and nobody said how hard.
    Unknown,
}

/// A fender's rated performance, without corrections.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rated {
    /// Deflection (m).
    pub deflection_m: f64,
    /// Largest reaction up to the rated deflection (N).
    pub reaction_n: f64,
    /// ∫ R dδ up to the rated deflection (J).
    pub energy_j: f64,
}

impl Rated {
    /// Of a reaction curve up to a deflection; `None` for an area law, which has none.
    #[must_use]
    pub fn of(law: &FenderLaw, deflection_m: f64) -> Option<Rated> {
        let FenderLaw::Curve(points) = law else { return None };
        let within = points.iter().filter(|p| p[0] < deflection_m).map(|p| p[1]);
        let reaction_n = within.fold(law.reaction_n(deflection_m), greater);
        Some(Rated { deflection_m, reaction_n, energy_j: law.energy_j(deflection_m) })
    }
}

/// Where a fender's data come from, and how sure they are.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FenderSource {
    /// Type and size, as a report names them.
    pub designation: String,
    /// Document or page.
    pub source: String,
    /// `found`, `recalled`, `derived` or `given` by the user.
    pub standing: String,
}

/// What a run did to one fender. Peaks are the true ones, sub-steps included.
#[derive(Clone, Debug, PartialEq)]
pub struct FenderSummary {
    /// Index into [`crate::Setup::fenders`].
    pub fender: usize,
    /// Start of the first step in which it was touched (s).
    pub first_touch_s: f64,
    /// V_n in that step (m/s), positive approaching.
    pub approach_speed_mps: f64,
    /// Angle between face and hull in that step (rad).
    pub approach_angle_rad: f64,
    /// The factor on its reaction at first touch: temperature, tolerance, speed and angle.
    pub factor: f64,
    /// Largest deflection (m), and when (s).
    pub peak_deflection_m: f64,
    /// Start of the step of the largest deflection (s).
    pub peak_deflection_at_s: f64,
    /// Largest reaction along its axis (N).
    pub peak_reaction_n: f64,
    /// Start of the step of the largest reaction (s); a fender that buckles has it before its largest
    /// deflection.
    pub peak_reaction_at_s: f64,
    /// Largest energy at a time that its loading curve takes to where it is (J), which catalogues rate.
    pub peak_energy_j: f64,
    /// Largest pressure on the hull (N/m²), by [`FenderSetup::hull_pressure_npm2`].
    pub peak_hull_pressure_npm2: Option<f64>,
    /// Energy that it can take with its factors (J).
    pub capacity_j: Option<f64>,
    /// Peak energy over that.
    pub share_of_rated_energy: Option<f64>,
    /// Peak reaction over the rated one with its factors.
    pub share_of_rated_reaction: Option<f64>,
    /// Peak deflection over the rated one.
    pub share_of_rated_deflection: Option<f64>,
    /// Peak pressure over what the hull takes.
    pub share_of_hull_pressure: Option<f64>,
    /// True where it was deflected beyond its stop, or beyond its projection.
    pub failed: bool,
    /// Deflection and reaction in the last step; 0 where it is not touched then (m, N).
    pub last_deflection_m: f64,
    /// Reaction in the last step (N).
    pub last_reaction_n: f64,
}

/// Collects [`FenderSummary`]s step by step, in the order of the set-up's fenders; `None` for one that
/// was never touched.
#[derive(Clone, Debug, Default)]
pub(crate) struct FenderSummaries {
    pub(crate) all: Vec<Option<FenderSummary>>,
    /// Reactions and deflections of this step.
    now: Vec<(f64, f64)>,
}

impl FenderSummaries {
    pub(crate) fn new(fenders: usize) -> FenderSummaries {
        FenderSummaries { all: vec![None; fenders], now: vec![(0.0, 0.0); fenders] }
    }

    /// Books one step.
    pub(crate) fn book(&mut self, setups: &[FenderSetup], contacts: &[Contact], t_s: f64) {
        if setups.is_empty() {
            return;
        }
        self.now.fill((0.0, 0.0));
        for summary in self.all.iter_mut().flatten() {
            (summary.last_deflection_m, summary.last_reaction_n) = (0.0, 0.0);
        }
        for contact in contacts {
            let Some(id) = contact.fender else { continue };
            let index = id.0 as usize;
            let setup = &setups[index];
            let summary =
                self.all[index].get_or_insert_with(|| first_touch(index, setup, contact, t_s));
            let (reaction_n, energy_j) = &mut self.now[index];
            // Two hulls on one fender press together; of a tilted hull's force the fender's reaction is the
            // part along its axis.
            *reaction_n += contact.peak_normal_force_n * libm::cos(contact.tilt_rad);
            *energy_j += contact.energy.peak_absorbed_j;
            book_contact(summary, setup, contact, t_s);
            book_peaks(summary, setup, *reaction_n, *energy_j, t_s);
        }
    }
}

fn first_touch(index: usize, setup: &FenderSetup, contact: &Contact, t_s: f64) -> FenderSummary {
    let angle_rad = contact.tilt_rad;
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
        approach_angle_rad: angle_rad,
        factor: contact.factor,
        peak_deflection_m: 0.0,
        peak_deflection_at_s: t_s,
        peak_reaction_n: 0.0,
        peak_reaction_at_s: t_s,
        peak_energy_j: 0.0,
        peak_hull_pressure_npm2: None,
        capacity_j,
        share_of_rated_energy: setup.rated.map(|_| 0.0),
        share_of_rated_reaction: setup.rated.map(|_| 0.0),
        share_of_rated_deflection: setup.rated.map(|_| 0.0),
        share_of_hull_pressure: None,
        failed: false,
        last_deflection_m: 0.0,
        last_reaction_n: 0.0,
    }
}

fn book_contact(summary: &mut FenderSummary, setup: &FenderSetup, contact: &Contact, t_s: f64) {
    summary.last_reaction_n += contact.normal_force_n * libm::cos(contact.tilt_rad);
    summary.last_deflection_m = greater(summary.last_deflection_m, contact.depth_m);
    let deflection_m = contact.peak_depth_m;
    if deflection_m > summary.peak_deflection_m {
        summary.peak_deflection_m = deflection_m;
        summary.peak_deflection_at_s = t_s;
        summary.share_of_rated_deflection = setup.rated.map(|r| deflection_m / r.deflection_m);
        let travel_m = setup.stop.map_or(setup.projection_m, |stop| stop.from_m);
        summary.failed |= deflection_m > travel_m;
    }
}

fn book_peaks(
    summary: &mut FenderSummary,
    setup: &FenderSetup,
    reaction_n: f64,
    energy_j: f64,
    t_s: f64,
) {
    if energy_j > summary.peak_energy_j {
        summary.peak_energy_j = energy_j;
        summary.share_of_rated_energy = summary.capacity_j.map(|capacity_j| energy_j / capacity_j);
    }
    if reaction_n > summary.peak_reaction_n {
        summary.peak_reaction_n = reaction_n;
        summary.peak_reaction_at_s = t_s;
        summary.share_of_rated_reaction =
            setup.rated.map(|rated| reaction_n / (rated.reaction_n * summary.factor));
    }
    // It never falls with deflection or reaction, so that its peak is at theirs.
    let pressure_npm2 =
        setup.hull_pressure_npm2(summary.peak_deflection_m, summary.peak_reaction_n);
    summary.peak_hull_pressure_npm2 = pressure_npm2;
    summary.share_of_hull_pressure =
        pressure_npm2.zip(setup.hull_pressure_limit_npm2).map(|(pressure, limit)| pressure / limit);
}
