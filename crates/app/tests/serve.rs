//! `fenderline serve` over real sockets: roles, claims, what is shown, and everybody who means it ill.

mod alarms;
mod files;
mod ghost;
mod instruments;
mod model;
mod mooring;
mod people;
mod restart;
mod steering;
mod trial;

use crate::client;
use crate::server;

use std::time::Duration;

use client::Client;
use serde_json::{Value, json};
use server::Server;

/// A runtime for a test's own sockets.
fn block_on<T>(test: impl Future<Output = T>) -> T {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    runtime.expect("threads").block_on(test)
}

fn rudder(angle_rad: f64) -> Value {
    json!({ "do": "rudder", "vessel": "ship", "angle_rad": angle_rad })
}

fn claim(vessel: &str) -> Value {
    json!({ "do": "claim", "control": { "vessel": vessel } })
}

/// The reason of a refusal.
fn reason(answer: &Value) -> &str {
    assert_eq!(answer["type"], "refused", "{answer}");
    answer["reason"].as_str().expect("a reason")
}

#[test]
fn each_link_opens_its_role_and_each_role_has_its_own_commands() {
    block_on(async {
        let server = Server::start(&[]);
        let instructor = Client::join(&server, "instructor").await;
        let pilot = Client::join(&server, "pilot").await;
        let master = Client::join(&server, "master of aft").await;
        let observer = Client::join(&server, "observer").await;
        assert_eq!(pilot.hello["role"], json!({ "name": "pilot" }));
        assert_eq!(master.hello["role"], json!({ "name": "tugmaster", "tug": "aft" }));
        assert_eq!(instructor.hello["links"].as_array().map(Vec::len), Some(5));
        assert!(pilot.hello["links"].is_null(), "no role learns another's link");
        let mut clients = [instructor, pilot, master, observer];
        let [instructor, pilot, master, observer] = [0, 1, 2, 3];
        let push = |tug: &str| json!({ "do": "tug", "tug": tug, "order": "push", "power": 0.25 });
        let wind = json!({ "do": "wind", "speed_mps": 9, "from_rad": 1 });
        // What is theirs.
        for (client, action) in [
            (pilot, rudder(0.1)),
            (pilot, push("forward")),
            (master, push("aft")),
            (instructor, wind.clone()),
            (instructor, push("forward")),
            (
                instructor,
                json!({ "do": "fault", "vessel": "ship", "fault": "engine_lost", "on": true }),
            ),
        ] {
            let answer = clients[client].ask(action.clone()).await;
            assert_eq!(answer["type"], "ack", "{action}: {answer}");
        }
        // And what is not.
        for (client, action) in [
            (pilot, wind.clone()),
            (pilot, json!({ "do": "pause" })),
            (pilot, json!({ "do": "load", "file": "harbour.toml" })),
            (master, rudder(0.1)),
            (master, push("forward")),
            (master, claim("ship")),
            (master, wind.clone()),
            (observer, rudder(0.1)),
            (observer, push("aft")),
            (observer, json!({ "do": "let_go", "line": "head" })),
            (observer, json!({ "do": "rewind", "tick": 0 })),
            (observer, claim("ship")),
            // The master has her tug: neither the pilot nor the instructor orders it about.
            (pilot, push("aft")),
            (instructor, push("aft")),
        ] {
            let answer = clients[client].ask(action.clone()).await;
            assert_eq!(answer["type"], "refused", "{action}");
        }
        server.stop_and_check();
    });
}

#[test]
fn two_clients_cannot_hold_one_helm_and_orders_stay_when_a_client_leaves() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut one = Client::join(&server, "pilot").await;
        let mut two = Client::join(&server, "pilot").await;
        assert_eq!(one.ask(claim("ship")).await["type"], "ack");
        assert!(reason(&two.ask(claim("ship")).await).contains("holds this control"));
        assert!(reason(&two.ask(rudder(0.3)).await).contains("holds this control"));
        let ordered = one.ask(rudder(-0.4)).await["tick"].as_u64().expect("an ack");
        assert!(
            reason(&two.ask(json!({ "do": "release", "control": { "vessel": "ship" } })).await)
                .contains("do not hold")
        );
        // The first one vanishes without a word.
        one.vanish();
        let notice = instructor.notice("has left").await;
        assert!(notice.contains("orders of ship stay as they are"), "{notice}");
        let frame = instructor.frame_after(ordered + 1).await;
        assert_eq!(frame["vessels"][0]["rudder"]["order_rad"], -0.4);
        instructor.hello_with(|hello| hello["claims"][0]["connected"] == false).await;
        // Nobody is at it: the other one takes it. The instructor relieves her.
        assert_eq!(two.ask(rudder(0.2)).await["type"], "ack");
        assert_eq!(instructor.ask(claim("ship")).await["type"], "ack");
        two.notice("has taken the control from you").await;
        assert!(reason(&two.ask(rudder(0.1)).await).contains("instructor"));
        server.stop_and_check();
    });
}

