//! The world around the bodies of a set-up: everything that acts on the bodies except contact and plain loads.
//!
//! [`WorldSetup`] is the constant part of the world. In each step, before contact, `World::step` carries out the orders
//! that are due, runs the pilots, moves rudders, shafts and thrusters, and adds the wrench (force and moment) of hull,
//! propeller, rudder, thrusters and wind to the load of each vessel's body. After contact, `World::settle` moves the
//! vessels in heave, roll and pitch with all horizontal forces and the heights at which they act.

mod abilities;
mod afloat;
mod anchor;
mod assist;
mod assist_task;
mod azimuth;
mod azimuth_pilot;
mod backup;
mod bank_walls;
mod bollard;
mod current_table;
mod environment;
mod event;
mod fault;
mod grounding;
mod inputs;
mod line;
mod line_end;
mod line_work;
pub mod passing;
mod pilot;
mod pilots;
mod seaway;
mod seaway_state;
pub(crate) mod setup;
mod shore;
mod soundings;
mod state;
mod tug;
mod vessel;

pub use self::backup::WorldBackup;
pub use self::shore::Shore;
pub use self::state::{World, motions};
pub use anchor::{AnchorAtWork, AnchorSetup, AnchorStart, AnchoredShip};
pub use assist::{Assist, AssistPilot, Job, NotAtTheSide, PushJob};
pub use azimuth::{AzimuthOrder, AzimuthSetup, AzimuthState, ThrusterSetup};
pub use bank_walls::Walls;
pub use bollard::{BollardSetup, LineHandling};
pub use current_table::CurrentTable;
pub use environment::{Bottom, Environment, NoDepth, Outside};
pub use event::{WorldEvent, WorldEventKind};
pub use fault::{Fault, Faults, Tripped};
pub use inputs::{Moving, MovingBodies, StepTimes, Surroundings};
pub use line::{LineWorld, Mooring, MooringLines, MooringSetup, Sent};
pub use line_end::LineEnd;
pub use line_work::Sending;
pub use pilots::Pilots;
pub use setup::{ProviderSetup, WorldSetup};
pub use soundings::Soundings;
pub use tug::{TugAtWork, TugSetup};
pub use vessel::{Float, VesselForces, VesselOrders, VesselSetup, VesselState, mass_matrix};
pub use vessel::{HullMotion, WaterInertia};
