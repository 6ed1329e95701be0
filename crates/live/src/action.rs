//! Commands to the simulation. A recording keeps them.

use fenderline_sim::anchor::AnchorFaults;
use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::MeanWind;
use fenderline_sim::order::{Lead, OrderName, SidePlace, TugWord, TugWords};
use fenderline_sim::{Change, Fault};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};
#[cfg(test)]
use ts_rs::TS;

use crate::approach::ApproachLimit;
use crate::named_order::NamedOrder;
use crate::pair::Pair;

/// A command that changes the simulated world. The command uses the scenario's names and SI units.
/// `web/src/protocol.ts` describes its JSON.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// An order that the table of orders in `fenderline_sim` lists.
    Order(NamedOrder),
    /// A command that is not in the table of orders.
    Other(OtherAction),
}

/// A command that is not in the table of orders.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[cfg_attr(test, ts(rename = "RecordedAction"))]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
#[allow(missing_docs, reason = "the commands are explained")]
pub enum OtherAction {
    /// An order in words to a tug: a vector tug or a tug that is a vessel. The simulation works out how strongly, in
    /// which direction and at which place of the ship the tug pushes or pulls.
    Tug {
        tug: String,
        #[serde(with = "crate::word")]
        #[cfg_attr(test, ts(type = "TugWord"))]
        order: TugWord,
        /// Force as a share of the tug's bollard pull. An order to push or pull needs a force.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        power: Option<f64>,
        #[serde(default, with = "crate::word")]
        #[cfg_attr(test, ts(type = "Lead"))]
        lead: Lead,
        #[serde(default, with = "crate::word")]
        #[cfg_attr(test, ts(type = "Place"))]
        place: SidePlace,
    },
    /// Sets the mean wind at a height of 10 m, at once or over a time. The gusts of the scenario go on, in proportion
    /// to the new mean wind. A wind that came from a time series becomes steady.
    Wind {
        speed_mps: f64,
        from_rad: f64,
        #[serde(default, skip_serializing_if = "is_zero")]
        #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
        over_s: f64,
    },
    /// Replaces the current by a uniform current, at once or over a time.
    Current {
        speed_mps: f64,
        to_rad: f64,
        #[serde(default, skip_serializing_if = "is_zero")]
        #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
        over_s: f64,
    },
    /// Makes a line part.
    PartLine { line: String },
    /// Begins or ends a fault of an anchor or of its windlass.
    AnchorFault { anchor: String, fault: AnchorFault, on: bool },
    /// Makes a vector tug, a tug that is only a force on a vessel, drop out, or brings her back.
    TugOut { tug: String, on: bool },
    /// Plans a change of the weather, or a fault, for a later time.
    Plan { at_s: f64, event: Box<OtherAction> },
    /// Cancels a planned event. `id` is the number of the event.
    CancelPlanned { id: u64 },
    /// Sets the visibility, at once or over a time. If no distance is given, the air is clear. Low visibility hides
    /// ships from people; it changes nothing in the simulated world.
    Visibility {
        #[serde(default)]
        distance_m: Option<f64>,
        #[serde(default, skip_serializing_if = "is_zero")]
        #[cfg_attr(test, ts(optional, as = "Option<f64>"))]
        over_s: f64,
    },
    /// Begins or ends a fault of a vessel.
    Fault {
        vessel: String,
        #[serde(with = "crate::word")]
        #[cfg_attr(test, ts(type = "Fault"))]
        fault: Fault,
        on: bool,
    },
    /// Makes one thruster or azimuth unit of a vessel trip, or brings the unit back.
    ThrusterOut { vessel: String, thruster: String, on: bool },
    /// Places a vessel before the first step: her centre of gravity, her heading and, if given, her speed ahead.
    Place {
        vessel: String,
        at_m: Pair,
        heading_rad: f64,
        #[serde(default, skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        ahead_mps: Option<f64>,
    },
    /// Sets the limit of a ship's closing speed at the fenders. A closing speed above the limit raises an alarm.
    ApproachLimit { speed_mps: f64 },
    /// Acknowledges the alarm whose key is `key`. Acknowledging an alarm does not change the simulated world.
    Acknowledge { key: String },
    /// Writes a note for the debriefing. A note without a text is a mark. A note does not change the simulated world.
    Note {
        #[serde(default, skip_serializing_if = "String::is_empty")]
        #[cfg_attr(test, ts(optional, as = "Option<String>"))]
        text: String,
    },
}

fn is_zero(number: &f64) -> bool {
    *number == 0.0
}

