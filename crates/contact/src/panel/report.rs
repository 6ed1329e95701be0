//! The report of a step on the motion of a fender panel.

use alloc::vec::Vec;

use crate::maths::number::greater;
use crate::model::material::{BodyId, FenderId};
use crate::panel::Panel;
use crate::panel::chains::Broken;
use crate::panel::press::Pressed;

/// The motion in a step of a panel on which a hull presses. Deflections and turn of the panel follow from the loading
/// curves of the cones. The reported moment is the moment that the law gives, before the solve reduces a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelMotion {
    /// The fender that has the panel.
    pub fender: FenderId,
    /// The body that presses on the panel.
    pub hull: BodyId,
    /// Deflection of the panel's middle at the start of the step (m).
    pub deflection_m: f64,
    /// Turn of the panel about the vertical axis at the start of the step (rad). The turn is positive if the right end
    /// is deflected more, as seen by a viewer who faces the panel.
    pub tilt_rad: f64,
    /// Moment of the cones' reactions about the panel's middle at the start of the step (N·m). The moment is positive
    /// if the cones on the right bear more.
    pub moment_nm: f64,
    /// The turn of the panel that is largest in size within the step, with its sign (rad).
    pub peak_tilt_rad: f64,
    /// The moment of the cones that is largest in size within the step, with its sign (N·m).
    pub peak_moment_nm: f64,
    /// Largest deflection of each cone within the step (m), in the order of [`Panel::cones_m`]; 0 beyond the number of
    /// cones.
    pub peak_deflections_m: [f64; Panel::MOST_CONES],
    /// Smallest deflection of each cone within the step (m): negative if the cone was stretched.
    pub least_deflections_m: [f64; Panel::MOST_CONES],
    /// Largest tension of each chain within the step (N), in the order of [`Panel::tension_chains`]. For a chain that
    /// parted in the step, this is the tension at which the chain parted.
    pub peak_tensions_n: [f64; Panel::MOST_CHAINS],
    /// Tells for each chain whether it parted within the step.
    pub parted: [bool; Panel::MOST_CHAINS],
}

impl PanelMotion {
    /// Adds a panel to the list of a step as it was pressed in a sub-step, with the factors of the panel and the chains
    /// that parted in the sub-step.
    #[inline(never)]
    pub(crate) fn note(
        list: &mut Vec<PanelMotion>,
        (fender, hull): (FenderId, BodyId),
        pressed: &Pressed,
        factor: f64,
        broken: &Broken,
    ) {
        let tension_n = |chain: usize| greater(pressed.tensions_n[chain], broken.tensions_n[chain]);
        let has_parted = |chain: usize| broken.chains & (1 << chain) != 0;
        let moment_nm = pressed.moment_nm * factor;
        let known = list.iter_mut().find(|m| m.fender == fender && m.hull == hull);
        let Some(motion) = known else {
            list.push(PanelMotion {
                fender,
                hull,
                deflection_m: pressed.middle_m,
                tilt_rad: pressed.tilt,
                moment_nm,
                peak_tilt_rad: pressed.tilt,
                peak_moment_nm: moment_nm,
                peak_deflections_m: pressed.deflections_m.map(|m| greater(m, 0.0)),
                least_deflections_m: pressed.deflections_m.map(|m| -greater(-m, 0.0)),
                peak_tensions_n: core::array::from_fn(tension_n),
                parted: core::array::from_fn(has_parted),
            });
            return;
        };
        larger(&mut motion.peak_tilt_rad, pressed.tilt);
        larger(&mut motion.peak_moment_nm, moment_nm);
        let ends = motion.peak_deflections_m.iter_mut().zip(&mut motion.least_deflections_m);
        for ((most_m, least_m), &now_m) in ends.zip(&pressed.deflections_m) {
            *most_m = greater(*most_m, now_m);
            *least_m = -greater(-*least_m, -now_m);
        }
        for chain in 0..Panel::MOST_CHAINS {
            let peak_n = &mut motion.peak_tensions_n[chain];
            *peak_n = greater(*peak_n, tension_n(chain));
            motion.parted[chain] |= has_parted(chain);
        }
    }
}

/// Replaces the peak by the value if the value is larger in size.
fn larger(peak: &mut f64, value: f64) {
    if value.abs() > peak.abs() {
        *peak = value;
    }
}
