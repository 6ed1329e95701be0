//! The content of a workspace affects speed, but never results. A run with a new workspace in each step gives the same
//! bits as a run that keeps its workspace. A run without contact reports gives the same bits too.

use crate::support;

use fenderline_contact::{
    BodyId, BodyState, Contact, Event, Fender, FenderLaw, Material, MaterialId, Memory, Mobility,
    Model, ReactionFactors, Vec2, Workspace, Wrench, advance, advance_from_engine_states,
    advance_in_place, step, vec2,
};
use support::harbour::{PAPER, at, body};
use support::shapes::{ellipse, hull, points, rectangle, stepped_ship};

const STEP_S: f64 = 0.25;
const STEPS: usize = 120;

/// Drifting tugs, barges and stepped ships in front of a quay with fenders, close to each other.
fn crowd() -> (Model, Vec<BodyState>, Vec<Wrench>) {
    let shapes = [rectangle(24.0, 9.0), hull(40.0, 11.0, 12), ellipse(20.0, 8.0, 20, &[])];
    let mut builder = Model::builder();
    let mut states = Vec::new();
    let mut loads = Vec::new();
    let quay = points(&[(-200.0, 0.0), (200.0, 0.0), (200.0, 20.0), (-200.0, 20.0)]);
    let quay = builder.body(body(500, &quay, false));
    states.push(at(0.0, 130.0, 0.0));
    loads.push(Wrench::default());
    for number in 0..30_u64 {
        let shape = if number % 10 == 7 { &stepped_ship() } else { &shapes[number as usize % 3] };
        let free = number % 11 != 5;
        // The order of the keys differs from the order of the bodies.
        builder.body(body((number * 7) % 31, shape, free));
        let (row, column) = ((number / 6) as f64, (number % 6) as f64);
        let mut state =
            at(-130.0 + 45.0 * column + 7.0 * row, -90.0 + 45.0 * row, 0.4 * row + 0.9 * column);
        if free {
            state.velocity_mps = vec2(0.7 - 0.3 * row, 2.0 - 0.6 * column);
            state.yaw_rate_radps = 0.02 * (column - row);
        }
        states.push(state);
        loads.push(Wrench { force_n: vec2(0.0, 2e5), moment_nm: 1e5 * (column - 2.0) });
    }
    let material = builder.material(Material { damping_nspm2: 2e4, ..PAPER });
    for number in 0..8_u64 {
        builder.fender(fender(quay, material, number));
    }
    builder.all_other_pairs(material);
    (builder.build().expect("a good model"), states, loads)
}

fn fender(body: BodyId, material: MaterialId, key: u64) -> Fender {
    Fender {
        name: format!("fender {key}"),
        key,
        body,
        position_m: vec2(-140.0 + 40.0 * key as f64, 0.0),
        facing_rad: -0.5 * core::f64::consts::PI,
        width_m: 3.0,
        projection_m: 1.5,
        law: FenderLaw::linear(2e6),
        unloading: None,
        material,
        rated_deflection_m: 0.9,
        stop: None,
        factors: ReactionFactors::default(),
        panel: None,
    }
}

/// All results of a step.
type Found = (Vec<Contact>, Vec<Wrench>, Vec<Event>, Vec<BodyState>, Vec<u8>);

/// A step, and the motion of the states.
type OneStep = fn(&Model, &mut Memory, &mut Workspace, &mut [BodyState], &[Wrench]);

/// How a run uses its workspace.
#[derive(Clone, Copy, PartialEq)]
enum Work {
    Kept,
    New,
    /// The workspace is kept, and there are no contact reports.
    Brief,
}