impl OtherAction {
    /// True for commands that can be planned for a later time: changes of the weather, and faults.
    #[must_use]
    pub fn can_be_planned(&self) -> bool {
        match self {
            OtherAction::Wind { .. }
            | OtherAction::Current { .. }
            | OtherAction::Visibility { .. }
            | OtherAction::Fault { .. }
            | OtherAction::ThrusterOut { .. }
            | OtherAction::PartLine { .. }
            | OtherAction::AnchorFault { .. }
            | OtherAction::TugOut { .. } => true,
            OtherAction::Tug { .. }
            | OtherAction::Place { .. }
            | OtherAction::Plan { .. }
            | OtherAction::CancelPlanned { .. }
            | OtherAction::ApproachLimit { .. }
            | OtherAction::Acknowledge { .. }
            | OtherAction::Note { .. } => false,
        }
    }
}

/// Limits of the commands that are not in the table of orders: the least and the greatest value of each number. Pages
/// of the browser get these limits in the message `hello`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(TS))]
pub struct CommandLimits {
    /// Force in an order in words to a tug, as a share of her bollard pull.
    pub tug_power: Pair,
    /// Speed of a wind (m/s).
    pub wind_mps: Pair,
    /// Speed of a current (m/s).
    pub current_mps: Pair,
    /// Visibility (m).
    pub visibility_m: Pair,
    /// Limit of the closing speed at the fenders (m/s).
    pub approach_limit_mps: Pair,
    /// Pace of the exercise: simulated time over wall time.
    pub pace: Pair,
    /// Time over which wind, current or visibility changes (s).
    pub over_s: Pair,
    /// Time that a trial looks ahead (s).
    pub trial_s: Pair,
}

/// The limits of commands that the server applies.
pub const COMMAND_LIMITS: CommandLimits = CommandLimits {
    tug_power: [0.0, 1.0],
    wind_mps: [0.0, MeanWind::FASTEST_MPS],
    current_mps: [0.0, Current::FASTEST_MPS],
    visibility_m: Change::VISIBILITY_M,
    approach_limit_mps: ApproachLimit::LIMITS_MPS,
    pace: [0.1, 20.0],
    over_s: [0.0, Change::LONGEST_S],
    trial_s: [10.0, 1200.0],
};

impl Action {
    /// An order in words to a tug.
    #[must_use]
    pub fn tug(tug: &str, words: TugWords) -> Action {
        let TugWords { word: order, power, lead, place } = words;
        let power = Some(power);
        Action::Other(OtherAction::Tug { tug: tug.to_owned(), order, power, lead, place })
    }
}

impl From<NamedOrder> for Action {
    fn from(order: NamedOrder) -> Action {
        Action::Order(order)
    }
}

impl From<OtherAction> for Action {
    fn from(other: OtherAction) -> Action {
        Action::Other(other)
    }
}

impl Serialize for Action {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        match self {
            Action::Order(order) => order.to_json().serialize(to),
            Action::Other(other) => other.serialize(to),
        }
    }
}

impl<'de> Deserialize<'de> for Action {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Action, D::Error> {
        let mut map = Map::deserialize(from)?;
        let order = map.get("do").and_then(Value::as_str).and_then(OrderName::of_word);
        if let Some(order) = order {
            map.remove("do");
            return NamedOrder::from_json(order, map).map(Action::Order).map_err(D::Error::custom);
        }
        serde_json::from_value(Value::Object(map)).map(Action::Other).map_err(D::Error::custom)
    }
}

/// A fault of an anchor. [`fenderline_sim::anchor::AnchorFaults`] describes the faults.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(test, derive(TS))]
#[serde(rename_all = "snake_case")]
pub enum AnchorFault {
    /// The windlass has no power.
    WindlassFailed,
    /// The anchor does not dig in, and holds no better than a dragging anchor.
    DoesNotBite,
}

impl AnchorFault {
    /// Lists the faults of an anchor that are on.
    #[must_use]
    pub fn active(faults: &AnchorFaults) -> Vec<AnchorFault> {
        [
            (faults.windlass_failed, AnchorFault::WindlassFailed),
            (faults.does_not_bite, AnchorFault::DoesNotBite),
        ]
        .into_iter()
        .filter_map(|(on, fault)| on.then_some(fault))
        .collect()
    }

    /// Switches a fault of the anchor on or off.
    pub(crate) fn switch(self, faults: &mut AnchorFaults, on: bool) {
        match self {
            AnchorFault::WindlassFailed => faults.windlass_failed = on,
            AnchorFault::DoesNotBite => faults.does_not_bite = on,
        }
    }
}
