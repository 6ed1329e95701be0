//! Snapshots are saved during contact and replayed bit for bit. Damaged snapshots and snapshots of another model are
//! refused and change nothing.

#[allow(dead_code, reason = "each test uses its own part of the scene")]
use crate::scene;

use fenderline_contact::hash::Fnv1a;
use fenderline_contact::{
    BodyState, Contact, Friction, Memory, Model, RestoreError, SNAPSHOT_VERSION, Workspace, Wrench,
    step, vec2,
};

const STEP_S: f64 = 0.1;
const STIFFNESS_NPM2: f64 = 500e3;

/// A ship that berths at 0.2 m/s, turns slightly and slides ahead. Tugs hold her to the fenders.
struct Run {
    model: Model,
    memory: Memory,
    work: Workspace,
    ship: BodyState,
}

impl Run {
    fn new() -> Run {
        let model = scene::berth(STIFFNESS_NPM2);
        let ship = BodyState {
            position_m: vec2(0.0, scene::TOUCH_EAST_M - 0.2),
            heading_rad: 1e-3,
            velocity_mps: vec2(0.1, 0.2),
            yaw_rate_radps: -1e-5,
        };
        Run { memory: Memory::new(&model), work: Workspace::new(&model), model, ship }
    }

    fn step(&mut self) {
        let states = scene::states(self.ship);
        step(&self.model, &mut self.memory, &mut self.work, &states, STEP_S).expect("good states");
        scene::advance(&mut self.ship, &self.work, vec2(20e3, 300e3), STEP_S);
    }

    /// Contacts and wrenches of the next `count` steps.
    fn play(&mut self, count: usize) -> Vec<(Vec<Contact>, Vec<Wrench>)> {
        (0..count)
            .map(|_| {
                self.step();
                (self.work.contacts().to_vec(), self.work.wrenches().to_vec())
            })
            .collect()
    }
}

/// A run during contact, with shear.
fn in_contact() -> Run {
    let mut run = Run::new();
    run.play(80);
    assert!(run.work.contacts().len() >= 4, "the ship lies at several fenders");
    assert!(run.work.contacts().iter().any(|c| c.shear_m.abs() > 1e-3), "with shear");
    run
}

#[test]
fn a_restored_run_continues_bit_for_bit() {
    let mut run = in_contact();
    let (saved, ship) = (run.memory.snapshot(), run.ship);
    let first = run.play(1_000);
    let frictions: Vec<Friction> =
        first.iter().flat_map(|(contacts, _)| contacts.iter().map(|c| c.friction)).collect();
    assert!(frictions.contains(&Friction::Stick) && frictions.contains(&Friction::Slip));

    // Restores into a new memory, and into a memory that was used further. Each has a new workspace.
    for mut memory in [Memory::new(&run.model), run.memory.clone()] {
        memory.restore(&run.model, &saved).expect("a good snapshot");
        assert_eq!(memory.snapshot(), saved);
        let model = run.model.clone();
        let mut again = Run { work: Workspace::new(&model), model, memory, ship };
        let second = again.play(1_000);
        // Debug text distinguishes −0 from 0, and shows every bit of a number.
        for (index, (one, two)) in first.iter().zip(&second).enumerate() {
            assert_eq!(format!("{one:?}"), format!("{two:?}"), "step {index}");
        }
        assert_eq!(again.memory.snapshot(), run.memory.snapshot());
    }
}

#[test]
fn a_snapshot_before_the_first_step_is_valid() {
    let run = Run::new();
    let mut memory = in_contact().memory;
    memory.restore(&run.model, &run.memory.snapshot()).expect("a good snapshot");
    assert_eq!(memory, run.memory);
}

/// Checks that restoring `bytes` over a memory in use fails and changes nothing.
fn refused(run: &mut Run, bytes: &[u8], before: &[u8]) -> RestoreError {
    let error = run.memory.restore(&run.model, bytes).expect_err("a bad snapshot");
    assert_eq!(run.memory.snapshot(), before, "{error}: memory changed");
    error
}

#[test]
fn every_truncation_is_refused() {
    let mut run = in_contact();
    let saved = run.memory.snapshot();
    run.play(3);
    let before = run.memory.snapshot();
    for length in 0..saved.len() {
        let error = refused(&mut run, &saved[..length], &before);
        assert_eq!(error, RestoreError::Length, "cut to {length} bytes");
    }
    let longer = [saved.as_slice(), &[0]].concat();
    assert_eq!(refused(&mut run, &longer, &before), RestoreError::Length);
    assert_eq!(refused(&mut run, b"not a snapshot at all", &before), RestoreError::NotASnapshot);
}

#[test]
fn every_flipped_bit_is_refused() {
    let mut run = in_contact();
    let mut bytes = run.memory.snapshot();
    run.play(3);
    let before = run.memory.snapshot();
    for place in 0..bytes.len() {
        for bit in 0..8 {
            bytes[place] ^= 1 << bit;
            refused(&mut run, &bytes, &before);
            bytes[place] ^= 1 << bit;
        }
    }
}

#[test]
fn another_model_and_another_version_are_refused() {
    let mut run = in_contact();
    let before = run.memory.snapshot();
    let other = scene::berth(STIFFNESS_NPM2 * 2.0);
    let foreign = Memory::new(&other).snapshot();
    assert_eq!(refused(&mut run, &foreign, &before), RestoreError::OtherModel);

    let mut newer = before.clone();
    newer[8..12].copy_from_slice(&(SNAPSHOT_VERSION + 1).to_le_bytes());
    let found = SNAPSHOT_VERSION + 1;
    assert_eq!(refused(&mut run, &newer, &before), RestoreError::Version { found });
}

/// A forged snapshot has a valid check sum, but impossible numbers.
#[test]
fn a_forged_snapshot_is_refused() {
    let mut run = in_contact();
    let before = run.memory.snapshot();
    // The numbers are Δt of the last step, at byte 20, and the position in the first state, at byte 56.
    for (place, value) in [
        (20, f64::NAN),
        (20, -0.1),
        (20, f64::MIN_POSITIVE),
        (20, 1e20),
        (56, f64::NAN),
        (56, f64::INFINITY),
        (56, f64::MAX),
    ] {
        let mut forged = before.clone();
        forged[place..place + 8].copy_from_slice(&value.to_le_bytes());
        sum_up(&mut forged);
        let error = refused(&mut run, &forged, &before);
        assert_eq!(error, RestoreError::Content, "{value:e} at byte {place}");
    }
}

/// Writes the check sum FNV-1a at the place that the table of bytes gives.
fn sum_up(bytes: &mut [u8]) {
    let end = bytes.len() - 8;
    let sum = Fnv1a::of(&bytes[..end]);
    bytes[end..].copy_from_slice(&sum.to_le_bytes());
}
