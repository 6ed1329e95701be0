//! The table of orders for pages: words, units, limits and defaults.

use fenderline_sim::hydro::actuator::Telegraph;
use fenderline_sim::order::{Absent, Argument, ArgumentKind, Gear, OrderName};

use crate::message::{ArgumentInfo, OrderInfo, TelegraphInfo};

/// All orders.
#[must_use]
pub fn order_infos() -> Vec<OrderInfo> {
    OrderName::ALL.iter().map(|order| order_info(*order)).collect()
}

/// The orders of the engine telegraph, from full astern to navigation full.
pub(crate) fn telegraph() -> Vec<TelegraphInfo> {
    let info =
        |order: Telegraph| TelegraphInfo { word: order.word(), share: order.revolutions_ratio() };
    Telegraph::ALL.map(info).to_vec()
}

fn order_info(order: OrderName) -> OrderInfo {
    let spec = order.spec();
    OrderInfo {
        name: spec.word,
        target: spec.target.word(),
        needs: (spec.gear != Gear::None).then(|| spec.gear.missing()),
        meaning: spec.meaning,
        arguments: spec.arguments.iter().map(argument_info).collect(),
    }
}

fn argument_info(argument: &Argument) -> ArgumentInfo {
    let (kind, unit, limits) = match argument.kind {
        ArgumentKind::Number { unit, low, high } => ("number", unit.symbol(), Some([low, high])),
        ArgumentKind::Place { most_m, .. } => ("place", "m", Some([-most_m, most_m])),
        ArgumentKind::Name(_) => ("name", "", None),
    };
    ArgumentInfo {
        name: argument.field(),
        kind,
        unit,
        limits,
        default: match argument.absent {
            Absent::Is(value, _) => Some(value),
            Absent::Refused | Absent::Means(_) => None,
        },
        required: argument.absent == Absent::Refused,
        meaning: argument.meaning,
    }
}
