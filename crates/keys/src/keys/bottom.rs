//! Keys of the bottom by place.

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
    doc: "The depth of the water by place, below datum, from surveys or from the chart, or from both: then the chart \
          counts where the surveys have no data. A table of depths at the nodes of a square grid is made once; between \
          the nodes depths are bilinear. The land of a chart stands 20 m above datum. Behind the front of a quay of the \
          chart the bottom goes on for two cells as before the front: the quay itself is a body of the scenario.",
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
    /// Keys of the bottom by place.
    pub BottomKey {
        SURVEY: Texts = key(
            "survey",
            Kind::FileNames,
            Means("no survey: the depths are those of the chart"),
            "Files of surveys, relative to the scenario file: ESRI ASCII grids, or rows of x, y and z. Where several have \
             data, the first one counts.",
            &["[\"berth.asc\", \"channel.xyz\"]"],
        ),
        SURVEY_COORDINATES: OneOf<SurveyCoordinates> = key(
            "survey_coordinates",
            Kind::Choice(&SURVEY_COORDINATES),
            Is("\"metres\""),
            "What x and y of the surveys are.",
            &["\"utm\""],
        ),
        SURVEY_VALUES: OneOf<SurveyValues> = key(
            "survey_values",
            Kind::Choice(&SURVEY_VALUES),
            Means("depths, or heights if most values of a survey are negative; `check` then says so"),
            "What the values of the surveys are.",
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
            Means("the cell of the survey; from a chart such a size of 1, 2, 5, 10, … m that there are at most half a million nodes"),
            "Side of a cell of the grid.",
            &["\"5 m\""],
        ),
        OUTSIDE: NameOr = key(
            "outside",
            Kind::NameOr(Quantity { measure: &unit::LENGTH, low: -20.0, high: 12_000.0 }),
            Is("\"error\""),
            "What holds where there is no data: \"error\" ends the run when a ship comes there, a length is a depth below \
             datum.",
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

/// What the coordinates of a survey are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SurveyCoordinates {
    /// Metres east and north of the scenario's origin.
    Metres,
    /// Degrees on WGS 84.
    LongitudeLatitude,
    /// Eastings and northings of UTM.
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
        doc: "x is the longitude, y the latitude on WGS 84 (degrees), about the origin of the chart.",
    },
    Choice {
        word: "utm",
        value: SurveyCoordinates::Utm,
        doc: "x is the easting, y the northing of UTM in the zone of the chart's origin, with false easting and northing \
              (m).",
    },
]);

/// What the values of a survey are.
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
    /// The least depth of the area.
    Least,
    /// Between contours, soundings and coast.
    Interpolated,
}

static CHART_DEPTHS: Choices<ChartDepths> = Choices(&[
    Choice {
        word: "least",
        value: ChartDepths::Least,
        doc: "The least depth of each depth area (DRVAL1, `depth_m`): what the chart warrants, in steps.",
    },
    Choice {
        word: "interpolated",
        value: ChartDepths::Interpolated,
        doc: "Linear in triangles between contours, soundings, edges of areas and the coast, within the least and the \
              greatest depth of each area (DRVAL1 and DRVAL2, `depth_m` and `deepest_m`). A dredged area is level.",
    },
]);
