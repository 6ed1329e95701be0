//! The table of azimuth units: one row a unit, so that its columns are the same for any number of them.

use fenderline_sim::{AzimuthOrder, AzimuthState};

use super::{Column, List, float, name};

/// One azimuth unit of a vessel in one step.
pub(crate) struct AzimuthRow {
    pub(crate) t_s: f64,
    pub(crate) vessel: usize,
    /// Number among all vessels' units.
    pub(crate) azimuth: usize,
    pub(crate) order: AzimuthOrder,
    pub(crate) now: AzimuthState,
}

/// The columns of `azimuths`, in their order.
pub(crate) fn azimuths_columns() -> Vec<Column<AzimuthRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        name("azimuth", "name of the azimuth unit", List::Azimuths, |r| Some(r.azimuth)),
        float("power_order", "1", "thrust ordered over that at rest and full power", |r| {
            r.order.power
        }),
        float(
            "power",
            "1",
            "what has come of it in the step; at speed there is less thrust for it",
            |r| r.now.power.value,
        ),
        float(
            "direction_order_rad",
            "rad",
            "direction ordered of the thrust from the bow, positive to starboard",
            |r| libm::remainder(r.order.direction_rad, core::f64::consts::TAU),
        ),
        float("direction_rad", "rad", "direction of the thrust in the step", |r| {
            r.now.direction.angle_rad
        }),
        float("force_x_n", "N", "force of the unit on the vessel: forward", |r| {
            r.now.force.surge_n
        }),
        float("force_y_n", "N", "force of the unit on the vessel: to starboard", |r| {
            r.now.force.sway_n
        }),
        float("moment_nm", "N·m", "moment of that force: about midship, to starboard", |r| {
            r.now.force.yaw_nm
        }),
    ]
}
