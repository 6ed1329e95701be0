//! Work and energy of a contact, work of the loads, and the energy ledger.

/// Work and energy of one contact in one step: a fender and a hull, or two outlines. Integrator stages and sub-steps of
/// the engine are included.
///
/// The energy that the normal force takes from the bodies is stored, or lost in one of three ways: `height_j - normal_j
/// = Δstored + hysteresis_j + damping_j + restitution_j`. The energy that the tangential force takes is stored or lost:
/// `-tangential_j = Δshear_stored + friction_j`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ContactEnergy {
    /// Indices of the bodies in the set-up, the smaller first.
    pub bodies: [usize; 2],
    /// Index of the fender in the set-up; `None` for a contact between outlines.
    pub fender: Option<usize>,
    /// Normal impulse ∫ N dt (N·s).
    pub normal_impulse_ns: f64,
    /// Work of the normal force on the two bodies (J), negative if the force takes energy from them.
    pub normal_j: f64,
    /// Work of the tangential force on the two bodies (J).
    pub tangential_j: f64,
    /// Energy that tide, heave, roll and pitch put into the fender (J), because they change the outline of the hull
    /// that the fender meets. Negative if these motions take energy out.
    pub height_j: f64,
    /// Work of both forces on the two bodies since the contact began, less [`ContactEnergy::height_j`] (J). Positive if
    /// the contact returned more energy than it absorbed. −∞ for a contact that exists at the start of the run, because
    /// its stored energy is not known.
    pub since_began_j: f64,
    /// Recoverable energy stored in spring and stop at the end of the step (J).
    pub stored_j: f64,
    /// Energy stored in the shear spring at the end of the step (J).
    pub shear_stored_j: f64,
    /// Hysteresis loss of a fender's unloading law (J).
    pub hysteresis_j: f64,
    /// Damping loss (J).
    pub damping_j: f64,
    /// Restitution loss: energy that the springs released and the limiter withheld from the bodies (J).
    pub restitution_j: f64,
    /// Friction loss, and the numerical damping of the implicit shear spring (J).
    pub friction_j: f64,
    /// Accumulated stored energy that does not agree with the spring (J). For a fender this energy is the difference
    /// from the spring's potential at each step; for any contact it also includes what is left when the contact ends.
    /// For fenders this energy is a discretisation error, which decreases with the time step. Between outlines this
    /// energy also contains the energy that the rotation of the chord normal creates (negative) or loses, because that
    /// force law has no potential.
    pub residual_j: f64,
}

