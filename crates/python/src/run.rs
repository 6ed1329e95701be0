//! A simulation with its controls, for code that runs on threads without Python.

use std::sync::Arc;

use fenderline_scenario::Scenario;
use fenderline_sim::{SetupError, SimError, Simulation, Start, StepRecord};

use crate::controls::Control;

/// A simulation, and the last values of its controls.
#[derive(Clone)]
pub(crate) struct Run {
    pub(crate) simulation: Simulation,
    pub(crate) controls: Arc<Vec<Control>>,
    /// The last value of each control; NaN for a control that was never set, which stays with an order of the scenario
    /// or a pilot.
    set: Vec<f64>,
    /// Whether the set-up of the simulation equals that of the scenario, except perhaps for the start of the run.
    pub(crate) is_of_scenario: bool,
}

/// Why a run cannot start.
pub(crate) enum CannotRun {
    Setup(SetupError),
    /// The scenario has providers: programs that compute forces.
    Providers,
}

impl std::fmt::Display for CannotRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            CannotRun::Setup(error) => error.fmt(f),
            CannotRun::Providers => f.write_str(
                "the scenario has a [[provider]], which only the program `fenderline` starts: take the provider \
                 out and set `external_wrenches` before each step",
            ),
        }
    }
}

impl Run {
    pub(crate) fn new(scenario: &Scenario, controls: Arc<Vec<Control>>) -> Result<Run, CannotRun> {
        if !scenario.setup.world.providers.is_empty() {
            return Err(CannotRun::Providers);
        }
        let simulation = Simulation::new(scenario.setup.clone()).map_err(CannotRun::Setup)?;
        let set = vec![f64::NAN; controls.len()];
        Ok(Run { simulation, controls, set, is_of_scenario: true })
    }

    /// Starts the run again, with no control set. The caller has checked that the set-up can be restarted in place.
    pub(crate) fn restart(&mut self, start: &Start) {
        self.simulation.restart(start).expect("a restart in place");
        self.set.fill(f64::NAN);
    }

    /// The first control whose value is out of the control's limits, in words. NaN is within the limits, because NaN
    /// leaves a control alone.
    pub(crate) fn refused(controls: &[Control], values: &[f64]) -> Option<String> {
        let each = controls.iter().cycle().zip(values);
        each.filter(|(_, value)| !value.is_nan()).find_map(|(control, value)| {
            let [low, high] = control.limits();
            let is_within = *value >= low && *value <= high;
            (!is_within).then(|| {
                format!(
                    "the control {} must be between {low} and {high}, but is {value}",
                    control.name
                )
            })
        })
    }

    /// Orders the controls whose values have changed, and calls `ordered` with the number and value of each; NaN leaves
    /// a control alone. The caller has checked that the values are within the limits of their controls.
    pub(crate) fn order(&mut self, values: &[f64], mut ordered: impl FnMut(usize, f64)) {
        for (index, &value) in values.iter().enumerate() {
            if !value.is_nan() && value.to_bits() != self.set[index].to_bits() {
                self.order_one(index, value);
                ordered(index, value);
            }
        }
    }

    /// Orders one control.
    pub(crate) fn order_one(&mut self, index: usize, value: f64) {
        self.set[index] = value;
        let at_s = self.simulation.time_s();
        let order = self.controls[index].order(value, at_s, self.simulation.setup());
        let given = self.simulation.order(order);
        given.expect("the controls belong to the set-up, and their values are within the limits");
    }

    /// One step.
    pub(crate) fn step(&mut self) -> Result<StepRecord<'_>, SimError> {
        self.simulation.step()
    }
}
