//! Hydrodynamics of a ship: hull, propeller, rudder and thruster forces as pure functions, and a manoeuvring model in
//! three degrees of freedom.
//!
//! | subject | item |
//! |---|---|
//! | main particulars, checked | [`Particulars`] |
//! | added mass from particulars | [`zhou_added_mass`], [`clarke_added_mass`] |
//! | hull of a ship under way: MMG polynomials in v', r' or in β, r' | [`Polynomial`] |
//! | hull at low speed, going astern or crabbing: cross-flow drag | [`LowSpeedHull`], [`CrossFlow`] |
//! | lift that a hull loses as its drift increases | [`Stall`] |
//! | continuous hull force, joined from all these forms | [`Hull`] |
//! | propeller in four quadrants | [`Propeller`] |
//! | rudder behind a propeller that goes ahead or astern or is stopped | [`Rudder`] |
//! | tunnel and azimuth thrusters | [`TunnelThruster`], [`AzimuthThruster`] |
//! | actuators: steering gear, shaft, lag, telegraph | [`actuator`] |
//! | the complete manoeuvring model of a ship | [`Mmg`], [`Mmg::forces`] |
//! | effects of shallow water: corrections of hull, propeller, rudder and added mass; squat, current | [`shallow`], [`Squat`] |
//! | equations of motion with two integrators | [`Model3`] |
//! | sources of a ship's data | [`vessels`] |
//! | estimates of a ship's unknown coefficients from her main particulars | [`estimated`] |
//! | standard manoeuvres: turning circle, zig-zag, crash stop, crabbing, bollard pull | [`manoeuvres`] |
//!
//! The conventions are: SI units; x forward, y to starboard, yaw and rudder positive to starboard, everything about
//! midship; velocities are *through the water*. Every hydrodynamic force is a continuous function of velocity,
//! revolutions and rudder angle, at rest and in all quadrants (`tests/hydro_continuity.rs`).
//!
//! ```
//! use fenderline_scenario::VesselLibrary;
//! use fenderline_ship::hydro::{Model3, Water, manoeuvres};
//! let vessel = VesselLibrary::built_in().vessel("kvlcc2")?.trial();
//! let model = Model3::new(vessel.ship, Water::SEA);
//! let approach_mps = vessel.approach_mps.ok_or("no speed of approach")?;
//! let approach = manoeuvres::Approach::at(&model, approach_mps, vessel.steering, 0.5)?;
//! let turn = manoeuvres::turning_circle(&model, &approach, 35_f64.to_radians())?;
//! assert!((turn.advance_m / 320.0 - 3.03).abs() < 0.03);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

pub mod actuator;
pub mod manoeuvres;
pub mod shallow;
mod squat;
mod stall;
pub mod vessels;

mod added_mass;
mod blend;
mod error;
mod estimate;
mod friction;
mod linear_terms;
mod low_speed;
mod mmg;
mod model3;
mod particulars;
mod polynomial;
mod propeller;
mod propeller_series;
mod quantities;
mod rudder;
mod source;
mod thruster;

pub use added_mass::{AddedMass, clarke_added_mass, zhou_added_mass};
pub use blend::{Hull, polynomial_weight};
pub use error::HydroError;
pub use estimate::{
    EstimateMethod, Estimated, Known, Ratio, RatioOutOfRange, SternCoefficients, SternGear,
    VALIDATED_RATIOS, estimated, estimated_by,
};
pub use friction::ittc_1957;
pub use low_speed::{CrossFlow, LowSpeedHull, hoerner_drag_coefficient};
pub use mmg::{
    DriftPolynomial, LinearTerms, Mmg, Parts, Polynomial, Propulsion, SwayPolynomial, Wake,
};
pub use model3::{Model3, Motion};
pub use particulars::Particulars;
pub use propeller::{Propeller, Series};
pub use quantities::{Controls, Force, Velocity, Water};
pub use rudder::{Race, Rudder};
pub use squat::FASTEST_FROUDE;
pub use squat::{Squat, critical_mps};
pub use stall::Stall;
pub use thruster::{AzimuthThruster, TunnelThruster, tunnel_effect};
