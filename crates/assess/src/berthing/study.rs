//! Follows a run and collects data for the study of berthing energy.

use fenderline_contact::number::{bounded, greater, lesser};
use fenderline_contact::{BodyState, Contact, Rotation, vec2};

use super::hit::{Hit, HitStep};
use super::outcome::{AddedSway, BerthingOutcome, LaterHit, OtherShip, ShallowFactor};
use fenderline_world::berthing::AddedMass;
use fenderline_world::berthing::BerthingError;
use fenderline_world::berthing::BerthingSetup;
use fenderline_world::berthing::{BerthingEnergy, abnormal_energy_j};
use fenderline_world::berthing::{ContactPoint, gyradius_m};
use fenderline_world::dolphin::DolphinMotion;
use fenderline_world::fender::FenderSetup;
use fenderline_world::record::{ContactEnergy, StepRecord};
use fenderline_world::rigid_body::Inertia;

/// The list of the fenders that the ship meets together is complete when the first of these fenders is compressed by
/// this share of its rated deflection.
const GROUP_SHARE: f64 = 0.1;

/// Data of the ship's first touch of a fender.
#[derive(Clone, Debug)]
struct FirstTouch {
    t_s: f64,
    /// Index of each fender of the group, and its place along the hull (m); the first entry is the fender touched
    /// first.
    group: Vec<(usize, f64)>,
    /// Deflection of the first fender at which no more fenders are added to the group (m).
    complete_at_m: f64,
    is_complete: bool,
    speed_mps: f64,
    angle_rad: f64,
    displacement_kg: f64,
    other: Option<OtherShip>,
    /// The ship's mass normal to the fender's face in the simulation, added mass included (kg); for two ships their
    /// reduced mass.
    mass_kg: f64,
    /// The ship's own added mass in sway, divided by her displacement.
    added_sway: f64,
    gyradius_m: f64,
}

impl FirstTouch {
    /// See [`BerthingOutcome::along_m`].
    fn along_m(&self) -> f64 {
        let along_m = || self.group.iter().map(|(_, along_m)| *along_m);
        let (low_m, high_m) =
            (along_m().fold(f64::INFINITY, lesser), along_m().fold(f64::NEG_INFINITY, greater));
        bounded(0.0, low_m, high_m)
    }
}

/// A hit is counted if the fenders absorbed at least this share of the ship's kinetic energy at the first touch.
const COUNTED_SHARE: f64 = 0.05;

/// The phase of the run: the ship is in a hit on her fenders, or between two hits.
#[derive(Clone, Copy, Debug)]
enum Phase {
    /// The run is in the first hit, or in light touches before the first hit.
    First(Hit),
    /// Between two hits. The field is the least energy that the fenders stored since the last hit (J).
    Between { least_j: f64 },
    /// The run is in a later hit; the number is the start of the first step of this hit (s).
    Later(Hit, f64),
}

/// Collects the results of a simulated berthing, step by step.
#[derive(Clone, Debug)]
pub struct Study {
    setup: BerthingSetup,
    /// Displacement of each body (kg); `None` for a fixed body.
    displacements_kg: Vec<Option<f64>>,
    /// Factor of shallow water on the ship's added mass in sway at the start of the run. `None` if the water is deep,
    /// or if the ship is no vessel.
    shallow: Option<ShallowFactor>,
    first: Option<FirstTouch>,
    phase: Phase,
    /// Number of counted hits that have ended.
    hits: u32,
    /// The results of the berthing; `None` before the first touch.
    pub outcome: Option<Result<BerthingOutcome, BerthingError>>,
}

/// The data of one step that the study of the berthing uses.
pub struct StudyStep<'a> {
    t_s: f64,
    step_s: f64,
    states: &'a [BodyState],
    contacts: &'a [Contact],
    energies: &'a [ContactEnergy],
    dolphins: &'a [DolphinMotion],
}