#[test]
fn the_instructor_pauses_rewinds_branches_and_loads() {
    block_on(async {
        let server = Server::start(&["--set", "time.step=0.05 s"]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        assert_eq!(instructor.ask(json!({ "do": "pace", "pace": 10 })).await["type"], "ack");
        assert_eq!(pilot.ask(rudder(0.3)).await["type"], "ack");
        instructor.frame_after(100).await;
        assert_eq!(instructor.ask(json!({ "do": "pause" })).await["type"], "ack");
        let paused = instructor.ask_and_see(json!({ "do": "single_step" })).await;
        assert_eq!(paused["run"]["paused"], true);
        let tick = paused["tick"].as_u64().expect("a tick");
        let next = instructor.ask_and_see(json!({ "do": "single_step" })).await;
        assert_eq!(next["tick"], tick + 1);
        let rewound = instructor.ask_and_see(json!({ "do": "rewind", "tick": 20 })).await;
        assert_eq!(
            (&rewound["tick"], &rewound["run"]["last_tick"]),
            (&json!(20), &json!(tick + 1))
        );
        assert!(reason(&pilot.ask(rudder(0.1)).await).contains("rewound"));
        assert!(
            reason(&instructor.ask(json!({ "do": "rewind", "tick": 999_999 })).await)
                .contains("no tick")
        );
        let branched = instructor.ask_and_see(json!({ "do": "branch" })).await;
        assert_eq!(branched["run"]["branches"].as_array().map(Vec::len), Some(2));
        assert_eq!(pilot.ask(rudder(-0.1)).await["type"], "ack");
        instructor.ask(json!({ "do": "resume" })).await;
        instructor.frame_after(60).await;
        let shown = instructor.ask_and_see(json!({ "do": "show_branch", "id": 0 })).await;
        assert_eq!(
            (&shown["tick"], &shown["vessels"][0]["rudder"]["order_rad"]),
            (&json!(tick + 1), &json!(0.3))
        );
        for bad in [
            json!({ "do": "show_branch", "id": 7 }),
            json!({ "do": "pace", "pace": 0 }),
            json!({ "do": "pace", "pace": 1000 }),
            json!({ "do": "load", "file": "../../etc/passwd" }),
            json!({ "do": "save", "name": "../escape" }),
            json!({ "do": "save", "name": "" }),
        ] {
            assert_eq!(instructor.ask(bad.clone()).await["type"], "refused", "{bad}");
        }
        assert_eq!(instructor.ask(json!({ "do": "save", "name": "mine" })).await["type"], "ack");
        let mine = server.sessions().join("mine.session.jsonl");
        let before = std::fs::read(&mine).expect("it is saved");
        let again = instructor.ask(json!({ "do": "save", "name": "mine" })).await;
        assert!(reason(&again).contains("there is a session named mine already"), "{again}");
        assert_eq!(std::fs::read(&mine).expect("it is there"), before, "it is not saved over");
        let loaded = instructor.load("harbour.toml").await;
        assert_eq!((&loaded["tick"], &loaded["run"]["paused"]), (&json!(0), &json!(true)));
        // The saved session goes on where it ended.
        let loaded = instructor.load("mine.session.jsonl").await;
        assert_eq!(loaded["run"]["branches"].as_array().map(Vec::len), Some(2));
        server.stop_and_check();
    });
}

#[test]
fn killing_the_server_loses_nothing_of_the_session() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        for turn in 0..20 {
            let answer = pilot.ask(rudder(0.01 * f64::from(turn))).await;
            assert_eq!(answer["type"], "ack");
        }
        pilot.frame_after(15).await;
        let (file, text) = server.kill();
        assert_eq!(text.matches("\"do\":\"rudder\"").count(), 20);
        // It goes on from there; a torn last line is told and dropped.
        std::fs::write(&file, text.clone() + "{\"line\":\"comm").expect("written");
        assert!(server::replay(&file).contains("the same bits"));
        let again = Server::start_with(&file, &[]);
        let mut pilot = Client::join(&again, "pilot").await;
        let frame = pilot.next("frame").await;
        assert!(frame["tick"].as_u64().is_some_and(|tick| tick >= 10), "{}", frame["tick"]);
        assert_eq!(frame["vessels"][0]["rudder"]["order_rad"], 0.19);
        again.stop_and_check();
    });
}

