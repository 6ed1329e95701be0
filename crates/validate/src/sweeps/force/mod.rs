//! The sweeps of all forces, with a file for each force. A file of this folder has the situations and the laws of its
//! sweeps, but never a number of a reference.

mod anchor;
mod bank;
mod current;
mod drift;
mod ground;
mod hull;
mod line;
mod passing;
mod propeller;
mod rudder;
mod thruster;
mod tug;
mod wind;

use super::sweep::Sweep;

/// All sweeps, force by force.
pub(super) fn all() -> Vec<Sweep> {
    let forces: [fn() -> Vec<Sweep>; 13] = [
        hull::sweeps,
        current::sweeps,
        wind::sweeps,
        bank::sweeps,
        passing::sweeps,
        drift::sweeps,
        propeller::sweeps,
        rudder::sweeps,
        thruster::sweeps,
        tug::sweeps,
        line::sweeps,
        anchor::sweeps,
        ground::sweeps,
    ];
    forces.into_iter().flat_map(|sweeps| sweeps()).collect()
}
