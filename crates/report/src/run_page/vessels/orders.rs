//! The report's table of the orders of a run, in the order of time.

use fenderline_sim::anchor::SHACKLE_M;
use fenderline_sim::order::{Argument, ArgumentKind, Named, Target, Unit, Value};
use fenderline_sim::{Action, Order, Setup};
use maud::{Markup, html};

use crate::plot::{fixed, plain};
use crate::run_page::tables::{ROWS, more, number};
use crate::{Head, table_head};
use fenderline_results::Outcome;

/// The table with one row per order, in the order of time.
pub(super) fn table(outcome: &Outcome<'_>) -> Markup {
    let setup = outcome.setup;
    let mut orders: Vec<&Order> = setup.world.orders.iter().collect();
    orders.sort_by(|one, other| one.at_s.total_cmp(&other.at_s));
    html! {
        div class="wide" {
            table class="narrow" {
                (table_head(&[
                    Head::Number("Time", "s"),
                    Head::Name("To"),
                    Head::Name("Order"),
                ]))
                tbody {
                    @for order in orders.iter().take(ROWS) {
                        tr {
                            (number(&plain(order.at_s, 6)))
                            td class="name" { (addressee(&order.action, setup)) }
                            td class="name" { (order_text(&order.action, setup)) }
                        }
                    }
                }
            }
        }
        (more(orders.len()))
    }
}

/// The name of the vessel, tug, mooring line or anchor that an order is for.
#[must_use]
pub fn addressee(order: &Action, setup: &Setup) -> String {
    let world = &setup.world;
    match order.target() {
        Target::Vessel(vessel) => setup.bodies[world.vessels[vessel].body].name.clone(),
        Target::Tug(tug) => format!("tug {}", world.tugs[tug].tug.name),
        Target::Line(line) => format!("line {}", world.lines[line].line.name),
        Target::Anchor(anchor) => format!("anchor {}", world.anchors[anchor].gear.name),
    }
}

/// The words of an order and its arguments, by the table of orders.
#[must_use]
pub fn order_text(order: &Action, setup: &Setup) -> String {
    let spec = order.name().spec();
    let arguments = order.arguments();
    let arguments = arguments.iter().filter_map(|(name, value)| {
        let argument = spec.argument(name)?;
        Some(match value {
            Value::Number(value) => number_text(argument, value),
            Value::Place(at_m) => format!("at {} m, {} m", plain(at_m.x, 6), plain(at_m.y, 6)),
            Value::Index(index) => name_of(argument, index, order, setup),
        })
    });
    let arguments: Vec<String> = arguments.collect();
    format!("{} {}", spec.word.replace('_', " "), arguments.join(", ")).trim_end().to_owned()
}

fn number_text(argument: &Argument, value: f64) -> String {
    let ArgumentKind::Number { unit, .. } = argument.kind else { return plain(value, 3) };
    match unit {
        Unit::Radian if argument.name == "heading" => compass(value),
        Unit::Radian if value == 0.0 => "0°".to_owned(),
        Unit::Radian => sided(libm::remainder(value.to_degrees(), 360.0), "°"),
        Unit::Share => format!("{} %", fixed(100.0 * value, 0)),
        Unit::Metre if argument.name == "chain" => {
            format!("{} m ({} shackles)", plain(value, 4), fixed(value / SHACKLE_M, 1))
        }
        Unit::Metre => format!("{} m", plain(value, 4)),
        Unit::MetrePerSecond => format!("{} m/s", plain(value, 3)),
        Unit::Newton => format!("{} kN", plain(value / 1e3, 3)),
    }
}

fn name_of(argument: &Argument, index: usize, order: &Action, setup: &Setup) -> String {
    let world = &setup.world;
    let vessel = match order.target() {
        Target::Vessel(vessel) => world.vessels.get(vessel),
        Target::Tug(_) | Target::Line(_) | Target::Anchor(_) => None,
    };
    let ArgumentKind::Name(named) = argument.kind else { return String::new() };
    match named {
        Named::Thruster => vessel.map_or_else(String::new, |v| v.thrusters[index].name.clone()),
        Named::AzimuthUnit => vessel.map_or_else(String::new, |v| v.azimuths[index].name.clone()),
        Named::Body => setup.bodies[index].name.clone(),
        Named::Line => format!("line {}", world.lines[index].line.name),
        Named::Bollard => format!("bollard {}", world.bollards[index].name),
    }
}

fn sided(value: f64, unit: &str) -> String {
    let side = if value > 0.0 { "to starboard" } else { "to port" };
    format!("{}{unit} {side}", plain(value.abs(), 3))
}

/// The text of a direction with three digits, as mariners say a compass course.
pub(in crate::run_page) fn compass(angle_rad: f64) -> String {
    let degrees = libm::round(angle_rad.to_degrees()).rem_euclid(360.0);
    format!("{degrees:03}°")
}