#[test]
fn wrong_tokens_hosts_and_origins_are_refused() {
    block_on(async {
        let server = Server::start(&[]);
        for token in ["", "?token=", "?token=00000000000000000000000000000000", "?token=x&token=y"]
        {
            let (code, reason) = client::closed(&server, token).await;
            assert_eq!(code, 4401, "{token}: {reason}");
        }
        let good = server.path("pilot").replace("/?", "/live?");
        for (header, value) in [
            ("Origin", "http://evil.example"),
            ("Origin", "null"),
            ("Origin", "http://localhost:1"),
            ("Host", "evil.example"),
        ] {
            let status = client::status(&server, &good, &[(header, value)]).await;
            assert_eq!(status, 403, "{header}: {value}");
        }
        let own = format!("http://127.0.0.1:{}", server.port);
        assert_eq!(client::status(&server, &good, &[("Origin", &own)]).await, 101);
        // The page: its files, their types, its policy; nothing beside them.
        let page = client::get(&server, "/").await;
        assert!(
            page.contains("200 OK") && page.contains("text/html") && page.contains("<p>a page"),
            "{page}"
        );
        assert!(
            page.to_lowercase().contains("content-security-policy: default-src 'none'"),
            "{page}"
        );
        assert!(client::get(&server, "/assets/a.js").await.contains("text/javascript"));
        for path in [
            "/../Cargo.toml",
            "/assets/../../x",
            "/%2e%2e/%2e%2e/etc/passwd",
            "//etc/passwd",
            "/assets",
        ] {
            assert!(client::get(&server, path).await.contains("404"), "{path}");
        }
        let answer = client::raw(&server, b"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n").await;
        assert!(answer.contains("403"), "{answer}");
        server.stop_and_check();
    });
}

#[test]
fn other_addresses_need_a_flag() {
    let refused = server::refused(&["--bind", "0.0.0.0", "--port", "0"]);
    assert!(refused.contains("--allow-remote"), "{refused}");
}

#[test]
fn bad_messages_are_refused_with_a_reason_and_change_nothing() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        for (text, told) in [
            ("", "not understood"),
            ("{", "not understood"),
            ("[1,2,3]", "not understood"),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"ship","share":1e999}}"#,
                "out of range",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"ship","share":NaN}}"#,
                "not understood",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"ship","share":1e300}}"#,
                "must be between -1 and 1",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"engine","vessel":"titanic","share":1}}"#,
                "no vessel",
            ),
            (
                r#"{"type":"command","id":1,"action":{"do":"tug","tug":"aft","order":"push"}}"#,
                "needs",
            ),
            (r#"{"type":"command","id":1,"action":{"do":"fly"}}"#, "unknown variant"),
            (
                r#"{"type":"command","id":1,"action":{"do":"hands","vessel":"ship","admin":true}}"#,
                "unknown field",
            ),
            (r#"{"type":"hello"}"#, "unknown variant"),
        ] {
            pilot.send(text).await;
            println!("sent: {text}");
            let answer = pilot.refusal().await;
            assert!(reason(&answer).contains(told), "{text}: {answer}");
        }
        pilot.send_bytes(vec![0, 159, 146, 150]).await;
        assert!(reason(&pilot.next("refused").await).contains("text"));
        let frame = pilot.next("frame").await;
        let order = frame["vessels"][0]["shaft"]["order"].as_f64().expect("a number");
        assert!(order.abs() <= 1.0, "{order}");
        assert_eq!(pilot.ask(rudder(0.1)).await["type"], "ack");
        server.stop_and_check();
    });
}

