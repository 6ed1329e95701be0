//! The table of thrusters: one row a thruster, so that its columns are the same for any number of them.

use super::{Column, List, float, name};

/// One thruster of a vessel in one step.
pub(crate) struct ThrusterRow {
    pub(crate) t_s: f64,
    pub(crate) vessel: usize,
    /// Number among all vessels' thrusters.
    pub(crate) thruster: usize,
    pub(crate) order: f64,
    pub(crate) power: f64,
}

/// The columns of `thrusters`, in their order.
pub(crate) fn thrusters_columns() -> Vec<Column<ThrusterRow>> {
    vec![
        float("t_s", "s", "start of the step", |r| r.t_s),
        name("vessel", "name of the vessel's body", List::Vessels, |r| Some(r.vessel)),
        name("thruster", "name of the thruster", List::Thrusters, |r| Some(r.thruster)),
        float("order", "1", "thrust ordered, −1 (full to port) to 1 (full to starboard)", |r| {
            r.order
        }),
        float("power", "1", "thrust in the step, in the same measure", |r| r.power),
    ]
}
