//! Keys of vessels.

use fenderline_sim::ShipType;
use serde_json::json;

use super::azimuth::{AZIMUTH, AzimuthKey};
use super::coefficients::{
    CURRENT_COEFFICIENTS, CurrentCoefficientsKey, WIND_COEFFICIENTS, WindCoefficientsKey,
};
use super::environment::{HYDRODYNAMICS_DOC, WAVE_RESPONSE_DOC};
use super::quantities::{FORCE, LENGTH, PLACE};
use super::windage::{WINDAGE, WindageKey};

use crate::choices::{Choice, Choices};
use crate::held::{NamedOf, Number, OneOf, TableOf, Text, Vector};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static VESSEL: TableSpec = TableSpec {
    what: "a vessel",
    doc: "A kind of vessel. Either the main particulars are given, and everything else is \
        estimated and reported as an estimate; or the key `from` names a vessel of the library, \
        which gets other machinery, wind areas or stability. The key `vessel` of a body names the \
        kind of vessel; several bodies may be of one kind.",
    keys: VesselKey::ALL,
    rules: Some(|| {
        json!({
            "not": { "required": ["hydrodynamics", "wave_response"] },
            "dependentRequired": { "roll_damping": ["hydrodynamics"] },
            "if": { "required": ["from"] },
            "then": {
                "properties": {
                    "length_bp": false, "beam": false, "draught": false, "block_coefficient": false,
                    "centre_of_gravity": false, "gyradius": false,
                    "propeller": { "properties": { "diameter": false } },
                    "rudder": { "properties": { "area": false, "span": false } }
                }
            },
            "else": {
                "required": ["length_bp", "beam", "draught", "block_coefficient"],
                "dependentRequired": { "propeller": ["rudder"], "rudder": ["propeller"] },
                "properties": {
                    "propeller": { "required": ["diameter", "full"] },
                    "rudder": { "required": ["area", "span"] }
                }
            }
        })
    }),
};

