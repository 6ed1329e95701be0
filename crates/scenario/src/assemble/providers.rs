//! External programs that apply forces to bodies.

use fenderline_sim::{BodySetup, ProviderSetup};

use super::{Assembly, Checked, Names};
use crate::checked::Table;
use crate::sources::quoted;

impl Assembly<'_, '_> {
    pub(super) fn providers(
        &self,
        providers: &[Table],
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Vec<ProviderSetup>> {
        providers.iter().map(|table| self.provider(table, bodies, names)).collect()
    }

    fn provider(
        &self,
        table: &Table,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<ProviderSetup> {
        let item = table.given("body");
        let body = self.body_named(table, item, item.name(), names)?;
        if bodies[body].mass.is_none() {
            let path = table.path_of("body");
            let message =
                format!("`{path}`: body {} is fixed, no force moves it", quoted(item.name()));
            return Err(self.sources.error(&item.span, &path, message));
        }
        let command = table.given("command");
        if command.texts().is_empty() {
            let path = table.path_of("command");
            let message = format!("`{path}` is empty: it must name a program");
            return Err(self.sources.error(&command.span, &path, message));
        }
        Ok(ProviderSetup {
            body,
            command: command.texts().to_vec(),
            timeout_s: *table.given("timeout").number(),
            hold_s: *table.given("hold").number(),
        })
    }
}
