//! The contact engine as a program of somebody else holds it: one object with everything in it, which the C
//! interface, the FMU and the Python package wrap. No physics here.
//!
//! [`Engine`] is made from a scenario ([`Engine::from_scenario`]) or by calls ([`EngineBuilder`]), for a
//! host that shows present states or for one that shows old ones ([`Settings`]). The host shows states,
//! tells loads where it has them, steps, and reads [`Results`]; at any time it can save the engine to bytes
//! and restore it. A call that fails changes nothing.
//!
//! ```
//! use fenderline_embed::*;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/paper/experiment_2_4kn.toml");
//! # let scenario = fenderline_scenario::Scenario::load(file.as_ref(), &[])?;
//! let mut engine = Engine::from_scenario(scenario, &Settings::default())?;
//! let tug = engine.body_named("tug")?;
//! let mut states = engine.initial_states().to_vec();
//! for _ in 0..50 {
//!     engine.set_states(&states)?;
//!     engine.step(0.1)?;
//!     let wrench = engine.results()?.wrenches[tug];
//!     let way_m = states[tug].velocity_mps * 0.1;
//!     states[tug].position_m += way_m;
//!     states[tug].velocity_mps += wrench.force_n * (0.1 / 1.01e6);
//! }
//! assert!(states[tug].velocity_mps.y < 0.0); // she has bounced off the ship's side
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod builder;
mod bytes;
mod engine;
mod error;
mod results;
mod settings;
mod snapshot;

pub use builder::{BodyDef, EngineBuilder, FenderDef};
pub use engine::Engine;
pub use error::EngineError;
pub use results::{HostEstimate, Results};
pub use settings::{CoriolisTerms, Host, MAX_DELAY_STEPS, Settings};

/// The guide's snippets, as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/guides/rust.md")]
pub struct Guide;
