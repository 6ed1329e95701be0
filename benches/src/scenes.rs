//! Whole scenes for the engine, with motions that keep every contact alive.

use std::f64::consts::TAU;
use std::hint::black_box;

use fenderline_contact::{
    Body, BodyId, BodyState, Material, Memory, Mobility, Model, ModelBuilder, Outline, Pair, Vec2,
    Workspace, step, vec2,
};

const STEP_S: f64 = 0.1;

/// Steps in a loop of the motion.
const LOOP: usize = 64;

/// Bodies that move go this far in and out [m].
const STROKE_M: f64 = 0.2;

/// What is stepped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Scene {
    /// A tug against one fender.
    Tug,
    /// A ship alongside eight fenders.
    Ship,
    /// So many tugs, each against a fender of its own, in a square of them; any body may touch any
    /// other.
    Pairs(usize),
}

impl Scene {
    pub(crate) fn named(name: &str) -> Option<Scene> {
        match name {
            "tug" => Some(Scene::Tug),
            "ship" => Some(Scene::Ship),
            "pairs-1000" => Some(Scene::Pairs(1_000)),
            "pairs-10000" => Some(Scene::Pairs(10_000)),
            _ => None,
        }
    }
}

/// A scene with its motion: a loop in and out, the velocities to match.
pub(crate) struct Driven {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
    /// The bodies that move, and where each is at the middle of the loop [m].
    movers: Vec<(usize, Vec2)>,
    /// Way into the fenders [m] and speed [m/s] at each step of the loop.
    motion: Vec<(f64, f64)>,
    at: usize,
}

impl Driven {
    pub(crate) fn new(scene: Scene) -> Driven {
        let mut plan = Plan::default();
        match scene {
            Scene::Tug => plan.tug_at_fender(vec2(0.0, 0.0), true),
            Scene::Ship => plan.ship_at_fenders(),
            Scene::Pairs(count) => plan.square_of_tugs(count),
        }
        let model = plan.builder.build().expect("the benches' scenes are sound");
        let motion = (0..LOOP)
            .map(|k| {
                let angle = TAU * k as f64 / LOOP as f64;
                let way_m = 0.5 * STROKE_M * (1.0 - libm::cos(angle));
                let rate = TAU / (LOOP as f64 * STEP_S);
                (way_m, 0.5 * STROKE_M * rate * libm::sin(angle))
            })
            .collect();
        Driven {
            memory: Memory::new(&model),
            work: Workspace::new(&model),
            model,
            states: plan.states,
            movers: plan.movers,
            motion,
            at: 0,
        }
    }

    /// Goes on by so many steps, moving the bodies included.
    pub(crate) fn steps(&mut self, count: usize) {
        for _ in 0..count {
            let (way_m, speed_mps) = self.motion[self.at % LOOP];
            for &(body, middle_m) in &self.movers {
                self.states[body].position_m.y = middle_m.y + way_m;
                self.states[body].velocity_mps.y = speed_mps;
            }
            self.at += 1;
            let states = black_box(self.states.as_slice());
            step(&self.model, &mut self.memory, &mut self.work, states, STEP_S)
                .expect("the benches' states are sound");
            black_box(self.work.wrenches());
        }
    }

    /// Contacts of the last step.
    pub(crate) fn contacts(&self) -> usize {
        self.work.contacts().len()
    }
}

#[derive(Default)]
struct Plan {
    builder: ModelBuilder,
    states: Vec<BodyState>,
    movers: Vec<(usize, Vec2)>,
}

impl Plan {
    fn rubber(&mut self) -> fenderline_contact::MaterialId {
        self.builder.material(Material {
            stiffness_npm2: 500e3,
            damping_nspm2: 0.0,
            shear_stiffness_npm: 3e6,
            friction_static: 0.5,
            friction_dynamic: 0.5,
            restitution: 0.1,
        })
    }

    fn body(&mut self, outline: &Outline, mobility: Mobility, state: BodyState) -> BodyId {
        let key = self.states.len() as u64;
        if mobility != Mobility::Fixed {
            self.movers.push((self.states.len(), state.position_m));
        }
        self.states.push(state);
        let (name, outline) = (format!("body {key}"), outline.clone());
        self.builder.body(Body { name, key, outline, mobility })
    }

    /// A tug of the paper's size, bow to the east, 5 cm into a fender's block at the least.
    fn tug_at_fender(&mut self, at_m: Vec2, named: bool) {
        let (tug, fender) = (outline(&TUG), outline(&FENDER));
        let mobility = Mobility::Free { mass_kg: 1.01e6, yaw_inertia_kgm2: 6.0e7 };
        let heading_rad = 0.25 * TAU + 0.01;
        let tug = self.body(&tug, mobility, at(at_m, heading_rad));
        let beyond = at_m + vec2(0.0, 16.0 + 0.5 - 0.05);
        let fender = self.body(&fender, Mobility::Fixed, at(beyond, 0.0));
        if named {
            let material = self.rubber();
            self.builder.pair(Pair { bodies: [tug, fender], material });
        }
    }

    /// The paper's container ship along eight fenders on its starboard side.
    fn ship_at_fenders(&mut self) {
        let (ship, fender) = (outline(&SHIP), outline(&FENDER));
        let mobility = Mobility::Free { mass_kg: 9.06e7, yaw_inertia_kgm2: 4.9e11 };
        let ship = self.body(&ship, mobility, at(vec2(0.0, 0.0), 0.0003));
        let material = self.rubber();
        for k in 0..8 {
            let place = vec2(-110.0 + 28.0 * f64::from(k), 23.0 + 0.5 - 0.08);
            let fender = self.body(&fender, Mobility::Fixed, at(place, 0.0));
            self.builder.pair(Pair { bodies: [ship, fender], material });
        }
    }

    fn square_of_tugs(&mut self, count: usize) {
        const APART_M: f64 = 60.0;
        let side = (1..).find(|side| side * side >= count).unwrap_or(1);
        for k in 0..count {
            let (row, column) = ((k / side) as f64, (k % side) as f64);
            // Every row a little further north, so that the rows are not in line.
            let place = vec2(APART_M * row + 0.4 * column, APART_M * column);
            self.tug_at_fender(place, false);
        }
        let material = self.rubber();
        self.builder.every_other_pair(material);
    }
}

/// 32 × 13 m with a flat bow of 10 m.
const TUG: [(f64, f64); 8] = [
    (-16.0, -5.5),
    (-14.0, -6.5),
    (6.0, -6.5),
    (16.0, -5.0),
    (16.0, 5.0),
    (6.0, 6.5),
    (-14.0, 6.5),
    (-16.0, 5.5),
];

/// 298 × 46 m.
const SHIP: [(f64, f64); 6] =
    [(-149.0, -23.0), (104.0, -23.0), (149.0, -3.0), (149.0, 3.0), (104.0, 23.0), (-149.0, 23.0)];

/// A block of 4 × 1 m.
const FENDER: [(f64, f64); 4] = [(-2.0, -0.5), (2.0, -0.5), (2.0, 0.5), (-2.0, 0.5)];

fn outline(corners: &[(f64, f64)]) -> Outline {
    let vertices: Vec<Vec2> = corners.iter().map(|&(x, y)| vec2(x, y)).collect();
    Outline::new(&vertices).expect("the benches' outlines are sound").0
}

fn at(position_m: Vec2, heading_rad: f64) -> BodyState {
    BodyState { position_m, heading_rad, ..BodyState::default() }
}
