//! A small host around the engine for tests: scenes of bodies, fenders and steady loads, and their motion.

#![allow(dead_code, reason = "each test binary uses its own part")]
#![allow(clippy::disallowed_methods, reason = "they give expected values, not results")]

pub(crate) mod scenes;

use fenderline_contact::{
    Body, BodyId, BodyState, Contact, Fender, Material, MaterialId, Memory, Mobility, Model,
    Outline, Pair, Vec2, Workspace, Wrench, advance, advance_in_place, step, vec2,
};

/// A rectangle about the origin, with its length along x.
pub(crate) fn rectangle(length_m: f64, width_m: f64) -> Outline {
    let (x, y) = (0.5 * length_m, 0.5 * width_m);
    outline(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)])
}

pub(crate) fn outline(vertices: &[Vec2]) -> Outline {
    Outline::new(vertices).expect("a good outline").0
}

/// Rigid-body mass and added mass.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Mass {
    pub(crate) mass_kg: f64,
    pub(crate) yaw_inertia_kgm2: f64,
    pub(crate) added_surge_kg: f64,
    pub(crate) added_sway_kg: f64,
    pub(crate) added_yaw_kgm2: f64,
}

/// The velocities of a body in its own axes.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BodyVelocity {
    pub(crate) surge_mps: f64,
    pub(crate) sway_mps: f64,
    pub(crate) yaw_radps: f64,
}

/// A body of a scene, with its initial state.
#[derive(Clone, Debug)]
pub(crate) struct BodySetup {
    pub(crate) name: String,
    pub(crate) outline: Outline,
    /// `None` for a fixed body.
    pub(crate) mass: Option<Mass>,
    pub(crate) position_m: Vec2,
    pub(crate) heading_rad: f64,
    pub(crate) velocity: BodyVelocity,
}

/// A floating body. Its yaw inertia follows from a radius of gyration.
pub(crate) fn floating(name: &str, outline: Outline, mass_kg: f64, gyradius_m: f64) -> BodySetup {
    let mass =
        Mass { mass_kg, yaw_inertia_kgm2: mass_kg * gyradius_m * gyradius_m, ..Mass::default() };
    BodySetup { mass: Some(mass), ..fixed(name, outline) }
}

pub(crate) fn fixed(name: &str, outline: Outline) -> BodySetup {
    BodySetup {
        name: name.into(),
        outline,
        mass: None,
        position_m: Vec2::ZERO,
        heading_rad: 0.0,
        velocity: BodyVelocity::default(),
    }
}

/// A material without friction and damping.
pub(crate) fn spring(stiffness_npm2: f64, restitution: f64) -> Material {
    Material {
        stiffness_npm2,
        damping_nspm2: 0.0,
        shear_stiffness_npm: 0.0,
        friction_static: 0.0,
        friction_dynamic: 0.0,
        restitution,
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    Coupled,
    Paper,
}

/// How the bodies are moved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Integrator {
    /// The host moves the bodies: first the positions with the old velocities, then the velocities.
    Euler,
    /// Velocities first. With the coupled method the engine moves the bodies, with the paper's method the host does.
    SemiImplicit,
}

/// Two bodies that may touch, and the material between them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PairSetup {
    pub(crate) bodies: [usize; 2],
    pub(crate) material: usize,
}

/// A steady load on a body, from the start.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load {
    pub(crate) body: usize,
    pub(crate) force_n: Vec2,
}

/// The input of a run.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) step_s: f64,
    pub(crate) duration_s: f64,
    pub(crate) integrator: Integrator,
    pub(crate) method: Method,
    pub(crate) bodies: Vec<BodySetup>,
    pub(crate) materials: Vec<Material>,
    pub(crate) pairs: Vec<PairSetup>,
    pub(crate) fenders: Vec<Fender>,
    pub(crate) loads: Vec<Load>,
}

/// Two bodies with one material and the paper's method.
pub(crate) fn two(
    one: BodySetup,
    two: BodySetup,
    material: Material,
    integrator: Integrator,
    step_s: f64,
    duration_s: f64,
) -> Scene {
    Scene {
        step_s,
        duration_s,
        integrator,
        method: Method::Paper,
        bodies: vec![one, two],
        materials: vec![material],
        pairs: vec![PairSetup { bodies: [0, 1], material: 0 }],
        fenders: vec![],
        loads: vec![],
    }
}

impl Scene {
    /// Surge mass, sway mass and yaw inertia of a body. In the paper's method the smaller added mass applies to every
    /// direction (§3.1 of the paper).
    pub(crate) fn masses(&self, body: usize) -> Option<[f64; 3]> {
        let mass = self.bodies[body].mass?;
        let smallest_kg = mass.added_surge_kg.min(mass.added_sway_kg);
        let (surge_kg, sway_kg) = match self.method {
            Method::Coupled => (mass.added_surge_kg, mass.added_sway_kg),
            Method::Paper => (smallest_kg, smallest_kg),
        };
        let yaw_kgm2 = mass.yaw_inertia_kgm2 + mass.added_yaw_kgm2;
        Some([mass.mass_kg + surge_kg, mass.mass_kg + sway_kg, yaw_kgm2])
    }

