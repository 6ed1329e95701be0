//! Keys of events: changes of the weather and faults at times of the run.

use fenderline_sim::environment::current::Current;
use fenderline_sim::environment::wind::MeanWind;
use fenderline_sim::{Change, Fault};
use serde_json::json;

use super::quantities::{DIRECTION, TIME};
use crate::choices::{Choice, Choices};
use crate::held::{Flag, Name, Number, OneOf, TableOf, Text};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec, key};
use crate::typed_key::AnyKey;
use crate::units::measures as unit;
use crate::{any_keys, table_keys};

/// The keys that say what happens in an event; each event has exactly one of these keys.
pub const WHAT: &[AnyKey<EventKey>] = any_keys![
    EventKey: WIND, CURRENT, VISIBILITY, FAULT, THRUSTER_OUT, LINE_PARTS, TUG_OUT
];
/// The keys of events that can end, such as a fault.
pub const CAN_END: &[AnyKey<EventKey>] = any_keys![EventKey: FAULT, THRUSTER_OUT, TUG_OUT];
/// The keys of events that concern a vessel, and so need the key `vessel`.
pub const OF_VESSEL: &[AnyKey<EventKey>] = any_keys![EventKey: FAULT, THRUSTER_OUT];

pub(super) static EVENT: TableSpec = TableSpec {
    what: "an event",
    doc: "A change of the weather, or a fault, at a time of the run; each [[event]] has one change \
        or fault. In a live session the instructor sees the events and can cancel them.",
    keys: EventKey::ALL,
    rules: Some(|| {
        let of = |keys: &[AnyKey<EventKey>]| -> Vec<_> {
            keys.iter().map(|key| json!({ "required": [key.name()] })).collect()
        };
        json!({
            "oneOf": of(WHAT),
            "allOf": [
                {
                    "if": { "anyOf": of(OF_VESSEL) },
                    "then": { "required": ["vessel"] },
                    "else": { "properties": { "vessel": false } }
                },
                {
                    "if": { "anyOf": of(CAN_END) },
                    "else": { "properties": { "ends": { "const": false } } }
                }
            ]
        })
    }),
};

table_keys! {
    /// Keys of an event.
    pub EventKey {
        AT: Number = key(
            "at",
            Kind::Quantity(TIME),
            Is("0"),
            "When the event happens.",
            &["\"12 min\""],
        ),
        WIND: TableOf<WindChangeKey> = key(
            "wind",
            Kind::Table(&WIND),
            ANOTHER,
            "The mean wind changes. After the change, gusts go on in proportion to the new mean \
             wind; a wind from a file becomes steady.",
            &["{ speed = \"14 m/s\", from = \"270 deg\", over = \"5 min\" }"],
        ),
        CURRENT: TableOf<CurrentChangeKey> = key(
            "current",
            Kind::Table(&CURRENT),
            ANOTHER,
            "The current becomes a uniform current with this speed and direction, in place of the \
             present current.",
            &["{ speed = \"1 kn\", towards = \"180 deg\", over = \"5 min\" }"],
        ),
        VISIBILITY: TableOf<VisibilityChangeKey> = key(
            "visibility",
            Kind::Table(&VISIBILITY),
            ANOTHER,
            "The visibility changes: how far people see in a live session.",
            &["{ distance = \"300 m\", over = \"5 min\" }"],
        ),
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Means("the event does not concern a vessel"),
            "For the events `fault` and `thruster_out`: the body of the vessel that has the fault.",
            &["\"ship\""],
        ),
        FAULT: OneOf<Fault> = key(
            "fault",
            Kind::Choice(&FAULTS),
            ANOTHER,
            "A fault of the vessel's machinery, steering or instruments.",
            &["\"engine_lost\""],
        ),
        THRUSTER_OUT: Text = key(
            "thruster_out",
            Kind::Text,
            ANOTHER,
            "Name of a thruster or azimuth unit of the vessel that fails.",
            &["\"bow\""],
        ),
        LINE_PARTS: Text = key(
            "line_parts",
            Kind::Text,
            ANOTHER,
            "Name of a mooring line that parts. If the line is not fast at the time of the event, \
             nothing happens, and the run reports that nothing happened.",
            &["\"spring\""],
        ),
        TUG_OUT: Text = key(
            "tug_out",
            Kind::Text,
            ANOTHER,
            "Name of a vector tug, a tug that is only a force on a vessel, that drops out.",
            &["\"one\""],
        ),
        ENDS: Flag = key(
            "ends",
            Kind::Flag,
            Is("false"),
            "For `fault`, `thruster_out` and `tug_out`: if true, the fault ends at the time of \
             this event.",
            &["true"],
        ),
    }
}

