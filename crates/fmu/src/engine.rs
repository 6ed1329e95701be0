//! A running FMU of the kind `engine`: the contact engine whose ships other FMUs simulate.

use fenderline_contact::{BodyState, Contact, HostIntegration, HostSettings, Wrench};
use fenderline_embed::{Engine, Host, Settings};
use fenderline_scenario::Scenario;
use fenderline_sim::Method;

use crate::inputs::Inputs;
use crate::outputs::read;
use crate::parameters::applied;
use crate::plan::Plan;
use crate::table::{FORWARD_EULER, Setting};
use crate::view::View;

/// An initialised engine. A clone continues independently.
#[derive(Clone, Debug)]
pub(crate) struct EngineRun {
    pub(crate) engine: Engine,
    uses_loads: bool,
    body_fixed: bool,
    pub(crate) beginning: Beginning,
    /// The reposition counter of each body at the last step; fixed bodies have 0.
    pub(crate) placed: Vec<i32>,
}

/// How far the start of the engine has come, for a host whose states reach the engine some steps late.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Beginning {
    /// Number of steps that are still skipped, because the host's states may not be valid yet.
    Waiting(u32),
    /// The host's initial states have been processed.
    Begun,
}

impl EngineRun {
    /// Starts the engine with the parameters and the bodies' initial states.
    pub(crate) fn start(plan: &Plan, values: &[f64]) -> Result<EngineRun, String> {
        let mut run = EngineRun::at_rest(plan, values)?;
        if run.beginning == Beginning::Waiting(0) {
            // The wrench for the host's first step must be available at initialization, before the first call of a
            // step.
            let step_s = plan.table.setting(values, Setting::StepS);
            run.advance(plan, values, step_s)?;
            run.beginning = Beginning::Begun;
        }
        Ok(run)
    }

    /// Makes the engine with the parameters, before its initial step.
    pub(crate) fn at_rest(plan: &Plan, values: &[f64]) -> Result<EngineRun, String> {
        let of = |setting| plan.table.setting(values, setting);
        let is_on = |setting| of(setting) != 0.0;
        let Scenario { title, setup, .. } = &plan.scenario;
        let setup = applied(&plan.table, values, setup);
        let following = is_on(Setting::Following);
        let delay_steps = if following { of(Setting::DelaySteps) as u32 } else { 0 };
        let integration = if of(Setting::Integration) as u32 == FORWARD_EULER {
            HostIntegration::ForwardEuler
        } else {
            HostIntegration::SemiImplicit
        };
        let host = if following {
            Host::CoSimulation(HostSettings { delay_steps, integration })
        } else {
            Host::default()
        };
        let scenario = Scenario {
            title: title.clone(),
            report: Vec::new(),
            setup,
            exercise: None,
            output: plan.scenario.output.clone(),
            output_gives: plan.scenario.output_gives,
            notices: Vec::new(),
        };
        let engine = Engine::from_scenario(scenario, &Settings { method: None, host })
            .map_err(|error| error.to_string())?;
        let uses_loads = !following || is_on(Setting::TellsLoads);
        let beginning = match delay_steps {
            0 => Beginning::Begun,
            _ => Beginning::Waiting(of(Setting::SkipSteps) as u32),
        };
        let placed = vec![0; engine.states().len()];
        let body_fixed = is_on(Setting::BodyFixed);
        Ok(EngineRun { engine, uses_loads, body_fixed, beginning, placed })
    }

    /// True before the engine has made its first step.
    pub(crate) fn waits(&self) -> bool {
        self.beginning != Beginning::Begun
    }

    /// Takes a step of the host.
    pub(crate) fn step(&mut self, plan: &Plan, values: &[f64], step_s: f64) -> Result<(), String> {
        match self.beginning {
            Beginning::Begun => {}
            Beginning::Waiting(steps @ 1..) => {
                self.beginning = Beginning::Waiting(steps - 1);
                return Ok(());
            }
            Beginning::Waiting(0) => {
                // The host takes this step without a wrench; the engine starts from the end of this
                // step.
                self.advance(plan, values, step_s)?;
                self.beginning = Beginning::Begun;
            }
        }
        self.advance(plan, values, step_s)
    }

    /// Takes a step of the engine from the states and loads that the inputs give.
    fn advance(&mut self, plan: &Plan, values: &[f64], step_s: f64) -> Result<(), String> {
        let inputs = Inputs { table: &plan.table, values };
        let mut states = self.engine.initial_states().to_vec();
        inputs.states(self.body_fixed, &mut states);
        let mut loads = inputs.loads(states.len());
        if self.body_fixed {
            for (load, state) in loads.iter_mut().zip(&states) {
                load.force_n = crate::axes::earth_fixed(state, load.force_n);
            }
        }
        let nothing = loads.iter().all(|load| *load == Wrench::default());
        // The paper's method takes no loads: pass no loads if all are zero.
        let use_loads = self.uses_loads && !(nothing && self.engine.method() == Method::Paper);
        let loads = use_loads.then_some(&*loads);
        let placed = self.newly_placed(&inputs);
        if placed.is_empty() {
            return advance(&mut self.engine, &states, loads, step_s);
        }
        // Work on a copy, so that a failed step leaves no body marked.
        let mut engine = self.engine.clone();
        for &(body, _) in &placed {
            engine.mark_teleported(body).map_err(|error| error.to_string())?;
        }
        advance(&mut engine, &states, loads, step_s)?;
        self.engine = engine;
        placed.into_iter().for_each(|(body, count)| self.placed[body] = count);
        Ok(())
    }

    /// Bodies whose reposition counter has changed since the last step, each with its new count.
    fn newly_placed(&self, inputs: &Inputs<'_>) -> Vec<(usize, i32)> {
        inputs.placed().filter(|&(body, count)| count != self.placed[body]).collect()
    }

    /// Reads the outputs of the engine's last step, or zeros before the first step.
    pub(crate) fn read(&self, plan: &Plan, values: &mut [f64]) {
        let results = self.engine.results();
        let nothing: (&[Wrench], &[Wrench], &[Contact]) = (&[], &[], &[]);
        let (wrenches, peaks, contacts) = results
            .map_or(nothing, |results| (results.wrenches, results.peak_wrenches, results.contacts));
        let states = self.engine.states();
        let body_fixed = self.body_fixed;
        let view = View { states, wrenches, peaks, contacts, body_fixed, simulation: None };
        read(&plan.table, &view, values);
    }
}

fn advance(
    engine: &mut Engine,
    states: &[BodyState],
    loads: Option<&[Wrench]>,
    step_s: f64,
) -> Result<(), String> {
    engine.advance(states, loads, step_s).map(|_| ()).map_err(|error| error.to_string())
}
