//! Reads the user's partial factors.

use fenderline_sim::factors::PartialFactors;

use super::assembly::{Assembly, Checked};
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::Number;
use fenderline_keys::keys::factors::FactorsKey;
use fenderline_keys::typed_key::Key;

impl Assembly<'_, '_> {
    /// Reads the partial factors of a scenario; there are no factors if the scenario has no table `[factors]`.
    pub(super) fn factors(&self, table: Option<Of<'_, FactorsKey>>) -> Checked<PartialFactors> {
        let Some(table) = table else { return Ok(PartialFactors::default()) };
        let number = |key: Key<_, Number>| table.item(key).map(|item| *item.number());
        let pairs = [
            (FactorsKey::REACTION_LIMIT.any(), FactorsKey::REACTION),
            (FactorsKey::LINE_CAPACITY.any(), FactorsKey::LINE_LOAD),
        ];
        for (key, other) in pairs {
            let given = table.item(key).filter(|item| !item.is_default);
            if let (Some(item), None) = (given, table.item(other)) {
                let path = table.path_of(key);
                let message = format!(
                    "`{path}` needs the factor `{other}`, without which this key does nothing"
                );
                return Err(self.sources.error(&item.key_span, &path, message));
            }
        }
        let factors = PartialFactors {
            source: table.given(FactorsKey::SOURCE).text().to_owned(),
            energy: number(FactorsKey::ENERGY),
            reaction: number(FactorsKey::REACTION),
            reaction_limit_n: number(FactorsKey::REACTION_LIMIT),
            line_load: number(FactorsKey::LINE_LOAD),
            line_capacity: table.given(FactorsKey::LINE_CAPACITY).choice(),
        };
        if factors.is_empty() {
            let error = self.sources.error(
                &table.span,
                &table.path,
                format!("`{}` has no factor", table.path),
            );
            return Err(
                error.with_help("give one of the factors `energy`, `reaction` and `line_load`")
            );
        }
        factors.check().map_err(|error| self.wrong(table, &error))?;
        Ok(factors)
    }

    /// Warns of partial factors for fenders or mooring lines if the scenario has no fenders or lines.
    pub(super) fn note_factors(
        &mut self,
        table: Option<Of<'_, FactorsKey>>,
        factors: &PartialFactors,
        (fenders, lines): (usize, usize),
    ) {
        let Some(table) = table else { return };
        for (key, is_given, count, what) in [
            (FactorsKey::ENERGY, factors.energy.is_some(), fenders, "fenders"),
            (FactorsKey::REACTION, factors.reaction.is_some(), fenders, "fenders"),
            (FactorsKey::LINE_LOAD, factors.line_load.is_some(), lines, "lines"),
        ] {
            if let (true, 0, Some(item)) = (is_given, count, table.item(key)) {
                self.note_item(
                    table,
                    item,
                    &format!("the factor does nothing, because the scenario has no {what}"),
                );
            }
        }
    }

    fn note_item<T, V>(&mut self, table: Of<'_, T>, item: Entry<'_, V>, message: &str) {
        self.notices.push(fenderline_keys::error::Notice {
            place: self.sources.place(&item.span),
            key: table.path_to(item),
            message: message.to_owned(),
        });
    }
}
