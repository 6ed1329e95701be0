//! External programs that apply forces to bodies.

use fenderline_sim::{BodySetup, ProviderSetup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::Table;

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
        let body = self.floating_body(table, "body", bodies, names, "no force moves it")?;
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
