//! Table columns that come from the catalogue of summary quantities.

use fenderline_results::{Catalogue, Digits, Reported, Shown};
use maud::{Markup, html};

use crate::Head;
use crate::plot::{decimals_for, fixed, significant};

/// The columns of a catalogue that the report shows.
fn reported<S, T>(
    catalogue: &Catalogue<S, T>,
) -> impl Iterator<Item = (&'static Shown, Reported)> + use<S, T> {
    catalogue.shown.iter().filter_map(|column| Some((column, column.reported?)))
}

/// The heads of the catalogue's columns that the report shows.
pub(super) fn heads<S, T>(catalogue: &Catalogue<S, T>) -> Vec<Head<'static>> {
    let columns = reported(catalogue);
    columns.map(|(of, _)| Head::Number(of.head, of.scale.page_unit())).collect()
}

/// The cells of one row of the table (one fender, line or the like), in the columns of [`heads`].
pub(super) fn cells<S, T>(
    catalogue: &Catalogue<S, T>,
    setup: &S,
    summary: &T,
    step_s: f64,
) -> Markup {
    let number = |name: &str| catalogue.number(name, setup, summary);
    html! {
        @for (column, of) in reported(catalogue) {
            @let value = number(column.quantity);
            @let value = value.map(|value| digits(column.scale.of(value), of.digits, step_s));
            td class="number" {
                (value.as_deref().unwrap_or("–"))
                @if let Some(share) = of.share.and_then(number) {
                    (share_below(share, of.catalogue_share.and_then(number), of.over.map_or(Some(share), number)))
                }
            }
        }
    }
}

/// The share of a limit that stands below a value, in bold if the value is over the limit; with the share of the
/// catalogue's rating if it differs.
fn share_below(share: f64, of_catalogue: Option<f64>, deciding: Option<f64>) -> Markup {
    let percent = |share: f64| fixed(100.0 * share, 0);
    let is_over = deciding.is_some_and(|share| share > 1.0);
    let other = of_catalogue.filter(|other| percent(share) != percent(*other));
    html! {
        small class=[is_over.then_some("over")] {
            (percent(share)) " %"
            @if let Some(other) = other { " (" (percent(other)) " %)" }
        }
    }
}

fn digits(value: f64, digits: Digits, step_s: f64) -> String {
    match digits {
        Digits::Fixed(decimals) => fixed(value, decimals),
        Digits::Significant(count) => significant(value, count),
        Digits::OfStep => fixed(value, decimals_for(step_s)),
    }
}
