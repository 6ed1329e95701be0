//! Bodies that never meet can be stepped in separate models, on any number of threads. The bits are those of one model.
//! No body's result depends on bodies outside its island.

use std::thread;

use fenderline_contact::{
    Body, BodyState, Material, Memory, Mobility, Model, Outline, Vec2, Workspace, Wrench,
    advance_in_place, vec2,
};

const STEPS: usize = 150;
const STEP_S: f64 = 0.2;

/// A body with its load.
#[derive(Clone)]
struct Part {
    key: u64,
    size_m: Vec2,
    mass_kg: Option<f64>,
    state: BodyState,
    load: Wrench,
}

/// A place of the harbour: bodies that may touch each other.
struct Place {
    at_m: Vec2,
    parts: Vec<Part>,
}

impl Place {
    fn fixed(&mut self, key: u64, size_m: Vec2, at_m: Vec2) {
        let state = BodyState { position_m: self.at_m + at_m, ..BodyState::default() };
        self.parts.push(Part { key, size_m, mass_kg: None, state, load: Wrench::default() });
    }

    fn floating(&mut self, key: u64, size_m: Vec2, at_m: Vec2, force_n: Vec2) {
        let state = BodyState {
            position_m: self.at_m + at_m,
            heading_rad: 0.001,
            velocity_mps: vec2(0.01, 0.15),
            ..BodyState::default()
        };
        let load = Wrench { force_n, moment_nm: 1e4 };
        let mass_kg = Some(1e3 * size_m.x * size_m.y * 3.0);
        self.parts.push(Part { key, size_m, mass_kg, state, load });
    }
}

/// Pairs, a chain, a raft, and a ship on eight fenders. Their keys are mixed, so that no place has a range of keys of
/// its own.
fn harbour() -> Vec<Place> {
    const PLACES: u64 = 8;
    let place = |number: u64| Place { at_m: vec2(2e3 * number as f64, 0.0), parts: vec![] };
    let mut places: Vec<Place> = (0..PLACES).map(place).collect();
    let (tug_m, fender_m, barge_m) = (vec2(13.0, 32.0), vec2(4.0, 1.0), vec2(40.0, 11.0));
    for (number, place) in (0..).zip(&mut places) {
        let key = |part: u64| part * PLACES + number;
        match number {
            0..5 => {
                place.floating(key(0), tug_m, vec2(0.0, 0.1 * number as f64), vec2(0.0, 3e5));
                place.fixed(key(1), fender_m, vec2(1.0, 17.0));
            }
            5 => {
                for k in 0..4 {
                    let at_m = vec2(0.5 * k as f64, -32.1 * k as f64);
                    place.floating(key(k), tug_m, at_m, vec2(0.0, 3e4));
                }
                place.fixed(key(4), vec2(100.0, 10.0), vec2(0.0, 21.2));
            }
            6 => {
                for k in 0..9 {
                    let at_m = vec2(-40.1 * (k / 3) as f64, -11.1 * (k % 3) as f64);
                    place.floating(key(k), barge_m, at_m, vec2(1e4, 3e4));
                }
                place.fixed(key(9), vec2(10.0, 200.0), vec2(25.1, 0.0));
                place.fixed(key(10), vec2(200.0, 10.0), vec2(0.0, 10.7));
            }
            _ => {
                place.floating(key(0), vec2(298.0, 46.0), vec2(0.0, 0.0), vec2(1e5, 2e6));
                for k in 0..8 {
                    place.fixed(key(k + 1), fender_m, vec2(-110.0 + 28.0 * k as f64, 23.6));
                }
            }
        }
    }
    places
}

/// The result for each body: its key, its state and the wrench on it.
type Outcome = Vec<(u64, BodyState, Wrench)>;

