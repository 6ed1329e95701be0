//! Hosts that show old states and tell no loads: a co-simulation master, say, or the loop of a game, that
//! moves its bodies by itself, shows them some steps late and keeps its loads to itself.
//!
//! One step, in the order of [`CoSimHost::step`]:
//!
//! 1. [`observer`]: from two states shown and the wrench given between them, the load;
//! 2. [`predictor`]: from the state shown, with the wrenches given since, the host's present;
//! 3. [`steering`]: where the engine has to begin, for a host that integrates as this one does;
//! 4. [`crate::advance`];
//! 5. [`steering`]: the wrench that makes the host's own integration land where the engine did; of a host whose
//!    step varies [`lead`]: the wrench that takes it along with the engine, whatever step comes next.

mod cosim;
mod direct;
mod inertia;
mod lead;
mod mass_check;
mod observer;
mod predictor;
mod settings;
mod snapshot;
mod steering;
mod workspace;

pub use cosim::CoSimHost;
pub use direct::DirectHost;
pub use settings::{HostIntegration, HostSettings};
pub use workspace::HostWorkspace;
