//! Keys of the sources of a vessel's numbers.

use fenderline_keys::keys::STANDINGS;
use fenderline_keys::spec::Absent::Refused;
use fenderline_keys::spec::{Kind, TableSpec, key};

pub(super) static SOURCE: TableSpec = TableSpec {
    what: "a source",
    doc: "Source of some of a vessel's numbers.",
    keys: &[
        key(
            "of",
            Kind::Texts,
            Refused,
            "Keys of the vessel, such as `beam`, `propeller` or `propeller.wake`. The name of a \
             table covers all keys of the table that no other source names.",
            &["[\"length_bp\", \"beam\", \"rudder\"]"],
        ),
        key(
            "source",
            Kind::Text,
            Refused,
            "Where the numbers come from, such as a publication with its table.",
            &["\"the trials report, table 2\""],
        ),
        key(
            "standing",
            Kind::Choice(&STANDINGS),
            Refused,
            "How well the source is known.",
            &["\"found\""],
        ),
    ],
    rules: None,
};
