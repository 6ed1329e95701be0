//! The table of azimuth units: one row per unit, so that the columns do not depend on the number of units.

use fenderline_sim::{AzimuthOrder, AzimuthState};

use super::{Column, Layout, List, float, name};
use crate::row::Row;

/// A row of the table: one azimuth unit of a vessel in one output interval.
pub(crate) struct AzimuthRow {
    pub(crate) t_s: f64,
    pub(crate) vessel: usize,
    /// Index of the unit among the azimuth units of all vessels.
    pub(crate) azimuth: usize,
    pub(crate) order: AzimuthOrder,
    pub(crate) now: AzimuthState,
}

impl Row for AzimuthRow {
    type Key = usize;

    fn key(&self) -> usize {
        self.azimuth
    }

    fn join(&mut self, later: AzimuthRow) {
        self.now.force = self.now.force + later.now.force;
    }

    fn close(&mut self, _own: f64, all: f64) {
        self.now.force = self.now.force * (1.0 / all);
    }
}

/// The table `azimuths`.
pub(crate) fn azimuths_table() -> Layout<AzimuthRow> {
    let columns: Vec<Column<AzimuthRow>> = vec![
        float("t_s", "s", "start of the interval", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        name("azimuth", "name of the azimuth unit", List::Azimuths, |r| Some(r.azimuth)),
        float(
            "power_order",
            "1",
            "ordered thrust divided by the bollard thrust at full power",
            |r| r.order.power,
        ),
        float(
            "power",
            "1",
            "power, given as thrust at zero speed divided by the bollard thrust at full power; at \
            speed the thrust is less",
            |r| r.now.power.value,
        ),
        float(
            "direction_order_rad",
            "rad",
            "ordered direction of the thrust from the bow, positive to starboard",
            |r| libm::remainder(r.order.direction_rad, core::f64::consts::TAU),
        ),
        float(
            "direction_rad",
            "rad",
            "direction of the thrust from the bow, positive to starboard",
            |r| r.now.direction.angle_rad,
        ),
    ];
    let force =
        force_columns!(AzimuthRow, "", "the unit on the vessel, mean of the interval", now.force);
    let columns = columns.into_iter().chain(force).collect();
    Layout {
        name: "azimuths",
        rows: "one row per azimuth unit and interval, with its state at the start",
        columns,
    }
}
