//! Work and energy of a contact, work of the loads, and the energy ledger.

/// Work and energy of one contact in one step: a fender and a hull, or two outlines. The numbers include the stages of
/// the integrator and the sub-steps of the engine.
///
/// The energy that the normal force of a contact takes from the bodies is stored, or lost in one of three ways:
/// `height_j - normal_j = Δstored + hysteresis_j + damping_j + restitution_j`. The energy that the tangential force of
/// a contact takes from the bodies is stored or lost: `-tangential_j = Δshear_stored + friction_j`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactEnergy {
    /// Indices of the two bodies in the set-up, the smaller index first.
    pub bodies: [usize; 2],
    /// Index of the fender in the set-up; `None` for a contact between outlines.
    pub fender: Option<usize>,
    /// Impulse ∫ N dt of the contact's normal force (N·s).
    pub normal_impulse_ns: f64,
    /// Work of the normal force on the two bodies (J), negative if the force takes energy from them.
    pub normal_j: f64,
    /// Work of the tangential force on the two bodies (J).
    pub tangential_j: f64,
    /// Energy that tide, heave, roll and pitch put into the fender (J), because they change the outline of the hull
    /// that the fender meets. The energy is negative if tide, heave, roll and pitch take energy out of the fender.
    pub height_j: f64,
    /// Work of both forces on the two bodies since the contact began, less [`ContactEnergy::height_j`] (J). The work is
    /// positive if the contact returned more energy than it absorbed. The work is −∞ for a contact that exists at the
    /// start of the run, because the stored energy of this contact is not known.
    pub since_began_j: f64,
    /// Recoverable energy stored in spring and stop at the end of the step (J).
    pub stored_j: f64,
    /// Energy stored in the shear spring at the end of the step (J).
    pub shear_stored_j: f64,
    /// Hysteresis loss of a fender's unloading law (J).
    pub hysteresis_j: f64,
    /// Damping loss of the contact (J).
    pub damping_j: f64,
    /// Restitution loss: energy that the springs released but that the bodies did not get, because the contact force
    /// was limited (J).
    pub restitution_j: f64,
    /// Friction loss, and the numerical damping of the implicit shear spring (J).
    pub friction_j: f64,
    /// Accumulated stored energy that does not agree with the spring (J). For a fender the residual energy is the
    /// difference from the spring's potential at each step; for any contact it also includes the energy that is left
    /// when the contact ends. For fenders the residual energy is a discretisation error, which decreases with the time
    /// step. Between outlines the residual energy also contains the energy that is created (negative) or lost as the
    /// normal of the overlap's chord turns, because the force law between outlines has no potential.
    pub residual_j: f64,
}

/// Declares [`LoadWork`] and the catalogue of its causes. Tables, report, summary and Python take the causes of work
/// from this catalogue.
macro_rules! load_works {
    ($($(#[$doc:meta])* $field:ident: $name:literal, $label:literal, $meaning:literal;)*) => {
        /// Work of the loads on the bodies, by cause (J): force times displacement over the ground, positive if the
        /// load accelerates the body. A hull that drifts with a current gains energy from the current.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct LoadWork {
            $($(#[$doc])* pub $field: f64,)*
        }

        impl LoadWork {
            /// The causes of work, in the order in which tables list them.
            pub const CAUSES: &'static [WorkCause] = &[$(WorkCause {
                name: $name,
                column: concat!($name, "_work_j"),
                label: $label,
                meaning: $meaning,
                work_j: |works| works.$field,
            },)*];

            /// Adds the work of each cause in a step.
            pub fn add(&mut self, step: &LoadWork) {
                $(self.$field += step.$field;)*
            }
        }
    };
}

/// A cause of [`LoadWork`].
#[derive(Clone, Copy, Debug)]
pub struct WorkCause {
    /// Name of the cause in summaries.
    pub name: &'static str,
    /// Name of the cause's column in the table of the energy ledger.
    pub column: &'static str,
    /// Words for the cause in the report.
    pub label: &'static str,
    /// Meaning of the cause's column.
    pub meaning: &'static str,
    /// Takes the work of this cause from a [`LoadWork`] (J).
    pub work_j: fn(&LoadWork) -> f64,
}

