//! A typical co-simulation master. It moves its bodies itself, passes states that are some steps old, and does not
//! report its loads.

use fenderline_contact::{
    Body, BodyId, BodyState, CoSimHost, DirectHost, Event, HostIntegration, HostSettings,
    HostWorkspace, Material, Memory, Mobility, Model, Outline, Pair, StepError, Vec2, Workspace,
    Wrench, advance, advance_from_engine_states, vec2,
};

/// Bodies that may touch, their initial states, and the loads, which only the master knows.
#[derive(Clone, Debug)]
pub(crate) struct Scene {
    pub(crate) model: Model,
    pub(crate) states: Vec<BodyState>,
    pub(crate) loads: Vec<Wrench>,
}

pub(crate) fn rectangle(length_m: f64, beam_m: f64) -> Outline {
    let (x, y) = (0.5 * length_m, 0.5 * beam_m);
    Outline::new(&[vec2(-x, -y), vec2(x, -y), vec2(x, y), vec2(-x, y)]).expect("a rectangle").0
}

/// A linear spring without damper. If `friction` is not zero, it has friction and a shear spring.
pub(crate) fn rubber(stiffness_npm2: f64, restitution: f64, friction: f64) -> Material {
    Material {
        stiffness_npm2,
        damping_nspm2: 0.0,
        shear_stiffness_npm: if friction > 0.0 { 3e6 } else { 0.0 },
        friction_static: friction,
        friction_dynamic: friction,
        restitution,
    }
}

/// A model with a pair of the first body and each other body.
pub(crate) fn model(bodies: &[(Outline, Mobility)], material: Material) -> Model {
    let mut builder = Model::builder();
    for (index, (outline, mobility)) in bodies.iter().enumerate() {
        builder.body(Body {
            name: format!("body {index}"),
            key: index as u64,
            outline: outline.clone(),
            mobility: *mobility,
        });
    }
    let material = builder.material(material);
    for index in 1..bodies.len() as u32 {
        builder.pair(Pair { bodies: [BodyId(0), BodyId(index)], material });
    }
    builder.build().expect("a good model")
}

