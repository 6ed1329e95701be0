//! Islands: bodies with contacts in several islands, and the order of the memory.

use crate::support;

use fenderline_contact::{
    Body, BodyId, BodyState, Event, EventKind, Material, Memory, Mobility, Model, Workspace,
    Wrench, advance, advance_in_place, vec2,
};
use support::harbour::{PAPER, at, body, model};
use support::shapes::{points, rectangle};

const STEP_S: f64 = 0.1;

/// Tugs with one side against a quay, 60 m apart, all at rest; the quay is the last body.
fn tugs_at_a_quay(count: u64) -> (Model, Vec<BodyState>) {
    tugs_at_a_quay_of(count, PAPER)
}

fn tugs_at_a_quay_of(count: u64, material: Material) -> (Model, Vec<BodyState>) {
    let mut builder = Model::builder();
    let mut states = Vec::new();
    for number in 0..count {
        builder.body(body(number, &rectangle(24.0, 9.0), true));
        states.push(at(60.0 * number as f64, -4.45, 0.0));
    }
    let end_m = 400.0 + 60.0 * count as f64;
    let quay = points(&[(-20.0, 0.0), (end_m, 0.0), (end_m, 20.0), (-20.0, 20.0)]);
    builder.body(body(1000, &quay, false));
    states.push(at(0.0, 0.0, 0.0));
    let material = builder.material(material);
    builder.all_other_pairs(material);
    (builder.build().expect("a good model"), states)
}

/// The same tugs with a second quay on their other side. The keys of the quays are lower than those of the tugs, so
/// that the order of islands differs from the order of pairs.
fn tugs_between_quays(count: u64) -> (Model, Vec<BodyState>) {
    let mut builder = Model::builder();
    let mut states = Vec::new();
    for number in 0..count {
        builder.body(body(10 + number, &rectangle(24.0, 9.0), true));
        states.push(at(60.0 * number as f64, -4.45, 0.0));
    }
    for (key, y_m) in [(0, 0.0), (1, -28.9)] {
        let quay = points(&[(-20.0, 0.0), (400.0, 0.0), (400.0, 20.0), (-20.0, 20.0)]);
        builder.body(body(key, &quay, false));
        states.push(at(0.0, y_m, 0.0));
    }
    let material = builder.material(PAPER);
    builder.all_other_pairs(material);
    (builder.build().expect("a good model"), states)
}

struct Run {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
}

impl Run {
    fn new((model, states): (Model, Vec<BodyState>)) -> Run {
        Run { memory: Memory::new(&model), work: Workspace::new(&model), model, states }
    }

    fn step(&mut self) -> &[Event] {
        let loads = vec![Wrench::default(); self.states.len()];
        let Run { model, memory, work, states } = self;
        advance(model, memory, work, states, &loads, STEP_S).expect("a good step");
        states.copy_from_slice(work.states_after());
        work.events()
    }
}

fn count(events: &[Event], kind: EventKind) -> usize {
    events.iter().filter(|event| event.kind == kind).count()
}

/// Teleports the quay along its side. Its three contacts look the same, but begin anew.
fn teleport_the_quay(run: &mut Run) {
    run.states[3].position_m.x -= 60.0;
    let events = run.step();
    assert_eq!(count(events, EventKind::Teleported), 1);
    assert_eq!(count(events, EventKind::ContactEnded), 3);
    assert_eq!(count(events, EventKind::ContactBegan), 3);
    assert_eq!(run.step(), []);
}

/// Only the first island noticed that the quay was teleported. The other tugs kept their memory.
#[test]
fn a_teleported_quay_begins_the_contacts_of_all_islands_anew() {
    let mut run = Run::new(tugs_at_a_quay(3));
    assert_eq!(count(run.step(), EventKind::ContactBegan), 3);
    assert_eq!(run.step(), []);
    teleport_the_quay(&mut run);
}

/// The same where the order of islands differs from the order of pairs.
#[test]
fn a_teleported_quay_leaves_contacts_with_another_quay_alone() {
    let mut run = Run::new(tugs_between_quays(3));
    assert_eq!(count(run.step(), EventKind::ContactBegan), 6);
    assert_eq!(run.step(), []);
    teleport_the_quay(&mut run);
    // Both quays are moved away, except for the end of one quay. There the first tug's contact begins anew.
    run.states[3].position_m.x -= 340.0;
    run.states[4].position_m.x -= 5000.0;
    assert_eq!(count(run.step(), EventKind::ContactEnded), 6);
}

