//! Records the data for the report during the run. The memory of the recorder does not grow with the length of the run.

mod body;
mod docking;
mod energy;
mod fender;
mod pair;
mod panel;
mod parts;
mod path;
mod plan;
mod wind;
mod world;

use std::collections::{BTreeMap, BTreeSet};

use fenderline_contact::{BodyState, Contact};
use fenderline_sim::{Energy, Setup, StepRecord};

use fenderline_results::{TouchedFender, touched};

pub(super) use body::BodyTrace;
pub(super) use docking::DockingTrace;
pub(super) use energy::EnergyTrace;
pub(super) use fender::FenderTrace;
pub(super) use pair::PairTrace;
use pair::{Deflections, Touch};
pub(super) use panel::Held;
pub(super) use parts::PartsTrace;
use path::Path;
pub(super) use plan::{LegTrace, PlanTrace};
pub use wind::WindTrace;
pub(super) use wind::both;
use world::tug_marks;
pub(super) use world::{TugMark, VesselTrace, WorldTrace};

/// The largest number of pairs, fenders and bodies whose time series are recorded for charts. The tables of the report
/// contain all pairs, fenders and bodies.
pub(super) const FOLLOWED: usize = 128;

/// The whole scene in the time step of the largest force.
#[derive(Clone, Debug)]
pub(super) struct ScenePeak {
    /// Start of the time step with the largest force (s).
    pub(super) t_s: f64,
    /// Sum of the normal forces N over the contact patches of the pair (N).
    normal_n: f64,
    /// The contact patch with the largest normal force N.
    pub(super) contact: Contact,
    /// States of all bodies.
    pub(super) states: Vec<BodyState>,
    /// Deflections of all fenders.
    pub(super) deflections_m: Deflections,
    /// Positions and forces of all tugs.
    pub(super) tugs: Vec<TugMark>,
}

/// Records the data that the report draws.
pub struct Recorder {
    pub(super) pairs: Vec<PairTrace>,
    /// Whether more pairs touched than can be recorded.
    pub(super) pairs_not_followed: bool,
    pub(super) bodies: Vec<BodyTrace>,
    /// Records of the touched fenders, in the order of their first touch.
    pub(super) fenders: Vec<FenderTrace>,
    /// Records of panels on several cones, and of chains.
    pub(super) held: Held,
    pub(super) energy: EnergyTrace,
    pub(super) world: WorldTrace,
    /// The mean wind over the run; `None` if it was not recorded, so that the report shows the wind of the set-up.
    pub wind: Option<WindTrace>,
    /// Positions and forces of all tugs in the last time step.
    pub(super) last_tugs: Vec<TugMark>,
    setup: Setup,
    /// The energy ledger before the first time step.
    pub(super) start_energy: Energy,
    /// The largest energy that springs, stops and shear springs stored at the end of a step (J), and its time (s).
    pub(super) most_stored: (f64, f64),
    pub(super) start: Vec<BodyState>,
    /// The time step with the largest force of all pairs, whether they are recorded or not.
    pub(super) peak: Option<ScenePeak>,
    /// The pairs in contact in the present step; the map is kept, so that no new memory is needed.
    touching: BTreeMap<[usize; 2], Touch>,
    /// The fenders touched in the present step.
    touched: BTreeMap<usize, TouchedFender>,
    deflections_m: Deflections,
    /// The pairs that are recorded in `pairs`.
    followed: BTreeSet<[usize; 2]>,
    has_loads: bool,
    step_s: f64,
}

impl Recorder {
    /// Makes an empty record of a run of `setup` that begins with the energy ledger `start`.
    pub fn new(setup: &Setup, start: Energy) -> Recorder {
        let floating = setup.bodies.iter().enumerate().filter(|(_, body)| body.mass.is_some());
        let mut energy = EnergyTrace::default();
        energy.push(0.0, &start);
        Recorder {
            pairs: Vec::new(),
            pairs_not_followed: false,
            bodies: floating.take(FOLLOWED).map(|(body, _)| BodyTrace::new(body)).collect(),
            fenders: Vec::new(),
            held: Held::new(setup),
            energy,
            world: WorldTrace::new(setup),
            wind: None,
            last_tugs: Vec::new(),
            setup: setup.clone(),
            start_energy: start,
            most_stored: (0.0, 0.0),
            start: Vec::new(),
            peak: None,
            touching: BTreeMap::new(),
            touched: BTreeMap::new(),
            deflections_m: Vec::new(),
            followed: BTreeSet::new(),
            has_loads: !setup.loads.is_empty(),
            step_s: setup.step_s,
        }
    }

