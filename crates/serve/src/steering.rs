//! Serves controllers that steer the pilot's ship by NMEA 0183 sentences over TCP. A controller needs no link, so that
//! the port is open to this machine alone unless the user says otherwise.
//!
//! A controller is a client with the role of the pilot: it holds the helm as others do, and people take the helm from
//! it in one press.

mod counts;
mod lines;

use std::sync::Arc;
use std::time::{Duration, Instant};

use fenderline_live::message::Role;
use fenderline_nautical::read::{Control, SentenceFault, body_of, control};
use serde_json::Value;
use tokio::io::AsyncReadExt as _;
use tokio::net::{TcpListener, TcpStream};
use tokio::sync::{mpsc, watch};
use tokio::time::{MissedTickBehavior, interval, sleep};

use self::counts::{Counts, Dropped};
use self::lines::{Line, Lines};
use super::claims::ClientId;
use super::connections::{Connections, Peer};
use super::hub::{Hub, Kind, Text, ToEngine};
use super::rate::Bucket;

/// Largest number of controllers that may be connected. If more connect, an old one is disconnected (see
/// `connections`).
const MOST: usize = 4;
/// Orders that a controller may give per second, and orders in one burst: those of a page.
const ORDERS: (f64, f64) = (30.0, 60.0);
/// Time without an order after which a controller loses the helm. The last order stands.
const MOST_SILENCE: Duration = Duration::from_secs(10);
/// Number of bytes that are read at once, and the pause after them. A controller that floods has to wait: at most some
/// 400 kB are read in a second.
const BLOCK: usize = 4096;
const PAUSE: Duration = Duration::from_millis(10);
/// Time between two lines of the log about one controller.
const BETWEEN_REPORTS: Duration = Duration::from_secs(1);
/// Number of answers that wait for a controller's task.
const MOST_ANSWERS: usize = 128;

/// Serves every controller that connects.
pub(crate) async fn serve(listener: TcpListener, hub: Arc<Hub>) {
    let connections = Connections::of(MOST);
    loop {
        let Ok((stream, from)) = listener.accept().await else {
            sleep(Duration::from_millis(100)).await;
            continue;
        };
        let place = connections.enter(Peer::of(from.ip()));
        let hub = Arc::clone(&hub);
        tokio::spawn(async move {
            let client = hub.new_client();
            let (hello, _greeted) = watch::channel(None);
            let (out, answers) = mpsc::channel(MOST_ANSWERS);
            let join = ToEngine::Join { client, role: Role::PILOT, kind: Kind::Nmea, hello, out };
            if !hub.send_to_engine(join) {
                return;
            }
            let mut controller = Controller::new(client, Arc::clone(&hub));
            tokio::select! {
                () = controller.obey(stream, answers) => {}
                () = place.asked_out() => {
                    hub.log.refused("a controller was disconnected: there are too many of them");
                }
            }
            hub.send_to_engine(ToEngine::Leave { client });
            controller.report();
        });
    }
}

/// A connected controller.
struct Controller {
    client: ClientId,
    hub: Arc<Hub>,
    lines: Lines,
    counts: Counts,
    /// The counts that the log has told.
    told: Counts,
    bucket: Bucket,
    /// Time of the last order; `None` until the first order, and once the controller has lost the helm by its silence.
    ordered: Option<Instant>,
}

impl Controller {
    fn new(client: ClientId, hub: Arc<Hub>) -> Controller {
        let bucket = Bucket::new(ORDERS.0, ORDERS.1, Instant::now());
        Controller {
            client,
            hub,
            lines: Lines::default(),
            counts: Counts::default(),
            told: Counts::default(),
            bucket,
            ordered: None,
        }
    }

    /// Obeys the sentences of the controller until it disconnects.
    async fn obey(&mut self, mut stream: TcpStream, mut answers: mpsc::Receiver<Text>) {
        let mut block = [0; BLOCK];
        let mut reports = interval(BETWEEN_REPORTS);
        reports.set_missed_tick_behavior(MissedTickBehavior::Delay);
        loop {
            tokio::select! {
                biased;
                _ = reports.tick() => {
                    self.report();
                    self.mind_silence(Instant::now());
                }
                answer = answers.recv() => match answer {
                    Some(answer) => self.hear(&answer),
                    None => return,
                },
                read = stream.read(&mut block) => {
                    let Ok(bytes @ 1..) = read else {
                        if self.lines.end() {
                            self.counts.drop(Dropped::NoSum);
                        }
                        return;
                    };
                    self.take(&block[..bytes]);
                    if bytes == BLOCK {
                        sleep(PAUSE).await;
                    }
                }
            }
        }
    }

    /// Takes bytes of the controller, and passes the orders in them on.
    fn take(&mut self, bytes: &[u8]) {
        let mut lines = std::mem::take(&mut self.lines);
        lines.push(bytes, |line| match line {
            Line::Whole(text) => {
                if let Err(why) = self.obey_line(text) {
                    self.counts.drop(why);
                }
            }
            Line::TooLong => self.counts.drop(Dropped::TooLong),
            Line::NoText => self.counts.drop(Dropped::NoSentence),
        });
        self.lines = lines;
    }

    fn obey_line(&mut self, line: &str) -> Result<(), Dropped> {
        let (_, body) = body_of(line).map_err(dropped)?;
        let order = match control(body).map_err(dropped)? {
            Control::Order(order) => order,
            Control::Report => return Err(Dropped::Report),
            Control::Other => return Err(Dropped::Other),
        };
        let now = Instant::now();
        if !self.bucket.take(now) {
            return Err(Dropped::TooMany);
        }
        if !self.hub.send_to_engine(ToEngine::Steer { client: self.client, order }) {
            return Err(Dropped::TooMany);
        }
        self.ordered = Some(now);
        self.counts.given();
        Ok(())
    }

    /// Counts a refusal of the simulation's thread.
    fn hear(&mut self, answer: &str) {
        let answer: Value = serde_json::from_str(answer).unwrap_or_default();
        if answer["type"] == "refused" {
            self.counts.refused(answer["reason"].as_str().unwrap_or_default());
        }
    }

    /// Writes a line of the log if anything was dropped since the last line.
    fn report(&mut self) {
        if self.counts.has_dropped_since(&self.told) {
            let text = format!("NMEA controller {}: {}", self.client, self.counts);
            self.hub.log.refused(&text);
            self.told = self.counts.clone();
        }
    }

    /// Gives the helm of a controller that has fallen silent back.
    fn mind_silence(&mut self, now: Instant) {
        if self.ordered.is_some_and(|at| now >= at + MOST_SILENCE) {
            self.ordered = None;
            self.hub.send_to_engine(ToEngine::Silent { client: self.client });
        }
    }
}

fn dropped(fault: SentenceFault) -> Dropped {
    match fault {
        SentenceFault::NoSentence => Dropped::NoSentence,
        SentenceFault::NoSum => Dropped::NoSum,
        SentenceFault::WrongSum => Dropped::WrongSum,
        SentenceFault::Field(_) => Dropped::Field,
    }
}
