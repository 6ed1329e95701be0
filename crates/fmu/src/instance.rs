//! An instance of an FMU, as both versions of the standard have it: which calls are allowed in which phase, and what
//! they do. A call that fails returns a message and changes nothing.

use fenderline_contact::number::greater;

use std::collections::BTreeMap;
use std::sync::Arc;

use crate::engine::EngineRun;
use crate::plan::Plan;
use crate::simulation::SimulationRun;
use crate::state::{Phase, Run, State};
use crate::table::{Causality, Class, Kind, StandsFor};

/// The result of a call to the FMU: a value, or a message that says what is wrong.
pub(crate) type Outcome<T = ()> = Result<T, String>;

/// Tolerance between a communication point and the time reached, as a share of the step and in seconds: masters round
/// time to nanoseconds, or sum up steps.
const SLACK_STEPS: f64 = 1e-6;
const SLACK_S: f64 = 1e-9;

/// An instance.
#[derive(Debug)]
pub(crate) struct Instance {
    pub(crate) plan: Arc<Plan>,
    pub(crate) state: State,
    /// States that the master has saved, by their handles.
    pub(crate) saved: BTreeMap<usize, State>,
    /// Whether a panic left the instance in an unknown state, so that it can only be freed.
    pub(crate) broken: bool,
}

impl Instance {
    pub(crate) fn new(plan: Plan) -> Instance {
        let state = State::new(&plan);
        Instance { plan: Arc::new(plan), state, saved: BTreeMap::new(), broken: false }
    }

    fn must_be(&self, phases: &[Phase], what: &str) -> Outcome {
        if phases.contains(&self.state.phase) {
            return Ok(());
        }
        let now = match self.state.phase {
            Phase::Instantiated => "was not initialized",
            Phase::Initializing => "is in initialization mode",
            Phase::Stepping => "was initialized",
            Phase::Terminated => "was terminated",
        };
        Err(format!("{what}: the instance {now}"))
    }

    /// Start and stop time.
    pub(crate) fn set_up(&mut self, start_s: f64, stop_s: Option<f64>) -> Outcome {
        self.must_be(&[Phase::Instantiated], "setting up the experiment")?;
        if !start_s.is_finite() || stop_s.is_some_and(|stop_s| stop_s.is_nan() || stop_s < start_s)
        {
            return Err(format!("from {start_s} s to {stop_s:?} is not a valid experiment"));
        }
        let state = &mut self.state;
        (state.start_s, state.time_s) = (start_s, start_s);
        state.stop_s = stop_s.unwrap_or(f64::INFINITY);
        Ok(())
    }

    pub(crate) fn enter_initialization(&mut self) -> Outcome {
        self.must_be(&[Phase::Instantiated], "entering initialization mode")?;
        self.state.phase = Phase::Initializing;
        Ok(())
    }

    pub(crate) fn exit_initialization(&mut self) -> Outcome {
        self.must_be(&[Phase::Initializing], "leaving initialization mode")?;
        self.start_run()?;
        self.state.phase = Phase::Stepping;
        Ok(())
    }

    pub(crate) fn terminate(&mut self) -> Outcome {
        self.must_be(&[Phase::Stepping], "terminating")?;
        self.state.phase = Phase::Terminated;
        Ok(())
    }

    pub(crate) fn reset(&mut self) -> Outcome {
        self.state = State::new(&self.plan);
        Ok(())
    }

    /// Creates the run of engine or simulation from the values set so far, and computes its first outputs.
    fn start_run(&mut self) -> Outcome {
        let (plan, state) = (&*self.plan, &mut self.state);
        if state.run.is_some() {
            return Ok(());
        }
        let run = match plan.bundle.kind {
            Kind::Engine => Run::Engine(Box::new(EngineRun::start(plan, &state.values)?)),
            Kind::Simulation => {
                Run::Simulation(Box::new(SimulationRun::start(plan, &state.values)?))
            }
        };
        state.run = Some(run);
        self.read_outputs();
        Ok(())
    }

    fn read_outputs(&mut self) {
        let State { run, values, .. } = &mut self.state;
        match run {
            Some(Run::Engine(run)) => run.read(&self.plan, values),
            Some(Run::Simulation(run)) => run.read(&self.plan, values),
            None => {}
        }
    }

    /// The values of some variables of one type.
    pub(crate) fn get(&mut self, references: &[u32], class: Class) -> Outcome<Vec<f64>> {
        for &reference in references {
            let variable = self.check(reference, class)?;
            // In initialization mode, outputs follow from the inputs set so far.
            let output = matches!(variable.stands_for, StandsFor::Output(_));
            if output && self.state.phase == Phase::Initializing {
                self.start_run()?;
            }
        }
        let value = |&reference: &u32| {
            let index = reference as usize;
            match self.plan.table.variables[index].stands_for {
                StandsFor::Time => self.state.time_s,
                _ => self.state.values[index],
            }
        };
        Ok(references.iter().map(value).collect())
    }

