//! Turns the tables of fender chains into the set-up of the chains.

use fenderline_contact::Panel;
use fenderline_sim::{ChainGrade, ChainKind, ChainLink, ChainSetup, ChainSize};

use super::assembly::{Assembly, Checked};
use crate::vessels::Belting;
use fenderline_keys::any_keys;
use fenderline_keys::checked::{Entry, Of};
use fenderline_keys::held::Number;
use fenderline_keys::keys::fender::FenderKey;
use fenderline_keys::keys::panel::ChainKey;
use fenderline_keys::typed_key::{AnyKey, Key};

impl Assembly<'_, '_> {
    /// Reads the chains of a fender, and the mass that the fender's weight chains carry (kg).
    pub(super) fn chains(
        &self,
        table: Of<'_, FenderKey>,
        face: &Belting,
    ) -> Checked<(Vec<ChainSetup>, f64)> {
        let panel_mass = table.item(FenderKey::PANEL_MASS).map(|item| *item.number());
        let Some(item) = table.item(FenderKey::CHAINS) else {
            return Ok((vec![], panel_mass.unwrap_or(0.0)));
        };
        let read = item.list().iter().map(|chain| self.chain(chain, face));
        let chains: Vec<ChainSetup> = read.collect::<Checked<_>>()?;
        let has = |kind: ChainKind| chains.iter().filter(|chain| chain.kind == kind).count();
        let refused = |message: String, help: &str| {
            let path = table.path_of(FenderKey::CHAINS);
            Err(self.sources.error(&item.span, &path, message).with_help(help))
        };
        if has(ChainKind::Tension) > 0 && table.item(FenderKey::CONES).is_none() {
            let message = format!(
                "`{}`: a tension chain holds a panel that turns, but this fender has no `cones`",
                table.path_of(FenderKey::CHAINS)
            );
            return refused(message, "give the panel its `cones`, or leave the chain out");
        }
        if has(ChainKind::Tension) > Panel::MOST_CHAINS {
            let message = format!(
                "`{}` must have at most {} tension chains",
                table.path_of(FenderKey::CHAINS),
                Panel::MOST_CHAINS
            );
            return refused(
                message,
                "combine two chains at one place into one chain of twice the \
                stiffness",
            );
        }
        if has(ChainKind::Weight) > 0 && panel_mass.is_none() {
            return Err(self.missing(
                table,
                FenderKey::PANEL_MASS,
                "a weight chain carries the panel's mass",
            ));
        }
        Ok((chains, panel_mass.unwrap_or(0.0)))
    }

    fn chain(&self, chain: Of<'_, ChainKey>, face: &Belting) -> Checked<ChainSetup> {
        let kind: ChainKind = chain.given(ChainKey::KIND).choice();
        let given = |name: Key<_, Number>| chain.item(name).map(|item| *item.number());
        let unwanted: &[AnyKey<ChainKey>] = match kind {
            ChainKind::Tension => &[],
            ChainKind::Shear => any_keys![ChainKey: AT],
            ChainKind::Weight => any_keys![ChainKey: AT, SLACK, LENGTH, SPAN, STIFFNESS],
        };
        for &key in unwanted {
            if let Some(item) = chain.item(key) {
                let path = chain.path_of(key);
                let message = format!("`{path}` is not for {} chains", kind.word());
                return Err(self.sources.error(&item.key_span, &path, message));
            }
        }
        let size = self.chain_size(chain)?;
        let break_load_n = match &size {
            Some(size) => size.break_load_n(),
            None => given(ChainKey::BREAK_LOAD).ok_or_else(|| {
                self.missing(
                    chain,
                    ChainKey::BREAK_LOAD,
                    "give `break_load`, or the chain's `diameter` and `grade`",
                )
            })?,
        };
        if kind == ChainKind::Weight {
            // The stretch of a weight chain does not matter: the chain carries the weight from the start.
            let (slack_m, stiffness_npm) = (0.0, break_load_n);
            return Ok(ChainSetup { kind, at_m: 0.0, slack_m, stiffness_npm, break_load_n });
        }
        if kind == ChainKind::Tension {
            self.within(chain, ChainKey::AT, face.width_m, "width")?;
        }
        let at_m = match (kind, given(ChainKey::AT)) {
            (ChainKind::Tension, None) => {
                return Err(self.missing(
                    chain,
                    ChainKey::AT,
                    "write at = \"-1.5 m\", from the panel's middle",
                ));
            }
            (_, at_m) => at_m.unwrap_or(0.0),
        };
        let stiffness_npm = match &size {
            Some(size) => size.stiffness_npm(given(ChainKey::LENGTH).ok_or_else(|| {
                self.missing(
                    chain,
                    ChainKey::LENGTH,
                    "the stiffness of a chain with a `diameter` follows from its length: give \
                     `length`",
                )
            })?),
            None => given(ChainKey::STIFFNESS).ok_or_else(|| {
                self.missing(chain, ChainKey::STIFFNESS, "write stiffness = \"40 MN/m\"")
            })?,
        };
        let slack_m = self.slack_m(chain)?;
        Ok(ChainSetup { kind, at_m, slack_m, stiffness_npm, break_load_n })
    }

