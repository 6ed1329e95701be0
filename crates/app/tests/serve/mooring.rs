//! Mooring with what goes wrong: two hands on one line, bollards that are taken or out of reach, lines that are not fast.

use std::path::Path;

use serde_json::{Value, json};

use super::{block_on, reason};
use crate::client::Client;
use crate::server::Server;

fn send(line: &str, bollard: &str) -> Value {
    json!({ "do": "send", "line": line, "bollard": bollard })
}

fn plain(word: &str, line: &str) -> Value {
    json!({ "do": word, "line": line })
}

fn winch(word: &str, line: &str, rate_mps: f64) -> Value {
    json!({ "do": word, "line": line, "rate_mps": rate_mps })
}

/// A bulk carrier at rest half a metre off the fenders; bollards take one line, and there is no boat.
fn alongside() -> Server {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/live/berthing.toml");
    Server::start_with(
        &scene,
        &[
            "--set",
            "body.ship.position=[0, -17.4]",
            "--set",
            "body.ship.heading=\"0 deg\"",
            "--set",
            "body.ship.velocity.surge=0",
            "--set",
            "body.forward_tug.position=[60, -75]",
            "--set",
            "body.after_tug.position=[-70, -75]",
            "--set",
            "line_handling.boat=false",
            "--set",
            "bollard.b9.lines=1",
            "--set",
            "bollard.b10.lines=1",
        ],
    )
}

/// What is known of a line, in a frame.
fn line<'f>(frame: &'f Value, hello: &Value, name: &str) -> &'f Value {
    let lines = hello["lines"].as_array().expect("lines");
    let index = lines.iter().position(|line| line["name"] == name).expect("a line");
    &frame["lines"][index]
}

/// Asks for something that cannot be, and compares the reason.
async fn refused(client: &mut Client, action: Value, why: &str) {
    let answer = client.ask(action.clone()).await;
    assert!(reason(&answer).contains(why), "{action}: {answer}");
}

async fn accepted(client: &mut Client, action: Value) {
    let answer = client.ask(action.clone()).await;
    assert_eq!(answer["type"], "ack", "{action}: {answer}");
}

/// Waits until a line is in a state; the frame.
async fn until(client: &mut Client, name: &str, state: &str) -> Value {
    let hello = client.hello.clone();
    loop {
        let frame = client.next("frame").await;
        if line(&frame, &hello, name)["state"] == state {
            return frame;
        }
    }
}

#[test]
fn what_cannot_be_done_with_a_line_is_answered_with_the_reason_and_nothing_is_lost() {
    block_on(async {
        let server = alongside();
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        let mut master = Client::join(&server, "master of forward_tug").await;
        let mut observer = Client::join(&server, "observer").await;
        accepted(&mut instructor, json!({ "do": "pace", "pace": 20 })).await;
        // On board: it can be sent, and nothing else.
        let aboard = "line `head` is on board";
        for action in [
            winch("heave", "head", 0.1),
            winch("pay_out", "head", 0.1),
            plain("hold", "head"),
            plain("let_go", "head"),
        ] {
            refused(&mut pilot, action, aboard).await;
        }
        refused(&mut instructor, plain("part_line", "head"), "is not fast").await;
        // Names, and who may.
        refused(&mut pilot, send("head", "b99"), "`b99`").await;
        refused(&mut pilot, send("heat", "b9"), "no line `heat`").await;
        refused(&mut pilot, json!({ "do": "send", "line": "head" }), "missing field `bollard`")
            .await;
        refused(
            &mut pilot,
            json!({ "do": "send", "line": "head", "bollard": 9 }),
            "not understood",
        )
        .await;
        refused(&mut master, send("head", "b9"), "that tug only").await;
        refused(&mut observer, send("head", "b9"), "observer").await;
        refused(&mut pilot, plain("part_line", "head"), "only the instructor").await;
        // Out of reach.
        refused(&mut pilot, send("head", "b1"), "a heaving line reaches 30 m").await;
        // Two hands on one line: one sends it, the other is told.
        let (one, two) =
            tokio::join!(pilot.ask(send("head", "b9")), instructor.ask(send("head", "b10")));
        let (first, second, bollard) = match one["type"] == "ack" {
            true => (one, two, "b9"),
            false => (two, one, "b10"),
        };
        assert_eq!(first["type"], "ack", "{first} {second}");
        assert!(reason(&second).contains("on its way to a bollard"), "{second}");
        refused(&mut pilot, send("head", "b8"), "on its way").await;
        refused(&mut pilot, winch("heave", "head", 0.1), "on its way").await;
        refused(&mut pilot, send("fore_breast", bollard), "takes 1 line and already has as many")
            .await;
        until(&mut pilot, "head", "fast").await;
        refused(&mut pilot, send("head", "b8"), "not on board: let it go first").await;
        for rate_mps in [-0.1, 1e9] {
            refused(&mut pilot, winch("heave", "head", rate_mps), "must be between").await;
        }
        // Two hands again: both are obeyed, the later one stays.
        let (one, two) = tokio::join!(
            pilot.ask(winch("heave", "head", 0.1)),
            instructor.ask(winch("pay_out", "head", 0.1))
        );
        assert_eq!((&one["type"], &two["type"]), (&json!("ack"), &json!("ack")));
        let tick = one["tick"].as_u64().max(two["tick"].as_u64()).expect("a tick");
        let frame = pilot.frame_after(tick + 2).await;
        let text = std::fs::read_to_string(server.recording()).expect("a recording");
        let later = match text.rfind("\"do\":\"heave\"") > text.rfind("\"do\":\"pay_out\"") {
            true => "heave",
            false => "pay_out",
        };
        assert_eq!(line(&frame, &pilot.hello, "head")["winch"], later);
        // A line that has parted can be cast off, and that is all.
        accepted(&mut instructor, plain("part_line", "head")).await;
        until(&mut pilot, "head", "parted").await;
        let parted = "line `head` has parted";
        for action in [
            winch("heave", "head", 0.1),
            winch("pay_out", "head", 0.1),
            plain("hold", "head"),
            send("head", "b8"),
        ] {
            refused(&mut pilot, action, parted).await;
        }
        refused(&mut instructor, plain("part_line", "head"), "is not fast").await;
        // A bollard that held a line which has parted is free.
        accepted(&mut pilot, send("fore_breast", bollard)).await;
        // The tug's master works her own line.
        accepted(&mut master, winch("heave", "forward_tow", 0.1)).await;
        refused(&mut master, send("forward_tow", "b9"), "not on board").await;
        // In the past nothing is ordered.
        accepted(&mut instructor, json!({ "do": "rewind", "tick": 1 })).await;
        refused(&mut pilot, send("stern", "b2"), "rewound").await;
        // What was carried out is recorded, in its order, and nothing else.
        let text = std::fs::read_to_string(server.recording()).expect("a recording");
        let count = |what: &str| text.matches(&format!("\"do\":\"{what}\"")).count();
        assert_eq!([count("send"), count("heave"), count("pay_out")], [2, 2, 1], "{text}");
        assert_eq!([count("part_line"), count("hold"), count("let_go")], [1, 0, 0], "{text}");
        server.stop_and_check();
    });
}
