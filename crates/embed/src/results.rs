//! What a step found.

use fenderline_contact::{BodyState, Contact, Event, HostWorkspace, Workspace, Wrench};

/// What the last step found, or what it had found when the engine was saved. One entry a body, in the order
/// of the model, unless said otherwise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Results<'a> {
    /// What the host is to add to its forces for the step: earth-fixed, about the centre of gravity. For a
    /// host of the present the mean contact wrench over the step; for a following host the wrench that
    /// takes it where the engine went.
    pub wrenches: &'a [Wrench],
    /// The touching patches, in a fixed order.
    pub contacts: &'a [Contact],
    /// What happened in the step.
    pub events: &'a [Event],
    /// The states that the engine came to at the end of the step, for hosts that let it move the bodies;
    /// empty by the paper's method and for a following host, who move the bodies themselves.
    pub states_after: &'a [BodyState],
    /// What was reckoned of a following host; `None` for a host of the present.
    pub reckoned: Option<Reckoned<'a>>,
}

/// What an engine takes a following host to be doing now.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reckoned<'a> {
    /// The host's present states, which it will show when they are old enough.
    pub states: &'a [BodyState],
    /// The loads, told or observed.
    pub loads: &'a [Wrench],
}

/// Results that were saved with an engine.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Saved {
    pub(crate) wrenches: Vec<Wrench>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) events: Vec<Event>,
    pub(crate) states_after: Vec<BodyState>,
    pub(crate) reckoned: Option<(Vec<BodyState>, Vec<Wrench>)>,
}

impl Saved {
    pub(crate) fn view(&self) -> Results<'_> {
        Results {
            wrenches: &self.wrenches,
            contacts: &self.contacts,
            events: &self.events,
            states_after: &self.states_after,
            reckoned: self.reckoned.as_ref().map(|(states, loads)| Reckoned { states, loads }),
        }
    }
}

/// Of a host of the present; `moved` by the coupled method.
pub(crate) fn of_present(work: &Workspace, moved: bool) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        contacts: work.contacts(),
        events: work.events(),
        states_after: if moved { work.states_after() } else { &[] },
        reckoned: None,
    }
}

pub(crate) fn of_following(work: &HostWorkspace) -> Results<'_> {
    Results {
        wrenches: work.wrenches(),
        contacts: work.contacts(),
        events: work.events(),
        states_after: &[],
        reckoned: Some(Reckoned { states: work.present(), loads: work.loads() }),
    }
}
