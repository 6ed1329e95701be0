//! Ships under bridges and cables of the chart: clearances in closed form, what is told, and mistakes that are refused.

use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::overhead::AirClearance;
use fenderline_sim::{Simulation, Verdict};

/// A bridge across the track, and another bridge beside the track.
const CHART: &str = r#"{ "type": "FeatureCollection", "features": [
{ "type": "Feature", "properties": { "OBJL": 11, "OBJNAM": "High Bridge", "VERCLR": 30 }, "geometry": { "type": "Polygon", "coordinates":
  [[[-200, 150], [200, 150], [200, 162], [-200, 162], [-200, 150]]] } },
{ "type": "Feature", "properties": { "OBJL": 11, "OBJNAM": "Side Bridge", "VERCLR": 5 }, "geometry": { "type": "LineString", "coordinates":
  [[20, 0], [20, 300]] } },
{ "type": "Feature", "properties": { "OBJL": 21, "OBJNAM": "Power", "VERCLR": 41, "VERCSA": 36 }, "geometry": { "type": "LineString", "coordinates":
  [[-200, 190], [200, 190]] } }
] }"#;

const TEXT: &str = r#"
[time]
step = "0.5 s"
duration = "60 s"
[environment]
depth = "12 m"
squat = "icorels"
tide = { level = 1.2, constituent = [{ amplitude = "1 m", period = "10 min", lag = "30 deg" }] }
[chart]
files = ["bridges.geojson"]
coordinates = "metres"
clearance_datum = "3.2 m"
[vessel.coaster]
length_bp = 100
beam = 16
draught = 6
block_coefficient = 0.7
rudder = { area = "12 m^2", span = "4 m" }
propeller = { diameter = "4 m", full = "130 rpm" }
[body.ship]
vessel = "coaster"
outline = [[-50, -8], [50, -8], [50, 8], [-50, 8]]
velocity = { surge = "8 kn" }
running = 0.5
air_draught = "28 m"
"#;

