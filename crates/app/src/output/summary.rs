//! `summary.json`: the run in one small file.

use fenderline_contact::{BodyState, Event, EventKind, Rotation};
use fenderline_sim::{Energy, Integrator, Method, PairSummary, Setup, StepRecord};
use serde_json::{Value, json};

use super::{OutputError, SUMMARY, WrittenFile};

/// How many events are told one by one.
const FIRST_EVENTS: usize = 20;

/// Events of a run: how many of each kind, and the first few. Bounded, whatever the run's length.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Events {
    /// In the order of first occurrence.
    counts: Vec<(EventKind, u64)>,
    first: Vec<(f64, Event)>,
}

impl Events {
    /// Adds those of one step.
    pub(crate) fn count(&mut self, step: &StepRecord<'_>) {
        for event in step.events {
            match self.counts.iter_mut().find(|(kind, _)| *kind == event.kind) {
                Some((_, count)) => *count += 1,
                None => self.counts.push((event.kind, 1)),
            }
            if self.first.len() < FIRST_EVENTS {
                self.first.push((step.t_s, *event));
            }
        }
    }

    /// The kinds that occurred, and how often.
    pub(crate) fn counts(&self) -> impl Iterator<Item = (EventKind, u64)> {
        self.counts.iter().copied()
    }
}

fn event_key(kind: EventKind) -> &'static str {
    match kind {
        EventKind::ContactBegan => "contact_began",
        EventKind::ContactEnded => "contact_ended",
        EventKind::PatchSplit => "patch_split",
        EventKind::PatchesMerged => "patches_merged",
        EventKind::Contained => "contained",
        EventKind::DeepOverlap => "deep_overlap",
        EventKind::Teleported => "teleported",
        EventKind::NotConverged => "not_converged",
        EventKind::FenderOverRated(_) => "fender_over_rated",
        EventKind::FenderFailed(_) => "fender_failed",
    }
}

/// What a reader of the report is told of a kind of event.
pub(crate) fn event_text(kind: EventKind) -> &'static str {
    match kind {
        EventKind::ContactBegan => "a contact began",
        EventKind::ContactEnded => "a contact ended",
        EventKind::PatchSplit => "one patch of contact became several",
        EventKind::PatchesMerged => "several patches of contact became one",
        EventKind::Contained => {
            "a body lay wholly within another: the overlap no longer grew with depth"
        }
        EventKind::DeepOverlap => {
            "an overlap was deeper than half the smaller body is wide: the force law means little \
             there"
        }
        EventKind::Teleported => "a body moved by more than its velocities explain",
        EventKind::NotConverged => {
            "the coupled solve of a contact did not settle within its bounded work"
        }
        EventKind::FenderOverRated(_) => "a fender was deflected beyond what it is rated for",
        EventKind::FenderFailed(_) => {
            "a fender FAILED: its stop, or the structure behind it, held the hull"
        }
    }
}

/// The word that a scenario file uses.
pub(crate) fn method_text(method: Method) -> &'static str {
    match method {
        Method::Coupled => "coupled",
        Method::Paper => "paper",
    }
}

/// The word that a scenario file uses.
pub(crate) fn integrator_text(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::Euler => "euler",
        Integrator::SemiImplicit => "semi_implicit",
        Integrator::Rk4 => "rk4",
    }
}

/// A run when it is done.
#[derive(Clone, Debug)]
pub(crate) struct Outcome<'a> {
    /// The scenario's title.
    pub(crate) title: &'a str,
    /// Name of the scenario file, without its folder.
    pub(crate) scenario_file: &'a str,
    /// The set-up.
    pub(crate) setup: &'a Setup,
    /// Notices of the scenario.
    pub(crate) notices: &'a [String],
    /// Number of steps.
    pub(crate) steps: u64,
    /// States at the end, one a body.
    pub(crate) states: &'a [BodyState],
    /// Pairs that touched.
    pub(crate) pairs: &'a [PairSummary],
    /// The ledger at the end.
    pub(crate) energy: Energy,
    /// What happened.
    pub(crate) events: &'a Events,
}