    fn mobility(&self, body: usize) -> Mobility {
        match self.masses(body) {
            None => Mobility::Fixed,
            Some([mass_kg, sway_kg, yaw_inertia_kgm2]) if mass_kg == sway_kg => {
                Mobility::Free { mass_kg, yaw_inertia_kgm2 }
            }
            Some([surge_kg, sway_kg, yaw_inertia_kgm2]) => {
                assert_eq!(self.integrator, Integrator::SemiImplicit, "the engine turns momentum");
                Mobility::SurgeSway { surge_kg, sway_kg, yaw_inertia_kgm2 }
            }
        }
    }

    /// The model. The keys of bodies follow from their names, so that the order of bodies does not matter.
    pub(crate) fn model(&self) -> Model {
        let mut names: Vec<&str> = self.bodies.iter().map(|body| body.name.as_str()).collect();
        names.sort_unstable();
        let mut builder = Model::builder();
        for (index, body) in self.bodies.iter().enumerate() {
            builder.body(Body {
                name: body.name.clone(),
                key: names.binary_search(&body.name.as_str()).expect("its name") as u64,
                outline: body.outline.clone(),
                mobility: self.mobility(index),
            });
        }
        for &material in &self.materials {
            builder.material(material);
        }
        for fender in &self.fenders {
            builder.fender(fender.clone());
        }
        for pair in &self.pairs {
            builder.pair(Pair {
                bodies: pair.bodies.map(|body| BodyId(body as u32)),
                material: MaterialId(pair.material as u32),
            });
        }
        builder.build().expect("a good model")
    }

    pub(crate) fn initial_states(&self) -> Vec<BodyState> {
        let state = |body: &BodySetup| {
            let BodyVelocity { surge_mps, sway_mps, yaw_radps } = body.velocity;
            let still = BodyState {
                position_m: body.position_m,
                heading_rad: body.heading_rad,
                ..BodyState::default()
            };
            let velocity_mps = still.pose().rotation.apply(vec2(surge_mps, sway_mps));
            BodyState { velocity_mps, yaw_rate_radps: yaw_radps, ..still }
        };
        self.bodies.iter().map(state).collect()
    }

    pub(crate) fn wrenches_of_loads(&self) -> Vec<Wrench> {
        let mut wrenches = vec![Wrench::default(); self.bodies.len()];
        for load in &self.loads {
            wrenches[load.body].force_n += load.force_n;
        }
        wrenches
    }
}

/// The largest values of a pair of bodies, or of a fender, in a run.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Peaks {
    pub(crate) force_n: f64,
    pub(crate) depth_m: f64,
    /// Start of the step with the largest depth (s).
    pub(crate) depth_at_s: f64,
    pub(crate) first_touch_s: f64,
    pub(crate) last_touch_s: f64,
    /// Impulse of the normal force (N·s).
    pub(crate) impulse_ns: f64,
}

impl Peaks {
    fn at(t_s: f64) -> Peaks {
        Peaks { first_touch_s: t_s, ..Peaks::default() }
    }

    /// Adds the contacts of a step that begins at `t_s`. The forces of several patches are summed.
    fn add(&mut self, contacts: &[&Contact], t_s: f64) {
        self.last_touch_s = t_s;
        let force_n: f64 = contacts.iter().map(|contact| contact.peak_normal_force_n).sum();
        self.force_n = self.force_n.max(force_n);
        for contact in contacts {
            self.impulse_ns += contact.impulse.normal_ns;
            if contact.peak_depth_m > self.depth_m {
                (self.depth_m, self.depth_at_s) = (contact.peak_depth_m, t_s);
            }
        }
    }
}

/// The run of a scene.
#[derive(Clone, Debug)]
pub(crate) struct Host {
    pub(crate) scene: Scene,
    pub(crate) model: Model,
    pub(crate) memory: Memory,
    pub(crate) work: Workspace,
    pub(crate) states: Vec<BodyState>,
    /// Pairs that have touched, in the order of their first touch.
    pub(crate) pairs: Vec<([usize; 2], Peaks)>,
    /// Fenders that have been touched, by index.
    pub(crate) fenders: Vec<(usize, Peaks)>,
    /// Work of all contacts on the bodies, if the engine moves the bodies (J).
    pub(crate) contact_work_j: f64,
    loads: Vec<Wrench>,
    steps_taken: u64,
}

impl Host {
    pub(crate) fn new(scene: Scene) -> Host {
        let model = scene.model();
        Host {
            memory: Memory::new(&model),
            work: Workspace::new(&model),
            states: scene.initial_states(),
            pairs: vec![],
            fenders: vec![],
            contact_work_j: 0.0,
            loads: scene.wrenches_of_loads(),
            steps_taken: 0,
            model,
            scene,
        }
    }

