//! What a step reports of a panel.

use alloc::vec::Vec;

use crate::material::{BodyId, FenderId};
use crate::number::greater;
use crate::panel::Panel;
use crate::panel::chains::Broken;
use crate::panel::press::Pressed;

/// The motion of a panel that a hull presses in a step. Deflections and turn are those by the loading curves of its cones,
/// and the moment is that of the law, before the solve reduces a force.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelMotion {
    /// The fender with the panel.
    pub fender: FenderId,
    /// The body that presses it.
    pub hull: BodyId,
    /// Deflection of the panel's middle at the start of the step (m).
    pub deflection_m: f64,
    /// Turn about the vertical axis at the start of the step (rad), positive where the right end, seen by one who looks at
    /// the face, is deflected more.
    pub tilt_rad: f64,
    /// Moment of the cones' reactions about the panel's middle at the start of the step (N·m), positive where the right
    /// ones bear more.
    pub moment_nm: f64,
    /// The turn of the largest size within the step, with its sign (rad).
    pub peak_tilt_rad: f64,
    /// The moment of the largest size within the step, with its sign (N·m).
    pub peak_moment_nm: f64,
    /// Largest deflection of each cone within the step (m), in the order of [`Panel::cones_m`]; 0 beyond their number.
    pub peak_deflections_m: [f64; Panel::MOST_CONES],
    /// Smallest deflection of each cone within the step (m): negative where it was stretched.
    pub least_deflections_m: [f64; Panel::MOST_CONES],
    /// Largest tension of each chain within the step (N), in the order of [`Panel::tension_chains`]: that at which it parted
    /// if it has.
    pub peak_tensions_n: [f64; Panel::MOST_CHAINS],
    /// Which of the chains parted within the step.
    pub parted: [bool; Panel::MOST_CHAINS],
}

impl PanelMotion {
    /// Adds the panel as pressed in a sub-step, with its factors and the chains that parted then, to the list of a step.
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

/// Takes a value of larger size.
fn larger(peak: &mut f64, value: f64) {
    if value.abs() > peak.abs() {
        *peak = value;
    }
}
