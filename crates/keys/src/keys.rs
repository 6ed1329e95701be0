//! Every key of a scenario file: its kind, unit, bounds, default and meaning.
//!
//! The bounds of the keys are wider than the figures of any real ship, and keep all computed numbers far from overflow.
//! To add a key, add a row for the key to its table below, then use the constant of the key in `assemble` of the crate
//! `fenderline-scenario`.

pub mod anchor;
pub mod approach;
pub mod azimuth;
pub mod berthing;
pub mod body;
pub mod bollard_row;
pub mod bottom;
pub mod chart;
pub mod coefficients;
pub mod dolphin;
pub mod environment;
pub mod event;
pub mod exercise;
pub mod factors;
pub mod fender;
pub mod fender_row;
pub mod hull;
pub mod limit;
pub mod load;
pub mod long_waves;
pub mod material;
pub mod mooring;
pub mod order;
pub mod output;
pub mod panel;
pub mod passing;
pub mod plan;
pub mod provider;
pub mod quantities;
pub mod quay_line;
pub mod report;
pub mod run;
pub mod standing;
pub mod vessel;
pub mod windage;
pub mod world;

use crate::held::{ListOf, NamedOf, TableOf, Text, Texts};
use crate::spec::Absent::{Is, Means, Refused};
use crate::spec::{Kind, TableSpec, key};
use crate::table_keys;

// Shared with vessel files.
pub use azimuth::{AZIMUTH, AzimuthKey};
pub use standing::STANDINGS;
pub use vessel::{STABILITY, StabilityKey, THRUSTER, ThrusterKey};
pub use windage::{WINDAGE, WindageKey};

pub use self::body::{BODY, BodyKey};
pub use self::fender::FENDER;
use self::load::{LOAD, LoadKey};
use self::material::{MATERIAL, MaterialKey, PAIR, PairKey};
use self::output::{OUTPUT, OutputKey};
use self::run::{CONTACT, ContactKey, TIME, TimeKey};