/// If a pair was no longer near, the end of its contact was reported only if there was no other island.
#[test]
fn a_contact_of_a_teleported_body_ends() {
    for gone in 0..3 {
        let mut run = Run::new(tugs_at_a_quay(3));
        run.step();
        run.states[gone].position_m = vec2(0.0, -5000.0);
        let ended: Vec<Event> = run
            .step()
            .iter()
            .filter(|event| event.kind == EventKind::ContactEnded)
            .copied()
            .collect();
        let bodies = [BodyId(gone as u32), BodyId(3)];
        assert_eq!(ended, [Event { bodies, kind: EventKind::ContactEnded }]);
        assert_eq!(run.work.contacts().len(), 2);
    }
    let mut alone = Run::new(tugs_at_a_quay(1));
    alone.step();
    alone.states[0].position_m = vec2(0.0, -5000.0);
    assert_eq!(count(alone.step(), EventKind::ContactEnded), 1);
}

/// Islands with the same number of sub-steps are stepped together. Each has the result that it has alone.
#[test]
fn an_island_has_the_same_bits_for_any_sub_steps_of_its_neighbours() {
    let after = |speeds_mps: [f64; 3]| {
        let mut run = Run::new(tugs_at_a_quay(3));
        for (state, speed_mps) in run.states.iter_mut().zip(speeds_mps) {
            state.velocity_mps.y = speed_mps;
        }
        for _ in 0..20 {
            run.step();
        }
        (run.states[1], run.memory.snapshot().len())
    };
    let (alone, size) = after([0.0, 0.1, 0.0]);
    for first_mps in [0.0, 0.1, 40.0] {
        for last_mps in [0.0, 0.1, 40.0] {
            let (with_others, _) = after([first_mps, 0.1, last_mps]);
            assert_eq!(with_others, alone, "{first_mps} and {last_mps} m/s");
        }
    }
    assert!(size > 0);
}

/// A quay with a velocity moved once for each group of islands with the same number of sub-steps, and not once in all.
#[test]
fn a_moving_quay_moves_once_for_any_sub_steps_of_its_islands() {
    let after = |fast_mps: f64| {
        let mut run = Run::new(tugs_at_a_quay(3));
        run.states[3].velocity_mps = vec2(0.2, -0.3);
        run.states[3].yaw_rate_radps = 1e-3;
        // The first island has another number of sub-steps.
        run.states[0].velocity_mps.y = fast_mps;
        run.step();
        (run.states.clone(), run.work.displacements()[3])
    };
    let (alike, moved) = after(0.0);
    let (apart, moved_apart) = after(40.0);
    let went_m = vec2(0.2, -0.3) * STEP_S;
    for (state, motion) in [(alike[3], moved), (apart[3], moved_apart)] {
        // The comparison is to rounding, because sub-steps are summed.
        assert!((state.position_m - went_m).length() < 1e-15, "{state:?}");
        assert!((motion.translation_m - went_m).length() < 1e-15, "{motion:?}");
        assert!((state.heading_rad - 1e-4).abs() < 1e-18);
    }
    assert_eq!(alike[1..3], apart[1..3]);
}

/// For most of these headings the step was refused: the rotation of momenta with their bodies diverged.
#[test]
fn a_step_of_days_in_contact_is_finite() {
    let mobility = Mobility::SurgeSway { surge_kg: 1e6, sway_kg: 1.5e6, yaw_inertia_kgm2: 5e7 };
    for angle in 0..60 {
        let bodies = [0, 1].map(|key| Body { mobility, ..body(key, &rectangle(20.0, 8.0), true) });
        let states = vec![at(0.0, 0.0, 0.0), at(0.0, 7.0, 0.0)];
        let mut run = Run::new((model(bodies.to_vec(), PAPER), states));
        run.step();
        run.states[0].velocity_mps = vec2(1.0, 2.0);
        run.states[0].yaw_rate_radps = 0.05;
        run.states[0].heading_rad = 0.1 * f64::from(angle);
        let Run { model, memory, work, states } = &mut run;
        let loads = [Wrench::default(); 2];
        advance_in_place(model, memory, work, states, &loads, 1e6).expect("finite");
        let finite = |s: &BodyState| s.position_m.is_finite() && s.heading_rad.is_finite();
        assert!(states.iter().all(finite));
    }
}

