//! Every transition of an alarm, seen by all clients alike.

use std::time::Duration;

use serde_json::{Value, json};
use tokio::time::sleep;

use super::{block_on, reason};
use crate::client::Client;
use crate::server::Server;

const KEY: &str = "rudder stuck ship";
/// Time between two events, of up to two commands of one client each.
const BETWEEN: Duration = Duration::from_millis(80);

/// The state of the alarm. As on a ship's bridge, one that nobody acknowledged stays when its cause ends.
#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    None,
    Active,
    Acknowledged,
    /// Its cause has ended, and nobody has acknowledged it.
    Waits,
}
use State::{Acknowledged, Active, None as Gone, Waits};

#[derive(Clone, Copy, Debug, PartialEq)]
enum Event {
    CauseBegins,
    CauseEnds,
    /// By the pilot or by the instructor.
    Acknowledge,
    Step,
}
use Event::{Acknowledge, CauseBegins, CauseEnds, Step};

/// From a state by an event to a state; for an acknowledgement that is refused, a part of the reason.
const TABLE: [(State, Event, State, &str); 16] = [
    (Gone, CauseBegins, Active, ""),
    (Gone, CauseEnds, Gone, ""),
    (Gone, Acknowledge, Gone, "no such alarm"),
    (Gone, Step, Gone, ""),
    (Active, CauseBegins, Active, ""),
    (Active, CauseEnds, Waits, ""),
    (Active, Acknowledge, Acknowledged, ""),
    (Active, Step, Active, ""),
    (Acknowledged, CauseBegins, Acknowledged, ""),
    (Acknowledged, CauseEnds, Gone, ""),
    (Acknowledged, Acknowledge, Acknowledged, "somebody has acknowledged this alarm already"),
    (Acknowledged, Step, Acknowledged, ""),
    (Waits, CauseBegins, Active, ""),
    (Waits, CauseEnds, Waits, ""),
    (Waits, Acknowledge, Gone, ""),
    (Waits, Step, Waits, ""),
];

fn fault(on: bool) -> Value {
    json!({ "do": "fault", "vessel": "ship", "fault": "rudder_stuck", "on": on })
}

fn acknowledge(key: &str) -> Value {
    json!({ "do": "acknowledge", "key": key })
}

/// The alarm in a frame, and since when it is there (s).
fn state(frame: &Value) -> (State, Option<f64>) {
    let all = frame["alarms"].as_array().expect("alarms");
    let Some(alarm) = all.iter().find(|alarm| alarm["key"] == KEY) else { return (Gone, None) };
    let state = match (alarm["stands"] == true, alarm["acknowledged"] == true) {
        (true, false) => Active,
        (true, true) => Acknowledged,
        (false, false) => Waits,
        (false, true) => panic!("it is over: {alarm}"),
    };
    (state, alarm["since_s"].as_f64())
}

/// A paused session with its people.
struct Table {
    instructor: Client,
    pilot: Client,
    observer: Client,
}

impl Table {
    /// An event and a step; the state that all three see, and the answer to the event.
    async fn event(&mut self, event: Event, by_pilot: bool) -> (State, Option<f64>, Value) {
        // The server takes thirty commands a second of a client.
        sleep(BETWEEN).await;
        let answer = match event {
            CauseBegins => self.instructor.ask(fault(true)).await,
            CauseEnds => self.instructor.ask(fault(false)).await,
            Acknowledge if by_pilot => self.pilot.ask(acknowledge(KEY)).await,
            Acknowledge => self.instructor.ask(acknowledge(KEY)).await,
            Step => Value::Null,
        };
        let step = self.instructor.ask(json!({ "do": "single_step" })).await;
        let tick = step["tick"].as_u64().expect("a tick");
        let own = self.instructor.frame_after(tick).await;
        for client in [&mut self.pilot, &mut self.observer] {
            assert_eq!(client.frame_after(tick).await["alarms"], own["alarms"], "all see the same");
        }
        let (state, since_s) = state(&own);
        (state, since_s, answer)
    }

    /// Brings the alarm into a state.
    async fn go_to(&mut self, to: State) {
        let (mut now, ..) = self.event(CauseEnds, true).await;
        if now == Waits {
            (now, ..) = self.event(Acknowledge, true).await;
        }
        assert_eq!(now, Gone);
        let way: &[Event] = match to {
            Gone => &[],
            Active => &[CauseBegins],
            Acknowledged => &[CauseBegins, Acknowledge],
            Waits => &[CauseBegins, CauseEnds],
        };
        for event in way {
            (now, ..) = self.event(*event, true).await;
        }
        assert_eq!(now, to);
    }
}

