//! A running FMU of the kind `simulation`: a whole scenario.

use fenderline_contact::number::greater;
use fenderline_sim::{Order, Simulation};

use crate::inputs::{InputOrder, Inputs};
use crate::outputs::read;
use crate::parameters::applied;
use crate::plan::Plan;
use crate::table::{StandsFor, Table};
use crate::view::View;

/// How far, in scenario steps, the end of a communication step may lie from the end of a scenario step and still count
/// as equal.
const SLACK_STEPS: f64 = 1e-6;

/// Most scenario steps in one communication step, which take hours of simulated time. A communication step of even more
/// scenario steps would look like a hang, and is refused.
const MOST_STEPS_A_CALL: u64 = 100_000;

/// An initialised simulation. A clone continues independently.
///
/// The simulation advances in the scenario's steps, whatever the communication step: at a communication point it has
/// made all scenario steps that end by that time.
#[derive(Clone, Debug)]
pub(crate) struct SimulationRun {
    simulation: Simulation,
    steps: u64,
    /// The values that the inputs had in the last step; the entries of other variables are unused.
    taken: Vec<f64>,
    /// All changes of the inputs, in the order in which they came. The parameters and these changes define the whole
    /// run, because the same input gives the same bits.
    pub(crate) journal: Vec<Entry>,
    /// Whether a step has failed: the simulation then stays at the last good step and does not continue.
    failed: bool,
}

/// Number of scenario steps that end at or before a time, counted from the start.
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

    /// True after a step of the simulation has failed.
    pub(crate) fn has_failed(&self) -> bool {
        self.failed
    }

    /// Number of scenario steps that the simulation has taken.
    pub(crate) fn steps(&self) -> u64 {
        self.steps
    }

    /// Advances the simulation to a time since its start. After an error the simulation stays at the last good step and
    /// does not continue.
    pub(crate) fn go_to(&mut self, plan: &Plan, values: &[f64], t_s: f64) -> Result<(), String> {
        let due = due(plan, t_s);
        if due.saturating_sub(self.steps) > MOST_STEPS_A_CALL {
            return Err(format!(
                "the communication step to {t_s} s has more than {MOST_STEPS_A_CALL} scenario steps"
            ));
        }
        while self.steps < due {
            self.step(&plan.table, values)?;
        }
        Ok(())
    }

    fn step(&mut self, table: &Table, values: &[f64]) -> Result<(), String> {
        if self.failed {
            return Err("an earlier step failed: restore an older state, or reset".to_owned());
        }
        let taken = self.take(table, values);
        let done =
            taken.and_then(|()| self.simulation.step().map_err(|e| e.to_string()).map(|_| ()));
        self.failed = done.is_err();
        done?;
        self.steps += 1;
        Ok(())
    }

    /// Gives the simulation the inputs that have changed.
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

    /// Makes a simulation and repeats a number of its steps with the changes of inputs in a journal.
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
