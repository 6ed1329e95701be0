//! Hosts that integrate the bodies themselves. A [`DirectHost`] passes the present states and all loads. A
//! [`CoSimHost`], a co-simulation master or the loop of a game, may pass states that are some steps old and need not
//! report its loads.
//!
//! One step of a [`CoSimHost`] has these stages:
//!
//! 1. [`observer`]: computes the load from two input states and the wrench of the step between them;
//! 2. [`predictor`]: computes the host's present state from the input state and the wrenches given since then;
//! 3. [`steering`]: computes the state from which the engine starts, which depends on how the host integrates;
//! 4. [`crate::advance`];
//! 5. [`steering`]: computes the wrench with which the host's own integration ends at the engine's position; or, if the
//!    host's step varies, [`lead`]: computes the wrench that keeps the host with the engine whatever the next step is.

mod cosim;
mod direct;
mod inertia;
mod lead;
mod mass_check;
mod observer;
mod past_step;
mod predictor;
mod record;
mod settings;
mod snapshot;
mod steering;
mod velocity;
mod workspace;

pub use cosim::CoSimHost;
pub use direct::DirectHost;
pub use settings::{HostIntegration, HostSettings};
pub use workspace::HostWorkspace;
