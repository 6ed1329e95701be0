//! A connected client.

use std::time::Instant;

use fenderline_live::message::Role;
use tokio::sync::{mpsc, watch};

use crate::hub::{Kind, Text};
use crate::rate::Bucket;

/// A connected client.
pub(super) struct Client {
    pub(super) role: Role,
    pub(super) kind: Kind,
    /// The client's role and number, as notices name the client.
    pub(super) label: String,
    /// The secret of the client's page, which the page keeps when the page is reloaded. The secret is `None` until the
    /// page has sent it.
    pub(super) seat: Option<String>,
    /// The channel that holds the latest greeting for the client.
    pub(super) hello: watch::Sender<Option<Text>>,
    /// The queue of answers and notices for the client.
    pub(super) out: mpsc::Sender<Text>,
    /// Limits how often the client may start trials.
    pub(super) trials: Bucket,
    /// Time at which the client last asked for the session's past.
    pub(super) asked: Option<Instant>,
}

impl Client {
    /// True if the client is a program, from which people take controls.
    pub(super) fn is_program(&self) -> bool {
        self.kind != Kind::Page
    }
}