/// The results of all steps of a run.
fn run(one_step: OneStep, with: Work) -> Vec<Found> {
    let (model, mut states, loads) = crowd();
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    work.report_contacts(with != Work::Brief);
    (0..STEPS)
        .map(|_| {
            if with == Work::New {
                work = Workspace::new(&model);
            }
            one_step(&model, &mut memory, &mut work, &mut states, &loads);
            let (contacts, wrenches) = (work.contacts().to_vec(), work.wrenches().to_vec());
            (contacts, wrenches, work.events().to_vec(), states.clone(), memory.snapshot())
        })
        .collect()
}

fn same_bits(one_step: OneStep) {
    let (kept, renewed) = (run(one_step, Work::Kept), run(one_step, Work::New));
    for (index, (one, other)) in kept.iter().zip(&renewed).enumerate() {
        // Debug text shows every bit of a float, except for NaN.
        assert_eq!(format!("{one:?}"), format!("{other:?}"), "step {index}");
    }
    let contacts: usize = kept.iter().map(|found| found.0.len()).sum();
    let on_fenders = kept.iter().flat_map(|found| &found.0).filter(|c| c.fender.is_some()).count();
    assert!(contacts > 8 * STEPS && on_fenders > STEPS, "{contacts} {on_fenders}");
}

fn same_bits_but_for_contacts(one_step: OneStep) {
    let (results, brief) = (run(one_step, Work::Kept), run(one_step, Work::Brief));
    for (index, (mut results, brief)) in results.into_iter().zip(brief).enumerate() {
        results.0.clear();
        assert_eq!(format!("{results:?}"), format!("{brief:?}"), "step {index}");
    }
}

fn by_the_papers_method(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &mut [BodyState],
    loads: &[Wrench],
) {
    step(model, memory, work, states, STEP_S).expect("good states");
    let floats = |index: usize| model.bodies()[index].mobility != Mobility::Fixed;
    for (index, state) in states.iter_mut().enumerate().filter(|(index, _)| floats(*index)) {
        let (push, load) = (work.wrenches()[index], loads[index]);
        let more_mps: Vec2 = (push.force_n + load.force_n) * (STEP_S / 1e6);
        state.velocity_mps += more_mps;
        state.yaw_rate_radps += (push.moment_nm + load.moment_nm) * (STEP_S / 6e7);
        state.position_m += state.velocity_mps * STEP_S;
        state.heading_rad += state.yaw_rate_radps * STEP_S;
    }
}

fn by_the_coupled_method(
    model: &Model,
    memory: &mut Memory,
    work: &mut Workspace,
    states: &mut [BodyState],
    loads: &[Wrench],
) {
    advance_from_engine_states(model, memory, work, states, loads, STEP_S)
        .expect("good states and loads");
    states.copy_from_slice(work.states_after());
}

#[test]
fn a_new_workspace_in_every_step_changes_no_bit_of_the_papers_method() {
    same_bits(by_the_papers_method);
}

#[test]
fn a_new_workspace_in_every_step_changes_no_bit_of_the_coupled_method() {
    same_bits(by_the_coupled_method);
}

#[test]
fn missing_contact_reports_change_no_bit_of_the_papers_method() {
    same_bits_but_for_contacts(by_the_papers_method);
}

#[test]
fn missing_contact_reports_change_no_bit_of_the_coupled_method() {
    same_bits_but_for_contacts(by_the_coupled_method);
}

/// Moves the fixed bodies. Body 6 and the quay are at rest, move for a while, are at rest again, and are teleported.
fn move_fixed_bodies(states: &mut [BodyState], index: usize) {
    let goes_mps = if (30..60).contains(&(index % 80)) { 0.3 } else { 0.0 };
    for body in [0, 6] {
        states[body].velocity_mps = vec2(0.0, -goes_mps);
        states[body].position_m.y -= goes_mps * STEP_S;
    }
    if index % 7 == 6 {
        states[6].position_m.x += 3.0;
        states[0].heading_rad += 0.01;
    }
}

