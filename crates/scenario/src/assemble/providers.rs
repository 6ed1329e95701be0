//! Reads external programs that apply forces to bodies.

use fenderline_sim::{BodySetup, ProviderSetup};

use super::assembly::{Assembly, Checked, Names};
use fenderline_keys::checked::{List, Of};
use fenderline_keys::keys::provider::ProviderKey;

impl Assembly<'_, '_> {
    pub(super) fn providers(
        &self,
        providers: List<'_, ProviderKey>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<Vec<ProviderSetup>> {
        providers.iter().map(|table| self.provider(table, bodies, names)).collect()
    }

    fn provider(
        &self,
        table: Of<'_, ProviderKey>,
        bodies: &[BodySetup],
        names: &Names,
    ) -> Checked<ProviderSetup> {
        let body =
            self.floating_body(table, ProviderKey::BODY, bodies, names, "no force moves it")?;
        let command = table.given(ProviderKey::COMMAND);
        if command.texts().is_empty() {
            let path = table.path_of(ProviderKey::COMMAND);
            let message = format!("`{path}` is empty: it must name a program");
            return Err(self.sources.error(&command.span, &path, message));
        }
        Ok(ProviderSetup {
            body,
            command: command.texts().to_vec(),
            timeout_s: *table.given(ProviderKey::TIMEOUT).number(),
            hold_s: *table.given(ProviderKey::HOLD).number(),
        })
    }
}
