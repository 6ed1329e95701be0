//! Mistakes of a host. Numbers that are not finite give errors that name body and field, and change nothing. Impossible
//! positions give finite, bounded forces and an event.

#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

#[allow(dead_code, reason = "each test uses its own part of the scene")]
use crate::scene;

use fenderline_contact::{
    Body, BodyId, BodyState, EventKind, Material, Memory, Mobility, Model, Outline, Pair,
    StepError, Vec2, Workspace, step, vec2,
};

const STEP_S: f64 = 0.1;
const BAD_NUMBERS: [f64; 6] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, f64::MAX, f64::MIN, 1e300];

type Field = (&'static str, fn(&mut BodyState) -> &mut f64);

const FIELDS: [Field; 6] = [
    ("north position", |s| &mut s.position_m.x),
    ("east position", |s| &mut s.position_m.y),
    ("heading", |s| &mut s.heading_rad),
    ("north velocity", |s| &mut s.velocity_mps.x),
    ("east velocity", |s| &mut s.velocity_mps.y),
    ("yaw rate", |s| &mut s.yaw_rate_radps),
];

/// A ship after a few steps: she is pressed on her fenders and slides along them.
fn at_berth() -> (Model, Memory, Workspace, Vec<BodyState>) {
    let model = scene::berth(500e3);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut ship = BodyState {
        position_m: vec2(0.0, scene::TOUCH_EAST_M - 0.1),
        velocity_mps: vec2(0.05, 0.2),
        ..BodyState::default()
    };
    for _ in 0..20 {
        step(&model, &mut memory, &mut work, &scene::states(ship), STEP_S).expect("good states");
        scene::advance(&mut ship, &work, Vec2::ZERO, STEP_S);
    }
    assert_eq!(work.contacts().len(), scene::FENDERS);
    (model, memory, work, scene::states(ship))
}

#[test]
fn a_bad_number_names_body_and_field_and_changes_nothing() {
    let (model, mut memory, mut work, good) = at_berth();
    let before = memory.snapshot();
    let found_before = format!("{:?} {:?}", work.contacts(), work.wrenches());
    for body in 0..good.len() {
        for (field, field_of) in FIELDS {
            for value in BAD_NUMBERS {
                let mut states = good.clone();
                *field_of(&mut states[body]) = value;
                let error = step(&model, &mut memory, &mut work, &states, STEP_S)
                    .expect_err("a bad number");
                let name = &model.bodies()[body].name;
                match &error {
                    StepError::BadState { body, field: named, value: reported } => {
                        assert_eq!((body, *named), (name, field));
                        assert_eq!(reported.to_bits(), value.to_bits());
                    }
                    other => panic!("{field} of {name} = {value}: {other:?}"),
                }
                let message = error.to_string();
                assert!(message.contains(name) && message.contains(field), "{message}");
                assert_eq!(memory.snapshot(), before, "{message}: memory changed");
            }
        }
    }
    assert_eq!(format!("{:?} {:?}", work.contacts(), work.wrenches()), found_before);
}

#[test]
fn a_bad_time_step_changes_nothing() {
    let (model, mut memory, mut work, good) = at_berth();
    let before = memory.snapshot();
    let bad = BAD_NUMBERS.into_iter().chain([-0.1, 5e-324, 1e12]);
    for step_s in bad {
        let error =
            step(&model, &mut memory, &mut work, &good, step_s).expect_err("a bad time step");
        assert!(matches!(error, StepError::BadTimeStep { .. }), "{step_s}: {error:?}");
        assert_eq!(memory.snapshot(), before);
    }
}

#[test]
fn a_wrong_number_of_states_and_a_foreign_memory_change_nothing() {
    let (model, mut memory, mut work, good) = at_berth();
    let before = memory.snapshot();
    let error = step(&model, &mut memory, &mut work, &good[1..], STEP_S).expect_err("one missing");
    assert_eq!(error, StepError::WrongCount { bodies: good.len(), states: good.len() - 1 });
    assert_eq!(memory.snapshot(), before);

    let other = scene::berth(1e6);
    let error = step(&other, &mut memory, &mut work, &good, STEP_S).expect_err("another model");
    assert_eq!(error, StepError::WrongModel);
    assert_eq!(memory.snapshot(), before);
}

#[test]
fn bad_input_changes_no_bit_of_the_run() {
    let (model, mut memory, mut work, good) = at_berth();
    let (mut other_memory, mut other_work) = (memory.clone(), work.clone());
    let mut bad = good.clone();
    bad[scene::SHIP].heading_rad = f64::NAN;
    step(&model, &mut memory, &mut work, &bad, STEP_S).expect_err("a bad heading");
    step(&model, &mut memory, &mut work, &good, STEP_S).expect("good states");
    step(&model, &mut other_memory, &mut other_work, &good, STEP_S).expect("good states");
    assert_eq!(format!("{:?}", work.contacts()), format!("{:?}", other_work.contacts()));
    assert_eq!(memory.snapshot(), other_memory.snapshot());
}

const STIFFNESS_NPM2: f64 = 500e3;
const FRICTION: f64 = 0.5;
const MASS_KG: f64 = 1e6;

/// A floating and a fixed square.
struct Squares {
    model: Model,
    memory: Memory,
    work: Workspace,
    smaller_m2: f64,
}

impl Squares {
    fn new(floating_side_m: f64, fixed_side_m: f64, restitution: f64) -> Squares {
        let square = |side: f64| {
            let h = 0.5 * side;
            let corners = [vec2(-h, -h), vec2(h, -h), vec2(h, h), vec2(-h, h)];
            Outline::new(&corners).expect("a square").0
        };
        let mut builder = Model::builder();
        let mobility = Mobility::Free { mass_kg: MASS_KG, yaw_inertia_kgm2: 6e7 };
        let tug = builder.body(Body {
            name: "tug".into(),
            key: 1,
            outline: square(floating_side_m),
            mobility,
        });
        let quay = builder.body(Body {
            name: "quay".into(),
            key: 2,
            outline: square(fixed_side_m),
            mobility: Mobility::Fixed,
        });
        let material = builder.material(Material {
            stiffness_npm2: STIFFNESS_NPM2,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 3e6,
            friction_static: FRICTION,
            friction_dynamic: FRICTION,
            restitution,
        });
        builder.pair(Pair { bodies: [tug, quay], material });
        let model = builder.build().expect("a good model");
        let smaller = floating_side_m.min(fixed_side_m);
        Squares {
            memory: Memory::new(&model),
            work: Workspace::new(&model),
            model,
            smaller_m2: smaller * smaller,
        }
    }

    /// Takes one step with the floating square at `position_m` and returns the events. Checks that forces are finite
    /// and within the bounds that follow from the material and the smaller body.
    fn step_at(&mut self, position_m: Vec2, velocity_mps: Vec2) -> Vec<EventKind> {
        let tug = BodyState { position_m, velocity_mps, ..BodyState::default() };
        let states = [tug, BodyState::default()];
        step(&self.model, &mut self.memory, &mut self.work, &states, STEP_S).expect("finite");
        let largest_n = STIFFNESS_NPM2 * self.smaller_m2 * (1.0 + 1e-9);
        for contact in self.work.contacts() {
            assert!(contact.area_m2.is_finite() && contact.depth_m.is_finite());
            assert!((contact.normal.length() - 1.0).abs() < 1e-12, "{:?}", contact.normal);
            assert!(contact.normal_force_n >= 0.0 && contact.normal_force_n <= largest_n);
            assert!(contact.tangential_force_n.abs() <= FRICTION * largest_n);
        }
        for wrench in self.work.wrenches() {
            assert!(wrench.force_n.length() <= (1.0 + FRICTION) * largest_n, "{wrench:?}");
            assert!(wrench.moment_nm.is_finite());
        }
        self.work.events().iter().map(|event| event.kind).collect()
    }
}

#[test]
fn a_teleport_out_of_contact_and_back_is_reported_and_begins_anew() {
    let mut squares = Squares::new(10.0, 10.0, 0.1);
    let (touching, away) = (vec2(-9.9, 0.0), vec2(-5_000.0, 3.0));
    assert_eq!(squares.step_at(touching, vec2(0.1, 0.2)), [EventKind::ContactBegan]);
    for _ in 0..3 {
        squares.step_at(touching, Vec2::ZERO);
    }
    let events = squares.step_at(away, Vec2::ZERO);
    assert!(events.contains(&EventKind::Teleported), "{events:?}");
    assert!(events.contains(&EventKind::ContactEnded), "{events:?}");
    assert!(squares.work.contacts().is_empty());

    let events = squares.step_at(vec2(-9.0, 2.0), vec2(1.0, 0.0));
    assert!(events.contains(&EventKind::Teleported), "{events:?}");
    assert!(events.contains(&EventKind::ContactBegan), "{events:?}");
    assert_eq!(squares.work.contacts()[0].shear_m, 0.0);
}

/// A body is teleported from one side of another body to its opposite side. With the old memory the shear would be
/// metres.
#[test]
fn a_teleport_within_a_contact_drops_its_memory() {
    let mut squares = Squares::new(10.0, 40.0, 0.1);
    squares.step_at(vec2(-24.9, -12.0), Vec2::ZERO);
    squares.step_at(vec2(-24.9, -12.0), Vec2::ZERO);
    let events = squares.step_at(vec2(-24.9, 12.0), Vec2::ZERO);
    let reported = [EventKind::Teleported, EventKind::ContactEnded, EventKind::ContactBegan];
    assert!(reported.iter().all(|kind| events.contains(kind)), "{events:?}");
    assert_eq!(squares.work.contacts()[0].shear_m, 0.0);
    let tug = squares.model.bodies()[0].name.as_str();
    let teleported: Vec<BodyId> = squares
        .work
        .events()
        .iter()
        .filter(|e| e.kind == EventKind::Teleported)
        .map(|e| e.bodies[0])
        .collect();
    assert_eq!((teleported, tug), (vec![BodyId(0)], "tug"));
}

#[test]
fn full_containment_is_bounded_and_reported_once() {
    let mut squares = Squares::new(4.0, 400.0, 0.1);
    let velocity_mps = vec2(0.5, 0.1);
    let events = squares.step_at(vec2(-20.0, 7.0), velocity_mps);
    assert!(events.contains(&EventKind::Contained), "{events:?}");
    assert!(events.contains(&EventKind::DeepOverlap), "{events:?}");
    let contact = squares.work.contacts()[0];
    assert!((contact.area_m2 - 16.0).abs() < 1e-9, "{}", contact.area_m2);
    let events = squares.step_at(vec2(-19.95, 7.01), velocity_mps);
    assert_eq!(events, []);

    // Each of the two squares is inside the other in one case.
    let mut squares = Squares::new(400.0, 4.0, 0.1);
    let events = squares.step_at(vec2(20.0, -7.0), velocity_mps);
    assert!(events.contains(&EventKind::Contained), "{events:?}");
}

#[test]
fn identical_bodies_at_the_same_position_get_finite_forces() {
    let mut squares = Squares::new(10.0, 10.0, 0.1);
    let events = squares.step_at(Vec2::ZERO, vec2(0.1, 0.0));
    assert!(events.contains(&EventKind::Contained), "{events:?}");
    assert!((squares.work.contacts()[0].area_m2 - 100.0).abs() < 1e-9);
}

#[test]
fn thousands_of_metres_of_overlap_are_bounded_and_reported() {
    let mut squares = Squares::new(5_000.0, 9_000.0, 1.0);
    // The square is 3 km deep, and so fast that the limiter does not reduce the force k·S.
    let events = squares.step_at(vec2(-4_000.0, 100.0), vec2(1e6, 1e3));
    assert!(events.contains(&EventKind::DeepOverlap), "{events:?}");
    let contact = squares.work.contacts()[0];
    assert!((contact.area_m2 - 3_000.0 * 5_000.0).abs() < 1e-3, "{}", contact.area_m2);
    assert!((contact.depth_m - 3_000.0).abs() < 1e-6, "{}", contact.depth_m);
    // At walking speed the limiter reduces the force to the value that stops the body in one step.
    let mut squares = Squares::new(5_000.0, 5_000.0, 1.0);
    squares.step_at(vec2(-2_000.0, 0.0), vec2(1.0, 0.0));
    let largest_n = 2.0 * MASS_KG * 1.0 / STEP_S;
    assert!(squares.work.contacts()[0].normal_force_n <= largest_n * (1.0 + 1e-12));
    // The squares are at the largest coordinates that the engine accepts.
    let mut squares = Squares::new(1e8, 1e8, 1.0);
    let events = squares.step_at(vec2(-5e7, 3e6), vec2(1e6, -1e6));
    assert!(events.contains(&EventKind::ContactBegan), "{events:?}");
}
