//! `fenderline replay` and `fenderline serve` with recordings that are large, long, damaged or absurd, and with files
//! that would stop a program.

use crate::client;
use crate::damage;
use crate::server;

use std::fs;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use client::Client;
use damage::{damaged, forged, objects, sealed};
use fenderline_live::{NamedOrder, Session, Source};
use fenderline_sim::OrderName;
use serde_json::json;
use server::{Server, replayed};

/// What a damaged recording may take at most until it is refused.
const LONGEST: Duration = Duration::from_secs(10);

/// Eleven hours of the harbour: seconds to play, be the machine fast or slow.
const LONG_TICKS: u64 = 400_000;

fn block_on(test: impl Future<Output = ()>) {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    runtime.expect("threads").block_on(test);
}

/// An empty folder for a test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder");
    folder
}

fn harbour() -> Session {
    let text = fs::read_to_string(server::scenario()).expect("a scenario");
    let none = |name: &str| Err(format!("{name}: none is needed"));
    let (source, _) = Source::collect("harbour.toml", text, vec![], none).expect("a scenario");
    Session::open(source).expect("a set-up")
}

/// A recording of so many ticks with commands every other second.
fn recording(ticks: u64) -> String {
    let mut session = harbour();
    let mut text = String::new();
    for tick in 0..ticks {
        if tick.is_multiple_of(20) {
            let angle_rad = if tick.is_multiple_of(40) { 0.1 } else { -0.1 };
            let rudder =
                NamedOrder::new(OrderName::Rudder, "ship").number("angle", angle_rad).into();
            session.command("pilot 1", 1_790_000_000_000 + tick, rudder).expect("a good command");
        }
        session.step().expect("a good step");
        text += &session.take_lines();
    }
    session.mark();
    text + &session.take_lines() + &session.end_line()
}

/// A recording with one line after the first.
fn with_line(line: &str) -> String {
    let header = objects(&harbour().take_lines()).remove(0);
    sealed([header.as_str(), line])
}

const FAR: &str =
    r#"{"line":"reached","branch":0,"tick":1000000000000000000,"bits":"0000000000000000"}"#;

#[cfg(unix)]
fn pipe(path: &Path) {
    let made = std::process::Command::new("mkfifo").arg(path).status().expect("mkfifo");
    assert!(made.success());
}

#[cfg(unix)]
#[test]
fn a_pipe_in_the_gallerys_folder_does_not_freeze_the_server() {
    block_on(async {
        let gallery = folder("gallery_with_pipes");
        pipe(&gallery.join("a.toml"));
        pipe(&gallery.join("b.session.jsonl"));
        let scene = gallery.join("c.toml");
        fs::copy(server::scenario(), &scene).expect("copied");
        let server = Server::start(&["--gallery", gallery.to_str().expect("a name")]);
        let mut instructor = Client::join(&server, "instructor").await;
        let told = instructor.hello["gallery"].to_string();
        assert!(told.contains("c.toml") && !told.contains("a.toml"), "{told}");
        // And one that takes a scenario's place when it is in the gallery already.
        fs::remove_file(&scene).expect("removed");
        pipe(&scene);
        let answer = instructor.ask(json!({ "do": "load", "file": "c.toml" })).await;
        assert_eq!(answer["type"], "ack");
        let refused = instructor.next("refused").await;
        let reason = refused["reason"].as_str().expect("a reason");
        assert!(refused["id"].is_null() && reason.contains("it is a pipe"), "{refused}");
        let tick = instructor.next("frame").await["tick"].as_u64().expect("a tick");
        instructor.frame_after(tick + 5).await;
        let (code, said) = replayed(&scene);
        assert!(code == Some(2) && said.contains("it is a pipe"), "{said}");
        server.stop_and_check();
    });
}

#[test]
fn a_recording_with_a_far_tick_does_not_freeze_the_server() {
    block_on(async {
        let gallery = folder("gallery_with_a_far_tick");
        let far = gallery.join("far.session.jsonl");
        fs::write(&far, with_line(FAR)).expect("written");
        let server = Server::start(&["--gallery", gallery.to_str().expect("a name")]);
        let mut instructor = Client::join(&server, "instructor").await;
        assert_eq!(
            instructor.ask(json!({ "do": "load", "file": "far.session.jsonl" })).await["type"],
            "ack"
        );
        let refused = instructor.next("refused").await.to_string();
        assert!(refused.contains("line 2: the line is invalid"), "{refused}");
        let tick = instructor.next("frame").await["tick"].as_u64().expect("a tick");
        instructor.frame_after(tick + 5).await;
        let (code, said) = replayed(&far);
        assert!(code == Some(2) && said.contains("from tick 0 to 1000000000000000000"), "{said}");
        server.stop_and_check();
    });
}