    /// Whether the run has external loads, so that the report draws a curve of their work.
    pub(super) fn has_loads(&self) -> bool {
        self.has_loads
    }

    /// Adds one step.
    pub fn record(&mut self, step: &StepRecord<'_>) {
        if step.index == 0 {
            self.start = step.states.to_vec();
        }
        self.touching.clear();
        for contact in step.contacts {
            let bodies = [contact.body_1.0 as usize, contact.body_2.0 as usize];
            self.touching
                .entry(bodies)
                .and_modify(|touch| *touch = touch.with(contact))
                .or_insert_with(|| Touch::of(contact));
        }
        self.touched = touched(step.contacts);
        self.deflections_m.clear();
        let deflections_m = self.touched.iter().map(|(index, now)| (*index, now.deflection_m));
        self.deflections_m.extend(deflections_m);
        self.record_peak(step);
        self.record_fenders(step);
        self.record_pairs(step);
        for body in &mut self.bodies {
            body.push(step);
        }
        self.held.push(step);
        self.record_energy(step);
        self.world.push(step);
        if !step.tugs.is_empty() {
            self.last_tugs = tug_marks(&self.setup, step, step.states);
        }
    }

    fn record_peak(&mut self, step: &StepRecord<'_>) {
        let strongest = self.touching.values().max_by(|a, b| a.normal_n.total_cmp(&b.normal_n));
        let Some(touch) = strongest else { return };
        if touch.normal_n <= self.peak.as_ref().map_or(0.0, |peak| peak.normal_n) {
            return;
        }
        // Keeps the allocation of the states: a force may rise over many steps.
        let mut states = self.peak.take().map_or_else(Vec::new, |peak| peak.states);
        states.clear();
        states.extend_from_slice(step.states);
        self.peak = Some(ScenePeak {
            t_s: step.t_s,
            normal_n: touch.normal_n,
            contact: touch.strongest,
            states,
            deflections_m: self.deflections_m.clone(),
            tugs: tug_marks(&self.setup, step, step.states),
        });
    }

    fn record_pairs(&mut self, step: &StepRecord<'_>) {
        for (bodies, touch) in &self.touching {
            if self.followed.contains(bodies) {
                continue;
            }
            if self.pairs.len() == FOLLOWED {
                self.pairs_not_followed = true;
            } else {
                self.followed.insert(*bodies);
                let deflections_m = &self.deflections_m;
                self.pairs.push(PairTrace::begin(*bodies, touch, deflections_m, step, self.step_s));
            }
        }
        for trace in &mut self.pairs {
            trace.push(self.touching.get(&trace.bodies), &self.deflections_m, step);
        }
    }

    fn record_fenders(&mut self, step: &StepRecord<'_>) {
        for &fender in self.touched.keys() {
            let is_new = self.fenders.iter().all(|trace| trace.fender != fender);
            if is_new && self.fenders.len() < FOLLOWED {
                self.fenders.push(FenderTrace::begin(fender, step.t_s, self.step_s));
            }
        }
        for trace in &mut self.fenders {
            trace.push(step.t_s, self.touched.get(&trace.fender));
        }
    }

    fn record_energy(&mut self, step: &StepRecord<'_>) {
        // The ledger is that at the end of the step.
        let end_s = step.t_s + self.step_s;
        let energy = step.energy();
        self.energy.push(end_s, &energy);
        let stored_j = energy.stored_j + energy.shear_stored_j;
        if stored_j > self.most_stored.0 {
            self.most_stored = (stored_j, end_s);
        }
    }
}