/// Other uses of a workspace: with the paper's method, with the fixed bodies at other positions, and in a step that
/// fails after some bodies were processed.
fn use_otherwise(
    model: &Model,
    other: &mut Memory,
    work: &mut Workspace,
    states: &[BodyState],
    loads: &[Wrench],
    index: usize,
) {
    let mut states = states.to_vec();
    if index.is_multiple_of(2) {
        states[0].position_m.y -= 1.0;
        states[6].position_m.x += 0.5;
    }
    match index % 5 {
        1 => step(model, other, work, &states, STEP_S).expect("good states"),
        2 => advance(model, other, work, &states, loads, STEP_S).expect("good states"),
        4 => advance_in_place(model, other, work, &mut states, loads, STEP_S).expect("good states"),
        3 => {
            let last = states.len() - 1;
            states[last].yaw_rate_radps = f64::NAN;
            advance(model, other, work, &states, loads, STEP_S).expect_err("not a number");
        }
        _ => {}
    }
}

/// The workspace keeps the values of bodies that have not moved, unless it was used for something else in between.
#[test]
fn a_workspace_used_otherwise_in_between_changes_no_bit() {
    let (model, mut states, loads) = crowd();
    let (mut memory, mut own) = (Memory::new(&model), Workspace::new(&model));
    let (mut same_memory, mut other_memory) = (Memory::new(&model), Memory::new(&model));
    for index in 0..STEPS {
        move_fixed_bodies(&mut states, index);
        use_otherwise(&model, &mut other_memory, &mut own, &states, &loads, index);
        let mut fresh = Workspace::new(&model);
        let found =
            [(&mut memory, &mut own), (&mut same_memory, &mut fresh)].map(|(memory, work)| {
                advance(&model, memory, work, &states, &loads, STEP_S)
                    .expect("good states and loads");
                let results = (work.contacts(), work.wrenches(), work.events());
                format!(
                    "{results:?} {:?} {:?} {memory:?}",
                    work.states_after(),
                    work.displacements()
                )
            });
        assert!(found[0] == found[1], "step {index}");
        states.copy_from_slice(own.states_after());
    }
}

/// Steps that move bodies in place alternate with steps that do not. Each therefore starts from the workspace of the
/// other.
#[test]
fn advance_in_place_moves_bodies_like_advance() {
    let (model, mut states, loads) = crowd();
    let (mut memory, mut own) = (Memory::new(&model), Workspace::new(&model));
    let (mut same_memory, mut other) = (Memory::new(&model), Workspace::new(&model));
    for index in 0..STEPS {
        move_fixed_bodies(&mut states, index);
        let mut moved = states.clone();
        if index % 9 < 7 {
            advance_in_place(&model, &mut memory, &mut own, &mut moved, &loads, STEP_S)
                .expect("good states and loads");
            assert!(own.states_after().is_empty());
        } else {
            by_the_coupled_method(&model, &mut memory, &mut own, &mut moved, &loads);
        }
        by_the_coupled_method(&model, &mut same_memory, &mut other, &mut states, &loads);
        assert_eq!((&moved, own.displacements()), (&states, other.displacements()), "step {index}");
        assert_eq!(memory, same_memory, "step {index}");
    }
}

/// A ship of 1000 t on two fenders of a quay. Bodies and materials are added in this order or in reverse. `more` bodies
/// drift beside the ship.
fn berth(backwards: bool, more: u64) -> (Model, Vec<BodyState>) {
    let mut builder = Model::builder();
    let mut bodies = vec![
        (body(9, &rectangle(60.0, 12.0), true), at(0.0, -7.3, 0.02)),
        (body(1, &rectangle(200.0, 20.0), false), at(0.0, 10.0, 0.0)),
    ];
    bodies.extend((0..more).map(|k| {
        let tug = body(2 + k, &rectangle(24.0, 9.0), true);
        (tug, at(-80.0 + 40.0 * k as f64, -100.0, 0.0))
    }));
    let mut materials = [PAPER, Material { stiffness_npm2: 5e6, ..PAPER }];
    if backwards {
        bodies.reverse();
        materials.reverse();
    }
    let mut states = Vec::new();
    let mut quay = BodyId(0);
    for (body, state) in bodies {
        let is_quay = body.key == 1;
        let id = builder.body(body);
        quay = if is_quay { id } else { quay };
        states.push(state);
    }
    let ids: Vec<MaterialId> = materials.iter().map(|&of| builder.material(of)).collect();
    let soft = if backwards { ids[1] } else { ids[0] };
    for key in 0..2 {
        let along_m = if key == 0 { -20.0 } else { 20.0 };
        let position_m = vec2(along_m, -10.0);
        builder.fender(Fender { position_m, ..fender(quay, soft, key) });
    }
    builder.all_other_pairs(soft);
    (builder.build().expect("a good model"), states)
}

