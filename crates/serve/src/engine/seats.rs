//! Keeps links and holders of controls in a file. A server that starts again takes links and holders from the file.

use std::sync::PoisonError;

use super::Engine;
use crate::kept_seats::{KeptSeats, beside};

impl Engine {
    /// Restores the links of a former run of the session. Also restores the holders of those controls that exist in the
    /// scenario.
    pub(super) fn take_seats(&mut self, seats: &KeptSeats) {
        self.hub.tokens.write().unwrap_or_else(PoisonError::into_inner).restore(&seats.links);
        let controls = self.session.cast().controls();
        let mut holders = seats.holders.clone();
        holders.retain(|holder| controls.contains(&holder.control));
        self.claims.restore(&holders);
    }

    /// Keeps the present links and holders of controls in the file beside the recording. A thread of its own writes the
    /// file.
    pub(super) fn keep_seats(&self) {
        let links = self.hub.tokens.read().unwrap_or_else(PoisonError::into_inner).kept();
        let seats = KeptSeats::of(links, self.claims.kept());
        self.keeper.keep(beside(self.recorder.path()), seats);
    }
}
