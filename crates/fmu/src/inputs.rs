//! The inputs of an FMU: what a master sets at each communication point.

use fenderline_contact::number::bounded;
use fenderline_contact::{BodyState, Wrench};
use fenderline_sim::order::{Arguments, OrderName, Value};
use fenderline_sim::{BodySetup, Setup};

use crate::axes::earth_fixed;
use crate::input::{Input, LoadComponent, StateComponent};
use crate::table::{Causality, Class, StandsFor, Table, Variable};
use crate::unit::Unit;

/// The largest force (N) or moment (N·m) that the engine takes.
const LARGEST_LOAD: f64 = 1e15;

struct Row<'a> {
    name: String,
    description: &'a str,
    unit: Unit,
    start: f64,
    range: Option<[f64; 2]>,
    input: Input,
}

fn add(table: &mut Table, row: Row<'_>) -> usize {
    let class = match row.input {
        Input::ExternalControl(_) | Input::ExternalTugControl(_) | Input::TugPulls(_) => {
            Class::Boolean
        }
        Input::Placed(_) => Class::Integer,
        Input::State { .. }
        | Input::Load { .. }
        | Input::Rudder(_)
        | Input::Engine(_)
        | Input::Thruster(..)
        | Input::AzimuthPower(..)
        | Input::AzimuthDirection(..)
        | Input::TugForce(_)
        | Input::TugDirection(_) => Class::Real,
    };
    table.add(Variable {
        name: row.name,
        description: row.description.to_owned(),
        unit: row.unit,
        class,
        causality: Causality::Input,
        start: row.start,
        range: row.range,
        stands_for: StandsFor::Input(row.input),
    })
}

/// Adds the inputs of an engine FMU: states and loads of the floating bodies.
pub(crate) fn add_states(table: &mut Table, setup: &Setup) {
    let states = setup.initial_states();
    for (body, (of, state)) in setup.bodies.iter().zip(&states).enumerate() {
        if of.mass.is_none() {
            continue;
        }
        let name = &of.name;
        let mut state_row = |field: &str, description, unit, component, start| {
            let input = Input::State { body, component };
            let name = format!("body.{name}.{field}");
            add(table, Row { name, description, unit, start, range: None, input })
        };
        let (x, v) = (state.position_m, state.velocity_mps);
        let (m, mps) = (Unit::Metre, Unit::MetrePerSecond);
        let place = [
            state_row(
                "x_m",
                "north coordinate of the body's centre of gravity",
                m,
                StateComponent::X,
                x.x,
            ),
            state_row(
                "y_m",
                "east coordinate of the body's centre of gravity",
                m,
                StateComponent::Y,
                x.y,
            ),
        ];
        let what = "heading, clockwise from north";
        let heading = state_row(
            "heading_rad",
            what,
            Unit::Radian,
            StateComponent::Heading,
            state.heading_rad,
        );
        let north = "velocity of the body's centre of gravity to the north; forward if host.body_fixed is true";
        let east = "velocity of the body's centre of gravity to the east; to starboard if host.body_fixed is true";
        let velocity = [
            state_row("velocity_x_mps", north, mps, StateComponent::VelocityX, v.x),
            state_row("velocity_y_mps", east, mps, StateComponent::VelocityY, v.y),
        ];
        let (what, unit) =
            ("rate of turn of the body, positive to starboard", Unit::RadianPerSecond);
        let turn = state_row("r_radps", what, unit, StateComponent::YawRate, state.yaw_rate_radps);
        table.group("LinearDisplacement", format!("{name}.position"), &place);
        table.group("AngularDisplacement", format!("{name}.heading"), &[heading]);
        table.group("LinearVelocity", format!("{name}.velocity"), &velocity);
        table.group("AngularVelocity", format!("{name}.rate_of_turn"), &[turn]);
        let what = "counter of repositionings. Increase this counter when the master sets the body to a new \
                    position instead of moving it there: the body's state in this step is then the new \
                    position, the body's contacts start anew, and overlapping bodies are pushed apart slowly";
        let input = Input::Placed(body);
        let range = Some([0.0, f64::from(i32::MAX)]);
        let name_of = format!("body.{name}.reposition_count");
        let row =
            Row { name: name_of, description: what, unit: Unit::One, start: 0.0, range, input };
        add(table, row);
        let about = "all forces on the body other than contact; read if host.loads_connected is \
            true or host.following is false";
        add_loads(table, (body, of), "load", about);
    }
}

