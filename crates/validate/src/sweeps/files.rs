//! Writes `sweeps.html`, `sweeps.csv`, `sweeps.json`, and a picture of each sweep.

use fenderline_report::plot::{page, plain};
use maud::{Markup, html};
use serde_json::{Value, json};

use super::check::{Compared, Finding};
use super::draw::chart;
use super::printed::{band_text, count, count_references, failure_text, ratio_text};
use super::{Sweeps, Swept};

const TITLE: &str = "Every force over its whole domain";

/// Names and contents.
pub(super) fn files(sweeps: &Sweeps) -> Vec<(String, String)> {
    let pictures = sweeps
        .swept
        .iter()
        .map(|swept| (format!("sweep_{}.svg", swept.sweep.key), chart(swept).stand_alone()));
    let tables = [
        ("sweeps.html".to_owned(), whole_page(sweeps)),
        ("sweeps.csv".to_owned(), csv_text(sweeps)),
        ("sweeps.json".to_owned(), json_text(sweeps)),
    ];
    tables.into_iter().chain(pictures).collect()
}

/// The page. The page has no time and no path of a file, so that the same program gives the same bytes.
fn whole_page(sweeps: &Sweeps) -> String {
    let (holds, checks) = count(sweeps);
    let (within, compared) = count_references(sweeps);
    let of_one = sweeps.swept.chunk_by(|a, b| a.sweep.subject == b.sweep.subject);
    let body = html! {
        h1 { (TITLE) }
        p class="subtitle" { "fenderline " (env!("CARGO_PKG_VERSION")) }
        p {
            strong { (holds) " of " (checks) " checks hold; " (within) " of " (compared) " references within their bands; "
                (sweeps.references.none.len()) " of " (sweeps.swept.len()) " sweeps have no reference." }
        }
        p {
            "Each curve is checked along its whole axis: there is no jump that stays when steps \
             are halved, the mirror image is the same to rounding, the signs are those of \
             physics, and the values grow no faster than the law says. Marks and extra lines in \
             the charts are references, with their bands in the colour of the curve."
        }
        @for group in of_one {
            h2 { (group[0].sweep.subject) }
            @for swept in group { (section(swept, sweeps)) }
        }
        footer {
            "Made by fenderline " (env!("CARGO_PKG_VERSION")) " validate --sweeps. "
            "The same program makes the same page again, byte for byte."
        }
    };
    page(TITLE, &body)
}

fn section(swept: &Swept, sweeps: &Sweeps) -> Markup {
    let judged = &swept.judged;
    let held = judged.findings.iter().filter(|finding| finding.holds).count();
    let none = sweeps.references.none.iter().find(|none| none.sweep == swept.sweep.key);
    html! {
        (chart(swept).render())
        ul class="note" {
            li { (held) " of " (judged.findings.len()) " checks hold: " (checks_text(swept)) "." }
            @for finding in judged.findings.iter().filter(|finding| !finding.holds) {
                li { strong class="over" { (failure_text(swept, finding)) } }
            }
            @for compared in &judged.compared { li { (reference(swept, compared, sweeps)) } }
            @if let Some(none) = none { li { strong { "No reference found. " } (none.looked_for) } }
        }
    }
}

fn reference(swept: &Swept, compared: &Compared, sweeps: &Sweeps) -> Markup {
    let Compared { curve, short, .. } = compared;
    let own = sweeps.references.references.iter().find(|reference| {
        reference.sweep == swept.sweep.key && reference.curve == *curve && reference.short == *short
    });
    html! {
        (curve) " over " (short) ": ratio " (ratio_text(compared)) ", band " (band_text(compared.band)) ". "
        @if !compared.holds {
            strong class="over" {
                (if compared.known.is_some() { "Out of the band, for a known reason" } else { "OUT OF THE BAND" })
                ": up to " (plain(compared.worst, 2)) " times. "
            }
        }
        @if let Some(note) = &compared.known { (note) " " }
        @if let Some(own) = own { "[" (own.standing.text()) "] " (own.citation) " Band: " (own.band_from) }
    }
}