/// Steps bodies in one model.
fn outcome(parts: &[Part]) -> Outcome {
    let model = model(parts);
    let (mut memory, mut work) = (Memory::new(&model), Workspace::new(&model));
    let mut states: Vec<BodyState> = parts.iter().map(|part| part.state).collect();
    let loads: Vec<Wrench> = parts.iter().map(|part| part.load).collect();
    for _ in 0..STEPS {
        advance_in_place(&model, &mut memory, &mut work, &mut states, &loads, STEP_S)
            .expect("sound input");
    }
    assert!(memory.touching_patches() > 0, "bodies touch");
    let results = parts.iter().zip(states).zip(work.wrenches());
    results.map(|((part, state), wrench)| (part.key, state, *wrench)).collect()
}

fn model(parts: &[Part]) -> Model {
    let mut builder = Model::builder();
    let rubber = builder.material(Material {
        stiffness_npm2: 5e5,
        damping_nspm2: 2e4,
        shear_stiffness_npm: 3e6,
        friction_static: 0.5,
        friction_dynamic: 0.4,
        restitution: 0.1,
    });
    for part in parts {
        let (x, y) = (0.5 * part.size_m.x, 0.5 * part.size_m.y);
        let corners = [vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)];
        let mobility = part.mass_kg.map_or(Mobility::Fixed, |mass_kg| Mobility::Free {
            mass_kg,
            yaw_inertia_kgm2: mass_kg * (x * x + y * y) / 3.0,
        });
        builder.body(Body {
            name: format!("body {}", part.key),
            key: part.key,
            outline: Outline::new(&corners).expect("a good outline").0,
            mobility,
        });
    }
    builder.all_other_pairs(rubber);
    builder.build().expect("a good model")
}

#[test]
fn models_on_1_2_and_8_threads_have_the_bits_of_one_model() {
    let places = harbour();
    let together: Vec<Part> = places.iter().flat_map(|place| place.parts.clone()).collect();
    let mut expected = outcome(&together);
    expected.sort_by_key(|(key, ..)| *key);
    for threads in [1, 2, 8] {
        let shares: Vec<Vec<Part>> = places
            .chunks(places.len().div_ceil(threads))
            .map(|own| own.iter().flat_map(|place| place.parts.clone()).collect())
            .collect();
        let mut found: Outcome = thread::scope(|scope| {
            let running: Vec<_> =
                shares.iter().map(|share| scope.spawn(|| outcome(share))).collect();
            running.into_iter().flat_map(|one| one.join().expect("no panic")).collect()
        });
        found.sort_by_key(|(key, ..)| *key);
        assert_eq!(bits(&found), bits(&expected), "{threads} threads");
    }
}

/// In a model in which nothing can touch, a step leaves out the stages of contact.
#[test]
fn contacts_elsewhere_change_no_bit_of_bodies_that_do_not_touch_yet() {
    let mut alone = Place { at_m: Vec2::ZERO, parts: vec![] };
    alone.floating(100, vec2(298.0, 46.0), vec2(0.0, 0.0), vec2(0.0, 0.0));
    alone.floating(101, vec2(13.0, 32.0), vec2(5.0, -60.0), vec2(0.0, 3e5));
    let elsewhere = &harbour()[1];
    let mut found = outcome(&[alone.parts.as_slice(), &elsewhere.parts].concat());
    found.retain(|(key, ..)| *key >= 100);
    assert_eq!(bits(&found), bits(&outcome(&alone.parts)));
}

fn bits(outcome: &Outcome) -> Vec<(u64, [u64; 9])> {
    let of = |(key, state, wrench): &(u64, BodyState, Wrench)| {
        let numbers = [
            state.position_m.x,
            state.position_m.y,
            state.heading_rad,
            state.velocity_mps.x,
            state.velocity_mps.y,
            state.yaw_rate_radps,
            wrench.force_n.x,
            wrench.force_n.y,
            wrench.moment_nm,
        ];
        (*key, numbers.map(f64::to_bits))
    };
    outcome.iter().map(of).collect()
}
