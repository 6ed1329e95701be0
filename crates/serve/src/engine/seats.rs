//! Links and holders of controls. Links and holders are kept for a server that starts again.

use std::sync::PoisonError;

use super::Engine;
use crate::kept_seats::{KeptSeats, beside};

impl Engine {
    /// Restores the links of a former run of this session. Restores the holders of those controls that exist.
    pub(super) fn take_seats(&mut self, seats: &KeptSeats) {
        self.hub.tokens.write().unwrap_or_else(PoisonError::into_inner).restore(&seats.links);
        let controls = self.session.cast().controls();
        let mut holders = seats.holders.clone();
        holders.retain(|holder| controls.contains(&holder.control));
        self.claims.restore(&holders);
    }

    /// Keeps the present links and holders in the file beside the recording. Another thread writes the file.
    pub(super) fn keep_seats(&self) {
        let links = self.hub.tokens.read().unwrap_or_else(PoisonError::into_inner).kept();
        let seats = KeptSeats::of(links, self.claims.kept());
        self.keeper.keep(beside(self.recorder.path()), seats);
    }
}
