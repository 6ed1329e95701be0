//! Who is at which page: pilots of several ships, and people with names.

use std::path::Path;

use serde_json::{Value, json};

use super::{block_on, claim, reason};
use crate::client::Client;
use crate::server::Server;

fn engine(vessel: &str) -> Value {
    json!({ "do": "engine", "vessel": vessel, "share": 0.1 })
}

fn name(name: &str) -> Value {
    json!({ "do": "name", "name": name })
}

/// The holder of a vessel's helm, and whether she is connected.
fn holder(hello: &Value, vessel: &str) -> (String, bool) {
    let claims = hello["claims"].as_array().expect("claims");
    let claim = claims.iter().find(|claim| claim["control"]["vessel"] == vessel);
    let claim = claim.expect("a claim");
    (claim["holder"].as_str().unwrap_or("").to_owned(), claim["connected"] == true)
}

#[test]
fn each_ship_has_a_pilot_with_a_link_of_her_own() {
    block_on(async {
        let two =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/live/ship_to_ship.toml");
        let server = Server::start_with(&two, &[]);
        let mut first = Client::join(&server, "pilot").await;
        let own = first.hello["vessels"][0]["name"].as_str().expect("a name").to_owned();
        let other = first.hello["vessels"][1]["name"].as_str().expect("a name").to_owned();
        let mut second = Client::join(&server, &format!("pilot of {other}")).await;
        assert_eq!(second.hello["role"], json!({ "name": "pilot", "vessel": &other }));
        assert_eq!(second.ask(claim(&other)).await["type"], "ack");
        assert_eq!(first.ask(claim(&own)).await["type"], "ack");
        for (client, theirs, foreign) in [(&mut first, &own, &other), (&mut second, &other, &own)] {
            assert!(reason(&client.ask(claim(foreign)).await).contains("does not open"));
            let refused = client.ask(engine(foreign)).await;
            assert!(reason(&refused).contains("that ship"), "{refused}");
            let hands = json!({ "do": "hands", "vessel": theirs });
            assert_eq!(client.ask(hands).await["type"], "ack");
        }
        server.stop_and_check();
    });
}

#[test]
fn a_person_has_a_name_and_gets_her_helm_back_when_she_comes_again() {
    block_on(async {
        let server = Server::start(&[]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        let mut other = Client::join(&server, "pilot").await;
        for bad in ["", "   ", "a\nb", &"x".repeat(31)] {
            assert!(reason(&pilot.ask(name(bad)).await).contains("1 to 30 characters"));
        }
        assert_eq!(pilot.ask(name("Anna")).await["type"], "ack");
        instructor.notice("is Anna (pilot)").await;
        assert_eq!(other.ask(name("Anna")).await["type"], "ack");
        instructor.notice("is Anna 2 (pilot)").await;
        assert_eq!(pilot.ask(claim("ship")).await["type"], "ack");
        let held_by_anna = |connected| {
            move |hello: &Value| holder(hello, "ship") == ("Anna (pilot)".to_owned(), connected)
        };
        instructor.hello_with(held_by_anna(true)).await;
        pilot.vanish();
        instructor.notice("Anna (pilot) has left").await;
        instructor.hello_with(held_by_anna(false)).await;
        let mut again = Client::join(&server, "pilot").await;
        assert_eq!(again.ask(name("Anna")).await["type"], "ack");
        instructor.hello_with(held_by_anna(true)).await;
        let rudder = json!({ "do": "rudder", "vessel": "ship", "angle_rad": 0.1 });
        assert_eq!(again.ask(rudder).await["type"], "ack");
        server.stop_and_check();
    });
}

#[test]
fn a_pilot_without_a_name_keeps_the_helm_over_a_reload_and_a_second_page_cannot_take_it() {
    block_on(async {
        let server = Server::start(&[]);
        let seat = |digit: &str| json!({ "do": "seat", "key": digit.repeat(32) });
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        for bad in ["", "a", "not hexadecimal"] {
            let refused = pilot.ask(json!({ "do": "seat", "key": bad })).await;
            assert!(reason(&refused).contains("32 hexadecimal digits"), "{refused}");
        }
        assert_eq!(pilot.ask(seat("a")).await["type"], "ack");
        assert_eq!(pilot.ask(claim("ship")).await["type"], "ack");
        let hello = instructor.hello_with(|hello| holder(hello, "ship").1).await;
        let (label, _) = holder(&hello, "ship");
        let mut copy = Client::join(&server, "pilot").await;
        assert!(reason(&copy.ask(seat("a")).await).contains("another page has this seat"));
        assert_eq!(copy.ask(seat("b")).await["type"], "ack");
        pilot.vanish();
        instructor.notice(&format!("{label} has left")).await;
        let mut observer = Client::join(&server, "observer").await;
        assert_eq!(observer.ask(seat("a")).await["type"], "ack", "a seat is one of a role");
        instructor.hello_with(|hello| holder(hello, "ship") == (label.clone(), false)).await;
        let mut again = Client::join(&server, "pilot").await;
        assert_eq!(again.ask(seat("a")).await["type"], "ack");
        instructor.notice("who is back").await;
        instructor.hello_with(|hello| holder(hello, "ship") == (label.clone(), true)).await;
        assert!(reason(&copy.ask(claim("ship")).await).contains("holds this control"));
        let rudder = json!({ "do": "rudder", "vessel": "ship", "angle_rad": 0.1 });
        assert_eq!(again.ask(rudder).await["type"], "ack");
        server.stop_and_check();
    });
}

/// A pilot and a tugmaster reached their goal without an instructor: the run paused, neither could resume it, and the tugs went on
/// pushing for ever.
#[test]
fn an_exercise_that_ends_pauses_for_an_instructor_and_not_without_one() {
    const ENDS: &str = "exercise={ vessel = \"ship\", goal = \"alongside\", time_limit = \"2 s\" }";
    block_on(async {
        let server = Server::start(&["--set", ENDS]);
        let mut pilot = Client::join(&server, "pilot").await;
        assert!(pilot.notice("exercise has ended").await.contains("goes on"));
        let frame = pilot.frame_after(60).await;
        assert_eq!(frame["run"]["paused"], false);
        server.stop_and_check();
        let server = Server::start(&["--set", ENDS]);
        let mut instructor = Client::join(&server, "instructor").await;
        assert!(instructor.notice("exercise has ended").await.contains("resumes"));
        assert_eq!(instructor.frame_after(19).await["run"]["paused"], true);
        server.stop_and_check();
    });
}