#[test]
fn every_transition_of_an_alarm_is_that_of_the_table_for_all_clients() {
    block_on(async {
        let server = Server::start(&["--paused"]);
        let instructor = Client::join(&server, "instructor").await;
        let pilot = Client::join(&server, "pilot").await;
        let observer = Client::join(&server, "observer").await;
        let mut table = Table { instructor, pilot, observer };
        for (from, event, to, refusal) in TABLE {
            for by_pilot in [true, false] {
                if event != Acknowledge && !by_pilot {
                    continue;
                }
                table.go_to(from).await;
                let (now, _, answer) = table.event(event, by_pilot).await;
                assert_eq!(now, to, "{from:?} by {event:?}");
                match (event, refusal) {
                    (Step, _) => {}
                    (_, "") => assert_eq!(answer["type"], "ack", "{from:?} by {event:?}: {answer}"),
                    _ => assert!(reason(&answer).contains(refusal), "{from:?}: {answer}"),
                }
            }
        }
        // Active again: since its first beginning where nobody had acknowledged it, else since now.
        table.go_to(Active).await;
        let (_, first_s, _) = table.event(Step, true).await;
        table.event(CauseEnds, true).await;
        let (now, again_s, _) = table.event(CauseBegins, true).await;
        assert_eq!((now, again_s), (Active, first_s));
        table.event(Acknowledge, false).await;
        table.event(CauseEnds, true).await;
        let (now, later_s, _) = table.event(CauseBegins, true).await;
        assert!(now == Active && later_s > first_s, "{now:?} {later_s:?} {first_s:?}");
        server.stop_and_check();
    });
}

#[test]
fn of_two_who_acknowledge_at_once_one_does_and_what_is_no_alarm_is_refused() {
    block_on(async {
        let server = Server::start(&["--paused"]);
        let instructor = Client::join(&server, "instructor").await;
        let pilot = Client::join(&server, "pilot").await;
        let observer = Client::join(&server, "observer").await;
        let mut master = Client::join(&server, "master of aft").await;
        let mut table = Table { instructor, pilot, observer };
        let mut times_of_pilot = 0;
        for _ in 0..5 {
            table.go_to(Active).await;
            let (pilot, instructor) = tokio::join!(
                table.pilot.ask(acknowledge(KEY)),
                table.instructor.ask(acknowledge(KEY))
            );
            let by_pilot = pilot["type"] == "ack";
            times_of_pilot += usize::from(by_pilot);
            let (done, refused) = if by_pilot { (pilot, instructor) } else { (instructor, pilot) };
            assert_eq!(done["type"], "ack", "{done}");
            assert!(reason(&refused).contains("already"), "{refused}");
            assert_eq!(table.event(Step, true).await.0, Acknowledged);
        }
        table.go_to(Active).await;
        for key in ["rudder stuck titanic", "", "rudder stuck", "RUDDER STUCK SHIP"] {
            let answer = table.pilot.ask(acknowledge(key)).await;
            assert!(reason(&answer).contains("no such alarm"), "{key}: {answer}");
        }
        for (client, why) in [
            (&mut master, "only the alarms of"),
            (&mut table.observer, "observer cannot acknowledge"),
        ] {
            assert!(reason(&client.ask(acknowledge(KEY)).await).contains(why));
        }
        for bad in [json!({ "do": "acknowledge" }), json!({ "do": "acknowledge", "key": 7 })] {
            assert!(reason(&table.pilot.ask(bad).await).contains("not understood"));
        }
        assert_eq!(table.event(Step, true).await.0, Active, "nothing of it changed the alarm");
        // What was acknowledged is recorded with who did it, what was refused is not.
        let text = std::fs::read_to_string(server.recording()).expect("a recording");
        let recorded: Vec<&str> =
            text.lines().filter(|line| line.contains("\"do\":\"acknowledge\"")).collect();
        let by_pilot = recorded.iter().filter(|line| line.contains("\"who\":\"pilot 2\"")).count();
        assert!(!text.contains("titanic"), "{text}");
        assert_eq!((recorded.len(), by_pilot), (5, times_of_pilot), "{text}");
        server.stop_and_check();
    });
}
