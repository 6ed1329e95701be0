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
        float(
            "kinetic_j",
            "J",
            "kinetic energy of all bodies over the ground, added mass included",
            |r| r.energy.kinetic_j,
        ),
        float(
            "load_work_j",
            "J",
            "work over the ground since the start by all that is no contact: the sum of the next twelve",
            |r| r.energy.load_work_j,
        ),
        float(
            "hull_work_j",
            "J",
            "of the water on vessels' hulls, current within: drag and lift",
            |r| r.energy.loads.hull_j,
        ),
        float("propeller_work_j", "J", "of propellers", |r| r.energy.loads.propeller_j),
        float("rudder_work_j", "J", "of rudders", |r| r.energy.loads.rudder_j),
        float("thrusters_work_j", "J", "of tunnel thrusters and azimuth units", |r| {
            r.energy.loads.thrusters_j
        }),
        float("wind_work_j", "J", "of wind on vessels", |r| r.energy.loads.wind_j),
        float("waves_work_j", "J", "of mean wave drift", |r| r.energy.loads.waves_j),
        float("banks_work_j", "J", "of banks", |r| r.energy.loads.banks_j),
        float("bottom_work_j", "J", "of the bottom on vessels aground", |r| {
            r.energy.loads.bottom_j
        }),
        float(
            "current_work_j",
            "J",
            "of a current that speeds up, and on the water that goes with a vessel as she turns in it; none in still water",
            |r| r.energy.loads.current_j,
        ),
        float("tugs_work_j", "J", "of vector tugs", |r| r.energy.loads.tugs_j),
        float("lines_work_j", "J", "of mooring and tow lines", |r| r.energy.loads.lines_j),
        float("other_work_j", "J", "of the scenario's loads and other programs", |r| {
            r.energy.loads.other_j
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
            "kinetic energy less that at the start and all works: rounding, and in contact what a step makes of \
             momentum that turns with the body",
            |r| r.energy.residual_j,
        ),
    ]
}
