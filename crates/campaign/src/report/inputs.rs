//! The report's table of inputs: their distributions, sources, and drawn values.

use fenderline_report::{Head, table_head};
use maud::{Markup, html};

use super::{Campaign, column, words};
use crate::statistics::{Moments, Sample};
use crate::table::TableError;

/// Largest number of different words that are listed for an input.
const WORDS: usize = 6;

/// The table of inputs.
pub(super) fn section(campaign: &Campaign<'_>) -> Result<Markup, TableError> {
    let mut rows = Vec::new();
    for input in campaign.inputs {
        let head = campaign.table.head(&input.column)?;
        rows.push((
            column::words_of(head),
            head.unit.clone(),
            drawn(campaign, &input.column)?,
            input,
        ));
    }
    Ok(html! {
        @if !rows.is_empty() {
            h2 { "Inputs" }
            div class="wide" { table {
                (table_head(&[
                    Head::Name("Input"),
                    Head::Text("Distribution", ""),
                    Head::Text("Drawn", ""),
                    Head::Text("Source", ""),
                ]))
                tbody { @for (name, unit, drawn, input) in rows {
                    tr {
                        td class="name" { (name) @if !unit.is_empty() { small { (unit) } } }
                        td { (input.distribution) }
                        td { (drawn) }
                        td { @if input.source.is_empty() { strong class="over" { "not stated" } } @else { (input.source) } }
                    }
                } }
            } }
        }
    })
}

/// Describes the drawn values of an input: mean, standard deviation and range of numbers, or counts of words.
fn drawn(campaign: &Campaign<'_>, name: &str) -> Result<String, TableError> {
    let Ok(numbers) = campaign.table.numbers(name) else {
        let texts = campaign.table.texts(name)?;
        let counts = texts.counts();
        let mut shown: Vec<String> =
            counts.iter().take(WORDS).map(|(text, count)| format!("{text} {count}")).collect();
        if counts.len() > WORDS {
            shown.push(format!("{} others", counts.len() - WORDS));
        }
        return Ok(shown.join(", "));
    };
    Ok(match Sample::new(numbers.present()) {
        Ok(sample) => {
            let moments = Moments::of(&sample);
            format!(
                "mean {}, deviation {}, {} to {}",
                words::number(moments.mean.value),
                words::number(moments.deviation.value),
                words::number(sample.least()),
                words::number(sample.largest())
            )
        }
        Err(_) => "no numbers".to_owned(),
    })
}