/// The whole file.
pub static SCENARIO: TableSpec = TableSpec {
    what: "a scenario",
    doc: "A scenario describes ships, fenders, quays and tugs in the horizontal plane: x points \
          north, y points east, headings are clockwise from north. A plain number is in SI units \
          (angles in radians); a number with another unit is a string, as \"4 kn\".",
    keys: ScenarioKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a scenario.
    pub ScenarioKey {
        TITLE: Text = key(
            "title",
            Kind::Text,
            Means("the name of the file"),
            "Title of reports.",
            &["\"Tug against a container ship's side, 4 kn\""],
        ),
        REPORT: TableOf<report::ReportKey> = key(
            "report",
            Kind::Table(&report::REPORT),
            Is("{}"),
            "Title page of reports.",
            &[],
        ),
        TIME: TableOf<TimeKey> = key(
            "time",
            Kind::Table(&TIME),
            Refused,
            "Time step and length of the run.",
            &[],
        ),
        OUTPUT: TableOf<OutputKey> = key(
            "output",
            Kind::Table(&OUTPUT),
            Is("{}"),
            "Which result tables the run writes, and how often.",
            &[],
        ),
        CONTACT: TableOf<ContactKey> = key(
            "contact",
            Kind::Table(&CONTACT),
            Is("{}"),
            "How contact forces are computed.",
            &[],
        ),
        MATERIAL: NamedOf<MaterialKey> = key(
            "material",
            Kind::Named(&MATERIAL),
            Is("{}"),
            "Contact parameters, by name.",
            &[],
        ),
        BODY: NamedOf<BodyKey> = key(
            "body",
            Kind::Named(&BODY),
            Refused,
            "Bodies, by name. The results list the bodies in the order of the file.",
            &[],
        ),
        PAIR: ListOf<PairKey> = key(
            "pair",
            Kind::List(&PAIR),
            Is("[]"),
            "Pairs of bodies that may touch. Bodies without a pair do not touch.",
            &[],
        ),
        FENDER: NamedOf<fender::FenderKey> = key(
            "fender",
            Kind::Named(&fender::FENDER),
            Is("{}"),
            "Fenders on the bodies, by name.",
            &[],
        ),
        FENDER_ROW: NamedOf<fender_row::FenderRowKey> = key(
            "fender_row",
            Kind::Named(&fender_row::FENDER_ROW),
            Is("{}"),
            "Rows of equal fenders, by name.",
            &[],
        ),
        FENDER_FILES: Texts = key(
            "fender_files",
            Kind::Texts,
            Is("[]"),
            "Files with your own fender data, named relative to the scenario file; \
             fenders/README.md shows the form of such files.",
            &["[\"our_fenders.toml\"]"],
        ),
        BERTHING: TableOf<berthing::BerthingKey> = key(
            "berthing",
            Kind::Table(&berthing::BERTHING),
            Means("no study"),
            "Particulars for the berthing energy by PIANC's formula, which the report compares \
             with the berthing energy of the run.",
            &[],
        ),
        ENVIRONMENT: TableOf<environment::EnvironmentKey> = key(
            "environment",
            Kind::Table(&environment::ENVIRONMENT),
            Is("{}"),
            "Wind, current, waves and water.",
            &[],
        ),
        CHART: TableOf<chart::ChartKey> = key(
            "chart",
            Kind::Table(&chart::CHART),
            Means("no chart"),
            "A chart that is drawn behind ships and quays: coast, depths, buoys, quays, names.",
            &["{ files = [\"harbour.geojson\"], coordinates = \"metres\" }"],
        ),
        VESSEL: NamedOf<vessel::VesselKey> = key(
            "vessel",
            Kind::Named(&vessel::VESSEL),
            Is("{}"),
            "Kinds of vessels that the scenario defines, by name. Vessels of the library need no \
             table.",
            &[],
        ),
        VESSEL_FILES: Texts = key(
            "vessel_files",
            Kind::Texts,
            Is("[]"),
            "Files with your own vessels, named relative to the scenario file; vessels/README.md \
             shows the form of such files.",
            &["[\"our_vessels.toml\"]"],
        ),
        TUG: NamedOf<world::TugKey> = key(
            "tug",
            Kind::Named(&world::TUG),
            Is("{}"),
            "Tugs that are only forces on vessels, without a hull of their own, by name.",
            &[],
        ),
        LINE: NamedOf<mooring::LineKey> = key(
            "line",
            Kind::Named(&mooring::LINE),
            Is("{}"),
            "Mooring lines, by name.",
            &[],
        ),
        ANCHOR: NamedOf<anchor::AnchorKey> = key(
            "anchor",
            Kind::Named(&anchor::ANCHOR),
            Is("{}"),
            "Anchors of vessels, by name.",
            &[],
        ),
        BOLLARD: NamedOf<mooring::BollardKey> = key(
            "bollard",
            Kind::Named(&mooring::BOLLARD),
            Is("{}"),
            "Bollards on which orders put mooring lines, by name.",
            &[],
        ),
        BOLLARD_ROW: NamedOf<bollard_row::BollardRowKey> = key(
            "bollard_row",
            Kind::Named(&bollard_row::BOLLARD_ROW),
            Is("{}"),
            "Rows of equal bollards, by name.",
            &[],
        ),
        LINE_HANDLING: TableOf<mooring::LineHandlingKey> = key(
            "line_handling",
            Kind::Table(&mooring::LINE_HANDLING),
            Is("{}"),
            "How mooring lines are brought to a bollard, and how long this takes.",
            &[],
        ),
        STATISTICS: TableOf<limit::StatisticsKey> = key(
            "statistics",
            Kind::Table(&limit::STATISTICS),
            Means("no statistics, unless the scenario has a `limit`"),
            "Statistics of the motions of vessels and of the tension of mooring lines.",
            &[],
        ),
        LIMIT: NamedOf<limit::LimitKey> = key(
            "limit",
            Kind::Named(&limit::LIMIT),
            Is("{}"),
            "Limits of vessels' motions and of the loads of lines and fenders, by name.",
            &[],
        ),
        FACTORS: TableOf<factors::FactorsKey> = key(
            "factors",
            Kind::Table(&factors::FACTORS),
            Means("no factors"),
            "Partial factors of a guideline or a design basis, with their source.",
            &[],
        ),
        PASSING: NamedOf<passing::PassingKey> = key(
            "passing",
            Kind::Named(&passing::PASSING),
            Is("{}"),
            "Ships that pass the vessels of the scenario, by name. The flow about a passing ship \
             pushes the vessels that she passes.",
            &[],
        ),
        PLAN: NamedOf<plan::PlanKey> = key(
            "plan",
            Kind::Named(&plan::PLAN),
            Is("{}"),
            "Passage plans of vessels, by name: waypoints, turns, speeds and corridors. Pages and \
             reports draw a plan and compare the vessel's way with the plan.",
            &[],
        ),
        EXERCISE: TableOf<exercise::ExerciseKey> = key(
            "exercise",
            Kind::Table(&exercise::EXERCISE),
            Means("no exercise"),
            "An exercise: a goal for the pilot, and limits that cost points if they are exceeded.",
            &[],
        ),
        ORDER: ListOf<order::OrderKey> = key(
            "order",
            Kind::List(&order::ORDER),
            Is("[]"),
            "Orders to ships, tugs and linesmen, each at a time of the run.",
            &[],
        ),
        EVENT: ListOf<event::EventKey> = key(
            "event",
            Kind::List(&event::EVENT),
            Is("[]"),
            "Changes of the weather and faults, each at a time of the run.",
            &[],
        ),
        PROVIDER: ListOf<provider::ProviderKey> = key(
            "provider",
            Kind::List(&provider::PROVIDER),
            Is("[]"),
            "External programs that apply forces to bodies.",
            &[],
        ),
        LOAD: ListOf<LoadKey> = key(
            "load",
            Kind::List(&LOAD),
            Is("[]"),
            "External loads on bodies, steady or by time.",
            &[],
        ),
    }
}