/// The text of `summary.json`.
///
/// # Errors
/// A value that is not finite: JSON cannot hold it, and a summary without it would mislead.
pub(crate) fn summary(outcome: &Outcome<'_>, files: &[WrittenFile]) -> Result<String, OutputError> {
    let setup = outcome.setup;
    let name = |body: usize| setup.bodies[body].name.as_str();
    let bodies: Vec<Value> =
        outcome.states.iter().enumerate().map(|(i, state)| body_json(name(i), state)).collect();
    let pairs: Vec<Value> = outcome.pairs.iter().map(|pair| pair_json(pair, &name)).collect();
    let counts: serde_json::Map<String, Value> =
        outcome.events.counts().map(|(kind, n)| (event_key(kind).to_owned(), json!(n))).collect();
    let first: Vec<Value> = outcome
        .events
        .first
        .iter()
        .map(|(t_s, event)| {
            let bodies = event.bodies.map(|body| name(body.0 as usize));
            json!({ "t_s": t_s, "kind": event_key(event.kind), "bodies": bodies })
        })
        .collect();
    let files: Vec<Value> = files
        .iter()
        .map(|file| match file.rows {
            Some(rows) => json!({ "name": file.name, "rows": rows }),
            None => json!({ "name": file.name }),
        })
        .collect();
    let whole = json!({
        "title": outcome.title,
        "fenderline_version": env!("CARGO_PKG_VERSION"),
        "scenario_file": outcome.scenario_file,
        "method": method_text(setup.method),
        "integrator": integrator_text(setup.integrator),
        "step_s": setup.step_s,
        "steps": outcome.steps,
        "duration_s": setup.duration_s,
        "bodies": bodies,
        "pairs": pairs,
        "energy": energy_json(outcome.energy),
        "events": { "counts": counts, "first": first },
        "notices": outcome.notices,
        "files": files,
    });
    match first_null(&whole) {
        None => Ok(format!("{whole:#}\n")),
        Some(key) => Err(OutputError::new(
            SUMMARY.as_ref(),
            format_args!("the simulation gave a value that is not finite for `{key}`"),
        )),
    }
}

/// The key of the first null, which is what a number that is not finite turns into; the summary
/// holds no other.
fn first_null(value: &Value) -> Option<String> {
    match value {
        Value::Null => Some(String::new()),
        Value::Array(items) => items.iter().find_map(first_null),
        Value::Object(map) => map.iter().find_map(|(key, value)| {
            let below = first_null(value)?;
            Some(if below.is_empty() { key.clone() } else { format!("{key}.{below}") })
        }),
        _ => None,
    }
}

fn body_json(name: &str, state: &BodyState) -> Value {
    let velocity = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
    json!({
        "name": name,
        "final": {
            "x_m": state.position_m.x,
            "y_m": state.position_m.y,
            "heading_rad": state.heading_rad,
            "u_mps": velocity.x,
            "v_mps": velocity.y,
            "r_radps": state.yaw_rate_radps,
        },
    })
}

fn pair_json<'a>(pair: &PairSummary, name: &impl Fn(usize) -> &'a str) -> Value {
    json!({
        "bodies": pair.bodies.map(name),
        "first_touch_s": pair.first_touch_s,
        "last_touch_s": pair.last_touch_s,
        "peak_normal_force_n": pair.peak_normal_force_n,
        "peak_normal_force_at_s": pair.peak_normal_force_at_s,
        "peak_depth_m": pair.peak_depth_m,
        "peak_depth_at_s": pair.peak_depth_at_s,
        "impulse_ns": pair.impulse_ns,
        "approach_speed_mps": pair.approach_speed_mps,
        "final_speed_mps": pair.final_speed_mps,
        "normal_work_j": pair.normal_work_j,
        "tangential_work_j": pair.tangential_work_j,
        "touching_at_end": pair.touching_at_end,
    })
}

fn energy_json(energy: Energy) -> Value {
    json!({
        "kinetic_j": energy.kinetic_j,
        "load_work_j": energy.load_work_j,
        "normal_work_j": energy.normal_work_j,
        "tangential_work_j": energy.tangential_work_j,
        "residual_j": energy.residual_j,
    })
}
