//! Controls: numbers that hold until they are set again. Only their names are defined here; orders and limits come from
//! the table in `fenderline_sim`.

use fenderline_sim::order::{Arguments, OrderName, Target, Value};
use fenderline_sim::{Order, OrderError, Setup};

/// How a control's value becomes an order.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    /// The value is this argument of an order; `part` is the thruster or azimuth unit.
    Argument { order: OrderName, argument: &'static str, part: Option<usize> },
    /// The force of a vector tug, square to the ship: a push where it is positive, a pull where it is negative.
    TugForce,
}

/// A control of a set-up.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Control {
    /// The user's name for it: `ship.rudder_rad`.
    pub(crate) name: String,
    target: Target,
    kind: Kind,
}

/// All controls of a set-up: of vessels, then of tugs.
pub(crate) fn controls(setup: &Setup) -> Vec<Control> {
    let world = &setup.world;
    let mut all = Vec::new();
    for (index, vessel) in world.vessels.iter().enumerate() {
        let ship = &setup.bodies[vessel.body].name;
        let target = Target::Vessel(index);
        let mut add = |name: String, order, argument, part| {
            let kind = Kind::Argument { order, argument, part };
            all.push(Control { name: format!("{ship}.{name}"), target, kind });
        };
        if OrderName::Rudder.spec().gear.is_on(index, setup) {
            add("rudder_rad".to_owned(), OrderName::Rudder, "angle", None);
            add("engine".to_owned(), OrderName::Engine, "share", None);
        }
        for (part, of) in vessel.thrusters.iter().enumerate() {
            let name = format!("thruster.{}", of.name);
            add(name, OrderName::Thruster, "power", Some(part));
        }
        for (part, of) in vessel.azimuths.iter().enumerate() {
            let name = format!("azimuth.{}", of.name);
            add(format!("{name}.power"), OrderName::Azimuth, "power", Some(part));
            add(format!("{name}.direction_rad"), OrderName::Azimuth, "direction", Some(part));
        }
    }
    for (tug, of) in world.tugs.iter().enumerate() {
        let name = format!("tug.{}.force_n", of.tug.name);
        all.push(Control { name, target: Target::Tug(tug), kind: Kind::TugForce });
    }
    all
}

impl Control {
    /// The smallest and the largest value.
    pub(crate) fn limits(&self) -> [f64; 2] {
        match self.kind {
            Kind::Argument { order, argument, .. } => order.limits(argument),
            Kind::TugForce => {
                let [_, most_n] = OrderName::Push.limits("force");
                [-most_n, most_n]
            }
        }
    }

    /// The order that sets this control to a value at a time.
    ///
    /// # Errors
    /// A value out of its limits.
    pub(crate) fn order(&self, value: f64, at_s: f64, setup: &Setup) -> Result<Order, OrderError> {
        let none = Arguments::new();
        let (order, arguments) = match self.kind {
            Kind::Argument { order, argument, part } => {
                let named = part.map_or(none.clone(), |part| none.with("name", Value::Index(part)));
                (order, named.number(argument, value))
            }
            Kind::TugForce if value > 0.0 => (OrderName::Push, none.number("force", value)),
            Kind::TugForce if value < 0.0 => (OrderName::Pull, none.number("force", -value)),
            Kind::TugForce => (OrderName::StandBy, none),
        };
        let (Target::Vessel(target) | Target::Tug(target) | Target::Line(target)) = self.target;
        Ok(Order { at_s, action: order.build(target, &arguments, setup)? })
    }
}
