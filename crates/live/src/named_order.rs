//! An order from the table of orders, with names of the scenario, as pages send orders and recordings store them.

use fenderline_contact::vec2;
use fenderline_sim::order::{
    Absent, Argument, ArgumentKind, Arguments, Named, OrderName, TargetKind, Value,
};
use fenderline_sim::{Action, Setup};
use serde_json::{Map, Value as Json, json};

use crate::refusal::Refusal;

/// An order with names of the scenario in place of indices. The JSON of an order is
/// `{"do": WORD, TARGET: NAME, ARGUMENT_UNIT: VALUE, …}` with the words of the table in `fenderline_sim`. An argument
/// that is `null` or missing takes its default.
#[derive(Clone, Debug, PartialEq)]
pub struct NamedOrder {
    /// The order.
    pub order: OrderName,
    /// Name of the vessel, tug, line or anchor that gets the order.
    pub to: String,
    /// The arguments of the order that have given values.
    given: Vec<(&'static Argument, Given)>,
}

/// The value that an order gives to an argument.
#[derive(Clone, Debug, PartialEq)]
enum Given {
    Number(f64),
    Place([f64; 2]),
    Name(String),
}

impl NamedOrder {
    /// An order without arguments.
    #[must_use]
    pub fn new(order: OrderName, to: &str) -> NamedOrder {
        NamedOrder { order, to: to.to_owned(), given: Vec::new() }
    }

    /// Adds a number. `name` is the name of the argument in the table of orders.
    ///
    /// # Panics
    /// Panics if the order has no argument of this name.
    #[must_use]
    pub fn number(self, name: &str, value: f64) -> NamedOrder {
        self.with(name, Given::Number(value))
    }

    /// Adds a position. `name` is the name of the argument in the table of orders.
    ///
    /// # Panics
    /// Panics if the order has no argument of this name.
    #[must_use]
    pub fn place(self, name: &str, at_m: [f64; 2]) -> NamedOrder {
        self.with(name, Given::Place(at_m))
    }

    /// Adds a name. `name` is the name of the argument in the table of orders.
    ///
    /// # Panics
    /// Panics if the order has no argument of this name.
    #[must_use]
    pub fn name(self, name: &str, value: &str) -> NamedOrder {
        self.with(name, Given::Name(value.to_owned()))
    }

    fn with(mut self, name: &str, value: Given) -> NamedOrder {
        let argument = self.order.spec().argument(name);
        let argument =
            argument.unwrap_or_else(|| panic!("{:?} has no argument {name}", self.order));
        self.given.push((argument, value));
        self
    }

    /// Reads an order from its JSON without the word of the order.
    ///
    /// # Errors
    /// Fails for a field that is missing, unknown or of the wrong kind.
    pub(crate) fn from_json(
        order: OrderName,
        map: Map<String, Json>,
    ) -> Result<NamedOrder, String> {
        let spec = order.spec();
        let mut to = None;
        let mut given: Vec<(&Argument, Given)> = Vec::new();
        for (field, value) in map {
            if field == spec.target.word() {
                let Json::String(name) = value else {
                    return Err(format!("invalid type: the value of `{field}` must be a name"));
                };
                to = Some(name);
                continue;
            }
            let argument = spec.arguments.iter().find(|argument| argument.field() == field);
            let argument = argument.ok_or_else(|| {
                let known: Vec<String> = spec.arguments.iter().map(Argument::field).collect();
                format!("unknown field `{field}`, `{}` has {known:?}", spec.word)
            })?;
            if let Some(value) = Given::from_json(argument, &field, &value)? {
                given.push((argument, value));
            }
        }
        let to = to.ok_or_else(|| format!("missing field `{}`", spec.target.word()))?;
        let is_given = |name: &str| given.iter().any(|(argument, _)| argument.name == name);
        let missing = spec
            .arguments
            .iter()
            .find(|argument| argument.absent == Absent::Refused && !is_given(argument.name));
        if let Some(missing) = missing {
            return Err(format!("missing field `{}`", missing.field()));
        }
        // Keeps the arguments in the order of the table, so that equal orders have equal texts.
        given.sort_by_key(|(argument, _)| {
            spec.arguments.iter().position(|other| other.name == argument.name)
        });
        Ok(NamedOrder { order, to, given })
    }

