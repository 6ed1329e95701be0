//! Keys of fenders.

use serde_json::json;

use super::quantities::{DIRECTION, FENDER_HEIGHT, FENDER_SIZE, POSITION};
use crate::held::{Curve, Flag, ListOf, Name, Number, TableOf, Text, Vector};
use crate::keys::quantities::RETURNED_ENERGY;
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{CurveSpec, Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

const STIFFNESS: Quantity = Quantity { measure: &unit::STIFFNESS, low: 0.0, high: 1e15 };

/// A fender.
pub static FENDER: TableSpec = TableSpec {
    what: "a fender",
    doc: "A fender: on a quay, on a tug's bow or along a ship's belting. A fender touches the \
        outlines of all bodies that are paired with the fender's body; the material of the pair \
        describes the solid structure behind the fender. The fender's law of reaction by \
        deflection comes from a `type` of the fender data, a `stiffness` or a `curve`. Without \
        `type`, `stiffness` and `curve`, the reaction is the overlap area times the stiffness of \
        the material, as in the paper.",
    keys: FenderKey::ALL,
    rules: Some(|| {
        let both = |one: &str, two: &str| json!({ "not": { "required": [one, two] } });
        json!({
            "allOf": [
                both("type", "stiffness"), both("type", "curve"), both("stiffness", "curve"),
                both("size", "height"), both("size", "rated_reaction"), both("count", "cones"),
                {
                    "if": { "required": ["chains"], "properties": { "chains": {
                        "contains": { "properties": { "kind": { "const": "weight" } } }
                    } } },
                    "then": { "required": ["panel_mass"] }
                },
                {
                    "if": { "required": ["chains"], "properties": { "chains": {
                        "contains": { "properties": { "kind": { "const": "tension" } } }
                    } } },
                    "then": { "required": ["cones"] }
                },
                {
                    "if": { "required": ["cones"] },
                    "then": { "anyOf": [
                        { "required": ["type"] }, { "required": ["stiffness"] }, { "required": ["curve"] }
                    ] }
                },
                both("type", "rated_deflection"), both("hull", "hull_pressure_limit"),
                both("type", "unloading"), both("returned_energy", "unloading"),
                both("returned_energy", "unloading_law"), both("unloading", "unloading_law"),
                {
                    "if": { "required": ["unloading"] },
                    "then": { "anyOf": [{ "required": ["stiffness"] }, { "required": ["curve"] }] }
                },
                {
                    "if": { "required": ["belting"] },
                    "then": { "properties": {
                        "position": false, "facing": false, "width": false, "face_height": false,
                        "above_water": false
                    } },
                    "else": { "required": ["position", "width"] }
                },
                {
                    "if": { "required": ["rated_deflection"] },
                    "then": { "anyOf": [{ "required": ["stiffness"] }, { "required": ["curve"] }] }
                },
            ],
            "if": { "required": ["type"] },
            "then": { "anyOf": [{ "required": ["size"] }, { "required": ["height"] }] },
            "else": {
                "required": ["projection"],
                "properties": {
                    "size": false, "height": false, "rated_reaction": false, "temperature": false,
                    "count": false, "velocity_factor": false, "angle_factor": false
                }
            }
        })
    }),
};

table_keys! {
    /// Keys of a fender.
    pub FenderKey {
        ON: Name = key(
            "on",
            Kind::BodyName,
            Refused,
            "The body that carries the fender.",
            &["\"quay\""],
        ),
        POSITION: Vector = key(
            "position",
            Kind::Point(POSITION),
            Unless("`belting` is given"),
            "Middle of the line where the fender is mounted: distances forward and to starboard of \
             the body's origin.",
            &["[-60, 0]"],
        ),
        FACING: Number = key(
            "facing",
            Kind::Quantity(DIRECTION),
            Unless(
                "`belting` is given, or `position` lies on an edge or at a corner of the body's \
                 outline",
            ),
            "Direction in which the fender faces, clockwise from the body's forward direction. By \
             default the fender faces out at right angles to the edge on which it stands; at a \
             corner it faces midway between the two edges.",
            &["\"-90 deg\""],
        ),
        BELTING: Text = key(
            "belting",
            Kind::Text,
            Unless("`position` and `width` of the fender are given"),
            "Name of a belting of the vessel that carries the fender. Position, facing, width, \
             face height and height above the water come from the belting.",
            &["\"bow\""],
        ),
        WIDTH: Number = key(
            "width",
            Kind::Quantity(FENDER_SIZE),
            Unless("`belting` is given"),
            "Width of the fender's face (of the panel, if there is a panel).",
            &["\"2.4 m\""],
        ),
        FACE_HEIGHT: Number = key(
            "face_height",
            Kind::Quantity(FENDER_SIZE),
            Means("the height is the width of the face; for a pneumatic fender, the diameter"),
            "Height of the fender's face. The hull pressure is the reaction divided by width times \
             height of the face. Hull pressure is computed only if `face_height`, `hull` or \
             `hull_pressure_limit` is given.",
            &["\"3 m\""],
        ),
        ABOVE_WATER: Number = key(
            "above_water",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: -100.0, high: 100.0 }),
            Means("the middle of the face is at the waterline; on a fixed body, at datum"),
            "Height of the middle of the fender's face above the still waterline, or above datum \
             on a fixed body: at this height the fender force heels a vessel. A hull with one \
             outline has a side at any height; a hull with `outlines` has a side only between the \
             lowest and the highest outline.",
            &["\"2 m\""],
        ),
        FLOATING: Flag = key(
            "floating",
            Kind::Flag,
            Is("false"),
            "True for a fender that floats, such as a pneumatic fender, and rises with the tide: \
             `above_water` is then above the present water level, also on a fixed body.",
            &["true"],
        ),
        PROJECTION: Number = key(
            "projection",
            Kind::Quantity(FENDER_HEIGHT),
            Means("the height of the fender's type"),
            "Distance from the fender's mounting to its face when the fender is uncompressed.",
            &["\"1.5 m\""],
        ),
        MATERIAL: Name = key(
            "material",
            Kind::MaterialName,
            Refused,
            "Material of the fender. The material gives friction and damping; it also gives the \
             restitution if `unloading_law` is false, and the stiffness if the fender has no other \
             law of reaction.",
            &["\"facing\""],
        ),
        ROLLING_RESISTANCE: Number = key(
            "rolling_resistance",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 1.0 }),
            Means("the face slides, with the friction of the material"),
            "For a roller or wheel fender: resistance along the berth divided by the reaction, \
             instead of the friction of the material.",
            &["0.05"],
        ),
        TYPE: Text = key(
            "type",
            Kind::Text,
            Means("no type"),
            "A family of the fender data: cone, cone SPC, unit element, V leg, pneumatic, or a \
             family of `fender_files`.",
            &["\"cone\""],
        ),
        SIZE: Text = key(
            "size",
            Kind::Text,
            Unless("`height` is given, or the fender has no `type`"),
            "Size of the fender within its `type`, by the designation in the fender data.",
            &["\"3300x6500 50kPa\""],
        ),
        HEIGHT: Number = key(
            "height",
            Kind::Quantity(FENDER_HEIGHT),
            Unless("`size` is given, or the fender has no `type`"),
            "Height of the uncompressed fender, instead of a `size` of the fender data.",
            &["\"1.2 m\""],
        ),
        RATED_REACTION: Number = key(
            "rated_reaction",
            Kind::Quantity(Quantity { measure: &unit::FORCE, low: 1.0, high: 1e9 }),
            Means("the reaction of the type's reference size, scaled with the square of the \
                   height"),
            "Rated reaction of one fender of this type and height.",
            &["\"900 kN\""],
        ),
        COUNT: Number = key(
            "count",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 1.0, high: 1000.0 }),
            Means("one"),
            "Number of fenders of this type behind the one face.",
            &["2"],
        ),
        CONES: ListOf<super::panel::ConeKey> = key(
            "cones",
            Kind::List(&super::panel::CONE),
            Means("one fender, or `count` fenders behind a face that does not turn"),
            "Several equal fenders (\"cones\") at given places behind one panel, which turns about \
             a vertical axis under the reactions of the cones. `width` is the width of the panel. \
             In the results, shares of rated values refer to the most compressed cone. For cones \
             behind a panel, an unloading curve counts only with the share of the energy that it \
             returns from the rated deflection.",
            &["[{ at = \"-1.2 m\" }, { at = \"1.2 m\" }]"],
        ),
        CHAINS: ListOf<super::panel::ChainKey> = key(
            "chains",
            Kind::List(&super::panel::CHAIN),
            Means("no chains"),
            "Tension, shear and weight chains of the panel. The contact engine computes how \
             tension chains hold the panel; the forces of shear and weight chains follow from \
             statics.",
            &[
                "[{ kind = \"shear\", slack = \"20 mm\", stiffness = \"40 MN/m\", break_load = \
                 \"500 kN\" }]",
            ],
        ),
        PANEL_MASS: Number = key(
            "panel_mass",
            Kind::Quantity(Quantity { measure: &unit::MASS, low: 0.0, high: 1e6 }),
            Unless("no weight chain is given"),
            "Mass that the weight chains carry: the panel with everything that hangs on the panel.",
            &["\"2.5 t\""],
        ),
        STIFFNESS: Number = key(
            "stiffness",
            Kind::Quantity(STIFFNESS),
            Means("no linear law"),
            "Stiffness of the fender: reaction divided by deflection.",
            &["\"2 MN/m\""],
        ),
        CURVE: Curve = key(
            "curve",
            Kind::Curve(&CURVE),
            Means("the fender has no curve of its own"),
            "Curve of the fender: rows of deflection and reaction, joined by straight lines; the \
             first row is [0, 0].",
            &["[[0, 0], [\"0.3 m\", \"600 kN\"], [\"0.8 m\", \"650 kN\"]]"],
        ),
        RETURNED_ENERGY: Number = key(
            "returned_energy",
            Kind::Quantity(RETURNED_ENERGY),
            Means("the share that the fender's type returns; 55 %, assumed for solid rubber, if the type has no share"),
            "Share of the absorbed energy that the rubber returns: in unloading the reaction \
             follows a lower curve than in loading, and restitution has no effect. Coupled method \
             only.",
            &["\"55 %\""],
        ),
        UNLOADING: Curve = key(
            "unloading",
            Kind::Curve(&CURVE),
            Means("`returned_energy` or the type gives the unloading curve"),
            "The unloading curve: rows of deflection and reaction, joined by straight lines, the \
             first row [0, 0]. The unloading curve may nowhere lie above the `curve` or \
             `stiffness` of the fender. The reaction comes down to the unloading curve within the \
             first tenth of the difference in energy, so a cycle of loading and unloading loses \
             4.45 % less energy than the area between both curves. Coupled method only.",
            &["[[0, 0], [\"0.3 m\", \"250 kN\"], [\"0.8 m\", \"600 kN\"]]"],
        ),
        UNLOADING_LAW: Flag = key(
            "unloading_law",
            Kind::Flag,
            Means("true"),
            "Whether the reaction falls by an unloading law when the hull retreats. If false, the \
             reaction falls by the restitution of the material; the fenders of a ship at rest then \
             chatter.",
            &["false"],
        ),
        RATED_DEFLECTION: Number = key(
            "rated_deflection",
            Kind::Quantity(FENDER_HEIGHT),
            Means("the rated deflection of the fender's type, or the deflection at the end of the curve"),
            "Rated deflection of a fender with a `stiffness` or a `curve`.",
            &["\"0.8 m\""],
        ),
        STOP: TableOf<StopKey> = key(
            "stop",
            Kind::Table(&STOP),
            Means(
                "a stop at the end of the curve or of the projection, 50 times as stiff as the \
                 mean stiffness of the fender",
            ),
            "Stop at the end of the fender's travel, where the fender becomes much stiffer.",
            &[],
        ),
        TEMPERATURE: Number = key(
            "temperature",
            Kind::Quantity(Quantity { measure: &unit::CELSIUS, low: -60.0, high: 80.0 }),
            Means("no correction"),
            "Temperature of the fender; a plain number is in degrees Celsius. Only a fender of a \
             type with temperature factors may have a temperature.",
            &["10", "\"40 degC\"", "\"104 degF\""],
        ),
        TOLERANCE: Number = key(
            "tolerance",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: -0.5, high: 0.5 }),
            Is("0"),
            "Deviation of the fender's reaction from the rated reaction, as a share: a \
             manufacturing tolerance.",
            &["\"-10 %\""],
        ),
        VELOCITY_FACTOR: Flag = key(
            "velocity_factor",
            Kind::Flag,
            Means("true"),
            "Whether the reaction is corrected for the speed of approach, if the type has a factor \
             for this speed.",
            &["false"],
        ),
        ANGLE_FACTOR: Flag = key(
            "angle_factor",
            Kind::Flag,
            Means("true"),
            "Whether reaction and energy are corrected for the angle of the hull, if the type has \
             factors for this angle.",
            &["false"],
        ),
        HULL_PRESSURE_LIMIT: Number = key(
            "hull_pressure_limit",
            Kind::Quantity(Quantity { measure: &unit::STIFFNESS_PER_AREA, low: 1.0, high: 1e9 }),
            Means("the hull pressure that the ship type in `hull` can bear, or no limit"),
            "Hull pressure that the ship's side can bear.",
            &["\"200 kN/m^2\""],
        ),
        HULL: Text = key(
            "hull",
            Kind::Text,
            Means("`hull_pressure_limit`, or no limit"),
            "Type of ship; the fender data give the hull pressure that the side of this type can \
             bear.",
            &["\"container ship\""],
        ),
    }
}

static CURVE: CurveSpec = CurveSpec {
    from: ("deflection", Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e3 }),
    to: ("reaction", Quantity { measure: &unit::FORCE, low: 0.0, high: 1e12 }),
    fewest: 2,
};

static STOP: TableSpec = TableSpec {
    what: "a stop",
    doc: "A stop: a second spring at the end of a fender's travel.",
    keys: StopKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a stop.
    pub StopKey {
        FROM: Number = key(
            "from",
            Kind::Quantity(FENDER_HEIGHT),
            Refused,
            "Deflection at which the stop begins.",
            &["\"0.9 m\""],
        ),
        STIFFNESS: Number = key(
            "stiffness",
            Kind::Quantity(STIFFNESS),
            Refused,
            "Stiffness of the stop.",
            &["\"50 MN/m\""],
        ),
    }
}
