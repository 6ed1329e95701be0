//! Clients of all kinds.
#![allow(dead_code, reason = "each test file uses its own part")]

use std::time::Duration;

use futures_util::{SinkExt as _, StreamExt as _};
use serde_json::{Value, json};
use tokio::io::{AsyncReadExt as _, AsyncWriteExt as _};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_tungstenite::tungstenite::client::IntoClientRequest as _;
use tokio_tungstenite::tungstenite::{Error, Message};
use tokio_tungstenite::{MaybeTlsStream, WebSocketStream, connect_async};

use crate::server::Server;

/// Longer than anything takes on a busy machine.
const LONG: Duration = Duration::from_secs(30);
/// Longer than any one answer of a server that sends frames all the time: a test that waits for what never comes
/// fails, and says what it waited for.
const ANSWER: Duration = Duration::from_secs(120);

/// What is waited for, in time.
async fn in_time<T>(what: &str, wanted: impl Future<Output = T>) -> T {
    match timeout(ANSWER, wanted).await {
        Ok(came) => came,
        Err(_) => panic!("{what} did not come within {} s", ANSWER.as_secs()),
    }
}

type Socket = WebSocketStream<MaybeTlsStream<TcpStream>>;

async fn connect(server: &Server, path: &str) -> Result<Socket, Error> {
    let url = format!("ws://127.0.0.1:{}{path}", server.port);
    timeout(LONG, connect_async(url)).await.expect("an answer in time").map(|(socket, _)| socket)
}

fn live_path(server: &Server, role: &str) -> String {
    server.path(role).replace("/?", "/live?")
}

/// A client that behaves.
pub(crate) struct Client {
    socket: Socket,
    next_id: i64,
    pub(crate) hello: Value,
    hellos: Vec<Value>,
    notices: Vec<String>,
    pub(crate) events: Vec<String>,
}

impl Client {
    pub(crate) async fn join(server: &Server, role: &str) -> Client {
        Client::join_at(server, &live_path(server, role)).await
    }

    /// A client that says that it is a program.
    pub(crate) async fn join_as_program(server: &Server, role: &str) -> Client {
        Client::join_at(server, &(live_path(server, role) + "&program=1")).await
    }

    async fn join_at(server: &Server, path: &str) -> Client {
        let socket = connect(server, path).await.expect("let in");
        let mut client = Client {
            socket,
            next_id: 1,
            hello: Value::Null,
            hellos: vec![],
            notices: vec![],
            events: vec![],
        };
        client.hello = client.next("hello").await;
        client
    }

    pub(crate) async fn send(&mut self, text: &str) {
        in_time("room to send", self.socket.send(Message::text(text))).await.expect("sent");
    }

    pub(crate) async fn send_bytes(&mut self, bytes: Vec<u8>) {
        in_time("room to send", self.socket.send(Message::binary(bytes))).await.expect("sent");
    }

    /// The next message, whatever it is.
    async fn hear(&mut self) -> Value {
        loop {
            let message = timeout(LONG, self.socket.next()).await.expect("something in time");
            match message.expect("an open connection").expect("a good message") {
                Message::Text(text) => {
                    let value: Value = serde_json::from_str(&text).expect("JSON");
                    match value["type"].as_str() {
                        Some("hello") => self.hellos.push(value.clone()),
                        Some("notice") => {
                            self.notices.push(value["text"].as_str().expect("a text").to_owned());
                        }
                        Some("frame") => {
                            let events = value["events"].as_array().expect("events");
                            let texts = events.iter().map(|e| e["text"].as_str().expect("a text"));
                            self.events.extend(texts.map(str::to_owned));
                        }
                        _ => {}
                    }
                    return value;
                }
                Message::Close(frame) => panic!("closed: {frame:?}"),
                _ => {}
            }
        }
    }

    /// The next message of any type.
    pub(crate) async fn any(&mut self) -> Value {
        in_time("a message", self.hear()).await
    }

    /// The next message of a type.
    pub(crate) async fn next(&mut self, kind: &str) -> Value {
        in_time(&format!("a message `{kind}`"), async {
            loop {
                let message = self.hear().await;
                if message["type"] == kind {
                    return message;
                }
            }
        })
        .await
    }

    /// The refusal of what was sent last. Panics when it was accepted.
    pub(crate) async fn refusal(&mut self) -> Value {
        in_time("a refusal", async {
            loop {
                let message = self.hear().await;
                assert_ne!(message["type"], "ack", "it was accepted");
                if message["type"] == "refused" {
                    return message;
                }
            }
        })
        .await
    }