#[test]
fn floods_large_messages_and_idle_connections_are_ended_and_the_simulation_keeps_its_pace() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let before = pilot.next("frame").await;
        // 100 MB in one frame: the connection ends when its head is read.
        client::giant(&server, &server.path("observer").replace("/?", "/live?")).await;
        // A flood of commands, good and bad ones, from a link that opens something.
        let flooded = client::flood(&server, "observer", 5000).await;
        assert!(flooded, "who does not stop is shown the door");
        // Heads that never end, and connections that say nothing.
        let sleepers = client::sleepers(&server, 30).await;
        assert_eq!(pilot.ask(rudder(0.2)).await["type"], "ack");
        let first = before["tick"].as_u64().expect("a tick");
        let frame = pilot.frame_after(first + 30).await;
        // By the server's clock: as many ticks as there were steps, to half a second. That none is late at all is
        // measured by `cargo xtask live-load`, where no other test takes the processor.
        let number = |frame: &Value, key: &str| frame[key].as_f64().expect("a number");
        let wall_s = 1e-3 * (number(&frame, "at_ms") - number(&before, "at_ms"));
        let simulated_s = number(&frame, "t_s") - number(&before, "t_s");
        assert!((wall_s - simulated_s).abs() < 0.5, "{simulated_s} s in {wall_s} s");
        assert!(
            sleepers.ended_within(Duration::from_secs(20)).await,
            "half-open connections are closed"
        );
        server.stop_and_check();
    });
}

#[test]
fn three_hundred_slow_requests_do_not_keep_a_new_client_out() {
    block_on(async {
        let server = Server::start(&[]);
        let sleepers = client::sleepers(&server, 300).await;
        let began = std::time::Instant::now();
        let page = client::get(&server, "/").await;
        assert!(page.starts_with("HTTP/1.1 200"), "{page}");
        let mut pilot = Client::join(&server, "pilot").await;
        assert_eq!(pilot.ask(rudder(0.2)).await["type"], "ack");
        // The heads' own time is five seconds: this did not wait for it.
        assert!(began.elapsed() < Duration::from_secs(4), "{:?}", began.elapsed());
        drop(sleepers);
        server.stop_and_check();
    });
}

#[test]
fn observers_that_come_and_go_do_not_flood_the_others_with_frames_and_notices() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        // No ticks, so that every frame is one of the crowd, or one a second.
        assert_eq!(instructor.ask(json!({ "do": "pause" })).await["type"], "ack");
        let began = std::time::Instant::now();
        for _ in 0..60 {
            let mut observer = Client::join(&server, "observer").await;
            let first = observer.next("frame").await;
            assert_eq!(first["run"]["paused"], true, "{first}");
            observer.vanish();
        }
        instructor.send(r#"{"type":"command","id":7777,"action":{"do":"pace","pace":1}}"#).await;
        let (mut frames, mut notices) = (0_u32, 0_u32);
        loop {
            let message = instructor.any().await;
            frames += u32::from(message["type"] == "frame");
            notices += u32::from(message["type"] == "notice");
            if message["type"] == "ack" && message["id"] == 7777 {
                break;
            }
        }
        // A frame each tenth of a second, ten notices at once and one a second, and a few of its own.
        let seconds = began.elapsed().as_secs_f64();
        assert!(f64::from(frames) < 10.0 * seconds + 5.0, "{frames} frames in {seconds} s");
        assert!(f64::from(notices) < 12.0 + seconds, "{notices} notices in {seconds} s");
        server.stop_and_check();
    });
}

#[test]
fn many_chart_programs_do_not_keep_another_one_out() {
    block_on(async {
        let server = Server::start(&["--nmea-tcp", "0", "--origin", "35.3,139.7"]);
        let at = server.nmea.expect("a port for chart programs");
        let mut crowd = Vec::new();
        for _ in 0..60 {
            crowd.push(tokio::net::TcpStream::connect(at).await.expect("connected"));
        }
        assert!(!client::lines(at, 1).await.is_empty());
        drop(crowd);
        server.stop_and_check();
    });
}