impl<'a> StudyStep<'a> {
    /// Takes from the record of a step what the study reads, and the length of the step (s).
    #[must_use]
    pub fn of(record: &StepRecord<'a>, step_s: f64) -> StudyStep<'a> {
        let StepRecord { t_s, states, contacts, contact_energies: energies, dolphins, .. } =
            *record;
        StudyStep { t_s, step_s, states, contacts, energies, dolphins }
    }

    /// The contacts of a ship with fenders in this step.
    fn touched(&self, ship: usize) -> impl Iterator<Item = &'a Contact> + use<'a> {
        let of_ship = move |contact: &&Contact| {
            let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            contact.fender.is_some() && bodies.contains(&ship)
        };
        self.contacts.iter().filter(of_ship)
    }

    /// The largest energy that bent the piles of the dolphins that a ship touches (J).
    fn piles_j(&self, ship: usize) -> f64 {
        let touched = |dolphin: &&DolphinMotion| {
            self.touched(ship).any(|contact| {
                [contact.body_1.0 as usize, contact.body_2.0 as usize].contains(&dolphin.body)
            })
        };
        self.dolphins.iter().filter(touched).map(|dolphin| dolphin.pile.peak_stored_j).sum()
    }

    /// The stored, lost and absorbed energies of the fenders that a ship touches in this step.
    fn energies_of(&self, ship: usize) -> HitStep {
        let of_ship =
            |energy: &&ContactEnergy| energy.fender.is_some() && energy.bodies.contains(&ship);
        let energies = || self.energies.iter().filter(of_ship);
        HitStep {
            stored_j: energies().map(|energy| energy.stored_j).sum(),
            hysteresis_j: energies().map(|energy| energy.hysteresis_j).sum(),
            peak_absorbed_j: self.touched(ship).map(|c| c.energy.peak_absorbed_j).sum(),
        }
    }
}

impl Study {
    /// Starts a study of a berthing from data that have been checked. The study needs the displacement of each body
    /// (kg; `None` for a fixed body), and the factor of shallow water on the ship's added mass in sway.
    pub fn new(
        setup: BerthingSetup,
        displacements_kg: Vec<Option<f64>>,
        shallow: Option<ShallowFactor>,
    ) -> Study {
        Study {
            setup,
            displacements_kg,
            shallow,
            first: None,
            phase: Phase::First(Hit::default()),
            hits: 0,
            outcome: None,
        }
    }

    /// Adds one step.
    pub fn add(&mut self, fenders: &[FenderSetup], inertias: &[Inertia], step: &StudyStep<'_>) {
        if let Phase::First(_) = self.phase {
            self.follow_group(fenders, inertias, step);
        }
        if let Some(Ok(outcome)) = self.outcome.as_mut() {
            let energies = step.energies_of(self.setup.ship);
            if let Phase::First(_) = self.phase {
                outcome.pile_energy_j =
                    greater(outcome.pile_energy_j, step.piles_j(self.setup.ship));
            }
            (self.phase, self.hits) = follow_hits(self.phase, self.hits, outcome, energies, step);
        }
    }

    /// Notes the first touch, and the fenders that the ship meets together until their group is complete. Computes the
    /// results anew if a fender joins the group.
    fn follow_group(
        &mut self,
        fenders: &[FenderSetup],
        inertias: &[Inertia],
        step: &StudyStep<'_>,
    ) {
        let ship = self.setup.ship;
        let mut touched = step.touched(ship).peekable();
        let Some(first) = touched.peek() else { return };
        let mut is_new = self.first.is_none();
        if is_new {
            self.first = Some(self.first_touch(fenders, inertias, step, first));
        }
        let group = self.first.as_mut().expect("touched");
        if group.is_complete {
            return;
        }
        for contact in touched {
            let fender = contact.fender.expect("a fender's contact").0 as usize;
            let leader = group.group[0].0;
            // The group is complete at the end of the step.
            if fender == leader && contact.peak_depth_m > group.complete_at_m {
                group.is_complete = true;
            }
            if group.group.iter().all(|(known, _)| *known != fender) {
                group.group.push((fender, along_m(&fenders[fender], ship, step.states)));
                is_new = true;
            }
        }
        if is_new {
            let outcome = self.outcome_of(self.first.as_ref().expect("touched"));
            let before = self.outcome.take();
            self.outcome = Some(match (outcome, before) {
                (Ok(outcome), Some(Ok(before))) => Ok(BerthingOutcome {
                    fender_energy_j: before.fender_energy_j,
                    pile_energy_j: before.pile_energy_j,
                    eccentricity_measured: before.eccentricity_measured,
                    ..outcome
                }),
                (outcome, _) => outcome,
            });
        }
    }

