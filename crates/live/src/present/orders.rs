//! Writes orders into the scenario file, as tables `[[order]]`: the orders in force now, and the orders to come.

use fenderline_contact::number::greater;
use fenderline_sim::mooring::WinchOrder;
use fenderline_sim::order::{Argument, ArgumentKind, Frame, Named, Value};
use fenderline_sim::tug::TugOrder;
use fenderline_sim::{
    Action, LineAction, Setup, Simulation, Station, VesselAction, VesselSetup, VesselState,
};

use super::anchors;
use super::written::{place, quoted, rounded};

/// All orders of a scenario file that begins now.
pub(super) fn all(simulation: &Simulation) -> Vec<String> {
    let (setup, t_s) = (simulation.setup(), simulation.time_s());
    // Before the first step all orders are still to come.
    let has_begun = simulation.steps_taken() > 0;
    let mut now = Vec::new();
    for (index, state) in simulation.vessels().iter().enumerate() {
        let of = &setup.world.vessels[index];
        now.extend(vessel(state, of).into_iter().map(|action| Action::Vessel(index, action)));
    }
    for (index, tug) in simulation.tugs().iter().enumerate() {
        let order = tug.state.waiting.last().map_or(tug.state.order, |(_, order)| *order);
        let stands_by = order == TugOrder::StandBy;
        now.extend((!stands_by).then_some(Action::Tug(index, order)));
    }
    for (index, line) in simulation.lines().iter().enumerate() {
        if let (Some(bollard), Some(_)) = (line.bollard, line.sent) {
            now.push(Action::Line(index, LineAction::Send { bollard }));
        } else if line.line.is_some() && line.order != WinchOrder::Hold && !line.has_parted() {
            now.push(Action::Line(index, LineAction::Winch(line.order)));
        }
    }
    now.extend(anchors::orders(simulation));
    now.retain(|_| has_begun);
    let now = now.iter().map(|action| table(action, 0.0, setup));
    let is_lost = |action: &Action| match action {
        Action::Anchor(anchor, _) => anchors::is_lost(&simulation.anchors()[*anchor]),
        Action::Vessel(..) | Action::Tug(..) | Action::Line(..) => false,
    };
    let pending = simulation.pending_orders().iter().filter(|order| !is_lost(&order.action));
    let pending = pending.map(|order| table(&order.action, greater(order.at_s - t_s, 0.0), setup));
    now.chain(pending).collect()
}

/// The orders that set a vessel's controls and autopilots as they are now. The sequence of these orders is such that no
/// order undoes an earlier one.
fn vessel(state: &VesselState, of: &VesselSetup) -> Vec<VesselAction> {
    let (orders, pilots) = (&state.orders, &state.pilots);
    if let Some(assist) = &pilots.assist {
        return vec![VesselAction::Assist(assist.order)];
    }
    if let Some(station) = &pilots.station {
        let [surge_mps, sway_mps, _] = station.gains.fastest;
        return vec![VesselAction::Station(Station {
            position_m: station.position_m,
            heading_rad: station.heading_rad,
            fastest_mps: [surge_mps, sway_mps],
        })];
    }
    let mut all = Vec::new();
    for (unit, order) in orders.azimuths.iter().enumerate() {
        all.push(VesselAction::Azimuth {
            unit,
            power: Some(order.power),
            direction_rad: Some(order.direction_rad),
        });
    }
    for (index, &power) in orders.thrusters.iter().enumerate() {
        if power != 0.0 {
            all.push(VesselAction::Thruster(index, power));
        }
    }
    let has_propeller = of.ship.propulsion.is_some();
    match &pilots.course {
        Some(course) => all.push(VesselAction::Course(course.heading_rad)),
        None if has_propeller => all.push(VesselAction::Rudder(orders.rudder_rad)),
        None => {}
    }
    match &pilots.speed {
        Some(speed) => all.push(VesselAction::Speed(speed.speed_mps)),
        None if has_propeller => all.push(VesselAction::Engine(orders.shaft)),
        None => {}
    }
    all
}

/// Formats an order as an inline table.
fn table(action: &Action, at_s: f64, setup: &Setup) -> String {
    let spec = action.name().spec();
    let target = match *action {
        Action::Vessel(index, _) => &setup.bodies[setup.world.vessels[index].body].name,
        Action::Tug(index, _) => &setup.world.tugs[index].tug.name,
        Action::Line(index, _) => &setup.world.lines[index].line.name,
        Action::Anchor(index, _) => &setup.world.anchors[index].gear.name,
    };
    let arguments = action.arguments();
    let value = |argument: &Argument| {
        let value = arguments.get(argument.name)?;
        Some(text(argument, value, action, setup))
    };
    let mut pairs = vec![format!("{} = {}", spec.target.word(), quoted(target))];
    if at_s > 0.0 {
        pairs.push(format!("at = {}", rounded(at_s, 3)));
    }
    match spec.arguments {
        [] => pairs.push(format!("{} = true", spec.word)),
        [Argument { kind: ArgumentKind::Number { .. }, .. }, ..] => {
            for (index, argument) in spec.arguments.iter().enumerate() {
                let name = if index == 0 { spec.word } else { argument.name };
                pairs.extend(value(argument).map(|value| format!("{name} = {value}")));
            }
        }
        all => {
            let inner = all
                .iter()
                .filter_map(|argument| Some(format!("{} = {}", argument.name, value(argument)?)));
            let inner: Vec<String> = inner.collect();
            pairs.push(format!("{} = {{ {} }}", spec.word, inner.join(", ")));
        }
    }
    format!("{{ {} }}", pairs.join(", "))
}

/// Formats the value of an argument as TOML.
fn text(argument: &Argument, value: Value, action: &Action, setup: &Setup) -> String {
    match value {
        Value::Number(number) => rounded(number, 9).to_string(),
        Value::Place(at_m) => match argument.kind {
            ArgumentKind::Place { frame: Frame::Earth | Frame::Body, .. } => place(at_m),
            ArgumentKind::Number { .. } | ArgumentKind::Name(_) => {
                unreachable!("{} holds a place", argument.name)
            }
        },
        Value::Index(index) => quoted(name_of(argument, index, action, setup)),
    }
}

fn name_of<'s>(argument: &Argument, index: usize, action: &Action, setup: &'s Setup) -> &'s str {
    let world = &setup.world;
    let vessel = match *action {
        Action::Vessel(vessel, _) => world.vessels.get(vessel),
        Action::Tug(..) | Action::Line(..) | Action::Anchor(..) => None,
    };
    let ArgumentKind::Name(named) = argument.kind else {
        unreachable!("{} holds an index", argument.name)
    };
    match named {
        Named::Thruster => vessel.map_or("", |vessel| &vessel.thrusters[index].name),
        Named::AzimuthUnit => vessel.map_or("", |vessel| &vessel.azimuths[index].name),
        Named::Body => &setup.bodies[index].name,
        Named::Line => &world.lines[index].line.name,
        Named::Bollard => &world.bollards[index].name,
    }
}
