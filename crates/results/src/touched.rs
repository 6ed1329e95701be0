//! The state of touched fenders in one time step.

use std::collections::BTreeMap;

use fenderline_contact::number::greater;
use fenderline_contact::{Contact, ForceParts};

/// One touched fender in one step; the contacts of all hulls and patches on it are added up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TouchedFender {
    /// Deflection at the start of the step (m).
    pub deflection_m: f64,
    /// Largest deflection within the step (m).
    pub peak_deflection_m: f64,
    /// Mean reaction along the fender's axis over the step (N).
    pub reaction_n: f64,
    /// Largest reaction along the fender's axis within the step (N).
    pub peak_reaction_n: f64,
    /// Energy stored in spring and stop at the start of the step (J).
    pub stored_j: f64,
    /// Components of the mean normal force (spring, stop, damper), taken along the direction of that force.
    pub parts: ForceParts,
}

/// The touched fenders of a step, by their index in the set-up.
#[must_use]
pub fn touched(contacts: &[Contact]) -> BTreeMap<usize, TouchedFender> {
    let mut fenders: BTreeMap<usize, TouchedFender> = BTreeMap::new();
    for contact in contacts {
        let Some(id) = contact.fender else { continue };
        let fender = fenders.entry(id.0 as usize).or_default();
        fender.deflection_m = greater(fender.deflection_m, contact.depth_m);
        fender.peak_deflection_m = greater(fender.peak_deflection_m, contact.peak_depth_m);
        // As in the simulation's summary: the component along the fender's axis.
        let along_axis = libm::cos(contact.tilt_rad);
        fender.reaction_n += contact.normal_force_n * along_axis;
        fender.peak_reaction_n += contact.peak_normal_force_n * along_axis;
        fender.stored_j += contact.energy.stored_j;
        add_parts(&mut fender.parts, &contact.parts);
    }
    fenders
}

/// Adds the components of the force of another contact.
pub fn add_parts(sum: &mut ForceParts, parts: &ForceParts) {
    sum.spring_n += parts.spring_n;
    sum.stop_n += parts.stop_n;
    sum.damper_n += parts.damper_n;
    sum.limiter_n += parts.limiter_n;
}
