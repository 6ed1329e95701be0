//! Keys of a comparison of the berthing energy by formula with the berthing energy of the run.

use serde_json::json;

use fenderline_sim::berthing::{AddedMassFormula, Configuration, Softness};

use crate::choices::{Choice, Choices};
use crate::held::{Name, Number, OneOf};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static BERTHING: TableSpec = TableSpec {
    what: "a berthing",
    doc: "Particulars of a ship and her berth for the berthing energy by formula. The report \
        compares the berthing energy by PIANC's formula with the energy of the run. If length, \
        beam, draught or block coefficient is not given, it is taken from the vessel of the ship; \
        if the under-keel clearance is not given, it follows from the depth of the water.",
    keys: BerthingKey::ALL,
    rules: Some(|| json!({ "not": { "required": ["added_mass", "added_mass_factor"] } })),
};

table_keys! {
    /// Keys of a berthing.
    pub BerthingKey {
        SHIP: Name = key(
            "ship",
            Kind::BodyName,
            Refused,
            "The floating body that berths.",
            &["\"ship\""],
        ),
        LENGTH_BP: Number = key(
            "length_bp",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 5000.0 }),
            Unless(IS_VESSEL),
            "Length between perpendiculars; the length of the vessel unless given.",
            &["\"285 m\""],
        ),
        BEAM: Number = key(
            "beam",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 1000.0 }),
            Unless(IS_VESSEL),
            "Beam of the ship; the beam of the vessel unless given.",
            &["\"46 m\""],
        ),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.01, high: 100.0 }),
            Unless("`ship` is a vessel or has `outlines`"),
            "Draught of the ship; unless given, the draught of the vessel or of the hull with \
             `outlines`.",
            &["\"9 m\""],
        ),
        UNDER_KEEL_CLEARANCE: Number = key(
            "under_keel_clearance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 2e4 }),
            Unless("`[environment]` has a `depth`"),
            "Depth of water under the keel; unless given, the depth plus the tide at the start, \
             less the draught.",
            &["\"3 m\""],
        ),
        BLOCK_COEFFICIENT: Number = key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Unless(IS_VESSEL),
            "Displaced volume divided by the product of length, beam and draught; the block \
             coefficient of the vessel unless given.",
            &["0.71"],
        ),
        ADDED_MASS: OneOf<AddedMassFormula> = key(
            "added_mass",
            Kind::Choice(&ADDED_MASSES),
            Is("\"pianc_2002\""),
            "Formula for the added mass factor Cm of the berthing energy and of the abnormal \
             energy; the report also shows the other formulas.",
            &["\"ufc\""],
        ),
        ADDED_MASS_FACTOR: Number = key(
            "added_mass_factor",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 10.0 }),
            Means("the formula that `added_mass` names gives the factor"),
            "The added mass factor Cm as a number: displacement plus added mass, divided by the \
             displacement.",
            &["1.8"],
        ),
        SOFTNESS: OneOf<Softness> = key(
            "softness",
            Kind::Choice(&SOFTNESSES),
            Is("\"soft\""),
            "Whether the fender is soft or hard compared with the hull, for the softness factor Cs \
             of the formula.",
            &["\"soft\""],
        ),
        CONFIGURATION: OneOf<Configuration> = key(
            "configuration",
            Kind::Choice(&CONFIGURATIONS),
            Is("\"open\""),
            "Kind of berth, open or solid, for the berth configuration factor Cc of the formula.",
            &["\"solid\""],
        ),
        ABNORMAL_FACTOR: Number = key(
            "abnormal_factor",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.25, high: 2.0 }),
            Means("no abnormal berthing"),
            "Energy of an abnormal berthing divided by the energy of a normal berthing. This \
             factor of safety is 1.25 to 2.0, depending on type and size of the ship. The report \
             shows the abnormal energy beside the capacity of the fenders.",
            &["1.5"],
        ),
    }
}

const IS_VESSEL: &str = "`ship` is a vessel";

static ADDED_MASSES: Choices<AddedMassFormula> = Choices(&[
    Choice {
        word: "pianc_2002",
        value: AddedMassFormula::Pianc2002,
        doc: "PIANC 2002: the factor falls from 1.8 to 1.5 with the ratio of under-keel clearance \
              to draught",
    },
    Choice {
        word: "ueda",
        value: AddedMassFormula::Ueda,
        doc: "Ueda's formula: the factor follows from draught, beam and block coefficient",
    },
    Choice {
        word: "vasco_costa",
        value: AddedMassFormula::VascoCosta,
        doc: "Vasco Costa's formula: the factor follows from the ratio of draught to beam",
    },
    Choice {
        word: "ufc",
        value: AddedMassFormula::Ufc,
        doc: "UFC 4-152-01: the factor rises to about 5 if there is little water under the keel",
    },
]);

static SOFTNESSES: Choices<Softness> = Choices(&[
    Choice {
        word: "soft",
        value: Softness::Soft,
        doc: "the fender is soft compared with the hull: Cs = 1",
    },
    Choice { word: "hard", value: Softness::Hard, doc: "the fender is hard: Cs = 0.9" },
]);

static CONFIGURATIONS: Choices<Configuration> = Choices(&[
    Choice { word: "solid", value: Configuration::SolidQuay, doc: "a solid quay: Cc = 0.8" },
    Choice { word: "semi_open", value: Configuration::SemiOpen, doc: "partly open: Cc = 0.9" },
    Choice { word: "open", value: Configuration::OpenPiles, doc: "a jetty on open piles: Cc = 1" },
]);