#[test]
fn the_simulation_goes_on_while_a_long_recording_is_opened_and_its_progress_is_shown() {
    block_on(async {
        let gallery = folder("gallery_with_a_long_session");
        fs::write(gallery.join("long.session.jsonl"), recording(LONG_TICKS)).expect("written");
        let server = Server::start(&["--gallery", gallery.to_str().expect("a name")]);
        let mut instructor = Client::join(&server, "instructor").await;
        let load = json!({ "do": "load", "file": "long.session.jsonl" });
        assert_eq!(instructor.ask(load.clone()).await["type"], "ack");
        let answer = instructor.ask(load.clone()).await.to_string();
        assert!(answer.contains("is still being opened"), "{answer}");
        // The session that is shown goes on, tick by tick.
        let (mut shares, mut ticks) = (vec![], vec![]);
        while shares.len() < 3 {
            let frame = instructor.next("frame").await;
            let opening = &frame["run"]["opening"];
            assert_eq!(opening["file"], "long.session.jsonl", "it is there already: {shares:?}");
            if opening["at"] == "plays" {
                shares.push(opening["share"].as_f64().expect("a number"));
            }
            ticks.push(frame["tick"].as_u64().expect("a tick"));
        }
        assert!(shares.is_sorted() && shares[0] < shares[2], "{shares:?}");
        assert!(ticks.is_sorted() && ticks[0] < ticks[ticks.len() - 1], "{ticks:?}");
        assert_eq!(instructor.ask(json!({ "do": "stop_opening" })).await["type"], "ack");
        let refused = instructor.next("refused").await.to_string();
        assert!(refused.contains("stopped"), "{refused}");
        let answer = instructor.ask(json!({ "do": "stop_opening" })).await;
        assert_eq!(answer["type"], "refused");
        assert_eq!(server.recordings().len(), 1, "what was stopped leaves no recording");
        let loaded = instructor.load("long.session.jsonl").await;
        assert_eq!((&loaded["tick"], &loaded["run"]["paused"]), (&json!(LONG_TICKS), &json!(true)));
        assert!(loaded["run"]["opening"].is_null());
        server.stop_and_check();
    });
}

#[test]
fn a_session_of_more_than_16_mib_is_replayed_and_continued() {
    block_on(async {
        // Four hands for fifteen minutes, at the thirty commands a second that the server permits.
        let mut session = harbour();
        let mut text = String::new();
        for tick in 0..9000_u32 {
            for hand in 0..12 {
                let angle_rad = 1e-6 * f64::from((tick * 12 + hand) % 100_003);
                let rudder =
                    NamedOrder::new(OrderName::Rudder, "ship").number("angle", angle_rad).into();
                let who = format!("the hand of the pilot {}", hand % 4);
                session.command(&who, 1_790_000_000_000, rudder).expect("a good command");
            }
            session.step().expect("a good step");
            text += &session.take_lines();
        }
        session.mark();
        text += &(session.take_lines() + &session.end_line());
        assert!(text.len() > 16 << 20, "{} bytes", text.len());
        let file = folder("a_large_session").join("large.session.jsonl");
        fs::write(&file, &text).expect("written");
        let (code, said) = replayed(&file);
        assert!(code == Some(0) && said.contains("whole; the same bits"), "{said}");
        let server = Server::start_with(&file, &[]);
        let mut instructor = Client::join(&server, "instructor").await;
        instructor.frame_after(9005).await;
        assert_eq!(instructor.ask(json!({ "do": "save", "name": "more" })).await["type"], "ack");
        let (code, said) = replayed(&server.sessions().join("more.session.jsonl"));
        assert!(code == Some(0) && said.contains("whole; the same bits"), "{said}");
        server.stop_and_check();
    });
}

#[test]
fn an_interrupted_server_ends_its_recording_and_a_killed_one_does_not() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        pilot.frame_after(15).await;
        let (file, text) = server.kill();
        let (code, said) = replayed(&file);
        assert!(code == Some(0) && said.contains("its last line is missing"), "{said}");
        assert!(said.contains("without its end; the same bits"), "{said}");
        fs::write(&file, &text[..text.len() - 20]).expect("written");
        let (code, said) = replayed(&file);
        assert!(code == Some(0) && said.contains("its last line is incomplete"), "{said}");
        #[cfg(unix)]
        {
            let server = Server::start(&[]);
            let mut pilot = Client::join(&server, "pilot").await;
            pilot.frame_after(15).await;
            let (file, _) = server.interrupt();
            let (code, said) = replayed(&file);
            assert!(code == Some(0) && said.contains("whole; the same bits"), "{said}");
        }
    });
}