#[test]
fn errors_are_plain_text_that_no_browser_interprets() {
    block_on(async {
        let server = Server::start(&[]);
        let request = |head: &str| format!("{head} HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n");
        for (head, status) in [("GET /none", "404"), ("POST /", "405")] {
            let answer = client::raw(&server, request(head).as_bytes()).await.to_lowercase();
            assert!(answer.starts_with(&format!("http/1.1 {status}")), "{answer}");
            assert!(answer.contains("x-content-type-options: nosniff"), "{answer}");
        }
        let stranger = b"GET / HTTP/1.1\r\nHost: evil.example\r\n\r\n";
        let answer = client::raw(&server, stranger).await.to_lowercase();
        assert!(answer.starts_with("http/1.1 403") && answer.contains("nosniff"), "{answer}");
        server.stop_and_check();
    });
}

#[test]
fn an_alarm_is_acknowledged_for_all_clients_and_not_by_observers() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut instructor = Client::join(&server, "instructor").await;
        let mut observer = Client::join(&server, "observer").await;
        let fault = json!({ "do": "fault", "vessel": "ship", "fault": "rudder_stuck", "on": true });
        assert_eq!(instructor.ask(fault.clone()).await["type"], "ack");
        let stuck = |frame: &Value| {
            let all = frame["alarms"].as_array().expect("alarms").clone();
            all.into_iter().find(|alarm| alarm["key"] == "rudder stuck ship")
        };
        let mut alarm = None;
        while alarm.is_none() {
            alarm = stuck(&pilot.next("frame").await);
        }
        let acknowledge = json!({ "do": "acknowledge", "key": "rudder stuck ship" });
        assert!(reason(&observer.ask(acknowledge.clone()).await).contains("observer"));
        // Repaired before anybody has acknowledged it: it stays.
        let mut repaired = fault;
        repaired["on"] = json!(false);
        assert_eq!(instructor.ask(repaired).await["type"], "ack");
        let mut alarm = alarm.expect("an alarm");
        while alarm["stands"] == true {
            alarm = stuck(&pilot.next("frame").await).expect("it waits to be acknowledged");
        }
        assert_eq!(pilot.ask(acknowledge.clone()).await["type"], "ack");
        while stuck(&observer.next("frame").await).is_some() {}
        assert!(reason(&pilot.ask(acknowledge).await).contains("no such alarm"));
        server.stop_and_check();
    });
}

