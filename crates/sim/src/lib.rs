//! Vessels and their world around the contact engine: rigid bodies in the plane, external loads,
//! integrators, the energy ledger and what a run reports.
//!
//! A [`Setup`] is the constant part; [`Simulation`] steps it and hands out one [`StepRecord`] a
//! step. No files, no clock, no threads.
//!
//! ```
//! use fenderline_contact::{Material, Outline, vec2};
//! use fenderline_sim::*;
//! let square = [vec2(-5.0, -5.0), vec2(5.0, -5.0), vec2(5.0, 5.0), vec2(-5.0, 5.0)];
//! let (outline, _) = Outline::new(&square)?;
//! let body = |name: &str, mass, north_m: f64, speed_mps| BodySetup {
//!     name: name.into(),
//!     outline: outline.clone(),
//!     mass,
//!     position_m: vec2(north_m, 0.0),
//!     heading_rad: 0.0,
//!     velocity: BodyVelocity { surge_mps: speed_mps, ..Default::default() },
//! };
//! let mass = MassProperties { mass_kg: 1e6, yaw_inertia_kgm2: 2e7, ..Default::default() };
//! let setup = Setup {
//!     step_s: 0.1,
//!     duration_s: 20.0,
//!     integrator: Integrator::Euler,
//!     method: Method::Paper,
//!     bodies: vec![body("tug", Some(mass), 0.0, 1.0), body("quay", None, 11.0, 0.0)],
//!     materials: vec![NamedMaterial {
//!         name: "rubber".into(),
//!         material: Material {
//!             stiffness_npm2: 500e3,
//!             damping_nspm2: 0.0,
//!             shear_stiffness_npm: 3e6,
//!             friction_static: 0.5,
//!             friction_dynamic: 0.5,
//!             restitution: 0.1,
//!         },
//!     }],
//!     pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
//!     all_other_pairs: None,
//!     fenders: vec![],
//!     berthing: None,
//!     loads: vec![],
//!     world: WorldSetup::default(),
//! };
//! let mut simulation = Simulation::new(setup)?;
//! while !simulation.is_done() {
//!     simulation.step()?;
//! }
//! let pair = &simulation.pair_summaries()[0];
//! assert!((pair.final_speed_mps - 0.1).abs() < 1e-9); // γ times the approach speed
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
#![forbid(unsafe_code)]

pub mod attitude;
pub mod berthing;
pub mod control;
pub mod environment;
pub mod external;
pub mod hydro;

mod error;
mod fender;
mod fixed_order;
mod gain;
mod gather;
mod integrate;
mod ledger;
mod load_work;
pub mod mooring;
pub mod order;
mod random;
mod range;
mod record;
mod rigid_body;
mod setup;
mod simulation;
mod summary;
pub mod tug;
mod turning;
mod world;

pub use error::{SetupError, SimError};
pub use fender::{FenderSetup, FenderSource, FenderSummary, HullPressure, Rated};
pub use gain::EnergyGain;
pub use order::{Action, LineAction, Order, OrderError, OrderName, Station, VesselAction};
pub use range::OutOfRange;
pub use record::{ContactEnergy, Energy, LoadWork, StepRecord};
pub use setup::{
    BodySetup, BodyVelocity, Integrator, Load, MassProperties, Method, NamedMaterial, PairSetup,
    Setup,
};
pub use simulation::Simulation;
pub use summary::PairSummary;
pub use world::{
    Assist, AssistPilot, AzimuthOrder, AzimuthSetup, AzimuthState, Environment, Faults, Float, Job,
    LineEnd, Mooring, MooringSetup, NotAtTheSide, Pilots, ProviderSetup, PushJob, ThrusterSetup,
    TugAtWork, TugSetup, VesselForces, VesselOrders, VesselSetup, VesselState, WorldEvent,
    WorldEventKind, WorldSetup, mass_matrix,
};