const ANOTHER: crate::spec::Absent = Means("another event");
const OVER: KeySpec = key(
    "over",
    Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: Change::LONGEST_S }),
    Is("0"),
    "Duration of a gradual change; with 0 the change is sudden.",
    &["\"5 min\""],
);

static WIND: TableSpec = TableSpec {
    what: "a change of the wind",
    doc: "The mean wind changes gradually: its speed linearly, its direction by the shorter turn.",
    keys: WindChangeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a change of the wind.
    pub WindChangeKey {
        SPEED: Number = key(
            "speed",
            Kind::Quantity(Quantity {
                measure: &unit::SPEED,
                low: 0.0,
                high: MeanWind::FASTEST_MPS,
            }),
            Refused,
            "Mean speed 10 m above the water.",
            &["\"14 m/s\""],
        ),
        FROM: Number = key(
            "from",
            Kind::Quantity(DIRECTION),
            Refused,
            "Direction from which the wind comes, clockwise from north.",
            &["\"270 deg\""],
        ),
        OVER: Number = OVER,
    }
}

static CURRENT: TableSpec = TableSpec {
    what: "a change of the current",
    doc: "The current becomes uniform and changes gradually: its speed linearly, its direction by \
        the shorter turn. A gradual change begins with the current at the scenario's origin.",
    keys: CurrentChangeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a change of the current.
    pub CurrentChangeKey {
        SPEED: Number = key(
            "speed",
            Kind::Quantity(Quantity {
                measure: &unit::SPEED,
                low: 0.0,
                high: Current::FASTEST_MPS,
            }),
            Refused,
            "Speed.",
            &["\"1 kn\""],
        ),
        TOWARDS: Number = key(
            "towards",
            Kind::Quantity(DIRECTION),
            Refused,
            "Direction in which the current runs, clockwise from north.",
            &["\"180 deg\""],
        ),
        OVER: Number = OVER,
    }
}

static VISIBILITY: TableSpec = TableSpec {
    what: "a change of the visibility",
    doc: "How far people see. In a gradual change the visibility changes by equal ratios in equal \
          times; clear visibility counts as 20 km.",
    keys: VisibilityChangeKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a change of the visibility.
    pub VisibilityChangeKey {
        DISTANCE: Number = key(
            "distance",
            Kind::Quantity(Quantity {
                measure: &unit::LENGTH,
                low: Change::VISIBILITY_M[0],
                high: Change::VISIBILITY_M[1],
            }),
            Means("clear"),
            "The distance.",
            &["\"300 m\""],
        ),
        OVER: Number = OVER,
    }
}

static FAULTS: Choices<Fault> = Choices(&[
    Choice {
        word: "rudder_stuck",
        value: Fault::RudderStuck,
        doc: "the rudder stays at its present angle; azimuth units do not turn",
    },
    Choice {
        word: "follow_up_lost",
        value: Fault::FollowUpLost,
        doc: "the rudder runs to its stop on the side of the rudder order",
    },
    Choice {
        word: "engine_lost",
        value: Fault::EngineLost,
        doc: "the engine fails: the shaft runs down, and azimuth units give no thrust",
    },
    Choice {
        word: "thrusters_lost",
        value: Fault::ThrustersLost,
        doc: "tunnel thrusters give no thrust",
    },
    Choice { word: "blackout", value: Fault::Blackout, doc: "no power at all" },
    Choice {
        word: "heading_frozen",
        value: Fault::HeadingFrozen,
        doc: "the heading on the pilot's page stays at its last value",
    },
    Choice {
        word: "speed_frozen",
        value: Fault::SpeedFrozen,
        doc: "the speeds on the pilot's page stay at their last values",
    },
    Choice {
        word: "position_frozen",
        value: Fault::PositionFrozen,
        doc: "the position on the pilot's page stays at its last value",
    },
]);
