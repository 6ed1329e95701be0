//! The server is killed in the middle of an exercise and started again: links, names, holders, alarms and history are there.

use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tokio::time::sleep;

use super::{block_on, claim, reason, rudder};
use crate::client::Client;
use crate::server::{self, Server};

/// Name of the file of links beside a recording.
fn links_of(server: &Server) -> std::path::PathBuf {
    let name = server.recording().to_string_lossy().replace(".session.jsonl", ".links.json");
    name.into()
}

/// Waits until the file of links has a word; it is written by a thread of its own.
async fn kept(server: &Server, word: &str) {
    let until = Instant::now() + Duration::from_secs(60);
    while !std::fs::read_to_string(links_of(server)).is_ok_and(|text| text.contains(word)) {
        assert!(Instant::now() < until, "no `{word}` in {}", links_of(server).display());
        sleep(Duration::from_millis(20)).await;
    }
}

async fn accepted(client: &mut Client, action: Value) -> Value {
    let answer = client.ask(action.clone()).await;
    assert_eq!(answer["type"], "ack", "{action}: {answer}");
    answer
}

fn holders(hello: &Value) -> Vec<(String, bool)> {
    let claims = hello["claims"].as_array().expect("claims").iter();
    let held = claims.filter(|claim| !claim["holder"].is_null());
    held.map(|claim| {
        let holder = claim["holder"].as_str().expect("a name").to_owned();
        (format!("{}: {holder}", claim["control"]), claim["connected"] == true)
    })
    .collect()
}

