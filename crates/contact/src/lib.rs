//! The contact engine of fenderline: horizontal forces between ships, fenders, quays and tugs.
//!
//! One call, [`step()`], takes the states of all bodies and a time step and gives the contacts and
//! one wrench per body. The constant part of a problem is a [`Model`]; what lives from step to step
//! is a [`Memory`], plain data that can be copied, saved and restored; [`Workspace`] holds buffers
//! and results, so that a warm step allocates nothing.
//!
//! Equation numbers are those of Moreno, Sasaki, Makiyama & Tannuri, "Vessel-Fender Contact Force
//! Modelling for a Real-time Ship Manoeuvring Simulator", TransNav 17(4), 2023, with the signs and
//! terms put right (ARCHITECTURE.md lists what and why).
//!
//! ```
//! use fenderline_contact::*;
//! # let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
//! # let (outline, _) = Outline::new(&square)?;
//! # let mut builder = Model::builder();
//! # let tug = builder.body(Body { name: "tug".into(), key: 1, outline: outline.clone(),
//! #     mobility: Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 } });
//! # let quay = builder.body(Body { name: "quay".into(), key: 2, outline, mobility: Mobility::Fixed });
//! # let rubber = builder.material(Material { stiffness_npm2: 500e3, damping_nspm2: 0.0,
//! #     shear_stiffness_npm: 3e6, friction_static: 0.5, friction_dynamic: 0.5, restitution: 0.1 });
//! # builder.pair(Pair { bodies: [tug, quay], material: rubber });
//! # let model = builder.build()?;
//! let mut memory = Memory::new(&model);
//! let mut work = Workspace::new(&model);
//! let states = [
//!     BodyState { position_m: vec2(0.0, 0.0), velocity_mps: vec2(0.5, 0.0), ..Default::default() },
//!     BodyState { position_m: vec2(9.9, 0.0), ..Default::default() },
//! ];
//! step(&model, &mut memory, &mut work, &states, 0.1)?;
//! assert!((work.contacts()[0].area_m2 - 1.0).abs() < 1e-12);
//! assert!((work.wrenches()[0].force_n.x + 500e3).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;
#[cfg(test)]
extern crate std;

mod admit;
mod angle;
mod broad;
mod coupled;
mod error;
mod events;
mod face;
mod fender;
mod geometry;
mod host;
mod inherit;
mod law;
mod limit;
mod mass;
mod memory;
mod model;
mod near;
pub mod number;
pub mod outline;
mod overlap;
mod pairing;
mod pause;
mod ranked;
mod report;
mod snapshot;
mod state;
mod step;
mod touch;
mod unloading;
mod vec2;
mod workspace;

pub use coupled::press_out::MAX_PUSH_OUT_MPS;
pub use coupled::{advance, advance_from_engine_states, advance_in_place};
pub use error::{DisplayNumber, ModelError, RestoreError, StepError};
pub use fender::{Fender, FenderId, FenderLaw, ReactionFactors, Stop};
pub use geometry::clip::{Clip, PairClip};
pub use geometry::convex::ConvexPolygon;
pub use host::{CoSimHost, DirectHost, HostIntegration, HostSettings, HostWorkspace};
pub use memory::Memory;
pub use model::{Body, BodyId, Material, MaterialId, Mobility, Model, ModelBuilder, Pair};
pub use outline::{Outline, OutlineError, OutlineNotice};
pub use report::{
    Contact, ContactImpulse, ContactWork, Displacement, EnergyParts, Event, EventKind, ForceParts,
    Friction, Wrench,
};
pub use snapshot::SNAPSHOT_VERSION;
pub use state::BodyState;
pub use step::step;
pub use unloading::Unloading;
pub use vec2::{Pose, Rotation, Vec2, vec2};
pub use workspace::Workspace;
