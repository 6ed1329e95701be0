//! An order given while a simulation runs has the same effect as one in the file, bit for bit.

use fenderline_scenario::{Override, Scenario, order};
use fenderline_sim::{Action, Simulation, VesselAction};

const FILE: &str =
    concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenarios/berth/alongside_with_two_tugs.toml");

fn scenario(changes: &[&str]) -> Scenario {
    let changes: Result<Vec<_>, _> = changes.iter().map(|text| Override::parse(text)).collect();
    Scenario::load(FILE.as_ref(), &changes.unwrap()).unwrap()
}

#[test]
fn an_order_given_during_the_run_equals_one_in_the_file() {
    let in_file = scenario(&["order=[{ at = 20.05, vessel = 'ship', rudder = '20 deg' }]"]);
    let without = scenario(&["order=[]"]);
    let mut given = Simulation::new(without.setup.clone()).unwrap();
    let mut known = Simulation::new(in_file.setup).unwrap();
    for step in 0..600 {
        if step == 200 {
            let rudder =
                order("vessel = 'ship'\nrudder = '20 deg'", "helm", given.setup()).unwrap();
            given.order(rudder).unwrap();
        }
        given.step().unwrap();
        known.step().unwrap();
        assert_eq!(given.states(), known.states(), "step {step}");
    }
    assert!(given.states()[0].yaw_rate_radps > 1e-4);
}

#[test]
fn an_order_to_an_unknown_vessel_changes_nothing() {
    let setup = scenario(&[]).setup;
    let error = order("vessel = 'quay'\nrudder = 0", "helm", &setup).unwrap_err();
    assert_eq!(error.key(), Some("order.vessel"));
    let mut simulation = Simulation::new(setup.clone()).unwrap();
    let mut wrong = order("vessel = 'ship'\nrudder = 0", "helm", &setup).unwrap();
    wrong.action = Action::Vessel(7, VesselAction::Rudder(0.0));
    assert!(simulation.order(wrong).is_err());
    let mut other = Simulation::new(setup).unwrap();
    for _ in 0..100 {
        simulation.step().unwrap();
        other.step().unwrap();
    }
    assert_eq!(simulation.states(), other.states());
}
