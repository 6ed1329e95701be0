//! The greatest wrench within a step, beside its mean.

#[allow(dead_code, reason = "each test uses its own part of the master")]
mod master;

use fenderline_contact::{
    Body, BodyId, BodyState, DirectHost, HostWorkspace, Memory, Mobility, Model, Pair, Vec2,
    Workspace, Wrench, advance, vec2,
};
use master::{rectangle, rubber, tug_at_a_wall};

/// v √(k m) of the tug at 0.5 m/s, against 6.5 MN/m (N).
fn peak_of_the_tug_n() -> f64 {
    0.5 * (6.5e6_f64 * 1e6).sqrt()
}

/// A hit of half a second within a step of 4 s: its mean is next to nothing.
#[test]
fn a_hit_within_one_step_has_its_peak_told_beside_its_mean() {
    let story = tug_at_a_wall(1.0, 0.5, 1.0);
    let (mut memory, mut work) = (Memory::new(&story.model), Workspace::new(&story.model));
    advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, 4.0).unwrap();
    let mut peaks = Vec::new();
    work.peak_wrenches_into(&mut peaks);
    let (mean, peak) = (work.wrenches()[0].force_n, peaks[0].force_n);
    // 1 m/s of change of 1000 t in 4 s.
    assert!((mean.x + 0.25e6).abs() < 0.01e6, "{mean:?}");
    assert!((peak.x / -peak_of_the_tug_n() - 1.0).abs() < 0.01, "{peak:?}");
    assert!((peaks[1].force_n + peak).length() < 1.0, "{peaks:?}");
    // A pause tells the same again.
    let (states, before) = (work.states_after().to_vec(), peaks.clone());
    advance(&story.model, &mut memory, &mut work, &states, &story.loads, 0.0).unwrap();
    work.peak_wrenches_into(&mut peaks);
    assert_eq!(peaks, before);
}

#[test]
fn a_direct_host_gets_the_peak_too_and_moves_by_the_mean() {
    let story = tug_at_a_wall(1.0, 0.5, 1.0);
    let (mut host, mut work) = (DirectHost::new(&story.model), HostWorkspace::new(&story.model));
    let no_step = host.step(&story.model, &mut work, &story.states, &story.loads, 0.0);
    no_step.expect("a pause");
    assert_eq!(work.peak_wrenches(), &[Wrench::default(); 2]);
    host.step(&story.model, &mut work, &story.states, &story.loads, 4.0).expect("a good step");
    let peak_n = work.peak_wrenches()[0].force_n.x;
    assert!((peak_n / -peak_of_the_tug_n() - 1.0).abs() < 0.01, "{peak_n} N");
    assert!(work.wrenches()[0].force_n.x > -0.3e6, "{:?}", work.wrenches());
}

/// In one sub-step there is nothing to choose from.
#[test]
fn the_peak_of_a_short_step_is_its_mean_to_the_bit() {
    let mut story = tug_at_a_wall(0.0, 0.5, 0.5);
    story.states[0].position_m.x = 0.05;
    let (mut memory, mut work) = (Memory::new(&story.model), Workspace::new(&story.model));
    let mut peaks = Vec::new();
    for _ in 0..30 {
        advance(&story.model, &mut memory, &mut work, &story.states, &story.loads, 0.01).unwrap();
        work.peak_wrenches_into(&mut peaks);
        assert_eq!(peaks, work.wrenches());
        story.states.copy_from_slice(work.states_after());
    }
}

/// Two barges against one quay, of which the light one needs more sub-steps: nobody knows when both are worst, so the
/// quay is told of both at one time.
#[test]
fn a_quay_that_two_barges_hit_is_told_of_both_their_peaks() {
    let free = |mass_kg: f64| Mobility::Free { mass_kg, yaw_inertia_kgm2: mass_kg * 100.0 };
    let bodies = [
        ("light", rectangle(20.0, 20.0), free(2e5), vec2(-30.5, -60.0)),
        ("quay", rectangle(40.0, 400.0), Mobility::Fixed, Vec2::ZERO),
        ("heavy", rectangle(20.0, 20.0), free(2e7), vec2(-30.5, 60.0)),
    ];
    let mut builder = Model::builder();
    let mut states = Vec::new();
    for (key, (name, outline, mobility, position_m)) in (0..).zip(bodies) {
        builder.body(Body { name: name.into(), key, outline, mobility });
        let velocity_mps = if mobility == Mobility::Fixed { Vec2::ZERO } else { vec2(0.5, 0.0) };
        states.push(BodyState { position_m, velocity_mps, ..BodyState::default() });
    }
    let material = builder.material(rubber(500e3, 0.5, 0.0));
    for barge in [0, 2] {
        builder.pair(Pair { bodies: [BodyId(barge), BodyId(1)], material });
    }
    let model = builder.build().expect("a good model");
    let loads = [Wrench::default(); 3];
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    advance(&model, &mut memory, &mut work, &states, &loads, 4.0).unwrap();
    let mut peaks = Vec::new();
    work.peak_wrenches_into(&mut peaks);
    for (barge, mass_kg) in [(0, 2e5_f64), (2, 2e7)] {
        let right_n = 0.5 * (10e6 * mass_kg).sqrt();
        let peak_n = -peaks[barge].force_n.x;
        assert!((peak_n / right_n - 1.0).abs() < 0.02, "{barge}: {peak_n} N, not {right_n} N");
    }
    let both_n = -(peaks[0].force_n + peaks[2].force_n).x;
    assert!((peaks[1].force_n.x / both_n - 1.0).abs() < 1e-9, "{peaks:?}");
}