#[cfg(unix)]
#[test]
fn the_report_from_the_page_is_that_of_the_command_and_only_the_instructor_gets_it() {
    block_on(async {
        let server = Server::start(&["--paused"]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        let report = json!({ "do": "report" });
        assert!(reason(&pilot.ask(report.clone()).await).contains("only the instructor"));
        assert!(reason(&instructor.ask(report.clone()).await).contains("nothing is recorded yet"));
        let address = |role: &str| {
            let path = server.path(role);
            format!("/report?token={}", path.split_once("token=").expect("a token").1)
        };
        let (master, observer) = (address("master of aft"), address("observer"));
        let [own, pilots] = [address("instructor"), address("pilot")];
        assert!(client::get(&server, &own).await.starts_with("HTTP/1.1 404"));
        assert_eq!(instructor.ask(json!({ "do": "resume" })).await["type"], "ack");
        assert_eq!(pilot.ask(rudder(0.2)).await["type"], "ack");
        let note = json!({ "do": "note", "text": "well begun" });
        assert_eq!(instructor.ask(note).await["type"], "ack");
        let tick = pilot.next("frame").await["tick"].as_u64().expect("a tick");
        pilot.frame_after(tick + 30).await;
        // While the ship goes on.
        assert_eq!(instructor.ask(report.clone()).await["type"], "ack");
        assert!(client::get(&server, &own).await.contains("well begun"));
        assert_eq!(instructor.ask(json!({ "do": "pause" })).await["type"], "ack");
        assert_eq!(instructor.ask(report).await["type"], "ack");
        for other in [&pilots, &master, &observer] {
            let answer = client::get(&server, other).await;
            assert!(answer.starts_with("HTTP/1.1 403") && !answer.contains("well begun"));
        }
        let answer = client::get(&server, &own).await;
        let (head, page) = answer.split_once("\r\n\r\n").expect("a head");
        assert!(head.contains("default-src 'none'") && head.contains("no-store"), "{head}");
        let (recording, _) = server.interrupt();
        // Under the name that it had.
        let folder = recording.with_extension("report");
        std::fs::create_dir_all(&folder).expect("a folder");
        let named = folder.join("harbour-001.session.jsonl");
        std::fs::copy(&recording, &named).expect("a copy");
        let html = folder.join("report.html");
        let ran = server::program()
            .args(["report", "--allow-failures", "--html"])
            .args([&html, &named])
            .output()
            .expect("it runs");
        assert!(ran.status.success(), "{ran:?}");
        let same = std::fs::read_to_string(&html).expect("a report");
        assert!(page == same, "{} and {} bytes", page.len(), same.len());
    });
}

#[test]
fn acknowledgements_and_notes_are_there_again_when_the_server_starts_again() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        for fault in ["rudder_stuck", "thrusters_lost"] {
            let fault = json!({ "do": "fault", "vessel": "ship", "fault": fault, "on": true });
            assert_eq!(instructor.ask(fault).await["type"], "ack");
        }
        let acknowledged = |frame: &Value| -> Vec<(String, bool)> {
            let all = frame["alarms"].as_array().expect("alarms").iter();
            let pair = |alarm: &Value| {
                (alarm["key"].as_str().expect("a key").to_owned(), alarm["acknowledged"] == true)
            };
            let is_fault = |(key, _): &(String, bool)| {
                key.starts_with("rudder") || key.starts_with("thrusters")
            };
            all.map(pair).filter(is_fault).collect()
        };
        let both = |seen: bool| {
            vec![("rudder stuck ship".to_owned(), seen), ("thrusters lost ship".to_owned(), false)]
        };
        while acknowledged(&pilot.next("frame").await) != both(false) {}
        let ack = json!({ "do": "acknowledge", "key": "rudder stuck ship" });
        assert_eq!(pilot.ask(ack).await["type"], "ack");
        let note = json!({ "do": "note", "text": "rudder seen" });
        assert!(reason(&pilot.ask(note.clone()).await).contains("only the instructor"));
        assert_eq!(instructor.ask(note).await["type"], "ack");
        assert_eq!(instructor.ask(json!({ "do": "note" })).await["type"], "ack");
        let long = json!({ "do": "note", "text": "x".repeat(301) });
        assert!(reason(&instructor.ask(long).await).contains("300 characters"));
        let tick = pilot.next("frame").await["tick"].as_u64().expect("a tick");
        pilot.frame_after(tick + 10).await;
        let (recording, _) = server.kill();
        let text = std::fs::read_to_string(&recording).expect("a recording");
        for words in [r#""do":"note","text":"rudder seen""#, r#"{"do":"note"}"#] {
            assert!(text.contains(words), "{words} in {text}");
        }
        let again = Server::start_with(&recording, &["--paused"]);
        let mut observer = Client::join(&again, "observer").await;
        assert_eq!(acknowledged(&observer.next("frame").await), both(true));
        again.stop_and_check();
    });
}

#[test]
fn a_silent_client_is_disconnected() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let silent = client::half_open(&server, "pilot").await;
        instructor.notice("pilot").await;
        let notice = instructor.notice("has left").await;
        assert!(notice.contains("pilot"), "{notice}");
        drop(silent);
        server.stop_and_check();
    });
}

#[test]
fn a_page_that_reads_slowly_gets_the_latest_frame_and_all_events() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut slow = Client::join(&server, "observer").await;
        instructor.ask(json!({ "do": "pace", "pace": 20 })).await;
        instructor.ask(rudder(0.1)).await;
        instructor.frame_after(400).await;
        instructor.ask(json!({ "do": "pause" })).await;
        // It slept all the while: what waits for it is bounded, and its last frame is the latest.
        let paused = instructor.next("frame").await["tick"].as_u64().expect("a tick");
        let frame = slow.frame_after(paused).await;
        assert_eq!(frame["tick"], paused);
        assert!(
            slow.events.iter().any(|text| text.contains("under manual control")),
            "{:?}",
            slow.events
        );
        server.stop_and_check();
    });
}

