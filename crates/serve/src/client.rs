//! The task that serves one client with a valid link. The task serves the client's websocket.

use std::future::pending;
use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::extract::ws::{CloseFrame, Message, WebSocket};
use fenderline_live::message::{self, Reply, Role};
use fenderline_live::{Refusal, Request};
use tokio::sync::{mpsc, watch};
use tokio::time::{MissedTickBehavior, interval, timeout};

use super::claims::ClientId;
use super::hub::{Hub, Kind, Published, Text, ToEngine};
use super::rate::Bucket;

/// A client is disconnected if the client does not read a message within this time.
const SEND_TIMEOUT: Duration = Duration::from_secs(10);
/// Time between two pings. A client that is silent for longer than `MOST_SILENCE` is disconnected.
const PING_INTERVAL: Duration = Duration::from_secs(5);
const MOST_SILENCE: Duration = Duration::from_secs(16);
/// Commands that a client may send per second, and commands in one burst.
const COMMANDS: (f64, f64) = (30.0, 60.0);
/// Number of refused messages in a row after which a client is disconnected.
const MOST_REFUSED: u32 = 300;
/// Largest number of answers and notices that wait to be sent to one client.
const MOST_ANSWERS: usize = 128;

/// Close codes of websockets: the standard's code for a broken policy, and our own codes for an unknown token and for a
/// full server.
const POLICY: u16 = 1008;
const NO_TOKEN: u16 = 4401;
const FULL: u16 = 4429;

/// Closes a websocket whose token the server does not know.
pub(crate) async fn turn_away(socket: WebSocket) {
    close(socket, NO_TOKEN, "this link is not valid on this server: ask for a new link").await;
}

/// Closes a websocket for which no seat is free.
pub(crate) async fn turn_away_full(socket: WebSocket) {
    close(socket, FULL, "all seats are taken").await;
}

async fn close(mut socket: WebSocket, code: u16, reason: &'static str) {
    let frame = CloseFrame { code, reason: reason.into() };
    let closing = async {
        let _ = socket.send(Message::Close(Some(frame))).await;
        // Waits until the client closes the websocket or sends anything else, so that the client receives our close
        // message.
        let _ = socket.recv().await;
    };
    let _ = timeout(Duration::from_secs(2), closing).await;
}

/// Serves a client until the client disconnects, is silent for too long or breaks a limit.
pub(crate) async fn serve(mut socket: WebSocket, hub: Arc<Hub>, role: Role, kind: Kind) {
    let client = hub.new_client();
    let (hello, greeted) = watch::channel(None);
    let (out, answers) = mpsc::channel(MOST_ANSWERS);
    if !hub.send_to_engine(ToEngine::Join { client, role: role.clone(), kind, hello, out }) {
        return;
    }
    let ended = exchange(&mut socket, &hub, (client, &role), greeted, answers).await;
    hub.send_to_engine(ToEngine::Leave { client });
    if let Some(reason) = ended {
        hub.log.refused(&format!("closed client {client}: {reason}"));
        close(socket, POLICY, reason).await;
    }
}

/// Exchanges messages with a client until one side ends the connection. If the server ends the connection, returns the
/// reason.
async fn exchange(
    socket: &mut WebSocket,
    hub: &Arc<Hub>,
    (client, role): (ClientId, &Role),
    mut greeted: watch::Receiver<Option<Text>>,
    mut answers: mpsc::Receiver<Text>,
) -> Option<&'static str> {
    // Sends the greeting first, because a page cannot draw frames without it.
    match timeout(SEND_TIMEOUT, greeted.wait_for(Option::is_some)).await {
        Ok(Ok(_)) => {}
        _ => return Some("the server is busy"),
    }
    greeted.mark_changed();
    let mut frames = hub.frames.subscribe();
    frames.mark_changed();
    let mut predictions = hub.predictions.subscribe();
    predictions.mark_changed();
    let mut last_event =
        frames.borrow().as_ref().and_then(|s| s.events.last().map(|e| e.0)).unwrap_or(0);
    let mut ping = interval(PING_INTERVAL);
    ping.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut listener = Listener::new(client);
    // No prediction is sent before a frame for this role: it could show what fog hides.
    let (mut is_greeted, mut has_frame) = (false, false);
    loop {
        let message = tokio::select! {
            biased;
            // The first greeting comes before all answers. Later an answer goes before a greeting: the answer to the
            // command that opened another scenario would else come after the greeting of that scenario, with which a
            // client ends.
            answer = answers.recv(), if is_greeted => Some(answer?.to_string()),
            changed = greeted.changed() => {
                changed.ok()?;
                is_greeted = true;
                greeted.borrow_and_update().as_ref().map(|text| text.to_string())
            }
            received = socket.recv() => match listener.take(received, hub) {
                Taken::Nothing => None,
                Taken::Answer(text) => Some(text),
                Taken::Disconnected => return None,
                Taken::Disconnect(reason) => return Some(reason),
            },
            changed = async { if is_greeted { frames.changed().await } else { pending().await } } => {
                changed.ok()?;
                let published = frames.borrow_and_update().clone();
                let published = published.filter(|published| published.is_for(role));
                has_frame |= published.is_some();
                published.map(|published| frame_for(&published, role, &mut last_event))
            }
            changed = async { if has_frame { predictions.changed().await } else { pending().await } } => {
                changed.ok()?;
                let predicted = predictions.borrow_and_update().clone();
                let latest = frames.borrow().clone();
                let fog = latest.as_ref().and_then(|published| published.fog_of(role));
                let hidden = fog.map_or(&[][..], |fog| &fog.hidden);
                predicted.map(|predicted| predicted.without(hidden))
            }
            _ = ping.tick() => {
                if listener.last_received.elapsed() > MOST_SILENCE {
                    return Some("the client was silent for too long");
                }
                match timeout(SEND_TIMEOUT, socket.send(Message::Ping(Vec::new().into()))).await {
                    Ok(Ok(())) => None,
                    Ok(Err(_)) => return None,
                    Err(_) => return Some("the client does not read its messages"),
                }
            }
        };
        let Some(text) = message else { continue };
        match timeout(SEND_TIMEOUT, socket.send(Message::Text(text.into()))).await {
            Ok(Ok(())) => {}
            Ok(Err(_)) => return None,
            Err(_) => return Some("the client does not read its messages"),
        }
    }
}

