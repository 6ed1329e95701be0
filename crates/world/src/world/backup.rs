//! A copy of the state of vessels, tugs, lines and anchors before a step. If the step fails, the state is restored from
//! the copy.

use super::anchor::AnchorAtWork;
use super::event::WorldEvent;
use super::line::Mooring;
use super::state::World;
use super::tug::TugAtWork;
use super::vessel::{VesselForces, VesselState, WaterInertia};

/// The state of vessels, tugs, lines and anchors before a step. Each step writes into the same memory.
#[derive(Clone, Debug, Default)]
pub struct WorldBackup {
    vessels: Vec<VesselState>,
    forces: Vec<VesselForces>,
    water_inertia: Vec<WaterInertia>,
    lines: Vec<Mooring>,
    anchors: Vec<AnchorAtWork>,
    tugs: Vec<TugAtWork>,
    events: Vec<WorldEvent>,
    taken: usize,
    clamped: Vec<bool>,
}

impl World {
    /// Copies the parts of this state that a step changes into a backup.
    pub fn back_up(&self, into: &mut WorldBackup) {
        let WorldBackup {
            vessels,
            forces,
            water_inertia,
            lines,
            anchors,
            tugs,
            events,
            taken,
            clamped,
        } = into;
        copy_all(vessels, &self.vessels, VesselState::copy_from);
        forces.clone_from(&self.forces);
        water_inertia.clone_from(&self.water_inertia);
        copy_all(lines, &self.lines, Mooring::copy_from);
        anchors.clone_from(&self.anchors);
        copy_all(tugs, &self.tugs, TugAtWork::copy_from);
        events.clone_from(&self.events);
        *taken = self.taken;
        clamped.clone_from(&self.clamped);
    }

    /// Takes the copied parts back from a backup. The backup then has the values that the step calculated.
    pub fn put_back(&mut self, backup: &mut WorldBackup) {
        let WorldBackup {
            vessels,
            forces,
            water_inertia,
            lines,
            anchors,
            tugs,
            events,
            taken,
            clamped,
        } = backup;
        std::mem::swap(&mut self.vessels, vessels);
        std::mem::swap(&mut self.forces, forces);
        std::mem::swap(&mut self.water_inertia, water_inertia);
        std::mem::swap(&mut self.lines, lines);
        std::mem::swap(&mut self.anchors, anchors);
        std::mem::swap(&mut self.tugs, tugs);
        std::mem::swap(&mut self.events, events);
        std::mem::swap(&mut self.taken, taken);
        std::mem::swap(&mut self.clamped, clamped);
    }
}

/// Copies a list item by item.
fn copy_all<T: Clone>(into: &mut Vec<T>, from: &[T], copy: fn(&mut T, &T)) {
    into.truncate(from.len());
    for (own, other) in into.iter_mut().zip(from) {
        copy(own, other);
    }
    let known = into.len();
    into.extend_from_slice(&from[known..]);
}
