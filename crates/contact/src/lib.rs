//! Contact forces between ships, fenders, quays and tugs, in the horizontal plane and in real time.
//!
//! Give the engine the state of each body and all forces on it except contact. [`advance`] returns the contact wrench
//! on each body for one time step. The engine solves all contacts of the step together with the other forces on the
//! bodies. If a contact is too stiff for the step, the engine divides the step into sub-steps. So a ship rests on her
//! fenders at her static deflection, and a step of 2 s gives the same peak force as a step of 0.01 s. The same input
//! gives the same bits on every machine.
//!
//! # The parts
//!
//! - [`Model`]: bodies with their outlines and masses, materials, fenders, and the pairs of bodies that may touch. The
//!   model is constant.
//! - [`BodyState`]: position, heading and velocity of one body. [`Wrench`]: a force and a moment on a body.
//! - [`Memory`]: what the engine remembers from one step to the next, as plain data. Copy the memory to branch a run;
//!   save it as bytes and restore it.
//! - [`Workspace`]: the results of the last step, and buffers, which let a step allocate no memory when its buffers are
//!   large enough. No step depends on what former steps left in the workspace.
//!
//! Units are SI. Positions are earth-fixed, north and east; headings and moments are clockwise, seen from above.
//! Outlines are in the frame of the body: *x* forward, *y* to starboard, origin at the centre of gravity.
//!
//! # Example
//!
//! In this example a ship of 36,000 t drifts at 0.1 m/s onto a quay. The program that calls the engine, the *host*,
//! adds the contact wrench to its own forces and integrates the ship's motion.
//!
//! ```
//! use fenderline_contact::*;
//!
//! // 1. The model.
//! let rectangle = |x_m: f64, y_m: f64| {
//!     Outline::new(&[vec2(-x_m, -y_m), vec2(x_m, -y_m), vec2(x_m, y_m), vec2(-x_m, y_m)])
//! };
//! let (hull, wall) = (rectangle(90.0, 15.0)?.0, rectangle(150.0, 5.0)?.0);
//! let mobility = Mobility::Free { mass_kg: 36e6, yaw_inertia_kgm2: 60e9 }; // with added mass
//! let mut builder = Model::builder();
//! let ship = builder.body(Body { name: "ship".into(), key: 1, outline: hull, mobility });
//! let mobility = Mobility::Fixed;
//! let quay = builder.body(Body { name: "quay".into(), key: 2, outline: wall, mobility });
//! let rubber = builder.material(Material {
//!     stiffness_npm2: 500e3, // a rubbing strip; for fenders with reaction curves see `Fender`
//!     damping_nspm2: 0.0,
//!     shear_stiffness_npm: 3e6,
//!     friction_static: 0.3,
//!     friction_dynamic: 0.3,
//!     restitution: 0.5,
//! });
//! builder.pair(Pair { bodies: [ship, quay], material: rubber });
//! let model = builder.build()?;
//!
//! // 2. The host's loop. The quay lies east of the ship, 0.3 m from her side.
//! let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
//! let mut states = [
//!     BodyState { velocity_mps: vec2(0.0, 0.1), ..Default::default() },
//!     BodyState { position_m: vec2(0.0, 20.3), ..Default::default() },
//! ];
//! let (step_s, mut peak_n) = (0.01, 0.0_f64);
//! for _ in 0..2000 {
//!     // All forces on the ship but contact: hull, propeller, wind, tugs. Here there are none.
//!     let loads = [Wrench::default(); 2];
//!     advance(&model, &mut memory, &mut work, &states, &loads, step_s)?;
//!     let force_n = loads[0].force_n + work.wrenches()[0].force_n;
//!     states[0].velocity_mps += force_n * (step_s / 36e6);
//!     let velocity_mps = states[0].velocity_mps;
//!     states[0].position_m += velocity_mps * step_s;
//!     for contact in work.contacts() {
//!         peak_n = peak_n.max(contact.peak_normal_force_n);
//!     }
//! }
//!
//! // 3. v √(m k) on the way in, with k for 180 m of hull; the coefficient of restitution on the way out.
//! assert!((peak_n / (0.1 * (36e6_f64 * 180.0 * 500e3).sqrt()) - 1.0).abs() < 0.01);
//! assert!((states[0].velocity_mps.y / -0.05 - 1.0).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which call to use
//!
//! | Program | Call |
//! |---|---|
//! | a program that lets the engine move the bodies | [`advance_in_place`] |
//! | a program that lets the engine move the bodies, and keeps their states | [`advance_from_engine_states`] |
//! | a program that integrates the bodies itself, by any method and with any time step | [`DirectHost`] |
//! | a program that passes old states or does not know its loads, like a co-simulation master | [`CoSimHost`] |
//! | a program that reproduces the paper's experiments | [`step()`] |
//!
//! [`advance`] starts from the states of the bodies that you pass. The forces of [`advance`] are right for a step of
//! any length: a step of 2 s is divided into sub-steps and has the same peak force as a step of 0.01 s. But a host that
//! moves its bodies by the mean wrench of a long step ends up to ½ a Δt² from the engine's own motion. The next step
//! starts from the host's motion, so contacts that last for several such steps chatter. A [`DirectHost`] continues the
//! engine's motion while bodies touch, and returns the wrench that keeps the host's bodies on the engine's motion. The
//! host's motion and the engine's motion are the same if Δt is short for the contact, as in the example, or if the
//! engine moves the bodies.
//!
//! Worked programs are in `examples/`: `berthing`, `fender_curve`, `own_integrator`, `save_and_restore`.
//!
//! # The paper
//!
//! The contact law is that of Moreno, Sasaki, Makiyama & Tannuri, "Vessel-Fender Contact Force Modelling for a
//! Real-time Ship Manoeuvring Simulator", TransNav 17(4), 2023. Equation numbers in this crate are the paper's.
//! `docs/contact_model.md` has the equations with the misprints corrected, and the coupled method. The paper's method
//! limits the force of each pair of bodies by itself and does not know the other loads. [`step()`] computes the paper's
//! method, for comparison.
#![no_std]
#![forbid(unsafe_code)]

