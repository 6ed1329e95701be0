//! Runs the scenarios that are compared with published results.

use std::collections::BTreeMap;

use fenderline_contact::number::greater;
use fenderline_contact::{BodyState, Mobility, Model, Vec2};
use fenderline_scenario::Scenario;
use fenderline_sim::{PairSummary, Setup, Simulation, StepRecord};

/// Name of a scenario under `scenarios/`, and its text.
macro_rules! embedded {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_str!(concat!(env!("FENDERLINE_DATA"), "/scenarios/", $name, ".toml")))),*]
    };
}

/// Every scenario of a validation.
pub(super) const SCENARIOS: [(&str, &str); 14] = embedded![
    "paper/experiment_1_step_0.1s",
    "paper/experiment_1_step_0.5s",
    "paper/experiment_1_step_1s",
    "paper/experiment_1_step_2s",
    "paper/experiment_2_4kn",
    "paper/experiment_2_2kn",
    "paper/experiment_2_1kn",
    "paper/experiment_2_0.5kn",
    "closed_form/flat_head_on",
    "closed_form/momentum",
    "closed_form/damped_head_on",
    "closed_form/grazing_slide",
    "closed_form/concrete_behind_fender",
    "closed_form/rubber_head_on",
];

/// The names of all scenarios of the validation, in the order of the sources.
pub(super) fn names() -> impl Iterator<Item = &'static str> {
    SCENARIOS.iter().map(|(name, _)| *name)
}

/// The results of a scenario's run.
#[derive(Clone, Debug)]
pub(super) struct Played {
    pub(super) title: String,
    pub(super) setup: Setup,
    /// Indices of the two bodies of the scenario's pair, into the scenario's bodies.
    pub(super) bodies: [usize; 2],
    /// The coefficient of restitution of the pair of bodies.
    pub(super) restitution: f64,
    /// The pair's contact.
    pub(super) pair: PairSummary,
    /// One sample a step.
    pub(super) trace: Vec<Sample>,
    pub(super) momentum: MomentumWatch,
    /// Energy that was lost in the run, as a share of the kinetic energy at the start.
    pub(super) energy_lost: f64,
}

/// Force and speed of the two bodies at the start of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sample {
    pub(super) t_s: f64,
    /// Sum over the patches.
    pub(super) normal_force_n: f64,
    /// Relative speed of the two bodies along the line between their centres of gravity at the start of the run,
    /// positive when closing.
    pub(super) closing_mps: f64,
}

impl Played {
    /// Duration of the contact, from the first step in which the bodies overlap to the end of the last (s).
    pub(super) fn contact_duration_s(&self) -> f64 {
        self.pair.last_touch_s - self.pair.first_touch_s + self.setup.step_s
    }

    /// Duration of the first push: the first unbroken series of steps with a normal force (s). A normal force that the
    /// momentum limit removed except for rounding does not count as a push.
    pub(super) fn push_duration_s(&self) -> f64 {
        let least_n = 1e-9 * self.pair.peak_normal_force_n;
        let pushes = self.trace.iter().map(|sample| sample.normal_force_n > least_n);
        let steps = pushes.skip_while(|pushes| !pushes).take_while(|pushes| *pushes).count();
        steps as f64 * self.setup.step_s
    }
}

/// Runs all scenarios of the validation, and calls `part_done` after each.
///
/// # Errors
/// A run that failed.
///
/// # Panics
/// Panics if a built-in scenario cannot be read, which would be a bug.
pub(super) fn play_all(
    mut part_done: impl FnMut(),
) -> Result<BTreeMap<&'static str, Played>, String> {
    let played = SCENARIOS.iter().map(|(name, text)| {
        let played = play(name, text)?;
        part_done();
        Ok((*name, played))
    });
    played.collect()
}