    fn first_touch(
        &self,
        fenders: &[FenderSetup],
        inertias: &[Inertia],
        step: &StudyStep<'_>,
        contact: &Contact,
    ) -> FirstTouch {
        let ship = self.setup.ship;
        let fender = contact.fender.expect("a fender's contact").0 as usize;
        let setup = &fenders[fender];
        let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
        let other = if bodies[0] == ship { bodies[1] } else { bodies[0] };
        let host = &step.states[setup.body];
        let outward =
            Rotation::from_angle(host.heading_rad + setup.facing_rad).apply(vec2(1.0, 0.0));
        // The fender may be on the ship herself.
        let to_ship = if setup.body == ship { -outward } else { outward };
        let in_ship = Rotation::from_angle(step.states[ship].heading_rad).apply_inverse(to_ship);
        let apart_mps = step.states[other].velocity_mps - step.states[ship].velocity_mps;
        let normal_mass_kg = |body: usize| {
            let inertia = &inertias[body];
            let attitude = Rotation::from_angle(step.states[body].heading_rad);
            let own = attitude.apply_inverse(outward);
            inertia.surge_kg * own.x * own.x + inertia.sway_kg * own.y * own.y
        };
        let own_mass_kg = normal_mass_kg(ship);
        let own_kg = self.displacements_kg[ship].expect("the ship floats");
        let other_ship = self.displacements_kg[other].map(|displacement_kg| OtherShip {
            displacement_kg,
            added_mass: normal_mass_kg(other) / displacement_kg,
        });
        let reduced_kg = |one_kg: f64, two_kg: f64| one_kg * two_kg / (one_kg + two_kg);
        let (displacement_kg, mass_kg, speed_mps) = match other_ship {
            None => (own_kg, own_mass_kg, apart_mps.dot(to_ship)),
            Some(of) => (
                reduced_kg(own_kg, of.displacement_kg),
                reduced_kg(own_mass_kg, normal_mass_kg(other)),
                contact.v_normal_mps,
            ),
        };
        let travel_m = setup.rated.map_or(setup.projection_m, |rated| rated.deflection_m);
        FirstTouch {
            t_s: step.t_s,
            group: vec![(fender, along_m(setup, ship, step.states))],
            complete_at_m: GROUP_SHARE * travel_m,
            is_complete: false,
            speed_mps,
            angle_rad: libm::atan2(-in_ship.x, in_ship.y.abs()),
            displacement_kg,
            other: other_ship,
            mass_kg,
            added_sway: inertias[ship].sway_kg / own_kg - 1.0,
            gyradius_m: libm::sqrt(inertias[ship].yaw_kgm2 / own_mass_kg),
        }
    }

