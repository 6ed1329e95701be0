//! Our engine, playing a scene by the paper's method or by the coupled one.

use std::f64::consts::TAU;
use std::hint::black_box;

use fenderline_contact::{
    Body, BodyId, BodyState, Fender, FenderLaw, MaterialId, Memory, Mobility, Model, Outline, Pair,
    ReactionFactors, Vec2, Workspace, Wrench, advance_in_place, step, vec2,
};

use crate::scenes::{Mass, Part, Plan};
use crate::world::World;

/// The contact method by which our engine steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// The contact method of Moreno et al. (2023); the host moves the bodies by forward Euler, as Moreno et al. do.
    Paper,
    /// The coupled method, which moves the bodies too.
    Coupled,
}

/// A variant of our engine; the variants differ in the time they take.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Variant {
    /// The coupled method, the default.
    Coupled,
    /// The coupled method without a report of each contact: only wrenches and motions, as rapier2d gives them.
    CoupledBrief,
    /// The paper's method, with forward Euler.
    Paper,
    /// The paper's method without a report of each contact.
    PaperBrief,
}

impl Variant {
    /// All variants.
    pub const ALL: [Variant; 4] =
        [Variant::Coupled, Variant::CoupledBrief, Variant::Paper, Variant::PaperBrief];

    /// The name of the variant on the command line and in tables.
    pub fn name(self) -> &'static str {
        match self {
            Variant::Coupled => "coupled",
            Variant::CoupledBrief => "coupled-brief",
            Variant::Paper => "paper",
            Variant::PaperBrief => "paper-brief",
        }
    }

    /// The scene `plan` in this variant, with steps of `step_s` (s).
    pub fn world(self, plan: &Plan, step_s: f64) -> Ours {
        match self {
            Variant::Coupled => Ours::new(plan, Method::Coupled, step_s),
            Variant::CoupledBrief => Ours::new(plan, Method::Coupled, step_s).brief(),
            Variant::Paper => Ours::new(plan, Method::Paper, step_s),
            Variant::PaperBrief => Ours::new(plan, Method::Paper, step_s).brief(),
        }
    }
}

/// A scene of the benches in our contact engine.
pub struct Ours {
    model: Model,
    memory: Memory,
    work: Workspace,
    states: Vec<BodyState>,
    loads: Vec<Wrench>,
    /// Δt over mass and over yaw inertia of each floating body (s/kg, s/(kg·m²)); `None` for a fixed body.
    paces: Vec<Option<(f64, f64)>>,
    method: Method,
    step_s: f64,
    /// States of the bodies and the engine's memory one step after the start of the scene, from which a restart begins.
    begun: Option<(Vec<BodyState>, Memory)>,
}

impl Ours {
    /// The scene `plan`, stepped by `method` with steps of `step_s` (s).
    pub fn new(plan: &Plan, method: Method, step_s: f64) -> Ours {
        let (parts, fenders) =
            if plan.faces { on_one_quay(plan) } else { (plan.parts.clone(), vec![]) };
        let model = model(plan, &parts, fenders);
        Ours {
            memory: Memory::new(&model),
            work: Workspace::new(&model),
            model,
            states: parts.iter().map(|part| part.state).collect(),
            loads: parts.iter().map(|part| part.load).collect(),
            paces: parts.iter().map(|part| part.mass.map(|mass| pace(mass, step_s))).collect(),
            method,
            step_s,
            begun: None,
        }
    }

    /// Turns off the reports of single contacts.
    pub fn brief(mut self) -> Ours {
        self.work.report_contacts(false);
        self
    }

    /// The present states of all bodies.
    pub fn states(&self) -> &[BodyState] {
        &self.states
    }

    fn euler(&mut self) {
        let wrenches = self.work.wrenches();
        for (index, state) in self.states.iter_mut().enumerate() {
            let Some((of_mass, of_inertia)) = self.paces[index] else { continue };
            let (load, contact) = (self.loads[index], wrenches[index]);
            state.position_m += state.velocity_mps * self.step_s;
            state.heading_rad += state.yaw_rate_radps * self.step_s;
            state.velocity_mps += (load.force_n + contact.force_n) * of_mass;
            state.yaw_rate_radps += (load.moment_nm + contact.moment_nm) * of_inertia;
        }
    }
}