    /// Writes the order as JSON.
    pub(crate) fn to_json(&self) -> Map<String, Json> {
        let spec = self.order.spec();
        let mut map = Map::new();
        map.insert("do".to_owned(), json!(spec.word));
        map.insert(spec.target.word().to_owned(), json!(self.to));
        for (argument, value) in &self.given {
            let value = match value {
                Given::Number(number) => json!(number),
                Given::Place(at_m) => json!(at_m),
                Given::Name(name) => json!(name),
            };
            map.insert(argument.field(), value);
        }
        map
    }

    /// Turns the order into an action of the simulation, and checks it.
    ///
    /// # Errors
    /// Fails for a name that does not exist, or for an order that the simulation refuses.
    pub fn resolve(&self, setup: &Setup) -> Result<Action, Refusal> {
        let world = &setup.world;
        let (kind, name) = (self.order.spec().target, self.to.as_str());
        let target = match kind {
            TargetKind::Vessel => {
                let is_her = |body: usize| setup.bodies[body].name == name;
                world.vessels.iter().position(|vessel| is_her(vessel.body))
            }
            TargetKind::Tug => world.tugs.iter().position(|tug| tug.tug.name == name),
            TargetKind::Line => world.lines.iter().position(|line| line.line.name == name),
            TargetKind::Anchor => world.anchors.iter().position(|own| own.gear.name == name),
        };
        let target = target
            .ok_or_else(|| Refusal::new(format_args!("there is no {} `{name}`", kind.word())))?;
        let mut arguments = Arguments::new();
        for (argument, given) in &self.given {
            let value = match given {
                Given::Number(number) => Value::Number(*number),
                Given::Place([along_m, across_m]) => Value::Place(vec2(*along_m, *across_m)),
                Given::Name(name) => Value::Index(self.index(argument, name, target, setup)?),
            };
            arguments = arguments.with(argument.name, value);
        }
        self.order.build(target, &arguments, setup).map_err(Refusal::new)
    }

    fn index(
        &self,
        argument: &Argument,
        name: &str,
        target: usize,
        setup: &Setup,
    ) -> Result<usize, Refusal> {
        let world = &setup.world;
        let vessel = || world.vessels.get(target);
        let ArgumentKind::Name(named) = argument.kind else {
            return Err(Refusal::new(format_args!("`{}` is not a name", argument.name)));
        };
        let index = match named {
            Named::Thruster => {
                vessel().and_then(|v| v.thrusters.iter().position(|own| own.name == name))
            }
            Named::AzimuthUnit => {
                vessel().and_then(|v| v.azimuths.iter().position(|own| own.name == name))
            }
            Named::Body => setup.bodies.iter().position(|body| body.name == name),
            Named::Line => world.lines.iter().position(|line| line.line.name == name),
            Named::Bollard => world.bollards.iter().position(|bollard| bollard.name == name),
        };
        index.ok_or_else(|| {
            Refusal::new(match named {
                Named::Thruster | Named::AzimuthUnit => {
                    format!("`{}` has no {} `{name}`", self.to, argument.meaning)
                }
                Named::Body | Named::Line | Named::Bollard => {
                    format!("there is no {} `{name}`", argument.meaning)
                }
            })
        })
    }
}

impl Given {
    /// Reads the value of an argument; `None` for `null`.
    fn from_json(argument: &Argument, field: &str, value: &Json) -> Result<Option<Given>, String> {
        if value.is_null() && argument.absent != Absent::Refused {
            return Ok(None);
        }
        let given = match argument.kind {
            ArgumentKind::Number { .. } => value.as_f64().map(Given::Number),
            ArgumentKind::Place { .. } => match value.as_array().map(Vec::as_slice) {
                Some([along, across]) => {
                    along.as_f64().zip(across.as_f64()).map(|(x, y)| Given::Place([x, y]))
                }
                _ => None,
            },
            ArgumentKind::Name(_) => value.as_str().map(|name| Given::Name(name.to_owned())),
        };
        let expected = match argument.kind {
            ArgumentKind::Number { .. } => "a number",
            ArgumentKind::Place { .. } => "two numbers",
            ArgumentKind::Name(_) => "a name",
        };
        let kind = || format!("invalid type: `{field}` is {expected}, but `{value}` was given");
        given.ok_or_else(kind).map(Some)
    }
}
