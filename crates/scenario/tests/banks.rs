//! Banks from scenarios that act by the image of the ship: what they do in a run, where they are off, and mistakes that are refused.

#![allow(clippy::disallowed_methods, reason = "expected values may use std")]

use fenderline_contact::vec2;
use fenderline_scenario::{Scenario, ScenarioError};
use fenderline_sim::passing::{FlowHull, PassingShip, force_of_wall};
use fenderline_sim::{SetupError, Simulation, VesselForces};

const CANAL: &str = r#"
[time]
step = "0.5 s"
duration = "60 s"

[environment]
depth = "14 m"
bank = [{ from = [-2000, 70], to = [2000, 70], method = "image" }]

[vessel.tanker]
length_bp = 200
beam = 32
draught = 11
block_coefficient = 0.8
rudder = { area = "50 m^2", span = "8 m" }
propeller = { diameter = "7 m", full = "90 rpm" }

[body.ship]
vessel = "tanker"
outline = [[-100, -16], [100, -16], [100, 16], [-100, 16]]
velocity = { surge = 4 }
"#;

fn with(changes: &[(&str, &str)]) -> Result<Scenario, ScenarioError> {
    let text = changes.iter().fold(CANAL.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    });
    Scenario::parse(&text, "canal.toml")
}

/// The forces of the first step.
fn forces(changes: &[(&str, &str)]) -> VesselForces {
    let scenario = with(changes).unwrap_or_else(|error| panic!("{error}"));
    let mut simulation = Simulation::new(scenario.setup).unwrap();
    simulation.step().unwrap().vessel_forces[0]
}

#[test]
fn a_run_has_the_force_of_the_image_and_its_work_in_the_ledger() {
    let own = FlowHull::new([200.0, 32.0, 11.0], 0.98, None).unwrap();
    let mut simulation = Simulation::new(with(&[]).unwrap().setup).unwrap();
    for _ in 0..120 {
        let record = simulation.step().unwrap();
        let state = record.states[0];
        let ship = PassingShip {
            sections: &own.sections,
            pose: state.pose(),
            velocity_mps: state.velocity_mps,
        };
        let wall = [vec2(-2000.0, 70.0), vec2(2000.0, 70.0)];
        let [x_n, y_n, n_nm] = force_of_wall(&ship, wall, 1025.0, Some(14.0), 32.0);
        let found = record.vessel_forces[0].banks;
        assert!((found.sway_n - y_n).abs() < 1e-9 * y_n, "{found:?} {y_n}");
        assert!(
            (found.surge_n - x_n).abs() < 1e-6 * y_n
                && (found.yaw_nm - n_nm).abs() < 1e-6 * 200.0 * y_n
        );
    }
    assert!(simulation.states()[0].position_m.y > 0.0, "she is drawn to the bank");
    assert!(simulation.energy().loads.banks_j > 0.0);
    assert!(simulation.energy().residual_j.abs() < 1e-3 * simulation.energy().exchanged_j());
}

/// Off where the flow does not hold: at 45 degrees, nearer than an eighth of a beam, for a short vessel, beyond the end of the bank; half
/// where half of her is beside it.
#[test]
fn it_is_off_where_the_flow_does_not_hold() {
    let full_n = forces(&[]).banks.sway_n;
    assert!(full_n > 1e4, "{full_n}");
    let bank = "[-2000, 70], to = [2000, 70]";
    let off = [
        ("velocity = { surge = 4 }", "velocity = { surge = 4 }\nheading = \"45 deg\""),
        (bank, "[-2000, 19], to = [2000, 19]"),
        (bank, "[-2000, 10], to = [2000, 10]"),
        (bank, "[300, 70], to = [2000, 70]"),
        ("beam = 32", "beam = 60"),
    ];
    for change in off {
        assert_eq!(forces(&[change]).banks.sway_n, 0.0, "{change:?}");
    }
    let half_n = forces(&[(bank, "[0, 70], to = [2000, 70]")]).banks.sway_n;
    assert!((half_n - 0.5 * full_n).abs() < 1e-9 * full_n, "{half_n} {full_n}");
    let port_n = forces(&[(bank, "[2000, -70], to = [-2000, -70]")]).banks.sway_n;
    assert!((port_n + full_n).abs() < 1e-9 * full_n, "{port_n}");
    // Between two walls at one distance there is none.
    let both = "bank = [{ from = [-2000, -70], to = [2000, -70], method = \"image\" }, ";
    assert!(forces(&[("bank = [", both)]).banks.sway_n.abs() < 1e-9 * full_n);
}

/// Each bank has its own method: one by Norrbin's formulas beside one by an image, and Norrbin's where nothing is said.
#[test]
fn methods_are_chosen_bank_by_bank() {
    let image_n = forces(&[]).banks.sway_n;
    let norrbin_n = forces(&[(", method = \"image\"", "")]).banks.sway_n;
    let named_n = forces(&[("\"image\"", "\"norrbin\"")]).banks.sway_n;
    assert_eq!(norrbin_n, named_n);
    let both = "bank = [{ from = [-2000, 70], to = [2000, 70] }, ";
    let both_n = forces(&[("bank = [", both)]).banks.sway_n;
    assert!((both_n - norrbin_n - image_n).abs() < 1e-9 * both_n, "{both_n}");
    assert!(
        forces(&[(", method = \"image\"", "")]).banks.yaw_nm < 0.0,
        "Norrbin turns her bow away"
    );
}

#[test]
fn mistakes_are_refused_and_limits_noted() {
    let error = with(&[("\"image\"", "\"images\"")]).expect_err("no such method");
    assert!(error.to_string().contains("image") && error.line().is_some(), "{error}");
    assert!(error.key().is_some_and(|key| key.ends_with("method")), "{:?}", error.key());
    let error = with(&[("to = [2000, 70]", "to = [-2000, 70]")]).expect_err("no length");
    assert!(error.to_string().contains("length of a bank"), "{error}");
    let noted = |changes: &[(&str, &str)], says: &str| {
        let notices = with(changes).unwrap().notices;
        assert!(notices.iter().any(|notice| notice.message.contains(says)), "{says}: {notices:?}");
    };
    noted(&[], "without waves and lift");
    noted(&[("beam = 32", "beam = 60")], "no such force for \"ship\", shorter than 3.5 beams");
    let both = "bank = [{ from = [-2000, -70], to = [2000, -70], method = \"image\" }, ";
    noted(&[("bank = [", both)], "images of the images");
    let own = with(&[(", method = \"image\"", "")]).unwrap();
    assert!(own.notices.iter().all(|notice| !notice.message.contains("without waves")));
    // A set-up by hand without the hulls.
    let mut setup = with(&[]).unwrap().setup;
    setup.world.flow.hulls.clear();
    assert!(matches!(Simulation::new(setup), Err(SetupError::OutOfRange { .. })));
}

/// A copy in the middle of a run goes on with the same bits.
#[test]
fn a_copy_goes_on_to_the_bit() {
    let mut one = Simulation::new(with(&[]).unwrap().setup).unwrap();
    let steps = |simulation: &mut Simulation| {
        for _ in 0..60 {
            simulation.step().unwrap();
        }
    };
    steps(&mut one);
    let mut copy = one.clone();
    steps(&mut one);
    steps(&mut copy);
    assert_eq!(one.states(), copy.states());
}
