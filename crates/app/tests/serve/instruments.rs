//! Frozen instruments over real sockets: charts after a reload, and chart programs.

use serde_json::{Value, json};

use super::block_on;
use crate::client::{self, Client};
use crate::server::Server;

/// Metres per second of a knot.
const KNOT_MPS: f64 = 1852.0 / 3600.0;

async fn accepted(client: &mut Client, action: Value) -> Value {
    let answer = client.ask(action.clone()).await;
    assert_eq!(answer["type"], "ack", "{action}: {answer}");
    answer
}

/// Times and speeds ahead of the charts that a page gets after it was loaded.
async fn charts(server: &Server, role: &str) -> Vec<(f64, f64)> {
    let mut page = Client::join(server, role).await;
    page.send(r#"{"type":"command","id":9000,"action":{"do":"history"}}"#).await;
    let past = page.next("history").await;
    let column = |name: &str| -> Vec<f64> {
        let values = past[name].as_array().expect("a column").iter();
        values.map(|value| value.as_f64().expect("a number")).collect()
    };
    column("t_s").into_iter().zip(column("ahead_mps")).collect()
}

/// Speed ahead over ground of the last log sentence of a round (m/s).
async fn by_log_mps(server: &Server) -> f64 {
    let text = client::lines(server.nmea.expect("a port for chart programs"), 40).await;
    let line = text.lines().rfind(|line| line.contains("VBW")).expect("a log");
    let speed_kn: f64 = line.split(',').nth(4).and_then(|cell| cell.parse().ok()).expect("a speed");
    speed_kn * KNOT_MPS
}

/// After a reload the pilot saw the true speeds of the time in which hers were frozen, and a chart program beside her page all the time.
#[test]
fn a_reloaded_page_and_a_chart_program_show_what_frozen_instruments_show() {
    block_on(async {
        let server = Server::start(&["--nmea-tcp", "0"]);
        let mut instructor = Client::join(&server, "instructor").await;
        let mut pilot = Client::join(&server, "pilot").await;
        accepted(&mut pilot, json!({ "do": "engine", "vessel": "ship", "share": 1.0 })).await;
        accepted(&mut instructor, json!({ "do": "pace", "pace": 10 })).await;
        instructor.frame_after(200).await;
        let fault = json!({ "do": "fault", "vessel": "ship", "fault": "speed_frozen", "on": true });
        let frozen_tick = accepted(&mut instructor, fault).await["tick"].as_u64().expect("a tick");
        instructor.frame_after(frozen_tick + 400).await;
        let truth = instructor.ask_and_see(json!({ "do": "pause" })).await;
        let shown = pilot.frame_after(truth["tick"].as_u64().expect("a tick")).await;
        let ahead_mps =
            |frame: &Value| frame["vessels"][0]["ground_mps"][0].as_f64().expect("a speed");
        let (shown_mps, true_mps) = (ahead_mps(&shown), ahead_mps(&truth));
        assert!((shown_mps - true_mps).abs() > 0.05, "{shown_mps} {true_mps}");
        let step_s = pilot.hello["step_s"].as_f64().expect("a step");
        let from_s = frozen_tick as f64 * step_s + 1e-6;
        let (seen, all) = (charts(&server, "pilot").await, charts(&server, "instructor").await);
        assert_eq!(seen.len(), all.len());
        let is_shown = |of: &(f64, f64)| (of.1 - shown_mps).abs() <= 0.5e-4 + 1e-9;
        for (own, truth) in seen.iter().zip(&all) {
            if own.0 > from_s {
                assert!(is_shown(own), "{own:?}, shown {shown_mps}");
            } else {
                assert_eq!(own, truth);
            }
        }
        assert!(all.last().is_some_and(|of| !is_shown(of)), "the instructor sees the truth");
        // Two decimals of a knot.
        let half_digit_mps = 0.005 * KNOT_MPS + 1e-9;
        assert!((by_log_mps(&server).await - shown_mps).abs() <= half_digit_mps);
        let fault =
            json!({ "do": "fault", "vessel": "ship", "fault": "speed_frozen", "on": false });
        accepted(&mut instructor, fault).await;
        assert!((by_log_mps(&server).await - true_mps).abs() <= half_digit_mps);
        server.stop_and_check();
    });
}