fn play(name: &str, text: &str) -> Result<Played, String> {
    let file_name = format!("scenarios/{name}.toml");
    let scenario = Scenario::parse(text, &file_name)
        .unwrap_or_else(|e| panic!("the built-in {file_name}: {e}"));
    let mut simulation =
        Simulation::new(scenario.setup).map_err(|e| format!("error: {file_name}: {e}"))?;
    let setup = simulation.setup();
    let [named] = &setup.pairs[..] else {
        panic!("the built-in {file_name} must have exactly one pair of bodies")
    };
    let (bodies, material) = (named.bodies, named.material);
    let restitution = setup.materials[material].material.restitution;
    let mut momentum = MomentumWatch::new(simulation.model(), simulation.states());
    let along = line_of_centres(bodies.map(|body| &simulation.states()[body]));
    let start_j = simulation.energy().kinetic_j;
    let mut trace = Vec::new();
    while !simulation.is_done() {
        let step = simulation.step().map_err(|e| format!("error: {file_name}: {e}"))?;
        trace.push(sample(&step, bodies, along));
        momentum.watch(step.states_after);
    }
    let [pair] = simulation.pair_summaries() else {
        return Err(format!("error: {file_name}: no contact"));
    };
    Ok(Played {
        title: scenario.title,
        bodies,
        restitution,
        pair: pair.clone(),
        setup: simulation.setup().clone(),
        trace,
        momentum,
        energy_lost: 1.0 - simulation.energy().kinetic_j / start_j,
    })
}

/// The unit vector from the first body to the second.
fn line_of_centres([first, second]: [&BodyState; 2]) -> Vec2 {
    let line = second.position_m - first.position_m;
    line * (1.0 / line.length())
}

fn sample(step: &StepRecord<'_>, bodies: [usize; 2], along: Vec2) -> Sample {
    let [first, second] = bodies.map(|body| &step.states[body]);
    Sample {
        t_s: step.t_s,
        normal_force_n: step.contacts.iter().map(|c| c.normal_force_n).sum(),
        closing_mps: (first.velocity_mps - second.velocity_mps).dot(along),
    }
}

/// Watches the largest change of the momentum of all bodies together in a run.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct MomentumWatch {
    /// Mass (kg) and yaw inertia (kg·m²) of each body; `None` for a fixed body.
    inertias: Vec<Option<(f64, f64)>>,
    start: Momentum,
    linear_change: f64,
    angular_change: f64,
}

/// Linear momentum of all bodies, and their angular momentum about the chart's origin.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
struct Momentum {
    linear: Vec2,
    angular: f64,
    /// Sum Σ|mv| over the bodies, with which a change of the linear momentum is compared.
    linear_scale: f64,
    /// Sum Σ|x × mv| + |Iω| over the bodies, with which a change of the angular momentum is compared.
    angular_scale: f64,
}

impl MomentumWatch {
    fn new(model: &Model, states: &[BodyState]) -> MomentumWatch {
        let inertias = model.bodies().iter().map(|body| match body.mobility {
            // What a pile takes goes to the ground, as with a fixed body.
            Mobility::Fixed | Mobility::OnPile { .. } => None,
            Mobility::Free { mass_kg, yaw_inertia_kgm2 } => Some((mass_kg, yaw_inertia_kgm2)),
            // With a mass that differs with direction the momentum is not m v.
            Mobility::FullMatrix { .. } | Mobility::SurgeSway { .. } => {
                panic!("the bodies of a case must have one mass for all directions")
            }
        });
        let inertias: Vec<_> = inertias.collect();
        let start = momentum(&inertias, states);
        MomentumWatch { inertias, start, linear_change: 0.0, angular_change: 0.0 }
    }

    fn watch(&mut self, states: &[BodyState]) {
        let now = momentum(&self.inertias, states);
        self.linear_change = greater(self.linear_change, (now.linear - self.start.linear).length());
        self.angular_change =
            greater(self.angular_change, (now.angular - self.start.angular).abs());
    }

    /// Largest change of the linear momentum, as a share of Σ|mv| at the start.
    pub(super) fn linear_drift(&self) -> f64 {
        self.linear_change / self.start.linear_scale
    }

    /// Largest change of the angular momentum, as a share of Σ|x × mv| + |Iω| at the start.
    pub(super) fn angular_drift(&self) -> f64 {
        self.angular_change / self.start.angular_scale
    }
}

fn momentum(inertias: &[Option<(f64, f64)>], states: &[BodyState]) -> Momentum {
    let floating = inertias.iter().zip(states).filter_map(|(i, s)| i.map(|i| (i, s)));
    floating.fold(Momentum::default(), |sum, ((mass_kg, yaw_inertia_kgm2), state)| {
        let linear = state.velocity_mps * mass_kg;
        let orbital = state.position_m.cross(linear);
        let spin = yaw_inertia_kgm2 * state.yaw_rate_radps;
        Momentum {
            linear: sum.linear + linear,
            angular: sum.angular + orbital + spin,
            linear_scale: sum.linear_scale + linear.length(),
            angular_scale: sum.angular_scale + orbital.abs() + spin.abs(),
        }
    })
}
