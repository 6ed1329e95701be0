//! The physics of a ship afloat: from her state, her settings and the weather to forces and moments.
//!
//! Each part is a set of pure functions and small states. No part knows of a run, of other bodies' contacts or of a file. The crate
//! `fenderline-sim` puts the parts together to a world that moves. Units are SI. Forces in a ship's axes are positive forward and to
//! starboard, moments and angles positive clockwise, seen from above.
//!
//! | subject | module |
//! |---|---|
//! | hull, propeller, rudder and thruster forces; standard manoeuvres | [`hydro`] |
//! | wind, current, waves, tide and banks | [`environment`] |
//! | six degrees of freedom by hydrodynamic data: exciting forces, memory, drift | [`seakeeping`] |
//! | heave, roll and pitch | [`attitude`] |
//! | mooring lines and winches | [`mooring`] |
//! | anchors, windlass and holding ground | [`anchor`] |
//! | break load and stiffness of chain | [`chain`] |
//! | tugs as force vectors | [`tug`] |
//! | ships that pass, and the flow between ships and along walls | [`passing`] |
//! | where a ship is that follows waypoints at given speeds | [`track`] |
//! | controllers for heading, position and thrust | [`control`] |
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
pub mod seakeeping;
pub mod track;
pub mod tug;