/// The past, as a client gets it.
async fn history(client: &mut Client) -> Value {
    client.send(r#"{"type":"command","id":9000,"action":{"do":"history"}}"#).await;
    client.next("history").await
}

#[test]
fn links_names_holders_alarms_and_history_are_there_when_the_server_starts_again() {
    block_on(async {
        let server = Server::start(&[]);
        let links = server.links().clone();
        let mut instructor = Client::join(&server, "instructor").await;
        let mut anna = Client::join(&server, "pilot").await;
        let mut bert = Client::join(&server, "master of aft").await;
        accepted(&mut instructor, json!({ "do": "pace", "pace": 10 })).await;
        accepted(&mut anna, json!({ "do": "name", "name": "Anna" })).await;
        accepted(&mut bert, json!({ "do": "name", "name": "Bert" })).await;
        accepted(&mut anna, claim("ship")).await;
        accepted(&mut anna, rudder(0.2)).await;
        let push = json!({ "do": "tug", "tug": "aft", "order": "push", "power": 0.25 });
        accepted(&mut bert, push).await;
        for (fault, on) in [("rudder_stuck", true), ("engine_lost", true), ("engine_lost", false)] {
            let fault = json!({ "do": "fault", "vessel": "ship", "fault": fault, "on": on });
            let tick = accepted(&mut instructor, fault).await["tick"].as_u64().expect("a tick");
            instructor.frame_after(tick + 2).await;
        }
        accepted(&mut anna, json!({ "do": "acknowledge", "key": "rudder stuck ship" })).await;
        accepted(&mut instructor, json!({ "do": "note", "text": "before the crash" })).await;
        instructor.frame_after(120).await;
        accepted(&mut instructor, json!({ "do": "pause" })).await;
        let before = instructor.ask_and_see(json!({ "do": "single_step" })).await;
        let past = history(&mut anna).await;
        kept(&server, "Bert").await;
        let told = holders(&instructor.hello_with(|hello| holders(hello).len() == 2).await);
        // Killed, not stopped. The last step is behind the last mark: it may be lost, and no more than ten are.
        let server = server.killed_and_started_again(&["--paused"]);
        assert_eq!(*server.links(), links, "the links are those that people have");
        let mut instructor = Client::join(&server, "instructor").await;
        let away: Vec<_> = told.iter().map(|(who, _)| (who.clone(), false)).collect();
        assert_eq!(holders(&instructor.hello), away, "they are not back yet");
        let after = instructor.next("frame").await;
        let (tick, was) = (after["tick"].as_u64(), before["tick"].as_u64());
        assert!(tick <= was && tick.map(|tick| tick + 10) > was, "{tick:?} of {was:?}");
        assert_eq!(after["alarms"], before["alarms"]);
        let texts = after["alarms"].to_string();
        assert!(texts.contains("rudder stuck") && texts.contains("engine lost"), "{texts}");
        // They come back by their links, say their names, and have what they held.
        let mut anna = Client::join(&server, "pilot").await;
        let again = history(&mut anna).await;
        let count = again["t_s"].as_array().expect("times").len();
        assert!(count >= 11, "{count} seconds");
        for column in ["t_s", "ahead_mps", "bow_m", "of_working"] {
            let of = |past: &Value| past[column].as_array().expect("a column")[..count].to_vec();
            assert_eq!(of(&again), of(&past), "{column}");
        }
        assert!(again["events"].to_string().contains("before the crash"));
        accepted(&mut anna, json!({ "do": "name", "name": "Anna" })).await;
        let mut bert = Client::join(&server, "master of aft").await;
        accepted(&mut bert, json!({ "do": "name", "name": "Bert" })).await;
        instructor.hello_with(|hello| holders(hello) == told).await;
        let mut carl = Client::join(&server, "pilot").await;
        assert!(reason(&carl.ask(rudder(0.1)).await).contains("Anna (pilot) holds this control"));
        accepted(&mut anna, rudder(-0.1)).await;
        accepted(&mut instructor, json!({ "do": "resume" })).await;
        instructor.frame_after(tick.unwrap_or(0) + 15).await;
        // Once more, after an orderly change of the holder.
        accepted(&mut anna, json!({ "do": "release", "control": { "vessel": "ship" } })).await;
        accepted(&mut carl, json!({ "do": "name", "name": "Carl" })).await;
        accepted(&mut carl, claim("ship")).await;
        kept(&server, "Carl").await;
        let server = server.killed_and_started_again(&["--paused"]);
        assert_eq!(*server.links(), links);
        let observer = Client::join(&server, "observer").await;
        let held = holders(&observer.hello);
        assert!(held[0].0.contains("Carl (pilot)") && held[1].0.contains("Bert"), "{held:?}");
        server.stop_and_check();
    });
}

#[test]
fn a_new_session_and_one_without_its_file_of_links_have_new_links() {
    block_on(async {
        let one = Server::start(&[]);
        let links = one.links().clone();
        let two = Server::start(&[]);
        assert!(two.links().iter().all(|(role, path)| links[role] != *path));
        two.stop_and_check();
        // Lost, and damaged.
        std::fs::remove_file(links_of(&one)).expect("it was there");
        let one = one.killed_and_started_again(&[]);
        assert!(one.links().iter().all(|(role, path)| links[role] != *path));
        std::fs::write(links_of(&one), "{\"fenderline_links\":1,\"li").expect("written");
        let links = one.links().clone();
        let one = one.killed_and_started_again(&[]);
        assert!(one.links().iter().all(|(role, path)| links[role] != *path));
        // What is told comes by another thread than the links.
        let until = Instant::now() + Duration::from_secs(30);
        while !one.said().contains("everybody gets a new link") {
            assert!(Instant::now() < until, "{}", one.said());
            sleep(Duration::from_millis(20)).await;
        }
        one.stop_and_check();
    });
}

#[test]
fn each_role_gets_the_past_of_its_ship_and_the_instructor_that_of_any() {
    block_on(async {
        let fairway = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../scenarios/live/two_pilots_in_a_fairway.toml");
        let server = Server::start_with(&fairway, &[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut first = Client::join(&server, "pilot").await;
        let mut second = Client::join(&server, "pilot of coaster").await;
        let mut observer = Client::join(&server, "observer").await;
        accepted(&mut instructor, json!({ "do": "pace", "pace": 10 })).await;
        instructor.frame_after(40).await;
        let of = |name: &str| json!({ "do": "history", "vessel": name });
        for (client, ship) in [(&mut first, 0), (&mut second, 1), (&mut observer, 0)] {
            assert_eq!(history(client).await["vessel"], ship);
        }
        for (client, name, why) in [
            (&mut first, "coaster", "not for your link"),
            (&mut second, "bulker", "not for your link"),
            (&mut observer, "coaster", "not for your link"),
            (&mut instructor, "titanic", "no vessel `titanic`"),
        ] {
            assert!(reason(&client.ask(of(name)).await).contains(why), "{name}");
        }
        let command = json!({ "type": "command", "id": 7, "action": of("coaster") });
        instructor.send(&command.to_string()).await;
        let past = instructor.next("history").await;
        assert_eq!(past["vessel"], 1);
        // 8 knots, not the 7 of the other ship.
        let ahead_mps = past["ahead_mps"][0].as_f64().expect("a speed");
        assert!((ahead_mps - 8.0 * 0.5144).abs() < 0.1, "{ahead_mps}");
        server.stop_and_check();
    });
}

#[test]
fn a_file_that_is_no_recording_is_refused_with_the_reason_when_it_is_served() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("no_recordings");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).expect("a folder");
    let served = |name: &str, bytes: &[u8]| {
        let file = folder.join(name);
        std::fs::write(&file, bytes).expect("written");
        let output = crate::support::limited::output(server::program().arg("serve").arg(&file));
        assert_eq!(output.status.code(), Some(2), "{name}");
        String::from_utf8_lossy(&output.stderr).into_owned()
    };
    let header = b"{\"fenderline_session\":3,\"version\":\"0.1";
    for (name, bytes, why) in [
        ("a.session.jsonl", &b""[..], "this is not a recorded session"),
        ("b.session.jsonl", b"title = \"a scenario\"\n", "this is not a recorded session"),
        ("c.session.jsonl", b"\x89PNG\r\n\x1a\n\0\0", "this is not a recorded session"),
        ("d.session.jsonl", header, "cut off within its first line"),
        ("e.session.jsonl", b"{\"fenderline_session\":9,\"version\":\"9\"}\n", "format 9"),
        ("f.toml", b"\x89PNG\r\n\x1a\n\0\0", "f.toml"),
    ] {
        let said = served(name, bytes);
        assert!(said.contains(why) && said.contains(name), "{name}: {said}");
        assert!(!said.contains("panicked"), "{said}");
    }
}
