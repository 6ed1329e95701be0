//! Islands: what touches in several of them, and what they leave in the order of the memory.

mod support;

use fenderline_contact::{
    Body, BodyId, BodyState, Event, EventKind, Memory, Mobility, Model, Workspace, Wrench, advance,
    advance_in_place, vec2,
};
use support::harbour::{PAPER, at, body, model};
use support::shapes::{points, rectangle};

const STEP_S: f64 = 0.1;

/// Tugs with one side against a quay, 60 m apart, all at rest; the quay last.
fn tugs_at_a_quay(count: u64) -> (Model, Vec<BodyState>) {
    let mut builder = Model::builder();
    let mut states = Vec::new();
    for number in 0..count {
        builder.body(body(number, &rectangle(24.0, 9.0), true));
        states.push(at(60.0 * number as f64, -4.45, 0.0));
    }
    let quay = points(&[(-20.0, 0.0), (400.0, 0.0), (400.0, 20.0), (-20.0, 20.0)]);
    builder.body(body(100, &quay, false));
    states.push(at(0.0, 0.0, 0.0));
    let material = builder.material(PAPER);
    builder.all_other_pairs(material);
    (builder.build().expect("a good model"), states)
}

/// The same with a second quay on their other side; the quays' keys are lower than the tugs', so that the
/// islands are not in the order of the pairs.
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

/// The quay is put elsewhere along her own side: her three contacts look the same, and begin anew.
fn put_the_quay_elsewhere(run: &mut Run) {
    run.states[3].position_m.x -= 60.0;
    let events = run.step();
    assert_eq!(count(events, EventKind::Teleported), 1);
    assert_eq!(count(events, EventKind::ContactEnded), 3);
    assert_eq!(count(events, EventKind::ContactBegan), 3);
    assert_eq!(run.step(), []);
}

/// The first island alone knew that the quay had jumped; the other tugs kept their memory.
#[test]
fn a_quay_that_is_put_elsewhere_starts_the_contacts_of_all_islands_afresh() {
    let mut run = Run::new(tugs_at_a_quay(3));
    assert_eq!(count(run.step(), EventKind::ContactBegan), 3);
    assert_eq!(run.step(), []);
    put_the_quay_elsewhere(&mut run);
}

/// Neither did islands that are not in the order of the pairs.
#[test]
fn a_quay_that_is_put_elsewhere_leaves_the_contacts_with_another_alone() {
    let mut run = Run::new(tugs_between_quays(3));
    assert_eq!(count(run.step(), EventKind::ContactBegan), 6);
    assert_eq!(run.step(), []);
    put_the_quay_elsewhere(&mut run);
    // Both quays away; but for the end of one, at which the first tug begins anew.
    run.states[3].position_m.x -= 340.0;
    run.states[4].position_m.x -= 5000.0;
    assert_eq!(count(run.step(), EventKind::ContactEnded), 6);
}

/// A contact whose pair was no longer near was told to have ended only where there was no other island.
#[test]
fn a_contact_ends_wherever_its_body_is_put() {
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

/// Neighbours that need as many sub-steps go together; each comes to where it would come to alone.
#[test]
fn an_island_comes_to_the_same_bits_whatever_its_neighbours_need() {
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

/// A quay that is shown with a speed went once for each group of islands that need as many sub-steps.
#[test]
fn a_quay_that_moves_goes_once_however_its_islands_go() {
    let after = |fast_mps: f64| {
        let mut run = Run::new(tugs_at_a_quay(3));
        run.states[3].velocity_mps = vec2(0.2, -0.3);
        run.states[3].yaw_rate_radps = 1e-3;
        // Another number of sub-steps for the first of them.
        run.states[0].velocity_mps.y = fast_mps;
        run.step();
        (run.states.clone(), run.work.displacements()[3])
    };
    let (alike, moved) = after(0.0);
    let (apart, moved_apart) = after(40.0);
    let went_m = vec2(0.2, -0.3) * STEP_S;
    for (state, motion) in [(alike[3], moved), (apart[3], moved_apart)] {
        // To rounding: sub-steps add up.
        assert!((state.position_m - went_m).length() < 1e-15, "{state:?}");
        assert!((motion.translation_m - went_m).length() < 1e-15, "{motion:?}");
        assert!((state.heading_rad - 1e-4).abs() < 1e-18);
    }
    assert_eq!(alike[1..3], apart[1..3]);
}

/// It was refused for most of these headings: momenta that turn with their bodies did so ever faster.
#[test]
fn a_step_of_days_within_a_contact_is_finite() {
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

/// What next to no mass does under the largest of loads is no number.
#[test]
fn a_step_that_overflows_is_refused() {
    let mobility = Mobility::Free { mass_kg: 1e-300, yaw_inertia_kgm2: 5e7 };
    let bodies = [0, 1].map(|key| Body { mobility, ..body(key, &rectangle(20.0, 8.0), true) });
    let mut run =
        Run::new((model(bodies.to_vec(), PAPER), vec![at(0.0, 0.0, 0.0), at(0.0, 50.0, 0.0)]));
    run.step();
    let before = run.memory.snapshot();
    let Run { model, memory, work, states } = &mut run;
    let shown = states.clone();
    let loads = [Wrench { force_n: vec2(1e15, 0.0), moment_nm: 0.0 }; 2];
    let error = advance_in_place(model, memory, work, states, &loads, STEP_S).expect_err("too far");
    assert!(error.to_string().contains("overflows"), "{error}");
    assert_eq!((memory.snapshot(), &*states), (before, &shown));
    let again = advance(model, memory, work, states, &loads, STEP_S).expect_err("as before");
    assert_eq!(again.to_string(), error.to_string());
}

/// The second of two islands that are not in the order of the pairs met a quay that moves where the first had
/// left it, at the end of the step.
#[test]
fn a_quay_that_moves_is_met_where_it_was_shown_by_every_island() {
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

/// A quay that is shown with a speed went on only in those steps in which some body was near.
#[test]
fn a_quay_that_moves_goes_on_with_nothing_near() {
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
