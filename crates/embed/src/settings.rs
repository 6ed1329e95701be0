//! Settings of an engine: contact method and host.

use fenderline_contact::HostSettings;
use fenderline_sim::Method;

/// Largest delay of a host, in steps.
pub const MAX_DELAY_STEPS: u32 = 1000;

/// Settings of an engine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The contact method; `None`: the method of the scenario, or the coupled method without a scenario.
    pub method: Option<Method>,
    /// The kind of host.
    pub host: Host,
}

/// The kind of host.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// A host that gives the states at the start of the step and all loads (without loads: zero). Each step is a
    /// step of [`fenderline_contact::DirectHost`] or, with the paper's method, a call of
    /// [`fenderline_contact::step`].
    Direct {
        /// Where the Coriolis terms are; `None`: as in `fenderline run` with the scenario's integrator, or
        /// by the engine without a scenario.
        coriolis: Option<CoriolisTerms>,
    },
    /// A co-simulation master, which moves its bodies itself, may give old states and need not give loads. Each
    /// step is a step of [`fenderline_contact::CoSimHost`], by the coupled method only.
    CoSimulation(HostSettings),
}

impl Default for Host {
    fn default() -> Host {
        Host::Direct { coriolis: None }
    }
}

/// Where the Coriolis and centripetal terms of a body whose added mass differs between surge and sway are computed.
/// This setting does not matter for the paper's method, nor for vessels, whose loads always include these terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoriolisTerms {
    /// The engine computes them: the host's loads exclude them.
    ByEngine,
    /// The host's loads include them.
    InLoads,
}
