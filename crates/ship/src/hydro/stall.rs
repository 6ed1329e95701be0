//! The lift of a drifting hull, and the loss of lift as the drift increases.
//!
//! In deep water the hull of a ship acts like a wing with an aspect ratio of 0.1. The lift of a slender hull in deep
//! water does not break down below half a right angle, and the form of Yoshimura et al., Y_v v|u|, has this lift at all
//! angles. In shallow water, near the bottom, the hull is a wing between walls, with an effective aspect ratio above 1.
//! Near the bottom, Y_v and N_v are seven or eight times as large as in deep water, and a wing of such an aspect ratio
//! stalls at 15 to 20°. Beyond its angle of stall a hull therefore loses the lift that the bottom adds. In a fully
//! separated flow no hull keeps more lift than 0.8 of its cross-flow drag (our choice): the side force is then at most
//! 1.15 times that of a flow abeam. Of the vessels in the library only a tug would have more lift than this limit: 1.0
//! of her cross-flow drag in deep water.
//!
//! Only one source with the side force and the moment over all drift angles could be read: OCIMF's curves for a loaded
//! tanker in 1.1 draughts of water (`validation/current.toml`). From the side force of OCIMF's curves the cross-flow
//! drag C_D sin²β is subtracted. What is left of OCIMF's side force is 1.08 C_D sin β cos β at 10° and 20°, 0.29 of C_D
//! sin β cos β at 40° and 0.13 of C_D sin β cos β at 60°; the last is the value of deep water. In a flow over the stern
//! OCIMF's side force is the same as in a flow over the bow. A fuller stern shifts the moment of OCIMF's curve by 0.02
//! L. Without this shift the moment falls to half of N_v sin β cos β and no further: bow and stern are still pushed
//! apart, as by a flow that is not separated (Munk). The angles of attached and separated flow, and the half of the
//! moment that is left, are read from OCIMF's curve. The two angles and the half of the moment are used at all depths,
//! because there is no other curve.

use fenderline_contact::number::lesser;

use super::low_speed::LowSpeedHull;
use super::quantities::{Velocity, smooth_step};

/// Value of |u|/U from which on the flow is attached, which is a drift angle of 20° or less. Up to the value
/// [`SEPARATED`] of |u|/U, which is a drift angle of 46° or more, the flow is separated.
const ATTACHED: f64 = 0.94;
const SEPARATED: f64 = 0.70;
/// Share of the yaw moment due to the bottom that is left in separated flow.
const MOMENT_LEFT: f64 = 0.5;
/// Largest lift in separated flow: Y'v divided by the drag coefficient at the same depth.
const MOST_LIFT: f64 = 0.8;

/// The part of its lift that a hull loses when the flow is separated.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stall {
    /// Draught divided by depth, 0 in deep water.
    pub draught_over_depth: f64,
    /// Share of the derivative Y'v that is lost in separated flow.
    pub sway_v: f64,
    /// Share of the derivative N'v that is lost in separated flow.
    pub yaw_v: f64,
}

impl Stall {
    /// Finds the loss of lift from the low-speed forms in deep water and at the actual depth.
    pub(super) fn of(deep: &LowSpeedHull, there: &LowSpeedHull, draught_over_depth: f64) -> Stall {
        let most = MOST_LIFT * there.cross_flow.drag_coefficient;
        let kept = lesser(deep.sway_v.abs(), most);
        Stall {
            draught_over_depth,
            sway_v: lost(kept, there.sway_v),
            yaw_v: (1.0 - MOMENT_LEFT) * lost(deep.yaw_v.abs(), there.yaw_v),
        }
    }

    /// The low-speed form of the hull for a direction of motion, without the lost lift.
    pub(super) fn after(&self, attached: &LowSpeedHull, velocity: &Velocity) -> LowSpeedHull {
        let separated = separated(velocity);
        LowSpeedHull {
            sway_v: attached.sway_v * (1.0 - separated * self.sway_v),
            yaw_v: attached.yaw_v * (1.0 - separated * self.yaw_v),
            ..*attached
        }
    }
}

/// The share of a derivative `term` that is lost if only the size `kept` of the derivative remains.
fn lost(kept: f64, term: f64) -> f64 {
    if term.abs() > kept { 1.0 - kept / term.abs() } else { 0.0 }
}

/// How far the flow about the hull is separated, 0 to 1. The separation of the flow depends on the drift angle, in the
/// same way ahead and astern.
fn separated(velocity: &Velocity) -> f64 {
    let speed_mps = velocity.speed_mps();
    if speed_mps == 0.0 {
        return 1.0;
    }
    smooth_step((ATTACHED - velocity.surge_mps.abs() / speed_mps) / (ATTACHED - SEPARATED))
}
