//! Strangers and clients that mean the live server ill: broken heads, broken frames, commands of any size and kind, from
//! every link. It goes on at its pace, its memory stays bounded, and what it recorded replays to the same bits.

use crate::attack;
use crate::client;
use crate::server;

use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

use attack::{Attack, Draw};
use client::Client;
use serde_json::{Value, json};
use server::Server;

/// How much the server's memory may grow from its first tries on (KiB): kept states, and buffers of those who are slow.
const GROWTH_KIB: u64 = 200 << 10;

/// The longest that a command and the next frame may take on a busy machine.
const LONGEST: Duration = Duration::from_secs(10);

const HEADS: [&str; 12] = [
    "GET / HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "GET /live?token=x HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n\
     Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n",
    "GET /../../etc/passwd HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "GET /%00%ff HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "POST / HTTP/1.1\r\nHost: localhost\r\nTransfer-Encoding: chunked\r\n\r\nffffffffffffffff\r\n",
    "POST / HTTP/1.1\r\nHost: localhost\r\nContent-Length: 18446744073709551615\r\n\r\nx",
    "GET / HTTP/1.1\r\nHost: evil.example\r\nOrigin: http://evil.example\r\n\r\n",
    "GET / HTTP/1.1\r\nHost: localhost\r\nHost: localhost\r\n\r\n",
    "GET / HTTP/0.9\r\n\r\n",
    "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n",
    "OPTIONS * HTTP/1.1\r\nHost: localhost\r\n\r\n",
    "\x16\x03\x01\x02\x00\x01\x00\x01\u{fc}\x03\x03",
];

/// Bytes to a socket: a head with something changed.
fn head(draw: &mut Draw) -> Vec<u8> {
    let mut bytes = draw.of(&HEADS).as_bytes().to_vec();
    for _ in 0..draw.below(4) {
        let at = draw.below(bytes.len());
        match draw.below(4) {
            0 => bytes[at] = draw.next() as u8,
            1 => bytes.truncate(at.max(1)),
            2 => drop(bytes.splice(at..at, std::iter::repeat_n(b'A', draw.below(20_000)))),
            _ => {
                let again = bytes[at..].to_vec();
                bytes.extend(again);
            }
        }
    }
    bytes
}

/// Mostly one that makes sense.
fn number(draw: &mut Draw) -> Value {
    if draw.below(3) > 0 {
        return json!(draw.below(2000) as f64 * 1e-3);
    }
    let numbers = [
        json!(0),
        json!(-0.0),
        json!(0.3),
        json!(-1),
        json!(1e300),
        json!(-1e300),
        json!(5e-324),
        json!(4096),
        json!(18_446_744_073_709_551_615_u64),
        json!(-9_223_372_036_854_775_808_i64),
        json!(null),
        json!("1"),
        json!([]),
        json!({}),
        json!(true),
    ];
    draw.of(&numbers).clone()
}

fn name(draw: &mut Draw) -> Value {
    if draw.below(2) == 0 {
        return json!("ship");
    }
    let names = [
        "ship",
        "forward",
        "aft",
        "quay",
        "head",
        "none",
        "",
        "\u{202e}",
        "../../../etc/passwd",
        "\0",
        "ship ",
    ];
    let name = *draw.of(&names);
    if draw.below(20) == 0 { json!("x".repeat(15_000)) } else { json!(name) }
}