/// The program waits to say its last line to somebody who does not listen.
#[cfg(unix)]
#[test]
fn a_second_ctrl_c_ends_the_program_whatever_it_waits_for() {
    use std::io::{BufRead as _, BufReader, Write as _};
    use std::process::{Command, Stdio};

    let folder = folder("second_interrupt");
    fs::create_dir_all(folder.join("page")).expect("a folder");
    fs::write(folder.join("page/index.html"), "<p>a page").expect("written");
    let (reader, mut writer) = std::io::pipe().expect("a pipe");
    let mut child = server::program()
        .arg("serve")
        .arg(server::scenario())
        .args(["--port", "0", "--page"])
        .arg(folder.join("page"))
        .arg("--sessions")
        .arg(folder.join("sessions"))
        .stdout(writer.try_clone().expect("a second end"))
        .stderr(Stdio::null())
        .spawn()
        .expect("it starts");
    let (send, greeted) = std::sync::mpsc::channel();
    std::thread::spawn(move || {
        let mut lines = BufReader::new(reader);
        let mut line = String::new();
        while !line.contains("Recorded to") {
            line.clear();
            assert!(lines.read_line(&mut line).expect("a line") > 0, "it has ended");
        }
        send.send(lines)
    });
    // Kept open and not read any more.
    let _reader = greeted.recv_timeout(crate::support::limited::LIMIT).expect("the greeting comes");
    let id = child.id().to_string();
    let interrupt = || {
        assert!(Command::new("kill").args(["-INT", &id]).status().expect("kill").success());
    };
    // Nothing more fits into the pipe.
    std::thread::spawn(move || writer.write_all(&vec![b' '; 1 << 22]));
    std::thread::sleep(Duration::from_millis(500));
    interrupt();
    std::thread::sleep(Duration::from_secs(1));
    assert!(child.try_wait().expect("its state").is_none(), "it waits");
    interrupt();
    let until = Instant::now() + LONGEST;
    let status = loop {
        if let Some(status) = child.try_wait().expect("its state") {
            break status;
        }
        if Instant::now() > until {
            let _ = child.kill();
            panic!("it still waits");
        }
        std::thread::sleep(Duration::from_millis(20));
    };
    assert_eq!(status.code(), Some(130));
}

/// `FENDERLINE_DAMAGED_FILES=1000 cargo test -p fenderline --test all recordings::damaged` for all of them.
#[test]
fn damaged_recordings_are_never_reported_as_whole_and_never_take_long() {
    let parameter = |name: &str, default: u64| {
        let text = std::env::var(name);
        text.map_or(default, |text| text.parse().unwrap_or_else(|e| panic!("{name}={text}: {e}")))
    };
    let (count, first) =
        (parameter("FENDERLINE_DAMAGED_FILES", 60), parameter("FENDERLINE_SEED", 1));
    let sound = recording(300);
    let file = folder("damaged").join("damaged.session.jsonl");
    let (mut refused, mut cut, mut absurd) = (0, 0, 0);
    let mut slowest = Duration::ZERO;
    let mut replay = |bytes: &[u8]| {
        fs::write(&file, bytes).expect("written");
        let start = Instant::now();
        let (code, said) = replayed(&file);
        slowest = slowest.max(start.elapsed());
        (code, said)
    };
    for seed in first..first + count {
        let (what, bytes) = damaged(sound.as_bytes(), seed);
        match replay(&bytes) {
            (Some(2), _) => refused += 1,
            (Some(0), said) if said.contains("without its end; the same bits") => cut += 1,
            other => panic!("seed {seed}, {what}: {other:?}"),
        }
        let (code, said) = replay(forged(&sound, seed).as_bytes());
        assert!(matches!(code, Some(0..=2)), "seed {seed}: {said}");
        absurd += u64::from(code != Some(0));
    }
    println!(
        "{count} damaged from seed {first}: {refused} refused, {cut} told as cut off or torn; \
         of as many forged {absurd} refused; the slowest took {slowest:?}"
    );
    assert!(slowest < LONGEST, "{slowest:?}");
}
