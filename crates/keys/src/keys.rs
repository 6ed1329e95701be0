//! Every key of a scenario file: its kind, unit, bounds, default and meaning.
//!
//! The bounds are beyond anything that floats, and keep all computed numbers far from overflow. To add a key, add its
//! row to this table, then use the key in `assemble` of the crate `fenderline-scenario`.

pub mod anchor;
mod approach;
mod azimuth;
mod berthing;
mod body;
pub mod chart;
pub mod coefficients;
mod dolphin;
mod environment;
pub mod event;
pub mod exercise;
mod factors;
mod fender;
pub mod fender_row;
mod hull;
pub mod limit;
mod load;
mod long_waves;
mod material;
pub mod mooring;
pub mod order;
mod output;
mod panel;
pub mod passing;
mod provider;
pub mod quantities;
pub mod report;
mod run;
mod standing;
mod vessel;
pub mod windage;
mod world;

use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, TableSpec, key};

// Shared with vessel files.
pub use azimuth::AZIMUTH;
pub use standing::STANDINGS;
pub use vessel::{STABILITY, THRUSTER};
pub use windage::WINDAGE;

pub use self::body::BODY;
pub use self::fender::FENDER;
use self::load::LOAD;
use self::material::{MATERIAL, PAIR};
use self::output::OUTPUT;
use self::run::{CONTACT, TIME};

/// The whole file.
pub static SCENARIO: TableSpec = TableSpec {
    what: "a scenario",
    doc: "Ships, fenders, quays and tugs in the horizontal plane: x north, y east, headings \
          clockwise from north. A plain number is in SI units (angles in radians); a string \
          carries its unit, as \"4 kn\".",
    keys: &[
        key(
            "title",
            Kind::Text,
            Means("the name of the file"),
            "Title of reports.",
            &["\"Tug against a container ship's side, 4 kn\""],
        ),
        key("report", Kind::Table(&report::REPORT), Is("{}"), "Title page of reports.", &[]),
        key("time", Kind::Table(&TIME), Refused, "Time step and length of the run.", &[]),
        key(
            "output",
            Kind::Table(&OUTPUT),
            Is("{}"),
            "Which result tables the run writes, and how often.",
            &[],
        ),
        key("contact", Kind::Table(&CONTACT), Is("{}"), "How contact forces are computed.", &[]),
        key("material", Kind::Named(&MATERIAL), Is("{}"), "Contact parameters, by name.", &[]),
        key(
            "body",
            Kind::Named(&BODY),
            Refused,
            "Bodies, by name. Their order in the file is the order of results.",
            &[],
        ),
        key(
            "pair",
            Kind::List(&PAIR),
            Is("[]"),
            "Pairs of bodies that may touch. Bodies without a pair do not touch.",
            &[],
        ),
        key(
            "fender",
            Kind::Named(&fender::FENDER),
            Is("{}"),
            "Fenders on the bodies, by name.",
            &[],
        ),
        key(
            "fender_row",
            Kind::Named(&fender_row::FENDER_ROW),
            Is("{}"),
            "Rows of equal fenders, by name.",
            &[],
        ),
        key(
            "fender_files",
            Kind::Texts,
            Is("[]"),
            "Files with fender data of your own (fenders/README.md shows their form), relative \
                  to this file.",
            &["[\"our_fenders.toml\"]"],
        ),
        key(
            "berthing",
            Kind::Table(&berthing::BERTHING),
            Means("no study"),
            "Particulars for the berthing energy by formula, which the report compares with the \
             energy of the run.",
            &[],
        ),
        key(
            "environment",
            Kind::Table(&environment::ENVIRONMENT),
            Is("{}"),
            "Wind, current, waves and water.",
            &[],
        ),
        key(
            "chart",
            Kind::Table(&chart::CHART),
            Means("no chart"),
            "A chart that is drawn behind ships and quays: coast, depths, buoys, quays, names.",
            &["{ files = [\"harbour.geojson\"], coordinates = \"metres\" }"],
        ),
        key(
            "vessel",
            Kind::Named(&vessel::VESSEL),
            Is("{}"),
            "Kinds of vessels that the scenario defines, by name. Vessels of the library need no table.",
            &[],
        ),
        key(
            "vessel_files",
            Kind::Texts,
            Is("[]"),
            "Files with vessels of your own (vessels/README.md shows their form), relative to this file.",
            &["[\"our_vessels.toml\"]"],
        ),
        key(
            "tug",
            Kind::Named(&world::TUG),
            Is("{}"),
            "Tugs that are forces on vessels, by name.",
            &[],
        ),
        key("line", Kind::Named(&mooring::LINE), Is("{}"), "Mooring lines, by name.", &[]),
        key("anchor", Kind::Named(&anchor::ANCHOR), Is("{}"), "Anchors of vessels, by name.", &[]),
        key(
            "bollard",
            Kind::Named(&mooring::BOLLARD),
            Is("{}"),
            "Bollards to which orders send lines, by name.",
            &[],
        ),
        key(
            "line_handling",
            Kind::Table(&mooring::LINE_HANDLING),
            Is("{}"),
            "How lines come to a bollard.",
            &[],
        ),
        key(
            "statistics",
            Kind::Table(&limit::STATISTICS),
            Means("no statistics, unless there is a `limit`"),
            "Statistics of motions and lines.",
            &[],
        ),
        key(
            "limit",
            Kind::Named(&limit::LIMIT),
            Is("{}"),
            "Limits of motions, lines and fenders, by name.",
            &[],
        ),
        key(
            "factors",
            Kind::Table(&factors::FACTORS),
            Means("no factors"),
            "Partial factors of a guideline or a design basis, with their source.",
            &[],
        ),
        key(
            "passing",
            Kind::Named(&passing::PASSING),
            Is("{}"),
            "Ships that pass, by name. They push vessels by the flow about them.",
            &[],
        ),
        key(
            "exercise",
            Kind::Table(&exercise::EXERCISE),
            Means("no exercise"),
            "A goal for the pilot, and limits with points.",
            &[],
        ),
        key("order", Kind::List(&order::ORDER), Is("[]"), "Orders at times of the run.", &[]),
        key(
            "event",
            Kind::List(&event::EVENT),
            Is("[]"),
            "Changes of the weather and faults at times of the run.",
            &[],
        ),
        key(
            "provider",
            Kind::List(&provider::PROVIDER),
            Is("[]"),
            "External programs that apply forces to bodies.",
            &[],
        ),
        key("load", Kind::List(&LOAD), Is("[]"), "Steady or timed external loads.", &[]),
    ],
    rules: None,
};
