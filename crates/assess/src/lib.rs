//! Evaluates a run: totals that are computed from the record of each step. Nothing in this crate changes a run.
//!
//! | subject | module |
//! |---|---|
//! | the verdict on a run, and the physical laws whose range a run can leave | [`verdict`] |
//! | statistics of motions and lines | [`statistics`] |
//! | a simulated berthing, compared with the berthing formulas | [`berthing`] |
//! | totals of each pair of bodies | [`summary`] |
//! | energy that contacts created | [`gain`] |
#![forbid(unsafe_code)]

pub mod berthing;
pub mod gain;
pub mod statistics;
pub mod summary;
pub mod verdict;
