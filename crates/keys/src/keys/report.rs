//! Keys of the title page of reports.

use crate::spec::Absent::Means;
use crate::spec::{KeySpec, Kind, TableSpec, key};

const ABSENT: crate::spec::Absent = Means("not shown");

/// A line of the title page.
const fn line(name: &'static str, doc: &'static str, examples: &'static [&'static str]) -> KeySpec {
    key(name, Kind::Text, ABSENT, doc, examples)
}

/// In the order of the title page.
pub(super) static REPORT: TableSpec = TableSpec {
    what: "the title page of a report",
    doc: "Texts for title page and page footers of the report and for the workbook. The texts \
        change no result. Each text is also an option of `fenderline run` and `fenderline report`, \
        such as `--client`.",
    keys: &[
        line("project", "Project.", &["\"Container terminal, berth 4\""]),
        line("client", "Client.", &["\"Port of Example\""]),
        line("number", "Number of the document.", &["\"1042-REP-007\""]),
        line("revision", "Revision of the document.", &["\"B\""]),
        line("status", "Status of the document.", &["\"for review\""]),
        line("date", "Date of the document, as the report shall print it.", &["\"2026-11-23\""]),
        line("author", "Author of the document.", &["\"A. Engineer\""]),
        line("checked_by", "Person who checked the document.", &["\"B. Reviewer\""]),
    ],
    rules: None,
};

/// Names of the keys, in the order of the title page.
pub fn names() -> impl Iterator<Item = &'static str> {
    REPORT.keys.iter().map(|key| key.name)
}
