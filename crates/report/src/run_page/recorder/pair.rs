//! Records the contact of a pair of bodies for the report.

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Contact, ForceParts};
use fenderline_sim::StepRecord;

use super::parts::PartsTrace;
use crate::plot::Decimator;
use fenderline_results::add_parts;

/// Deflection of each touched fender at one moment (m), by its index in the set-up.
pub(in crate::run_page) type Deflections = Vec<(usize, f64)>;

/// Time series of one pair of bodies.
pub(in crate::run_page) struct PairTrace {
    /// Indices of the two bodies among the set-up's bodies.
    pub(in crate::run_page) bodies: [usize; 2],
    /// Sum of the normal forces N over the pair's contact patches (N).
    pub(in crate::run_page) normal_n: Decimator,
    /// Sum of the tangential forces T over the pair's contact patches (N).
    pub(in crate::run_page) tangential_n: Decimator,
    /// Largest depth of a contact patch (m).
    pub(in crate::run_page) depth_m: Decimator,
    /// Normal speed V_n at the patch with the largest normal force, positive when approaching (m/s); after the contact
    /// it is taken along the last normal at the last contact point.
    pub(in crate::run_page) v_normal_mps: Decimator,
    /// Components of the normal force between outlines; the components of fender forces are recorded by fender.
    pub(in crate::run_page) parts: PartsTrace,
    /// The time step with the largest sum of normal forces.
    pub(in crate::run_page) peak: Peak,
    last: Contact,
}

/// The moment of a pair's largest force.
#[derive(Clone, Debug)]
pub(in crate::run_page) struct Peak {
    /// Start of the time step with the pair's largest force (s).
    pub(in crate::run_page) t_s: f64,
    /// Sum of the normal forces N over the pair's contact patches (N).
    pub(in crate::run_page) normal_n: f64,
    /// The contact patch with the largest normal force N.
    pub(in crate::run_page) contact: Contact,
    /// States of the two bodies.
    pub(in crate::run_page) states: [BodyState; 2],
    /// Deflections of all fenders.
    pub(in crate::run_page) deflections_m: Deflections,
}

/// The contact of a pair in one time step: sums over its contact patches.
#[derive(Clone, Copy)]
pub(super) struct Touch {
    pub(super) normal_n: f64,
    tangential_n: f64,
    depth_m: f64,
    pub(super) strongest: Contact,
    parts: ForceParts,
}

impl Touch {
    pub(super) fn of(contact: &Contact) -> Touch {
        Touch {
            normal_n: contact.normal_force_n,
            tangential_n: contact.tangential_force_n,
            depth_m: contact.depth_m,
            strongest: *contact,
            parts: of_outlines(contact),
        }
    }

    pub(super) fn with(self, contact: &Contact) -> Touch {
        let mut parts = self.parts;
        add_parts(&mut parts, &of_outlines(contact));
        let is_stronger = contact.normal_force_n > self.strongest.normal_force_n;
        Touch {
            normal_n: self.normal_n + contact.normal_force_n,
            tangential_n: self.tangential_n + contact.tangential_force_n,
            depth_m: greater(self.depth_m, contact.depth_m),
            strongest: if is_stronger { *contact } else { self.strongest },
            parts,
        }
    }
}

/// The parts of a contact's normal force (spring, damper, limiter) if two outlines touch; zero if a fender carries the
/// force.
fn of_outlines(contact: &Contact) -> ForceParts {
    if contact.fender.is_none() { contact.parts } else { ForceParts::default() }
}

impl PairTrace {
    pub(super) fn begin(
        bodies: [usize; 2],
        touch: &Touch,
        deflections_m: &Deflections,
        step: &StepRecord<'_>,
        step_s: f64,
    ) -> PairTrace {
        let peak = Peak {
            t_s: step.t_s,
            normal_n: touch.normal_n,
            contact: touch.strongest,
            states: bodies.map(|i| step.states[i]),
            deflections_m: deflections_m.clone(),
        };
        let mut trace = PairTrace {
            bodies,
            normal_n: Decimator::new(),
            tangential_n: Decimator::new(),
            depth_m: Decimator::new(),
            v_normal_mps: Decimator::new(),
            parts: PartsTrace::default(),
            peak,
            last: touch.strongest,
        };
        if step.index > 0 {
            // Nothing touched from the start until the step before this one.
            let until_s = step.t_s - step_s;
            for series in [&mut trace.normal_n, &mut trace.tangential_n, &mut trace.depth_m] {
                series.rest_until(until_s);
            }
            trace.parts.rest_until(until_s);
        }
        trace
    }

    fn push_forces(&mut self, t_s: f64, normal_n: f64, tangential_n: f64, depth_m: f64) {
        self.normal_n.push(t_s, normal_n);
        self.tangential_n.push(t_s, tangential_n);
        self.depth_m.push(t_s, depth_m);
    }

    pub(super) fn push(
        &mut self,
        touch: Option<&Touch>,
        deflections_m: &Deflections,
        step: &StepRecord<'_>,
    ) {
        let states = self.bodies.map(|i| step.states[i]);
        let Some(touch) = touch else {
            self.push_forces(step.t_s, 0.0, 0.0, 0.0);
            self.parts.push(step.t_s, &ForceParts::default());
            let [v_1, v_2] = states.map(|s| s.velocity_at(self.last.point_m));
            self.v_normal_mps.push(step.t_s, (v_1 - v_2).dot(self.last.normal));
            return;
        };
        self.push_forces(step.t_s, touch.normal_n, touch.tangential_n, touch.depth_m);
        self.parts.push(step.t_s, &touch.parts);
        self.v_normal_mps.push(step.t_s, touch.strongest.v_normal_mps);
        self.last = touch.strongest;
        if touch.normal_n > self.peak.normal_n {
            self.peak.t_s = step.t_s;
            self.peak.normal_n = touch.normal_n;
            self.peak.contact = touch.strongest;
            self.peak.states = states;
            self.peak.deflections_m.clone_from(deflections_m);
        }
    }
}
