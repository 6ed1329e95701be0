//! External loads.

use fenderline_contact::Vec2;
use fenderline_sim::{BodySetup, Load};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{List, Of};
use fenderline_keys::keys::load::LoadKey;

impl Assembly<'_, '_> {
    pub(super) fn loads(
        &self,
        loads: List<'_, LoadKey>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Vec<Load>> {
        loads.iter().map(|table| self.load(table, bodies, names)).collect()
    }

    pub(super) fn load(
        &self,
        table: Of<'_, LoadKey>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Load> {
        let body = self.floating_body(table, LoadKey::BODY, bodies, names, "no load moves it")?;
        let (force, moment) = (table.item(LoadKey::FORCE), table.item(LoadKey::MOMENT));
        if force.is_none() && moment.is_none() {
            let path = table.path_of(LoadKey::FORCE);
            let message = format!("`{path}` is missing, and so is `moment`");
            let error = self.sources.error(&table.span, &path, message);
            return Err(error.with_help("write force = [\"0 kN\", \"-500 kN\"]"));
        }
        let from_s = *table.given(LoadKey::FROM).number();
        let until = table.item(LoadKey::UNTIL);
        let until_s = until.map_or(f64::INFINITY, |item| *item.number());
        if let Some(item) = until.filter(|_| until_s <= from_s) {
            let path = table.path_of(LoadKey::UNTIL);
            let message = format!(
                "`{path}` must be later than `from`, which is {from_s} s, but is {until_s} s"
            );
            return Err(self.sources.error(&item.span, &path, message));
        }
        Ok(Load {
            body,
            force_n: force.map_or(Vec2::ZERO, |item| *item.vector()),
            moment_nm: moment.map_or(0.0, |item| *item.number()),
            from_s,
            until_s,
        })
    }
}
