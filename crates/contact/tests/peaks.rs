//! The largest wrench within a step, and the mean wrench.

#[allow(dead_code, reason = "each test uses its own part of the master")]
use crate::master;

use fenderline_contact::{
    Body, BodyId, BodyState, DirectHost, HostWorkspace, Memory, Mobility, Model, Pair, Vec2,
    Workspace, Wrench, advance, vec2,
};
use master::{rectangle, rubber, tug_at_a_wall};

/// v √(k m) of the tug at 0.5 m/s against 6.5 MN/m (N).
fn peak_of_the_tug_n() -> f64 {
    0.5 * (6.5e6_f64 * 1e6).sqrt()
}

/// An impact lasts half a second within a step of 4 s, so the mean is small.
#[test]
fn the_peak_of_an_impact_within_a_step_is_reported_beside_its_mean() {
    let scene = tug_at_a_wall(1.0, 0.5, 1.0);
    let (mut memory, mut work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
    advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, 4.0).unwrap();
    let mut peaks = Vec::new();
    work.peak_wrenches_into(&mut peaks);
    let (mean, peak) = (work.wrenches()[0].force_n, peaks[0].force_n);
    // 1000 t change their speed by 1 m/s in 4 s.
    assert!((mean.x + 0.25e6).abs() < 0.01e6, "{mean:?}");
    assert!((peak.x / -peak_of_the_tug_n() - 1.0).abs() < 0.01, "{peak:?}");
    assert!((peaks[1].force_n + peak).length() < 1.0, "{peaks:?}");
    // A pause reports the same values again.
    let (states, before) = (work.states_after().to_vec(), peaks.clone());
    advance(&scene.model, &mut memory, &mut work, &states, &scene.loads, 0.0).unwrap();
    work.peak_wrenches_into(&mut peaks);
    assert_eq!(peaks, before);
}

#[test]
fn a_direct_host_gets_the_peak_and_moves_by_the_mean() {
    let scene = tug_at_a_wall(1.0, 0.5, 1.0);
    let (mut host, mut work) = (DirectHost::new(&scene.model), HostWorkspace::new(&scene.model));
    let no_step = host.step(&scene.model, &mut work, &scene.states, &scene.loads, 0.0);
    no_step.expect("a pause");
    assert_eq!(work.peak_wrenches(), &[Wrench::default(); 2]);
    host.step(&scene.model, &mut work, &scene.states, &scene.loads, 4.0).expect("a good step");
    let peak_n = work.peak_wrenches()[0].force_n.x;
    assert!((peak_n / -peak_of_the_tug_n() - 1.0).abs() < 0.01, "{peak_n} N");
    assert!(work.wrenches()[0].force_n.x > -0.3e6, "{:?}", work.wrenches());
}

/// With a single sub-step the peak is the mean.
#[test]
fn the_peak_of_a_short_step_equals_its_mean_bit_for_bit() {
    let mut scene = tug_at_a_wall(0.0, 0.5, 0.5);
    scene.states[0].position_m.x = 0.05;
    let (mut memory, mut work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
    let mut peaks = Vec::new();
    for _ in 0..30 {
        advance(&scene.model, &mut memory, &mut work, &scene.states, &scene.loads, 0.01).unwrap();
        work.peak_wrenches_into(&mut peaks);
        assert_eq!(peaks, work.wrenches());
        scene.states.copy_from_slice(work.states_after());
    }
}

/// Two barges lie against one quay, and the light barge needs more sub-steps. The times of their peaks are not
/// compared, so the quay's peak is the sum of both peaks.
#[test]
fn the_peak_on_a_quay_is_the_sum_of_two_barges_peaks() {
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