table_keys! {
    /// Keys of a vessel.
    pub VesselKey {
        FROM: Text = key(
            "from",
            Kind::Text,
            Means("the vessel has its own particulars"),
            "A vessel of the library or of `vessel_files`. The hull, propeller and rudder of the \
             vessel `from` stay the same; thrusters, azimuth units, wind areas and stability in \
             this table replace those of the vessel `from`.",
            &["\"kvlcc2\""],
        ),
        LENGTH_BP: Number = key(
            "length_bp",
            Kind::Quantity(LENGTH),
            Means("the value of `from`"),
            "Length between perpendiculars.",
            &["\"285 m\""],
        ),
        BEAM: Number = key(
            "beam",
            Kind::Quantity(LENGTH),
            Means("the value of `from`"),
            "Beam.",
            &["\"46 m\""],
        ),
        DRAUGHT: Number = key(
            "draught",
            Kind::Quantity(LENGTH),
            Means("the value of `from`"),
            "Draught.",
            &["\"9 m\""],
        ),
        BLOCK_COEFFICIENT: Number = key(
            "block_coefficient",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.1, high: 1.0 }),
            Means("the value of `from`"),
            "Displaced volume divided by the product of length, beam and draught.",
            &["0.71"],
        ),
        CENTRE_OF_GRAVITY: Number = key(
            "centre_of_gravity",
            Kind::Quantity(PLACE),
            Means("amidships, or the place in the vessel `from`"),
            "Distance of the centre of gravity forward of midship; the vertices of the body's \
             outline are relative to the centre of gravity.",
            &["\"-3.4 m\""],
        ),
        GYRADIUS: Number = key(
            "gyradius",
            Kind::Quantity(LENGTH),
            Means("a quarter of the vessel's length"),
            "Radius of gyration in yaw, without added mass.",
            &["\"72 m\""],
        ),
        PROPELLER: TableOf<PropellerKey> = key(
            "propeller",
            Kind::Table(&PROPELLER),
            Means("the propeller of the vessel `from`, or no propeller"),
            "Propeller and shaft.",
            &[],
        ),
        RUDDER: TableOf<RudderKey> = key(
            "rudder",
            Kind::Table(&RUDDER),
            Means("the rudder of the vessel `from`, or no rudder"),
            "Rudder.",
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
            Means("the wind areas of the vessel `from`, or no wind forces"),
            "Wind areas.",
            &[],
        ),
        WIND_COEFFICIENTS: TableOf<WindCoefficientsKey> = key(
            "wind_coefficients",
            Kind::Table(&WIND_COEFFICIENTS),
            Means("the coefficients of `windage`"),
            "Your wind coefficients.",
            &[],
        ),
        CURRENT_COEFFICIENTS: TableOf<CurrentCoefficientsKey> = key(
            "current_coefficients",
            Kind::Table(&CURRENT_COEFFICIENTS),
            Means("the manoeuvring model gives the hull force"),
            "Your current coefficients.",
            &[],
        ),
        WAVE_RESPONSE: Text = key(
            "wave_response",
            Kind::FileName,
            Means("an estimate for a box-shaped hull, if `stability` is given"),
            WAVE_RESPONSE_DOC,
            &["\"response.csv\""],
        ),
        HYDRODYNAMICS: Text = key(
            "hydrodynamics",
            Kind::FileName,
            Means(
                "heave, roll and pitch are oscillators that do not act on the motion in the \
                plane",
            ),
            HYDRODYNAMICS_DOC,
            &["\"ship.hydro\""],
        ),
        ROLL_DAMPING: Number = key(
            "roll_damping",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            Means("0.05 with `hydrodynamics` (our assumption for a hull with bilge keels)"),
            "Viscous damping of roll as a share of the critical damping, in addition to the \
             damping of `hydrodynamics`.",
            &["0.04"],
        ),
        STABILITY: TableOf<StabilityKey> = key(
            "stability",
            Kind::Table(&STABILITY),
            Means("the data of the vessel `from`; without such data the vessel does not heave, roll or pitch"),
            "Data for heave, roll and pitch.",
            &[],
        ),
        KIND: OneOf<ShipType> = key(
            "kind",
            Kind::Choice(&SHIP_TYPES),
            Means("the type that the title says, or else a bulk carrier"),
            "Type of ship, by which the view out of the window of live pages draws her deck, house and \
             cargo. No force depends on the type.",
            &["\"container\""],
        ),
        CONNING: TableOf<ConningKey> = key(
            "conning",
            Kind::Table(&CONNING),
            Means("the usual place for her type"),
            "Place of the eye on the bridge, for the view out of the window of live pages.",
            &["{ at = [-60, 0], eye_height = \"28 m\" }"],
        ),
        MODEL: Text = key(
            "model",
            Kind::FileName,
            Means("the view draws the ship by her type, her size and her outline"),
            "Binary glTF file (`.glb`) with a model of the ship, for the view out of the window of live pages. \
             The model has metres, its y axis points up, its z axis points ahead, and its origin is amidships \
             on the waterline at the ship's draught. No force depends on the model.",
            &["\"feeder.glb\""],
        ),
    }
}

static SHIP_TYPES: Choices<ShipType> = Choices(&[
    Choice {
        word: ShipType::Bulk.word(),
        value: ShipType::Bulk,
        doc: "bulk carrier or general cargo ship, with hatch covers",
    },
    Choice {
        word: ShipType::Tanker.word(),
        value: ShipType::Tanker,
        doc: "tanker or gas carrier, with pipes on deck",
    },
    Choice {
        word: ShipType::Container.word(),
        value: ShipType::Container,
        doc: "container ship, with containers on deck",
    },
    Choice {
        word: ShipType::RoRo.word(),
        value: ShipType::RoRo,
        doc: "ferry or car carrier, with high sides and the bridge forward",
    },
    Choice {
        word: ShipType::Passenger.word(),
        value: ShipType::Passenger,
        doc: "passenger ship, with decks along her whole length",
    },
    Choice { word: ShipType::Tug.word(), value: ShipType::Tug, doc: "tug" },
]);

