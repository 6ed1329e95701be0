//! Declares every key of a vessel file, in the same way as [`fenderline_keys::keys`] declares the keys of a scenario.

pub(crate) mod deck;
pub(crate) mod hull;
mod shared;
pub(crate) mod source;
pub(crate) mod stern;

use serde_json::json;

use self::deck::{BELTING, DECK_POINT, FileBeltingKey, FileDeckPointKey, FileOutlineKey, OUTLINE};
use self::hull::{
    ADDED_MASS, DRIFT_POLYNOMIAL, FileAddedMassKey, FileDriftPolynomialKey, FileLowSpeedKey,
    FileSwayPolynomialKey, LOW_SPEED, SWAY_POLYNOMIAL,
};
use self::shared::ESTIMATED;
use self::source::{FileSourceKey, SOURCE};
use self::stern::{FilePropellerKey, FileRudderKey, PROPELLER, RUDDER};
use fenderline_keys::held::{Flag, ListOf, NamedOf, Number, TableOf, Text};
use fenderline_keys::keys::quantities::{LENGTH, PLACE};
use fenderline_keys::keys::vessel::VesselKey;
use fenderline_keys::keys::{
    AZIMUTH, AzimuthKey, STABILITY, StabilityKey, THRUSTER, ThrusterKey, WINDAGE, WindageKey,
};
use fenderline_keys::spec::Absent::{Is, Means, Refused, Unless};
use fenderline_keys::spec::{Kind, Quantity, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_keys::typed_key::ReadAs;
use fenderline_keys::units::measures as unit;

/// The whole file.
pub(crate) static VESSEL_FILE: TableSpec = TableSpec {
    what: "a vessel file",
    doc: "A vessel file has vessels with their particulars, outlines, coefficients, propellers, \
          rudders, thrusters, wind areas, stability, chocks, bitts and belting. Each number has a \
          source and a standing. A plain number is in SI units (angles in radians); a number with \
          another unit is a string, as \"3 m\".",
    keys: VesselFileKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a vessel file.
    pub(crate) VesselFileKey {
        VESSEL: NamedOf<FileVesselKey> = key(
            "vessel",
            Kind::Named(&VESSEL),
            Refused,
            "Vessels, by name.",
            &[],
        ),
    }
}

static VESSEL: TableSpec = TableSpec {
    what: "a vessel of a file",
    doc: "A vessel. The program estimates coefficients of a vessel that are not given, and reports \
          name these coefficients as estimates.",
    keys: FileVesselKey::ALL,
    rules: Some(|| {
        let one_of = ["volume", "displacement", "block_coefficient", "mass_coefficient"];
        let one_of: Vec<_> = one_of.iter().map(|key| json!({ "required": [key] })).collect();
        json!({
            "oneOf": one_of,
            "not": { "anyOf": [
                { "required": ["speed", "froude"] },
                { "required": ["sway_polynomial", "drift_polynomial"] }
            ] },
            "dependentRequired": { "propeller": ["rudder"], "rudder": ["propeller"] }
        })
    }),
};

table_keys! {
    /// Keys of a vessel of a file.
    pub(crate) FileVesselKey {
        TITLE: Text = key(
            "title",
            Kind::Text,
            Refused,
            "Name of the vessel in reports.",
            &["\"KCS, 230 m\""],
        ),
        TANK_MODEL: Flag = key(
            "tank_model",
            Kind::Flag,
            Is("false"),
            "True for a model in a towing tank: a tank model manoeuvres in fresh water, and IMO's \
             limits do not apply to it.",
            &["true"],
        ),
        COEFFICIENTS_OF: Text = key(
            "coefficients_of",
            Kind::Text,
            Means("the vessel's own coefficients, or estimated coefficients"),
            "Another vessel, of which this vessel is a model or a sister. Coefficients that this \
             vessel does not give are taken from the other vessel, and speed, revolutions and \
             rudder rate of the other vessel are scaled by Froude's law.",
            &["\"kvlcc2\""],
        ),
        LENGTH_BP: Number = key(
            "length_bp",
            Kind::Quantity(LENGTH),
            Refused,
            "Length between perpendiculars.",
            &["\"285 m\""],
        ),
        LENGTH_OVERALL: Number = key(
            "length_overall",
            Kind::Quantity(LENGTH),
            Means("not known"),
            "Length overall of the vessel, which the outline must have.",
            &["\"298 m\""],
        ),
        BEAM: Number = key("beam", Kind::Quantity(LENGTH), Refused, "Beam.", &["\"46 m\""]),
        DRAUGHT: Number = key("draught", Kind::Quantity(LENGTH), Refused, "Draught.", &["\"9 m\""]),
        VOLUME: Number = key(
            "volume",
            Kind::Quantity(Quantity { measure: &unit::VOLUME, low: 1e-6, high: 1e8 }),
            Unless("another key gives the displacement"),
            "Displaced volume.",
            &["\"312600 m^3\""],
        ),
        DISPLACEMENT: Number = key(
            "displacement",
            Kind::Quantity(Quantity { measure: &unit::MASS, low: 1e-3, high: 1e11 }),
            Unless("another key gives the displacement"),
            "Displacement of the vessel in sea water of 1025 kg/m³.",
            &["\"87800 t\""],
        ),
        BLOCK_COEFFICIENT: Number = key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Unless("another key gives the displacement"),
            "Displaced volume divided by the product of length between perpendiculars, beam and \
             draught.",
            &["0.71"],
        ),
        MASS_COEFFICIENT: Number = key(
            "mass_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-3, high: 10.0 }),
            Unless("another key gives the displacement"),
            "Mass coefficient m': mass divided by ½ρL²d.",
            &["0.2708"],
        ),
        CENTRE_OF_GRAVITY: Number = key(
            "centre_of_gravity",
            Kind::Quantity(PLACE),
            Means("amidships, assumed"),
            "Distance of the centre of gravity forward of midship.",
            &["\"-3.4 m\""],
        ),
        GYRADIUS: Number = key(
            "gyradius",
            Kind::Quantity(LENGTH),
            Means("a quarter of the length, assumed"),
            "Radius of gyration in yaw about the centre of gravity, without added mass.",
            &["\"72 m\""],
        ),
        RESISTANCE_OF_MODEL: Number = key(
            "resistance_of_model",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 100.0 }),
            Means("the resistance is for the full-scale ship, or unknown"),
            "Length of the model on which the vessel's resistance was measured. A model has \
             relatively more friction than a ship, so crash stops are also shown without this \
             excess friction.",
            &["\"7 m\""],
        ),
        SPEED: Number = key(
            "speed",
            Kind::Quantity(Quantity { measure: &unit::SPEED, low: 0.01, high: 50.0 }),
            Means("not known"),
            "Speed at which the vessel's standard manoeuvres begin.",
            &["\"15.5 kn\""],
        ),
        FROUDE: Number = key(
            "froude",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1e-3, high: 1.0 }),
            Means("`speed`, if it is known"),
            "Speed at which the vessel's standard manoeuvres begin, as a Froude number with g = \
             9.81 m/s².",
            &["0.26"],
        ),
        ADDED_MASS: TableOf<FileAddedMassKey> = key(
            "added_mass",
            Kind::Table(&ADDED_MASS),
            Means(ESTIMATED),
            "Added mass.",
            &[],
        ),
        SWAY_POLYNOMIAL: TableOf<FileSwayPolynomialKey> = key(
            "sway_polynomial",
            Kind::Table(&SWAY_POLYNOMIAL),
            Means("none"),
            "Forces on the hull under way, as a polynomial of v' and r', divided by ½ρLdU².",
            &[],
        ),
        DRIFT_POLYNOMIAL: TableOf<FileDriftPolynomialKey> = key(
            "drift_polynomial",
            Kind::Table(&DRIFT_POLYNOMIAL),
            Means("none"),
            "Forces on the hull under way, as a polynomial of β and r', divided by ½ρLdU². The \
             coefficient x_br includes −m'y, and y_r includes −m'x.",
            &[],
        ),
        LOW_SPEED: TableOf<FileLowSpeedKey> = key(
            "low_speed",
            Kind::Table(&LOW_SPEED),
            Means(ESTIMATED),
            "Forces on the hull at low speed, astern and crabbing.",
            &[],
        ),
        PROPELLER: TableOf<FilePropellerKey> = key(
            "propeller",
            Kind::Table(&PROPELLER),
            Means("none"),
            "Propeller and shaft.",
            &[],
        ),
        RUDDER: TableOf<FileRudderKey> = key(
            "rudder",
            Kind::Table(&RUDDER),
            Means("none"),
            "Rudder and steering gear.",
            &[],
        ),
        THRUSTER: NamedOf<ThrusterKey> = key(
            "thruster",
            Kind::Named(&THRUSTER),
            Is("{}"),
            "Tunnel thrusters, by name.",
            &[],
        ),
        AZIMUTH: NamedOf<AzimuthKey> = key(
            "azimuth",
            Kind::Named(&AZIMUTH),
            Is("{}"),
            "Azimuth units, by name. A vessel without a propeller moves and steers by azimuth \
             units.",
            &[],
        ),
        WINDAGE: TableOf<WindageKey> = key(
            "windage",
            Kind::Table(&WINDAGE),
            Means("no wind forces"),
            "Wind areas.",
            &[],
        ),
        STABILITY: TableOf<StabilityKey> = key(
            "stability",
            Kind::Table(&STABILITY),
            Means("the vessel does not heave, roll or pitch"),
            "Data of the vessel for heave, roll and pitch.",
            &[],
        ),
        OUTLINE: TableOf<FileOutlineKey> = key(
            "outline",
            Kind::Table(&OUTLINE),
            Means("the bodies of a scenario give the outline"),
            "Outline of the vessel in the horizontal plane.",
            &[],
        ),
        CHOCK: NamedOf<FileDeckPointKey> = key(
            "chock",
            Kind::Named(&DECK_POINT),
            Is("{}"),
            "Chocks and fairleads, by name: the places where lines leave the vessel.",
            &[],
        ),
        BITTS: NamedOf<FileDeckPointKey> = key(
            "bitts",
            Kind::Named(&DECK_POINT),
            Is("{}"),
            "Bitts, by name: the places where lines of other vessels are made fast.",
            &[],
        ),
        BELTING: NamedOf<FileBeltingKey> = key(
            "belting",
            Kind::Named(&BELTING),
            Is("{}"),
            "Straight strips of belting or bow fendering, by name: a fender of a scenario may lie \
             on such a strip.",
            &[],
        ),
        SOURCE: ListOf<FileSourceKey> = key(
            "source",
            Kind::List(&SOURCE),
            Refused,
            "Sources of the vessel's numbers; every number must have one source.",
            &[],
        ),
    }
}

// A vessel of a scenario is read as a vessel of a file that has no keys of its own but these.
impl ReadAs<FileVesselKey> for VesselKey {}
