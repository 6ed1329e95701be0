//! Links and holders of controls, kept for a server that starts again.

use std::sync::PoisonError;

use super::Engine;
use crate::kept_seats::{KeptSeats, beside};

impl Engine {
    /// Takes the links of a former run of this session, and its holders of the controls that there are.
    pub(super) fn take_seats(&mut self, seats: &KeptSeats) {
        self.hub.tokens.write().unwrap_or_else(PoisonError::into_inner).restore(&seats.links);
        let controls = self.session.cast().controls();
        let mut holders = seats.holders.clone();
        holders.retain(|holder| controls.contains(&holder.control));
        self.claims.restore(&holders);
    }

    /// Keeps the present links and holders beside the recording, by another thread.
    pub(super) fn keep_seats(&self) {
        let links = self.hub.tokens.read().unwrap_or_else(PoisonError::into_inner).kept();
        let seats = KeptSeats::of(links, self.claims.kept());
        self.keeper.keep(beside(self.recorder.path()), seats);
    }
}
