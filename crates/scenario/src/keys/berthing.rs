//! Keys of the study of berthing energy.

use fenderline_sim::berthing::{Configuration, Softness};

use crate::choices::{Choice, Choices};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::units::measures as unit;

pub(super) static BERTHING: TableSpec = TableSpec {
    what: "a berthing",
    doc: "Particulars of a ship and her berth. The report shows the berthing energy by PIANC's formula beside \
          that of the run.",
    keys: &[
        key("ship", Kind::BodyName, Refused, "The floating body that berths.", &["\"ship\""]),
        key(
            "length_bp",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 5000.0 }),
            Refused,
            "Length between perpendiculars.",
            &["\"285 m\""],
        ),
        key(
            "beam",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 1000.0 }),
            Refused,
            "Beam.",
            &["\"46 m\""],
        ),
        key(
            "draught",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.01, high: 100.0 }),
            Refused,
            "Draught.",
            &["\"9 m\""],
        ),
        key(
            "under_keel_clearance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 2e4 }),
            Refused,
            "Water under the keel.",
            &["\"3 m\""],
        ),
        key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Refused,
            "Displaced volume over length, beam and draught.",
            &["0.71"],
        ),
        key(
            "softness",
            Kind::Choice(&SOFTNESSES),
            Is("\"soft\""),
            "Fender against hull, for the factor Cs.",
            &["\"soft\""],
        ),
        key(
            "configuration",
            Kind::Choice(&CONFIGURATIONS),
            Is("\"open\""),
            "The berth, for the factor Cc.",
            &["\"solid\""],
        ),
        key(
            "abnormal_factor",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.25, high: 2.0 }),
            Means("no abnormal berthing"),
            "Energy of an abnormal berthing over that of a normal one.",
            &["1.5"],
        ),
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