    fn outcome_of(&self, first: &FirstTouch) -> Result<BerthingOutcome, BerthingError> {
        let setup = &self.setup;
        let added_mass = setup.added_masses()?;
        let chosen_added_mass = match setup.added_mass {
            AddedMass::Given(factor) => factor,
            AddedMass::By(formula) => added_mass[formula.index()].expect("checked"),
        };
        let gyradius_m = gyradius_m(setup.block_coefficient, setup.length_bp_m)?;
        let along_m = first.along_m();
        let point = ContactPoint { along_m, beam_m: setup.beam_m };
        let ce = point.eccentricity(gyradius_m, first.angle_rad)?;
        let (softness, configuration) = (setup.softness.factor(), setup.configuration.factor());
        let touch_mps = first.speed_mps.abs();
        let formula_mps = setup.design_speed_mps.unwrap_or(touch_mps);
        let energy_j = |added_mass: f64, speed_mps: f64| {
            let energy = BerthingEnergy {
                displacement_kg: first.displacement_kg,
                speed_mps,
                added_mass,
                eccentricity: ce,
                softness,
                configuration,
            };
            energy.normal_j()
        };
        let mut energies_j = [None; 4];
        for (each_j, factor) in energies_j.iter_mut().zip(added_mass) {
            *each_j = factor.map(|factor| energy_j(factor, formula_mps)).transpose()?;
        }
        let chosen_j = energy_j(chosen_added_mass, formula_mps)?;
        let abnormal = setup.abnormal_factor;
        Ok(BerthingOutcome {
            first_touch_s: first.t_s,
            fenders: first.group.iter().map(|(fender, _)| *fender).collect(),
            speed_mps: first.speed_mps,
            design_speed_mps: setup.design_speed_mps,
            angle_rad: first.angle_rad,
            along_m,
            displacement_kg: first.displacement_kg,
            other: first.other,
            added_mass,
            chosen: setup.added_mass,
            chosen_added_mass,
            added_mass_simulated: first.mass_kg / first.displacement_kg,
            added_sway: AddedSway {
                deep: first.added_sway / self.shallow.map_or(1.0, |shallow| shallow.factor),
                shallow: self.shallow,
            },
            gyradius_m,
            gyradius_simulated_m: first.gyradius_m,
            eccentricity: ce,
            eccentricity_of_run: point.eccentricity(first.gyradius_m, first.angle_rad)?,
            softness,
            configuration,
            energy_j: chosen_j,
            energy_at_touch_j: energy_j(chosen_added_mass, touch_mps)?,
            energies_j,
            abnormal_energy_j: abnormal
                .map(|factor| abnormal_energy_j(chosen_j, factor))
                .transpose()?,
            kinetic_j: 0.5 * first.mass_kg * first.speed_mps * first.speed_mps,
            fender_energy_j: 0.0,
            pile_energy_j: 0.0,
            eccentricity_measured: 0.0,
            first_hit_until_s: None,
            later: None,
        })
    }
}

/// The phase of the run after this step, and the number of hits that have ended.
fn follow_hits(
    phase: Phase,
    hits: u32,
    outcome: &mut BerthingOutcome,
    energies: HitStep,
    step: &StudyStep<'_>,
) -> (Phase, u32) {
    let end_s = step.t_s + step.step_s;
    let after = Phase::Between { least_j: energies.stored_j };
    let counted_j = COUNTED_SHARE * outcome.kinetic_j;
    match phase {
        Phase::First(mut hit) => {
            hit.add(energies);
            outcome.fender_energy_j = hit.taken_j;
            outcome.eccentricity_measured =
                (hit.taken_j + outcome.pile_energy_j) / outcome.kinetic_j;
            // A light touch before the impact does not count as the impact.
            if hit.taken_j > counted_j && hit.is_over(energies) {
                outcome.first_hit_until_s = Some(end_s);
                return (after, hits + 1);
            }
            (Phase::First(hit), hits)
        }
        Phase::Between { least_j } if energies.stored_j <= least_j => (after, hits),
        Phase::Between { .. } => {
            follow_later(Hit::default(), step.t_s, hits, outcome, energies, step)
        }
        Phase::Later(hit, from_s) => follow_later(hit, from_s, hits, outcome, energies, step),
    }
}

fn follow_later(
    mut hit: Hit,
    from_s: f64,
    hits: u32,
    outcome: &mut BerthingOutcome,
    energies: HitStep,
    step: &StudyStep<'_>,
) -> (Phase, u32) {
    let is_counted = |hit: &Hit| hit.taken_j > COUNTED_SHARE * outcome.kinetic_j;
    let is_more = hit.add(energies);
    let (is_over, counts) = (hit.is_over(energies), is_counted(&hit));
    let is_largest = outcome.later.is_none_or(|later| hit.taken_j > later.energy_j);
    if is_more && counts && is_largest {
        let number = hits + 1;
        let (energy_j, at_s) = (hit.taken_j, step.t_s);
        outcome.later = Some(LaterHit { number, from_s, until_s: None, energy_j, at_s });
    }
    if !is_over {
        return (Phase::Later(hit, from_s), hits);
    }
    if let Some(later) = outcome.later.as_mut().filter(|later| later.from_s == from_s) {
        later.until_s = Some(step.t_s + step.step_s);
    }
    (Phase::Between { least_j: energies.stored_j }, hits + u32::from(counts))
}

/// Middle of a fender's face along the ship's hull from her centre of gravity, positive forward (m).
fn along_m(fender: &FenderSetup, ship: usize, states: &[BodyState]) -> f64 {
    let ahead = Rotation::from_angle(fender.facing_rad).apply(vec2(fender.projection_m, 0.0));
    let face_m = states[fender.body].pose().apply(fender.position_m + ahead);
    let state = &states[ship];
    Rotation::from_angle(state.heading_rad).apply_inverse(face_m - state.position_m).x
}
