//! A co-simulation host as bytes: it is saved during contact, restored, and replayed.

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{CoSimHost, HostIntegration, HostSettings, RestoreError};
use master::{Master, Service, tug_against_a_ship, tug_at_a_wall};

const STEP_S: f64 = 0.1;

fn in_contact(delay_steps: u32, service: fn(HostSettings) -> Service) -> Master {
    let integration = HostIntegration::SemiImplicit;
    let settings = HostSettings { delay_steps, integration };
    let mut scene = tug_against_a_ship(0.5);
    scene.loads[0].force_n.y = 2e5;
    let mut master = Master::new(scene, integration, delay_steps, service(settings));
    while master.work.contacts().is_empty() {
        master.step(STEP_S);
    }
    master.step(STEP_S);
    master
}

#[test]
fn a_run_continues_from_a_snapshot_bit_for_bit() {
    for service in [Service::CoSim, Service::CoSimWithLoads] {
        for delay_steps in [0, 1, 3] {
            let mut one = in_contact(delay_steps, service);
            let mut two = in_contact(delay_steps, service);
            let model = one.scene.model.clone();
            let bytes = one.host.snapshot(&model);
            two.host = CoSimHost::new(&model, HostSettings::default());
            two.host.restore(&model, &bytes).expect("a good snapshot");
            assert_eq!(two.host, one.host);
            assert_eq!(two.host.snapshot(&model), bytes);
            for _ in 0..50 {
                one.step(STEP_S);
                two.step(STEP_S);
                assert_eq!((one.states(), &one.host), (two.states(), &two.host));
            }
        }
    }
}

#[test]
fn changed_truncated_and_foreign_bytes_change_nothing() {
    let mut master = in_contact(1, Service::CoSim);
    let model = master.scene.model.clone();
    let good = master.host.snapshot(&model);
    let before = master.host.clone();
    for at in 0..good.len() {
        let mut bytes = good.clone();
        bytes[at] ^= 0x41;
        assert!(master.host.restore(&model, &bytes).is_err(), "byte {at}");
        assert!(master.host.restore(&model, &good[..at]).is_err(), "cut at {at}");
    }
    let other = tug_at_a_wall(1.0, 1.0, 0.1).model;
    let mut host = CoSimHost::new(&other, HostSettings::default());
    assert_eq!(host.restore(&other, &good), Err(RestoreError::OtherModel));
    assert_eq!(host, CoSimHost::new(&other, HostSettings::default()));
    let of_memory = master.host.memory().snapshot();
    assert_eq!(master.host.restore(&model, &of_memory), Err(RestoreError::NotASnapshot));
    assert_eq!(master.host, before);
}
