//! A client with a token: its websocket, in a task of its own.

use std::future::pending;
use std::sync::Arc;
use std::time::{Duration, Instant};

use axum::extract::ws::{CloseFrame, Message, WebSocket};
use fenderline_live::message::{self, Reply as Answer, Role};
use fenderline_live::{Refusal, Request};
use tokio::sync::{mpsc, watch};
use tokio::time::{MissedTickBehavior, interval, timeout};

use super::claims::ClientId;
use super::hub::{Hub, Shown, Text, Told};
use super::rate::Bucket;

/// A client that takes nothing for so long is gone.
const SEND: Duration = Duration::from_secs(10);
/// It is asked whether it is there so often, and gone when it has said nothing for so long.
const PING: Duration = Duration::from_secs(5);
const SILENT: Duration = Duration::from_secs(16);
/// Commands a second, and at once; beyond so many refused ones in a row it is shown the door.
const COMMANDS: (f64, f64) = (30.0, 60.0);
const PATIENCE: u32 = 300;
/// Answers and notices that wait for it at most.
const ANSWERS: usize = 128;

/// Close codes: the standard's for a policy, and ours for a token that opens nothing.
const POLICY: u16 = 1008;
const NO_TOKEN: u16 = 4401;
const FULL: u16 = 4429;

/// Turns away somebody whose token opens nothing.
pub(crate) async fn turn_away(socket: WebSocket) {
    close(socket, NO_TOKEN, "this link opens no role here: ask for a new one").await;
}

/// Turns away somebody for whom there is no seat.
pub(crate) async fn full(socket: WebSocket) {
    close(socket, FULL, "all seats are taken").await;
}

async fn close(mut socket: WebSocket, code: u16, reason: &'static str) {
    let frame = CloseFrame { code, reason: reason.into() };
    let said = async {
        let _ = socket.send(Message::Close(Some(frame))).await;
        // Its own close, so that it gets to read ours; or whatever else it says first.
        let _ = socket.recv().await;
    };
    let _ = timeout(Duration::from_secs(2), said).await;
}

/// Serves a client until it goes, falls silent, or misbehaves.
pub(crate) async fn serve(mut socket: WebSocket, hub: Arc<Hub>, role: Role) {
    let client = hub.new_client();
    let (hello, greeted) = watch::channel(None);
    let (out, answers) = mpsc::channel(ANSWERS);
    if !hub.tell_engine(Told::Join { client, role, hello, out }) {
        return;
    }
    let ended = talk(&mut socket, &hub, client, greeted, answers).await;
    hub.tell_engine(Told::Leave { client });
    if let Some(reason) = ended {
        hub.log.refused(&format!("closed client {client}: {reason}"));
        close(socket, POLICY, reason).await;
    }
}

/// The talk; why it was ended, where it was not by the client.
async fn talk(
    socket: &mut WebSocket,
    hub: &Arc<Hub>,
    client: ClientId,
    mut greeted: watch::Receiver<Option<Text>>,
    mut answers: mpsc::Receiver<Text>,
) -> Option<&'static str> {
    // The greeting first: without it frames mean nothing.
    match timeout(SEND, greeted.wait_for(Option::is_some)).await {
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
    let mut ping = interval(PING);
    ping.set_missed_tick_behavior(MissedTickBehavior::Delay);
    let mut listener = Listener::new(client);
    let mut is_greeted = false;
    loop {
        let message = tokio::select! {
            biased;
            changed = greeted.changed() => {
                changed.ok()?;
                is_greeted = true;
                greeted.borrow_and_update().as_ref().map(|text| text.to_string())
            }
            answer = answers.recv() => Some(answer?.to_string()),
            heard = socket.recv() => match listener.hear(heard, hub) {
                Heard::Nothing => None,
                Heard::Answer(text) => Some(text),
                Heard::Gone => return None,
                Heard::Enough(reason) => return Some(reason),
            },
            changed = async { if is_greeted { frames.changed().await } else { pending().await } } => {
                changed.ok()?;
                let shown = frames.borrow_and_update().clone();
                shown.map(|shown| frame_for(&shown, &mut last_event))
            }
            changed = predictions.changed() => {
                changed.ok()?;
                predictions.borrow_and_update().as_ref().map(|text| text.to_string())
            }
            _ = ping.tick() => {
                if listener.heard_at.elapsed() > SILENT {
                    return Some("it has been silent for too long");
                }
                match timeout(SEND, socket.send(Message::Ping(Vec::new().into()))).await {
                    Ok(Ok(())) => None,
                    Ok(Err(_)) => return None,
                    Err(_) => return Some("it does not read"),
                }
            }
        };
        let Some(text) = message else { continue };
        match timeout(SEND, socket.send(Message::Text(text.into()))).await {
            Ok(Ok(())) => {}
            Ok(Err(_)) => return None,
            Err(_) => return Some("it does not read"),
        }
    }
}

/// A frame with the events that this client has not had.
fn frame_for(shown: &Shown, last_event: &mut u64) -> String {
    let new = shown.events.iter().filter(|(number, _)| *number > *last_event);
    let new: Vec<_> = new.map(|(_, event)| event.clone()).collect();
    *last_event = shown.events.last().map_or(*last_event, |(number, _)| *number);
    message::with_events(&shown.frame, &new)
}

/// What became of something that came in.
enum Heard {
    Nothing,
    Answer(String),
    Gone,
    Enough(&'static str),
}

/// Reads what a client says.
struct Listener {
    client: ClientId,
    bucket: Bucket,
    refused: u32,
    heard_at: Instant,
}

impl Listener {
    fn new(client: ClientId) -> Listener {
        let now = Instant::now();
        let bucket = Bucket::new(COMMANDS.0, COMMANDS.1, now);
        Listener { client, bucket, refused: 0, heard_at: now }
    }

    fn hear(&mut self, heard: Option<Result<Message, axum::Error>>, hub: &Hub) -> Heard {
        self.heard_at = Instant::now();
        let text = match heard {
            None => return Heard::Gone,
            // A frame beyond the limit, a broken frame, or a connection that broke.
            Some(Err(e)) => {
                hub.log.refused(&format!("lost client {}: {e}", self.client));
                return Heard::Gone;
            }
            Some(Ok(Message::Close(_))) => return Heard::Gone,
            Some(Ok(Message::Ping(_) | Message::Pong(_))) => return Heard::Nothing,
            Some(Ok(Message::Binary(_))) => return self.refuse("commands are text, not binary"),
            Some(Ok(Message::Text(text))) => text,
        };
        if !self.bucket.take(self.heard_at) {
            return self.refuse("too many commands");
        }
        let (id, request) = Request::parse(&text);
        if request.is_ok() {
            self.refused = 0;
        } else {
            self.refused += 1;
            if self.refused > PATIENCE {
                return Heard::Enough("too much that is not understood");
            }
        }
        if hub.tell_engine(Told::Said { client: self.client, id, request }) {
            return Heard::Nothing;
        }
        let reason = Refusal::new("the server has too much to do").to_string();
        Heard::Answer(message::text(&Answer::Refused { id, reason }))
    }

    /// Refuses without asking the simulation; not every time in words, or the answers would be a flood too.
    fn refuse(&mut self, reason: &str) -> Heard {
        self.refused += 1;
        if self.refused > PATIENCE {
            return Heard::Enough("too many commands");
        }
        if !self.refused.is_power_of_two() {
            return Heard::Nothing;
        }
        let reason = reason.to_owned();
        Heard::Answer(message::text(&Answer::Refused { id: None, reason }))
    }
}
