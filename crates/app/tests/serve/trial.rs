//! Trial manoeuvres over real sockets: soon shown, checked as orders are, and given together.

use std::path::Path;
use std::time::{Duration, Instant};

use serde_json::{Value, json};

use super::{block_on, claim, reason, rudder};
use crate::client::Client;
use crate::server::Server;

/// Far above what a trial takes on a machine that other tests use too; the time itself is printed.
const GENEROUS: Duration = Duration::from_secs(20);

fn trial(orders: &[Value], horizon_s: f64) -> Value {
    json!({ "do": "trial", "orders": orders, "horizon_s": horizon_s })
}

fn astern() -> Value {
    json!({ "do": "engine", "vessel": "ship", "share": -0.5 })
}

#[test]
fn a_trial_shows_soon_and_its_orders_are_then_given_together() {
    block_on(async {
        let berthing =
            Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenarios/live/berthing.toml");
        let server = Server::start_with(&berthing, &[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let push = json!({ "do": "tug", "tug": "forward_tug", "order": "push", "power": 0.5 });
        let orders = [astern(), rudder(-0.3), push];
        let begun = Instant::now();
        let answer = pilot.ask(trial(&orders, 300.0)).await;
        assert_eq!(answer["type"], "ack", "{answer}");
        let mut shown = pilot.next("trial").await;
        println!(
            "trial of 300 s with three ships: first shown after {:.3} s",
            begun.elapsed().as_secs_f64()
        );
        assert!(begun.elapsed() < GENEROUS && shown["id"] == answer["id"]);
        assert!(shown["paths"][0]["path"].as_array().is_some_and(|path| path.len() > 1), "{shown}");
        while shown["complete"] == false {
            shown = pilot.next("trial").await;
        }
        println!("complete after {:.3} s", begun.elapsed().as_secs_f64());
        assert_eq!(shown["paths"].as_array().map(Vec::len), Some(3), "ship and two tugs");
        assert_eq!(shown["paths"][0]["path"].as_array().map(Vec::len), Some(61));
        let frame = pilot.next("frame").await;
        assert_eq!(frame["vessels"][0]["shaft"]["order"], 0.0, "nothing is given by a trial");
        let frame = pilot.ask_and_see(json!({ "do": "give", "orders": orders })).await;
        assert_eq!(frame["vessels"][0]["shaft"]["order"], -0.5);
        assert_eq!(frame["vessels"][0]["rudder"]["order_rad"], -0.3);
        assert_eq!(frame["vessels"][1]["assist"]["order"], "push");
        server.stop_and_check();
    });
}

#[test]
fn a_trial_is_refused_as_its_orders_would_be() {
    block_on(async {
        let server = Server::start(&[]);
        let mut pilot = Client::join(&server, "pilot").await;
        let mut other = Client::join(&server, "pilot").await;
        let mut observer = Client::join(&server, "observer").await;
        let mut master = Client::join(&server, "master of aft").await;
        let all = |order: Value| {
            [trial(std::slice::from_ref(&order), 60.0), json!({ "do": "give", "orders": [order] })]
        };
        for action in all(astern()) {
            assert!(reason(&observer.ask(action.clone()).await).contains("observer"));
            assert!(reason(&master.ask(action).await).contains("that tug only"));
        }
        for action in all(json!({ "do": "wind", "speed_mps": 3, "from_rad": 0 })) {
            assert!(reason(&pilot.ask(action).await).contains("only the instructor"));
        }
        for action in all(rudder(9.0)) {
            assert!(reason(&pilot.ask(action).await).contains("rudder"));
        }
        // A trial takes no helm, and asks who holds it.
        assert_eq!(pilot.ask(trial(&[astern()], 60.0)).await["type"], "ack");
        assert_eq!(other.ask(claim("ship")).await["type"], "ack");
        for action in all(astern()) {
            assert!(reason(&pilot.ask(action).await).contains("holds this control"));
        }
        // More than ten a second of one page.
        let mut refused = 0;
        for _ in 0..25 {
            refused += u32::from(other.ask(trial(&[astern()], 10.0)).await["type"] == "refused");
        }
        assert!(refused > 0, "trials have a limit");
        server.stop_and_check();
    });
}
