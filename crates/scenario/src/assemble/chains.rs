//! Chains of fenders: from their tables to a set-up.

use fenderline_contact::Panel;
use fenderline_sim::{ChainGrade, ChainKind, ChainLink, ChainSetup, ChainSize};

use super::assembly::{Assembly, Checked};
use crate::vessels::Belting;
use fenderline_keys::checked::{Item, Table};

impl Assembly<'_, '_> {
    /// The chains of a fender, and the mass that its weight chains carry (kg).
    pub(super) fn chains(&self, table: &Table, face: &Belting) -> Checked<(Vec<ChainSetup>, f64)> {
        let panel_mass = table.item("panel_mass").map(|item| *item.number());
        let Some(item) = table.item("chains") else {
            return Ok((vec![], panel_mass.unwrap_or(0.0)));
        };
        let read = item.list().iter().map(|chain| self.chain(chain, face));
        let chains: Vec<ChainSetup> = read.collect::<Checked<_>>()?;
        let has = |kind: ChainKind| chains.iter().filter(|chain| chain.kind == kind).count();
        let refused = |message: String, help: &str| {
            let path = table.path_of("chains");
            Err(self.sources.error(&item.span, &path, message).with_help(help))
        };
        if has(ChainKind::Tension) > 0 && table.item("cones").is_none() {
            let message = format!(
                "`{}`: a tension chain holds a panel that turns, and this fender has no `cones`",
                table.path_of("chains")
            );
            return refused(message, "give the panel its `cones`, or leave the chain out");
        }
        if has(ChainKind::Tension) > Panel::MOST_CHAINS {
            let message = format!(
                "`{}` must have at most {} tension chains",
                table.path_of("chains"),
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
                "panel_mass",
                "a weight chain carries the panel's mass",
            ));
        }
        Ok((chains, panel_mass.unwrap_or(0.0)))
    }

    fn chain(&self, chain: &Table, face: &Belting) -> Checked<ChainSetup> {
        let kind: ChainKind = chain.given("kind").choice();
        let given = |name: &str| chain.item(name).map(|item| *item.number());
        let unwanted: &[&str] = match kind {
            ChainKind::Tension => &[],
            ChainKind::Shear => &["at"],
            ChainKind::Weight => &["at", "slack", "length", "span", "stiffness"],
        };
        for name in unwanted {
            if let Some(item) = chain.item(name) {
                let path = chain.path_of(name);
                let message = format!("`{path}` is not for {} chains", kind.word());
                return Err(self.sources.error(&item.key_span, &path, message));
            }
        }
        let size = self.chain_size(chain)?;
        let break_load_n = match &size {
            Some(size) => size.break_load_n(),
            None => given("break_load").ok_or_else(|| {
                self.missing(chain, "break_load", "give it, or the chain's `diameter` and `grade`")
            })?,
        };
        if kind == ChainKind::Weight {
            // The stretch of a weight chain does not matter: the chain carries the weight from the start.
            let (slack_m, stiffness_npm) = (0.0, break_load_n);
            return Ok(ChainSetup { kind, at_m: 0.0, slack_m, stiffness_npm, break_load_n });
        }
        if kind == ChainKind::Tension {
            self.within(chain, "at", face.width_m, "width")?;
        }
        let at_m = match (kind, given("at")) {
            (ChainKind::Tension, None) => {
                return Err(self.missing(
                    chain,
                    "at",
                    "write at = \"-1.5 m\", from the panel's middle",
                ));
            }
            (_, at_m) => at_m.unwrap_or(0.0),
        };
        let stiffness_npm = match &size {
            Some(size) => size.stiffness_npm(given("length").ok_or_else(|| {
                self.missing(
                    chain,
                    "length",
                    "a chain's stiffness by its `diameter` goes with its length",
                )
            })?),
            None => given("stiffness")
                .ok_or_else(|| self.missing(chain, "stiffness", "write stiffness = \"40 MN/m\""))?,
        };
        let slack_m = self.slack_m(chain)?;
        Ok(ChainSetup { kind, at_m, slack_m, stiffness_npm, break_load_n })
    }

    /// The chain's size; `None` without a `diameter`.
    fn chain_size(&self, chain: &Table) -> Checked<Option<ChainSize>> {
        let refuse = |names: &[&str], why: &str| match names.iter().find_map(|n| chain.item(n)) {
            None => Ok(()),
            Some(item) => {
                let path = chain.path_of(item.name);
                let message = format!("`{path}` {why}");
                Err(self.sources.error(&item.key_span, &path, message))
            }
        };
        let Some(diameter) = chain.item("diameter") else {
            refuse(&["grade", "link"], "is for chains with a `diameter`")?;
            return Ok(None);
        };
        refuse(
            &["break_load", "stiffness"],
            "does not go together with `diameter`, which gives this value",
        )?;
        let grade: ChainGrade = match chain.item("grade") {
            Some(item) => item.choice(),
            None => return Err(self.missing(chain, "grade", "write grade = \"u2\"")),
        };
        let link = chain.item("link").map_or(ChainLink::Open, Item::choice);
        if let Some(item) = chain.item("link")
            && link == ChainLink::Stud
            && grade.is_short_link()
        {
            let path = chain.path_of("link");
            let message = format!("`{path}`: chains of grade 30, 40 and 80 have no studs");
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(Some(ChainSize { diameter_m: *diameter.number(), grade, link }))
    }

    /// Slack of a chain: its length less its span.
    fn slack_m(&self, chain: &Table) -> Checked<f64> {
        let [slack, length, span] = ["slack", "length", "span"].map(|name| chain.item(name));
        if let Some(slack) = slack {
            let Some(other) = length.or(span) else { return Ok(*slack.number()) };
            let path = chain.path_of(other.name);
            let message = format!("`{path}` does not go together with `slack`");
            let error = self.sources.error(&other.key_span, &path, message);
            return Err(error.with_help("keep one of the two"));
        }
        let need = |name: &str| {
            chain.item(name).ok_or_else(|| {
                self.missing(chain, name, "give `slack`, or the chain's `length` and its `span`")
            })
        };
        let (length, span) = (need("length")?, need("span")?);
        let (length_m, span_m) = (*length.number(), *span.number());
        if length_m < span_m {
            let path = chain.path_of("length");
            let message = format!(
                "`{path}` of {length_m} m is shorter than the `span` of {span_m} m between its fastenings"
            );
            let error = self.sources.error(&length.span, &path, message);
            return Err(error.with_help("the chain must reach from one fastening to the other"));
        }
        Ok(length_m - span_m)
    }
}
