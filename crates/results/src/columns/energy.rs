//! The table of the energy ledger.

use fenderline_sim::Energy;

use super::{Column, Layout, float};

/// The ledger at one time.
#[derive(Clone, Copy, Debug)]
pub(crate) struct EnergyRow {
    pub(crate) t_s: f64,
    pub(crate) energy: Energy,
}

/// The table `energy`.
pub(crate) fn energy_table() -> Layout<EnergyRow> {
    let columns: Vec<Column<EnergyRow>> = vec![
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
            "work of all loads other than contact since the start, in the ground frame: the sum of the next fifteen columns",
            |r| r.energy.load_work_j,
        ),
        float(
            "hull_work_j",
            "J",
            "work of the water on the hulls of vessels, current included: drag and lift",
            |r| r.energy.loads.hull_j,
        ),
        float("propeller_work_j", "J", "work of propellers", |r| r.energy.loads.propeller_j),
        float("rudder_work_j", "J", "work of rudders", |r| r.energy.loads.rudder_j),
        float("thrusters_work_j", "J", "work of tunnel thrusters and azimuth units", |r| {
            r.energy.loads.thrusters_j
        }),
        float("wind_work_j", "J", "work of wind on vessels", |r| r.energy.loads.wind_j),
        float("waves_work_j", "J", "work of wave drift and excitation", |r| r.energy.loads.waves_j),
        float(
            "radiation_work_j",
            "J",
            "work of the radiation force, the reaction of the water to the motion of vessels with \
             hydrodynamic data",
            |r| r.energy.loads.radiation_j,
        ),
        float("banks_work_j", "J", "work of banks", |r| r.energy.loads.banks_j),
        float(
            "passing_work_j",
            "J",
            "work of the flow of passing ships and of other vessels",
            |r| r.energy.loads.passing_j,
        ),
        float("bottom_work_j", "J", "work of the seabed on vessels aground", |r| {
            r.energy.loads.bottom_j
        }),
        float(
            "current_work_j",
            "J",
            "work of an accelerating current, and on the added mass of a vessel that turns in a current; 0 in still water",
            |r| r.energy.loads.current_j,
        ),
        float("tugs_work_j", "J", "work of vector tugs", |r| r.energy.loads.tugs_j),
        float("lines_work_j", "J", "work of mooring and tow lines", |r| r.energy.loads.lines_j),
        float("anchors_work_j", "J", "work of the chains of anchors, windlasses included", |r| {
            r.energy.loads.anchors_j
        }),
        float(
            "piles_work_j",
            "J",
            "work of the piles of flexible dolphins on the bodies: minus the energy that they \
             store, and minus their losses",
            |r| r.energy.loads.piles_j,
        ),
        float("other_work_j", "J", "work of the scenario's loads and of force providers", |r| {
            r.energy.loads.other_j
        }),
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
            "numerical energy loss of contacts by the method or the time step; negative: \
             energy gain",
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
        columns,
    }
}
