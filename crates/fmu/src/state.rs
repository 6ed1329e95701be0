//! The state of an FMU's instance: everything that changes, and the byte format in which it is saved.
//!
//! | bytes | content |
//! |---|---|
//! | 8, 4 | the letters `fndrlfmu`; version of the byte format |
//! | 8 | FNV-1a hash of the token that identifies the FMU |
//! | 4, 8, 8, 8 | phase of the instance; start time, stop time (infinity where none is set) and present time (s) |
//! | 4 + 8 each | the values of all variables of the FMU |
//! | 4 | kind of the run: 0 not initialized, 1 an engine, 2 a simulation |
//! | 4, 4 each | for an engine: number of first steps still to skip, or all bits set if the engine has started; repositioning counter of each body |
//! | 4 + length | its own bytes |
//! | 8, 4+20 each | for a simulation: number of steps; each change of an input with step, variable and value |
//! | 8 | FNV-1a hash of all bytes before this hash |
//!
//! A simulation is saved as its inputs and restored by repeating its steps with them: the same input gives the same
//! bits, and no byte format has to follow every change of the simulator. Restoring a simulation from bytes takes as
//! long as its run took; a saved state that is not serialised is a copy, which is restored at once.

use fenderline_contact::hash::Fnv1a;

use crate::bytes::{Reader, number, word32, word64};
use crate::engine::{Beginning, EngineRun};
use crate::plan::Plan;
use crate::simulation::{Entry, SimulationRun, due};
use crate::table::Class;

const MAGIC: &[u8; 8] = b"fndrlfmu";
const VERSION: u32 = 2;
/// The number that stands for "the engine has started", in place of the number of steps to skip.
const BEGUN: u32 = u32::MAX;
/// Most steps that restoring may repeat: months of simulated time.
const MOST_STEPS: u64 = 100_000_000;

/// The phase of an FMU instance's life.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Phase {
    Instantiated,
    Initializing,
    Stepping,
    Terminated,
}

impl Phase {
    fn to_word(self) -> u32 {
        match self {
            Phase::Instantiated => 0,
            Phase::Initializing => 1,
            Phase::Stepping => 2,
            Phase::Terminated => 3,
        }
    }

    fn from_word(word: u32) -> Option<Phase> {
        Some(match word {
            0 => Phase::Instantiated,
            1 => Phase::Initializing,
            2 => Phase::Stepping,
            3 => Phase::Terminated,
            _ => return None,
        })
    }
}

/// The run of an instance: an engine or a simulation, by the kind of FMU.
#[derive(Clone, Debug)]
pub(crate) enum Run {
    Engine(Box<EngineRun>),
    Simulation(Box<SimulationRun>),
}

/// The state of an FMU's instance.
#[derive(Clone, Debug)]
pub(crate) struct State {
    pub(crate) phase: Phase,
    pub(crate) start_s: f64,
    /// Stop time (s); infinity if the master gave none.
    pub(crate) stop_s: f64,
    pub(crate) time_s: f64,
    pub(crate) values: Vec<f64>,
    /// The run; `None` before initialization, or if a value was set after the run was created.
    pub(crate) run: Option<Run>,
}

impl State {
    pub(crate) fn new(plan: &Plan) -> State {
        State {
            phase: Phase::Instantiated,
            start_s: 0.0,
            stop_s: f64::INFINITY,
            time_s: 0.0,
            values: plan.table.start_values(),
            run: None,
        }
    }

    /// # Errors
    /// Fails for a simulation that failed within a communication step: repeating its steps cannot reach that point.
    pub(crate) fn to_bytes(&self, plan: &Plan) -> Result<Vec<u8>, String> {
        if let Some(Run::Simulation(run)) = &self.run
            && run.has_failed()
        {
            return Err("a step failed: the state of this instance cannot be serialised".to_owned());
        }
        let mut out = MAGIC.to_vec();
        word32(&mut out, VERSION);
        word64(&mut out, Fnv1a::of(plan.token.as_bytes()));
        word32(&mut out, self.phase.to_word());
        [self.start_s, self.stop_s, self.time_s].iter().for_each(|&t| number(&mut out, t));
        word32(&mut out, self.values.len() as u32);
        self.values.iter().for_each(|&value| number(&mut out, value));
        match &self.run {
            None => word32(&mut out, 0),
            Some(Run::Engine(run)) => {
                word32(&mut out, 1);
                word32(
                    &mut out,
                    match run.beginning {
                        Beginning::Waiting(steps) => steps,
                        Beginning::Begun => BEGUN,
                    },
                );
                run.placed.iter().for_each(|&count| word32(&mut out, count as u32));
                let bytes = run.engine.save();
                word32(&mut out, bytes.len() as u32);
                out.extend_from_slice(&bytes);
            }
            Some(Run::Simulation(run)) => {
                word32(&mut out, 2);
                word64(&mut out, run.steps());
                word32(&mut out, run.journal.len() as u32);
                for entry in &run.journal {
                    word64(&mut out, entry.step);
                    word32(&mut out, entry.variable);
                    number(&mut out, entry.value);
                }
            }
        }
        let sum = Fnv1a::of(&out);
        word64(&mut out, sum);
        Ok(out)
    }

