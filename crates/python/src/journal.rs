//! The inputs of a simulation, in their order. The simulation and its inputs give the same bits again; a simulation is
//! pickled in this way.

use fenderline_contact::Wrench;

/// An input, before a step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Input {
    /// A control by number, and its new value.
    Control(usize, f64),
    /// A body by number, and the new external wrench on it.
    External(usize, Wrench),
    /// An order, as text of the scenario's keys.
    Order(String),
}

/// All inputs since the start.
#[derive(Clone, Debug, Default)]
pub(crate) struct Journal {
    /// Number of steps before the input, and the input.
    pub(crate) inputs: Vec<(u64, Input)>,
    /// The external wrenches now.
    pub(crate) external: Vec<Wrench>,
}

impl Journal {
    pub(crate) fn new(bodies: usize) -> Journal {
        Journal { inputs: Vec::new(), external: vec![Wrench::default(); bodies] }
    }

    pub(crate) fn add(&mut self, step: u64, input: Input) {
        self.inputs.push((step, input));
    }

    /// Whether these external wrenches differ from the present wrenches.
    pub(crate) fn differs(&self, wrenches: &[Wrench]) -> bool {
        self.external.iter().zip(wrenches).any(|(old, new)| bits(old) != bits(new))
    }

    /// Adds the external wrenches that have changed.
    pub(crate) fn add_external(&mut self, step: u64, wrenches: &[Wrench]) {
        for (body, (old, new)) in self.external.iter_mut().zip(wrenches).enumerate() {
            if bits(old) != bits(new) {
                *old = *new;
                self.inputs.push((step, Input::External(body, *new)));
            }
        }
    }
}

fn bits(wrench: &Wrench) -> [u64; 3] {
    [wrench.force_n.x, wrench.force_n.y, wrench.moment_nm].map(f64::to_bits)
}