/// The latest frame (the message with the present state), with the events that this client has not received yet. For an
/// instructor, the frame includes the score and the deductions of the exercise.
fn frame_for(published: &Published, role: &Role, last_event: &mut u64) -> String {
    let new = published.events.iter().filter(|(number, _)| *number > *last_event);
    let new: Vec<_> = new.map(|(_, event)| event.clone()).collect();
    *last_event = published.events.last().map_or(*last_event, |(number, _)| *number);
    let marks = published.marks.as_deref().filter(|_| *role == Role::Instructor);
    message::with_events(published.frame_for(role), &new, marks)
}

/// What the server does after a message of the client.
enum Taken {
    Nothing,
    /// Send this answer.
    Answer(String),
    /// The server does nothing, because the client has disconnected.
    Disconnected,
    /// The server disconnects the client for the reason in the text.
    Disconnect(&'static str),
}

/// Receives the messages of a client and passes its commands on.
struct Listener {
    client: ClientId,
    bucket: Bucket,
    /// Number of refused messages since the last good message.
    refused: u32,
    last_received: Instant,
}

impl Listener {
    fn new(client: ClientId) -> Listener {
        let now = Instant::now();
        let bucket = Bucket::new(COMMANDS.0, COMMANDS.1, now);
        Listener { client, bucket, refused: 0, last_received: now }
    }

    fn take(&mut self, received: Option<Result<Message, axum::Error>>, hub: &Hub) -> Taken {
        self.last_received = Instant::now();
        let text = match received {
            None => return Taken::Disconnected,
            // The frame is too large or malformed, or the connection is lost.
            Some(Err(e)) => {
                hub.log.refused(&format!("lost client {}: {e}", self.client));
                return Taken::Disconnected;
            }
            Some(Ok(Message::Close(_))) => return Taken::Disconnected,
            Some(Ok(Message::Ping(_) | Message::Pong(_))) => return Taken::Nothing,
            Some(Ok(Message::Binary(_))) => {
                return self.refuse("a client's commands must be text, not binary");
            }
            Some(Ok(Message::Text(text))) => text,
        };
        if !self.bucket.take(self.last_received) {
            return self.refuse("too many commands");
        }
        let (id, request) = Request::parse(&text);
        if request.is_ok() {
            self.refused = 0;
        } else {
            self.refused += 1;
            if self.refused > MOST_REFUSED {
                return Taken::Disconnect(
                    "the client has sent too many messages that are not understood",
                );
            }
        }
        if hub.send_to_engine(ToEngine::Command { client: self.client, id, request }) {
            return Taken::Nothing;
        }
        let reason = Refusal::new("the server is busy: too many commands wait").to_string();
        Taken::Answer(message::text(&Reply::Refused { id, reason }))
    }

    /// Refuses a client's message without asking the simulation. Of many refusals, only the first, second, fourth,
    /// eighth and so on are answered. A flood of messages therefore does not cause a flood of answers.
    fn refuse(&mut self, reason: &str) -> Taken {
        self.refused += 1;
        if self.refused > MOST_REFUSED {
            return Taken::Disconnect("too many commands");
        }
        if !self.refused.is_power_of_two() {
            return Taken::Nothing;
        }
        let reason = reason.to_owned();
        Taken::Answer(message::text(&Reply::Refused { id: None, reason }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page of the protocol states the limits that hold.
    #[test]
    fn the_guide_of_the_protocol_states_the_limits() {
        let guide = include_str!("../../../docs/guides/protocol.md");
        let guide = guide.split_whitespace().collect::<Vec<_>>().join(" ");
        for text in [
            format!("{} a second, {} in a burst", COMMANDS.0, COMMANDS.1),
            format!("| refused messages in a row | {MOST_REFUSED} |"),
            format!(
                "| {} s; the server pings every {} s |",
                MOST_SILENCE.as_secs(),
                PING_INTERVAL.as_secs()
            ),
            format!("reads nothing | {} s |", SEND_TIMEOUT.as_secs()),
            format!("with code {NO_TOKEN}"),
            format!("with code {FULL}"),
            format!("with code {POLICY}"),
            format!("describes version {}.", message::PROTOCOL),
        ] {
            assert!(guide.contains(&text), "docs/guides/protocol.md does not say: {text}");
        }
    }
}
