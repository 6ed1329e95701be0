//! Limits of motions, lines and fenders in scenarios: what exceeds them, and mistakes that are refused.

use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::{Finding, Simulation, Verdict};

/// A ship alone that a load pushes ahead and back.
const SHIP: &str = r#"
[time]
step = "0.5 s"
duration = "200 s"

[vessel.tanker]
length_bp = 243.5
beam = 39
draught = 15.3
block_coefficient = 0.8
rudder = { area = "60 m^2", span = "9 m" }
propeller = { diameter = "7 m", full = "90 rpm" }

[body.ship]
vessel = "tanker"
outline = [[-121.75, -19.5], [121.75, -19.5], [121.75, 19.5], [-121.75, 19.5]]

[[load]]
body = "ship"
force = ["1 MN", 0]
until = "100 s"

"#;

fn read(limits: &str) -> Result<Scenario, ScenarioError> {
    Scenario::parse(&format!("{SHIP}{limits}"), "limits.toml")
}

fn findings(limits: &str) -> (Vec<Finding>, Verdict, Simulation) {
    let mut simulation = Simulation::new(read(limits).unwrap().setup).unwrap();
    while !simulation.is_done() {
        simulation.step().unwrap();
    }
    (simulation.findings(), simulation.verdict(), simulation)
}

#[test]
fn what_exceeds_a_limit_is_found_with_its_sentence() {
    let (found, verdict, simulation) = findings(
        "[limit.ahead]\nof = \"surge\"\nstatistic = \"maximum\"\ndistance = \"10 m\"\n\
         [limit.turned]\nof = \"yaw\"\nstatistic = \"maximum\"\nangle = \"10 deg\"",
    );
    assert_eq!(verdict, Verdict::LimitExceeded);
    let limits: Vec<&Finding> =
        found.iter().filter(|finding| matches!(finding, Finding::LimitExceeded { .. })).collect();
    assert_eq!(limits.len(), 1, "{found:?}");
    let sentence = limits[0].sentence(simulation.setup());
    assert!(sentence.starts_with("Limit ahead: surge of ship, maximum was "), "{sentence}");
    assert!(sentence.ends_with("m, above 10.00 m"), "{sentence}");
    assert_eq!(limits[0].names(simulation.setup()), ["ahead"]);
}

/// The mean of a motion that begins late is that of what is counted.
#[test]
fn statistics_count_from_their_time() {
    let (_, _, all) = findings("[statistics]");
    let (_, _, late) = findings("[statistics]\nfrom = \"150 s\"");
    let surge = |of: &Simulation| of.statistics().unwrap().motions(0, 0.5)[0];
    assert!(surge(&late).maximum < 0.6 * surge(&all).maximum);
    // The mean is from where the count begins.
    assert!(surge(&late).mean > 0.0);
    assert!(findings("").2.statistics().is_none());
}

#[test]
fn mistakes_in_limits_are_refused() {
    let refused = |limits: &str, key: &str, says: &str| {
        let error = read(limits).expect_err(limits);
        assert_eq!(error.key(), Some(key), "{error}");
        assert!(error.to_string().contains(says) && error.line().is_some(), "{error}");
    };
    let of = |keys: &str| format!("[limit.x]\nof = {keys}");
    refused(&of("\"surge\"\nstatistic = \"maximum\""), "limit.x.distance", "is missing");
    refused(&of("\"surge\"\ndistance = 1"), "limit.x.statistic", "is missing");
    let roll = "\"roll\"\nstatistic = \"maximum\"\ndistance = 1";
    refused(&of(roll), "limit.x.distance", "does not go together");
    refused(&of("\"lines\"\ndistance = 1"), "limit.x.distance", "does not go together");
    refused(&of("\"lines\""), "limit.x.share", "is missing");
    refused("[statistics]\nfrom = \"1 h\"", "statistics.from", "the run ends before this time");
    let other = of("\"surge\"\nstatistic = \"maximum\"\ndistance = 1\nvessel = \"shop\"");
    refused(&other, "limit.x.vessel", "no body");
}
