//! Settings of an engine: its method and its host.

use fenderline_contact::HostSettings;
use fenderline_sim::Method;

/// Largest delay of a host, in steps.
pub const MAX_DELAY_STEPS: u32 = 1000;

/// Settings of an engine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The contact method; `None`: the scenario's, or the coupled one without a scenario.
    pub method: Option<Method>,
    /// The kind of host.
    pub host: Host,
}

/// The kind of host.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// A host that gives the states at the step's start and all its loads (none: zero). Each step is one of
    /// [`fenderline_contact::DirectHost`] or, with the paper's method, of [`fenderline_contact::step`].
    Direct {
        /// Where the Coriolis terms are; `None`: as in `fenderline run` with the scenario's integrator, or
        /// by the engine without a scenario.
        coriolis: Option<CoriolisTerms>,
    },
    /// A co-simulation master, which moves its bodies itself, may give old states and need not give its loads.
    /// Each step is one of [`fenderline_contact::CoSimHost`], by the coupled method only.
    CoSimulation(HostSettings),
}

impl Default for Host {
    fn default() -> Host {
        Host::Direct { coriolis: None }
    }
}

/// Where the Coriolis and centripetal terms of a body whose added mass differs between surge and sway are computed.
/// It does not matter for the paper's method, nor for vessels, whose loads always include them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoriolisTerms {
    /// The engine computes them: the host's loads exclude them.
    ByEngine,
    /// The host's loads include them.
    InLoads,
}
