//! Keys of the title page of reports.

use crate::held::Text;
use crate::spec::Absent::Means;
use crate::spec::{KeySpec, Kind, TableSpec, key};
use crate::table_keys;
use crate::typed_key::Key;

const ABSENT: crate::spec::Absent = Means("not shown");

/// Declares a key for a line of the title page of reports.
const fn line(name: &'static str, doc: &'static str, examples: &'static [&'static str]) -> KeySpec {
    key(name, Kind::Text, ABSENT, doc, examples)
}

/// The keys of the title page, in the order in which the page shows them.
pub(super) static REPORT: TableSpec = TableSpec {
    what: "the title page of a report",
    doc: "Texts for the title page and the page footers of the report, and for the workbook. The \
        texts of the title page change no result. Each text of the title page can also be given as \
        an option of `fenderline run` and `fenderline report`, such as `--client`.",
    keys: ReportKey::ALL,
    rules: None,
};

table_keys! {
    /// Keys of the title page of a report.
    pub ReportKey {
        PROJECT: Text = line("project", "Project.", &["\"Container terminal, berth 4\""]),
        CLIENT: Text = line("client", "Client.", &["\"Port of Example\""]),
        NUMBER: Text = line("number", "Number of the document.", &["\"1042-REP-007\""]),
        REVISION: Text = line("revision", "Revision of the document.", &["\"B\""]),
        STATUS: Text = line("status", "Status of the document.", &["\"for review\""]),
        DATE: Text = line(
            "date",
            "Date of the document, as the report shall print it.",
            &["\"2026-11-23\""],
        ),
        AUTHOR: Text = line("author", "Author of the document.", &["\"A. Engineer\""]),
        CHECKED_BY: Text = line(
            "checked_by",
            "Person who checked the document.",
            &["\"B. Reviewer\""],
        ),
    }
}

/// The keys of the title page, in the order of the page.
pub const KEYS: [Key<ReportKey, Text>; ReportKey::ALL.len()] = [
    ReportKey::PROJECT,
    ReportKey::CLIENT,
    ReportKey::NUMBER,
    ReportKey::REVISION,
    ReportKey::STATUS,
    ReportKey::DATE,
    ReportKey::AUTHOR,
    ReportKey::CHECKED_BY,
];

/// Names of the keys of the title page, in the order of the page.
pub fn names() -> impl Iterator<Item = &'static str> {
    KEYS.into_iter().map(Key::name)
}
