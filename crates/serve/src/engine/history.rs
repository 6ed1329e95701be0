//! Sends the session's past to pages that were loaded anew.

use std::sync::Arc;
use std::time::{Duration, Instant};

use fenderline_live::{Refusal, message};

use super::Engine;
use crate::claims::ClientId;
use crate::hub::Text;

/// A client may ask once within this time: the answer is a hundred kilobytes.
const BETWEEN: Duration = Duration::from_secs(1);

/// The text of the last answer, for the next client that asks at the same tick.
#[derive(Debug, Default)]
pub(super) struct KeptHistory(Option<((usize, u64, u64), Text)>);

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
        let version = self.session.history_version();
        let text = match &self.history.0 {
            Some((kept, text)) if *kept == version => Arc::clone(text),
            _ => {
                let text: Text = message::text(&self.session.history()).into();
                self.history.0 = Some((version, Arc::clone(&text)));
                text
            }
        };
        // The queue of a client that does not read is full. Its connection is about to be closed for that.
        let _ = of.out.try_send(text);
        Ok(())
    }
}
