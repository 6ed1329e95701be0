//! Controllers that steer by NMEA sentences, and programs that steer by the protocol of the pages: orders, the helm, and
//! everything that such a controller may get wrong.

use std::time::{Duration, Instant};

use serde_json::{Value, json};
use tokio::io::AsyncWriteExt as _;
use tokio::net::TcpStream;
use tokio::task::JoinHandle;
use tokio::time::sleep;

use super::{block_on, claim, reason, rudder};
use crate::client::Client;
use crate::server::{self, Server};

const STEER: &[&str] = &["--nmea-steer", "0"];

/// A sentence with its check sum.
fn sentence(body: &str) -> String {
    let sum = body.bytes().fold(0, |sum, byte| sum ^ byte);
    format!("${body}*{sum:02X}\r\n")
}

fn heading(deg: f64) -> String {
    sentence(&format!("IIHTC,V,,,H,N,,,,,{deg:.1},,,T"))
}

async fn controller(server: &Server) -> TcpStream {
    let at = server.steer.expect("a port for controllers");
    TcpStream::connect(at).await.expect("connected")
}

async fn say(to: &mut TcpStream, text: &str) {
    to.write_all(text.as_bytes()).await.expect("sent");
}

/// Says a text again and again, until the task is aborted.
fn keep_saying(mut to: TcpStream, text: String, every_ms: u64) -> JoinHandle<()> {
    tokio::spawn(async move {
        loop {
            say(&mut to, &text).await;
            sleep(Duration::from_millis(every_ms)).await;
        }
    })
}

/// The first frame whose vessel is as wanted.
async fn vessel_with(client: &mut Client, is_wanted: impl Fn(&Value) -> bool) -> Value {
    for _ in 0..400 {
        let frame = client.next("frame").await;
        if is_wanted(&frame["vessels"][0]) {
            return frame;
        }
    }
    panic!("the order is not carried out")
}

/// The holder of the ship's helm.
fn holder(hello: &Value) -> &str {
    hello["claims"][0]["holder"].as_str().unwrap_or("")
}

fn near(value: &Value, expected: f64) -> bool {
    value.as_f64().is_some_and(|value| (value - expected).abs() < 1e-9)
}

/// Waits until the server has said a text on its standard error.
async fn said(server: &Server, text: &str) -> String {
    for _ in 0..200 {
        let all = server.said();
        if all.contains(text) {
            return all;
        }
        sleep(Duration::from_millis(50)).await;
    }
    panic!("`{text}` was not said: {}", server.said())
}

#[test]
fn each_sentence_of_a_controller_is_an_order_and_the_recording_replays() {
    block_on(async {
        let server = Server::start(STEER);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut by_nmea = controller(&server).await;
        say(&mut by_nmea, &heading(90.0)).await;
        let hello = pilot.hello_with(|hello| holder(hello).starts_with("NMEA controller")).await;
        assert_eq!(hello["claims"][0]["connected"], true);
        assert!(hello["mine"].as_array().expect("a list").iter().all(|of| of["vessel"] != "ship"));
        vessel_with(&mut pilot, |ship| near(&ship["course_rad"], 90_f64.to_radians())).await;
        say(&mut by_nmea, &sentence("IIROR,-10.0,A,,V,B")).await;
        let port = |ship: &Value| near(&ship["rudder"]["order_rad"], -10_f64.to_radians());
        vessel_with(&mut pilot, port).await;
        say(&mut by_nmea, &sentence("IIHTC,V,5.0,R,R,N,,,,,,,,T,C")).await;
        let starboard = |ship: &Value| near(&ship["rudder"]["order_rad"], 5_f64.to_radians());
        vessel_with(&mut pilot, starboard).await;
        say(&mut by_nmea, &sentence("IIPRC,-40.0,A,,,,,B,0")).await;
        vessel_with(&mut pilot, |ship| near(&ship["shaft"]["order"], -0.4)).await;
        say(&mut by_nmea, &sentence("IITRC,1,,V,50.0,P,,B,C")).await;
        vessel_with(&mut pilot, |ship| near(&ship["thrusters"][0]["order"], 0.5)).await;
        say(&mut by_nmea, &sentence("ECAPB,A,A,0.1,R,N,V,V,11.0,T,D,11.0,T,45.0,T")).await;
        vessel_with(&mut pilot, |ship| near(&ship["course_rad"], 45_f64.to_radians())).await;
        // What she does not have is refused, with the names of what she has.
        say(&mut by_nmea, &sentence("IITRC,99,,V,50.0,P,,B,C")).await;
        said(&server, "no thruster 99; her thrusters: 1 is ").await;
        say(&mut by_nmea, &sentence("IIPRC,10,A,,,,,B,2")).await;
        said(&server, "no engine 2").await;
        // By hand: the controller gives the helm back.
        say(&mut by_nmea, &sentence("IIHTC,V,,,M,N,,,,,,,,T")).await;
        pilot.hello_with(|hello| holder(hello).is_empty()).await;
        assert!(server.steer.expect("an address").ip().is_loopback());
        server.stop_and_check();
    });
}