    /// Gives a command; the answer.
    pub(crate) async fn ask(&mut self, action: Value) -> Value {
        let id = self.next_id;
        self.next_id += 1;
        let command = json!({ "type": "command", "id": id, "action": &action });
        self.send(&command.to_string()).await;
        in_time(&format!("an answer to {action}"), async {
            loop {
                let message = self.hear().await;
                let is_answer = message["type"] == "ack" || message["type"] == "refused";
                if is_answer && message["id"] == id {
                    return message;
                }
            }
        })
        .await
    }

    /// Gives a command that is carried out; a frame that was made after it.
    pub(crate) async fn ask_and_see(&mut self, action: Value) -> Value {
        let answer = self.ask(action.clone()).await;
        assert_eq!(answer["type"], "ack", "{action}: {answer}");
        // The first one may have been under way before.
        self.next("frame").await;
        self.next("frame").await
    }

    /// Has a scenario or a session opened; a frame of it.
    pub(crate) async fn load(&mut self, file: &str) -> Value {
        let answer = self.ask(json!({ "do": "load", "file": file })).await;
        assert_eq!(answer["type"], "ack", "{file}: {answer}");
        self.notice("has loaded").await;
        self.next("frame").await;
        self.next("frame").await
    }

    /// The first frame at a tick or later.
    pub(crate) async fn frame_after(&mut self, tick: u64) -> Value {
        in_time(&format!("a frame at tick {tick}"), async {
            loop {
                let frame = self.next("frame").await;
                if frame["tick"].as_u64().expect("a tick") >= tick {
                    return frame;
                }
            }
        })
        .await
    }

    /// The first notice with a word in it, be it told already.
    pub(crate) async fn notice(&mut self, word: &str) -> String {
        in_time(&format!("a notice with `{word}`"), async {
            loop {
                if let Some(at) = self.notices.iter().position(|text| text.contains(word)) {
                    return self.notices.remove(at);
                }
                self.hear().await;
            }
        })
        .await
    }

    /// Whether a notice with this word has come.
    pub(crate) fn has_heard(&self, word: &str) -> bool {
        self.notices.iter().any(|text| text.contains(word))
    }

    /// The first greeting, from the latest so far on, that is as wanted.
    pub(crate) async fn hello_with(&mut self, is_wanted: impl Fn(&Value) -> bool) -> Value {
        in_time("a greeting as wanted", async {
            loop {
                if let Some(hello) = self.hellos.last().filter(|hello| is_wanted(hello)) {
                    return hello.clone();
                }
                self.hear().await;
            }
        })
        .await
    }

    /// Goes without a word.
    pub(crate) fn vanish(self) {
        drop(self.socket);
    }
}

/// The code and the reason with which a websocket is closed at once.
pub(crate) async fn closed(server: &Server, query: &str) -> (u16, String) {
    let mut socket = connect(server, &format!("/live{query}")).await.expect("answered");
    loop {
        match timeout(LONG, socket.next()).await.expect("something in time") {
            Some(Ok(Message::Close(Some(frame)))) => {
                return (frame.code.into(), frame.reason.to_string());
            }
            Some(Ok(Message::Text(text))) => panic!("a stranger is told: {text}"),
            Some(Ok(_)) => {}
            other => panic!("not closed: {other:?}"),
        }
    }
}

/// The status with which a websocket's request is answered, some headers changed.
pub(crate) async fn status(server: &Server, path: &str, headers: &[(&str, &str)]) -> u16 {
    let url = format!("ws://127.0.0.1:{}{path}", server.port);
    let mut request = url.into_client_request().expect("a request");
    for (name, value) in headers {
        let name: tokio_tungstenite::tungstenite::http::HeaderName = name.parse().expect("a name");
        request.headers_mut().insert(name, value.parse().expect("a value"));
    }
    match timeout(LONG, connect_async(request)).await.expect("an answer in time") {
        Ok((_, response)) => response.status().as_u16(),
        Err(Error::Http(response)) => response.status().as_u16(),
        Err(other) => panic!("{other}"),
    }
}

/// A TCP connection to the server.
async fn tcp(server: &Server) -> TcpStream {
    let address = ("127.0.0.1", server.port);
    in_time("a connection", TcpStream::connect(address)).await.expect("connected")
}

/// What is answered to some bytes.
pub(crate) async fn raw(server: &Server, request: &[u8]) -> String {
    let mut stream = tcp(server).await;
    in_time("room to send", stream.write_all(request)).await.expect("sent");
    let mut answer = Vec::new();
    let _ = timeout(LONG, stream.read_to_end(&mut answer)).await.expect("an end in time");
    String::from_utf8_lossy(&answer).into_owned()
}

