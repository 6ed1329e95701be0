//! Reads which bodies may touch, and which material their contact has.

use std::collections::BTreeSet;

use fenderline_sim::{BodySetup, PairSetup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{Entry, List, Of};
use fenderline_keys::error::ScenarioError;
use fenderline_keys::held::TwoNames;
use fenderline_keys::keys::material::PairKey;
use fenderline_keys::sources::quoted;

pub(super) struct Pairs {
    pub(super) named: Vec<PairSetup>,
    pub(super) every_other: Option<usize>,
    /// The indices of the two bodies of each named pair, the lower index first.
    touching: BTreeSet<[usize; 2]>,
}

impl Pairs {
    pub(super) fn new(named: Vec<PairSetup>, every_other: Option<usize>) -> Pairs {
        let touching = named.iter().map(|pair| ordered(pair.bodies)).collect();
        Pairs { named, every_other, touching }
    }
}

impl Pairs {
    /// Adds a pair, unless the file names the pair.
    pub(super) fn add_if_new(&mut self, pair: PairSetup) {
        if self.touching.insert(ordered(pair.bodies)) {
            self.named.push(pair);
        }
    }

    /// Whether some pair allows two bodies to touch.
    pub(super) fn may_touch(&self, bodies: [usize; 2]) -> bool {
        self.every_other.is_some() || self.touching.contains(&ordered(bodies))
    }
}

fn ordered([one, other]: [usize; 2]) -> [usize; 2] {
    [one.min(other), one.max(other)]
}

impl Assembly<'_, '_> {
    pub(super) fn pairs(
        &self,
        pairs: List<'_, PairKey>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Pairs> {
        let mut read = Pairs::new(Vec::with_capacity(pairs.len()), None);
        for table in pairs {
            let item = table.given(PairKey::BODIES);
            let material_item = table.given(PairKey::MATERIAL);
            let two = item.two_names();
            if let [true, true] = two.each_ref().map(|name| name == "*") {
                let material = self.material_named(table, material_item, names)?;
                if read.every_other.replace(material).is_some() {
                    return Err(self.pair_error(table, item, "[\"*\", \"*\"] is given twice"));
                }
                continue;
            }
            let [one, other] = self.two_bodies(table, item, bodies, names)?;
            if !read.touching.insert(ordered([one, other])) {
                let message = format!(
                    "the pair of {} and {} is given twice",
                    quoted(&two[0]),
                    quoted(&two[1])
                );
                return Err(self.pair_error(table, item, &message));
            }
            let material = self.material_named(table, material_item, names)?;
            read.named.push(PairSetup { bodies: [one, other], material });
        }
        Ok(read)
    }

    fn two_bodies<T>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, TwoNames>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<[usize; 2]> {
        let two = item.two_names();
        if two.iter().any(|name| name == "*") {
            let error = self.pair_error(table, item, "\"*\" stands for both bodies or for none");
            return Err(error.with_help("write [\"*\", \"*\"] for every pair not named otherwise"));
        }
        let [one, other] = two.each_ref().map(|name| self.body_named(table, item, name, names));
        let [one, other] = [one?, other?];
        if one == other {
            let message = format!("body {} cannot touch itself", quoted(&two[0]));
            return Err(self.pair_error(table, item, &message));
        }
        if bodies[one].mass.is_none() && bodies[other].mass.is_none() {
            let message = format!(
                "bodies {} and {} are both fixed: nothing could happen between them",
                quoted(&two[0]),
                quoted(&two[1])
            );
            return Err(self.pair_error(table, item, &message));
        }
        Ok([one, other])
    }

    fn pair_error<T, V>(
        &self,
        table: Of<'_, T>,
        item: Entry<'_, V>,
        message: &str,
    ) -> ScenarioError {
        let path = table.path_to(item);
        self.sources.error(&item.span, &path, format!("`{path}`: {message}"))
    }
}