/// The largest load on a mass near zero overflows.
#[test]
fn a_step_that_overflows_is_refused() {
    let mobility = Mobility::Free { mass_kg: 1e-300, yaw_inertia_kgm2: 5e7 };
    let bodies = [0, 1].map(|key| Body { mobility, ..body(key, &rectangle(20.0, 8.0), true) });
    let mut run =
        Run::new((model(bodies.to_vec(), PAPER), vec![at(0.0, 0.0, 0.0), at(0.0, 50.0, 0.0)]));
    run.step();
    let before = run.memory.snapshot();
    let Run { model, memory, work, states } = &mut run;
    let input = states.clone();
    let loads = [Wrench { force_n: vec2(1e15, 0.0), moment_nm: 0.0 }; 2];
    let error = advance_in_place(model, memory, work, states, &loads, STEP_S).expect_err("too far");
    assert!(error.to_string().contains("overflows"), "{error}");
    assert_eq!((memory.snapshot(), &*states), (before, &input));
    let again = advance(model, memory, work, states, &loads, STEP_S).expect_err("as before");
    assert_eq!(again.to_string(), error.to_string());
}

/// If two islands were in another order than the pairs, the second island had the moving quay at the end of the step,
/// where the first island had left it.
#[test]
fn every_island_has_a_moving_quay_at_its_input_position() {
    let pressed = |count: u64| {
        let mut run = Run::new(tugs_between_quays(count));
        for quay in run.states.len() - 2..run.states.len() {
            run.states[quay].velocity_mps = vec2(0.0, -0.5);
        }
        run.step();
        let last = count as usize - 1;
        let contacts = run.work.contacts().iter().filter(|c| c.body_1 == BodyId(last as u32));
        let areas_m2: Vec<f64> = contacts.map(|contact| contact.area_m2).collect();
        (areas_m2, run.work.states_after()[last].velocity_mps)
    };
    let (alone, among_others) = (pressed(1), pressed(3));
    assert_eq!(alone.0.len(), 2, "both quays");
    assert!((alone.1 - among_others.1).length() < 1e-9, "{alone:?} {among_others:?}");
    for (alone_m2, other_m2) in alone.0.iter().zip(&among_others.0) {
        assert!((alone_m2 - other_m2).abs() < 1e-9, "{alone:?} {among_others:?}");
    }
}

/// In a step of one sub-step the reported displacement of a quay with a velocity was that of h/2 + 1 s.
#[test]
fn a_moving_quay_reports_where_it_went_in_one_sub_step() {
    let soft = Material { stiffness_npm2: 1e3, ..PAPER };
    let mut run = Run::new(tugs_at_a_quay_of(1, soft));
    run.states[1].velocity_mps = vec2(0.2, -0.3);
    run.step();
    let motion = run.work.displacements()[1];
    assert_eq!(run.work.contacts().len(), 1);
    assert!((motion.translation_m - vec2(0.2, -0.3) * STEP_S).length() < 1e-15, "{motion:?}");
}

/// A step takes islands with one sub-step in groups. The results do not show it.
#[test]
fn a_tug_among_many_has_the_bits_that_it_has_alone() {
    let soft = Material { stiffness_npm2: 1e3, ..PAPER };
    let after = |count: usize| {
        let mut run = Run::new(tugs_at_a_quay_of(count as u64, soft));
        let step = |run: &mut Run| {
            run.step();
            let before_m = run.states[count].position_m;
            assert_eq!(before_m, vec2(0.0, 0.0));
        };
        (0..5).for_each(|_| step(&mut run));
        // One contact ends in the midst of a group, and one begins.
        run.states[0].position_m.y -= 1.0;
        run.step();
        run.states[0].position_m.y += 1.0;
        (0..5).for_each(|_| step(&mut run));
        let contacts = run.work.contacts();
        assert_eq!(contacts.len(), count);
        (run.states[..2].to_vec(), contacts[..2].to_vec())
    };
    let ((few, few_contacts), (many, many_contacts)) = (after(2), after(290));
    assert_eq!(few, many);
    for (one, other) in few_contacts.iter().zip(&many_contacts) {
        assert_eq!(one.impulse, other.impulse);
    }
}

/// A quay with a velocity moved only in steps in which some body was near.
#[test]
fn a_moving_quay_moves_with_no_body_near() {
    for away_m in [0.0, 5000.0] {
        let mut run = Run::new(tugs_at_a_quay(1));
        run.states[0].position_m.y -= away_m;
        run.states[1].velocity_mps = vec2(0.2, -0.3);
        run.states[1].yaw_rate_radps = 1e-3;
        run.step();
        let went_m = vec2(0.2, -0.3) * STEP_S;
        let (state, motion) = (run.states[1], run.work.displacements()[1]);
        assert!((state.position_m - went_m).length() < 1e-15, "{away_m} m: {state:?}");
        assert!((motion.translation_m - went_m).length() < 1e-15, "{away_m} m: {motion:?}");
        assert!((state.heading_rad - 1e-4).abs() < 1e-18);
    }
}
