//! Small models for the tests: bodies by outline and key, one material.

use fenderline_contact::{
    Body, BodyId, BodyState, Contact, EventKind, Material, Memory, Mobility, Model, Outline, Pair,
    Vec2, Workspace, step, vec2,
};

/// The material of the paper's Table 1.
pub const PAPER: Material = Material {
    stiffness_npm2: 500e3,
    damping_nspm2: 0.0,
    shear_stiffness_npm: 3e6,
    friction_static: 0.5,
    friction_dynamic: 0.5,
    restitution: 0.1,
};

/// A body of 1000 t, or a fixed body.
pub fn body(key: u64, vertices: &[Vec2], free: bool) -> Body {
    let (outline, _) = Outline::new(vertices).expect("a good outline");
    let mobility =
        if free { Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6e7 } } else { Mobility::Fixed };
    Body { name: format!("body {key}"), key, outline, mobility }
}

/// A model in which every body may touch every other body.
pub fn model(bodies: Vec<Body>, material: Material) -> Model {
    let mut builder = Model::builder();
    for body in bodies {
        builder.body(body);
    }
    let material = builder.material(material);
    builder.all_other_pairs(material);
    builder.build().expect("a good model")
}

/// The same model, with a `Pair` for each two bodies that are not both fixed.
pub fn model_of_explicit_pairs(bodies: Vec<Body>, material: Material) -> Model {
    let fixed: Vec<bool> = bodies.iter().map(|b| b.mobility == Mobility::Fixed).collect();
    let mut builder = Model::builder();
    for body in bodies {
        builder.body(body);
    }
    let material = builder.material(material);
    for i in 0..fixed.len() {
        for j in i + 1..fixed.len() {
            if !(fixed[i] && fixed[j]) {
                let bodies = [BodyId(i as u32), BodyId(j as u32)];
                builder.pair(Pair { bodies, material });
            }
        }
    }
    builder.build().expect("a good model")
}

/// A state at rest.
pub fn at(x_m: f64, y_m: f64, heading_rad: f64) -> BodyState {
    BodyState { position_m: vec2(x_m, y_m), heading_rad, ..Default::default() }
}

/// A model, and a run of it.
pub struct Run {
    pub model: Model,
    pub memory: Memory,
    pub work: Workspace,
}

impl Run {
    /// A run before its first step.
    pub fn new(model: Model) -> Run {
        let (memory, work) = (Memory::new(&model), Workspace::new(&model));
        Run { model, memory, work }
    }

    /// Takes one step; returns its contacts.
    pub fn step(&mut self, states: &[BodyState], step_s: f64) -> Vec<Contact> {
        step(&self.model, &mut self.memory, &mut self.work, states, step_s).expect("good states");
        self.work.contacts().to_vec()
    }

    /// Did the last step have this event?
    pub fn has_event(&self, kind: EventKind) -> bool {
        self.work.events().iter().any(|e| e.kind == kind)
    }
}

/// The contacts of two bodies in the first step.
pub fn contacts_of(a: &[Vec2], a_state: BodyState, b: &[Vec2], b_state: BodyState) -> Vec<Contact> {
    let bodies = vec![body(1, a, true), body(2, b, true)];
    Run::new(model(bodies, PAPER)).step(&[a_state, b_state], 0.1)
}
