//! A run gives the same bits on any number of threads.

use crate::support;

use fenderline_contact::BodyState;
use fenderline_sim::{Setup, Simulation};
use support::scenes::{oblique_berthing, tug_impact, tug_push};

/// Runs with and without chords and faces, friction, loads and added mass, at several time steps.
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

/// The result of a run: states, memory and energies.
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
