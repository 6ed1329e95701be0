//! The table of the energy ledger.

use fenderline_sim::Energy;

use super::{Column, float};

/// The ledger at one time.
pub(crate) struct EnergyRow {
    pub(crate) t_s: f64,
    pub(crate) energy: Energy,
}

/// The columns of `energy`, in their order.
pub(crate) fn energy_columns() -> Vec<Column<EnergyRow>> {
    vec![
        float("t_s", "s", "when the ledger stands so: the start, and the end of each step", |r| {
            r.t_s
        }),
        float("kinetic_j", "J", "kinetic energy of all bodies, added mass included", |r| {
            r.energy.kinetic_j
        }),
        float("load_work_j", "J", "work done by the external loads since the start", |r| {
            r.energy.load_work_j
        }),
        float("stored_j", "J", "stored now in springs and stops of contacts", |r| {
            r.energy.stored_j
        }),
        float("shear_stored_j", "J", "stored now in shear springs of contacts", |r| {
            r.energy.shear_stored_j
        }),
        float("hysteresis_j", "J", "lost in the rubber of fenders since the start", |r| {
            r.energy.hysteresis_j
        }),
        float("damping_j", "J", "lost to damping since the start", |r| r.energy.damping_j),
        float("restitution_j", "J", "lost to restitution since the start", |r| {
            r.energy.restitution_j
        }),
        float("friction_j", "J", "lost to friction since the start", |r| r.energy.friction_j),
        float(
            "contact_residual_j",
            "J",
            "stored and not given back for no reason but the method's or the time step's; negative: \
             energy that they made up",
            |r| r.energy.contact_residual_j,
        ),
        float(
            "residual_j",
            "J",
            "kinetic energy less that at the start and all works: rounding, and what a step makes of \
             momentum that turns with the body",
            |r| r.energy.residual_j,
        ),
    ]
}
