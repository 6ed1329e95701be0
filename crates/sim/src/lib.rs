//! A ship-manoeuvring simulator in the horizontal plane around the contact engine `fenderline-contact`.
//!
//! The crate simulates ships, tugs, fenders, quays and mooring lines under wind, current, waves and tide: hull forces
//! by the MMG method, propellers, rudders and thrusters, wind and wave loads, elastic lines with winches, pilots that
//! follow orders, and the contact forces between all bodies. The simulator uses no files, clock or threads, and gives
//! the same bits for the same input on every machine.
//!
//! [`Setup`] holds everything that is constant in a run. [`Simulation`] holds the state of a run, advances it by one
//! time step with [`Simulation::step`], and returns a [`StepRecord`] with forces, contacts, energies and events. Units
//! are SI. The axis x points north and y east; headings and moments are positive clockwise, seen from above.
//!
//! # Example
//!
//! In this example wind presses a ship onto a fender on a quay for a minute.
//!
//! ```
//! use fenderline_contact::{FenderLaw, Material, Outline, ReactionFactors, vec2};
//! use fenderline_sim::environment::wind::{Blendermann, RelativeWind, ShipWindage, WindMethod};
//! use fenderline_sim::*;
//!
//! let rectangle = |length_m: f64, beam_m: f64| {
//!     let (l, b) = (0.5 * length_m, 0.5 * beam_m);
//!     Outline::new(&[vec2(-l, -b), vec2(l, -b), vec2(l, b), vec2(-l, b)]).map(|(outline, _)| outline)
//! };
//! // A ship of 200 m heading north. The quay is to starboard, with its face 1.5 m from her side.
//! let ship = BodySetup {
//!     name: "ship".into(),
//!     hull: None,
//!     outline: rectangle(200.0, 32.0)?,
//!     mass: Some(MassProperties {
//!         mass_kg: 4e7,
//!         yaw_inertia_kgm2: 1e11,
//!         added_surge_kg: 2e6,
//!         added_sway_kg: 3e7,
//!         added_yaw_kgm2: 5e10,
//!     }),
//!     position_m: vec2(0.0, 0.0),
//!     heading_rad: 0.0,
//!     velocity: BodyVelocity::default(),
//!     dolphin: None,
//! };
//! let quay = BodySetup {
//!     name: "quay".into(),
//!     outline: rectangle(300.0, 20.0)?,
//!     mass: None,
//!     position_m: vec2(0.0, 16.0 + 1.5 + 10.0),
//!     ..ship.clone()
//! };
//! let rubber = NamedMaterial {
//!     name: "rubber".into(),
//!     material: Material {
//!         stiffness_npm2: 5e5,
//!         damping_nspm2: 0.0,
//!         shear_stiffness_npm: 3e6,
//!         friction_static: 0.3,
//!         friction_dynamic: 0.3,
//!         restitution: 0.3,
//!     },
//! };
//! // A fender in the middle of the quay's face, 1.2 m deep, with a reaction of 1 MN at 0.6 m.
//! let fender = FenderSetup {
//!     name: "fender".into(),
//!     body: 1,
//!     position_m: vec2(0.0, -10.0),
//!     facing_rad: -90_f64.to_radians(),
//!     width_m: 2.0,
//!     height_m: 2.0,
//!     above_water_m: 2.0,
//!     floating: false,
//!     projection_m: 1.2,
//!     law: FenderLaw::Curve(vec![[0.0, 0.0], [0.6, 1e6], [0.9, 1.5e6]]),
//!     unloading: None,
//!     material: 0,
//!     rated: None,
//!     stop: None,
//!     factors: ReactionFactors::default(),
//!     energy_by_angle: vec![],
//!     hull_pressure: HullPressure::OverFace,
//!     hull_pressure_limit_npm2: None,
//!     source: None,
//!     panel: None,
//!     chains: vec![],
//!     panel_mass_kg: 0.0,
//! };
//! // The force of a westerly wind of 15 m/s on the ship.
//! let windage = ShipWindage {
//!     length_m: 200.0,
//!     beam_m: 32.0,
//!     frontal_m2: 900.0,
//!     lateral_m2: 4000.0,
//!     centroid_forward_m: 0.0,
//!     centroid_height_m: 10.0,
//!     method: WindMethod::Blendermann(Blendermann::of_type("car carrier").ok_or("no such type")?),
//! };
//! let wind = RelativeWind::of(vec2(0.0, 15.0), vec2(0.0, 0.0), ship.heading_rad);
//! let [surge_n, sway_n, yaw_nm] = windage.force(&wind, 1.224);
//! let load = Load {
//!     body: 0,
//!     force_n: vec2(surge_n, sway_n),
//!     moment_nm: yaw_nm,
//!     from_s: 0.0,
//!     until_s: f64::INFINITY,
//! };
//!
//! let mut simulation = Simulation::new(Setup {
//!     step_s: 0.1,
//!     duration_s: 60.0,
//!     integrator: Integrator::SemiImplicit,
//!     method: Method::Coupled,
//!     bodies: vec![ship, quay],
//!     materials: vec![rubber],
//!     pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
//!     all_other_pairs: None,
//!     approaches: vec![],
//!     fenders: vec![fender],
//!     berthing: None,
//!     loads: vec![load],
//!     world: WorldSetup::default(),
//! })?;
//! let mut force_on_ship_n = vec2(0.0, 0.0);
//! while !simulation.is_done() {
//!     let record = simulation.step()?;
//!     force_on_ship_n = record.wrenches[0].force_n;
//! }
//! let fender = simulation.fender_summaries().next().ok_or("the ship did not touch the fender")?;
//! assert!(fender.peak_reaction_n > sway_n); // The ship arrives with some speed.
//! assert!(force_on_ship_n.y <= 0.0); // The fender pushes her away from the quay.
//! assert!(simulation.energy().residual_j.abs() < 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! For a ship with a manoeuvring model, propeller, rudder, lines and a berth, start from a scenario file: the crate
//! `fenderline-scenario` reads scenario files into a [`Setup`].
//!
//! # Where to look next
//!
//! | subject | module or file |
//! |---|---|
//! | the computation of a time step, from start to end | `simulation.rs`, [`Simulation::step`] |
//! | vessels, tugs and lines in a simulation, pilots and orders | [`WorldSetup`], the crate `fenderline-world` |
//! | hull, propeller, rudder and thruster forces; standard manoeuvres | [`hydro`] |
//! | wind, current, waves, tide and banks | [`environment`] |
//! | mooring lines and winches | [`mooring`] |
//! | anchors, chain, windlass and holding ground | [`anchor`] |
//! | ships that pass, and the flow between ships | [`passing`] |
//! | the position of a ship that follows waypoints at given speeds | [`track`] |
//! | statistics of motions, and limits on them | [`statistics`] |
//! | heave, roll and pitch | [`attitude`] |
//! | tugs as force vectors | [`tug`] |
//! | controllers for heading, position and thrust | [`control`] |
//! | the line through a berth's fenders, and a ship's position relative to it | [`berth`] |
//! | berthing energy by PIANC's formulas | [`berthing`] |
//! | exercises: goal, limits and score | [`exercise`] |
//! | weather and faults that change during a run | [`change`] |
//! | forces from other programs | [`external`] |
//! | energies of a step and of a run | [`StepRecord`], [`ContactEnergy`], [`Energy`] |
//!
//! The crate re-exports what its users need of three crates: `fenderline-ship` (physics of a ship), `fenderline-world`
//! (set-up, state and records) and `fenderline-assess` (verdict, statistics).
//!
//! [`Simulation::step`] calls these functions in turn; files of `fenderline-world` are marked W:
//!
//! 1. `gather_loads`: sums the loads of the set-up and of the host program, then of vessels, tugs, lines and
//!    environment (W `world/state.rs`).
//! 2. `turn_momentum`: computes Coriolis and centripetal terms over the step (W `turning.rs`).
//! 3. `advance_bodies`: computes the contact forces (`fenderline_contact::advance_in_place`, or `step` for the method
//!    of Moreno et al. 2023) and the new states (`integrate.rs`).
//! 4. `update_world`: computes heel and trim of the vessels under all forces.
//! 5. `account_energy`: computes the work of each contact and load, and the energy ledger (W `contact_totals.rs`, W
//!    `ledger.rs`).
//! 6. `record`: updates the summaries and makes the [`StepRecord`].
#![forbid(unsafe_code)]

