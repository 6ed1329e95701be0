//! A world of bodies, ships, fenders, lines and tugs: the parts that are constant in a run, the parts that change in a
//! run, and the record of a step.
//!
//! [`setup::Setup`] holds everything that is constant in a run. [`world::World`] is the state of vessels, tugs, lines
//! and anchors, and finds their forces by the physics of `fenderline-ship`. Orders and changes of the weather act on
//! the world. The crate `fenderline-sim` steps the world; the crate `fenderline-assess` reads the
//! [`record::StepRecord`] of each step.
//!
//! | subject | module |
//! |---|---|
//! | bodies, materials, pairs and loads of a run | [`setup`] |
//! | masses of the bodies and model of the contact engine, made from a set-up | [`model`], [`rigid_body`] |
//! | vessels, tugs, lines and anchors in a step, pilots | [`world`] |
//! | orders to vessels, tugs, lines and anchors | [`order`] |
//! | changes of the weather, faults | [`change`] |
//! | fenders, their panels and chains | [`fender`], [`panel`], [`chain`] |
//! | flexible dolphins | [`dolphin`] |
//! | hulls with outlines at several heights | [`hull`] |
//! | how a ship approaches her berth | [`approach`] |
//! | berthing energy by PIANC's formulas | [`berthing`] |
//! | limits on motions, lines and fenders | [`limit`] |
//! | the user's partial factors | [`factors`] |
//! | forces from other programs | [`external`] |
//! | energies of a step and of a run | [`record`], [`ledger`], [`contact_totals`] |
#![forbid(unsafe_code)]

pub mod approach;
pub mod berthing;
pub mod chain;
pub mod change;
pub mod chart;
pub mod contact_totals;
pub mod dolphin;
mod energy;
pub mod error;
pub mod external;
pub mod factors;
pub mod fender;
pub mod fixed_order;
pub mod hull;
pub mod ledger;
pub mod limit;
pub mod looks;
pub mod mean_velocity;
pub mod model;
pub mod named;
pub mod order;
pub mod overhead;
pub mod panel;
pub mod record;
pub mod rigid_body;
pub mod setup;
pub mod start;
pub mod turning;
pub mod world;
