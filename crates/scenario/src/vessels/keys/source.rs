//! Keys of the sources of a vessel's numbers.

use fenderline_keys::held::{OneOf, Text, Texts};
use fenderline_keys::keys::STANDINGS;
use fenderline_keys::spec::Absent::Refused;
use fenderline_keys::spec::{Kind, TableSpec, key};
use fenderline_keys::table_keys;
use fenderline_sim::hydro::vessels::Standing;

pub(super) static SOURCE: TableSpec = TableSpec {
    what: "a source",
    doc: "A source of some of a vessel's numbers.",
    keys: FileSourceKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of a source.
    pub(crate) FileSourceKey {
        OF: Texts = key(
            "of",
            Kind::Texts,
            Refused,
            "Keys of the vessel whose numbers come from this source, such as `beam`, `propeller` \
             or `propeller.wake`. The name of a table covers all keys of the table that no other \
             source names.",
            &["[\"length_bp\", \"beam\", \"rudder\"]"],
        ),
        SOURCE: Text = key(
            "source",
            Kind::Text,
            Refused,
            "Where the numbers come from, such as a publication with its table.",
            &["\"the trials report, table 2\""],
        ),
        STANDING: OneOf<Standing> = key(
            "standing",
            Kind::Choice(&STANDINGS),
            Refused,
            "How well the source of the numbers is known.",
            &["\"found\""],
        ),
    }
}