extern crate alloc;
#[cfg(test)]
extern crate std;

mod admit;
mod broad;
mod coupled;
mod error;
mod geometry;
mod host;
mod inherit;
mod law;
mod limit;
mod maths;
mod model;
mod overlap;
mod panel;
mod pause;
mod state;
mod step;
mod touch;

pub use coupled::press_out::MAX_PUSH_OUT_MPS;
pub use coupled::{advance, advance_from_engine_states, advance_in_place};
pub use error::{DisplayNumber, ModelError, RestoreError, StepError};
pub use geometry::clip::{Clip, PairClip};
pub use geometry::convex::ConvexPolygon;
pub use host::{CoSimHost, DirectHost, HostIntegration, HostSettings, HostWorkspace};
pub use law::normal::combined_angle_rad;
pub use maths::vec2::{Pose, Rotation, Vec2, vec2};
pub use maths::{hash, number};
pub use model::body::{Body, Mobility};
pub use model::fender::{Fender, ReactionFactors};
pub use model::material::{BodyId, FenderId, Material, MaterialId};
pub use model::outline;
pub use model::outline::{Outline, OutlineError, OutlineNotice};
pub use model::pile::{Pile, PileMotion};
pub use model::reaction::{FenderLaw, Stop};
pub use model::renew::{Renewal, RenewalBuffers};
pub use model::slice::{SideMet, Slice};
pub use model::unloading::Unloading;
pub use model::{Model, ModelBuilder, Pair};
pub use panel::report::PanelMotion;
pub use panel::{Panel, TensionChain};
pub use state::body_state::BodyState;
pub use state::bytes::SNAPSHOT_VERSION;
pub use state::memory::Memory;
pub use state::report::{
    Contact, ContactImpulse, ContactWork, Displacement, EnergyParts, Event, EventKind, ForceParts,
    Friction, Wrench,
};
pub use state::workspace::Workspace;
pub use step::step;
