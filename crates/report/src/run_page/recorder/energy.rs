//! Records the energy ledger over time.

use fenderline_sim::Energy;

use crate::plot::Decimator;

/// Each part of the energy ledger over time (J).
#[derive(Clone, Debug, Default)]
pub(in crate::run_page) struct EnergyTrace {
    pub(in crate::run_page) kinetic_j: Decimator,
    pub(in crate::run_page) load_work_j: Decimator,
    /// Energy stored in springs and stops, and in shear springs.
    pub(in crate::run_page) stored_j: Decimator,
    pub(in crate::run_page) hysteresis_j: Decimator,
    pub(in crate::run_page) damping_j: Decimator,
    pub(in crate::run_page) restitution_j: Decimator,
    pub(in crate::run_page) friction_j: Decimator,
    /// Energy that is lost without a known cause: the numerical loss of contacts less the residual of the motion.
    pub(in crate::run_page) residual_j: Decimator,
    /// Work of normal and of tangential forces on the bodies.
    pub(in crate::run_page) normal_work_j: Decimator,
    pub(in crate::run_page) tangential_work_j: Decimator,
    /// Residual of the balance of kinetic energy and works.
    pub(in crate::run_page) motion_residual_j: Decimator,
}

impl EnergyTrace {
    pub(super) fn push(&mut self, t_s: f64, energy: &Energy) {
        self.kinetic_j.push(t_s, energy.kinetic_j);
        self.load_work_j.push(t_s, energy.load_work_j);
        self.stored_j.push(t_s, energy.stored_j + energy.shear_stored_j);
        self.hysteresis_j.push(t_s, energy.hysteresis_j);
        self.damping_j.push(t_s, energy.damping_j);
        self.restitution_j.push(t_s, energy.restitution_j);
        self.friction_j.push(t_s, energy.friction_j);
        self.residual_j.push(t_s, unexplained_j(energy));
        self.normal_work_j.push(t_s, energy.normal_work_j);
        self.tangential_work_j.push(t_s, energy.tangential_work_j);
        self.motion_residual_j.push(t_s, energy.residual_j);
    }
}

/// Energy that is lost without a known cause (J); negative if energy was gained.
///
/// The balance is: kinetic at the start + work of the loads = kinetic + stored + damping + restitution + friction +
/// unexplained.
fn unexplained_j(energy: &Energy) -> f64 {
    energy.contact_residual_j - energy.residual_j
}
