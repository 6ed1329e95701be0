//! The part of an FMU that does not change: scenario, table of variables and fingerprint.

use core::fmt;

use fenderline_scenario::Scenario;
use fenderline_sim::{Method, Simulation};

use crate::bundle::{Bundle, BundleError};
use crate::hash::guid;
use crate::inputs::{add_controls, add_extra_loads, add_states};
use crate::outputs::{add_contact, add_peaks, add_simulation};
use crate::parameters::{add_fenders, add_materials_and_masses, add_starts};
use crate::table::{Causality, Class, FORWARD_EULER, Kind, Setting, StandsFor, Table, Variable};
use crate::unit::Unit;

/// The data that all instances of an FMU share.
#[derive(Clone, Debug)]
pub struct Plan {
    /// The scenario, self-contained.
    pub bundle: Bundle,
    /// The scenario, read.
    pub scenario: Scenario,
    /// The variables.
    pub table: Table,
    /// GUID in FMI 2.0 and instantiation token in FMI 3.0: a hash of bundle, table and version.
    pub token: String,
}

/// Why a scenario cannot be exported as an FMU.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// The scenario is invalid.
    Bundle(BundleError),
    /// The scenario cannot be run; the text says why.
    Setup(String),
    /// The scenario starts other programs as providers, which an FMU cannot do.
    Providers,
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            PlanError::Bundle(error) => error.fmt(f),
            PlanError::Setup(error) => write!(f, "error: {error}"),
            PlanError::Providers => f.write_str(
                "error: the scenario starts providers, which an FMU cannot do: leave the providers out and \
                 connect their forces to the inputs `body.NAME.external_x_n` and so on",
            ),
        }
    }
}

impl std::error::Error for PlanError {}

impl Plan {
    /// Reads the scenario of a bundle and makes the table of variables.
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
        let identity =
            [version.as_bytes(), b"\n", &bundle.content(), table.text().as_bytes()].concat();
        let token = guid(&identity);
        Ok(Plan { bundle, scenario, table, token })
    }
}

/// Adds the settings by which an engine FMU knows how its host works. The defaults are those of a master of the Open
/// Simulation Platform: input states that are one step old, forward Euler, and no loads connected. With the paper's
/// method, which has no co-simulation mode, the default is a host with current states.
fn add_settings(table: &mut Table, scenario: &Scenario) {
    let coupled = f64::from(u8::from(scenario.setup.method == Method::Coupled));
    let rows = [
        (
            "following",
            "true: the host integrates its bodies with the engine's wrenches, and the engine keeps \
             the bodies on the motion that the engine computes; false: wrenches are the mean \
             contact forces of a step that starts at the input states",
            Setting::Following,
            coupled,
        ),
        (
            "delay_steps",
            "if host.following: number of steps by which the input states are old when the wrench starts to \
             act; 1 if the master steps all FMUs at the same time, 0 if the master steps the engine first",
            Setting::DelaySteps,
            1.0,
        ),
        (
            "skip_steps",
            "if host.following with a delay: number of steps at the start without a wrench. Masters send zeros \
             until every FMU has made a step, so that all bodies overlap at the origin and would get a wrench",
            Setting::SkipSteps,
            1.0,
        ),
        (
            "integration",
            "if host.following: how the host moves its bodies",
            Setting::Integration,
            f64::from(FORWARD_EULER),
        ),
        (
            "loads_connected",
            "if host.following: true: the load inputs are connected; false: the engine estimates the loads from the motion",
            Setting::TellsLoads,
            0.0,
        ),
        (
            "body_fixed",
            "true: velocities, loads and wrenches are in the bodies' axes; false: they are earth-fixed",
            Setting::BodyFixed,
            0.0,
        ),
        (
            "step_s",
            "if host.following: length of the communication step, for the wrench at the start",
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
            Setting::Integration => (Class::Enumeration, Unit::One, Some([1.0, 2.0])),
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
