//! The table of an FMU's variables: how the model description shows them, and the quantities for which they stand.

use fenderline_sim::Setup;

use crate::input::Input;
use crate::unit::Unit;
use crate::view::View;

/// What an FMU is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The contact engine: its inputs are states of bodies, its outputs are wrenches.
    Engine,
    /// The whole scenario: its inputs are controls, its outputs are states.
    Simulation,
}

impl Kind {
    /// Name of the kind of FMU on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Kind::Engine => "engine",
            Kind::Simulation => "simulation",
        }
    }

    pub(crate) fn of_name(name: &str) -> Option<Kind> {
        [Kind::Engine, Kind::Simulation].into_iter().find(|kind| kind.name() == name)
    }
}

/// Type of a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Class {
    /// A double.
    Real,
    /// 32 bits.
    Integer,
    /// A switch.
    Boolean,
    /// One of several named items, each of which has a number.
    Enumeration,
}

/// Names of values.
#[derive(Debug)]
pub(crate) struct Enumeration {
    pub(crate) name: &'static str,
    pub(crate) description: &'static str,
    /// Names and descriptions of the items with the numbers 1, 2 and so on.
    pub(crate) items: &'static [(&'static str, &'static str)],
}

/// The ways in which a co-simulation host may integrate the motion of its bodies.
pub(crate) static INTEGRATION: Enumeration = Enumeration {
    name: "Integration",
    description: "how the host moves its bodies",
    items: &[
        (
            "forward_euler",
            "the host first moves positions by the old velocities, then changes velocities",
        ),
        (
            "semi_implicit",
            "the host first changes velocities, then moves positions by the new velocities",
        ),
    ],
};

/// The number of the item `forward_euler` of [`INTEGRATION`].
pub(crate) const FORWARD_EULER: u32 = 1;

/// Who sets a variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Causality {
    /// Time.
    Independent,
    /// The master sets the variable, until initialization ends.
    Parameter,
    /// The master sets the variable, at any communication point.
    Input,
    /// The FMU.
    Output,
}

/// One variable. The value reference of a variable is its index in the table.
#[derive(Clone, Debug)]
pub struct Variable {
    /// Unique name.
    pub name: String,
    /// What the variable is.
    pub description: String,
    /// Unit.
    pub unit: Unit,
    /// Type.
    pub class: Class,
    /// Who sets the variable.
    pub causality: Causality,
    /// Start value of the variable; 0 for outputs, which have no start value in the model description.
    pub start: f64,
    /// Smallest and largest value that the variable may have.
    pub range: Option<[f64; 2]>,
    pub(crate) stands_for: StandsFor,
}

/// What a variable of the FMU stands for.
#[derive(Clone, Copy, Debug)]
pub(crate) enum StandsFor {
    Time,
    Setting(Setting),
    Parameter(Parameter),
    Input(Input),
    Output(Output),
}

/// Settings by which an engine FMU knows how its host works.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Setting {
    /// Whether the FMU runs in co-simulation: the engine follows a host that moves its bodies itself.
    Following,
    /// Number of steps by which the input states are old.
    DelaySteps,
    /// Number of steps at the start without a wrench.
    SkipSteps,
    /// How the host integrates, as an item of [`INTEGRATION`].
    Integration,
    /// Whether the load inputs are connected; otherwise the engine estimates the loads.
    TellsLoads,
    /// Whether vectors are in the bodies' axes.
    BodyFixed,
    /// The communication step.
    StepS,
}

/// A number of the scenario's set-up that a parameter sets.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Parameter {
    pub(crate) of: usize,
    pub(crate) write: fn(&mut Setup, usize, f64),
}

/// A number that an output reads from a run.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Output {
    pub(crate) of: [usize; 2],
    pub(crate) read: fn(&View<'_>, [usize; 2]) -> f64,
}

/// All variables of an FMU.
#[derive(Clone, Debug)]
pub struct Table {
    /// The variables of the FMU, in the order of their value references.
    pub variables: Vec<Variable>,
    /// Groups of variables that belong together, for the Open Simulation Platform.
    pub(crate) groups: Vec<Group>,
}

/// A group of variables that are a vector or an angle, as the Open Simulation Platform groups them.
#[derive(Clone, Debug)]
pub(crate) struct Group {
    pub(crate) name: String,
    /// Element of an `OspModelDescription.xml`.
    pub(crate) kind: &'static str,
    pub(crate) members: Vec<usize>,
}

impl Variable {
    /// The names of the variable's values, if the variable is an enumeration.
    pub(crate) fn enumeration(&self) -> Option<&'static Enumeration> {
        match self.stands_for {
            StandsFor::Setting(Setting::Integration) => Some(&INTEGRATION),
            _ => None,
        }
    }
}

impl Table {
    /// A table of variables with time as its only variable.
    pub(crate) fn new() -> Table {
        let mut table = Table { variables: Vec::new(), groups: Vec::new() };
        table.add(Variable {
            name: "time".into(),
            description: "current time".into(),
            unit: Unit::Second,
            class: Class::Real,
            causality: Causality::Independent,
            start: 0.0,
            range: None,
            stands_for: StandsFor::Time,
        });
        table
    }

    /// Adds a variable to the table and returns its index. Characters that are not allowed in names of variables are
    /// replaced, and a name that exists already gets a number.
    pub(crate) fn add(&mut self, mut variable: Variable) -> usize {
        let clean = |text: &str| text.replace(|c: char| c.is_control(), "_");
        let name = clean(&variable.name);
        let taken = |name: &str| self.variables.iter().any(|other| other.name == name);
        let numbered = (2..).map(|number| format!("{name}_{number}"));
        let mut names = core::iter::once(name.clone()).chain(numbered);
        variable.name = names.find(|name| !taken(name)).unwrap_or(name);
        variable.description = clean(&variable.description);
        self.variables.push(variable);
        self.variables.len() - 1
    }

    pub(crate) fn group(&mut self, kind: &'static str, name: String, members: &[usize]) {
        self.groups.push(Group { name, kind, members: members.to_vec() });
    }

    /// The start values.
    pub(crate) fn start_values(&self) -> Vec<f64> {
        self.variables.iter().map(|variable| variable.start).collect()
    }

    /// The value of a setting, from the values of an engine FMU's variables.
    ///
    /// # Panics
    /// Panics if the table is not that of an engine FMU.
    pub(crate) fn setting(&self, values: &[f64], wanted: Setting) -> f64 {
        let is = |v: &Variable| matches!(v.stands_for, StandsFor::Setting(s) if s == wanted);
        values[self.variables.iter().position(is).expect("an engine's table has all settings")]
    }

    /// The interface of the FMU as text, with all of its variables. Two FMUs whose interfaces have the same text are
    /// compatible.
    pub(crate) fn text(&self) -> String {
        let line = |v: &Variable| {
            let Variable { name, unit, class, causality, start, range, .. } = v;
            format!("{name}|{unit:?}|{class:?}|{causality:?}|{:016x}|{range:?}\n", start.to_bits())
        };
        self.variables.iter().map(line).collect()
    }
}
