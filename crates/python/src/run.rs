//! A simulation with its controls, without Python.

use std::sync::Arc;

use fenderline_scenario::Scenario;
use fenderline_sim::{SetupError, SimError, Simulation, StepRecord};

use crate::controls::Control;

/// A simulation and the last values of its controls.
#[derive(Clone)]
pub(crate) struct Run {
    pub(crate) simulation: Simulation,
    pub(crate) controls: Arc<Vec<Control>>,
    /// NaN for a control that was never set, which stays with the scenario's orders and pilots.
    set: Vec<f64>,
}

/// The reason why a run cannot start.
pub(crate) enum CannotRun {
    Setup(SetupError),
    /// The scenario asks other programs for forces.
    Providers,
}

impl std::fmt::Display for CannotRun {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            CannotRun::Setup(error) => error.fmt(f),
            CannotRun::Providers => f.write_str(
                "the scenario has a [[provider]], which only the program `fenderline` starts: take it \
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
        Ok(Run { simulation, controls, set })
    }

    /// The first control with an invalid value, which is an infinite one.
    pub(crate) fn refused<'c>(controls: &'c [Control], values: &[f64]) -> Option<&'c str> {
        let infinite = values.iter().position(|value| value.is_infinite())?;
        controls.get(infinite % controls.len()).map(|control| control.name.as_str())
    }

    /// Gives orders for the controls whose values have changed; NaN leaves a control unchanged.
    pub(crate) fn order(&mut self, values: &[f64]) {
        let at_s = self.simulation.time_s();
        for ((control, set), &value) in self.controls.iter().zip(&mut self.set).zip(values) {
            if value.is_nan() || value.to_bits() == set.to_bits() {
                continue;
            }
            *set = value;
            let ordered = self.simulation.order(control.order(value, at_s));
            ordered.expect("controls are those of the set-up");
        }
    }

    /// One step.
    pub(crate) fn step(&mut self) -> Result<StepRecord<'_>, SimError> {
        self.simulation.step()
    }
}
