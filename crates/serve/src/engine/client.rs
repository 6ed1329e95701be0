//! A connected client.

use std::time::Instant;

use fenderline_live::message::Role;
use tokio::sync::{mpsc, watch};

use crate::hub::Text;
use crate::rate::Bucket;

/// A connected client.
pub(super) struct Client {
    pub(super) role: Role,
    /// The client's role and number, for notices.
    pub(super) label: String,
    /// The secret of the client's page, which the page keeps when it is reloaded. `None` until the page has sent it.
    pub(super) seat: Option<String>,
    /// The channel that holds the latest greeting.
    pub(super) hello: watch::Sender<Option<Text>>,
    /// The queue of answers and notices for the client.
    pub(super) out: mpsc::Sender<Text>,
    /// Limits the trials of the client.
    pub(super) trials: Bucket,
    /// Time at which the client last asked for the history.
    pub(super) asked: Option<Instant>,
}