    /// Reads a serialised state; bytes that are no serialised state are refused.
    pub(crate) fn of_bytes(plan: &Plan, bytes: &[u8]) -> Result<State, String> {
        let end = bytes.len().checked_sub(8).ok_or_else(broken)?;
        let (summed, sum) = bytes.split_at(end);
        if sum != Fnv1a::of(summed).to_le_bytes() {
            return Err(broken());
        }
        let mut input = Reader(summed);
        let head = read_head(plan, &mut input).ok_or_else(broken)?;
        let (mut state, run) = head;
        state.run = match run {
            0 => None,
            1 => Some(Run::Engine(Box::new(read_engine(plan, &state, &mut input)?))),
            2 => Some(Run::Simulation(Box::new(read_simulation(plan, &state, &mut input)?))),
            _ => return Err(broken()),
        };
        // In the stepping phase there is a run, of the FMU's kind.
        let own = match (&state.run, plan.bundle.kind) {
            (None, _) => state.phase != Phase::Stepping,
            (Some(Run::Engine(_)), kind) => kind == crate::Kind::Engine,
            (Some(Run::Simulation(_)), kind) => kind == crate::Kind::Simulation,
        };
        if input.0.is_empty() && own { Ok(state) } else { Err(broken()) }
    }
}

/// Reads the head of a serialised state, up to the kind of run.
fn read_head(plan: &Plan, input: &mut Reader<'_>) -> Option<(State, u32)> {
    if input.take(8)? != MAGIC || input.word32()? != VERSION {
        return None;
    }
    if input.word64()? != Fnv1a::of(plan.token.as_bytes()) {
        return None;
    }
    let phase = Phase::from_word(input.word32()?)?;
    let start_s = input.number()?;
    let stop_s = f64::from_bits(input.word64()?);
    let time_s = input.number()?;
    let variables = &plan.table.variables;
    if stop_s.is_nan() || input.word32()? as usize != variables.len() {
        return None;
    }
    let mut values = Vec::with_capacity(variables.len());
    for variable in variables {
        let value = input.number()?;
        let whole = variable.class == Class::Real || value == libm::trunc(value);
        let within = variable.range.is_none_or(|[least, most]| (least..=most).contains(&value));
        if !(whole && within) {
            return None;
        }
        values.push(value);
    }
    let run = input.word32()?;
    Some((State { phase, start_s, stop_s, time_s, values, run: None }, run))
}

fn read_engine(plan: &Plan, state: &State, input: &mut Reader<'_>) -> Result<EngineRun, String> {
    let beginning = match input.word32().ok_or_else(broken)? {
        BEGUN => Beginning::Begun,
        steps => Beginning::Waiting(steps),
    };
    if plan.bundle.kind != crate::Kind::Engine {
        return Err(broken());
    }
    let mut run = EngineRun::at_rest(plan, &state.values)?;
    for count in &mut run.placed {
        let word = input.word32().ok_or_else(broken)?;
        *count = i32::try_from(word).map_err(|_| broken())?;
    }
    let length = input.word32().ok_or_else(broken)?;
    let bytes = input.take(length as usize).ok_or_else(broken)?;
    run.beginning = beginning;
    run.engine.restore(bytes).map_err(|error| error.to_string())?;
    Ok(run)
}

fn read_simulation(
    plan: &Plan,
    state: &State,
    input: &mut Reader<'_>,
) -> Result<SimulationRun, String> {
    if plan.bundle.kind != crate::Kind::Simulation {
        return Err(broken());
    }
    // The steps must match the time reached, so that forged bytes cannot demand a longer replay than the run.
    let reached = due(plan, state.time_s - state.start_s);
    let steps = input.word64().filter(|steps| *steps == reached).ok_or_else(broken)?;
    if steps > MOST_STEPS {
        return Err(format!("restoring the state would repeat {steps} steps, which are too many"));
    }
    let count = input.word32().ok_or_else(broken)?;
    let mut journal = Vec::new();
    for _ in 0..count {
        let entry = read_entry(plan, input).ok_or_else(broken)?;
        if journal.last().is_some_and(|last: &Entry| last.step > entry.step) {
            return Err(broken());
        }
        journal.push(entry);
    }
    SimulationRun::replay(plan, &state.values, steps, &journal)
}

fn read_entry(plan: &Plan, input: &mut Reader<'_>) -> Option<Entry> {
    let entry = Entry { step: input.word64()?, variable: input.word32()?, value: input.number()? };
    let variable = plan.table.variables.get(entry.variable as usize)?;
    let is_input = variable.causality == crate::Causality::Input;
    let within = variable.range.is_none_or(|[least, most]| (least..=most).contains(&entry.value));
    (is_input && within).then_some(entry)
}

fn broken() -> String {
    "the bytes are not a state that this FMU has serialised".to_owned()
}
