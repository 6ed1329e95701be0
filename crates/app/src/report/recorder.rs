//! What the report draws, gathered while the run goes on, in memory that does not grow with the
//! run's length.

use std::collections::{BTreeMap, BTreeSet};

use fenderline_contact::{BodyState, Contact, Vec2};
use fenderline_sim::{Energy, Setup, StepRecord};

use crate::plot::Decimator;

/// Pairs and bodies that are followed; the tables of the report know all the others.
pub(super) const FOLLOWED: usize = 128;
/// Points kept of a track.
const TRACK_POINTS: usize = 400;

/// Time series of one pair.
pub(super) struct PairTrace {
    /// Indices into the set-up's bodies.
    pub(super) bodies: [usize; 2],
    /// Sum of N over the patches [N].
    pub(super) normal_n: Decimator,
    /// Sum of T over the patches [N].
    pub(super) tangential_n: Decimator,
    /// Largest depth of a patch [m].
    pub(super) depth_m: Decimator,
    /// V_n of the patch with the largest N, positive approaching [m/s]; after the contact, along
    /// its last normal at its last point.
    pub(super) v_normal_mps: Decimator,
    /// The step with the largest sum of N.
    pub(super) peak: Peak,
    last: Contact,
}

/// The moment of a pair's largest force.
#[derive(Clone, Copy, Debug)]
pub(super) struct Peak {
    /// Start of that step [s].
    pub(super) t_s: f64,
    /// Sum of N over the patches [N].
    pub(super) normal_n: f64,
    /// The patch with the largest N.
    pub(super) contact: Contact,
    /// The two bodies.
    pub(super) states: [BodyState; 2],
}

/// What one pair does in one step: sums over its patches.
#[derive(Clone, Copy)]
struct Touch {
    normal_n: f64,
    tangential_n: f64,
    depth_m: f64,
    strongest: Contact,
}

impl Touch {
    fn of(contact: &Contact) -> Touch {
        Touch {
            normal_n: contact.normal_force_n,
            tangential_n: contact.tangential_force_n,
            depth_m: contact.depth_m,
            strongest: *contact,
        }
    }

    fn with(self, contact: &Contact) -> Touch {
        let is_stronger = contact.normal_force_n > self.strongest.normal_force_n;
        Touch {
            normal_n: self.normal_n + contact.normal_force_n,
            tangential_n: self.tangential_n + contact.tangential_force_n,
            depth_m: self.depth_m.max(contact.depth_m),
            strongest: if is_stronger { *contact } else { self.strongest },
        }
    }
}

impl PairTrace {
    fn begin(bodies: [usize; 2], touch: &Touch, step: &StepRecord<'_>, step_s: f64) -> PairTrace {
        let peak = Peak {
            t_s: step.t_s,
            normal_n: touch.normal_n,
            contact: touch.strongest,
            states: bodies.map(|i| step.states[i]),
        };
        let mut trace = PairTrace {
            bodies,
            normal_n: Decimator::new(),
            tangential_n: Decimator::new(),
            depth_m: Decimator::new(),
            v_normal_mps: Decimator::new(),
            peak,
            last: touch.strongest,
        };
        if step.index > 0 {
            // Nothing touched from the start until the step before this one.
            for t_s in [0.0, step.t_s - step_s] {
                trace.push_forces(t_s, 0.0, 0.0, 0.0);
            }
        }
        trace
    }

    fn push_forces(&mut self, t_s: f64, normal_n: f64, tangential_n: f64, depth_m: f64) {
        self.normal_n.push(t_s, normal_n);
        self.tangential_n.push(t_s, tangential_n);
        self.depth_m.push(t_s, depth_m);
    }

    fn push(&mut self, touch: Option<&Touch>, step: &StepRecord<'_>) {
        let states = self.bodies.map(|i| step.states[i]);
        let Some(touch) = touch else {
            self.push_forces(step.t_s, 0.0, 0.0, 0.0);
            let [v_1, v_2] = states.map(|s| s.velocity_at(self.last.point_m));
            self.v_normal_mps.push(step.t_s, (v_1 - v_2).dot(self.last.normal));
            return;
        };
        self.push_forces(step.t_s, touch.normal_n, touch.tangential_n, touch.depth_m);
        self.v_normal_mps.push(step.t_s, touch.strongest.v_normal_mps);
        self.last = touch.strongest;
        if touch.normal_n > self.peak.normal_n {
            self.peak =
                Peak { t_s: step.t_s, normal_n: touch.normal_n, contact: touch.strongest, states };
        }
    }
}

/// Time series of one floating body.
pub(super) struct BodyTrace {
    /// Index into the set-up's bodies.
    pub(super) body: usize,
    /// Speed over ground [m/s].
    pub(super) speed_mps: Decimator,
    track: Vec<Vec2>,
    track_stride: u64,
}

