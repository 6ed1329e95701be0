//! Results of a step.

use fenderline_contact::{
    BodyState, Contact, ContactImpulse, ContactWork, Event, HostWorkspace, PanelMotion, Workspace,
    Wrench,
};

/// Results of the engine's last step, or the results that were saved with the engine. Unless stated otherwise, lists of
/// results have one entry per body, in the order of the model.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Results<'a> {
    /// The wrench on each body that the host adds to its own forces for the step: earth-fixed, about the centre of
    /// gravity. For a direct host this wrench is the mean contact wrench over the step; if the host moves the body
    /// itself, the wrench includes a correction that keeps the body on the engine's motion. For a co-simulation host
    /// this wrench moves the body to the position that the engine computed.
    pub wrenches: &'a [Wrench],
    /// The largest contact wrench on each body within the step, while `wrenches` are means: see
    /// [`fenderline_contact::Workspace::peak_wrenches_into`]. Use the largest wrenches to size fenders, and `wrenches`
    /// to move bodies.
    pub peak_wrenches: &'a [Wrench],
    /// The contact patches of the step, in a fixed order.
    pub contacts: &'a [Contact],
    /// The motion of panels on several cones, for the panels that a hull presses.
    pub panels: &'a [PanelMotion],
    /// The events of the contacts in the step.
    pub events: &'a [Event],
    /// The engine's states at the end of the step, for direct hosts that let the engine move the bodies; empty for
    /// co-simulation hosts and with the paper's method, because the host moves the bodies. As in a leapfrog scheme, the
    /// velocities in `states_after` are half a step older than the positions (half of the last sub-step, if contacts
    /// needed several).
    pub states_after: &'a [BodyState],
    /// The engine's estimate of a co-simulation host's states and loads; `None` for a direct host.
    pub host_estimate: Option<HostEstimate<'a>>,
}

/// The engine's estimate of a co-simulation host's states and loads.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HostEstimate<'a> {
    /// The host's present states.
    pub states: &'a [BodyState],
    /// Loads on the host's bodies, reported by the host or observed by the engine.
    pub loads: &'a [Wrench],
}

impl Results<'_> {
    /// Whether every number among the results is finite.
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
            && self.panels.iter().all(|panel| panel_numbers(panel).all(f64::is_finite))
    }
}

/// All numbers of a panel, in the order in which they are saved.
pub(crate) fn panel_numbers(p: &PanelMotion) -> impl Iterator<Item = f64> + '_ {
    let own = [p.deflection_m, p.tilt_rad, p.moment_nm, p.peak_tilt_rad, p.peak_moment_nm];
    let lists = p.peak_deflections_m.iter().chain(&p.least_deflections_m).chain(&p.peak_tensions_n);
    own.into_iter().chain(lists.copied())
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

/// How many numbers [`numbers`] gives for a contact.
pub(crate) const CONTACT_NUMBERS: usize = 34;

/// Results that were saved with an engine.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Saved {
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) peak_wrenches: Vec<Wrench>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) panels: Vec<PanelMotion>,
    pub(crate) events: Vec<Event>,
    pub(crate) states_after: Vec<BodyState>,
    pub(crate) host_estimate: Option<(Vec<BodyState>, Vec<Wrench>)>,
}

impl Saved {
    /// Makes these results those of a pause, a step of zero length.
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
            panels: &self.panels,
            events: &self.events,
            states_after: &self.states_after,
            host_estimate: self
                .host_estimate
                .as_ref()
                .map(|(states, loads)| HostEstimate { states, loads }),
        }
    }
}

/// Gathers the results of the paper's method, which has no sub-steps.
pub(crate) fn of_paper(work: &Workspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.wrenches(),
        contacts: work.contacts(),
        panels: work.panels(),
        events: work.events(),
        states_after: &[],
        host_estimate: None,
    }
}

/// Gathers the results for a direct host, by the coupled method.
pub(crate) fn of_direct(work: &HostWorkspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.peak_wrenches(),
        contacts: work.contacts(),
        panels: work.panels(),
        events: work.events(),
        states_after: work.states_after(),
        host_estimate: None,
    }
}

/// Gathers the results for a co-simulation host.
pub(crate) fn of_cosim(work: &HostWorkspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        peak_wrenches: work.peak_wrenches(),
        contacts: work.contacts(),
        panels: work.panels(),
        events: work.events(),
        states_after: &[],
        host_estimate: Some(HostEstimate { states: work.estimated_states(), loads: work.loads() }),
    }
}
