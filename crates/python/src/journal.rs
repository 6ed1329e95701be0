//! The inputs that a simulation has got, in the order in which it got them. A new simulation with the same inputs gives
//! the same bits; so a simulation is pickled as its inputs.

use fenderline_contact::Wrench;

/// An input that a simulation gets before a step.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Input {
    /// A control, by its number, and its new value.
    Control(usize, f64),
    /// The number of a body, and the new external wrench on this body.
    External(usize, Wrench),
    /// An order, as text with the keys of a scenario.
    Order(String),
}

/// All inputs since the simulation's start.
#[derive(Clone, Debug, Default)]
pub(crate) struct Journal {
    /// Number of steps before each input, and the input itself.
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

    /// Whether the given external wrenches differ from the present ones.
    pub(crate) fn differs(&self, wrenches: &[Wrench]) -> bool {
        self.external.iter().zip(wrenches).any(|(old, new)| bits(old) != bits(new))
    }

    /// Adds the external wrenches that have changed to the inputs.
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
