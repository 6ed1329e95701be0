//! The report's section of the user's partial factors and the factored loads.

use fenderline_results::Outcome;
use fenderline_sim::factors::Factored;
use maud::{Markup, html};

use super::tables::{ROWS, more, number};
use crate::plot::{fixed, plain, significant};
use crate::{Head, table_head};

/// A row of the table: the fender or mooring line, the quantity with its unit, and the factored effect.
struct Row<'o> {
    name: &'o str,
    quantity: &'static str,
    of: Factored,
}

/// Writes the section of partial factors; empty if the scenario has no factors.
pub(super) fn section(outcome: &Outcome<'_>) -> Markup {
    let factors = &outcome.setup.world.factors;
    let rows = rows(outcome);
    html! {
        @if !factors.is_empty() {
            h3 { "Partial factors" }
            p {
                (format!(
                    "The factors come from the scenario, with the source {}. fenderline has no \
                     factors of its own.",
                    factors.source,
                ))
            }
            div class="wide" {
                table {
                    (table_head(&[
                        Head::Name("Of"),
                        Head::Name("Quantity"),
                        Head::Number("Factor", ""),
                        Head::Number("Factored", "kJ, kN"),
                        Head::Number("Capacity", "kJ, kN"),
                        Head::Number("Share", "%"),
                        Head::Text("Verdict", ""),
                    ]))
                    tbody { @for row in rows.iter().take(ROWS) { tr { (cells(row)) } } }
                }
            }
            (more(rows.len()))
            p class="note" {
                (format!(
                    "Energy is compared with the rated energy with the factors of the run, reaction \
                     with the scenario's limit, tension with the {}.",
                    factors.line_capacity.words(),
                ))
            }
        }
    }
}

fn rows<'o>(outcome: &'o Outcome<'_>) -> Vec<Row<'o>> {
    let (setup, factors) = (outcome.setup, &outcome.setup.world.factors);
    let of_fenders = outcome.fenders.iter().flat_map(|fender| {
        let name = setup.fenders[fender.fender].name.as_str();
        let energy = factors.energy_of(fender).map(|of| Row { name, quantity: "energy", of });
        let reaction = factors.reaction_of(fender).map(|of| Row { name, quantity: "reaction", of });
        energy.into_iter().chain(reaction)
    });
    let lines = setup.world.lines.iter().zip(&outcome.world.lines);
    let of_lines = lines.filter_map(|(line, totals)| {
        let of = factors.line_load_of(&line.line.kind, totals.tension_n.value)?;
        Some(Row { name: &line.line.name, quantity: "tension", of })
    });
    of_fenders.chain(of_lines).collect()
}

fn cells(row: &Row<'_>) -> Markup {
    let share = row.of.share();
    html! {
        td class="name" { (row.name) }
        td class="name" { (row.quantity) }
        (number(&plain(row.of.factor, 4)))
        (number(&significant(row.of.value / 1e3, 3)))
        (number(&row.of.capacity.map_or_else(|| "–".to_owned(), |n| significant(n / 1e3, 3))))
        (number(&share.map_or_else(|| "–".to_owned(), |share| fixed(100.0 * share, 0))))
        td {
            @match share {
                Some(share) if share > 1.0 => span class="verdict over_rated" { "exceeded" },
                Some(_) => span class="verdict ok" { "kept" },
                None => "–",
            }
        }
    }
}