#[test]
fn a_person_takes_the_helm_from_a_controller_in_one_press_and_hands_it_back() {
    block_on(async {
        let server = Server::start(STEER);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        let mut by_nmea = controller(&server).await;
        say(&mut by_nmea, &sentence("IIROR,-10.0,A,,V,B")).await;
        pilot.notice("NMEA controller").await;
        // It does not stop to talk.
        let talking = keep_saying(by_nmea, sentence("IIROR,-10.0,A,,V,B"), 100);
        for (client, other) in [(&mut pilot, "pilot"), (&mut instructor, "instructor")] {
            let refused = client.ask(rudder(0.2)).await;
            assert!(reason(&refused).contains("take the control before"), "{other}: {refused}");
            assert_eq!(client.ask(claim("ship")).await["type"], "ack");
            client.notice("taken the control from a program").await;
            let given = client.ask(rudder(0.2)).await["tick"].as_u64().expect("an ack");
            let frame = client.frame_after(given + 15).await;
            assert!(near(&frame["vessels"][0]["rudder"]["order_rad"], 0.2), "{other}");
            let release = json!({ "do": "release", "control": { "vessel": "ship" } });
            assert_eq!(client.ask(release).await["type"], "ack");
            client.hello_with(|hello| holder(hello).starts_with("NMEA controller")).await;
        }
        // A pilot who takes the helm and goes away does not leave it to a program.
        assert_eq!(pilot.ask(claim("ship")).await["type"], "ack");
        let given = pilot.ask(rudder(0.3)).await["tick"].as_u64().expect("an ack");
        pilot.vanish();
        instructor.notice("has left").await;
        let frame = instructor.frame_after(given + 15).await;
        assert!(near(&frame["vessels"][0]["rudder"]["order_rad"], 0.3));
        talking.abort();
        server.stop_and_check();
    });
}

#[test]
fn a_controller_that_disconnects_or_falls_silent_loses_the_helm_and_its_order_stands() {
    block_on(async {
        let server = Server::start(STEER);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut by_nmea = controller(&server).await;
        let order = sentence("IIROR,-10.0,A,,V,B");
        say(&mut by_nmea, &(order.clone() + &order[..9])).await;
        pilot.hello_with(|hello| holder(hello).starts_with("NMEA controller")).await;
        drop(by_nmea);
        let notice = pilot.notice("has left").await;
        assert!(notice.contains("orders of ship stay as they are"), "{notice}");
        pilot.hello_with(|hello| holder(hello).is_empty()).await;
        let frame = pilot.next("frame").await;
        assert!(near(&frame["vessels"][0]["rudder"]["order_rad"], -10_f64.to_radians()));
        said(&server, "1 without a check sum").await;
        // It stays connected and says nothing that is an order.
        let mut silent = controller(&server).await;
        say(&mut silent, &heading(80.0)).await;
        pilot.hello_with(|hello| holder(hello).starts_with("NMEA controller")).await;
        let since = Instant::now();
        let talking = keep_saying(silent, sentence("GPGLL,4916.45,N,12311.12,W,225444,A"), 200);
        let notice = pilot.notice("is silent").await;
        assert!(notice.contains("orders of ship stay as they are"), "{notice}");
        assert!(since.elapsed() > Duration::from_secs(9), "{:?}", since.elapsed());
        pilot.hello_with(|hello| holder(hello).is_empty()).await;
        let heard = |events: &[String]| events.iter().any(|text| text.contains("is silent"));
        while !heard(&pilot.events) {
            pilot.next("frame").await;
        }
        talking.abort();
        server.stop_and_check();
    });
}

#[test]
fn bad_sentences_are_dropped_and_counted_and_the_helm_stays_safe() {
    block_on(async {
        let server = Server::start(STEER);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut by_nmea = controller(&server).await;
        let good = heading(90.0);
        for bad in [
            good.replace("90.0", "91.0"),
            good.replace("90.0", "9"),
            format!("{}\r\n", &good[..12]),
            format!("{}{good}", &good[..12]),
            "hello\r\n\r\n\n".to_owned(),
            sentence("IIHTC,V,,,H,N,,,,,NaN,,,T"),
            sentence("IIHTC,V,,,H,N,,,,,inf,,,T"),
            sentence("IIHTC,V,,,T,N,,,,,90.0,,90.0,T"),
            sentence("IIROR,1e9,A,,V,B"),
            sentence("IIXYZ,1,2,3"),
            sentence("PFENX,1"),
            sentence("GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W"),
            sentence("IITRC,1,,V,50.0,P,,B,R"),
            format!("{}\r\n", "x".repeat(100_000)),
            sentence(&format!("IIHTC,{}", "9".repeat(300))),
        ] {
            say(&mut by_nmea, &bad).await;
        }
        by_nmea.write_all(b"\xff\xfe\x00\x01\r\n").await.expect("sent");
        let text = said(&server, "2 without a sentence").await;
        for count in [
            "0 orders, 0 refused",
            "2 too long",
            "3 of other kinds",
            "1 without a check sum",
            "3 with a wrong check sum",
            "4 with a field that cannot be obeyed",
            "1 that report and order nothing",
        ] {
            assert!(text.contains(count), "{count}: {text}");
        }
        assert_eq!(pilot.hello["claims"][0]["holder"], Value::Null);
        // The same connection still steers.
        say(&mut by_nmea, &good).await;
        vessel_with(&mut pilot, |ship| near(&ship["course_rad"], 90_f64.to_radians())).await;
        server.stop_and_check();
    });
}

