//! What an engine has to know of its host.

use fenderline_contact::HostSettings;
use fenderline_sim::Method;

/// Most steps of delay that an engine reckons with.
pub const MAX_DELAY_STEPS: u32 = 1000;

/// How an engine is to work.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The contact method; `None`: the scenario's, and the coupled one where there is no scenario.
    pub method: Option<Method>,
    /// What is known of the host.
    pub host: Host,
}

/// What kind of host shows the states.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// One that shows the states of the step's beginning and tells all its loads (none: zero): each step is
    /// one of [`fenderline_contact::DirectHost`] or, by the paper's method, of [`fenderline_contact::step`].
    Direct {
        /// Whose the turning of momentum is; `None`: as `fenderline run` has it with the scenario's
        /// integrator, and the engine's where there is no scenario.
        coriolis: Option<CoriolisTerms>,
    },
    /// One that moves its bodies by itself, may show old states and need not tell its loads: a co-simulation
    /// master. Each step is one of [`fenderline_contact::CoSimHost`], by the coupled method only.
    CoSimulation(HostSettings),
}

impl Default for Host {
    fn default() -> Host {
        Host::Direct { coriolis: None }
    }
}

/// Who turns the momentum of a body whose added mass differs between surge and sway (its Coriolis and
/// centripetal terms). Of no matter by the paper's method, and for vessels, whose loads always hold them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoriolisTerms {
    /// The engine: the loads that the host tells are without these terms.
    ByEngine,
    /// The loads that the host tells hold them.
    InLoads,
}
