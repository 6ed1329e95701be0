//! What people do to the simulation: the commands that are recorded.

use fenderline_sim::order::{Lead, OrderName, SidePlace, TugWord, TugWords};
use serde::de::Error;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use serde_json::{Map, Value};

use crate::named_order::NamedOrder;

/// A command that changes the simulated world, by the names of the scenario; units are SI. Its JSON is that of
/// `web/src/protocol.ts`.
#[derive(Clone, Debug, PartialEq)]
pub enum Action {
    /// An order of the table in `fenderline_sim`.
    Order(NamedOrder),
    /// Anything else.
    Other(OtherAction),
}

/// A command that is not an order of the table.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "do", rename_all = "snake_case", deny_unknown_fields)]
#[allow(missing_docs, reason = "protocol.ts explains the fields")]
pub enum OtherAction {
    /// A pilot's words to a tug of either kind. The simulation finds force, direction and place.
    Tug {
        tug: String,
        #[serde(with = "crate::word")]
        order: TugWord,
        /// Force over her bollard pull. A push and a pull need it.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        power: Option<f64>,
        #[serde(default, with = "crate::word")]
        lead: Lead,
        #[serde(default, with = "crate::word")]
        place: SidePlace,
    },
    /// A steady wind at 10 m in place of the present one.
    Wind { speed_mps: f64, from_rad: f64 },
    /// A uniform current in place of the present one.
    Current { speed_mps: f64, to_rad: f64 },
    /// Something on a vessel fails, or is repaired.
    Fault { vessel: String, fault: Fault, on: bool },
    /// The greatest closing speed at the fenders that is no alarm.
    ApproachLimit { speed_mps: f64 },
}

impl Action {
    /// A pilot's words to a tug.
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

/// What can fail on a vessel: see [`fenderline_sim::Faults`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Fault {
    /// The rudder stays where it is; azimuth units do not turn.
    RudderStuck,
    /// Shaft and azimuth units give nothing.
    EngineLost,
    /// Tunnel thrusters give nothing.
    ThrustersLost,
    /// All of these.
    Blackout,
}

impl Fault {
    /// Those of a vessel that are on.
    #[must_use]
    pub fn standing(faults: &fenderline_sim::Faults) -> Vec<Fault> {
        [
            (faults.rudder_stuck, Fault::RudderStuck),
            (faults.engine_lost, Fault::EngineLost),
            (faults.thrusters_lost, Fault::ThrustersLost),
            (faults.blackout, Fault::Blackout),
        ]
        .into_iter()
        .filter_map(|(on, fault)| on.then_some(fault))
        .collect()
    }

    /// Switches it on or off.
    pub(crate) fn switch(self, faults: &mut fenderline_sim::Faults, on: bool) {
        match self {
            Fault::RudderStuck => faults.rudder_stuck = on,
            Fault::EngineLost => faults.engine_lost = on,
            Fault::ThrustersLost => faults.thrusters_lost = on,
            Fault::Blackout => faults.blackout = on,
        }
    }
}