static CONNING: TableSpec = TableSpec {
    what: "a conning position",
    doc: "Place from which a ship is conned, for the view out of the window.",
    keys: ConningKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a conning position.
    pub ConningKey {
        AT: Vector = key(
            "at",
            Kind::Vector(PLACE),
            Refused,
            "Place forward and to starboard of midship.",
            &["[-60, 0]"],
        ),
        EYE_HEIGHT: Number = key(
            "eye_height",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1.0, high: 100.0 }),
            Refused,
            "Height of the eye above the still water.",
            &["\"28 m\""],
        ),
    }
}

static PROPELLER: TableSpec = TableSpec {
    what: "a propeller",
    doc: "Propeller and shaft.",
    keys: PropellerKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a propeller.
    pub PropellerKey {
        DIAMETER: Number = key(
            "diameter",
            Kind::Quantity(LENGTH),
            Means("the value of `from`"),
            "Diameter.",
            &["\"8.5 m\""],
        ),
        FULL: Number = key(
            "full",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-3, high: 1e3 }),
            Means("the value of `from`"),
            "Full revolutions.",
            &["\"95 rpm\""],
        ),
        REVERSAL: Number = key(
            "reversal",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.1, high: 3600.0 }),
            Means("the reversal time of the vessel `from`, or 40 s"),
            "Time in which the shaft goes from full ahead to full astern.",
            &["\"60 s\""],
        ),
    }
}

static RUDDER: TableSpec = TableSpec {
    what: "a rudder",
    doc: "Rudder and steering gear.",
    keys: RudderKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a rudder.
    pub RudderKey {
        AREA: Number = key(
            "area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-4, high: 1e4 }),
            Means("the value of `from`"),
            "Movable area.",
            &["\"60 m^2\""],
        ),
        SPAN: Number = key(
            "span",
            Kind::Quantity(LENGTH),
            Means("the value of `from`"),
            "Span.",
            &["\"9 m\""],
        ),
        RATE: Number = key(
            "rate",
            Kind::Quantity(Quantity { measure: &unit::RATE_OF_TURN, low: 1e-4, high: 10.0 }),
            Means("the rudder rate of the vessel `from`, or 2.32 deg/s"),
            "Rate at which the steering gear turns the rudder.",
            &["\"2.5 deg/s\""],
        ),
        STOP: Number = key(
            "stop",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.01, high: 1.57 }),
            Means("the rudder angle of the vessel `from`, or 35 deg"),
            "Largest rudder angle to either side.",
            &["\"35 deg\""],
        ),
    }
}

/// A tunnel thruster.
pub static THRUSTER: TableSpec = TableSpec {
    what: "a thruster",
    doc: "A tunnel thruster.",
    keys: ThrusterKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a thruster.
    pub ThrusterKey {
        ALONG: Number = key(
            "along",
            Kind::Quantity(PLACE),
            Refused,
            "Distance of the thruster forward of midship.",
            &["\"60 m\""],
        ),
        FORCE: Number = key(
            "force",
            Kind::Quantity(FORCE),
            Refused,
            "Thrust at full power when the vessel is at rest.",
            &["\"250 kN\""],
        ),
        LAG: Number = key(
            "lag",
            Kind::Quantity(Quantity { measure: &unit::TIME, low: 0.0, high: 600.0 }),
            Is("8"),
            "Time constant with which the thrust follows the order.",
            &["\"10 s\""],
        ),
    }
}

/// Heave, roll and pitch.
pub static STABILITY: TableSpec = TableSpec {
    what: "a stability",
    doc: "Data of the vessel for heave, roll and pitch.",
    keys: StabilityKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a stability.
    pub StabilityKey {
        GM: Number = key(
            "gm",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 1e-3, high: 100.0 }),
            Refused,
            "Metacentric height GM.",
            &["\"2 m\""],
        ),
        GRAVITY_ABOVE_KEEL: Number = key(
            "gravity_above_keel",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 200.0 }),
            Refused,
            "Height KG of the centre of gravity above the keel.",
            &["\"10 m\""],
        ),
        WATERPLANE_AREA: Number = key(
            "waterplane_area",
            Kind::Quantity(Quantity { measure: &unit::AREA, low: 1e-3, high: 1e6 }),
            Refused,
            "Waterplane area.",
            &["\"3000 m^2\""],
        ),
    }
}