    pub(crate) fn steps_total(&self) -> u64 {
        (self.scene.duration_s / self.scene.step_s - 1e-9).ceil() as u64
    }

    pub(crate) fn is_done(&self) -> bool {
        self.steps_taken >= self.steps_total()
    }

    pub(crate) fn time_s(&self) -> f64 {
        self.steps_taken as f64 * self.scene.step_s
    }

    pub(crate) fn step(&mut self) {
        let Host { scene, model, memory, work, states, loads, .. } = self;
        let step_s = scene.step_s;
        match (scene.method, scene.integrator) {
            (Method::Coupled, Integrator::SemiImplicit) => {
                advance_in_place(model, memory, work, states, loads, step_s)
            }
            (Method::Coupled, Integrator::Euler) => {
                advance(model, memory, work, states, loads, step_s)
            }
            (Method::Paper, _) => step(model, memory, work, states, step_s),
        }
        .expect("a good step");
        self.record();
        if (self.scene.method, self.scene.integrator) != (Method::Coupled, Integrator::SemiImplicit)
        {
            self.integrate();
        }
        self.steps_taken += 1;
    }

    /// Moves the bodies with the step's mean contact wrenches and the loads.
    fn integrate(&mut self) {
        let step_s = self.scene.step_s;
        for body in 0..self.states.len() {
            let Some([mass_kg, _, yaw_kgm2]) = self.scene.masses(body) else { continue };
            let (contact, load) = (self.work.wrenches()[body], self.loads[body]);
            let state = &mut self.states[body];
            let before = *state;
            state.velocity_mps += (contact.force_n + load.force_n) * (step_s / mass_kg);
            state.yaw_rate_radps += (contact.moment_nm + load.moment_nm) * (step_s / yaw_kgm2);
            let moving = match self.scene.integrator {
                Integrator::Euler => before,
                Integrator::SemiImplicit => *state,
            };
            state.position_m += moving.velocity_mps * step_s;
            state.heading_rad += moving.yaw_rate_radps * step_s;
        }
    }

    fn record(&mut self) {
        let t_s = self.time_s();
        let contacts = self.work.contacts();
        for contact in contacts {
            self.contact_work_j += contact.work.normal_j + contact.work.tangential_j;
        }
        let bodies_of =
            |contact: &Contact| [contact.body_1, contact.body_2].map(|id| id.0 as usize);
        let fender_of = |contact: &Contact| contact.fender.map(|id| id.0 as usize);
        add_by(&mut self.pairs, contacts, |contact| Some(bodies_of(contact)), t_s);
        add_by(&mut self.fenders, contacts, fender_of, t_s);
        self.fenders.sort_by_key(|(fender, _)| *fender);
    }

    pub(crate) fn run(scene: Scene) -> Host {
        let mut host = Host::new(scene);
        while !host.is_done() {
            host.step();
        }
        host
    }

    /// Kinetic energy of the bodies, added mass included (J).
    pub(crate) fn kinetic_j(&self) -> f64 {
        let of = |(body, state): (usize, &BodyState)| {
            let Some([surge_kg, sway_kg, yaw_kgm2]) = self.scene.masses(body) else { return 0.0 };
            let own = state.pose().rotation.apply_inverse(state.velocity_mps);
            let turning_j = yaw_kgm2 * state.yaw_rate_radps * state.yaw_rate_radps;
            0.5 * (surge_kg * own.x * own.x + sway_kg * own.y * own.y + turning_j)
        };
        self.states.iter().enumerate().map(of).sum()
    }

    /// Linear momentum, and angular momentum about the earth's origin, of bodies without added mass.
    pub(crate) fn momentum(&self) -> (Vec2, f64) {
        let (mut linear, mut angular) = (Vec2::ZERO, 0.0);
        for (body, state) in self.scene.bodies.iter().zip(&self.states) {
            let mass = body.mass.expect("free bodies");
            let own = state.velocity_mps * mass.mass_kg;
            linear += own;
            angular += state.position_m.cross(own) + mass.yaw_inertia_kgm2 * state.yaw_rate_radps;
        }
        (linear, angular)
    }
}

/// Adds the contacts of a step to the peaks of their pairs or fenders.
fn add_by<K: Copy + PartialEq>(
    records: &mut Vec<(K, Peaks)>,
    contacts: &[Contact],
    owner: impl Fn(&Contact) -> Option<K>,
    t_s: f64,
) {
    let mut seen: Vec<K> = vec![];
    for key in contacts.iter().filter_map(&owner) {
        if seen.contains(&key) {
            continue;
        }
        seen.push(key);
        let own: Vec<&Contact> = contacts.iter().filter(|c| owner(c) == Some(key)).collect();
        let index = records.iter().position(|(other, _)| *other == key).unwrap_or_else(|| {
            records.push((key, Peaks::at(t_s)));
            records.len() - 1
        });
        records[index].1.add(&own, t_s);
    }
}
