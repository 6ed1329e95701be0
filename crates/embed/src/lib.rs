//! The contact engine as one object for other simulators. The C interface, the FMU and the Python package are wrappers
//! around this crate. This crate contains no physics of its own.
//!
//! An [`Engine`] is made from a scenario ([`Engine::from_scenario`]) or by calls ([`EngineBuilder`]), for a direct or a
//! co-simulation host ([`Settings`]). The host sets states, sets loads if it knows them, takes a step, and reads the
//! [`Results`]. The host can save the engine as bytes at any time, and restore the engine from them. A call of the
//! engine that fails changes nothing.
//!
//! ```
//! use fenderline_embed::*;
//! # let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/paper/experiment_2_4kn.toml");
//! # let coupled = fenderline_scenario::Override::parse("contact.method=coupled")?;
//! # let scenario = fenderline_scenario::Scenario::load(file.as_ref(), &[coupled])?;
//! let mut engine = Engine::from_scenario(scenario, &Settings::default())?;
//! let tug = engine.body_named("tug")?;
//! let mut states = engine.initial_states().to_vec();
//! for _ in 0..50 {
//!     engine.set_states(&states)?;
//!     engine.step(0.1)?;
//!     let wrench = engine.results()?.wrenches[tug];
//!     let velocity_mps = states[tug].velocity_mps;
//!     states[tug].position_m += velocity_mps * 0.1;
//!     states[tug].velocity_mps += wrench.force_n * (0.1 / 1.01e6);
//! }
//! assert!(states[tug].velocity_mps.y < 0.0); // she has bounced off the ship's side
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

mod builder;
mod by_keys;
mod bytes;
mod drawing;
mod dump;
mod engine;
mod error;
mod outlines;
mod recorded;
mod recording;
mod results;
mod settings;
mod snapshot;
mod step;

pub use builder::{BodyDef, EngineBuilder, FenderDef};
pub use drawing::FenderView;
pub use dump::{Dump, DumpedOutcome, DumpedStep, is_dump};
pub use engine::Engine;
pub use error::EngineError;
pub use outlines::{hull_of_points, mirrored_outline, simplified_outline};
pub use recorded::MOST_RECORDED_STEPS;
pub use results::{HostEstimate, Results};
pub use settings::{CoriolisTerms, Host, MAX_DELAY_STEPS, Settings};

/// Runs the pieces of code in the guide as tests.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/guides/rust.md")]
pub struct Guide;
