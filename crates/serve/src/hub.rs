//! What the simulation's thread and the clients' tasks share: channels, tokens, counters.

use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, RwLock};

use fenderline_live::message::{EventNow, Role};
use fenderline_live::{Refusal, Request};
use tokio::sync::{mpsc, watch};

use super::claims::ClientId;
use super::crowd::Peer;
use super::log::{Log, Notify};
use super::opening::Outcome;
use super::seats::{Seat, Seats};
use super::tokens::Tokens;

/// Commands that wait for the simulation's thread at most, of all clients together.
const MOST_WAITING: usize = 256;
/// Clients at a time that watch, and that steer: who only watches keeps nobody from a helm.
const MOST_WATCHING: usize = 48;
const MOST_STEERING: usize = 32;

/// A text that many clients are sent.
pub(crate) type Text = Arc<str>;

/// The sentences of the last second for chart programs.
pub(crate) type Said = Option<Arc<[String]>>;

/// A frame, and the last events with their numbers: who missed frames still gets them.
#[derive(Clone, Debug)]
pub(crate) struct Shown {
    pub(crate) frame: Text,
    pub(crate) events: Arc<[(u64, EventNow)]>,
}

/// What the simulation's thread is told.
pub(crate) enum Told {
    /// A client has come. `hello` always holds the latest greeting, `out` what must not be missed.
    Join {
        client: ClientId,
        role: Role,
        hello: watch::Sender<Option<Text>>,
        out: mpsc::Sender<Text>,
    },
    /// It has gone.
    Leave { client: ClientId },
    /// It said something.
    Said { client: ClientId, id: Option<i64>, request: Result<Request, Refusal> },
    /// Something that was done beside the simulation's thread is done.
    Done(Outcome),
    /// The program is to end.
    Stop,
}

/// The shared part.
pub(crate) struct Hub {
    to_engine: Sender<Told>,
    waiting: AtomicUsize,
    next_client: AtomicU64,
    pub(crate) frames: watch::Sender<Option<Shown>>,
    pub(crate) predictions: watch::Sender<Option<Text>>,
    /// What the instruments say.
    pub(crate) said: watch::Sender<Said>,
    pub(crate) tokens: RwLock<Tokens>,
    watching: Arc<Seats>,
    steering: Arc<Seats>,
    pub(crate) log: Log,
}

impl Hub {
    pub(crate) fn new(to_engine: Sender<Told>, notify: Notify) -> Hub {
        Hub {
            to_engine,
            waiting: AtomicUsize::new(0),
            next_client: AtomicU64::new(1),
            frames: watch::Sender::new(None),
            predictions: watch::Sender::new(None),
            said: watch::Sender::new(None),
            tokens: RwLock::new(Tokens::default()),
            watching: Seats::of(MOST_WATCHING),
            steering: Seats::of(MOST_STEERING),
            log: Log::new(notify),
        }
    }

    /// A seat for a role, free again when it is dropped; `None` where all are taken, or all that one address gets.
    pub(crate) fn seat(&self, role: &Role, peer: Peer) -> Option<Seat> {
        let seats = if *role == Role::Observer { &self.watching } else { &self.steering };
        Seats::take(seats, peer)
    }

    /// A number that no client had.
    pub(crate) fn new_client(&self) -> ClientId {
        self.next_client.fetch_add(1, Ordering::Relaxed)
    }

    /// Tells the simulation's thread; of commands only so many wait. False where there was no room, or the program
    /// ends.
    pub(crate) fn tell_engine(&self, told: Told) -> bool {
        if matches!(told, Told::Said { .. }) {
            if self.waiting.fetch_add(1, Ordering::AcqRel) >= MOST_WAITING {
                self.waiting.fetch_sub(1, Ordering::AcqRel);
                return false;
            }
            if self.to_engine.send(told).is_err() {
                self.waiting.fetch_sub(1, Ordering::AcqRel);
                return false;
            }
            return true;
        }
        self.to_engine.send(told).is_ok()
    }

    /// The simulation's thread has taken a command.
    pub(crate) fn taken(&self) {
        self.waiting.fetch_sub(1, Ordering::AcqRel);
    }
}
