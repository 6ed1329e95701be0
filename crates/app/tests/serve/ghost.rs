//! A measured ship beside the simulated ones: in the greeting, in the recording, and what cannot be shown.

use super::block_on;
use crate::client::Client;
use crate::server::{self, Server};

fn example(name: &str) -> String {
    format!("{}/../../examples/measured/{name}", env!("CARGO_MANIFEST_DIR"))
}

#[test]
fn a_measured_track_is_in_the_greeting_and_stays_in_the_recording() {
    let [log, mapping] = ["laser.csv", "laser.toml"].map(example);
    let options = ["--ghost", &log, "--ghost-mapping", &mapping, "--ghost-touch", "100"];
    let server = Server::start(&options);
    let ghost = block_on(async { Client::join(&server, "observer").await.hello["ghost"].clone() });
    assert_eq!(ghost["file"], "laser.csv");
    assert!((ghost["touch_s"].as_f64().expect("a touch") - 100.0).abs() < 1e-6, "{ghost}");
    let points = ghost["points"].as_array().expect("a track");
    assert!((2..=2000).contains(&points.len()), "{}", points.len());
    assert!(ghost["outline"].as_array().expect("a hull").len() > 3);
    let recording = server.recording().to_owned();
    // A session that goes on has the same ghost; its track cannot be changed.
    let again = server.killed_and_started_again(&[]);
    let same = block_on(async { Client::join(&again, "observer").await.hello["ghost"].clone() });
    assert_eq!(same, ghost);
    let kept = std::fs::read_to_string(&recording).expect("a recording");
    assert!(kept.lines().next().expect("a line").contains("\"ghost\":{"));
    again.stop_and_check();
}

#[test]
fn a_ghost_that_cannot_be_shown_is_refused_with_its_file() {
    let [log, mapping] = ["laser.csv", "laser.toml"].map(example);
    let with = |more: &[&str]| {
        let all: Vec<&str> = ["--ghost", log.as_str(), "--ghost-mapping", mapping.as_str()]
            .into_iter()
            .chain(more.iter().copied())
            .collect();
        server::refused(&all)
    };
    for (more, words) in [
        (&["--ghost-berthing", "7"][..], "laser.csv: number 7 is wanted, but the log has 5 tracks"),
        (&["--ghost-touch", "-1e6"], "s before the session begins"),
        (&["--ghost-touch", "nan"], "not a time"),
    ] {
        let text = with(more);
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(server::refused(&["--ghost-touch", "5"]).contains("--ghost"));
    assert!(server::refused(&["--ghost", "none.csv"]).contains("none.csv"));
    // Without the mapping, nobody knows where the sensors stand.
    assert!(server::refused(&["--ghost", &log]).contains("laser.csv: nobody knows where"));
    let (track, by) = (example("pilot_unit.nmea"), example("pilot_unit.toml"));
    let far = ["--ghost", &track, "--ghost-mapping", &by, "--ghost-touch", "9"];
    assert!(server::refused(&far).contains("does not touch a fender"));
}
