//! A restored snapshot continues a run with the same bits. A workspace has no influence on the run.

use crate::small_host;

use fenderline_contact::{BodyState, Memory, Workspace, Wrench, advance};
use small_host::Host;
use small_host::scenes::tug_push;

/// A run that continues from the middle of a contact.
struct Engine {
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
}

impl Engine {
    fn at(host: &Host, memory: Memory) -> Engine {
        let states = host.states.clone();
        Engine { memory, work: Workspace::new(&host.model), states }
    }

    fn step(&mut self, host: &Host, loads: &[Wrench]) {
        let Engine { memory, work, states } = self;
        let step_s = host.scene.step_s;
        advance(&host.model, memory, work, states, loads, step_s).unwrap();
        states.copy_from_slice(work.states_after());
    }
}

#[test]
fn a_snapshot_during_contact_replays_a_thousand_steps_with_any_workspace() {
    for step_s in [0.05, 0.5] {
        let mut host = Host::new(tug_push(step_s));
        while host.time_s() < 6.0 {
            host.step();
        }
        assert!(host.memory.touching_patches() >= 5, "taken in mid-contact");
        let model = &host.model;
        let mut restored = Memory::new(model);
        restored.restore(model, &host.memory.snapshot()).unwrap();
        assert_eq!(restored, host.memory);
        let loads = host.scene.wrenches_of_loads();
        let mut continued = Engine::at(&host, host.memory.clone());
        let mut replayed = Engine::at(&host, restored);
        let mut fresh = Engine::at(&host, host.memory.clone());
        for _ in 0..1000 {
            continued.step(&host, &loads);
            replayed.step(&host, &loads);
            fresh.work = Workspace::new(model);
            fresh.step(&host, &loads);
            assert_eq!(continued.states, replayed.states);
            assert_eq!(continued.states, fresh.states);
            assert_eq!(continued.work.contacts(), replayed.work.contacts());
            assert_eq!(continued.work.contacts(), fresh.work.contacts());
        }
        assert_eq!(continued.memory.snapshot(), replayed.memory.snapshot());
        assert_eq!(continued.memory.snapshot(), fresh.memory.snapshot());
        assert!(continued.memory.touching_patches() >= 5, "still in contact");
    }
}