impl BodyTrace {
    fn push(&mut self, step: &StepRecord<'_>) {
        let state = &step.states[self.body];
        self.speed_mps.push(step.t_s, state.velocity_mps.length());
        if step.index.is_multiple_of(self.track_stride) {
            self.track.push(state.position_m);
            if self.track.len() > TRACK_POINTS {
                let mut index = 0;
                self.track.retain(|_| {
                    index += 1;
                    index % 2 == 1
                });
                self.track_stride *= 2;
            }
        }
    }

    /// The path of the centre of gravity, up to `end`.
    pub(super) fn track_to(&self, end: &BodyState) -> Vec<Vec2> {
        let mut track = self.track.clone();
        track.push(end.position_m);
        track
    }
}

/// The whole scene in the step of the largest force.
#[derive(Clone, Debug)]
pub(super) struct ScenePeak {
    /// Start of that step [s].
    pub(super) t_s: f64,
    /// Sum of N over the patches of the pair [N].
    normal_n: f64,
    /// The patch with the largest N.
    pub(super) contact: Contact,
    /// All bodies.
    pub(super) states: Vec<BodyState>,
}

/// All that the report draws of a run.
pub(crate) struct Recorder {
    pub(super) pairs: Vec<PairTrace>,
    /// Pairs that touched when as many as can be followed already were.
    pub(super) pairs_not_followed: bool,
    pub(super) bodies: Vec<BodyTrace>,
    pub(super) kinetic_j: Decimator,
    pub(super) load_work_j: Decimator,
    pub(super) normal_work_j: Decimator,
    pub(super) tangential_work_j: Decimator,
    pub(super) residual_j: Decimator,
    pub(super) start: Vec<BodyState>,
    /// The step of the largest force of all pairs, followed or not.
    pub(super) peak: Option<ScenePeak>,
    /// This step's touching pairs, kept for its allocation.
    touching: BTreeMap<[usize; 2], Touch>,
    /// The pairs of `pairs`.
    followed: BTreeSet<[usize; 2]>,
    has_loads: bool,
    step_s: f64,
}

impl Recorder {
    /// An empty record of a run of `setup`.
    pub(crate) fn new(setup: &Setup) -> Recorder {
        let floating = setup.bodies.iter().enumerate().filter(|(_, body)| body.mass.is_some());
        let bodies = floating.take(FOLLOWED).map(|(body, _)| BodyTrace {
            body,
            speed_mps: Decimator::new(),
            track: Vec::new(),
            track_stride: 1,
        });
        Recorder {
            pairs: Vec::new(),
            pairs_not_followed: false,
            bodies: bodies.collect(),
            kinetic_j: Decimator::new(),
            load_work_j: Decimator::new(),
            normal_work_j: Decimator::new(),
            tangential_work_j: Decimator::new(),
            residual_j: Decimator::new(),
            start: Vec::new(),
            peak: None,
            touching: BTreeMap::new(),
            followed: BTreeSet::new(),
            has_loads: !setup.loads.is_empty(),
            step_s: setup.step_s,
        }
    }

    /// Whether the run has external loads, and so a curve of their work.
    pub(super) fn has_loads(&self) -> bool {
        self.has_loads
    }

    /// Adds one step.
    pub(crate) fn record(&mut self, step: &StepRecord<'_>) {
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
        self.record_peak(step);
        self.record_pairs(step);
        for body in &mut self.bodies {
            body.push(step);
        }
        self.record_energy(step);
    }

    fn record_peak(&mut self, step: &StepRecord<'_>) {
        let strongest = self.touching.values().max_by(|a, b| a.normal_n.total_cmp(&b.normal_n));
        let Some(touch) = strongest else { return };
        if touch.normal_n <= self.peak.as_ref().map_or(0.0, |peak| peak.normal_n) {
            return;
        }
        // The states' allocation is kept: a force may rise over many steps.
        let mut states = self.peak.take().map_or_else(Vec::new, |peak| peak.states);
        states.clear();
        states.extend_from_slice(step.states);
        let contact = touch.strongest;
        self.peak = Some(ScenePeak { t_s: step.t_s, normal_n: touch.normal_n, contact, states });
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
                self.pairs.push(PairTrace::begin(*bodies, touch, step, self.step_s));
            }
        }
        for trace in &mut self.pairs {
            trace.push(self.touching.get(&trace.bodies), step);
        }
    }

    fn record_energy(&mut self, step: &StepRecord<'_>) {
        let energy = &step.energy;
        if step.index == 0 {
            let work_j = energy.load_work_j + energy.normal_work_j + energy.tangential_work_j;
            let start_j = energy.kinetic_j - work_j - energy.residual_j;
            self.push_energy(0.0, &Energy { kinetic_j: start_j, ..Energy::default() });
        }
        // The ledger stands at the end of the step.
        self.push_energy(step.t_s + self.step_s, energy);
    }

    fn push_energy(&mut self, t_s: f64, energy: &Energy) {
        self.kinetic_j.push(t_s, energy.kinetic_j);
        self.load_work_j.push(t_s, energy.load_work_j);
        self.normal_work_j.push(t_s, energy.normal_work_j);
        self.tangential_work_j.push(t_s, energy.tangential_work_j);
        self.residual_j.push(t_s, energy.residual_j);
    }
}
