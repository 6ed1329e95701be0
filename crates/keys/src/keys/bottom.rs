//! Keys of the depth of the water by place.

use fenderline_sim::environment::BankMethod;
use serde_json::json;

use crate::choices::{Choice, Choices};
use crate::held::{NameOr, Number, OneOf, Texts};
use crate::spec::Absent::{Is, Means};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static BOTTOM: TableSpec = TableSpec {
    what: "a bottom",
    doc: "The depth of the water by place, below datum, from surveys, from the chart, or from both: then the chart \
          counts where the surveys have no data. Before the run the program makes a table of depths at the nodes of a \
          square grid; between the nodes depths are interpolated bilinearly. The land of a chart stands 20 m above \
          datum. Behind the front of a quay of the chart the water keeps, for two cells of the grid, the depth before \
          the front, because the quay itself is a body of the scenario.",
    keys: BottomKey::ALL,
    rules: Some(|| {
        json!({
            "anyOf": [{ "required": ["survey"] }, { "required": ["chart"] }],
            "allOf": [{ "properties": { "survey": { "minItems": 1 } } }],
            "dependentRequired": { "survey_coordinates": ["survey"], "survey_values": ["survey"] }
        })
    }),
};

table_keys! {
    /// Keys of the depth of the water by place.
    pub BottomKey {
        SURVEY: Texts = key(
            "survey",
            Kind::FileNames,
            Means("no survey: the depths are those of the chart"),
            "Files of surveys, relative to the scenario file: ESRI ASCII grids, or rows of x, y and z. Where \
             several surveys have data, the survey that is listed first counts.",
            &["[\"berth.asc\", \"channel.xyz\"]"],
        ),
        SURVEY_COORDINATES: OneOf<SurveyCoordinates> = key(
            "survey_coordinates",
            Kind::Choice(&SURVEY_COORDINATES),
            Is("\"metres\""),
            "What the coordinates x and y of the surveys mean: metres, degrees or UTM.",
            &["\"utm\""],
        ),
        SURVEY_VALUES: OneOf<SurveyValues> = key(
            "survey_values",
            Kind::Choice(&SURVEY_VALUES),
            Means("depths, or heights if most values of a survey are negative; `check` then says so"),
            "Whether the values of the surveys are depths or heights.",
            &["\"depths\""],
        ),
        CHART: OneOf<ChartDepths> = key(
            "chart",
            Kind::Choice(&CHART_DEPTHS),
            Means("the depths of the chart are only drawn"),
            "How depths are taken from the depth areas of the chart.",
            &["\"interpolated\""],
        ),
        CELL: Number = key(
            "cell",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.1, high: 1e4 }),
            Means(
                "the cell of the survey; for a chart the smallest of 1, 2, 5, 10, … m with which the grid has about \
                 half a million nodes at most",
            ),
            "Side of a cell of the grid.",
            &["\"5 m\""],
        ),
        OUTSIDE: NameOr = key(
            "outside",
            Kind::NameOr(Quantity { measure: &unit::LENGTH, low: -20.0, high: 12_000.0 }),
            Is("\"error\""),
            "Depth of the water where neither surveys nor chart have data: with \"error\" the run ends when a ship \
             comes there; a length is the depth below datum there.",
            &["\"error\"", "\"15 m\""],
        ),
        BANKS: OneOf<Option<BankMethod>> = key(
            "banks",
            Kind::Choice(&BANKS),
            Is("\"norrbin\""),
            "Method for the force of the banks that the bottom has, to both sides of a vessel as far as 10 beams. Cross-sections \
             at six places along her are cut into level layers, from the surface to the mean depth under her. A layer ends \
             at a vertical wall, where the bottom first stands above the layer; the vertical wall that stands for a side \
             has the mean effect of the side's layers. So a vertical bank stands for itself, and a sloping or submerged \
             bank for a wall farther off. These walls are our assumption: no whole set of published formulas for banks of any \
             shape could be read. The effect of banks is UNVALIDATED.",
            &["\"image\"", "\"none\""],
        ),
    }
}

static BANKS: Choices<Option<BankMethod>> = Choices(&[
    Choice {
        word: "norrbin",
        value: Some(BankMethod::Norrbin),
        doc: "Norrbin's formulas for a vertical wall (from memory): suction to the wall, and a moment that turns the bow away. \
              Three beams off, the suction is 3 to 11 times that of a panel method.",
    },
    Choice {
        word: "image",
        value: Some(BankMethod::Image),
        doc: "The flow of the vessel's image behind a wall along her, as for `bank`: suction alone, for vessels of at least \
              3.5 beams.",
    },
    Choice { word: "none", value: None, doc: "No force of banks." },
]);

/// The kind of coordinates in which a survey gives places.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurveyCoordinates {
    /// Metres east and north of the scenario's origin.
    Metres,
    /// Degrees on WGS 84.
    LongitudeLatitude,
    /// Eastings and northings of the UTM projection.
    Utm,
}

static SURVEY_COORDINATES: Choices<SurveyCoordinates> = Choices(&[
    Choice {
        word: "metres",
        value: SurveyCoordinates::Metres,
        doc: "x is east, y is north of the scenario's origin (m).",
    },
    Choice {
        word: "longitude_latitude",
        value: SurveyCoordinates::LongitudeLatitude,
        doc: "x is the longitude, y the latitude on WGS 84 (degrees); the program projects both about the origin of \
              the chart.",
    },
    Choice {
        word: "utm",
        value: SurveyCoordinates::Utm,
        doc: "x is the easting, y the northing of the UTM projection in the zone of the chart's origin, with false \
              easting and northing (m).",
    },
]);

/// Whether the values of a survey are depths or heights.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurveyValues {
    /// Depths below datum, positive down.
    Depths,
    /// Heights above datum, positive up.
    Heights,
}

static SURVEY_VALUES: Choices<SurveyValues> = Choices(&[
    Choice {
        word: "depths",
        value: SurveyValues::Depths,
        doc: "Depths below datum, positive down (m).",
    },
    Choice {
        word: "heights",
        value: SurveyValues::Heights,
        doc: "Heights above datum, positive up (m).",
    },
]);

/// How depths are taken from a chart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChartDepths {
    /// The depth is the least depth of the chart's depth area.
    Least,
    /// The depth is interpolated between contours, soundings and coast.
    Interpolated,
}

static CHART_DEPTHS: Choices<ChartDepths> = Choices(&[
    Choice {
        word: "least",
        value: ChartDepths::Least,
        doc: "Everywhere in a depth area, the depth is the least depth of the area (DRVAL1, `depth_m`), which the \
              chart warrants; at the edge of an area the depth has a step.",
    },
    Choice {
        word: "interpolated",
        value: ChartDepths::Interpolated,
        doc: "The depth is linear in triangles between contours, soundings, edges of areas and the coast, within the \
              least and the greatest depth of each area (DRVAL1 and DRVAL2, `depth_m` and `deepest_m`). The bottom of \
              a dredged area is level.",
    },
]);
