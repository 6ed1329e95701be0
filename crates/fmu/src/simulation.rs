//! A running FMU of the simulation kind.

use fenderline_contact::number::greater;
use fenderline_sim::{Order, Simulation};

use crate::inputs::{InputOrder, Inputs};
use crate::outputs::read;
use crate::parameters::applied;
use crate::plan::Plan;
use crate::table::{StandsFor, Table};
use crate::view::View;

/// Tolerance for the end of a communication step to coincide with the end of a scenario step, in steps.
const SLACK_STEPS: f64 = 1e-6;

/// Limit of scenario steps per communication step, equal to hours. More steps would look like a hang, and are an error.
const MOST_STEPS_A_CALL: u64 = 100_000;

/// An initialised simulation. A clone continues independently.
///
/// The simulation advances in the scenario's steps, whatever the communication step: at a communication point it is at
/// the last step that does not end later.
#[derive(Clone, Debug)]
pub(crate) struct SimulationRun {
    simulation: Simulation,
    steps: u64,
    /// Inputs as of the last step; entries of other variables are unused.
    taken: Vec<f64>,
    /// All input changes in their order. With the parameters they define the whole run, since the same input gives the same
    /// bits.
    pub(crate) journal: Vec<Entry>,
    /// A step failed: the simulation stays at the last good step and does not continue.
    failed: bool,
}

/// Number of scenario steps that end no later than a time since the start.
pub(crate) fn due(plan: &Plan, t_s: f64) -> u64 {
    greater(libm::floor(t_s / plan.scenario.setup.step_s + SLACK_STEPS), 0.0) as u64
}

/// A changed input.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Entry {
    pub(crate) step: u64,
    pub(crate) variable: u32,
    pub(crate) value: f64,
}

impl SimulationRun {
    /// Starts with the parameters.
    pub(crate) fn start(plan: &Plan, values: &[f64]) -> Result<SimulationRun, String> {
        let setup = applied(&plan.table, values, &plan.scenario.setup);
        let simulation = Simulation::new(setup).map_err(|error| error.to_string())?;
        let taken = plan.table.start_values();
        Ok(SimulationRun { simulation, steps: 0, taken, journal: Vec::new(), failed: false })
    }

    /// True after a failed step.
    pub(crate) fn has_failed(&self) -> bool {
        self.failed
    }

    /// Number of scenario steps taken.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// Advances to a time since the start. After an error the simulation stays at the last good step and does not
    /// continue.
    pub(crate) fn go_to(&mut self, plan: &Plan, values: &[f64], t_s: f64) -> Result<(), String> {
        let due = due(plan, t_s);
        if due.saturating_sub(self.steps) > MOST_STEPS_A_CALL {
            return Err(format!(
                "the step to {t_s} s has more than {MOST_STEPS_A_CALL} scenario steps"
            ));
        }
        while self.steps < due {
            self.step(&plan.table, values)?;
        }
        Ok(())
    }

    fn step(&mut self, table: &Table, values: &[f64]) -> Result<(), String> {
        if self.failed {
            return Err("a step failed before: restore an older state, or reset".to_owned());
        }
        let taken = self.take(table, values);
        let done =
            taken.and_then(|()| self.simulation.step().map_err(|e| e.to_string()).map(|_| ()));
        self.failed = done.is_err();
        done?;
        self.steps += 1;
        Ok(())
    }

    /// Applies changed inputs to the simulation.
    fn take(&mut self, table: &Table, values: &[f64]) -> Result<(), String> {
        let is_input =
            |variable: usize| matches!(table.variables[variable].stands_for, StandsFor::Input(_));
        let changed = |&(variable, (old, new)): &(usize, (&f64, &f64))| {
            is_input(variable) && old.to_bits() != new.to_bits()
        };
        let pairs = self.taken.iter().zip(values).enumerate();
        let changes: Vec<Entry> = pairs
            .filter(changed)
            .map(|(variable, (_, &value))| Entry {
                step: self.steps,
                variable: variable as u32,
                value,
            })
            .collect();
        if changes.is_empty() {
            return Ok(());
        }
        let before = Inputs { table, values: &self.taken };
        let now = Inputs { table, values };
        for InputOrder { order, target, arguments } in now.orders(&before) {
            let action = order.build(target, &arguments, self.simulation.setup());
            let action = action.map_err(|error| error.to_string())?;
            let order = Order { at_s: self.simulation.time_s(), action };
            self.simulation.order(order).map_err(|error| error.to_string())?;
        }
        self.simulation.set_external(&now.loads(self.simulation.states().len()));
        for entry in &changes {
            self.taken[entry.variable as usize] = entry.value;
        }
        self.journal.extend(changes);
        Ok(())
    }

    /// Replays a journal for a number of steps.
    pub(crate) fn replay(
        plan: &Plan,
        values: &[f64],
        steps: u64,
        journal: &[Entry],
    ) -> Result<SimulationRun, String> {
        let mut run = SimulationRun::start(plan, values)?;
        let mut inputs = plan.table.start_values();
        let mut entries = journal.iter().peekable();
        while run.steps < steps {
            while let Some(entry) = entries.next_if(|entry| entry.step <= run.steps) {
                inputs[entry.variable as usize] = entry.value;
            }
            run.step(&plan.table, &inputs)?;
        }
        Ok(run)
    }

    /// Reads the current outputs.
    pub(crate) fn read(&self, plan: &Plan, values: &mut [f64]) {
        let simulation = &self.simulation;
        let view = View {
            states: simulation.states(),
            wrenches: simulation.wrenches(),
            peaks: &[],
            contacts: simulation.contacts(),
            body_fixed: false,
            simulation: Some(simulation),
        };
        read(&plan.table, &view, values);
    }
}