/// A file of the page, with its head.
pub(crate) async fn get(server: &Server, path: &str) -> String {
    let request = format!("GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\n\r\n", server.port);
    raw(server, request.as_bytes()).await
}

/// A websocket by hand, so that it can do what no good client does.
async fn by_hand(server: &Server, path: &str) -> TcpStream {
    let mut stream = tcp(server).await;
    let request = format!(
        "GET {path} HTTP/1.1\r\nHost: 127.0.0.1:{}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
         Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
        server.port
    );
    stream.write_all(request.as_bytes()).await.expect("sent");
    let mut head = [0; 12];
    timeout(LONG, stream.read_exact(&mut head)).await.expect("in time").expect("an answer");
    assert_eq!(&head, b"HTTP/1.1 101");
    stream
}

/// Says that 100 MB come in one frame and sends until it is shown the door.
pub(crate) async fn giant(server: &Server, path: &str) {
    let mut stream = by_hand(server, path).await;
    // Text, the last of its message, masked, 64 bits of length.
    let mut head = vec![0x81, 0xff];
    head.extend(100_000_000_u64.to_be_bytes());
    head.extend([0; 4]);
    stream.write_all(&head).await.expect("sent");
    let block = vec![b'x'; 1 << 16];
    let sending = async {
        let mut sent = 0;
        while sent < 100_000_000 && stream.write_all(&block).await.is_ok() {
            sent += block.len();
        }
        sent
    };
    let sent = timeout(LONG, sending).await.expect("an end in time");
    assert!(sent < 20_000_000, "{sent} bytes of 100 MB were taken");
}

/// Sends commands as fast as it can; true where it was shown the door.
pub(crate) async fn flood(server: &Server, role: &str, commands: usize) -> bool {
    let socket = connect(server, &live_path(server, role)).await.expect("let in");
    let (mut to, mut from) = socket.split();
    let reading = tokio::spawn(async move {
        while let Some(Ok(message)) = from.next().await {
            if message.is_close() {
                return true;
            }
        }
        true
    });
    for number in 0..commands {
        let text = match number % 3 {
            0 => {
                r#"{"type":"command","id":1,"action":{"do":"rudder","vessel":"ship","angle_rad":1}}"#
            }
            1 => "{{{{",
            _ => r#"{"type":"command","id":1,"action":{"do":"rewind","tick":0}}"#,
        };
        if in_time("room to send", to.send(Message::text(text))).await.is_err() {
            break;
        }
    }
    timeout(LONG, reading).await.is_ok_and(|ended| ended.unwrap_or(false))
}

/// Connections that say nothing, or begin a request and never end it.
pub(crate) struct Sleepers(Vec<TcpStream>);

pub(crate) async fn sleepers(server: &Server, count: usize) -> Sleepers {
    let mut all = Vec::new();
    for number in 0..count {
        let mut stream = tcp(server).await;
        if number % 2 == 0 {
            stream.write_all(b"GET / HTTP/1.1\r\nHost: local").await.expect("sent");
        }
        all.push(stream);
    }
    Sleepers(all)
}

impl Sleepers {
    /// Does the server end them all by itself?
    pub(crate) async fn ended_within(self, time: Duration) -> bool {
        let all = async {
            for mut stream in self.0 {
                let mut rest = Vec::new();
                let _ = stream.read_to_end(&mut rest).await;
            }
        };
        timeout(time, all).await.is_ok()
    }
}

/// A client that joins and then neither reads nor answers, its connection still open.
pub(crate) async fn half_open(server: &Server, role: &str) -> TcpStream {
    by_hand(server, &live_path(server, role)).await
}

/// The first lines that somebody says who only speaks.
pub(crate) async fn lines(from: std::net::SocketAddr, count: usize) -> String {
    let mut stream = TcpStream::connect(from).await.expect("connected");
    let (mut text, mut block) = (String::new(), [0; 4096]);
    while text.matches('\n').count() < count {
        let read = timeout(LONG, stream.read(&mut block)).await.expect("in time").expect("read");
        assert!(read > 0, "it went away: {text}");
        text += &String::from_utf8_lossy(&block[..read]);
    }
    text.truncate(text.rfind('\n').expect("lines") + 1);
    text
}

/// Some bytes to the server, for a while, whatever it answers.
pub(crate) async fn raw_for(server: &Server, request: &[u8], time: Duration) {
    let mut stream = tcp(server).await;
    let _ = timeout(time, stream.write_all(request)).await;
    let mut answer = Vec::new();
    let _ = timeout(time, stream.read_to_end(&mut answer)).await;
}