/// A tug of 1000 t, 13 m wide, at `gap_m` from a wall of 500 kN/m²: k·width = 6.5 MN/m.
pub(crate) fn tug_at_a_wall(gap_m: f64, speed_mps: f64, restitution: f64) -> Scene {
    let tug = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6.4e7 };
    let bodies = [(rectangle(32.0, 13.0), tug), (rectangle(200.0, 100.0), Mobility::Fixed)];
    Scene {
        model: model(&bodies, rubber(500e3, restitution, 0.0)),
        states: vec![
            BodyState { velocity_mps: vec2(speed_mps, 0.0), ..BodyState::default() },
            BodyState { position_m: vec2(116.0 + gap_m, 0.0), ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

/// The interface of the engine that the master uses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Service {
    /// A [`CoSimHost`] without loads.
    CoSim(HostSettings),
    /// A [`CoSimHost`] with the loads.
    CoSimWithLoads(HostSettings),
    /// A [`CoSimHost`] with zero loads, which switch the observer off.
    CoSimWithoutObserver(HostSettings),
    /// `advance` alone. It takes the old states for current ones, and gets no loads.
    AdvanceWithoutLoads,
    /// `advance` alone, with the loads.
    Advance,
    /// A [`DirectHost`].
    Direct,
}

/// The co-simulation master.
pub(crate) struct Master {
    pub(crate) scene: Scene,
    pub(crate) integration: HostIntegration,
    pub(crate) delay_steps: u32,
    /// The master's masses over those of the model.
    pub(crate) mass_factor: f64,
    /// All states since the start. The last states are the current ones.
    pub(crate) past: Vec<Vec<BodyState>>,
    pub(crate) host: CoSimHost,
    pub(crate) work: HostWorkspace,
    pub(crate) direct: DirectHost,
    memory: Memory,
    plain: Workspace,
    service: Service,
}

impl Master {
    pub(crate) fn new(
        scene: Scene,
        integration: HostIntegration,
        delay_steps: u32,
        service: Service,
    ) -> Master {
        let settings = match service {
            Service::CoSim(settings)
            | Service::CoSimWithLoads(settings)
            | Service::CoSimWithoutObserver(settings) => settings,
            Service::AdvanceWithoutLoads | Service::Advance | Service::Direct => {
                HostSettings::default()
            }
        };
        Master {
            host: CoSimHost::new(&scene.model, settings),
            work: HostWorkspace::new(&scene.model),
            direct: DirectHost::new(&scene.model),
            memory: Memory::new(&scene.model),
            plain: Workspace::new(&scene.model),
            past: vec![scene.states.clone()],
            scene,
            integration,
            delay_steps,
            mass_factor: 1.0,
            service,
        }
    }

    /// A master with a [`CoSimHost`] that has the right integrator and delay.
    pub(crate) fn known(scene: Scene, integration: HostIntegration, delay_steps: u32) -> Master {
        let settings = HostSettings { delay_steps, integration };
        Master::new(scene, integration, delay_steps, Service::CoSim(settings))
    }

    pub(crate) fn wrenches(&self) -> &[Wrench] {
        match self.service {
            Service::AdvanceWithoutLoads | Service::Advance => self.plain.wrenches(),
            _ => self.work.wrenches(),
        }
    }

    pub(crate) fn events(&self) -> &[Event] {
        match self.service {
            Service::AdvanceWithoutLoads | Service::Advance => self.plain.events(),
            _ => self.work.events(),
        }
    }

    pub(crate) fn states(&self) -> &[BodyState] {
        self.past.last().expect("never empty")
    }

    pub(crate) fn input_states(&self) -> &[BodyState] {
        let old = (self.past.len() - 1).saturating_sub(self.delay_steps as usize);
        &self.past[old]
    }

    /// The wrenches for the master's next step.
    fn next_wrenches(&mut self, step_s: f64) -> Result<Vec<Wrench>, StepError> {
        let states = self.input_states().to_vec();
        let (model, loads) = (&self.scene.model, &self.scene.loads);
        let no_loads = vec![Wrench::default(); loads.len()];
        let given_loads = match self.service {
            Service::CoSim(_) => None,
            Service::CoSimWithLoads(_) | Service::Advance | Service::Direct => {
                Some(loads.as_slice())
            }
            Service::CoSimWithoutObserver(_) | Service::AdvanceWithoutLoads => {
                Some(no_loads.as_slice())
            }
        };
        if let (Service::AdvanceWithoutLoads | Service::Advance, Some(given_loads)) =
            (self.service, given_loads)
        {
            advance(model, &mut self.memory, &mut self.plain, &states, given_loads, step_s)?;
            return Ok(self.plain.wrenches().to_vec());
        }
        if let (Service::Direct, Some(given_loads)) = (self.service, given_loads) {
            return self
                .direct
                .step(model, &mut self.work, &states, given_loads, step_s)
                .map(<[_]>::to_vec);
        }
        self.host.step(model, &mut self.work, &states, given_loads, step_s).map(<[_]>::to_vec)
    }

    pub(crate) fn step(&mut self, step_s: f64) {
        let wrenches = self.next_wrenches(step_s).expect("a good step");
        let mut states = self.states().to_vec();
        for (index, state) in states.iter_mut().enumerate() {
            let (contact, load) = (&wrenches[index], &self.scene.loads[index]);
            let share = 1.0 / self.mass_factor;
            let sum = Wrench {
                force_n: (contact.force_n + load.force_n) * share,
                moment_nm: (contact.moment_nm + load.moment_nm) * share,
            };
            let mobility = self.scene.model.bodies()[index].mobility;
            *state = moved(state, mobility, &sum, self.integration, step_s);
        }
        self.past.push(states);
    }

    pub(crate) fn run(&mut self, step_s: f64, duration_s: f64) {
        for _ in 0..(duration_s / step_s).round() as usize {
            self.step(step_s);
        }
    }
}

/// Solves M a = W by Gaussian elimination in the body's axes. It does not use the engine's inverse.
fn acceleration(state: &BodyState, mobility: Mobility, sum: &Wrench) -> (Vec2, f64) {
    let mut m = match mobility {
        Mobility::Fixed | Mobility::OnPile { .. } => return (Vec2::ZERO, 0.0),
        Mobility::Free { mass_kg, yaw_inertia_kgm2 } => {
            [[mass_kg, 0.0, 0.0], [0.0, mass_kg, 0.0], [0.0, 0.0, yaw_inertia_kgm2]]
        }
        Mobility::FullMatrix { .. } | Mobility::SurgeSway { .. } => {
            mobility.matrix().expect("it floats")
        }
    };
    let (sin, cos) = libm::sincos(state.heading_rad);
    let force = sum.force_n;
    let mut w = [cos * force.x + sin * force.y, cos * force.y - sin * force.x, sum.moment_nm];
    for pivot in 0..3 {
        for row in pivot + 1..3 {
            let factor = m[row][pivot] / m[pivot][pivot];
            let above = m[pivot];
            for (value, above) in m[row].iter_mut().zip(above) {
                *value -= factor * above;
            }
            w[row] -= factor * w[pivot];
        }
    }
    let yaw = w[2] / m[2][2];
    let sway = (w[1] - m[1][2] * yaw) / m[1][1];
    let surge = (w[0] - m[0][1] * sway - m[0][2] * yaw) / m[0][0];
    (vec2(cos * surge - sin * sway, sin * surge + cos * sway), yaw)
}

fn moved(
    state: &BodyState,
    mobility: Mobility,
    sum: &Wrench,
    integration: HostIntegration,
    step_s: f64,
) -> BodyState {
    let (linear, turning) = acceleration(state, mobility, sum);
    let velocity_mps = state.velocity_mps + linear * step_s;
    let yaw_rate_radps = state.yaw_rate_radps + turning * step_s;
    let (way, turn) = match integration {
        HostIntegration::ForwardEuler => (state.velocity_mps, state.yaw_rate_radps),
        HostIntegration::SemiImplicit => (velocity_mps, yaw_rate_radps),
    };
    BodyState {
        position_m: state.position_m + way * step_s,
        heading_rad: state.heading_rad + turn * step_s,
        velocity_mps,
        yaw_rate_radps,
    }
}

/// The converged solution: the engine moves the bodies in steps of 0.01 s and knows the loads.
pub(crate) fn converged(scene: &Scene, duration_s: f64) -> Vec<BodyState> {
    moved_by_the_engine(scene, 0.01, duration_s)
}

/// The states after a run in which the engine moves the bodies and knows the loads.
pub(crate) fn moved_by_the_engine(scene: &Scene, step_s: f64, duration_s: f64) -> Vec<BodyState> {
    let (mut memory, mut work) = (Memory::new(&scene.model), Workspace::new(&scene.model));
    let mut states = scene.states.clone();
    for _ in 0..(duration_s / step_s).round() as usize {
        advance_from_engine_states(
            &scene.model,
            &mut memory,
            &mut work,
            &states,
            &scene.loads,
            step_s,
        )
        .expect("a good step");
        states.copy_from_slice(work.states_after());
    }
    states
}

/// A ship of 200 m × 32 m. Her masses in surge and sway differ, and sway is coupled with yaw.
pub(crate) fn ship() -> (Outline, Mobility) {
    let matrix = [[1.03e8, 0.0, 0.0], [0.0, 1.5e8, 4e8], [0.0, 4e8, 4.3e11]];
    (rectangle(200.0, 32.0), Mobility::FullMatrix { matrix })
}

/// The ship at a heading of 30°, drifting sideways onto a fender 4 m wide, 60 m forward of her centre.
pub(crate) fn ship_on_a_fender(friction: f64, stiffness_npm2: f64) -> Scene {
    let heading_rad = core::f64::consts::FRAC_PI_6;
    let (sin, cos) = libm::sincos(heading_rad);
    let at = |forward: f64, starboard: f64| {
        vec2(cos * forward - sin * starboard, sin * forward + cos * starboard)
    };
    let bodies = [ship(), (rectangle(4.0, 8.0), Mobility::Fixed)];
    Scene {
        model: model(&bodies, rubber(stiffness_npm2, 0.1, friction)),
        states: vec![
            BodyState { heading_rad, velocity_mps: at(0.1, 0.3), ..BodyState::default() },
            BodyState { position_m: at(60.0, 20.3), heading_rad, ..BodyState::default() },
        ],
        loads: vec![Wrench::default(); 2],
    }
}

/// A tug that hits a free ship's side forward of midships, at an angle.
pub(crate) fn tug_against_a_ship(friction: f64) -> Scene {
    let tug = Mobility::Free { mass_kg: 1e6, yaw_inertia_kgm2: 6.4e7 };
    let bodies = [(rectangle(32.0, 13.0), tug), ship()];
    let heading_rad = 1.5;
    let (sin, cos) = libm::sincos(heading_rad);
    Scene {
        model: model(&bodies, rubber(500e3, 0.1, friction)),
        states: vec![
            BodyState {
                position_m: vec2(50.0, -34.0),
                heading_rad,
                velocity_mps: vec2(cos, sin) * 2.06,
                ..BodyState::default()
            },
            BodyState::default(),
        ],
        loads: vec![Wrench::default(); 2],
    }
}

/// The ship at rest at a heading of 30°, touching two fenders 4 m wide, 60 m forward and 40 m aft of her
/// centre, and pushed against them by a steady load forward of her centre.
pub(crate) fn ship_on_two_fenders(friction: f64) -> Scene {
    let heading_rad = core::f64::consts::FRAC_PI_6;
    let (sin, cos) = libm::sincos(heading_rad);
    let at = |forward: f64, starboard: f64| {
        vec2(cos * forward - sin * starboard, sin * forward + cos * starboard)
    };
    let fender = |forward: f64| BodyState {
        position_m: at(forward, 20.0),
        heading_rad,
        ..BodyState::default()
    };
    let wide = || (rectangle(4.0, 8.0), Mobility::Fixed);
    let load = Wrench { force_n: at(0.0, 1e6), moment_nm: 2e7 };
    Scene {
        model: model(&[ship(), wide(), wide()], rubber(1e6, 0.1, friction)),
        states: vec![
            BodyState { heading_rad, ..BodyState::default() },
            fender(60.0),
            fender(-40.0),
        ],
        loads: vec![load, Wrench::default(), Wrench::default()],
    }
}
