//! Keys for the statistics of a run, and for the limits that a run must keep.

use fenderline_sim::statistics::{Measure, MotionName};
use serde_json::json;

use super::quantities::TIME;
use crate::choices::{Choice, Choices};
use crate::held::{Name, Number, OneOf};
use crate::spec::Absent::{Is, Means, Refused, Unless};
use crate::spec::{Kind, Quantity, TableSpec, key};
use crate::table_keys;
use crate::units::measures as unit;

pub(super) static STATISTICS: TableSpec = TableSpec {
    what: "a table of statistics",
    doc: "Statistics of the motions of vessels in six degrees of freedom, and cycles of the \
        tension of lines.",
    keys: StatisticsKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a table of statistics.
    pub StatisticsKey {
        FROM: Number = key(
        "from",
        Kind::Quantity(TIME),
        Is("0"),
        "Time of the run from which motions count in the statistics. Choose the time so that the \
         motions with which the ship comes to rest do not count.",
        &["\"5 min\""],
    ),
    }
}

pub(super) static LIMIT: TableSpec = TableSpec {
    what: "a limit",
    doc: "Largest permissible value of a motion, a line or a fender. The verdict of the run says \
          if the limit is exceeded. fenderline has no limits of its own: take the limits of your \
          terminal, and look whether these limits mean amplitudes or ranges, largest or \
          significant values.",
    keys: LimitKey::ALL,
    rules: Some(|| {
        let words = |words: &[&str]| json!({ "enum": words });
        json!({ "oneOf": [
            {
                "required": ["statistic", "distance"],
                "properties": { "of": words(&["surge", "sway", "heave"]), "angle": false, "share": false }
            },
            {
                "required": ["statistic", "angle"],
                "properties": { "of": words(&["roll", "pitch", "yaw"]), "distance": false, "share": false }
            },
            {
                "required": ["share"],
                "properties": {
                    "of": words(&["lines", "fenders"]), "vessel": false, "statistic": false, "distance": false,
                    "angle": false
                }
            }
        ] })
    }),
};

table_keys! {
    /// Keys of a limit.
    pub LimitKey {
        OF: OneOf<Subject> = key(
            "of",
            Kind::Choice(&SUBJECTS),
            Refused,
            "The motion or the load that is limited.",
            &["\"surge\""],
        ),
        VESSEL: Name = key(
            "vessel",
            Kind::BodyName,
            Means("the first vessel of the scenario; a limit of lines or fenders has no vessel"),
            "The body of the vessel whose motion is limited.",
            &["\"d\""],
        ),
        STATISTIC: OneOf<Measure> = key(
            "statistic",
            Kind::Choice(&MEASURES),
            Unless("the limit is a limit of lines or fenders"),
            "Which statistic of the motion about its mean is limited.",
            &["\"significant range\""],
        ),
        DISTANCE: Number = key(
            "distance",
            Kind::Quantity(Quantity { measure: &unit::LENGTH, low: 0.0, high: 1e4 }),
            Unless("the limited quantity is an angle or a share"),
            "Limit of surge, sway or heave.",
            &["\"0.8 m\""],
        ),
        ANGLE: Number = key(
            "angle",
            Kind::Quantity(Quantity { measure: &unit::ANGLE, low: 0.0, high: 6.3 }),
            Unless("the limited quantity is a distance or a share"),
            "Limit of roll, pitch or yaw.",
            &["\"2 deg\""],
        ),
        SHARE: Number = key(
            "share",
            Kind::Quantity(Quantity { measure: &unit::PLAIN_NUMBER, low: 0.0, high: 10.0 }),
            Unless("a motion is limited"),
            "Limit as a share of a line's break load or of a fender's rating.",
            &["0.5"],
        ),
    }
}

/// What is limited: a motion, lines or fenders.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Subject {
    /// A motion.
    Motion(MotionName),
    /// Lines.
    Lines,
    /// Fenders.
    Fenders,
}

static SUBJECTS: Choices<Subject> = Choices(&[
    Choice {
        word: "surge",
        value: Subject::Motion(MotionName::Surge),
        doc: "motion of the vessel's centre of gravity along the mean heading",
    },
    Choice {
        word: "sway",
        value: Subject::Motion(MotionName::Sway),
        doc: "motion of the vessel's centre of gravity across the mean heading",
    },
    Choice { word: "heave", value: Subject::Motion(MotionName::Heave), doc: "motion up and down" },
    Choice { word: "roll", value: Subject::Motion(MotionName::Roll), doc: "roll" },
    Choice { word: "pitch", value: Subject::Motion(MotionName::Pitch), doc: "pitch" },
    Choice { word: "yaw", value: Subject::Motion(MotionName::Yaw), doc: "heading" },
    Choice {
        word: "lines",
        value: Subject::Lines,
        doc: "the largest tension of any line since the start of the run, divided by the break \
              load of the line",
    },
    Choice {
        word: "fenders",
        value: Subject::Fenders,
        doc: "the largest energy, reaction or deflection of any fender since the start of the run, \
              divided by the rated value",
    },
]);

static MEASURES: Choices<Measure> = Choices(&[
    Choice {
        word: "maximum",
        value: Measure::Maximum,
        doc: "largest distance of the motion from its mean",
    },
    Choice {
        word: "significant",
        value: Measure::Significant,
        doc: "mean of the highest third of the peaks; a peak is the largest distance of the motion \
              from its mean between two crossings of the mean",
    },
    Choice {
        word: "maximum range",
        value: Measure::MaximumRange,
        doc: "largest range of the motion from a crest to the next trough",
    },
    Choice {
        word: "significant range",
        value: Measure::SignificantRange,
        doc: "mean of the highest third of the motion's ranges from a crest to the next trough",
    },
    Choice {
        word: "standard deviation",
        value: Measure::Deviation,
        doc: "root mean square of the distance of the motion from its mean",
    },
]);
