//! `validation.html`, `.csv` and `.json`.

use serde_json::{Value, json};

use super::published::{Rule, Tolerance};
use super::row::{Compared, Row, count};

/// Names and contents of the files `validation.csv`, `validation.json` and `validation.html`.
pub(super) fn files(page: String, rows: &[Row]) -> [(&'static str, String); 3] {
    [
        ("validation.csv", csv_text(rows)),
        ("validation.json", json_text(rows)),
        ("validation.html", page),
    ]
}

/// Writes a number in full, in the shortest form that reads back to the same value.
fn full(value: f64) -> String {
    format!("{value:?}")
}

fn tolerance_parts(tolerance: Tolerance) -> (&'static str, f64) {
    match tolerance {
        Tolerance::Relative(share) => ("relative", share),
        Tolerance::Absolute(bound) => ("absolute", bound),
    }
}

fn rule_text(rule: Rule) -> String {
    match rule {
        Rule::Rises => "rises".to_owned(),
        Rule::Falls => "falls".to_owned(),
        Rule::DoesNotFall => "does_not_fall".to_owned(),
        Rule::Converges => "converges".to_owned(),
        Rule::Within { low, high } => format!("within {low} to {high}"),
    }
}

fn csv_text(rows: &[Row]) -> String {
    let mut table = csv::Writer::from_writer(Vec::new());
    let head = [
        "subject",
        "kind",
        "case",
        "source",
        "standing",
        "place",
        "published",
        "ours",
        "unit",
        "error",
        "tolerance",
        "tolerance_kind",
        "uncertainty",
        "uncertainty_from",
        "ok",
        "known_mismatch",
        "note",
    ];
    let records = rows.iter().map(|row| {
        let none = String::new;
        let (kind, published, ours, error) = match &row.compared {
            Compared::Number { published, ours, error, .. } => {
                ("number", full(*published), full(*ours), full(*error))
            }
            Compared::Statement { rule, ours, .. } => {
                let ours: Vec<String> = ours.iter().map(|v| full(*v)).collect();
                ("statement", rule_text(*rule), ours.join(" "), none())
            }
        };
        let (tolerance_kind, tolerance, uncertainty, from) = match &row.compared {
            Compared::Number { tolerance, uncertainty, .. } => {
                let (kind, bound) = tolerance_parts(*tolerance);
                (kind, full(bound), full(uncertainty.size), uncertainty.from.clone())
            }
            Compared::Statement { .. } => ("", none(), none(), none()),
        };
        [
            row.subject.clone(),
            kind.to_owned(),
            row.case.clone(),
            row.source.clone(),
            row.standing.text().to_owned(),
            row.place.clone(),
            published,
            ours,
            row.unit.clone(),
            error,
            tolerance,
            tolerance_kind.to_owned(),
            uncertainty,
            from,
            row.is_ok.to_string(),
            row.is_known_mismatch().to_string(),
            row.note.clone(),
        ]
    });
    let written = table.write_record(head);
    let written =
        records.fold(written, |so_far, record| so_far.and_then(|()| table.write_record(&record)));
    written.expect("a table in memory accepts every row");
    let bytes = table.into_inner().expect("a table in memory can be finished");
    String::from_utf8(bytes).expect("all cells are text")
}

fn json_text(rows: &[Row]) -> String {
    let (within, compared) = count(rows, true);
    let (hold, statements) = count(rows, false);
    let document = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "rows_within_tolerance": within,
        "rows": compared,
        "statements_that_hold": hold,
        "statements": statements,
        "numbers": rows.iter().filter_map(number_json).collect::<Vec<_>>(),
        "statement_rows": rows.iter().filter_map(statement_json).collect::<Vec<_>>(),
    });
    let text = serde_json::to_string_pretty(&document).expect("plain values become JSON");
    text + "\n"
}

fn number_json(row: &Row) -> Option<Value> {
    let Compared::Number { published, ours, error, tolerance, reason, uncertainty, known_mismatch } =
        &row.compared
    else {
        return None;
    };
    let (tolerance_kind, tolerance) = tolerance_parts(*tolerance);
    Some(json!({
        "subject": row.subject,
        "case": row.case,
        "source": row.source,
        "standing": row.standing.text(),
        "place": row.place,
        "published": published,
        "ours": ours,
        "unit": row.unit,
        "error": error,
        "tolerance": tolerance,
        "tolerance_kind": tolerance_kind,
        "reason": reason,
        "uncertainty": uncertainty.size,
        "uncertainty_from": uncertainty.from,
        "ok": row.is_ok,
        "known_mismatch": known_mismatch,
        "note": row.note,
    }))
}

fn statement_json(row: &Row) -> Option<Value> {
    let Compared::Statement { says, rule, ours, known_mismatch } = &row.compared else {
        return None;
    };
    Some(json!({
        "subject": row.subject,
        "case": row.case,
        "source": row.source,
        "standing": row.standing.text(),
        "place": row.place,
        "statement": says,
        "holds_if": rule_text(*rule),
        "ours": ours,
        "unit": row.unit,
        "ok": row.is_ok,
        "known_mismatch": known_mismatch,
        "note": row.note,
    }))
}
