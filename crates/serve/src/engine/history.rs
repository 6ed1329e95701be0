//! Sends the session's past to pages that were loaded anew.

use std::time::{Duration, Instant};

use fenderline_live::{Refusal, message};

use super::Engine;
use crate::claims::ClientId;

/// A client may ask once within this time: the answer is a hundred kilobytes.
const BETWEEN: Duration = Duration::from_secs(1);

impl Engine {
    /// Sends the past up to the present tick to a client.
    ///
    /// # Errors
    /// It asked a moment ago.
    pub(super) fn send_history(&mut self, client: ClientId, now: Instant) -> Result<(), Refusal> {
        let Some(of) = self.clients.get_mut(&client) else { return Ok(()) };
        if of.asked.is_some_and(|at| now < at + BETWEEN) {
            return Err(Refusal::new("the history was sent a moment ago"));
        }
        of.asked = Some(now);
        let (session, version) = (&self.session, self.session.history_version());
        let text = self.history.text(version, || message::text(&session.history()).into());
        // The queue of a client that does not read is full. Its connection is about to be closed for that.
        let _ = of.out.try_send(text);
        Ok(())
    }
}
