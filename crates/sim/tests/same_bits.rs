//! The same bits on any number of threads, from a restored snapshot and with a fresh workspace.

mod support;

use fenderline_contact::{BodyState, Memory, Workspace, Wrench, advance};
use fenderline_sim::{Setup, Simulation};
use support::scenes::{oblique_berthing, tug_impact, tug_push};

/// Runs that differ in all that matters: chords and faces, friction, loads, added mass, time steps.
fn scenes() -> Vec<Setup> {
    let mut scenes = vec![];
    for step_s in [0.1, 0.5, 2.0] {
        for k in 0..3 {
            let mut berthing = oblique_berthing(step_s);
            berthing.bodies[1].velocity.yaw_radps = 1e-4 * f64::from(k);
            let mut push = tug_push(step_s);
            push.duration_s = 60.0;
            push.bodies[2].heading_rad += 0.05 * f64::from(k);
            scenes.extend([tug_impact(2.0, 20.0 * f64::from(k), step_s), berthing, push]);
        }
    }
    scenes
}

/// Everything that a run leaves: its states, its memory and its energies.
fn end_of(setup: &Setup) -> (Vec<BodyState>, Vec<u8>, String) {
    let mut simulation = Simulation::new(setup.clone()).unwrap();
    while !simulation.is_done() {
        simulation.step().unwrap();
    }
    // `{:?}` of a float is its shortest text that reads back the same bits.
    let energy = format!("{:?}", simulation.energy());
    (simulation.states().to_vec(), simulation.memory().snapshot(), energy)
}

#[test]
fn one_two_and_eight_threads_give_the_same_bits() {
    let scenes = scenes();
    let serial: Vec<_> = scenes.iter().map(end_of).collect();
    for threads in [2, 8] {
        std::thread::scope(|scope| {
            let (scenes, serial) = (&scenes, &serial);
            for thread in 0..threads {
                scope.spawn(move || {
                    for (scene, alone) in scenes.iter().zip(serial).skip(thread).step_by(threads) {
                        assert_eq!(end_of(scene), *alone, "{threads} threads");
                    }
                });
            }
        });
    }
}

/// Loads of the first step on, as the simulation gives them; none of these scenes' hulls turns much.
fn loads_of(simulation: &Simulation) -> Vec<Wrench> {
    let mut loads = vec![Wrench::default(); simulation.states().len()];
    for load in &simulation.setup().loads {
        loads[load.body].force_n += load.force_n;
    }
    loads
}

/// The engine alone, stepped on from mid-contact.
struct Engine {
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
}

impl Engine {
    fn at(simulation: &Simulation, memory: Memory) -> Engine {
        let states = simulation.states().to_vec();
        Engine { memory, work: Workspace::new(simulation.model()), states }
    }

    fn step(&mut self, simulation: &Simulation, loads: &[Wrench]) {
        let Engine { memory, work, states } = self;
        let step_s = simulation.setup().step_s;
        advance(simulation.model(), memory, work, states, loads, step_s).unwrap();
        states.copy_from_slice(work.states_after());
    }
}

#[test]
fn a_snapshot_in_mid_contact_on_faces_replays_a_thousand_steps_and_no_workspace_matters() {
    for step_s in [0.05, 0.5] {
        let mut simulation = Simulation::new(tug_push(step_s)).unwrap();
        while simulation.time_s() < 6.0 {
            simulation.step().unwrap();
        }
        assert!(simulation.memory().touching_patches() >= 5, "taken in mid-contact");
        let model = simulation.model();
        let mut restored = Memory::new(model);
        restored.restore(model, &simulation.memory().snapshot()).unwrap();
        assert_eq!(restored, *simulation.memory());
        let loads = loads_of(&simulation);
        let mut went_on = Engine::at(&simulation, simulation.memory().clone());
        let mut replayed = Engine::at(&simulation, restored);
        let mut fresh = Engine::at(&simulation, simulation.memory().clone());
        for _ in 0..1000 {
            went_on.step(&simulation, &loads);
            replayed.step(&simulation, &loads);
            fresh.work = Workspace::new(model);
            fresh.step(&simulation, &loads);
            assert_eq!(went_on.states, replayed.states);
            assert_eq!(went_on.states, fresh.states);
            assert_eq!(went_on.work.contacts(), replayed.work.contacts());
            assert_eq!(went_on.work.contacts(), fresh.work.contacts());
        }
        assert_eq!(went_on.memory.snapshot(), replayed.memory.snapshot());
        assert_eq!(went_on.memory.snapshot(), fresh.memory.snapshot());
        assert!(went_on.memory.touching_patches() >= 5, "still in contact");
    }
}
