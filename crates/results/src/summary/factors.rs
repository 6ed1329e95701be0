//! Partial factors of the user in `summary.json`.

use fenderline_sim::factors::Factored;

use crate::json::{Json, object};
use crate::outcome::Outcome;

/// Adds the key `factors` if the scenario has partial factors: each factor with the user's source, and the factored
/// values of fenders and mooring lines.
pub(super) fn put_factors(whole: &mut Json, outcome: &Outcome<'_>) {
    let (setup, factors) = (outcome.setup, &outcome.setup.world.factors);
    if factors.is_empty() {
        return;
    }
    let mut section = object!({ "source": factors.source });
    section.put_if_any("energy", factors.energy);
    section.put_if_any("reaction", factors.reaction);
    section.put_if_any("line_load", factors.line_load);
    if factors.energy.or(factors.reaction).is_some() {
        let fenders = outcome.fenders.iter().map(|fender| {
            let mut row = object!({ "fender": setup.fenders[fender.fender].name });
            put_factored(&mut row, ("j", "energy"), factors.energy_of(fender));
            put_factored(&mut row, ("n", "reaction"), factors.reaction_of(fender));
            row
        });
        section.put("fenders", fenders.collect::<Json>());
    }
    if factors.line_load.is_some() {
        section.put("line_capacity", factors.line_capacity.words());
        let lines = setup.world.lines.iter().zip(&outcome.world.lines).map(|(line, totals)| {
            let mut row = object!({ "line": line.line.name });
            let load = factors.line_load_of(&line.line.kind, totals.tension_n.value);
            put_factored(&mut row, ("n", "line_load"), load);
            row
        });
        section.put("lines", lines.collect::<Json>());
    }
    whole.put("factors", section);
}

/// Adds a factored value, with its share of the capacity of the fender or mooring line if the capacity is known.
fn put_factored(row: &mut Json, (unit, what): (&str, &str), factored: Option<Factored>) {
    let Some(factored) = factored else { return };
    row.put(&format!("factored_{what}_{unit}"), factored.value);
    row.put_if_any(&format!("share_with_{what}_factor"), factored.share());
}