/// Adds the inputs of a simulation FMU for further forces on the floating bodies.
pub(crate) fn add_extra_loads(table: &mut Table, setup: &Setup) {
    for (body, of) in setup.bodies.iter().enumerate() {
        if of.mass.is_some() {
            add_loads(
                table,
                (body, of),
                "external",
                "acts on the body in addition to the scenario's loads",
            );
        }
    }
}

fn add_loads(table: &mut Table, (body, of): (usize, &BodySetup), stem: &str, about: &str) {
    let name = &of.name;
    let fields = [
        (
            LoadComponent::X,
            "x_n",
            Unit::Newton,
            "force to the north at the body's centre of gravity",
        ),
        (
            LoadComponent::Y,
            "y_n",
            Unit::Newton,
            "force to the east at the body's centre of gravity",
        ),
        (
            LoadComponent::Moment,
            "moment_nm",
            Unit::NewtonMetre,
            "moment on the body about the vertical, positive to starboard",
        ),
    ];
    let places = fields.map(|(component, field, unit, what)| {
        add(
            table,
            Row {
                name: format!("body.{name}.{stem}_{field}"),
                description: &format!("{what}: {about}"),
                unit,
                start: 0.0,
                range: Some([-LARGEST_LOAD, LARGEST_LOAD]),
                input: Input::Load { body, component },
            },
        )
    });
    table.group("Force", format!("{name}.{stem}"), &places[..2]);
    table.group("Torque", format!("{name}.{stem}_moment"), &places[2..]);
}

/// Adds the inputs that control vessels and tugs.
pub(crate) fn add_controls(table: &mut Table, setup: &Setup) {
    let limits = |order: OrderName, argument| Some(order.limits(argument));
    let (one, radian) = (Unit::One, Unit::Radian);
    for (index, vessel) in setup.world.vessels.iter().enumerate() {
        let body = &setup.bodies[vessel.body].name;
        let mut row = |field: &str, description, unit, range, start, input| {
            let name = format!("vessel.{body}.{field}");
            add(table, Row { name, description, unit, start, range, input });
        };
        let what = "true: the vessel's inputs in this list control her; false: the scenario's orders and pilots do";
        row("external_control", what, one, None, 0.0, Input::ExternalControl(index));
        // Without a rudder and an engine these inputs would have no effect.
        if OrderName::Rudder.spec().gear.is_on(index, setup) {
            let what = "rudder angle ordered; a positive angle turns the ship to starboard";
            let at_start = vessel.rudder.value;
            row(
                "rudder_order_rad",
                what,
                radian,
                limits(OrderName::Rudder, "angle"),
                at_start,
                Input::Rudder(index),
            );
            let what = "revolutions ordered over full revolutions, positive ahead";
            let at_start = bounded(vessel.shaft.value / vessel.shaft.stop, -1.0, 1.0);
            let at_start = if at_start.is_finite() { at_start } else { 0.0 };
            row(
                "engine_order",
                what,
                one,
                limits(OrderName::Engine, "share"),
                at_start,
                Input::Engine(index),
            );
        }
        for (unit, thruster) in vessel.thrusters.iter().enumerate() {
            let field = format!("thruster.{}.order", thruster.name);
            let what =
                "thrust of the thruster ordered over its largest thrust, positive to starboard";
            row(
                &field,
                what,
                one,
                limits(OrderName::Thruster, "power"),
                0.0,
                Input::Thruster(index, unit),
            );
        }
        for (unit, azimuth) in vessel.azimuths.iter().enumerate() {
            let field = format!("azimuth.{}.power_order", azimuth.name);
            let range = limits(OrderName::Azimuth, "power");
            let what = "thrust of the azimuth unit ordered over its thrust at rest and full power";
            row(&field, what, one, range, 0.0, Input::AzimuthPower(index, unit));
            let field = format!("azimuth.{}.direction_order_rad", azimuth.name);
            let what = "direction ordered for the azimuth unit's thrust, from the bow, positive to starboard";
            let range = limits(OrderName::Azimuth, "direction");
            row(&field, what, radian, range, 0.0, Input::AzimuthDirection(index, unit));
        }
    }
    for (index, tug) in setup.world.tugs.iter().enumerate() {
        let mut row = |field: &str, description, unit, range, input| {
            let name = format!("tug.{}.{field}", tug.tug.name);
            add(table, Row { name, description, unit, start: 0.0, range, input });
        };
        let what =
            "true: the tug's inputs in this list control her; false: the scenario's orders do";
        row("external_control", what, one, None, Input::ExternalTugControl(index));
        let what = "force ordered from the tug; at 0 she stands by";
        let range = limits(OrderName::Push, "force");
        row("force_order_n", what, Unit::Newton, range, Input::TugForce(index));
        let what =
            "direction ordered for the tug's force, from the ship's bow, positive to starboard";
        let range = limits(OrderName::Push, "direction");
        row("direction_order_rad", what, radian, range, Input::TugDirection(index));
        let what = "true: the tug pulls on her line; false: the tug pushes";
        row("pull", what, one, None, Input::TugPulls(index));
    }
}

