//! The lift of a drifting hull, and how the hull loses it as she drifts more.
//!
//! A slender hull in deep water is a wing of an aspect ratio of 0.1: its lift does not break down before half a right angle, and the
//! form of Yoshimura et al., Y_v v|u|, has it at all angles. Near the bottom she is a wing between walls, of an effective aspect ratio
//! above 1. Y_v and N_v are then seven or eight times as large, and such a wing stalls at 15 to 20°. So what the bottom adds is lost from there on.
//! In a flow that is quite separated no hull keeps more lift than 0.8 of her cross-flow drag (ours): at most, side force is then 1.15
//! times that abeam. Of the library only a tug, with 1.0 in deep water, would have more.
//!
//! The only curve over all angles that could be read is OCIMF's for a loaded tanker in 1.1 draughts of water (`validation/current.toml`). Its side
//! force, less the cross-flow drag C_D sin²β, is 1.08 C_D sin β cos β at 10° and 20°, 0.29 of C_D sin β cos β at 40° and 0.13 at 60°, which is what
//! there is in deep water. Over the stern it is the same. The moment, less the shift by 0.02 L that a fuller stern makes, falls to half of
//! N_v sin β cos β and no further: bow and stern are still pushed apart as by a flow that is not separated (Munk). The angles and this half are read from
//! the curve; they hold at all depths, as there is no other.

use fenderline_contact::number::lesser;

use super::low_speed::LowSpeedHull;
use super::quantities::{Velocity, smooth_step};

/// |u|/U from which on the flow is attached, 20°, and up to which it is separated, 46°.
const ATTACHED: f64 = 0.94;
const SEPARATED: f64 = 0.70;
/// Share of the moment due to the bottom that is left in separated flow.
const MOMENT_LEFT: f64 = 0.5;
/// Most lift in separated flow, Y'v over the drag coefficient in the same depth.
const MOST_LIFT: f64 = 0.8;

/// What a hull loses of her lift in separated flow.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stall {
    /// Draught over depth, 0 in deep water.
    pub draught_over_depth: f64,
    /// Share of Y'v that is lost.
    pub sway_v: f64,
    /// Share of N'v that is lost.
    pub yaw_v: f64,
}

impl Stall {
    /// From the forms in deep water and in the depth in question.
    pub(super) fn of(deep: &LowSpeedHull, there: &LowSpeedHull, draught_over_depth: f64) -> Stall {
        let most = MOST_LIFT * there.cross_flow.drag_coefficient;
        let kept = lesser(deep.sway_v.abs(), most);
        Stall {
            draught_over_depth,
            sway_v: lost(kept, there.sway_v),
            yaw_v: (1.0 - MOMENT_LEFT) * lost(deep.yaw_v.abs(), there.yaw_v),
        }
    }

    /// The low-speed form for a direction of motion: without the lift that is lost.
    pub(super) fn after(&self, attached: &LowSpeedHull, velocity: &Velocity) -> LowSpeedHull {
        let separated = separated(velocity);
        LowSpeedHull {
            sway_v: attached.sway_v * (1.0 - separated * self.sway_v),
            yaw_v: attached.yaw_v * (1.0 - separated * self.yaw_v),
            ..*attached
        }
    }
}

/// The share of a term that is more than what is kept of it.
fn lost(kept: f64, term: f64) -> f64 {
    if term.abs() > kept { 1.0 - kept / term.abs() } else { 0.0 }
}

/// How far the flow is separated, 0 to 1: by the drift angle, ahead and astern alike.
fn separated(velocity: &Velocity) -> f64 {
    let speed_mps = velocity.speed_mps();
    if speed_mps == 0.0 {
        return 1.0;
    }
    smooth_step((ATTACHED - velocity.surge_mps.abs() / speed_mps) / (ATTACHED - SEPARATED))
}