load_works! {
    /// Work of drag and lift of the vessels' hulls, current included. The Coriolis part of the hull force in
    /// [`crate::world::VesselForces`] is not included, because it does no work.
    hull_j: "hull", "water on hulls",
        "work of the water on the hulls of vessels, current included: drag and lift";
    /// Work of propellers.
    propeller_j: "propeller", "propellers",
        "work of propellers";
    /// Work of rudders.
    rudder_j: "rudder", "rudders",
        "work of rudders";
    /// Work of tunnel thrusters and azimuth units.
    thrusters_j: "thrusters", "thrusters and azimuth units",
        "work of tunnel thrusters and azimuth units";
    /// Work of the wind on the vessels.
    wind_j: "wind", "wind",
        "work of wind on vessels";
    /// Work of the waves: mean and slow drift, and excitation of vessels with hydrodynamic data.
    waves_j: "waves", "waves (drift and excitation)",
        "work of wave drift and excitation";
    /// Work of the reaction of the water to the motion of vessels with hydrodynamic data, and of the coupling of this
    /// motion with heave, roll and pitch.
    radiation_j: "radiation", "water set in motion by vessels in waves (radiation)",
        "work of the radiation force, the reaction of the water to the motion of vessels with \
         hydrodynamic data";
    /// Work of banks.
    banks_j: "banks", "banks",
        "work of banks";
    /// Work of the flow of passing ships and of other vessels.
    passing_j: "passing", "passing ships",
        "work of the flow of passing ships and of other vessels";
    /// Work of the bottom on vessels that are aground.
    bottom_j: "bottom", "seabed",
        "work of the seabed on vessels aground";
    /// Work of a current beyond its part in the hull force. An accelerating current accelerates the vessel, and the
    /// energy of the added mass in the current changes with the vessel's heading. The work of the current is zero in
    /// still water.
    current_j: "current", "accelerating current, and current past a turning ship",
        "work of an accelerating current, and on the added mass of a vessel that turns in a \
         current; 0 in still water";
    /// Work of vector tugs.
    tugs_j: "tugs", "vector tugs",
        "work of vector tugs";
    /// Work of mooring and tow lines, winches included.
    lines_j: "lines", "lines",
        "work of mooring and tow lines";
    /// Work of the chains of anchors, windlasses included.
    anchors_j: "anchors", "chains of anchors",
        "work of the chains of anchors, windlasses included";
    /// Work of the piles of flexible dolphins on the bodies: minus the energy that the piles store, and minus the
    /// losses of the piles.
    piles_j: "piles", "piles of dolphins",
        "work of the piles of flexible dolphins on the bodies: minus the energy that the piles store, and minus \
         the losses of the piles";
    /// Work of the loads of the set-up, and of external forces.
    other_j: "other", "external loads",
        "work of the scenario's loads and of force providers";
}

impl LoadWork {
    /// The work of each cause, with the name of the cause in summaries.
    pub fn parts(&self) -> impl Iterator<Item = (&'static str, f64)> {
        LoadWork::CAUSES.iter().map(|cause| (cause.name, (cause.work_j)(self)))
    }

    /// The sum of the work of all causes (J).
    #[must_use]
    pub fn total_j(&self) -> f64 {
        self.parts().map(|(_, work_j)| work_j).sum()
    }
}

/// The energy ledger since the start of the run (J). Velocities and displacements in the ledger are over the ground, so
/// that the kinetic energy is the energy that a fender on a quay has to absorb.
///
/// Work in the ledger is force times mean velocity times Δt, and gives the change of kinetic energy exactly:
///
/// kinetic = kinetic at the start + load_work + normal_work + tangential_work + residual, and
/// height_work − (normal_work + tangential_work) = stored + shear_stored + hysteresis + damping + restitution +
/// friction + contact_residual.
///
/// A contact that returns more energy than it absorbed has positive `normal_work_j` and negative `contact_residual_j`;
/// the method or the time step created this energy.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Present kinetic energy of the bodies, added mass included (J).
    pub kinetic_j: f64,
    /// Work of everything but contact, which is the sum of [`Energy::loads`] (J).
    pub load_work_j: f64,
    /// Work of everything but contact, by cause (J).
    pub loads: LoadWork,
    /// Work of normal contact forces on the bodies (J).
    pub normal_work_j: f64,
    /// Work of tangential contact forces on the bodies (J).
    pub tangential_work_j: f64,
    /// Energy that changes of height put into fenders: tide, heave, roll and pitch change the height at which a fender
    /// meets a hull. The motion in the plane gives the rest of the energy in fenders. The energy from changes of height
    /// is zero if all hulls have one outline.
    pub height_work_j: f64,
    /// Energy now stored in the springs and stops of contacts (J).
    pub stored_j: f64,
    /// Energy now stored in the shear springs of contacts (J).
    pub shear_stored_j: f64,
    /// Energy lost to hysteresis of fenders (J).
    pub hysteresis_j: f64,
    /// Energy lost to damping of contacts (J).
    pub damping_j: f64,
    /// Energy lost by restitution of contacts (J).
    pub restitution_j: f64,
    /// Energy lost to friction of contacts (J).
    pub friction_j: f64,
    /// Energy now stored in the bending of dolphins' piles. Apart from rounding, `loads.piles_j` is −(`pile_stored_j` +
    /// `pile_damping_j` + `pile_yield_j`).
    pub pile_stored_j: f64,
    /// Energy lost to damping of dolphins' piles (J).
    pub pile_damping_j: f64,
    /// Energy lost to yielding of dolphins' piles (J).
    pub pile_yield_j: f64,
    /// Sum of the residual energies of all contacts (J); see [`ContactEnergy::residual_j`].
    pub contact_residual_j: f64,
    /// Energy that contacts absorbed: the sum over all steps and contacts in which the bodies lost energy (J).
    pub contact_taken_j: f64,
    /// Energy that contacts returned to the bodies beyond the energy that they had absorbed since each contact began
    /// (J). Contacts that exist at the start of the run do not count in the returned energy, because they may have had
    /// energy stored.
    pub contact_gained_j: f64,
    /// Residual of the ledger: change of kinetic energy, less all work (J). For bodies with equal mass in surge and
    /// sway, and for vessels without contact, the residual is rounding error. Otherwise the residual also contains the
    /// error of the Coriolis terms over a step, which decreases with Δt.
    pub residual_j: f64,
}

impl Energy {
    /// Total energy exchanged (J): the sum of the absolute values of all works. [`Energy::residual_j`] should be small
    /// compared with the exchanged energy.
    #[must_use]
    pub fn exchanged_j(&self) -> f64 {
        let loads_j: f64 = self.loads.parts().map(|(_, work_j)| work_j.abs()).sum();
        loads_j + self.normal_work_j.abs() + self.tangential_work_j.abs() + self.height_work_j.abs()
    }
}