/// Declares [`LoadWork`] and its catalogue. Tables, report, summary and Python take the works from the catalogue.
macro_rules! load_works {
    ($($(#[$doc:meta])* $field:ident: $name:literal, $label:literal, $meaning:literal;)*) => {
        /// Work of the loads on the bodies, by cause (J): force times displacement over the ground, positive if the load
        /// accelerates the body. A hull that drifts with a current gains energy from the current.
        #[derive(Clone, Copy, Debug, Default, PartialEq)]
        pub struct LoadWork {
            $($(#[$doc])* pub $field: f64,)*
        }

        impl LoadWork {
            /// The causes, in the order of tables.
            pub const CAUSES: &'static [WorkCause] = &[$(WorkCause {
                name: $name,
                column: concat!($name, "_work_j"),
                label: $label,
                meaning: $meaning,
                work_j: |works| works.$field,
            },)*];

            /// Adds the works of a step.
            pub fn add(&mut self, step: &LoadWork) {
                $(self.$field += step.$field;)*
            }
        }
    };
}

/// A cause of [`LoadWork`].
#[derive(Clone, Copy, Debug)]
pub struct WorkCause {
    /// Name in summaries.
    pub name: &'static str,
    /// Name of the column in the table of the energy ledger.
    pub column: &'static str,
    /// Words for the cause in the report.
    pub label: &'static str,
    /// Meaning of the column.
    pub meaning: &'static str,
    /// Takes the work (J).
    pub work_j: fn(&LoadWork) -> f64,
}

load_works! {
    /// Drag and lift of the vessels' hulls, current included. The Coriolis part of the hull force in
    /// [`crate::world::VesselForces`] is not included, because it does no work.
    hull_j: "hull", "water on hulls",
        "work of the water on the hulls of vessels, current included: drag and lift";
    /// Propellers.
    propeller_j: "propeller", "propellers",
        "work of propellers";
    /// Rudders.
    rudder_j: "rudder", "rudders",
        "work of rudders";
    /// Tunnel thrusters and azimuth units.
    thrusters_j: "thrusters", "thrusters and azimuth units",
        "work of tunnel thrusters and azimuth units";
    /// Wind on the vessels.
    wind_j: "wind", "wind",
        "work of wind on vessels";
    /// Waves: mean and slow drift, and excitation of vessels with hydrodynamic data.
    waves_j: "waves", "waves (drift and excitation)",
        "work of wave drift and excitation";
    /// Reaction of the water to the motion of vessels with hydrodynamic data, and the coupling of this motion with
    /// heave, roll and pitch.
    radiation_j: "radiation", "water that answers the motion in waves (radiation)",
        "work of the radiation force, the reaction of the water to the motion of vessels with hydrodynamic data";
    /// Banks.
    banks_j: "banks", "banks",
        "work of banks";
    /// The flow of passing ships and of other vessels.
    passing_j: "passing", "passing ships",
        "work of the flow of passing ships and of other vessels";
    /// The bottom, on vessels that are aground.
    bottom_j: "bottom", "seabed",
        "work of the seabed on vessels aground";
    /// Work of a current beyond its part in the hull force: an accelerating current accelerates the vessel, and the
    /// energy of the added mass in the current changes with the vessel's heading. Zero in still water.
    current_j: "current", "accelerating current, and current past a turning ship",
        "work of an accelerating current, and on the added mass of a vessel that turns in a current; 0 in still water";
    /// Vector tugs.
    tugs_j: "tugs", "vector tugs",
        "work of vector tugs";
    /// Mooring and tow lines, winches included.
    lines_j: "lines", "lines",
        "work of mooring and tow lines";
    /// Chains of anchors, windlasses included.
    anchors_j: "anchors", "chains of anchors",
        "work of the chains of anchors, windlasses included";
    /// Piles of flexible dolphins: minus the energy that they store, and minus their losses.
    piles_j: "piles", "piles of dolphins",
        "work of the piles of flexible dolphins on the bodies: minus the energy that they store, and minus their losses";
    /// Loads of the set-up, and external wrenches.
    other_j: "other", "external loads",
        "work of the scenario's loads and of force providers";
}

impl LoadWork {
    /// Each work with its name in summaries.
    pub fn parts(&self) -> impl Iterator<Item = (&'static str, f64)> {
        LoadWork::CAUSES.iter().map(|cause| (cause.name, (cause.work_j)(self)))
    }

    /// The sum (J).
    #[must_use]
    pub fn total_j(&self) -> f64 {
        self.parts().map(|(_, work_j)| work_j).sum()
    }
}

/// The energy ledger since the start of the run (J). Velocities and displacements are over the ground, so that the
/// kinetic energy is the energy that a fender on a quay has to absorb.
///
/// Work is force times mean velocity times Δt, and gives the change of kinetic energy exactly:
///
/// kinetic = kinetic at the start + load_work + normal_work + tangential_work + residual, and
/// height_work − (normal_work + tangential_work) = stored + shear_stored + hysteresis + damping + restitution + friction +
/// contact_residual.
///
/// A contact that returns more energy than it absorbed has positive `normal_work_j` and negative
/// `contact_residual_j`: energy created by the method or the time step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Current kinetic energy, added mass included.
    pub kinetic_j: f64,
    /// Work of everything but contact: the sum of [`Energy::loads`].
    pub load_work_j: f64,
    /// Work of everything but contact, by cause.
    pub loads: LoadWork,
    /// Work of normal contact forces on the bodies.
    pub normal_work_j: f64,
    /// Work of tangential contact forces on the bodies.
    pub tangential_work_j: f64,
    /// Energy that changes of height put into fenders: tide, heave, roll and pitch change the height at which a fender
    /// meets a hull. The motion in the plane gives the rest of the energy. Zero if all hulls have one outline.
    pub height_work_j: f64,
    /// Energy now stored in springs and stops.
    pub stored_j: f64,
    /// Energy now stored in shear springs.
    pub shear_stored_j: f64,
    /// Hysteresis losses of fenders.
    pub hysteresis_j: f64,
    /// Damping losses.
    pub damping_j: f64,
    /// Restitution losses.
    pub restitution_j: f64,
    /// Friction losses.
    pub friction_j: f64,
    /// Energy now stored in the bending of dolphins' piles. Apart from rounding, `loads.piles_j` is −(this energy + the
    /// two losses below).
    pub pile_stored_j: f64,
    /// Losses to damping of piles.
    pub pile_damping_j: f64,
    /// Losses to yielding of piles.
    pub pile_yield_j: f64,
    /// Sum of the contacts' residuals: see [`ContactEnergy::residual_j`].
    pub contact_residual_j: f64,
    /// Energy absorbed by contacts: the sum over all steps and contacts in which the bodies lost energy.
    pub contact_taken_j: f64,
    /// Energy that contacts returned to the bodies beyond what they had absorbed since each contact began. Contacts
    /// that exist at the start of the run are not counted, because they may have had energy stored.
    pub contact_gained_j: f64,
    /// Change of kinetic energy, less all work. For bodies with equal mass in surge and sway, and for vessels without
    /// contact, it is rounding error. Otherwise the residual also contains the error of the Coriolis terms over a step,
    /// which decreases with Δt.
    pub residual_j: f64,
}

impl Energy {
    /// Total energy exchanged (J): the sum of the absolute values of all works. Compare [`Energy::residual_j`] with it.
    #[must_use]
    pub fn exchanged_j(&self) -> f64 {
        let loads_j: f64 = self.loads.parts().map(|(_, work_j)| work_j.abs()).sum();
        loads_j + self.normal_work_j.abs() + self.tangential_work_j.abs() + self.height_work_j.abs()
    }
}
