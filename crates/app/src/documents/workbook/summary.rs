//! The sheets of the workbook about the whole run: governing numbers and findings.

use fenderline_report::run_page::{detail_label, governing};
use fenderline_results::{Outcome, integrator_text, method_text};
use fenderline_sim::Verdict;
use rust_xlsxwriter::{Format, Worksheet, XlsxError};

use super::table::{Cell, Head, format_of, print_on_a4, put, sheet_of, table};

pub(super) fn summary(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    sheet.set_name("Summary")?;
    let title = Format::new().set_bold().set_font_size(14);
    let bold = Format::new().set_bold();
    sheet.write_string_with_format(0, 0, outcome.title, &title)?;
    let mut row = 2;
    for (name, cell) in facts(outcome) {
        sheet.write_string_with_format(row, 0, &name, &bold)?;
        match cell {
            // Runs over the cells beside it, which are empty.
            Cell::Text(text) => drop(sheet.write_string(row, 1, &text)?),
            cell => put(sheet, (row, 1), &cell, &format_of(""))?,
        }
        row += 1;
    }
    let heads = [
        Head("Governing number", "", 34.0),
        Head("Of", "", 28.0),
        Head("Value", "", 14.0),
        Head("Unit", "", 12.0),
        Head("Share of limit", "%", 14.0),
        Head("Limit", "", 22.0),
        Head("At", "s", 10.0),
        Head("In hit", "", 8.0),
    ];
    let rows = governing(outcome).into_iter().map(|of| {
        vec![
            of.quantity.into(),
            of.subject.into(),
            Cell::Of(of.value, of.unit),
            of.unit.into(),
            of.share.map(|(share, _)| 100.0 * share).into(),
            of.share.map_or(Cell::Empty, |(_, limit)| limit.into()),
            of.at_s.into(),
            of.hit.map(f64::from).into(),
        ]
    });
    table(sheet, row + 1, &heads, rows)?;
    print_on_a4(sheet, "Summary", 1);
    Ok(())
}

/// Names and values of the lines that the sheet shows above the governing numbers.
fn facts(outcome: &Outcome<'_>) -> Vec<(String, Cell)> {
    let setup = outcome.setup;
    let mut facts: Vec<(String, Cell)> = outcome
        .report
        .iter()
        .map(|(key, text)| (detail_label(key), text.as_str().into()))
        .collect();
    facts.push(("Verdict".into(), Verdict::of(outcome.findings).text().into()));
    for approach in &setup.approaches {
        let name = if approach.is_abnormal() { "Abnormal berthing" } else { "Approach" };
        facts.push((name.into(), approach.sentence(setup).into()));
    }
    facts.push(("Scenario".into(), outcome.scenario_file.into()));
    facts.push(("Program".into(), format!("fenderline {}", env!("CARGO_PKG_VERSION")).into()));
    facts.push(("Contact method".into(), method_text(setup.method).into()));
    facts.push(("Integrator".into(), integrator_text(setup.integrator).into()));
    facts.push(("Time step [s]".into(), setup.step_s.into()));
    facts.push(("Steps".into(), (outcome.steps as f64).into()));
    facts.push(("Interrupted".into(), Cell::Flag(outcome.interrupted.is_some())));
    facts
}

pub(super) fn findings(sheet: &mut Worksheet, outcome: &Outcome<'_>) -> Result<(), XlsxError> {
    let heads = [
        Head("Finding", "", 26.0),
        Head("Gravity", "", 12.0),
        Head("About", "", 28.0),
        Head("In words", "", 90.0),
    ];
    let no_finding = outcome.findings.is_empty().then(|| {
        let words = "Nothing was found: no limit was exceeded.";
        vec![
            Verdict::AllWell.key().into(),
            Verdict::AllWell.gravity().key().into(),
            Cell::Empty,
            words.into(),
        ]
    });
    let rows = outcome.findings.iter().map(|finding| {
        let verdict = finding.verdict();
        vec![
            verdict.key().into(),
            verdict.gravity().key().into(),
            finding.names(outcome.setup).join(", ").into(),
            finding.sentence(outcome.setup).into(),
        ]
    });
    sheet_of(sheet, "Findings", &heads, no_finding.into_iter().chain(rows), 0)
}