/// Lists the names of the checks of a sweep, each once.
fn checks_text(swept: &Swept) -> String {
    let mut names: Vec<&str> = Vec::new();
    for Finding { check, .. } in &swept.judged.findings {
        if !names.contains(&check.as_str()) {
            names.push(check);
        }
    }
    names.join("; ")
}

/// The values of the curves at every fourth sampled place.
fn csv_text(sweeps: &Sweeps) -> String {
    let mut table = csv::Writer::from_writer(Vec::new());
    let mut write = |record: [String; 8]| {
        table.write_record(&record).expect("a table in memory accepts every row");
    };
    write(
        ["subject", "sweep", "curve", "axis", "axis_unit", "at", "value", "unit"]
            .map(str::to_owned),
    );
    for Swept { sweep, judged } in &sweeps.swept {
        for (curve, values) in sweep.curves.iter().zip(&judged.values) {
            for (x, y) in judged.places.iter().zip(values).step_by(4) {
                write([
                    sweep.subject.to_owned(),
                    sweep.key.to_owned(),
                    curve.name.clone(),
                    sweep.axis.name.to_owned(),
                    sweep.axis.unit.to_owned(),
                    format!("{x:?}"),
                    format!("{y:?}"),
                    sweep.value[1].to_owned(),
                ]);
            }
        }
    }
    let bytes = table.into_inner().expect("a table in memory can be finished");
    String::from_utf8(bytes).expect("all cells are text")
}

fn json_text(sweeps: &Sweeps) -> String {
    let (holds, checks) = count(sweeps);
    let (within, references) = count_references(sweeps);
    let document = json!({
        "version": env!("CARGO_PKG_VERSION"),
        "checks_that_hold": holds,
        "checks": checks,
        "references_within_their_band": within,
        "references": references,
        "sweeps_without_reference": sweeps.references.none.len(),
        "sweeps": sweeps.swept.iter().map(|swept| sweep_json(swept, sweeps)).collect::<Vec<_>>(),
    });
    serde_json::to_string_pretty(&document).expect("plain values become JSON") + "\n"
}

fn sweep_json(swept: &Swept, sweeps: &Sweeps) -> Value {
    let Swept { sweep, judged } = swept;
    let none = sweeps.references.none.iter().find(|none| none.sweep == sweep.key);
    let compared = judged.compared.iter().map(|compared| compared_json(swept, compared, sweeps));
    json!({
        "name": sweep.key,
        "subject": sweep.subject,
        "title": sweep.title,
        "axis": sweep.axis.name,
        "axis_unit": sweep.axis.unit,
        "from": sweep.axis.from,
        "to": sweep.axis.to,
        "value": sweep.value[0],
        "unit": sweep.value[1],
        "note": sweep.note,
        "picture": format!("sweep_{}.svg", sweep.key),
        "curves": sweep.curves.iter().map(|curve| &curve.name).collect::<Vec<_>>(),
        "checks": judged.findings.iter().map(finding_json).collect::<Vec<_>>(),
        "references": compared.collect::<Vec<_>>(),
        "no_reference": none.map(|none| &none.looked_for),
    })
}

fn finding_json(finding: &Finding) -> Value {
    json!({
        "curve": finding.curve,
        "check": finding.check,
        "holds": finding.holds,
        "found": finding.found,
        "at": finding.at,
        "known": finding.known,
    })
}

fn compared_json(swept: &Swept, compared: &Compared, sweeps: &Sweeps) -> Value {
    let own = sweeps.references.references.iter().find(|reference| {
        reference.sweep == swept.sweep.key
            && reference.curve == compared.curve
            && reference.short == compared.short
    });
    let own = own.expect("it was compared");
    json!({
        "curve": compared.curve,
        "reference": compared.short,
        "citation": own.citation,
        "standing": own.standing.text(),
        "ratio_least": finite(compared.ratio[0]),
        "ratio_greatest": finite(compared.ratio[1]),
        "ratio": ratio_text(compared),
        "band": compared.band,
        "band_from": own.band_from,
        "worst_over_band": compared.worst,
        "worst_at": compared.worst_at,
        "within": compared.holds,
        "known": compared.known,
    })
}

/// The ratio of our values to a reference; `None` if no value of the reference is away from zero.
fn finite(ratio: f64) -> Option<f64> {
    ratio.is_finite().then_some(ratio)
}