impl World for Ours {
    fn restart(&mut self) {
        if self.begun.is_none() {
            self.step();
            self.begun = Some((self.states.clone(), self.memory.clone()));
        }
        if let Some((states, memory)) = &self.begun {
            self.states.copy_from_slice(states);
            self.memory.clone_from(memory);
        }
    }

    fn step(&mut self) {
        let Ours { model, memory, work, states, loads, step_s, .. } = self;
        let states = black_box(states);
        match self.method {
            Method::Paper => {
                step(model, memory, work, states, *step_s).expect("the scenes are sound");
                self.euler();
            }
            Method::Coupled => {
                advance_in_place(model, memory, work, states, loads, *step_s)
                    .expect("the scenes are sound");
            }
        }
    }

    fn load(&mut self, body: usize, force_n: Vec2) {
        self.loads[body].force_n = force_n;
    }

    fn state(&self, body: usize) -> BodyState {
        self.states[body]
    }

    fn touching(&self) -> usize {
        self.memory.touching_patches()
    }

    fn peaks(&self) -> Option<(f64, f64)> {
        let largest = |(force_n, depth_m): (f64, f64), c: &fenderline_contact::Contact| {
            (force_n.max(c.peak_normal_force_n), depth_m.max(c.peak_depth_m))
        };
        Some(self.work.contacts().iter().fold((0.0, 0.0), largest))
    }
}

fn pace(mass: Mass, step_s: f64) -> (f64, f64) {
    (step_s / mass.mass_kg, step_s / mass.yaw_inertia_kgm2)
}

/// The model's floating bodies and one quay, with a fender face on the quay for each fixed block.
fn on_one_quay(plan: &Plan) -> (Vec<Part>, Vec<Fender>) {
    let (fixed, mut parts): (Vec<Part>, Vec<Part>) =
        plan.parts.iter().cloned().partition(|part| part.mass.is_none());
    let (width_m, projection_m) = plan.fender_m;
    let fenders = fixed.iter().zip(0..).map(|(part, key)| Fender {
        name: format!("fender {key}"),
        key,
        body: BodyId(parts.len() as u32),
        position_m: part.state.position_m + vec2(0.0, 0.5 * projection_m),
        facing_rad: -0.25 * TAU,
        width_m,
        projection_m,
        law: FenderLaw::Area,
        unloading: None,
        material: MaterialId(0),
        rated_deflection_m: 0.6,
        stop: None,
        factors: ReactionFactors::default(),
        panel: None,
    });
    let fenders: Vec<Fender> = fenders.collect();
    let east_m = fenders.first().map_or(0.0, |fender| fender.position_m.y);
    let outline_m = [(-200.0, 0.0), (200.0, 0.0), (200.0, 20.0), (-200.0, 20.0)]
        .map(|(x, y)| vec2(x, east_m + y));
    let (state, load) = (BodyState::default(), Wrench::default());
    parts.push(Part { outline_m: outline_m.to_vec(), mass: None, state, load });
    (parts, fenders)
}

fn model(plan: &Plan, parts: &[Part], fenders: Vec<Fender>) -> Model {
    let mut builder = Model::builder();
    let material = builder.material(plan.material);
    let ids: Vec<BodyId> =
        parts.iter().zip(0..).map(|(part, key)| builder.body(body(part, key))).collect();
    for fender in fenders {
        builder.fender(fender);
    }
    if plan.anyone {
        builder.all_other_pairs(material);
    } else {
        let floats = |id: &&BodyId| parts[id.0 as usize].mass.is_some();
        for &one in ids.iter().filter(floats) {
            for &other in ids.iter().filter(|id| !floats(id)) {
                builder.pair(Pair { bodies: [one, other], material });
            }
        }
    }
    builder.build().expect("the scenes are sound")
}

fn body(part: &Part, key: u64) -> Body {
    let outline = Outline::new(&part.outline_m).expect("the scenes' outlines are sound").0;
    let mobility = match part.mass {
        None => Mobility::Fixed,
        Some(Mass { mass_kg, yaw_inertia_kgm2 }) => Mobility::Free { mass_kg, yaw_inertia_kgm2 },
    };
    Body { name: format!("body {key}"), key, outline, mobility }
}
