//! Arguments of an order, with their names in the table of orders.

use fenderline_contact::Vec2;

use super::error::OrderError;
use super::table::{Absent, ArgumentKind, OrderName};
use crate::setup::Setup;

/// The value of an argument of an order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value {
    /// A number in its SI unit.
    Number(f64),
    /// Two coordinates (m).
    Place(Vec2),
    /// The index of a named object.
    Index(usize),
}

/// The arguments of an order, with their names in the table of orders. An argument that is absent has its default
/// value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Arguments(Vec<(&'static str, Value)>);

impl Arguments {
    /// No arguments.
    #[must_use]
    pub fn new() -> Arguments {
        Arguments::default()
    }

    /// Adds an argument.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: Value) -> Arguments {
        self.0.push((name, value));
        self
    }

    /// Adds a number.
    #[must_use]
    pub fn number(self, name: &'static str, value: f64) -> Arguments {
        self.with(name, Value::Number(value))
    }

    /// All arguments with their names.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, Value)> {
        self.0.iter().copied()
    }

    /// The value of the argument of this name; `None` if it is not given.
    #[must_use]
    pub fn get(&self, name: &str) -> Option<Value> {
        self.iter().find(|(given, _)| *given == name).map(|(_, value)| value)
    }
}

/// Reads the arguments given for one order by their names.
pub(super) struct Given<'a> {
    order: OrderName,
    arguments: &'a Arguments,
}

impl<'a> Given<'a> {
    /// The arguments, checked against the order's row in the table.
    ///
    /// # Errors
    /// Returns the first argument that the order does not have, or whose value has the wrong kind.
    pub(super) fn new(order: OrderName, arguments: &'a Arguments) -> Result<Given<'a>, OrderError> {
        for (name, value) in arguments.iter() {
            let fits = order.spec().argument(name).is_some_and(|argument| {
                matches!(
                    (argument.kind, value),
                    (ArgumentKind::Number { .. }, Value::Number(_))
                        | (ArgumentKind::Place { .. }, Value::Place(_))
                        | (ArgumentKind::Name(_), Value::Index(_))
                )
            });
            if !fits {
                return Err(OrderError::Unknown { order, argument: name.to_owned() });
            }
        }
        Ok(Given { order, arguments })
    }

    fn missing(&self, argument: &'static str) -> OrderError {
        OrderError::Missing { order: self.order, argument }
    }

    pub(super) fn optional_number(&self, name: &str) -> Option<f64> {
        match (self.arguments.get(name), self.order.spec().argument(name)?.absent) {
            (Some(Value::Number(value)), _) | (None, Absent::Is(value, _)) => Some(value),
            _ => None,
        }
    }

    pub(super) fn number(&self, name: &'static str) -> Result<f64, OrderError> {
        self.optional_number(name).ok_or_else(|| self.missing(name))
    }

    pub(super) fn place(&self, name: &'static str) -> Result<Vec2, OrderError> {
        match self.arguments.get(name) {
            Some(Value::Place(at_m)) => Ok(at_m),
            _ => Err(self.missing(name)),
        }
    }

    pub(super) fn index(&self, name: &'static str) -> Result<usize, OrderError> {
        match self.arguments.get(name) {
            Some(Value::Index(index)) => Ok(index),
            _ => Err(self.missing(name)),
        }
    }

    pub(super) fn tug_force(&self, tug: usize, setup: &Setup) -> Result<(f64, f64), OrderError> {
        let square_rad = || setup.world.tugs.get(tug).map(|tug| tug.square_push_rad());
        let square_rad = match self.order {
            OrderName::Pull => square_rad().map(|push_rad| -push_rad),
            _ => square_rad(),
        };
        let direction_rad = self.optional_number("direction").or(square_rad);
        Ok((self.number("force")?, direction_rad.ok_or_else(|| self.missing("direction"))?))
    }
}