fn with(changes: &[(&str, &str)], chart: &str) -> Result<Scenario, ScenarioError> {
    let text = changes.iter().fold(TEXT.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    Scenario::parse_among(&text, "bridge.toml", &[], &mut |_| Ok(chart.to_owned()))
}

/// What a run finds: the clearance in each step in which the ship is under something, and the findings.
struct Passed {
    /// The structure and the clearance (m), with the clearance in closed form.
    under: Vec<(AirClearance, f64)>,
    findings: Vec<String>,
    verdict: &'static str,
}

fn run(scenario: Scenario) -> Passed {
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    let setup = simulation.setup().clone();
    let mut under = Vec::new();
    while !simulation.is_done() {
        simulation.step().unwrap();
        let level_m = setup.world.environment.level_m(simulation.time_s());
        let squat_m = simulation.vessels()[0].squat_m;
        let state = &simulation.states()[0];
        if let Some(now) = setup.world.overhead.over(0, state, level_m, squat_m) {
            let height_m = [30.0, 5.0, 36.0][now.structure];
            under.push((now, height_m + 3.2 - level_m - 28.0 + squat_m));
        }
    }
    let findings = simulation.findings();
    let verdict = Verdict::of(&findings).key();
    let findings = findings.iter().map(|finding| finding.sentence(&setup)).collect();
    Passed { under, findings, verdict }
}

#[test]
fn the_clearance_is_that_of_the_closed_form_from_bow_to_stern() {
    let passed = run(with(&[], CHART).unwrap());
    assert!(passed.under.iter().all(|(now, form_m)| (now.clearance_m - form_m).abs() < 1e-12));
    assert_eq!(passed.verdict, "all_well", "{:?}", passed.findings);
    let over = |structure| passed.under.iter().filter(move |(now, _)| now.structure == structure);
    // Her stem comes under the bridge at 150 m, and her stern leaves the bridge at 162 m; under both the bridge, which is
    // lower, counts.
    let norths: Vec<f64> = over(0).map(|(now, _)| now.at_m.x).collect();
    let stride_m = 0.5 * 8.0 * 1852.0 / 3600.0;
    assert!((100.0..100.0 + stride_m).contains(&norths[0]), "{norths:?}");
    let last = norths[norths.len() - 1];
    assert!((212.0 - stride_m..212.0).contains(&last), "{norths:?}");
    assert_eq!(over(1).count(), 0, "the bridge beside her");
    // The safe clearance of the cable counts, not the larger one.
    assert!(over(2).count() > 5 && over(2).all(|(now, _)| now.clearance_m > 8.0));
    let least = over(0).map(|(now, _)| now.clearance_m).fold(f64::INFINITY, libm::fmin);
    assert!(least > 2.5 && least < 5.5, "{least}");
}

/// The same bits to the south as to the north.
#[test]
fn a_ship_that_goes_the_other_way_has_the_same_clearance() {
    let north = run(with(&[("depth = \"12 m\"\nsquat = \"icorels\"\n", "")], CHART).unwrap());
    let mirrored = CHART.replace("150]", "-150]").replace("162]", "-162]").replace("190]", "-190]");
    let south = [
        ("depth = \"12 m\"\nsquat = \"icorels\"\n", ""),
        ("velocity", "heading = \"180 deg\"\nvelocity"),
    ];
    let south = run(with(&south, &mirrored).unwrap());
    let clearances = |passed: &Passed| -> Vec<f64> {
        passed.under.iter().map(|(now, _)| now.clearance_m).collect()
    };
    assert_eq!(clearances(&north), clearances(&south));
}

#[test]
fn a_ship_that_is_too_high_strikes_the_bridge_and_the_verdict_says_where() {
    let still = [
        (", constituent = [{ amplitude = \"1 m\", period = \"10 min\", lag = \"30 deg\" }]", ""),
        ("depth = \"12 m\"\nsquat = \"icorels\"\n", ""),
        ("\"28 m\"", "\"33 m\""),
    ];
    let passed = run(with(&still, CHART).unwrap());
    assert_eq!(passed.verdict, "structure_struck", "{:?}", passed.findings);
    let says = "ship was 1.00 m too high for the bridge \"High Bridge\", 10";
    assert!(passed.findings[0].starts_with(says), "{:?}", passed.findings);
    // Beside the bridge nothing is found.
    let beside = CHART.replace("[200, 150]", "[-50, 150]").replace("[200, 162]", "[-50, 162]");
    let passed = run(with(&still, &beside).unwrap());
    assert_eq!(passed.verdict, "all_well", "{:?}", passed.findings);
}

#[test]
fn what_is_not_known_is_refused_or_told() {
    let error = with(&[("clearance_datum = \"3.2 m\"\n", "")], CHART).unwrap_err();
    assert_eq!(error.key(), Some("body.ship.air_draught"), "{error}");
    assert!(error.to_string().contains("chart.clearance_datum"), "{error}");
    let told = |changes: &[(&str, &str)], chart: &str| -> Vec<String> {
        let scenario = with(changes, chart).unwrap();
        scenario
            .notices
            .iter()
            .filter(|notice| notice.message.contains("cable"))
            .map(|notice| format!("{}: {}", notice.key, notice.message))
            .collect()
    };
    assert_eq!(told(&[], CHART), [""; 0]);
    let none = told(&[("air_draught = \"28 m\"\n", "")], CHART);
    assert!(
        none[0].contains("3 bridges and cables") && none[0].contains("not checked for ship"),
        "{none:?}"
    );
    let unknown = told(&[], &CHART.replace(", \"VERCLR\": 5", ""));
    assert!(
        unknown[0].contains("1 bridges and cables of the chart have no clearance"),
        "{unknown:?}"
    );
    let nothing = told(&[], "{ \"type\": \"FeatureCollection\", \"features\": [] }");
    assert!(nothing.iter().any(|told| told.starts_with("body.ship.air_draught: ")), "{nothing:?}");
}