#[test]
fn a_flood_of_sentences_delays_no_tick_and_nobody_else() {
    block_on(async {
        let server = Server::start(STEER);
        let mut pilot = Client::join(&server, "pilot").await;
        pilot.frame_after(5).await;
        let late = |frame: &Value| frame["run"]["late_ticks"].as_u64().expect("a count");
        let before = late(&pilot.next("frame").await);
        let waited = server.thread_times_s("simulation");
        let mut floods = Vec::new();
        // One that talks 1,000 lines a second, and three that send as fast as they can.
        for number in 0..4 {
            let mut by_nmea = controller(&server).await;
            floods.push(tokio::spawn(async move {
                let lines: String = (0..10).map(|deg| heading(f64::from(deg))).collect();
                loop {
                    if by_nmea.write_all(lines.as_bytes()).await.is_err() {
                        return;
                    }
                    if number == 0 {
                        sleep(Duration::from_millis(10)).await;
                    }
                }
            }));
        }
        let end = Instant::now() + Duration::from_secs(4);
        assert_eq!(pilot.ask(claim("ship")).await["type"], "ack");
        let mut worst = Duration::ZERO;
        while Instant::now() < end {
            let asked = Instant::now();
            assert_eq!(pilot.ask(rudder(0.1)).await["type"], "ack");
            worst = worst.max(asked.elapsed());
            sleep(Duration::from_millis(100)).await;
        }
        let frame = pilot.next("frame").await;
        let after = late(&frame);
        assert!(near(&frame["vessels"][0]["rudder"]["order_rad"], 0.1));
        let waits = server.thread_times_s("simulation").zip(waited);
        let waited_s = waits.map(|(now, then)| now[1] - then[1]);
        println!("{} late ticks, slowest answer {worst:?}, waited {waited_s:?} s", after - before);
        assert!(worst < Duration::from_secs(5), "{worst:?}");
        // A tick may be late where others kept the processor from the simulation's thread.
        if waited_s.is_some_and(|waited_s| waited_s < 0.03) {
            assert_eq!(after, before, "late ticks");
        }
        said(&server, "beyond the rate of orders").await;
        let lines = server.said();
        let lines = lines.lines().filter(|line| line.contains("NMEA controller")).count();
        assert!(lines < 80, "{lines} lines of the log");
        floods.iter().for_each(JoinHandle::abort);
        server.stop_and_check();
    });
}

#[test]
fn a_port_for_controllers_is_open_to_others_only_if_the_user_says_so() {
    assert!(server::refused(&["--nmea-steer", "0.0.0.0:0"]).contains("--allow-remote"));
    assert!(server::refused(&["--nmea-steer", "70000"]).contains("--nmea-steer"));
    assert!(server::refused(&["--nmea-steer", "x"]).contains("--nmea-steer"));
}

#[test]
fn people_take_the_helm_from_a_program_of_the_protocol() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut program = Client::join_as_program(&server, "pilot").await;
        let name = json!({ "do": "name", "name": "autopilot" });
        assert_eq!(program.ask(name).await["type"], "ack");
        assert_eq!(program.ask(claim("ship")).await["type"], "ack");
        pilot.hello_with(|hello| holder(hello) == "autopilot (pilot, program)").await;
        // One program does not take it from another.
        let mut other = Client::join_as_program(&server, "pilot").await;
        assert_eq!(other.ask(claim("ship")).await["type"], "refused");
        assert_eq!(pilot.ask(claim("ship")).await["type"], "ack");
        program.notice("has taken the control from you").await;
        assert!(reason(&program.ask(rudder(0.1)).await).contains("holds this control"));
        assert_eq!(program.ask(claim("ship")).await["type"], "refused");
        let release = json!({ "do": "release", "control": { "vessel": "ship" } });
        assert_eq!(pilot.ask(release).await["type"], "ack");
        assert_eq!(program.ask(claim("ship")).await["type"], "ack");
        program.vanish();
        let notice = pilot.notice("autopilot (pilot, program) has left").await;
        assert!(notice.contains("orders of ship stay as they are"), "{notice}");
        pilot.hello_with(|hello| holder(hello).is_empty()).await;
        server.stop_and_check();
    });
}
