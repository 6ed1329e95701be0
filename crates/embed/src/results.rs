//! What a step found.

use fenderline_contact::{
    BodyState, Contact, ContactImpulse, ContactWork, Event, HostWorkspace, Workspace, Wrench,
};

/// What the last step found, or what it had found when the engine was saved. One entry a body, in the order
/// of the model, unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Results<'a> {
    /// What the host is to add to its forces for the step: earth-fixed, about the centre of gravity. For a
    /// host of the present the mean contact wrench over the step, and where the host moves the body by itself what
    /// keeps it beside the engine; for a following host the wrench that takes it where the engine went.
    pub wrenches: &'a [Wrench],
    /// The greatest contact wrench within the step, of which the host's is a mean: see
    /// [`fenderline_contact::Workspace::peak_wrenches_into`]. Size fenders by it, and move bodies by `wrenches`.
    pub peak_wrenches: &'a [Wrench],
    /// The touching patches, in a fixed order.
    pub contacts: &'a [Contact],
    /// What happened in the step.
    pub events: &'a [Event],
    /// The states that the engine came to at the end of the step, for hosts that let it move the bodies;
    /// empty by the paper's method and for a following host, who move the bodies themselves. Velocities are those of half
    /// a step before (of half of the last sub-step, where contacts needed several), as a leapfrog has them.
    pub states_after: &'a [BodyState],
    /// What was host_estimate of a following host; `None` for a host of the present.
    pub host_estimate: Option<HostEstimate<'a>>,
}

/// What an engine takes a following host to be doing now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostEstimate<'a> {
    /// The host's present states, which it will show when they are old enough.
    pub states: &'a [BodyState],
    /// The loads, told or observed.
    pub loads: &'a [Wrench],
}

impl Results<'_> {
    /// Is every number among them finite?
    pub(crate) fn are_finite(&self) -> bool {
        let of_state = |s: &BodyState| {
            s.position_m.is_finite()
                & s.heading_rad.is_finite()
                & s.velocity_mps.is_finite()
                & s.yaw_rate_radps.is_finite()
        };
        let of_wrench = |w: &Wrench| w.force_n.is_finite() & w.moment_nm.is_finite();
        self.wrenches.iter().chain(self.peak_wrenches).all(of_wrench)
            && self.states_after.iter().all(of_state)
            && self.host_estimate.is_none_or(|host_estimate| {
                host_estimate.states.iter().all(of_state)
                    && host_estimate.loads.iter().all(of_wrench)
            })
            && self.contacts.iter().all(|contact| numbers(contact).iter().all(|n| n.is_finite()))
    }
}

/// All numbers of a contact, in the order in which they are saved.
pub(crate) fn numbers(c: &Contact) -> [f64; CONTACT_NUMBERS] {
    let (p, w) = (&c.parts, &c.work);
    [
        c.point_m.x,
        c.point_m.y,
        c.arm_1_m.x,
        c.arm_1_m.y,
        c.arm_2_m.x,
        c.arm_2_m.y,
        c.normal.x,
        c.normal.y,
        c.area_m2,
        c.depth_m,
        c.v_normal_mps,
        c.v_tangential_mps,
        c.shear_m,
        c.normal_force_n,
        c.tangential_force_n,
        c.impulse.normal_ns,
        c.impulse.tangential_ns,
        c.peak_normal_force_n,
        c.peak_depth_m,
        p.spring_n,
        p.stop_n,
        p.damper_n,
        p.limiter_n,
        w.normal_j,
        w.tangential_j,
        w.damper_j,
        w.limiter_j,
        c.factor,
        c.tilt_rad,
        c.energy.stored_j,
        c.energy.peak_absorbed_j,
        c.energy.shear_stored_j,
        c.energy.hysteresis_j,
        c.energy.hysteresis_at_start_j,
    ]
}

/// How many they are.
pub(crate) const CONTACT_NUMBERS: usize = 34;

/// Results that were saved with an engine.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Saved {
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) peak_wrenches: Vec<Wrench>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) events: Vec<Event>,
    pub(crate) states_after: Vec<BodyState>,
    pub(crate) host_estimate: Option<(Vec<BodyState>, Vec<Wrench>)>,
}

impl Saved {
    /// A step of no length.
    pub(crate) fn pause(&mut self, states: &[BodyState]) {
        self.events.clear();
        for contact in &mut self.contacts {
            contact.work = ContactWork::default();
            contact.impulse = ContactImpulse::default();
        }
        if !self.states_after.is_empty() {
            self.states_after.copy_from_slice(states);
        }
    }

    pub(crate) fn view(&self) -> Results<'_> {
        Results {
            wrenches: &self.wrenches,
            peak_wrenches: &self.peak_wrenches,
            contacts: &self.contacts,
            events: &self.events,
            states_after: &self.states_after,
            host_estimate: self
                .host_estimate
                .as_ref()
                .map(|(states, loads)| HostEstimate { states, loads }),
        }
    }
}

/// By the paper's method, which knows no sub-steps.
pub(crate) fn of_paper(work: &Workspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.wrenches(),
        contacts: work.contacts(),
        events: work.events(),
        states_after: &[],
        host_estimate: None,
    }
}

/// Of a host of the present, by the coupled method.
pub(crate) fn of_direct(work: &HostWorkspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.peak_wrenches(),
        contacts: work.contacts(),
        events: work.events(),
        states_after: work.states_after(),
        host_estimate: None,
    }
}

pub(crate) fn of_cosim(work: &HostWorkspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.peak_wrenches(),
        contacts: work.contacts(),
        events: work.events(),
        states_after: &[],
        host_estimate: Some(HostEstimate { states: work.estimated_states(), loads: work.loads() }),
    }
}
