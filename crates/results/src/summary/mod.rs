//! `summary.json`: the run in one small file.

mod approach;
mod berthing;
mod dolphins;
mod events;
mod exercise;
mod factors;
mod fenders;
mod session;
mod statistics;
mod verdict;
mod world;

use fenderline_contact::{BodyState, Rotation};
use fenderline_sim::{Energy, Integrator, Method, PairSummary};

use crate::json::{Json, NumberNotFinite, object};
use crate::outcome::{Outcome, WrittenFile};
use crate::quantities::PAIRS;

use approach::approaches_json;
use berthing::berthing_json;
use dolphins::dolphins_json;
use events::events_json;
use exercise::exercise_json;
use factors::put_factors;
use fenders::fenders_json;
use session::session_json;
use statistics::put_statistics;
use verdict::verdict_json;
use world::put_world;

/// The word for the contact method, as a scenario file has it.
pub fn method_text(method: Method) -> &'static str {
    match method {
        Method::Coupled => "coupled",
        Method::Paper => "paper",
    }
}

/// The word for the time integrator, as a scenario file has it.
pub fn integrator_text(integrator: Integrator) -> &'static str {
    match integrator {
        Integrator::Euler => "euler",
        Integrator::SemiImplicit => "semi_implicit",
        Integrator::Rk4 => "rk4",
    }
}

/// The text of `summary.json`.
///
/// # Errors
/// Fails if a value is not finite: JSON cannot hold such a value, and a summary without it would mislead.
pub fn summary(outcome: &Outcome<'_>, files: &[WrittenFile]) -> Result<String, NumberNotFinite> {
    let setup = outcome.setup;
    let name = |body: usize| setup.bodies[body].name.as_str();
    let bodies: Vec<Json> =
        outcome.states.iter().enumerate().map(|(i, state)| body_json(name(i), state)).collect();
    let pairs: Vec<Json> = outcome.pairs.iter().map(|pair| pair_json(pair, &name)).collect();
    let files: Vec<Json> = files
        .iter()
        .map(|file| match file.rows {
            Some(rows) => object!({ "name": file.name, "rows": rows }),
            None => object!({ "name": file.name }),
        })
        .collect();
    let mut whole = object!({
        "title": outcome.title,
        "report": report_json(outcome.report),
        "fenderline_version": env!("CARGO_PKG_VERSION"),
        "scenario_file": outcome.scenario_file,
        "method": method_text(setup.method),
        "integrator": integrator_text(setup.integrator),
        "step_s": setup.step_s,
        "steps": outcome.steps,
        "verdict": verdict_json(outcome),
        "interrupted": outcome.interrupted.is_some(),
        "duration_s": outcome.duration_s(),
        "bodies": bodies,
        "pairs": pairs,
        "fenders": fenders_json(outcome),
        "energy": energy_json(outcome.energy),
        "events": events_json(outcome.events, setup),
        "notices": outcome.notices,
        "files": files,
    });
    if let Some(exercise) = outcome.exercise {
        whole.put("exercise", exercise_json(exercise, setup));
    }
    if let Some(session) = outcome.session {
        whole.put("session", session_json(session));
    }
    if !setup.approaches.is_empty() {
        whole.put("approaches", approaches_json(setup));
    }
    if !outcome.dolphins.is_empty() {
        whole.put("dolphins", dolphins_json(outcome.dolphins, setup));
    }
    if let Some(berthing) = outcome.berthing {
        whole.put("berthing", berthing_json(berthing, setup));
    }
    put_world(&mut whole, outcome);
    put_statistics(&mut whole, outcome);
    put_factors(&mut whole, outcome);
    let checked = whole.checked()?;
    Ok(format!("{checked:#}\n"))
}

/// The lines of the report's title page, as JSON.
fn report_json(lines: &[(&str, String)]) -> Json {
    lines.iter().map(|(key, text)| ((*key).to_owned(), text)).collect()
}

fn body_json(name: &str, state: &BodyState) -> Json {
    let velocity = Rotation::from_angle(state.heading_rad).apply_inverse(state.velocity_mps);
    object!({
        "name": name,
        "final": object!({
            "x_m": state.position_m.x,
            "y_m": state.position_m.y,
            "heading_rad": state.heading_rad,
            "u_mps": velocity.x,
            "v_mps": velocity.y,
            "r_radps": state.yaw_rate_radps,
        }),
    })
}

fn pair_json<'a>(pair: &PairSummary, name: &impl Fn(usize) -> &'a str) -> Json {
    let mut object = object!({ "bodies": pair.bodies.map(name) });
    PAIRS.put(&mut object, &(), pair);
    object
}

fn energy_json(energy: Energy) -> Json {
    let loads: Json =
        energy.loads.parts().map(|(name, work_j)| (name.to_owned(), work_j)).collect();
    let mut object = object!({
        "kinetic_j": energy.kinetic_j,
        "load_work_j": energy.load_work_j,
        "load_works_j": loads,
        "normal_work_j": energy.normal_work_j,
        "tangential_work_j": energy.tangential_work_j,
        "stored_j": energy.stored_j,
        "shear_stored_j": energy.shear_stored_j,
        "hysteresis_j": energy.hysteresis_j,
        "damping_j": energy.damping_j,
        "restitution_j": energy.restitution_j,
        "friction_j": energy.friction_j,
        "contact_residual_j": energy.contact_residual_j,
        "residual_j": energy.residual_j,
        "exchanged_j": energy.exchanged_j(),
    });
    // Only hulls by height have work of height.
    if energy.height_work_j != 0.0 {
        object.put("height_work_j", energy.height_work_j);
    }
    // Only flexible dolphins do.
    if energy.loads.piles_j != 0.0 {
        object.put("pile_stored_j", energy.pile_stored_j);
        object.put("pile_damping_j", energy.pile_damping_j);
        object.put("pile_yield_j", energy.pile_yield_j);
    }
    object
}
