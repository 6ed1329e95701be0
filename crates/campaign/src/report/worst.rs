//! The report's table of the worst runs, each with the command that makes the run again.

use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use super::verdicts::Verdicts;
use super::{Campaign, Output, column, words};

/// Largest number of runs that the table shows, and of columns beside the output.
const RUNS: usize = 10;
const COLUMNS: usize = 4;

/// The table of the runs with the largest values of the first output.
pub(super) fn section(
    campaign: &Campaign<'_>,
    outputs: &[Output<'_>],
    verdicts: &Verdicts,
) -> Markup {
    let Some(first) = outputs.first() else { return html! {} };
    let mut rows: Vec<usize> =
        (0..first.values.len()).filter(|row| first.values[*row].is_finite()).collect();
    let by_value =
        |a: &usize, b: &usize| first.values[*b].total_cmp(&first.values[*a]).then(a.cmp(b));
    if rows.len() > RUNS {
        rows.select_nth_unstable_by(RUNS - 1, by_value);
        rows.truncate(RUNS);
    }
    rows.sort_by(by_value);
    let shown = &outputs[..outputs.len().min(COLUMNS)];
    let names: Vec<String> = shown.iter().map(|output| column::words_of(output.head)).collect();
    let mut heads = vec![Head::Number("Run", "")];
    heads.extend(
        names.iter().zip(shown).map(|(name, output)| Head::Number(name, &output.head.unit)),
    );
    heads.extend([Head::Text("Verdict", ""), Head::Text("Play it again", "")]);
    html! {
        h2 { "The worst runs" }
        p { "The " (rows.len()) " runs of the largest " (column::words_of(first.head)) "." }
        div class="wide" { table {
            (table_head(&heads))
            tbody { @for row in rows {
                tr {
                    td class="number" { (row + 1) }
                    @for output in shown {
                        td class="number" {
                            @let value = output.values[row];
                            @if value.is_finite() { (words::number(value)) } @else { "–" }
                        }
                    }
                    td { (verdicts.words(row)) }
                    td { code { ((campaign.replay)(row)) } }
                }
            } }
        } }
    }
}