/// A command of the protocol, with fields that mostly fit.
fn command(draw: &mut Draw) -> Value {
    let kinds = 24;
    let (n, m, who) = (number(draw), number(draw), name(draw));
    match draw.below(kinds) {
        0 => json!({ "do": "rudder", "vessel": who, "angle_rad": n }),
        1 => json!({ "do": "engine", "vessel": who, "share": n }),
        2 => json!({ "do": "thruster", "vessel": who, "name": "bow", "power": n }),
        3 => {
            json!({ "do": "azimuth", "vessel": who, "name": "port", "power": n, "direction_rad": m })
        }
        4 => json!({ "do": "course", "vessel": who, "heading_rad": n }),
        5 => json!({ "do": "speed", "vessel": who, "speed_mps": n }),
        6 => json!({ "do": "hands", "vessel": who }),
        7 if draw.below(2) == 0 => {
            json!({ "do": "push", "tug": who, "force_n": n, "direction_rad": m })
        }
        7 => json!({ "do": "tug", "tug": who, "order": "push", "power": n }),
        8 => {
            json!({ "do": "push_ship", "vessel": who, "ship": "ship", "at_m": [n, m], "force_n": 1e5 })
        }
        9 => json!({ "do": "heave", "line": who, "rate_mps": n }),
        10 => json!({ "do": "let_go", "line": who }),
        11 => json!({ "do": "claim", "control": { "vessel": who } }),
        12 => json!({ "do": "release", "control": { "tug": who } }),
        13 => json!({ "do": "pause" }),
        14 => json!({ "do": "resume" }),
        15 => json!({ "do": "single_step" }),
        16 => json!({ "do": "pace", "pace": n }),
        17 if draw.below(2) == 0 => json!({ "do": "rewind", "tick": draw.below(200) }),
        17 => json!({ "do": "rewind", "tick": n }),
        18 => json!({ "do": "branch" }),
        19 => json!({ "do": "show_branch", "id": n }),
        20 => json!({ "do": "acknowledge", "key": who }),
        21 => json!({ "do": "wind", "speed_mps": n, "from_rad": m }),
        22 => json!({ "do": "current", "speed_mps": n, "to_rad": m }),
        _ => json!({ "do": "fault", "vessel": who, "fault": "blackout", "on": draw.below(2) == 0 }),
    }
}

/// An observer who reads all the time, as a page does: the server closes the link of one who does not. Returns the count
/// of frames that it has seen.
async fn watch(server: &Server) -> Arc<AtomicU64> {
    let mut observer = Client::join(server, "observer").await;
    let frames = Arc::new(AtomicU64::new(0));
    let count = Arc::clone(&frames);
    tokio::spawn(async move {
        loop {
            observer.next("frame").await;
            observer.events.clear();
            count.fetch_add(1, Ordering::Relaxed);
        }
    });
    frames
}

#[test]
fn the_server_survives_any_message() {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    runtime.expect("threads").block_on(async {
        let server = Server::start(&[]);
        let mut attack = Attack::begin("server");
        let frames = watch(&server).await;
        let roles = ["instructor", "pilot", "master of forward", "master of aft", "observer"];
        let (mut early_kib, mut answers, mut refused) = (0, 0_u64, 0_u64);
        while let Some(number) = attack.next_try() {
            if number % 10 < 4 {
                let bytes = head(&mut attack.draw);
                // Whatever is answered; a connection that ends early is an answer too.
                client::raw_for(&server, &bytes, Duration::from_millis(100)).await;
            } else {
                let role = *attack.draw.of(&roles);
                let mut one = Client::join(&server, role).await;
                for _ in 0..1 + attack.draw.below(12) {
                    let answer = one.ask(command(&mut attack.draw)).await;
                    answers += 1;
                    refused += u64::from(answer["type"] == "refused");
                }
                one.vanish();
            }
            if number % 10 == 9 {
                // Rewound or paused nothing is carried out: go on from there, as an instructor would.
                let mut instructor = Client::join(&server, "instructor").await;
                for word in ["branch", "resume"] {
                    instructor.ask(json!({ "do": word })).await;
                }
                instructor.vanish();
            }
            if number == 50 {
                early_kib = server.memory_kib();
            }
            if number.is_multiple_of(50) {
                // It still shows what is.
                let began = Instant::now();
                let mut instructor = Client::join(&server, "instructor").await;
                let resumed = instructor.ask(json!({ "do": "resume" })).await;
                assert_eq!(resumed["type"], "ack", "{}: {resumed}", attack.here());
                let seen = frames.load(Ordering::Relaxed);
                while frames.load(Ordering::Relaxed) == seen {
                    assert!(began.elapsed() < LONGEST, "{}: no frame", attack.here());
                    tokio::time::sleep(Duration::from_millis(10)).await;
                }
                let took = began.elapsed();
                assert!(took < LONGEST, "{}: {took:?}", attack.here());
                let late_kib = server.memory_kib();
                let grown = late_kib.saturating_sub(early_kib);
                assert!(grown < GROWTH_KIB, "{}: {early_kib} to {late_kib} KiB", attack.here());
            }
        }
        let memory_kib = server.memory_kib();
        server.stop_and_check();
        attack.end(&format!("{answers} commands, {refused} refused, {memory_kib} KiB at the end"));
    });
}
