//! The section that shows which inputs drive an output: a tornado chart of rank correlations.

use fenderline_report::plot::{Tornado, Whisker, plain};
use maud::{Markup, html};

use super::{Campaign, Output, column};
use crate::statistics::correlation::spearman;
use crate::table::TableError;

/// A tornado chart for each output, with the inputs that are numbers.
pub(super) fn section(
    campaign: &Campaign<'_>,
    outputs: &[Output<'_>],
) -> Result<Markup, TableError> {
    let confidence = campaign.asked.confidence;
    let mut bars: Vec<Vec<Whisker>> = outputs.iter().map(|_| Vec::new()).collect();
    let mut words: Vec<String> = Vec::new();
    // One input in memory at a time.
    for input in campaign.inputs {
        let head = campaign.table.head(&input.column)?;
        let name = column::words_of(head);
        // A mix of ships is in words, which have no rank.
        let Ok(numbers) = campaign.table.numbers(&input.column) else {
            words.push(name);
            continue;
        };
        for (bars, output) in bars.iter_mut().zip(outputs) {
            if let Some(found) = spearman(&numbers.values, &output.values, confidence) {
                let (low, high) = (found.interval.low, found.interval.high);
                bars.push(Whisker { name: name.clone(), value: found.value, low, high });
            }
        }
    }
    let per_cent = plain(100.0 * confidence.level(), 4);
    let tornado = |output: &Output<'_>, mut bars: Vec<Whisker>| {
        bars.sort_by(|a, b| b.value.abs().total_cmp(&a.value.abs()));
        Tornado {
            title: format!("What drives {}", column::words_of(output.head)),
            bars,
            axis: "rank correlation",
            note: String::new(),
        }
    };
    let tornadoes = outputs.iter().zip(bars).filter(|(_, bars)| !bars.is_empty());
    let tornadoes: Vec<Tornado> = tornadoes.map(|(output, bars)| tornado(output, bars)).collect();
    Ok(html! {
        @if !tornadoes.is_empty() {
            h2 { "Sensitivity" }
            p { "Spearman’s rank correlation of each input with each output: 1 if the output \
                always rises with the input, −1 if it always falls, near 0 if it neither rises nor \
                falls steadily. "
                (format!("The line across a bar is the {per_cent} % confidence interval."))
                @if !words.is_empty() { (format!(" Inputs in words have no rank: {}.", words.join(", "))) }
            }
            @for tornado in tornadoes { (tornado.render()) }
        }
    })
}
