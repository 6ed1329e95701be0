//! Partial factors of the user.

use fenderline_sim::factors::PartialFactors;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Item, Table};

impl Assembly<'_, '_> {
    /// The factors of a scenario; none without its table.
    pub(super) fn factors(&self, table: Option<&Table>) -> Checked<PartialFactors> {
        let Some(table) = table else { return Ok(PartialFactors::default()) };
        let number = |key: &str| table.item(key).map(|item| *item.number());
        for (key, other) in [("reaction_limit", "reaction"), ("line_capacity", "line_load")] {
            let given = table.item(key).filter(|item| !item.is_default);
            if let (Some(item), None) = (given, table.item(other)) {
                let path = table.path_of(key);
                let message =
                    format!("`{path}` needs `{other}`: without that factor this key does nothing");
                return Err(self.sources.error(&item.key_span, &path, message));
            }
        }
        let factors = PartialFactors {
            source: table.given("source").text().to_owned(),
            energy: number("energy"),
            reaction: number("reaction"),
            reaction_limit_n: number("reaction_limit"),
            line_load: number("line_load"),
            line_capacity: table.given("line_capacity").choice(),
        };
        if factors.is_empty() {
            let error = self.sources.error(
                &table.span,
                &table.path,
                format!("`{}` has no factor", table.path),
            );
            return Err(error.with_help("give `energy`, `reaction` or `line_load`"));
        }
        factors.check().map_err(|error| self.wrong(table, &error))?;
        Ok(factors)
    }

    /// Notes factors without a fender or line to which they could apply.
    pub(super) fn note_factors(
        &mut self,
        table: Option<&Table>,
        factors: &PartialFactors,
        (fenders, lines): (usize, usize),
    ) {
        let Some(table) = table else { return };
        for (key, is_given, count, what) in [
            ("energy", factors.energy.is_some(), fenders, "fenders"),
            ("reaction", factors.reaction.is_some(), fenders, "fenders"),
            ("line_load", factors.line_load.is_some(), lines, "lines"),
        ] {
            if let (true, 0, Some(item)) = (is_given, count, table.item(key)) {
                self.note_item(
                    table,
                    item,
                    &format!("the scenario has no {what}: the factor does nothing"),
                );
            }
        }
    }

    fn note_item(&mut self, table: &Table, item: &Item, message: &str) {
        self.notices.push(fenderline_keys::error::Notice {
            place: self.sources.place(&item.span),
            key: table.path_of(item.name),
            message: message.to_owned(),
        });
    }
}
