//! Settings of an engine: contact method and host.

use fenderline_contact::HostSettings;
use fenderline_sim::Method;

/// Largest age of the states that a host may pass (steps).
pub const MAX_DELAY_STEPS: u32 = 1000;

/// Settings of an engine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Settings {
    /// The contact method; `None` means the method of the scenario, or the coupled method without a scenario.
    pub method: Option<Method>,
    /// The kind of host.
    pub host: Host,
}

/// The kind of host.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Host {
    /// A direct host, which gives the states at the start of the step and all loads (zero loads if it gives none). Each
    /// step for a direct host is a step of [`fenderline_contact::DirectHost`] or, with the paper's method, a call of
    /// [`fenderline_contact::step`].
    Direct {
        /// Whether the engine or the host computes the Coriolis terms. `None` means the side that `fenderline run` with
        /// the scenario's integrator would choose, or the engine if there is no scenario.
        coriolis: Option<CoriolisTerms>,
    },
    /// A co-simulation host, which moves its bodies itself, may give old states and need not give loads. Each step for
    /// a co-simulation host is a step of [`fenderline_contact::CoSimHost`], by the coupled method only.
    CoSimulation(HostSettings),
}

impl Default for Host {
    fn default() -> Host {
        Host::Direct { coriolis: None }
    }
}

/// Who computes the Coriolis and centripetal terms of a body whose added mass differs between surge and sway. The
/// setting of the Coriolis terms has no effect with the paper's method, nor for vessels, whose loads always include
/// these terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CoriolisTerms {
    /// The engine computes the Coriolis terms: the host's loads exclude them.
    ByEngine,
    /// The host's loads include the Coriolis terms.
    InLoads,
}