    fn check(&self, reference: u32, class: Class) -> Outcome<&crate::Variable> {
        let Some(variable) = self.plan.table.variables.get(reference as usize) else {
            return Err(format!("no variable has the value reference {reference}"));
        };
        // FMI 2.0 reads and sets enumerations as integers.
        let fits = variable.class == class
            || (variable.class == Class::Enumeration && class == Class::Integer);
        if !fits {
            let name = &variable.name;
            return Err(format!("`{name}` is of type {:?}, not {class:?}", variable.class));
        }
        Ok(variable)
    }

    /// Sets some variables of a type: all of them, or no variable if one of them is invalid.
    pub(crate) fn set(&mut self, references: &[u32], values: &[f64], class: Class) -> Outcome {
        for (&reference, &value) in references.iter().zip(values) {
            let variable = self.check(reference, class)?;
            let name = &variable.name;
            match variable.causality {
                Causality::Input => self.must_be(
                    &[Phase::Instantiated, Phase::Initializing, Phase::Stepping],
                    &format!("setting `{name}`"),
                )?,
                Causality::Parameter => self.must_be(
                    &[Phase::Instantiated, Phase::Initializing],
                    &format!("setting the parameter `{name}`"),
                )?,
                Causality::Output | Causality::Independent => {
                    return Err(format!("`{name}` is an output: it cannot be set"));
                }
            }
            if !value.is_finite() {
                return Err(format!("`{name}` cannot be {value}"));
            }
            if let Some([least, most]) = variable.range
                && !(least..=most).contains(&value)
            {
                return Err(format!(
                    "`{name}` cannot be {value}: it must be from {least} to {most}"
                ));
            }
        }
        for (&reference, &value) in references.iter().zip(values) {
            self.state.values[reference as usize] = value;
        }
        if self.state.phase != Phase::Stepping && !references.is_empty() {
            self.state.run = None;
        }
        Ok(())
    }

    /// One communication step. A step of zero length, as from a paused master, changes nothing.
    pub(crate) fn step(&mut self, from_s: f64, step_s: f64) -> Outcome {
        self.must_be(&[Phase::Stepping], "a step")?;
        let (plan, state) = (&*self.plan, &mut self.state);
        if !(step_s >= 0.0 && from_s.is_finite() && (from_s + step_s).is_finite()) {
            return Err(format!("a step from {from_s} s that lasts {step_s} s is not valid"));
        }
        let slack_s = SLACK_S * greater(state.time_s.abs(), 1.0) + SLACK_STEPS * step_s;
        if from_s < state.time_s - slack_s {
            return Err(format!(
                "a step from {from_s} s goes back: the time {} s was reached already; restore an older state first",
                state.time_s
            ));
        }
        if from_s > state.time_s + slack_s {
            return Err(format!(
                "a step from {from_s} s leaves a gap: only the time {} s was reached",
                state.time_s
            ));
        }
        let end_s = from_s + step_s;
        if end_s > state.stop_s + slack_s {
            return Err(format!(
                "a step to {end_s} s goes beyond the stop time of {} s",
                state.stop_s
            ));
        }
        match &mut state.run {
            // A step of zero length does not count as one of the skipped first steps.
            Some(Run::Engine(run)) if step_s == 0.0 && run.waits() => {}
            Some(Run::Engine(run)) => run.step(plan, &state.values, step_s)?,
            Some(Run::Simulation(run)) => {
                run.go_to(plan, &state.values, end_s - state.start_s)?;
            }
            None => unreachable!("in the stepping phase there is always a run"),
        }
        state.time_s = end_s;
        self.read_outputs();
        Ok(())
    }

    /// Saves a copy of the instance's state under a handle.
    pub(crate) fn save(&mut self, number: usize) {
        self.saved.insert(number, self.state.clone());
    }

    fn saved(&self, number: usize) -> Outcome<&State> {
        self.saved
            .get(&number)
            .ok_or_else(|| "no FMU state of this instance has the given handle".to_owned())
    }

    pub(crate) fn restore(&mut self, number: usize) -> Outcome {
        self.state = self.saved(number)?.clone();
        Ok(())
    }

    pub(crate) fn forget(&mut self, number: usize) -> Outcome {
        self.saved(number)?;
        self.saved.remove(&number);
        Ok(())
    }

    pub(crate) fn to_bytes(&self, number: usize) -> Outcome<Vec<u8>> {
        self.saved(number)?.to_bytes(&self.plan)
    }

    pub(crate) fn of_bytes(&mut self, bytes: &[u8], number: usize) -> Outcome {
        let state = State::of_bytes(&self.plan, bytes)?;
        self.saved.insert(number, state);
        Ok(())
    }
}
