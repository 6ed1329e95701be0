//! A connected client.

use std::time::Instant;

use fenderline_live::message::Role;
use tokio::sync::{mpsc, watch};

use crate::hub::Text;
use crate::rate::Bucket;

/// A connected client.
pub(super) struct Client {
    pub(super) role: Role,
    /// Its role and number, for notices.
    pub(super) label: String,
    /// The secret of its page, which it keeps over a reload; `None` until it has said it.
    pub(super) seat: Option<String>,
    /// Holds the latest greeting.
    pub(super) hello: watch::Sender<Option<Text>>,
    /// Queues answers and notices.
    pub(super) out: mpsc::Sender<Text>,
    /// Limits its trials.
    pub(super) trials: Bucket,
    /// When it last asked for the history.
    pub(super) asked: Option<Instant>,
}
