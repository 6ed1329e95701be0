//! The constant part of an FMU: scenario, table and fingerprint.

use core::fmt;

use fenderline_scenario::Scenario;
use fenderline_sim::{Method, Simulation};

use crate::bundle::{Bundle, BundleError};
use crate::hash::guid;
use crate::inputs::{add_controls, add_extra_loads, add_states};
use crate::outputs::{add_contact, add_peaks, add_simulation};
use crate::parameters::{add_fenders, add_materials_and_masses, add_starts};
use crate::table::{Causality, Class, Kind, Setting, StandsFor, Table, Variable};
use crate::unit::Unit;

/// What all instances of an FMU share.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scenario, self-contained.
    pub bundle: Bundle,
    /// The scenario, read.
    pub scenario: Scenario,
    /// The variables.
    pub table: Table,
    /// GUID of FMI 2.0, instantiation token of FMI 3.0: a hash of bundle, table and version.
    pub token: String,
}

/// A scenario that makes no FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// The scenario is refused.
    Bundle(BundleError),
    /// It cannot be run: why.
    Setup(String),
    /// It starts other programs, which an FMU does not.
    Providers,
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlanError::Bundle(error) => error.fmt(f),
            PlanError::Setup(error) => write!(f, "error: {error}"),
            PlanError::Providers => f.write_str(
                "error: the scenario starts providers, which an FMU cannot: leave them out and \
                 connect their forces to the inputs `body.NAME.extra_x_n` and so on",
            ),
        }
    }
}

impl std::error::Error for PlanError {}

impl Plan {
    /// Reads the scenario and makes the table.
    ///
    /// # Errors
    /// [`PlanError`].
    pub fn new(bundle: Bundle) -> Result<Plan, PlanError> {
        let scenario = bundle.scenario().map_err(PlanError::Bundle)?;
        let setup = &scenario.setup;
        Simulation::new(setup.clone()).map_err(|error| PlanError::Setup(error.to_string()))?;
        let mut table = Table::new();
        match bundle.kind {
            Kind::Engine => {
                add_settings(&mut table, &scenario);
                add_materials_and_masses(&mut table, setup);
                add_fenders(&mut table, setup);
                add_states(&mut table, setup);
                add_contact(&mut table, setup);
                add_peaks(&mut table, setup);
            }
            Kind::Simulation => {
                if !setup.world.providers.is_empty() {
                    return Err(PlanError::Providers);
                }
                add_materials_and_masses(&mut table, setup);
                add_fenders(&mut table, setup);
                add_starts(&mut table, setup);
                add_extra_loads(&mut table, setup);
                add_controls(&mut table, setup);
                add_contact(&mut table, setup);
                add_simulation(&mut table, setup);
            }
        }
        let version = env!("CARGO_PKG_VERSION");
        let token = guid(format!("{version}\n{}{}", bundle.to_json(), table.text()).as_bytes());
        Ok(Plan { bundle, scenario, table, token })
    }
}

/// How the engine shall serve its host. A host is taken for an OSP master (states a step old, forward
/// Euler, loads not told) unless it says otherwise; with the paper's method, which can follow nobody, for
/// one of the present.
fn add_settings(table: &mut Table, scenario: &Scenario) {
    let coupled = f64::from(u8::from(scenario.setup.method == Method::Coupled));
    let rows = [
        (
            "following",
            "the engine follows a host that moves its bodies by itself, and steers it by wrenches; \
             else wrenches are the mean contact forces of a step that begins with the states shown",
            Setting::Following,
            coupled,
        ),
        (
            "delay_steps",
            "where following: age of the states shown when the wrench begins to act, in steps; 1 \
             where a master steps all its FMUs at the same time, 0 where it steps the engine first",
            Setting::DelaySteps,
            1.0,
        ),
        (
            "skip_steps",
            "where following with a delay: first steps in which nothing is looked at and no wrench is \
             given; masters show zeros until all their FMUs have made a step, and a wrench between \
             bodies that lie upon each other at the origin could not be taken back",
            Setting::SkipSteps,
            1.0,
        ),
        (
            "forward_euler",
            "where following: the host moves positions with the old velocities; else with the new",
            Setting::ForwardEuler,
            1.0,
        ),
        (
            "tells_loads",
            "where following: the load inputs are set; else the engine finds the loads itself",
            Setting::TellsLoads,
            0.0,
        ),
        (
            "body_fixed",
            "velocities, loads and wrenches are in the bodies' axes; else earth-fixed",
            Setting::BodyFixed,
            0.0,
        ),
        (
            "step_s",
            "where following: the communication step, for the wrench at the start",
            Setting::StepS,
            scenario.setup.step_s,
        ),
    ];
    for (name, description, setting, start) in rows {
        let (class, unit, range) = match setting {
            Setting::DelaySteps | Setting::SkipSteps => {
                let most = f64::from(fenderline_embed::MAX_DELAY_STEPS);
                (Class::Integer, Unit::One, Some([0.0, most]))
            }
            Setting::StepS => (Class::Real, Unit::Second, Some([1e-6, 1e3])),
            _ => (Class::Boolean, Unit::One, None),
        };
        table.add(Variable {
            name: format!("host.{name}"),
            description: description.to_owned(),
            unit,
            class,
            causality: Causality::Parameter,
            start,
            range,
            stands_for: StandsFor::Setting(setting),
        });
    }
}
