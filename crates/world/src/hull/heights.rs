//! Heights of fenders and hulls in a step, and the work that changes of these heights do on fenders.

use crate::world::{HullMotion, Shore, VesselState};

/// The energy that a new outline of a hull, or the lean of a fender, put into the fender.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HeightWork {
    /// Indices of the two bodies, the smaller index first.
    pub bodies: [usize; 2],
    /// Index of the fender.
    pub fender: usize,
    /// The energy that the new outline or the lean put into the fender (J).
    pub work_j: f64,
}

/// Heights of fenders and hulls in a step.
#[derive(Clone, Copy)]
pub struct Heights<'a> {
    /// The heights of points on quays and on vessels.
    pub shore: Shore<'a>,
    /// Heave, roll and pitch of the vessels.
    pub vessels: &'a [VesselState],
    /// Start of the step (s).
    pub t_s: f64,
    /// Length of the step (s).
    pub step_s: f64,
}

impl Heights<'_> {
    /// Heave, roll and pitch of a vessel in the middle of the step; zero for other bodies. For a vessel with
    /// hydrodynamic data, heave, roll and pitch are those at the start of the step, because in the leapfrog the contact
    /// forces act at that time. With values half a step later, a roll against a fender would gain energy.
    pub(super) fn motion(&self, vessel: Option<usize>) -> HullMotion {
        vessel.map_or(HullMotion::default(), |index| {
            let vessel = &self.vessels[index];
            vessel.motion_after(if vessel.seaway.is_some() { 0.0 } else { 0.5 * self.step_s })
        })
    }
}