pub mod berth;
pub mod exercise;

mod gather;
mod integrate;
mod load_work;
mod output_plan;
mod simulation;

/// Berthing energy by PIANC's formulas, and the comparison of a simulated berthing with these formulas.
pub mod berthing {
    pub use fenderline_assess::berthing::{
        AddedSway, BerthingOutcome, LaterHit, OtherShip, ShallowFactor,
    };
    pub use fenderline_world::berthing::*;
}

/// Statistics of motions and lines, and limits on them.
pub mod statistics {
    pub use fenderline_assess::statistics::*;
    pub use fenderline_world::limit::*;
}

pub use fenderline_assess::gain::EnergyGain;
pub use fenderline_assess::summary::PairSummary;
pub use fenderline_assess::verdict::{
    Departure, Finding, Gravity, Law, LawRow, Subject, Verdict, fender_finding,
};
pub use fenderline_seakeeping as seakeeping;
pub use fenderline_ship::chain::{ChainGrade, ChainLink, ChainSize};
pub use fenderline_ship::range::OutOfRange;
pub use fenderline_ship::{
    anchor, attitude, constants, control, distance, environment, hydro, mooring, passing,
    step_time, track, tug,
};
pub use fenderline_world::approach::{Approach, Side};
pub use fenderline_world::chain::{ChainKind, ChainSetup, ChainSummary, ChainTension};
pub use fenderline_world::change::{Change, ChangeError, PlannedChange};
pub use fenderline_world::dolphin::{DolphinMotion, DolphinSetup, DolphinSummary, SteelPiles};
pub use fenderline_world::error::{NoDepthUnder, SetupError, SimError, StepFault};
pub use fenderline_world::fender::{
    FenderSetup, FenderSource, FenderSummary, HullMet, HullPressure, Rated,
};
pub use fenderline_world::hull::{HullByHeight, HullError, HullTouch, Level, SideMissed};
pub use fenderline_world::looks::{Conning, Daylight, Looks, Rain, ShipModel, ShipType};
pub use fenderline_world::named::called;
pub use fenderline_world::order::{
    Action, AnchorAction, LineAction, Order, OrderError, OrderName, Station, VesselAction,
};
pub use fenderline_world::panel::{ConeSummary, ConeUse, PanelSummary};
pub use fenderline_world::record::{ContactEnergy, Energy, LoadWork, StepRecord, WorkCause};
pub use fenderline_world::setup::{
    BodySetup, BodyVelocity, Integrator, Load, MassProperties, Method, NamedMaterial, PairSetup,
    Setup,
};
pub use fenderline_world::start::{BodyStart, Start};
pub use fenderline_world::world::passing::shallowest_on_track_m;
pub use fenderline_world::world::{
    AnchorAtWork, AnchorSetup, AnchorStart, Assist, AssistPilot, AzimuthOrder, AzimuthSetup,
    AzimuthState, BollardSetup, Bottom, CurrentTable, Environment, Fault, Faults, Float, Job,
    LineEnd, LineHandling, Mooring, MooringSetup, NoDepth, NotAtTheSide, Outside, Pilots,
    ProviderSetup, PushJob, Sent, Soundings, ThrusterSetup, Tripped, TugAtWork, TugSetup,
    VesselForces, VesselOrders, VesselSetup, VesselState, Walls, WorldEvent, WorldEventKind,
    WorldSetup, mass_matrix,
};
pub use fenderline_world::{change, chart, external, factors, order, overhead};
pub use output_plan::{OutputPlan, OutputTable};
pub use simulation::Simulation;
