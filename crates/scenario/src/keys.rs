//! Every key of a scenario file: its kind, unit, bounds, default and meaning.
//!
//! The bounds keep all that the simulation computes far from overflow and are beyond anything that
//! floats. To add a key: add it here, then use it in [`crate::assemble`].

mod azimuth;
mod berthing;
mod body;
mod environment;
mod fender;
mod load;
mod material;
pub(crate) mod order;
mod provider;
mod run;
mod standing;
mod vessel;
pub(crate) mod windage;
mod world;

use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{KeySpec, Kind, TableSpec};

// What vessel files share with scenarios.
pub(crate) use azimuth::AZIMUTH;
pub(crate) use standing::STANDINGS;
pub(crate) use vessel::{STABILITY, THRUSTER};
pub(crate) use windage::WINDAGE;
pub(crate) use world::{LENGTH as LENGTH_M, PLACE as FORWARD_M, key};

use self::body::{BODY, POSITION_M};
use self::load::LOAD;
use self::material::{MATERIAL, PAIR};
use self::run::{CONTACT, TIME};

/// The whole file.
pub(crate) static SCENARIO: TableSpec = TableSpec {
    what: "a scenario",
    doc: "Ships, fenders, quays and tugs in the horizontal plane: x north, y east, headings \
          clockwise from north. A plain number is in SI units (angles in radians); a string \
          carries its unit, as \"4 kn\".",
    keys: &[
        KeySpec {
            name: "title",
            kind: Kind::Text,
            absent: Means("the name of the file"),
            doc: "Title of reports.",
            examples: &["\"Tug against a container ship's side, 4 kn\""],
        },
        KeySpec {
            name: "time",
            kind: Kind::Table(&TIME),
            absent: Refused,
            doc: "Time step and length of the run.",
            examples: &[],
        },
        KeySpec {
            name: "contact",
            kind: Kind::Table(&CONTACT),
            absent: Is("{}"),
            doc: "How contact forces are computed.",
            examples: &[],
        },
        KeySpec {
            name: "material",
            kind: Kind::Named(&MATERIAL),
            absent: Is("{}"),
            doc: "Contact parameters, by name.",
            examples: &[],
        },
        KeySpec {
            name: "body",
            kind: Kind::Named(&BODY),
            absent: Refused,
            doc: "Bodies, by name. Their order in the file is the order of results.",
            examples: &[],
        },
        KeySpec {
            name: "pair",
            kind: Kind::List(&PAIR),
            absent: Is("[]"),
            doc: "Pairs of bodies that may touch. Bodies without a pair do not touch.",
            examples: &[],
        },
        KeySpec {
            name: "fender",
            kind: Kind::Named(&fender::FENDER),
            absent: Is("{}"),
            doc: "Fenders on the bodies, by name.",
            examples: &[],
        },
        KeySpec {
            name: "fender_files",
            kind: Kind::Texts,
            absent: Is("[]"),
            doc: "Files with fender data of your own (fenders/README.md shows their form), relative \
                  to this file.",
            examples: &["[\"our_fenders.toml\"]"],
        },
        KeySpec {
            name: "berthing",
            kind: Kind::Table(&berthing::BERTHING),
            absent: Means("no study"),
            doc: "Particulars for the berthing energy by formula beside that of the run.",
            examples: &[],
        },
        KeySpec {
            name: "environment",
            kind: Kind::Table(&environment::ENVIRONMENT),
            absent: Is("{}"),
            doc: "Wind, current, waves and water.",
            examples: &[],
        },
        KeySpec {
            name: "vessel",
            kind: Kind::Named(&vessel::VESSEL),
            absent: Is("{}"),
            doc: "Kinds of vessels that the scenario defines, by name. Vessels of the library need no table.",
            examples: &[],
        },
        KeySpec {
            name: "vessel_files",
            kind: Kind::Texts,
            absent: Is("[]"),
            doc: "Files with vessels of your own (vessels/README.md shows their form), relative to this file.",
            examples: &["[\"our_vessels.toml\"]"],
        },
        KeySpec {
            name: "tug",
            kind: Kind::Named(&world::TUG),
            absent: Is("{}"),
            doc: "Tugs that are forces on vessels, by name.",
            examples: &[],
        },
        KeySpec {
            name: "line",
            kind: Kind::Named(&world::LINE),
            absent: Is("{}"),
            doc: "Mooring lines, by name.",
            examples: &[],
        },
        KeySpec {
            name: "order",
            kind: Kind::List(&order::ORDER),
            absent: Is("[]"),
            doc: "Orders at times of the run.",
            examples: &[],
        },
        KeySpec {
            name: "provider",
            kind: Kind::List(&provider::PROVIDER),
            absent: Is("[]"),
            doc: "External programs that apply forces to bodies.",
            examples: &[],
        },
        KeySpec {
            name: "load",
            kind: Kind::List(&LOAD),
            absent: Is("[]"),
            doc: "Steady or timed external loads.",
            examples: &[],
        },
    ],
    rules: None,
};