    /// Reads the size of a chain; `None` if the chain has no `diameter`.
    fn chain_size(&self, chain: Of<'_, ChainKey>) -> Checked<Option<ChainSize>> {
        let refuse = |keys: &[AnyKey<ChainKey>], message: fn(&str) -> String| match keys
            .iter()
            .find_map(|key| chain.item(*key))
        {
            None => Ok(()),
            Some(item) => {
                let path = chain.path_to(item);
                Err(self.sources.error(&item.key_span, &path, message(&path)))
            }
        };
        let Some(diameter) = chain.item(ChainKey::DIAMETER) else {
            refuse(any_keys![ChainKey: GRADE, LINK], |path| {
                format!("`{path}` is for chains with a `diameter`")
            })?;
            return Ok(None);
        };
        refuse(any_keys![ChainKey: BREAK_LOAD, STIFFNESS], |path| {
            format!("`{path}` does not go together with `diameter`, which gives this value")
        })?;
        let grade: ChainGrade = match chain.item(ChainKey::GRADE) {
            Some(item) => item.choice(),
            None => return Err(self.missing(chain, ChainKey::GRADE, "write grade = \"u2\"")),
        };
        let link = chain.item(ChainKey::LINK).map_or(ChainLink::Open, Entry::choice);
        if let Some(item) = chain.item(ChainKey::LINK)
            && link == ChainLink::Stud
            && grade.is_short_link()
        {
            let path = chain.path_of(ChainKey::LINK);
            let message = format!("`{path}`: chains of grade 30, 40 and 80 have no studs");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(Some(ChainSize { diameter_m: *diameter.number(), grade, link }))
    }

    /// Slack of a chain: the length of the chain less its span.
    fn slack_m(&self, chain: Of<'_, ChainKey>) -> Checked<f64> {
        let [slack, length, span] =
            [ChainKey::SLACK, ChainKey::LENGTH, ChainKey::SPAN].map(|name| chain.item(name));
        if let Some(slack) = slack {
            let Some(other) = length.or(span) else { return Ok(*slack.number()) };
            let path = chain.path_to(other);
            let message = format!("`{path}` does not go together with `slack`");
            let error = self.sources.error(&other.key_span, &path, message);
            return Err(error.with_help("keep only one of the two keys"));
        }
        let need = |key: Key<ChainKey, Number>| {
            chain.item(key).ok_or_else(|| {
                self.missing(chain, key, "give `slack`, or the chain's `length` and its `span`")
            })
        };
        let (length, span) = (need(ChainKey::LENGTH)?, need(ChainKey::SPAN)?);
        let (length_m, span_m) = (*length.number(), *span.number());
        if length_m < span_m {
            let path = chain.path_of(ChainKey::LENGTH);
            let message = format!(
                "`{path}` of {length_m} m is shorter than the `span` of {span_m} m between the \
                 chain's fastenings"
            );
            let error = self.sources.error(&length.span, &path, message);
            return Err(error.with_help("the chain must reach from one fastening to the other"));
        }
        Ok(length_m - span_m)
    }
}
