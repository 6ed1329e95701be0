//! The table of the energy ledger.

use fenderline_sim::{Energy, LoadWork};

use super::{Column, Layout, Value, float};

/// A row of the table: the energy ledger at one time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EnergyRow {
    pub(crate) t_s: f64,
    pub(crate) energy: Energy,
}

/// The table `energy`.
pub(crate) fn energy_table() -> Layout<EnergyRow> {
    let first: Vec<Column<EnergyRow>> = vec![
        float(
            "t_s",
            "s",
            "time of the row: the start of the run, and the end of each interval",
            |r| r.t_s,
        ),
        float(
            "kinetic_j",
            "J",
            "kinetic energy of all bodies over the ground, added mass included",
            |r| r.energy.kinetic_j,
        ),
        float(
            "load_work_j",
            "J",
            "work of all loads other than contact since the start, in the ground frame: the sum of the next columns, up to `other_work_j`",
            |r| r.energy.load_work_j,
        ),
    ];
    let works = LoadWork::CAUSES.iter().enumerate().map(|(n, cause)| Column {
        name: cause.column,
        unit: "J",
        meaning: cause.meaning,
        value: Value::Nth(n, |r: &EnergyRow, n| (LoadWork::CAUSES[n].work_j)(&r.energy.loads)),
    });
    let rest: Vec<Column<EnergyRow>> = vec![
        float("stored_j", "J", "energy now stored in springs and stops of contacts", |r| {
            r.energy.stored_j
        }),
        float("shear_stored_j", "J", "energy now stored in shear springs of contacts", |r| {
            r.energy.shear_stored_j
        }),
        float("hysteresis_j", "J", "energy lost to hysteresis of fenders since the start", |r| {
            r.energy.hysteresis_j
        }),
        float("damping_j", "J", "energy lost to damping since the start", |r| r.energy.damping_j),
        float("restitution_j", "J", "energy lost to restitution since the start", |r| {
            r.energy.restitution_j
        }),
        float("friction_j", "J", "energy lost to friction since the start", |r| {
            r.energy.friction_j
        }),
        float(
            "contact_residual_j",
            "J",
            "numerical energy loss of contacts by the method or the time step; negative if energy \
             is gained",
            |r| r.energy.contact_residual_j,
        ),
        float(
            "residual_j",
            "J",
            "residual of the balance: kinetic energy less its value at the start and all works; rounding, and in contact the \
             integration error where surge and sway have different added mass",
            |r| r.energy.residual_j,
        ),
    ];
    Layout {
        name: "energy",
        rows: "the energy ledger: one row at the start, then one per interval",
        columns: first.into_iter().chain(works).chain(rest).collect(),
    }
}