/// A workspace for fewer bodies had no room for the energy that more contacts released. A step panicked.
#[test]
fn a_workspace_made_for_a_smaller_model_serves_a_larger_one() {
    let (small, _) = berth(false, 0);
    let (large, states) = berth(true, 3);
    let loads: Vec<Wrench> = large
        .bodies()
        .iter()
        .map(|body| {
            let pushed = body.key == 9;
            let force_n = if pushed { vec2(0.0, 5e5) } else { Vec2::ZERO };
            Wrench { force_n, moment_nm: 0.0 }
        })
        .collect();
    let after = |mut work: Workspace| {
        let (mut memory, mut states) = (Memory::new(&large), states.clone());
        for _ in 0..600 {
            advance_in_place(&large, &mut memory, &mut work, &mut states, &loads, STEP_S)
                .expect("good states and loads");
        }
        states
    };
    assert_eq!(after(Workspace::new(&small)), after(Workspace::new(&large)));
}

/// Models that differ only in the order of adding bodies and materials have the same memories. A workspace used its
/// values of one model for the other model, and the quay was reported at the ship's position.
#[test]
fn a_workspace_used_for_the_same_model_in_another_order_changes_no_bit() {
    let models = [berth(false, 2), berth(true, 2)];
    let mut runs = models.each_ref().map(|(model, states)| (Memory::new(model), states.clone()));
    let mut shared = Workspace::new(&models[0].0);
    for index in 0..40 {
        for ((model, _), (memory, states)) in models.iter().zip(&mut runs) {
            let loads = vec![Wrench::default(); states.len()];
            let (mut same, mut own) = (memory.clone(), Workspace::new(model));
            let found =
                [(&mut same, &mut own), (&mut *memory, &mut shared)].map(|(memory, work)| {
                    advance(model, memory, work, states, &loads, STEP_S).expect("good states");
                    let results = (work.contacts(), work.wrenches(), work.events());
                    format!(
                        "{results:?} {:?} {:?} {memory:?}",
                        work.states_after(),
                        work.displacements()
                    )
                });
            assert_eq!(found[0], found[1], "step {index}");
            states.copy_from_slice(shared.states_after());
        }
    }
}

/// After the first error the results of the last good step were kept. The second error changed the states of this step.
#[test]
fn repeated_errors_keep_the_results_of_the_last_good_step() {
    let (model, states) = berth(false, 1);
    let loads = vec![Wrench::default(); states.len()];
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    advance(&model, &mut memory, &mut work, &states, &loads, STEP_S).expect("good states");
    let results = |work: &Workspace| {
        let results = (work.contacts(), work.wrenches(), work.events());
        format!("{results:?} {:?} {:?}", work.states_after(), work.displacements())
    };
    let before = (results(&work), memory.snapshot());
    let mut bad = states.clone();
    bad[2].yaw_rate_radps = f64::NAN;
    for _ in 0..3 {
        advance(&model, &mut memory, &mut work, &bad, &loads, STEP_S).expect_err("not a number");
        assert_eq!((results(&work), memory.snapshot()), before);
    }
}
