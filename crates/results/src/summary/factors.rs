//! Partial factors of the user in `summary.json`.

use fenderline_sim::factors::Factored;
use serde_json::{Map, Value, json};

use crate::outcome::Outcome;

/// Adds `factors`, if the scenario has some: each with the user's source, and what it makes of fenders and lines.
pub(super) fn put_factors(whole: &mut Value, outcome: &Outcome<'_>) {
    let (setup, factors) = (outcome.setup, &outcome.setup.world.factors);
    if factors.is_empty() {
        return;
    }
    let mut of = Map::new();
    of.insert("source".to_owned(), json!(factors.source));
    for (key, factor) in [
        ("energy", factors.energy),
        ("reaction", factors.reaction),
        ("line_load", factors.line_load),
    ] {
        of.extend(factor.map(|factor| (key.to_owned(), json!(factor))));
    }
    let shown = |unit: &str, what: &str, of: Option<Factored>, one: &mut Map<String, Value>| {
        let Some(of) = of else { return };
        one.insert(format!("factored_{what}_{unit}"), json!(of.value));
        one.extend(of.share().map(|share| (format!("share_with_{what}_factor"), json!(share))));
    };
    let fenders = outcome.fenders.iter().map(|fender| {
        let mut one = Map::new();
        one.insert("fender".to_owned(), json!(setup.fenders[fender.fender].name));
        shown("j", "energy", factors.energy_of(fender), &mut one);
        shown("n", "reaction", factors.reaction_of(fender), &mut one);
        Value::Object(one)
    });
    if factors.energy.or(factors.reaction).is_some() {
        of.insert("fenders".to_owned(), fenders.collect());
    }
    if factors.line_load.is_some() {
        of.insert("line_capacity".to_owned(), json!(factors.line_capacity.words()));
        let lines = setup.world.lines.iter().zip(&outcome.world.lines).map(|(line, totals)| {
            let mut one = Map::new();
            one.insert("line".to_owned(), json!(line.line.name));
            let load = factors.line_load_of(&line.line.kind, totals.tension_n.value);
            shown("n", "line_load", load, &mut one);
            Value::Object(one)
        });
        of.insert("lines".to_owned(), lines.collect());
    }
    whole["factors"] = Value::Object(of);
}
