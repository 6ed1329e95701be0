//! What the simulation's thread and the clients' tasks share: channels, tokens, counters.

use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, RwLock};

use fenderline_live::message::{self, EventNow, Reply, Role};
use fenderline_live::{Refusal, Request};
use fenderline_nautical::read::ControlOrder;
use fenderline_sim::ShipModel;
use tokio::sync::{mpsc, watch};

use super::claims::ClientId;
use super::connections::Peer;
use super::log::{Log, Notify};
use super::opening::Outcome;
use super::seats::{Seat, Seats};
use super::tokens::Tokens;

/// Largest number of commands of all clients that may wait for the simulation's thread.
const MOST_WAITING: usize = 256;
/// Largest number of observers, and of clients with a control. Observers and clients with a control are counted
/// separately, so that observers cannot block a control.
const MOST_WATCHING: usize = 48;
const MOST_STEERING: usize = 32;

/// A text that is sent to many clients.
pub(crate) type Text = Arc<str>;

/// The latest round of sentences for chart programs.
pub(crate) type Sentences = Option<Arc<[String]>>;

/// A published frame (a message with the state of the session), and the last events with their numbers. By the numbers,
/// clients that missed frames still get every event.
#[derive(Clone, Debug)]
pub(crate) struct Published {
    /// The frame for roles from which nothing is hidden.
    pub(crate) frame: Text,
    /// The roles for which the frame was made: for each of them the server has worked out what fog hides.
    pub(crate) roles: Arc<[Role]>,
    /// Frames for the roles from which fog hides something.
    pub(crate) in_fog: Arc<[InFog]>,
    pub(crate) events: Arc<[(u64, EventNow)]>,
    /// The score and the deductions of the exercise as JSON, for instructors.
    pub(crate) marks: Option<Text>,
}

/// The frame for a role from which fog hides ships.
#[derive(Clone, Debug)]
pub(crate) struct InFog {
    pub(crate) role: Role,
    pub(crate) frame: Text,
    /// Indices of the vessels that fog hides from the role.
    pub(crate) hidden: Vec<usize>,
}

impl Published {
    /// True if the published frame was made for a role. The first client of a role waits for the next frame, so that
    /// the client sees nothing that fog hides.
    pub(crate) fn is_for(&self, role: &Role) -> bool {
        self.roles.contains(role)
    }

    /// The published frame as a role may see it.
    pub(crate) fn frame_for(&self, role: &Role) -> &Text {
        self.fog_of(role).map_or(&self.frame, |fog| &fog.frame)
    }

    /// The frame in fog for a role; `None` if fog hides nothing from the role.
    pub(crate) fn fog_of(&self, role: &Role) -> Option<&InFog> {
        self.in_fog.iter().find(|fog| fog.role == *role)
    }
}

/// A prediction of paths: its text for clients from which nothing is hidden, and the paths.
#[derive(Clone, Debug)]
pub(crate) struct Predicted {
    text: Text,
    prediction: Reply,
}

impl Predicted {
    pub(crate) fn new(prediction: Reply) -> Predicted {
        Predicted { text: message::text(&prediction).into(), prediction }
    }

    /// The text of the prediction for a client from which fog hides the vessels `hidden`.
    pub(crate) fn without(&self, hidden: &[usize]) -> String {
        match &self.prediction {
            Reply::Prediction { tick, paths } if !hidden.is_empty() => {
                let seen = paths.iter().filter(|path| !hidden.contains(&path.vessel));
                let paths = seen.cloned().collect();
                message::text(&Reply::Prediction { tick: *tick, paths })
            }
            _ => self.text.to_string(),
        }
    }
}

/// What a client is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// The page of a person.
    Page,
    /// A program that steers by the protocol of the pages.
    Program,
    /// A controller that steers by NMEA sentences.
    Nmea,
}

/// A message to the thread that runs the simulation.
pub(crate) enum ToEngine {
    /// A client has connected. `hello` always holds the latest greeting for the client. `out` is the queue of answers
    /// and notices for the client, which must not be lost.
    Join {
        client: ClientId,
        role: Role,
        kind: Kind,
        hello: watch::Sender<Option<Text>>,
        out: mpsc::Sender<Text>,
    },
    /// The client has disconnected.
    Leave { client: ClientId },
    /// The client sent a command.
    Command { client: ClientId, id: Option<i64>, request: Result<Request, Refusal> },
    /// A controller gave an order by an NMEA sentence.
    Steer { client: ClientId, order: ControlOrder },
    /// A controller has given no order for some time.
    Silent { client: ClientId },
    /// Work on another thread has finished.
    WorkDone(Outcome),
    /// The server is stopping.
    Stop,
}

/// Everything that the simulation's thread and the clients' tasks share.
pub(crate) struct Hub {
    to_engine: Sender<ToEngine>,
    waiting: AtomicUsize,
    next_client: AtomicU64,
    pub(crate) frames: watch::Sender<Option<Published>>,
    pub(crate) predictions: watch::Sender<Option<Arc<Predicted>>>,
    /// The latest round of instrument sentences for chart programs.
    pub(crate) sentences: watch::Sender<Sentences>,
    pub(crate) tokens: RwLock<Tokens>,
    /// The latest report of the session, as HTML.
    pub(crate) report: RwLock<Option<Text>>,
    /// The models of the session's vessels for the view, in the order of the vessels.
    pub(crate) models: RwLock<Vec<Option<ShipModel>>>,
    watching: Arc<Seats>,
    steering: Arc<Seats>,
    pub(crate) log: Log,
}

impl Hub {
    pub(crate) fn new(to_engine: Sender<ToEngine>, notify: Notify) -> Hub {
        Hub {
            to_engine,
            waiting: AtomicUsize::new(0),
            next_client: AtomicU64::new(1),
            frames: watch::Sender::new(None),
            predictions: watch::Sender::new(None),
            sentences: watch::Sender::new(None),
            tokens: RwLock::new(Tokens::default()),
            report: RwLock::default(),
            models: RwLock::default(),
            watching: Seats::of(MOST_WATCHING),
            steering: Seats::of(MOST_STEERING),
            log: Log::new(notify),
        }
    }

    /// Takes a seat for a client with a role. Dropping the seat frees it for another client. The result is `None` if
    /// all seats are taken, or all seats that one address may take.
    pub(crate) fn seat(&self, role: &Role, peer: Peer) -> Option<Seat> {
        let seats = if *role == Role::Observer { &self.watching } else { &self.steering };
        Seats::take(seats, peer)
    }

    /// A client number that has never been used.
    pub(crate) fn new_client(&self) -> ClientId {
        self.next_client.fetch_add(1, Ordering::Relaxed)
    }

    /// Sends a message to the simulation's thread. The number of messages that may wait is limited. Returns false if
    /// too many messages wait, or if the server is stopping.
    pub(crate) fn send_to_engine(&self, message: ToEngine) -> bool {
        if matches!(message, ToEngine::Command { .. } | ToEngine::Steer { .. }) {
            if self.waiting.fetch_add(1, Ordering::AcqRel) >= MOST_WAITING {
                self.waiting.fetch_sub(1, Ordering::AcqRel);
                return false;
            }
            if self.to_engine.send(message).is_err() {
                self.waiting.fetch_sub(1, Ordering::AcqRel);
                return false;
            }
            return true;
        }
        self.to_engine.send(message).is_ok()
    }

    /// Counts a command that the simulation's thread has taken from the queue.
    pub(crate) fn command_taken(&self) {
        self.waiting.fetch_sub(1, Ordering::AcqRel);
    }
}
