//! How the runs ended.

use fenderline_report::plot::{fixed, significant};
use fenderline_report::{Head, table_head};
use fenderline_sim::Verdict;
use maud::{Markup, html};

use crate::statistics::{Confidence, binomial};
use crate::table::{Table, TableError, Texts};

/// Columns of a campaign's table that say how a run ended.
const VERDICT: &str = "verdict";
const GRAVITY: &str = "gravity";

/// The key that stands as verdict for a run that could not be made.
const ERROR: &str = "error";

/// The verdicts of all runs.
pub(super) struct Verdicts {
    /// Number of rows.
    pub(super) runs: usize,
    /// Verdict and gravity of each row, if the table has these columns.
    columns: Option<[Texts; 2]>,
}

impl Verdicts {
    /// Reads the verdicts of a table.
    pub(super) fn of(table: &Table) -> Result<Verdicts, TableError> {
        if table.has(VERDICT) && table.has(GRAVITY) {
            let columns = [table.texts(VERDICT)?, table.texts(GRAVITY)?];
            return Ok(Verdicts { runs: columns[0].len(), columns: Some(columns) });
        }
        // Without verdicts any column tells the number of rows.
        let first = table.heads().first().map(|head| table.texts(&head.name)).transpose()?;
        Ok(Verdicts { runs: first.map_or(0, |texts| texts.len()), columns: None })
    }

    /// The verdict of a row in words; empty if the table has no verdicts.
    pub(super) fn words(&self, row: usize) -> String {
        let key = self.columns.as_ref().and_then(|[verdict, _]| verdict.get(row));
        key.map_or_else(String::new, in_words)
    }

    /// Whether each run succeeded, that is, no limit was exceeded and nothing is in doubt. `None` if the table has no
    /// verdicts. A run that could not be made is neither a success nor a failure: its entry is `None`.
    pub(super) fn successes(&self) -> Option<Vec<Option<bool>>> {
        let [verdict, gravity] = self.columns.as_ref()?;
        let one = |(verdict, gravity): (&str, &str)| {
            (verdict != ERROR).then_some(matches!(gravity, "ok" | "note"))
        };
        Some(verdict.iter().zip(gravity.iter()).map(one).collect())
    }

    /// The table of verdicts.
    pub(super) fn section(&self, confidence: Confidence) -> Markup {
        let Some([verdicts, _]) = &self.columns else {
            return html! { p { "The table has no columns `verdict` and `gravity`." } };
        };
        let counts = verdicts.counts();
        let failed = counts.iter().find(|(key, _)| *key == ERROR).map_or(0, |(_, count)| *count);
        let level = fixed(100.0 * confidence.level(), 0);
        html! {
            div class="wide" { table class="narrow" {
                (table_head(&[
                    Head::Name("Verdict"),
                    Head::Number("Runs", ""),
                    Head::Number("Share", "%"),
                    Head::Number(&format!("{level} % interval"), "%"),
                ]))
                tbody { @for (key, count) in counts {
                    @let share = binomial(count, self.runs, confidence);
                    tr {
                        td class="name" { (in_words(key)) }
                        td class="number" { (fixed(count as f64, 0)) }
                        td class="number" { (percent(share.value)) }
                        td class="number" { (percent(share.interval.low)) " to " (percent(share.interval.high)) }
                    }
                } }
            } }
            @if failed > 0 {
                p {
                    strong class="over" { (format!("{} runs could not be made", fixed(failed as f64, 0))) }
                    ". These runs are not in the statistics below. The column `error` has the reasons."
                }
            }
        }
    }
}

fn percent(share: f64) -> String {
    if share > 0.1 { fixed(100.0 * share, 1) } else { significant(100.0 * share, 2) }
}

/// Turns a verdict's key into words; a text that is no such key is returned unchanged.
fn in_words(key: &str) -> String {
    if key == ERROR {
        return "Run could not be made".to_owned();
    }
    let known = Verdict::ALL.into_iter().find(|verdict| verdict.key() == key);
    known.map_or_else(|| key.to_owned(), |verdict| verdict.text().to_owned())
}
