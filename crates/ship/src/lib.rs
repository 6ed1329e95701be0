//! The physics of a ship afloat: from her state, her settings and the weather to forces and moments.
//!
//! Each part of the physics is a set of pure functions and small states. No part of this crate knows of a run, of
//! contacts between bodies or of a file. The crate `fenderline-sim` puts the parts of this crate together to a world
//! that moves. Units are SI. Forces in a ship's axes are positive forward and to starboard, moments and angles positive
//! clockwise, seen from above.
//!
//! | subject | module |
//! |---|---|
//! | forces of hull, propeller, rudder and thruster; standard manoeuvres | [`hydro`] |
//! | wind, current, waves, tide and banks | [`environment`] |
//! | heave, roll and pitch | [`attitude`] |
//! | mooring lines and winches | [`mooring`] |
//! | anchors, windlass and holding ground | [`anchor`] |
//! | break load and stiffness of chain | [`chain`] |
//! | tugs as force vectors | [`tug`] |
//! | ships that pass, and the flow between ships and along walls | [`passing`] |
//! | position of a ship that follows waypoints at given speeds | [`track`] |
//! | controllers for heading, position and thrust | [`control`] |
//! | start and length of a time step | [`step_time`] |
#![forbid(unsafe_code)]

pub mod anchor;
pub mod attitude;
pub mod chain;
pub mod constants;
pub mod control;
pub mod distance;
pub mod environment;
pub mod hydro;
pub mod mooring;
pub mod passing;
pub mod random;
pub mod range;
pub mod step_time;
pub mod track;
pub mod tug;
