//! The live server on a machine that runs out: of file descriptors, of room for the recording, of a clock that can be
//! believed.
#![cfg(unix)]

use crate::client;
use crate::server;

use std::fs;
use std::process::Command;
use std::time::Duration;

use client::Client;
use serde_json::{Value, json};
use server::Server;

fn block_on(test: impl Future<Output = ()>) {
    let runtime =
        tokio::runtime::Builder::new_multi_thread().worker_threads(2).enable_all().build();
    runtime.expect("threads").block_on(test);
}

fn rudder(angle_rad: f64) -> Value {
    json!({ "do": "rudder", "vessel": "ship", "angle_rad": angle_rad })
}

#[test]
fn a_server_without_file_descriptors_goes_on_and_accepts_clients_later() {
    block_on(async {
        let server = Server::start_under("ulimit -n 40", &[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let crowd = client::sleepers(&server, 200).await;
        // Who is in stays in, and is answered.
        let before = pilot.next("frame").await["tick"].as_u64().expect("a tick");
        assert_eq!(pilot.ask(rudder(0.2)).await["type"], "ack");
        pilot.frame_after(before + 10).await;
        drop(crowd);
        let mut second = None;
        for _ in 0..100 {
            let page = client::get(&server, "/").await;
            if page.starts_with("HTTP/1.1 200") {
                second = Some(Client::join(&server, "observer").await);
                break;
            }
            tokio::time::sleep(Duration::from_millis(100)).await;
        }
        second.expect("a newcomer gets in").next("frame").await;
        server.stop_and_check();
    });
}

#[test]
fn a_full_disk_ends_the_recording_with_a_notice_and_the_session_goes_on() {
    block_on(async {
        // Files of at most 16 KiB; a write beyond it fails as on a full disk.
        let server = Server::start_under("trap '' XFSZ; ulimit -f 32", &[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut number = 0;
        let mut told = false;
        while !told {
            number += 1;
            assert!(number < 2000, "it is never told");
            let answer = pilot.ask(rudder(0.1 + 1e-4 * f64::from(number))).await;
            assert!(answer["type"] == "ack" || answer["reason"].as_str().is_some(), "{answer}");
            told = pilot.has_heard("NO LONGER RECORDED");
            tokio::time::sleep(Duration::from_millis(20)).await;
        }
        let tick = pilot.next("frame").await["tick"].as_u64().expect("a tick");
        pilot.frame_after(tick + 10).await;
        assert_eq!(pilot.ask(rudder(0.0)).await["type"], "ack");
        let (recording, _) = server.kill();
        let (code, said) = server::replayed(&recording);
        fs::remove_file(&recording).expect("removed");
        // What is there plays to the same bits, and is not called the whole session.
        assert!(said.contains("the same bits"), "{said}");
        assert!(said.contains("its last line is") || code != Some(0), "{code:?}: {said}");
    });
}

/// A clock that jumps by a day or an hour to and fro at each look, as a library that is loaded before the system's.
const LYING_CLOCK: &str = r#"
#define _GNU_SOURCE
#include <time.h>
#include <sys/syscall.h>
#include <unistd.h>
static long looks;
int clock_gettime(clockid_t of, struct timespec *at) {
    long failed = syscall(SYS_clock_gettime, of, at);
    if (failed == 0 && of == CLOCK_REALTIME) {
        long look = __atomic_add_fetch(&looks, 1, __ATOMIC_RELAXED);
        static const long jumps[] = {0, 86400, -86400, 3600, -1000000000, 7000000000L};
        at->tv_sec += jumps[look % 6];
    }
    return (int)failed;
}
"#;

#[test]
#[cfg(target_os = "linux")]
fn a_clock_that_jumps_changes_neither_the_pace_nor_the_bits() {
    let folder = std::env::temp_dir().join(format!("fenderline-clock-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    fs::write(folder.join("clock.c"), LYING_CLOCK).expect("written");
    let mut cc = Command::new("cc");
    cc.args(["-shared", "-fPIC", "-O1", "-o", "clock.so", "clock.c"]).current_dir(&folder);
    let Ok(compiled) = cc.output() else {
        assert!(std::env::var_os("CI").is_none(), "cc is missing in CI");
        println!("skipped: there is no C compiler");
        return;
    };
    assert!(compiled.status.success(), "{}", String::from_utf8_lossy(&compiled.stderr));
    block_on(async {
        let preload = format!("export LD_PRELOAD={}", folder.join("clock.so").display());
        let options = ["--nmea-tcp", "0", "--origin", "35.3,139.7"];
        let server = Server::start_under(&preload, &options);
        let mut pilot = Client::join(&server, "pilot").await;
        let at_ms = |frame: &Value| frame["at_ms"].as_f64().expect("a time");
        let mut frame = pilot.next("frame").await;
        let (first, began) = (frame["tick"].as_u64().expect("a tick"), std::time::Instant::now());
        let mut jumped = false;
        while frame["tick"].as_u64().expect("a tick") < first + 40 {
            assert_eq!(pilot.ask(rudder(0.1)).await["type"], "ack");
            let next = pilot.next("frame").await;
            jumped |= (at_ms(&next) - at_ms(&frame)).abs() > 1e6;
            frame = next;
        }
        assert!(jumped, "the clock did not lie: nothing is tested");
        // Four seconds of wall time, by a clock that does not jump; half of it either way for a busy machine.
        let took = began.elapsed().as_secs_f64();
        assert!((2.0..8.0).contains(&took), "{took} s for 40 ticks of 0.1 s");
        assert!(!client::lines(server.nmea.expect("a port"), 3).await.is_empty());
        server.stop_and_check();
    });
    fs::remove_dir_all(&folder).expect("removed");
}