/// The table of an FMU's variables, with the values of the inputs among the variables.
pub(crate) struct Inputs<'a> {
    pub(crate) table: &'a Table,
    pub(crate) values: &'a [f64],
}

impl Inputs<'_> {
    fn all(&self) -> impl Iterator<Item = (Input, f64)> {
        self.table.variables.iter().zip(self.values).filter_map(|(variable, &value)| match variable
            .stands_for
        {
            StandsFor::Input(input) => Some((input, value)),
            _ => None,
        })
    }

    /// # Panics
    /// Panics if the table of variables lacks the input.
    fn value(&self, wanted: Input) -> f64 {
        let found = self.all().find(|(input, _)| *input == wanted);
        found.unwrap_or_else(|| panic!("the table has no {wanted:?}")).1
    }

    fn is_on(&self, wanted: Input) -> bool {
        self.value(wanted) != 0.0
    }

    /// Writes the states that the inputs give into `states`; fixed bodies have no inputs and keep their states.
    pub(crate) fn states(&self, body_fixed: bool, states: &mut [BodyState]) {
        for (input, value) in self.all() {
            let Input::State { body, component } = input else { continue };
            let state = &mut states[body];
            match component {
                StateComponent::X => state.position_m.x = value,
                StateComponent::Y => state.position_m.y = value,
                StateComponent::Heading => state.heading_rad = value,
                StateComponent::VelocityX => state.velocity_mps.x = value,
                StateComponent::VelocityY => state.velocity_mps.y = value,
                StateComponent::YawRate => state.yaw_rate_radps = value,
            }
        }
        if !body_fixed {
            return;
        }
        for (input, _) in self.all() {
            // One input of each floating body.
            if let Input::State { body, component: StateComponent::Heading } = input {
                states[body].velocity_mps = earth_fixed(&states[body], states[body].velocity_mps);
            }
        }
    }

    /// The repositioning counters.
    pub(crate) fn placed(&self) -> impl Iterator<Item = (usize, i32)> {
        self.all().filter_map(|(input, value)| match input {
            Input::Placed(body) => Some((body, value as i32)),
            _ => None,
        })
    }

    /// Loads of all bodies.
    pub(crate) fn loads(&self, bodies: usize) -> Vec<Wrench> {
        let mut loads = vec![Wrench::default(); bodies];
        for (input, value) in self.all() {
            let Input::Load { body, component } = input else { continue };
            match component {
                LoadComponent::X => loads[body].force_n.x = value,
                LoadComponent::Y => loads[body].force_n.y = value,
                LoadComponent::Moment => loads[body].moment_nm = value,
            }
        }
        loads
    }

    /// The orders that follow from inputs that have changed since `before`.
    pub(crate) fn orders(&self, before: &Inputs<'_>) -> Vec<InputOrder> {
        let changed = |input: Input| self.value(input).to_bits() != before.value(input).to_bits();
        let mut orders = Vec::new();
        for (input, _) in self.all() {
            let Some((control, parts, order)) = self.order_of(input) else { continue };
            let is_new = !before.is_on(control) || parts.into_iter().any(changed);
            if self.is_on(control) && is_new {
                orders.push(order);
            }
        }
        orders
    }

    /// The order that an input gives, with the input that says whether the master is in control, and with the inputs
    /// whose change gives the order anew. The result is `None` for an input that gives no order by itself.
    fn order_of(&self, input: Input) -> Option<(Input, Vec<Input>, InputOrder)> {
        let none = Arguments::new();
        let of_vessel = |vessel, order, arguments| {
            let order = InputOrder { order, target: vessel, arguments };
            (Input::ExternalControl(vessel), vec![input], order)
        };
        let value = self.value(input);
        let named = |index| Arguments::new().with("name", Value::Index(index));
        Some(match input {
            Input::ExternalControl(vessel) => {
                let order = InputOrder { order: OrderName::Hands, target: vessel, arguments: none };
                (input, vec![], order)
            }
            Input::Rudder(vessel) => {
                of_vessel(vessel, OrderName::Rudder, none.number("angle", value))
            }
            Input::Engine(vessel) => {
                of_vessel(vessel, OrderName::Engine, none.number("share", value))
            }
            Input::Thruster(vessel, index) => {
                of_vessel(vessel, OrderName::Thruster, named(index).number("power", value))
            }
            Input::AzimuthPower(vessel, index) => {
                of_vessel(vessel, OrderName::Azimuth, named(index).number("power", value))
            }
            Input::AzimuthDirection(vessel, index) => {
                of_vessel(vessel, OrderName::Azimuth, named(index).number("direction", value))
            }
            Input::TugForce(tug) => {
                let parts =
                    vec![Input::TugForce(tug), Input::TugDirection(tug), Input::TugPulls(tug)];
                (Input::ExternalTugControl(tug), parts, self.tug_order(tug))
            }
            // These inputs are part of the order that the force gives.
            Input::ExternalTugControl(_) | Input::TugDirection(_) | Input::TugPulls(_) => {
                return None;
            }
            Input::State { .. } | Input::Placed(_) | Input::Load { .. } => return None,
        })
    }

    fn tug_order(&self, tug: usize) -> InputOrder {
        let force_n = self.value(Input::TugForce(tug));
        let direction_rad = self.value(Input::TugDirection(tug));
        let numbers = Arguments::new().number("force", force_n).number("direction", direction_rad);
        let (order, arguments) = match (force_n == 0.0, self.is_on(Input::TugPulls(tug))) {
            (true, _) => (OrderName::StandBy, Arguments::new()),
            (_, true) => (OrderName::Pull, numbers),
            (_, false) => (OrderName::Push, numbers),
        };
        InputOrder { order, target: tug, arguments }
    }
}

/// An order to a vessel or tug that a master gives by inputs.
#[derive(Clone, Debug)]
pub(crate) struct InputOrder {
    pub(crate) order: OrderName,
    /// Index of the vessel or tug that gets the order.
    pub(crate) target: usize,
    pub(crate) arguments: Arguments,
}
