//! Keys of the study of berthing energy.

use fenderline_sim::berthing::{Configuration, Softness};

use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, Quantity, TableSpec};
use crate::units::measures as unit;

pub(super) static BERTHING: TableSpec = TableSpec {
    what: "a berthing",
    doc: "Particulars of a ship and her berth, for the berthing energy by PIANC's formula that the \
          report shows beside the energy of the run.",
    keys: &[
        KeySpec {
            name: "ship",
            kind: Kind::BodyName,
            absent: Refused,
            doc: "The floating body that berths.",
            examples: &["\"ship\""],
        },
        KeySpec {
            name: "length_bp",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 5000.0 }),
            absent: Refused,
            doc: "Length between perpendiculars.",
            examples: &["\"285 m\""],
        },
        KeySpec {
            name: "beam",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 1000.0 }),
            absent: Refused,
            doc: "Beam.",
            examples: &["\"46 m\""],
        },
        KeySpec {
            name: "draught",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.01, high: 100.0 }),
            absent: Refused,
            doc: "Draught.",
            examples: &["\"9 m\""],
        },
        KeySpec {
            name: "under_keel_clearance",
            kind: Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 2e4 }),
            absent: Refused,
            doc: "Water under the keel.",
            examples: &["\"3 m\""],
        },
        KeySpec {
            name: "block_coefficient",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            absent: Refused,
            doc: "Volume over length, beam and draught.",
            examples: &["0.71"],
        },
        KeySpec {
            name: "softness",
            kind: Kind::Choice(&SOFTNESSES),
            absent: Is("\"soft\""),
            doc: "Fender against hull, for the factor Cs.",
            examples: &["\"soft\""],
        },
        KeySpec {
            name: "configuration",
            kind: Kind::Choice(&CONFIGURATIONS),
            absent: Is("\"open\""),
            doc: "The berth, for the factor Cc.",
            examples: &["\"solid\""],
        },
        KeySpec {
            name: "abnormal_factor",
            kind: Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.25, high: 2.0 }),
            absent: Means("no abnormal berthing"),
            doc: "Energy of an abnormal berthing over that of a normal one.",
            examples: &["1.5"],
        },
    ],
    rules: None,
};

static SOFTNESSES: Choices<Softness> = Choices(&[
    Choice {
        word: "soft",
        value: Softness::Soft,
        doc: "the fender is soft beside the hull: Cs = 1",
    },
    Choice { word: "hard", value: Softness::Hard, doc: "the fender is hard: Cs = 0.9" },
]);

static CONFIGURATIONS: Choices<Configuration> = Choices(&[
    Choice { word: "solid", value: Configuration::SolidQuay, doc: "a solid quay: Cc = 0.8" },
    Choice { word: "semi_open", value: Configuration::SemiOpen, doc: "partly open: Cc = 0.9" },
    Choice { word: "open", value: Configuration::OpenPiles, doc: "a jetty on open piles: Cc = 1" },
]);