/// What kinds of sentences are in a text; every sum is right.
fn kinds(text: &str) -> Vec<String> {
    let mut kinds = Vec::new();
    for line in text.lines() {
        let (body, sum) = line[1..].split_once('*').expect("a sum");
        let ours = body.bytes().fold(0, |sum, byte| sum ^ byte);
        assert_eq!(u8::from_str_radix(sum, 16), Ok(ours), "{line}");
        assert!(line.len() <= 80, "{line}");
        kinds.push(body.split(',').next().expect("a kind")[2..].to_owned());
    }
    kinds.sort();
    kinds.dedup();
    kinds
}

#[test]
fn a_chart_program_gets_sentences_over_tcp_and_udp() {
    block_on(async {
        let udp = tokio::net::UdpSocket::bind("127.0.0.1:0").await.expect("a port");
        let to = udp.local_addr().expect("an address").to_string();
        let server =
            Server::start(&["--nmea-tcp", "0", "--nmea-udp", &to, "--origin", "35.3,139.7"]);
        let text = client::lines(server.nmea.expect("a port for chart programs"), 30).await;
        // No depth yet: nobody has come, and the simulation has not taken its first step.
        let wanted = ["HDT", "MWV", "RMC", "ROT", "RPM", "RSA", "VBW", "VDO", "VTG"];
        assert_eq!(kinds(&text), wanted, "{text}");
        // The ship lies 700 m south and 60 m west of the origin.
        assert!(text.contains(",3517.6") && text.contains(",N,13941.9"), "{text}");
        let mut datagram = [0; 200];
        let length = udp.recv(&mut datagram).await.expect("a datagram");
        let text = String::from_utf8_lossy(&datagram[..length]).into_owned();
        assert!(text.ends_with("\r\n") && kinds(&text).len() == 1, "{text}");
        server.stop_and_check();
        for bad in ["91,0", "x", "0", "0,200"] {
            assert!(server::refused(&["--origin", bad]).contains("--origin"), "{bad}");
        }
        assert!(server::refused(&["--nmea-udp", "192.0.2.1:10110"]).contains("--allow-remote"));
    });
}

/// Latitude and longitude of the first RMC sentence (minutes of arc).
fn fix_min(text: &str) -> [f64; 2] {
    let line = text.lines().find(|line| line.contains("RMC")).expect("an RMC sentence");
    let cells: Vec<&str> = line.split(',').collect();
    let minutes = |cell: &str, degrees: usize| {
        let (whole, rest) = cell.split_at(degrees);
        60.0 * whole.parse::<f64>().expect("degrees") + rest.parse::<f64>().expect("minutes")
    };
    assert_eq!((cells[4], cells[6]), ("N", "E"), "{line}");
    [minutes(cells[3], 2), minutes(cells[5], 3)]
}

/// The harbour is drawn from GeoJSON in longitude and latitude: her place on a chart is that of the harbour, and with `--origin` that of
/// the given origin, while the harbour stays drawn where it is. The ship lies 551.8 m south and 296.6 m west of the origin.
#[test]
fn chart_programs_get_the_origin_of_a_geojson_chart_and_that_of_the_option_in_its_place() {
    block_on(async {
        let harbour = std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
            .join("../../scenarios/live/harbour.toml");
        for (options, [latitude_deg, longitude_deg]) in [
            (&["--nmea-tcp", "0"][..], [54.02, 8.02]),
            (&["--nmea-tcp", "0", "--origin", "35.3,139.7"][..], [35.3_f64, 139.7]),
        ] {
            let server = Server::start_with(&harbour, options);
            let text = client::lines(server.nmea.expect("a port for chart programs"), 30).await;
            let [north_min, east_min] = fix_min(&text);
            // A sea mile is a minute of latitude on the sphere that the sentences use to within 0.5 %; 4 m is more than that of
            // 552 m, and what the four digits of a minute leave.
            let north_m = (north_min - 60.0 * latitude_deg) * 1852.0;
            let parallel_m = 1852.0 * libm::cos(latitude_deg.to_radians());
            let east_m = (east_min - 60.0 * longitude_deg) * parallel_m;
            assert!((north_m + 551.8).abs() < 4.0, "{north_m} {text}");
            assert!((east_m + 296.6).abs() < 4.0, "{east_m} {text}");
            let observer = Client::join(&server, "observer").await;
            let drawn = observer.hello["chart"].as_array().map_or(0, Vec::len);
            assert!(drawn > 5, "the chart is drawn with both: {drawn}");
            server.stop_and_check();
        }
    });
}
